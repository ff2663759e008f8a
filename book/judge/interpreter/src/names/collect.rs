//! Declarations: what each item of the trees is, and the types of its parts.

use std::mem;

use syn::punctuated::Punctuated;

use super::{
    Context, Entry, Field, Kind, Module, Named, Names, Signature, Trait, module_key, names,
};
use crate::node::At;
use crate::read::{Refusal, at};
use crate::types::{Head, Type};

type Read<T = ()> = Result<T, Refusal>;

/// What is in a function.
#[derive(Clone, Copy)]
pub(crate) enum Inside<'a> {
    Function(&'a syn::Signature, &'a syn::Block),
    Constant(&'a syn::Expr),
}

/// What the files declare, each with its name and its tree; the root is `lib.rs`, or the first. Of each
/// function what is in it, if anything is.
pub(crate) fn collect<'a>(
    files: &'a [(String, syn::File)],
) -> Result<(Names, Vec<Option<Inside<'a>>>), Vec<Refusal>> {
    let mut collector = Collector {
        files,
        names: Names::default(),
        items: Vec::new(),
        imports: Vec::new(),
        bodies: Vec::new(),
        faults: Vec::new(),
    };
    let root = files.iter().position(|it| it.0.ends_with("lib.rs"));
    let root = root.unwrap_or_default();
    let module = Module {
        file: root as u32,
        ..Module::default()
    };
    collector.module(module, &files[root].1.items);
    collector.define();
    if collector.faults.is_empty() {
        Ok((collector.names, collector.bodies))
    } else {
        Err(collector.faults)
    }
}

struct Collector<'a> {
    files: &'a [(String, syn::File)],
    names: Names,
    /// Each with its module.
    items: Vec<(usize, &'a syn::Item)>,
    /// The paths of all imports, each with its module and its place.
    imports: Vec<(usize, Vec<String>, At)>,
    bodies: Vec<Option<Inside<'a>>>,
    faults: Vec<Refusal>,
}

impl<'a> Collector<'a> {
    fn module(&mut self, module: Module, items: impl IntoIterator<Item = &'a syn::Item>) -> usize {
        self.names.modules.push(module);
        let own = self.names.modules.len() - 1;
        for item in items {
            if !is_test(item) {
                self.items.push((own, item));
                let declared = self.declare(own, item);
                self.faults.extend(declared.err());
            }
        }
        own
    }

    fn at(&self, module: usize, it: &impl syn::spanned::Spanned) -> At {
        at(self.names.file(module), it)
    }

    fn declare(&mut self, module: usize, item: &'a syn::Item) -> Read {
        let (name, visibility, named) = match item {
            syn::Item::Struct(it) => {
                let named = self.kind(module, it);
                self.no_generics(module, &it.generics)?;
                if !matches!(it.fields, syn::Fields::Named(_)) {
                    let what = "structs whose fields have no names";
                    return Err(Refusal::unknown(self.at(module, &it.ident), what));
                }
                (&it.ident, &it.vis, named)
            }
            syn::Item::Trait(it) => {
                self.no_generics(module, &it.generics)?;
                let named = Named::Trait(self.names.traits.len());
                self.names.traits.push(Trait::called(&it.ident));
                (&it.ident, &it.vis, named)
            }
            syn::Item::Fn(it) => (&it.sig.ident, &it.vis, self.function()),
            syn::Item::Const(it) => (&it.ident, &it.vis, self.function()),
            syn::Item::Mod(it) => (&it.ident, &it.vis, self.submodule(module, it)?),
            syn::Item::Type(it) => (&it.ident, &it.vis, Named::Type(Type::UNKNOWN)),
            syn::Item::Use(it) => return self.import(module, &it.vis, Vec::new(), &it.tree),
            syn::Item::Impl(_) => return Ok(()),
            _ => return Err(Refusal::unknown(self.at(module, item), "this kind of item")),
        };
        self.name(module, name, visibility, named)
    }

    fn name(
        &mut self,
        module: usize,
        name: &syn::Ident,
        visibility: &syn::Visibility,
        named: Named,
    ) -> Read {
        let entry = Entry {
            named,
            is_public: is_public(visibility),
        };
        let key = match entry.named {
            Named::Module(_) => module_key(&name.to_string()),
            _ => name.to_string(),
        };
        match self.names.modules[module].names.insert(key, entry) {
            None => Ok(()),
            Some(_) => {
                let message = format!("the name `{name}` is defined multiple times");
                Err(Refusal::new(self.at(module, name), &message, "", ""))
            }
        }
    }

    /// A place for a function whose signature is read later.
    fn function(&mut self) -> Named {
        self.names.functions.push(Signature::default());
        self.bodies.push(None);
        Named::Function(self.names.functions.len() - 1)
    }

    fn submodule(&mut self, module: usize, it: &'a syn::ItemMod) -> Read<Named> {
        let name = it.ident.to_string();
        let mut own = Module {
            file: self.names.file(module),
            parent: module,
            name: name.clone(),
            ..Module::default()
        };
        if let Some((_, items)) = &it.content {
            return Ok(Named::Module(self.module(own, items)));
        }
        let is_it = |(file, _): &(String, syn::File)| {
            let path = file.trim_end_matches("/mod.rs").trim_end_matches(".rs");
            path.rsplit('/').next() == Some(&name)
        };
        let Some(file) = self.files.iter().position(is_it) else {
            let message = format!("file not found for module `{name}`");
            return Err(Refusal::new(self.at(module, &it.ident), &message, "", ""));
        };
        own.file = file as u32;
        let files = self.files;
        Ok(Named::Module(self.module(own, &files[file].1.items)))
    }

    fn kind(&mut self, module: usize, it: &syn::ItemStruct) -> Named {
        let mut derives = Vec::new();
        for derive in it.attrs.iter().filter(|it| it.path().is_ident("derive")) {
            let _ = derive.parse_nested_meta(|meta| {
                derives.extend(meta.path.segments.last().map(|it| it.ident.to_string()));
                Ok(())
            });
        }
        self.names.kinds.push(Kind {
            name: it.ident.to_string(),
            module,
            fields: Vec::new(),
            derives,
        });
        Named::Type(Head::Own(self.names.kinds.len() - 1).into())
    }

    fn import(
        &mut self,
        module: usize,
        visibility: &syn::Visibility,
        mut path: Vec<String>,
        tree: &syn::UseTree,
    ) -> Read {
        let own = match tree {
            syn::UseTree::Path(it) => {
                path.push(it.ident.to_string());
                return self.import(module, visibility, path, &it.tree);
            }
            syn::UseTree::Group(it) => {
                let mut trees = it.items.iter();
                return trees.try_for_each(|it| self.import(module, visibility, path.clone(), it));
            }
            syn::UseTree::Glob(_) => None,
            syn::UseTree::Name(it) => Some(&it.ident),
            syn::UseTree::Rename(_) => {
                let what = "other names for what is imported";
                return Err(Refusal::unknown(self.at(module, tree), what));
            }
        };
        let mut name = own.cloned();
        match (own, path.last()) {
            // `use std::fmt::{self, …}`.
            (Some(own), Some(last)) if own == "self" => {
                name = Some(syn::Ident::new(last, own.span()));
            }
            _ => path.extend(own.map(ToString::to_string)),
        }
        self.imports
            .push((module, path.clone(), self.at(module, tree)));
        match name {
            Some(name) => self.name(module, &name, visibility, Named::Import(path)),
            None => {
                let is_public = is_public(visibility);
                self.names.modules[module].globs.push((path, is_public));
                Ok(())
            }
        }
    }

    /// Finds what all names mean, now that all are known.
    fn define(&mut self) {
        let items = mem::take(&mut self.items);
        let each = |own: &mut Self, work: fn(&mut Self, usize, &'a syn::Item) -> Read| {
            for &(module, item) in &items {
                let done = work(own, module, item);
                own.faults.extend(done.err());
            }
        };
        // One name may stand for another that comes later.
        let declared = self.faults.len();
        for _ in 0..4 {
            self.faults.truncate(declared);
            each(self, Self::alias);
        }
        for (module, path, at) in mem::take(&mut self.imports) {
            if let Err(lost) = self.names.found(module, &path) {
                self.faults.push(self.names.unresolved(at, &path, lost));
            }
        }
        if self.faults.is_empty() {
            each(self, Self::fields_or_trait);
            each(self, Self::functions);
        }
        if self.faults.is_empty() {
            let complete = self.are_traits_complete();
            self.faults.extend(complete.err());
        }
    }

    fn alias(&mut self, module: usize, item: &'a syn::Item) -> Read {
        let syn::Item::Type(it) = item else {
            return Ok(());
        };
        let ty = self.names.ty(&Context::of(module), &it.ty)?;
        let entry = self.names.modules[module]
            .names
            .get_mut(&it.ident.to_string());
        entry.expect("it was declared").named = Named::Type(ty);
        Ok(())
    }

    fn fields_or_trait(&mut self, module: usize, item: &'a syn::Item) -> Read {
        let context = Context::of(module);
        match item {
            syn::Item::Struct(it) => self.fields(&context, &it.ident, &it.fields),
            syn::Item::Trait(it) => {
                let own = match self.names.modules[module].names[&it.ident.to_string()].named {
                    Named::Trait(own) => own,
                    _ => return Ok(()),
                };
                let context = Context {
                    own: Some(Head::Dyn(own).into()),
                    ..context
                };
                for item in &it.items {
                    let syn::TraitItem::Fn(method) = item else {
                        return Err(Refusal::unknown(self.at(module, item), "this in a trait"));
                    };
                    if let Some(default) = &method.default {
                        let what = "functions that a trait gives to all";
                        return Err(Refusal::unknown(self.at(module, default), what));
                    }
                    let function = self.method(&context, &method.sig, None, true)?;
                    self.names.traits[own].methods.push(function);
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn functions(&mut self, module: usize, item: &'a syn::Item) -> Read {
        let context = Context::of(module);
        let number = |own: &Self, name: &syn::Ident| match own.names.modules[module].names
            [&name.to_string()]
            .named
        {
            Named::Function(number) => number,
            _ => unreachable!("it was declared as a function"),
        };
        match item {
            syn::Item::Fn(it) => {
                let is_public = is_public(&it.vis);
                self.put(
                    number(self, &it.sig.ident),
                    &context,
                    &it.sig,
                    Some(&it.block),
                    is_public,
                )
            }
            syn::Item::Const(it) => self.constant(
                number(self, &it.ident),
                &context,
                &it.ident,
                (&it.ty, &it.expr),
            ),
            syn::Item::Impl(it) => self.implementation(context, it),
            _ => Ok(()),
        }
    }

    fn fields(&mut self, context: &Context, name: &syn::Ident, fields: &syn::Fields) -> Read {
        let own = self.names.modules[context.module].names[&name.to_string()]
            .named
            .clone();
        let Named::Type(Type(Head::Own(own), _)) = own else {
            return Ok(());
        };
        let fields = fields.iter().enumerate().map(|(n, field)| {
            let name = field.ident.as_ref();
            Ok(Field {
                name: name.map_or(n.to_string(), ToString::to_string),
                ty: self.names.ty(context, &field.ty)?,
                is_public: is_public(&field.vis),
            })
        });
        self.names.kinds[own].fields = fields.collect::<Read<_>>()?;
        Ok(())
    }

    /// Reads the signature of a function that has its number.
    fn put(
        &mut self,
        number: usize,
        context: &Context,
        it: &'a syn::Signature,
        block: Option<&'a syn::Block>,
        is_public: bool,
    ) -> Read {
        self.names.functions[number] = Signature {
            is_public,
            ..self.names.signature(context, it)?
        };
        self.bodies[number] = block.map(|block| Inside::Function(it, block));
        Ok(())
    }

    fn method(
        &mut self,
        context: &Context,
        it: &'a syn::Signature,
        block: Option<&'a syn::Block>,
        is_public: bool,
    ) -> Read<usize> {
        self.function();
        let number = self.names.functions.len() - 1;
        self.put(number, context, it, block, is_public)?;
        Ok(number)
    }

    fn constant(
        &mut self,
        number: usize,
        context: &Context,
        name: &syn::Ident,
        (ty, value): (&syn::Type, &'a syn::Expr),
    ) -> Read {
        self.names.functions[number] = Signature {
            name: name.to_string(),
            module: context.module,
            at: self.at(context.module, name),
            is_public: true,
            is_constant: true,
            of: context.own.clone(),
            result: self.names.ty(context, ty)?,
            ..Signature::default()
        };
        self.bodies[number] = Some(Inside::Constant(value));
        Ok(())
    }

    fn implementation(&mut self, context: Context, it: &'a syn::ItemImpl) -> Read {
        let module = context.module;
        self.no_generics(module, &it.generics)?;
        let own = self.names.ty(&context, &it.self_ty)?;
        let (mut in_trait, mut in_standard) = (None, None);
        if let Some((path, _)) = &it.trait_ {
            match self.names.found(module, &names(path)) {
                Ok(Named::Trait(found)) => {
                    self.names.traits[found].implemented_for.push(own.clone());
                    in_trait = Some(found);
                }
                Ok(Named::Standard(name)) => in_standard = Some(name),
                Err(lost) => {
                    let at = self.at(module, path);
                    return Err(self
                        .names
                        .not_found(module, at, "trait", &names(path), lost));
                }
                Ok(_) => return Err(Refusal::unknown(self.at(module, path), "this trait")),
            }
        }
        let mut context = Context {
            own: Some(own),
            ..context
        };
        for item in &it.items {
            match item {
                syn::ImplItem::Type(it) => {
                    let ty = self.names.ty(&context, &it.ty)?;
                    context.parameters.insert(format!("Self::{}", it.ident), ty);
                }
                syn::ImplItem::Fn(it) => {
                    let is_public = is_public(&it.vis);
                    let made = self.method(&context, &it.sig, Some(&it.block), is_public)?;
                    self.names.functions[made].in_trait = in_trait;
                    self.names.functions[made]
                        .in_standard
                        .clone_from(&in_standard);
                }
                syn::ImplItem::Const(it) => {
                    self.function();
                    let made = self.names.functions.len() - 1;
                    self.constant(made, &context, &it.ident, (&it.ty, &it.expr))?;
                }
                _ => return Err(Refusal::unknown(self.at(module, item), "this in an `impl`")),
            }
        }
        Ok(())
    }

    /// Whether each implementation of a trait has what that promises, and nothing else.
    fn are_traits_complete(&self) -> Read {
        let names = &self.names;
        let refused = |at, message: String| Err(Refusal::new(at, &message, "", ""));
        for own in &names.functions {
            let of = own.in_trait.map(|it| &names.traits[it]);
            if let Some(of) = of.filter(|it| names.method_of(it, &own.name).is_none()) {
                let message = format!(
                    "method `{}` is not a member of trait `{}`",
                    own.name, of.name
                );
                return refused(own.at, message);
            }
        }
        for (n, of) in names.traits.iter().enumerate() {
            let each = |ty| of.methods.iter().map(move |&it| (ty, &names.functions[it]));
            for (ty, promised) in of.implemented_for.iter().flat_map(each) {
                let name = &promised.name;
                match names
                    .method(ty, name, Some(n))
                    .map(|it| &names.functions[it])
                {
                    None => {
                        let on = ty.name(names);
                        let message = format!(
                            "not all trait items implemented, missing: `{name}` for `{on}`"
                        );
                        return refused(promised.at, message);
                    }
                    Some(own) if !own.is_as_promised(promised) => {
                        let message = format!("method `{name}` has an incompatible type for trait");
                        return refused(own.at, message);
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }

    fn no_generics(&self, module: usize, generics: &syn::Generics) -> Read {
        let mut parameters = generics.params.iter();
        match parameters.find(|it| !matches!(it, syn::GenericParam::Lifetime(_))) {
            None => Ok(()),
            Some(parameter) => Err(Refusal::unknown(
                self.at(module, parameter),
                "type parameters of structs, traits and `impl`s",
            )),
        }
    }
}

fn is_public(visibility: &syn::Visibility) -> bool {
    !matches!(visibility, syn::Visibility::Inherited)
}

fn is_test(item: &syn::Item) -> bool {
    matches!(item, syn::Item::Mod(it) if it.ident == "tests")
}

impl Signature {
    fn is_as_promised(&self, promised: &Self) -> bool {
        let others = |it: &Self| it.parameters[usize::from(it.has_self)..].to_vec();
        self.has_self == promised.has_self
            && others(self) == others(promised)
            && self.result == promised.result
    }
}

impl Trait {
    fn called(name: &syn::Ident) -> Self {
        Self {
            name: name.to_string(),
            methods: Vec::new(),
            implemented_for: Vec::new(),
        }
    }
}

impl Context {
    pub(crate) fn of(module: usize) -> Self {
        Self {
            module,
            ..Self::default()
        }
    }
}

impl Names {
    /// A signature whose type parameters stand for what has their traits.
    pub(crate) fn signature(&self, context: &Context, it: &syn::Signature) -> Read<Signature> {
        let file = self.file(context.module);
        let mut context = context.clone();
        for parameter in &it.generics.params {
            let syn::GenericParam::Type(parameter) = parameter else {
                continue;
            };
            let ty = self.bounded(&context, &parameter.bounds)?;
            context.parameters.insert(parameter.ident.to_string(), ty);
        }
        if let Some(clause) = &it.generics.where_clause {
            return Err(Refusal::unknown(at(file, clause), "`where`"));
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
                    syn::ReceiverKind::Reference(_, _, Some(_)) => Ok(Type::of(Head::RefMut, own)),
                    syn::ReceiverKind::Reference(..) => Ok(Type::of(Head::Ref, own)),
                    syn::ReceiverKind::Typed(_, ty) => self.ty(&context, ty),
                    _ => Err(Refusal::unknown(at(file, receiver), "this kind of `self`")),
                }
            }
        });
        Ok(Signature {
            name: it.ident.to_string(),
            module: context.module,
            at: at(file, &it.ident),
            is_public: true,
            parameters: parameters.collect::<Read<_>>()?,
            has_self: matches!(it.inputs.first(), Some(syn::FnArg::Receiver(_))),
            result: self.result(&context, &it.output)?,
            of: context.own,
            ..Signature::default()
        })
    }

    pub(crate) fn result(&self, context: &Context, output: &syn::ReturnType) -> Read<Type> {
        match output {
            syn::ReturnType::Default => Ok(Type::UNIT),
            syn::ReturnType::Type(_, ty) => self.ty(context, ty),
        }
    }

    /// The type that is written there.
    pub(crate) fn ty(&self, context: &Context, ty: &syn::Type) -> Read<Type> {
        let one = |head, of: &syn::Type| Ok(Type::of(head, self.ty(context, of)?));
        let place = || at(self.file(context.module), ty);
        match ty {
            syn::Type::Paren(it) => self.ty(context, &it.elem),
            syn::Type::Group(it) => self.ty(context, &it.elem),
            syn::Type::Never(_) => Ok(Head::Never.into()),
            syn::Type::Infer(_) => Ok(Type::UNKNOWN),
            syn::Type::Tuple(it) => {
                let all = it.elems.iter().map(|it| self.ty(context, it));
                Ok(Type(Head::Tuple, all.collect::<Read<_>>()?))
            }
            syn::Type::Reference(it) if it.mutability.is_some() => one(Head::RefMut, &it.elem),
            syn::Type::Reference(it) => one(Head::Ref, &it.elem),
            syn::Type::Slice(it) => one(Head::Slice, &it.elem),
            syn::Type::Array(it) => match literal(&it.len) {
                Some(length) => one(Head::Array(length), &it.elem),
                None => Err(Refusal::unknown(place(), "lengths that are no number")),
            },
            syn::Type::TraitObject(it) => self.bounded(context, &it.bounds),
            syn::Type::ImplTrait(it) => self.bounded(context, &it.bounds),
            syn::Type::FnPtr(it) => {
                self.function_type(context, it.inputs.iter().map(|it| &it.ty), &it.output)
            }
            syn::Type::Path(it) if it.qself.is_none() => self.path(context, &it.path),
            _ => Err(Refusal::unknown(place(), "this kind of type")),
        }
    }

    fn function_type<'t>(
        &self,
        context: &Context,
        inputs: impl Iterator<Item = &'t syn::Type>,
        output: &syn::ReturnType,
    ) -> Read<Type> {
        let mut types = inputs
            .map(|it| self.ty(context, it))
            .collect::<Read<Vec<_>>>()?;
        types.push(self.result(context, output)?);
        Ok(Type(Head::Fn, types))
    }

    fn path(&self, context: &Context, path: &syn::Path) -> Read<Type> {
        let module = context.module;
        let place = at(self.file(module), path);
        let last = path.segments.last().expect("a path has a name");
        let names = names(path);
        let own = context.own.as_ref().filter(|_| names == ["Self"]);
        if let Some(ty) = own.or_else(|| context.parameters.get(&names.join("::"))) {
            return Ok(ty.clone());
        }
        let arguments = match &last.arguments {
            syn::PathArguments::AngleBracketed(it) => {
                let types = it.args.iter().filter_map(|it| match it {
                    syn::GenericArgument::Type(ty) => Some(self.ty(context, ty)),
                    _ => None,
                });
                types.collect::<Read<Vec<_>>>()?
            }
            _ => Vec::new(),
        };
        match self.found(module, &names) {
            Ok(Named::Type(ty)) => Ok(ty),
            Ok(Named::Generic(head)) if arguments.len() == 1 => Ok(Type(head, arguments)),
            Ok(Named::Generic(_)) => {
                let message = format!("missing generics for `{}`", last.ident);
                let help = format!("`{}<T>`", last.ident);
                Err(Refusal::new(
                    place,
                    &message,
                    "expected 1 generic argument",
                    &help,
                ))
            }
            Ok(Named::Trait(found)) => {
                let name = &self.traits[found].name;
                let message = format!("expected a type, found the trait `{name}`");
                let help = format!("`&dyn {name}`, or `Box<dyn {name}>`");
                Err(Refusal::new(place, &message, "", &help))
            }
            Ok(Named::Standard(name)) => Err(Refusal::unknown(place, &format!("`{name}`"))),
            Ok(_) => {
                let message = format!("expected type, found `{}`", last.ident);
                Err(Refusal::new(place, &message, "not a type", ""))
            }
            Err(lost) => Err(self.not_found(module, place, "type", &names, lost)),
        }
    }

    /// What has these traits: functions, and whatever has a trait of the reader's.
    fn bounded(
        &self,
        context: &Context,
        bounds: &Punctuated<syn::TypeParamBound, syn::Token![+]>,
    ) -> Read<Type> {
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
                _ => match self.found(context.module, &names(&bound.path)) {
                    Ok(Named::Trait(found)) => return Ok(Head::Dyn(found).into()),
                    Ok(_) => {}
                    Err(lost) => {
                        let (module, path) = (context.module, names(&bound.path));
                        let place = at(self.file(module), &bound.path);
                        return Err(self.not_found(module, place, "trait", &path, lost));
                    }
                },
            }
        }
        Ok(Type::UNKNOWN)
    }
}

fn literal(length: &syn::Expr) -> Option<usize> {
    match length {
        syn::Expr::Lit(syn::ExprLit {
            lit: syn::Lit::Int(it),
            ..
        }) => it.base10_parse().ok(),
        _ => None,
    }
}
