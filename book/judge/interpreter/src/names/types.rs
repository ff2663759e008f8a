//! Type expressions: which type is written in a signature, a field or a declaration.

use syn::punctuated::Punctuated;

use super::words::unexpected;
use super::{Meaning, Names, Resolved, Signature, TypeScope, names};
use crate::read::at;
use crate::refusal::Refusal;
use crate::types::{Ctor, Type};

impl Names {
    /// Resolves the types in a function's signature. A type parameter means a value of any type
    /// that has its traits.
    pub(crate) fn signature(
        &self,
        context: &TypeScope,
        it: &syn::Signature,
    ) -> Resolved<Signature> {
        let file = self.modules[context.module].file;
        let mut context = context.clone();
        for parameter in &it.generics.params {
            let syn::GenericParam::Type(parameter) = parameter else {
                continue;
            };
            let ty = self.bounded(&context, &parameter.bounds)?;
            context.parameters.insert(parameter.ident.to_string(), ty);
        }
        if let Some(clause) = &it.generics.where_clause {
            return Err(Refusal::unread(at(file, clause), "`where`"));
        }
        let parameters = it.inputs.iter().map(|input| match input {
            syn::FnArg::Typed(input) => self.ty(&context, &input.ty),
            syn::FnArg::Receiver(receiver) => {
                let Some(own) = context.own.clone() else {
                    let message = "`self` parameter is only allowed in associated functions";
                    return Err(Refusal::new(at(file, receiver), message, "", ""));
                };
                match &receiver.kind {
                    syn::ReceiverKind::Value => Ok(own),
                    syn::ReceiverKind::Reference(_, _, Some(_)) => Ok(Type::of(Ctor::RefMut, own)),
                    syn::ReceiverKind::Reference(..) => Ok(Type::of(Ctor::Ref, own)),
                    syn::ReceiverKind::Typed(_, ty) => self.ty(&context, ty),
                    _ => Err(Refusal::unread(at(file, receiver), "this kind of `self`")),
                }
            }
        });
        Ok(Signature {
            name: it.ident.to_string(),
            module: context.module,
            inside: context.module,
            at: at(file, &it.ident),
            is_public: true,
            parameters: parameters.collect::<Resolved<_>>()?,
            has_self: matches!(it.inputs.first(), Some(syn::FnArg::Receiver(_))),
            result: self.result(&context, &it.output)?,
            of: context.own,
            ..Signature::default()
        })
    }

    /// Resolves the type of a result.
    pub(crate) fn result(&self, context: &TypeScope, output: &syn::ReturnType) -> Resolved<Type> {
        match output {
            syn::ReturnType::Default => Ok(Type::UNIT),
            syn::ReturnType::Type(_, ty) => self.ty(context, ty),
        }
    }

    /// Resolves a type as it is written.
    pub(crate) fn ty(&self, context: &TypeScope, ty: &syn::Type) -> Resolved<Type> {
        let one = |ctor, of: &syn::Type| Ok(Type::of(ctor, self.ty(context, of)?));
        let place = || at(self.modules[context.module].file, ty);
        match ty {
            syn::Type::Paren(it) => self.ty(context, &it.elem),
            syn::Type::Group(it) => self.ty(context, &it.elem),
            syn::Type::Never(_) => Ok(Ctor::Never.into()),
            syn::Type::Infer(_) => Ok(Type::UNKNOWN),
            syn::Type::Tuple(it) => {
                let all = it.elems.iter().map(|it| self.ty(context, it));
                Ok(Type(Ctor::Tuple, all.collect::<Resolved<_>>()?))
            }
            syn::Type::Reference(it) if it.mutability.is_some() => one(Ctor::RefMut, &it.elem),
            syn::Type::Reference(it) => one(Ctor::Ref, &it.elem),
            syn::Type::Slice(it) => one(Ctor::Slice, &it.elem),
            syn::Type::Array(it) => match literal(&it.len) {
                Some(length) => one(Ctor::Array(length), &it.elem),
                None => Err(Refusal::unread(place(), "lengths that are no number")),
            },
            syn::Type::TraitObject(it) => self.bounded(context, &it.bounds),
            syn::Type::ImplTrait(it) => self.bounded(context, &it.bounds),
            syn::Type::FnPtr(it) => {
                self.function_type(context, it.inputs.iter().map(|it| &it.ty), &it.output)
            }
            syn::Type::Path(it) if it.qself.is_none() => self.path(context, &it.path),
            _ => Err(Refusal::unread(place(), "this kind of type")),
        }
    }

    /// Resolves the type of a function.
    fn function_type<'t>(
        &self,
        context: &TypeScope,
        inputs: impl Iterator<Item = &'t syn::Type>,
        output: &syn::ReturnType,
    ) -> Resolved<Type> {
        let mut types = inputs
            .map(|it| self.ty(context, it))
            .collect::<Resolved<Vec<_>>>()?;
        types.push(self.result(context, output)?);
        Ok(Type(Ctor::Fn, types))
    }

    /// Resolves a type that is a path.
    fn path(&self, context: &TypeScope, path: &syn::Path) -> Resolved<Type> {
        let place = at(self.modules[context.module].file, path);
        let last = path.segments.last().expect("a path has a name");
        let names = names(path);
        if let Some(ty) = context.parameters.get(&names.join("::")) {
            return Ok(ty.clone());
        }
        let arguments = match &last.arguments {
            syn::PathArguments::AngleBracketed(it) => {
                let types = it.args.iter().filter_map(|it| match it {
                    syn::GenericArgument::Type(ty) => Some(self.ty(context, ty)),
                    _ => None,
                });
                types.collect::<Resolved<Vec<_>>>()?
            }
            _ => Vec::new(),
        };
        match self.expected(context, &names, "type", place)? {
            Meaning::Type(ty) => Ok(ty),
            Meaning::Generic(ctor) if arguments.len() == 1 => Ok(Type(ctor, arguments)),
            Meaning::Generic(_) => {
                let message = format!("missing generics for `{}`", last.ident);
                let help = format!("`{}<T>`", last.ident);
                Err(Refusal::new(
                    place,
                    message,
                    "expected 1 generic argument",
                    &help,
                ))
            }
            Meaning::Trait(found) => {
                let name = &self.traits[found].name;
                let message = format!("expected a type, found the trait `{name}`");
                let help = format!("`&dyn {name}`, or `Box<dyn {name}>`");
                Err(Refusal::new(place, message, "", &help))
            }
            _ => Err(unexpected("type", &names, place)),
        }
    }

    /// Resolves the type of a value with these traits, of which the first counts that is `Fn` or
    /// one of the text.
    fn bounded(
        &self,
        context: &TypeScope,
        bounds: &Punctuated<syn::TypeParamBound, syn::Token![+]>,
    ) -> Resolved<Type> {
        for bound in bounds {
            let syn::TypeParamBound::Trait(bound) = bound else {
                continue;
            };
            let last = bound.path.segments.last().expect("a path has a name");
            match (&last.arguments, last.ident.to_string().as_str()) {
                (syn::PathArguments::Parenthesized(it), "Fn" | "FnMut" | "FnOnce") => {
                    let inputs = it.inputs.iter().map(|it| &it.ty);
                    return self.function_type(context, inputs, &it.output);
                }
                _ => {
                    let place = at(self.modules[context.module].file, &bound.path);
                    let path = names(&bound.path);
                    if matches!(self.meant(context, &path), Ok(Meaning::Standard(_))) {
                        continue;
                    }
                    let Meaning::Trait(found) = self.expected(context, &path, "trait", place)?
                    else {
                        return Err(unexpected("trait", &path, place));
                    };
                    return Ok(Ctor::Dyn(found).into());
                }
            }
        }
        Ok(Type::UNKNOWN)
    }
}

/// Returns the length of an array, if it is a plain number.
fn literal(length: &syn::Expr) -> Option<usize> {
    match length {
        syn::Expr::Lit(syn::ExprLit {
            lit: syn::Lit::Int(it),
            ..
        }) => it.base10_parse().ok(),
        _ => None,
    }
}
