//! Name resolution: what the files declare, what they import, and which types their
//! signatures name.

use std::collections::HashMap;

use crate::read::place_of;
use crate::types::{Head, Int, Type};
use crate::{Fault, Place};

/// All that the files declare.
#[derive(Default)]
pub(crate) struct Items<'a> {
    pub(crate) kinds: Vec<Kind>,
    pub(crate) traits: Vec<Trait>,
    pub(crate) functions: Vec<Signature>,
    /// What is in each of them, if anything is.
    pub(crate) bodies: Vec<Option<Body<'a>>>,
    /// The names that each file knows.
    scopes: Vec<HashMap<String, Named>>,
    /// Those that it knows by a `*`: names of its own go before them.
    globs: Vec<HashMap<String, Named>>,
    /// Which file each module is.
    modules: HashMap<String, usize>,
}

/// What a name can be.
#[derive(Clone, Debug)]
pub(crate) enum Named {
    Type(Type),
    Trait(usize),
    /// A function, or a constant, which is a function without parameters.
    Function(usize),
    /// A type of the library that takes others, by its name.
    Generic(&'static str),
    /// A function of the library, by its name.
    Library(&'static str),
    /// A constant of the library.
    Number(f64),
    /// A module of the library.
    Module,
}

/// A struct, or an enum, of the reader's.
pub(crate) struct Kind {
    pub(crate) name: String,
    pub(crate) file: usize,
    pub(crate) is_enum: bool,
    pub(crate) variants: Vec<Variant>,
    pub(crate) derives: Vec<String>,
}

pub(crate) struct Variant {
    pub(crate) name: String,
    pub(crate) fields: Vec<Field>,
    pub(crate) shape: Shape,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    Named,
    Tuple,
    Unit,
}

pub(crate) struct Field {
    pub(crate) name: String,
    pub(crate) ty: Type,
    pub(crate) is_public: bool,
}

pub(crate) struct Trait {
    pub(crate) name: String,
    /// The functions that an implementation has, and those that it may have.
    pub(crate) methods: Vec<usize>,
    pub(crate) implemented_for: Vec<usize>,
}

/// The parameters and the result of a function.
#[derive(Clone, Debug)]
pub(crate) struct Signature {
    pub(crate) name: String,
    pub(crate) file: usize,
    pub(crate) place: Place,
    pub(crate) parameters: Vec<Type>,
    /// Whether the first is `self`.
    pub(crate) has_self: bool,
    pub(crate) result: Type,
    /// Whose function it is, if it is in an `impl`.
    pub(crate) of: Option<Type>,
    /// In which trait it is, by which it is called.
    pub(crate) in_trait: Option<usize>,
    pub(crate) is_constant: bool,
}

/// What is to be checked.
pub(crate) enum Body<'a> {
    Function(&'a syn::Signature, &'a syn::Block),
    Constant(&'a syn::Expr),
}

/// What a type is read with.
#[derive(Clone, Default)]
pub(crate) struct Context {
    pub(crate) file: usize,
    pub(crate) own: Option<Type>,
    pub(crate) parameters: HashMap<String, Type>,
}

pub(crate) fn unknown<T>(place: Place, what: &str) -> Result<T, Fault> {
    let message = format!("this page does not know {what}");
    Err(Fault::at(Some(place), &message, "", "cargo does"))
}

impl<'a> Items<'a> {
    /// What the signatures of the library are read with.
    pub(crate) fn library() -> Self {
        let mut scope = prelude();
        for name in ["Iterator", "Range"] {
            scope.insert(name.to_owned(), Named::Generic(name));
        }
        scope.extend(of_std(&["cmp"], "Ordering").map(|it| ("Ordering".to_owned(), it)));
        Self {
            scopes: vec![scope],
            globs: vec![HashMap::new()],
            ..Self::default()
        }
    }

    /// What these files declare: each with the name of its module, and the first is the root.
    pub(crate) fn of(files: &'a [(String, syn::File)]) -> Result<Self, Vec<Fault>> {
        let mut items = Self {
            scopes: vec![HashMap::new(); files.len()],
            globs: vec![HashMap::new(); files.len()],
            ..Self::default()
        };
        for (file, (module, _)) in files.iter().enumerate() {
            items.modules.insert(module.clone(), file);
        }
        let mut faults = Vec::new();
        let mut each = |items: &mut Self,
                        work: &mut dyn FnMut(
            &mut Self,
            usize,
            &'a syn::Item,
        ) -> Result<(), Fault>| {
            for (file, (_, tree)) in files.iter().enumerate() {
                for item in tree.items.iter().filter(|it| !is_test(it)) {
                    faults.extend(work(items, file, item).err());
                }
            }
        };
        each(&mut items, &mut Self::declare);
        // A name may be handed on from file to file, and a type by another name.
        for is_last in [false, false, true] {
            each(&mut items, &mut Self::import_all);
            each(&mut items, &mut |items, file, item| {
                let named = items.define_type(file, item);
                if is_last { named } else { Ok(()) }
            });
        }
        each(&mut items, &mut |items, file, item| match item {
            syn::Item::Trait(_) => items.define(file, item),
            _ => Ok(()),
        });
        each(&mut items, &mut |items, file, item| match item {
            syn::Item::Trait(_) => Ok(()),
            _ => items.define(file, item),
        });
        // Functions have their names now.
        each(&mut items, &mut Self::import_all);
        each(&mut items, &mut |items, file, item| match item {
            syn::Item::Use(it) => items.import(file, &[], &it.tree, true),
            _ => Ok(()),
        });
        let is_complete = items.are_traits_complete();
        faults.extend(is_complete.err());
        match faults.is_empty() {
            true => Ok(items),
            false => Err(faults),
        }
    }

    fn declare(&mut self, file: usize, item: &syn::Item) -> Result<(), Fault> {
        let (name, named) = match item {
            syn::Item::Struct(it) => {
                no_generics(file, &it.generics)?;
                (&it.ident, self.kind(file, &it.ident, &it.attrs, false))
            }
            syn::Item::Enum(it) => {
                no_generics(file, &it.generics)?;
                (&it.ident, self.kind(file, &it.ident, &it.attrs, true))
            }
            syn::Item::Trait(it) => {
                no_generics(file, &it.generics)?;
                self.traits.push(Trait {
                    name: it.ident.to_string(),
                    methods: Vec::new(),
                    implemented_for: Vec::new(),
                });
                (&it.ident, Named::Trait(self.traits.len() - 1))
            }
            syn::Item::Mod(it) if it.content.is_none() => {
                return match self.modules.contains_key(&it.ident.to_string()) {
                    true => Ok(()),
                    false => {
                        let message = format!("file not found for module `{}`", it.ident);
                        Err(Fault::at(Some(place_of(file, &it.ident)), &message, "", ""))
                    }
                };
            }
            syn::Item::Fn(_)
            | syn::Item::Impl(_)
            | syn::Item::Use(_)
            | syn::Item::Type(_)
            | syn::Item::Const(_)
            | syn::Item::Static(_) => return Ok(()),
            _ => return unknown(place_of(file, item), "this kind of item"),
        };
        self.name(file, name, named)
    }

    fn name(&mut self, file: usize, name: &syn::Ident, named: Named) -> Result<(), Fault> {
        match self.scopes[file].insert(name.to_string(), named) {
            None => Ok(()),
            Some(_) => {
                let message = format!("the name `{name}` is defined multiple times");
                Err(Fault::at(Some(place_of(file, name)), &message, "", ""))
            }
        }
    }

    fn kind(
        &mut self,
        file: usize,
        name: &syn::Ident,
        attributes: &[syn::Attribute],
        is_enum: bool,
    ) -> Named {
        let derives = attributes.iter().filter(|it| it.path().is_ident("derive"));
        let derives = derives.flat_map(|it| {
            let mut names = Vec::new();
            let _ = it.parse_nested_meta(|meta| {
                names.extend(meta.path.segments.last().map(|it| it.ident.to_string()));
                Ok(())
            });
            names
        });
        self.kinds.push(Kind {
            name: name.to_string(),
            file,
            is_enum,
            variants: Vec::new(),
            derives: derives.collect(),
        });
        Named::Type(Type::plain(Head::Own(self.kinds.len() - 1)))
    }

    fn import_all(&mut self, file: usize, item: &syn::Item) -> Result<(), Fault> {
        match item {
            syn::Item::Use(it) => self.import(file, &[], &it.tree, false),
            _ => Ok(()),
        }
    }

    fn import(
        &mut self,
        file: usize,
        before: &[String],
        tree: &syn::UseTree,
        must_be: bool,
    ) -> Result<(), Fault> {
        let path = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        let (name, found) = match tree {
            syn::UseTree::Path(it) => {
                return self.import(file, &path(&it.ident), &it.tree, must_be);
            }
            syn::UseTree::Group(it) => {
                let mut trees = it.items.iter();
                return trees.try_for_each(|tree| self.import(file, before, tree, must_be));
            }
            syn::UseTree::Glob(_) => {
                let names = match self.module(file, before) {
                    Some(module) => {
                        let mut names = self.globs[module].clone();
                        names.extend(self.scopes[module].clone());
                        names
                    }
                    None => match before.join("::").as_str() {
                        "common::rtweekend" => prelude(),
                        path if must_be => {
                            return unknown(place_of(file, tree), &format!("`{path}`"));
                        }
                        _ => return Ok(()),
                    },
                };
                self.globs[file].extend(names);
                return Ok(());
            }
            syn::UseTree::Name(it) if it.ident == "self" => return Ok(()),
            syn::UseTree::Name(it) => (&it.ident, path(&it.ident)),
            syn::UseTree::Rename(it) => (&it.rename, path(&it.ident)),
        };
        match self.found(file, &found) {
            Some(named) => {
                self.scopes[file].insert(name.to_string(), named);
                Ok(())
            }
            None if must_be => {
                let message = format!("unresolved import `{}`", found.join("::"));
                Err(Fault::at(Some(place_of(file, name)), &message, "", ""))
            }
            None => Ok(()),
        }
    }

    /// The file that a path of modules leads to.
    fn module(&self, file: usize, path: &[String]) -> Option<usize> {
        match path {
            [] => Some(file),
            [first, rest @ ..] if first == "self" => self.module(file, rest),
            // Modules are one below the root.
            [first, rest @ ..] if first == "crate" || first == "super" => self.module(0, rest),
            [name] => self.modules.get(name).copied(),
            _ => None,
        }
    }

    /// What a path means in the file.
    pub(crate) fn found(&self, file: usize, path: &[String]) -> Option<Named> {
        let (name, modules) = path.split_last()?;
        if let Some(module) = self.module(file, modules)
            && let Some(named) = self.scopes[module]
                .get(name)
                .or_else(|| self.globs[module].get(name))
        {
            return Some(named.clone());
        }
        let modules: Vec<&str> = modules.iter().map(String::as_str).collect();
        match modules.as_slice() {
            [] => standard(name),
            ["common", "rtweekend"] => prelude().remove(name),
            ["std" | "core", rest @ ..] => of_std(rest, name),
            ["f64", "consts"] => constant(name),
            ["consts"] if matches!(self.scopes[file].get("consts"), Some(Named::Module)) => {
                constant(name)
            }
            _ => None,
        }
    }

    fn define(&mut self, file: usize, item: &'a syn::Item) -> Result<(), Fault> {
        let context = Context {
            file,
            ..Context::default()
        };
        match item {
            syn::Item::Struct(it) => self.fields(&context, &it.ident, &it.ident, &it.fields),
            syn::Item::Enum(it) => {
                let mut variants = it.variants.iter();
                variants.try_for_each(|variant| {
                    self.fields(&context, &it.ident, &variant.ident, &variant.fields)
                })
            }
            syn::Item::Const(it) => self.constant(&context, &it.ident, &it.ty, &it.expr),
            syn::Item::Static(it) => self.constant(&context, &it.ident, &it.ty, &it.expr),
            syn::Item::Fn(it) => {
                let function = self.signature(&context, &it.sig, Some(&it.block))?;
                self.name(file, &it.sig.ident, Named::Function(function))
            }
            syn::Item::Trait(it) => {
                let Some(Named::Trait(own)) = self.scopes[file].get(&it.ident.to_string()).cloned()
                else {
                    return Ok(());
                };
                let context = Context {
                    own: Some(Type::plain(Head::Dyn(own))),
                    ..context
                };
                for item in &it.items {
                    let syn::TraitItem::Fn(method) = item else {
                        return unknown(place_of(file, item), "this in a trait");
                    };
                    let function =
                        self.signature(&context, &method.sig, method.default.as_ref())?;
                    self.traits[own].methods.push(function);
                }
                Ok(())
            }
            syn::Item::Impl(it) => self.implementation(context, it),
            _ => Ok(()),
        }
    }

    /// Another name for a type.
    fn define_type(&mut self, file: usize, item: &syn::Item) -> Result<(), Fault> {
        let syn::Item::Type(it) = item else {
            return Ok(());
        };
        if self.scopes[file].contains_key(&it.ident.to_string()) {
            return Ok(());
        }
        let context = Context {
            file,
            ..Context::default()
        };
        let ty = self.ty(&context, &it.ty)?;
        self.name(file, &it.ident, Named::Type(ty))
    }

    fn fields(
        &mut self,
        context: &Context,
        kind: &syn::Ident,
        name: &syn::Ident,
        fields: &syn::Fields,
    ) -> Result<(), Fault> {
        let own = self.scopes[context.file].get(&kind.to_string()).cloned();
        let Some(Named::Type(Type::Of(Head::Own(own), _))) = own else {
            return Ok(());
        };
        let shape = match fields {
            syn::Fields::Named(_) => Shape::Named,
            syn::Fields::Unnamed(_) => Shape::Tuple,
            syn::Fields::Unit => Shape::Unit,
        };
        let is_enum = self.kinds[own].is_enum;
        let fields = fields.iter().enumerate().map(|(n, field)| {
            Ok(Field {
                name: field
                    .ident
                    .as_ref()
                    .map_or(n.to_string(), ToString::to_string),
                ty: self.ty(context, &field.ty)?,
                is_public: is_enum || !matches!(field.vis, syn::Visibility::Inherited),
            })
        });
        let fields = fields.collect::<Result<Vec<_>, Fault>>()?;
        self.kinds[own].variants.push(Variant {
            name: name.to_string(),
            fields,
            shape,
        });
        Ok(())
    }

    fn constant(
        &mut self,
        context: &Context,
        name: &syn::Ident,
        ty: &syn::Type,
        value: &'a syn::Expr,
    ) -> Result<(), Fault> {
        let signature = Signature {
            name: name.to_string(),
            file: context.file,
            place: place_of(context.file, name),
            parameters: Vec::new(),
            has_self: false,
            result: self.ty(context, ty)?,
            of: context.own.clone(),
            in_trait: None,
            is_constant: true,
        };
        self.functions.push(signature);
        self.bodies.push(Some(Body::Constant(value)));
        match context.own {
            Some(_) => Ok(()),
            None => self.name(
                context.file,
                name,
                Named::Function(self.functions.len() - 1),
            ),
        }
    }

    fn implementation(&mut self, context: Context, it: &'a syn::ItemImpl) -> Result<(), Fault> {
        let file = context.file;
        no_generics(file, &it.generics)?;
        let own = self.ty(&context, &it.self_ty)?;
        let Some(Head::Own(kind)) = own.head() else {
            return unknown(
                place_of(file, &it.self_ty),
                "an `impl` for a type that is not yours",
            );
        };
        let implemented = match &it.trait_ {
            Some((path, _)) => match self.found(file, &names(path)) {
                Some(Named::Trait(found)) => {
                    self.traits[found].implemented_for.push(kind);
                    Some(found)
                }
                // `Default` and `Clone` written out are functions like others.
                _ if path.is_ident("Default") || path.is_ident("Clone") => None,
                _ => {
                    return unknown(
                        place_of(file, path),
                        &format!("the trait `{}`", names(path).join("::")),
                    );
                }
            },
            None => None,
        };
        if it
            .trait_
            .as_ref()
            .is_some_and(|(path, _)| path.is_ident("Clone"))
        {
            self.kinds[kind].derives.push("Clone".to_owned());
        }
        let context = Context {
            own: Some(own),
            ..context
        };
        for item in &it.items {
            match item {
                syn::ImplItem::Fn(function) => {
                    let made = self.signature(&context, &function.sig, Some(&function.block))?;
                    self.functions[made].in_trait = implemented;
                    self.fits_its_trait(made)?;
                }
                syn::ImplItem::Const(it) => {
                    self.constant(&context, &it.ident, &it.ty, &it.expr)?;
                }
                _ => return unknown(place_of(file, item), "this in an `impl`"),
            }
        }
        Ok(())
    }

    fn fits_its_trait(&self, function: usize) -> Result<(), Fault> {
        let own = &self.functions[function];
        let Some(implemented) = own.in_trait.map(|it| &self.traits[it]) else {
            return Ok(());
        };
        let mut methods = implemented.methods.iter().map(|&it| &self.functions[it]);
        let message = match methods.find(|it| it.name == own.name) {
            None => format!(
                "method `{}` is not a member of trait `{}`",
                own.name, implemented.name
            ),
            Some(it)
                if it.parameters.len() != own.parameters.len()
                    || it.parameters[usize::from(it.has_self)..]
                        != own.parameters[usize::from(it.has_self)..]
                    || it.has_self != own.has_self
                    || it.result != own.result =>
            {
                format!("method `{}` has an incompatible type for trait", own.name)
            }
            Some(_) => return Ok(()),
        };
        Err(Fault::at(Some(own.place.clone()), &message, "", ""))
    }

    fn are_traits_complete(&self) -> Result<(), Fault> {
        for (n, it) in self.traits.iter().enumerate() {
            for &kind in &it.implemented_for {
                let mut methods = it
                    .methods
                    .iter()
                    .filter(|&&method| self.bodies[method].is_none());
                let missing = methods.find(|&&method| {
                    self.method(kind, &self.functions[method].name, Some(n))
                        .is_none()
                });
                if let Some(missing) = missing.map(|&method| &self.functions[method]) {
                    let message = format!(
                        "not all trait items implemented, missing: `{}`",
                        missing.name
                    );
                    let label = format!("`{}` for `{}`", it.name, self.kinds[kind].name);
                    return Err(Fault::at(Some(missing.place.clone()), &message, &label, ""));
                }
            }
        }
        Ok(())
    }

    /// The function of that name in an `impl` for the kind, of that trait if one is named.
    pub(crate) fn method(&self, kind: usize, name: &str, of_trait: Option<usize>) -> Option<usize> {
        let is_it = |it: &Signature| {
            it.name == name
                && it.of.as_ref().is_some_and(|of| of.is(Head::Own(kind)))
                && (of_trait.is_none() || it.in_trait == of_trait)
        };
        self.functions.iter().position(is_it)
    }

    /// The same, or the one that a trait gives to all.
    pub(crate) fn method_or_default(&self, kind: usize, name: &str) -> Option<usize> {
        self.method(kind, name, None).or_else(|| {
            let mut traits = self
                .traits
                .iter()
                .filter(|it| it.implemented_for.contains(&kind));
            traits.find_map(|it| self.method_of(it, name))
        })
    }

    pub(crate) fn method_of(&self, of: &Trait, name: &str) -> Option<usize> {
        let mut methods = of.methods.iter().copied();
        methods.find(|&it| self.functions[it].name == name)
    }

    /// Keeps the signature of a function; returns its number.
    fn signature(
        &mut self,
        context: &Context,
        it: &'a syn::Signature,
        body: Option<&'a syn::Block>,
    ) -> Result<usize, Fault> {
        let signature = self.read_signature(context, it)?;
        self.functions.push(signature);
        self.bodies.push(body.map(|body| Body::Function(it, body)));
        Ok(self.functions.len() - 1)
    }

    /// A signature whose type parameters stand for what has their traits.
    pub(crate) fn read_signature(
        &self,
        context: &Context,
        it: &syn::Signature,
    ) -> Result<Signature, Fault> {
        let file = context.file;
        if it.asyncness.is_some() {
            return unknown(place_of(file, &it.ident), "`async`");
        }
        let mut context = context.clone();
        for parameter in &it.generics.params {
            match parameter {
                syn::GenericParam::Lifetime(_) => {}
                syn::GenericParam::Type(parameter) => {
                    let ty = match parameter.bounds.is_empty() {
                        true => where_bounds(&it.generics, &parameter.ident),
                        false => Some(&parameter.bounds),
                    };
                    let Some(bounds) = ty else {
                        return unknown(
                            place_of(file, parameter),
                            "type parameters without a trait",
                        );
                    };
                    let ty = self.bounded(&context, bounds, place_of(file, parameter))?;
                    context.parameters.insert(parameter.ident.to_string(), ty);
                }
                syn::GenericParam::Const(_) => {
                    return unknown(place_of(file, parameter), "constants as parameters");
                }
            }
        }
        let parameters = it.inputs.iter().map(|input| match input {
            syn::FnArg::Typed(input) => self.ty(&context, &input.ty),
            syn::FnArg::Receiver(receiver) => {
                let Some(own) = context.own.clone() else {
                    let message = "`self` parameter is only allowed in associated functions";
                    return Err(Fault::at(Some(place_of(file, receiver)), message, "", ""));
                };
                match &receiver.kind {
                    syn::ReceiverKind::Value => Ok(own),
                    syn::ReceiverKind::Reference(_, _, Some(_)) => Ok(Type::one(Head::RefMut, own)),
                    syn::ReceiverKind::Reference(..) => Ok(Type::one(Head::Ref, own)),
                    syn::ReceiverKind::Typed(_, ty) => self.ty(&context, ty),
                    _ => unknown(place_of(file, receiver), "this kind of `self`"),
                }
            }
        });
        Ok(Signature {
            name: it.ident.to_string(),
            file,
            place: place_of(file, &it.ident),
            parameters: parameters.collect::<Result<_, _>>()?,
            has_self: matches!(it.inputs.first(), Some(syn::FnArg::Receiver(_))),
            result: self.result(&context, &it.output)?,
            of: context.own,
            in_trait: None,
            is_constant: false,
        })
    }

    fn result(&self, context: &Context, output: &syn::ReturnType) -> Result<Type, Fault> {
        match output {
            syn::ReturnType::Default => Ok(Type::unit()),
            syn::ReturnType::Type(_, ty) => self.ty(context, ty),
        }
    }

    /// The type that is written there.
    pub(crate) fn ty(&self, context: &Context, ty: &syn::Type) -> Result<Type, Fault> {
        let place = || place_of(context.file, ty);
        Ok(match ty {
            syn::Type::Paren(it) => self.ty(context, &it.elem)?,
            syn::Type::Group(it) => self.ty(context, &it.elem)?,
            syn::Type::Never(_) => Type::plain(Head::Never),
            syn::Type::Tuple(it) => {
                let all = it.elems.iter().map(|it| self.ty(context, it));
                Type::Of(Head::Tuple, all.collect::<Result<_, _>>()?)
            }
            syn::Type::Reference(it) => {
                let head = match it.mutability {
                    Some(_) => Head::RefMut,
                    None => Head::Ref,
                };
                Type::one(head, self.ty(context, &it.elem)?)
            }
            syn::Type::Slice(it) => Type::one(Head::Slice, self.ty(context, &it.elem)?),
            syn::Type::Array(it) => match literal(&it.len) {
                Some(length) => Type::one(Head::Array(length), self.ty(context, &it.elem)?),
                None => return unknown(place(), "lengths that are no number"),
            },
            syn::Type::TraitObject(it) => self.bounded(context, &it.bounds, place())?,
            syn::Type::ImplTrait(it) => self.bounded(context, &it.bounds, place())?,
            syn::Type::FnPtr(it) => {
                let parameters = it.inputs.iter().map(|it| self.ty(context, &it.ty));
                let parameters = parameters.collect::<Result<Vec<_>, _>>()?;
                Type::function(parameters, self.result(context, &it.output)?)
            }
            syn::Type::Path(it) if it.qself.is_none() => self.path(context, &it.path)?,
            _ => return unknown(place(), "this kind of type"),
        })
    }

    fn path(&self, context: &Context, path: &syn::Path) -> Result<Type, Fault> {
        let place = place_of(context.file, path);
        let last = path.segments.last().expect("a path has a name");
        if let Some(name) = path.get_ident().map(ToString::to_string) {
            if name == "Self"
                && let Some(own) = &context.own
            {
                return Ok(own.clone());
            }
            if let Some(parameter) = context.parameters.get(&name) {
                return Ok(parameter.clone());
            }
        }
        let arguments = match &last.arguments {
            syn::PathArguments::AngleBracketed(it) => {
                let types = it.args.iter().filter_map(|it| match it {
                    syn::GenericArgument::Type(ty) => Some(self.ty(context, ty)),
                    _ => None,
                });
                types.collect::<Result<Vec<_>, _>>()?
            }
            _ => Vec::new(),
        };
        match self.found(context.file, &names(path)) {
            Some(Named::Type(ty)) if arguments.is_empty() => Ok(ty),
            Some(Named::Generic(name)) if arguments.len() == 1 => {
                Ok(Type::Of(generic(name), arguments))
            }
            Some(Named::Generic(name)) => {
                let message = format!("missing generics for `{name}`");
                Err(Fault::at(
                    Some(place),
                    &message,
                    "expected 1 generic argument",
                    &format!("`{name}<T>`"),
                ))
            }
            Some(Named::Trait(found)) => {
                let name = &self.traits[found].name;
                let message = format!("expected a type, found the trait `{name}`");
                Err(Fault::at(
                    Some(place),
                    &message,
                    "",
                    &format!("`&dyn {name}`, or `Box<dyn {name}>`"),
                ))
            }
            _ => Err(self.not_found(context.file, place, "type", &last.ident.to_string())),
        }
    }

    /// What has these traits: functions, iterators, and whatever has a trait of the reader's.
    fn bounded(
        &self,
        context: &Context,
        bounds: &syn::punctuated::Punctuated<syn::TypeParamBound, syn::Token![+]>,
        place: Place,
    ) -> Result<Type, Fault> {
        for bound in bounds {
            let syn::TypeParamBound::Trait(bound) = bound else {
                continue;
            };
            let last = bound.path.segments.last().expect("a path has a name");
            match (&last.arguments, last.ident.to_string().as_str()) {
                (syn::PathArguments::Parenthesized(it), "Fn" | "FnMut" | "FnOnce") => {
                    let parameters = it.inputs.iter().map(|it| self.ty(context, &it.ty));
                    let parameters = parameters.collect::<Result<Vec<_>, _>>()?;
                    return Ok(Type::function(
                        parameters,
                        self.result(context, &it.output)?,
                    ));
                }
                (syn::PathArguments::AngleBracketed(it), "Iterator" | "IntoIterator") => {
                    for argument in &it.args {
                        if let syn::GenericArgument::AssocType(item) = argument {
                            return Ok(Type::one(Head::Iterator, self.ty(context, &item.ty)?));
                        }
                    }
                }
                (_, "Send" | "Sync" | "Sized" | "Debug" | "Copy" | "Clone") => {}
                _ => match self.found(context.file, &names(&bound.path)) {
                    Some(Named::Trait(found)) => return Ok(Type::plain(Head::Dyn(found))),
                    _ => {
                        let place = place_of(context.file, &bound.path);
                        return Err(self.not_found(
                            context.file,
                            place,
                            "trait",
                            &last.ident.to_string(),
                        ));
                    }
                },
            }
        }
        unknown(place, "type parameters without a trait of yours")
    }

    /// Says that there is no such name, and which one was meant.
    pub(crate) fn not_found(&self, file: usize, place: Place, what: &str, name: &str) -> Fault {
        let message = format!("cannot find {what} `{name}` in this scope");
        let files = 0..self.scopes.len();
        let mut elsewhere = files.filter(|&it| it != file && self.scopes[it].contains_key(name));
        let module = |it: usize| self.modules.iter().find(|(_, file)| **file == it);
        let help = if prelude().contains_key(name) {
            "`use common::rtweekend::*;` is missing".to_owned()
        } else if let Some((module, _)) = elsewhere.next().and_then(module) {
            format!("`use crate::{module}::{name};` is missing")
        } else {
            let known = self.scopes[file].keys().chain(self.globs[file].keys());
            let known = known.map(String::as_str);
            similar(name, known).map_or(String::new(), |it| format!("there is `{it}`"))
        };
        Fault::at(Some(place), &message, "not found in this scope", &help)
    }
}

/// The name that is most like this one, if one is.
pub(crate) fn similar<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let near = |other: &&str| {
        let distance = distance(name, other);
        distance * 3 <= name.len().max(3)
            || (other.len() > 2
                && (name.starts_with(other) || other.starts_with(name))
                && name.len() > 2)
    };
    among
        .filter(near)
        .min_by_key(|other| (distance(name, other), *other))
}

/// How many letters must be changed, added or left out (Levenshtein, 1965).
fn distance(one: &str, other: &str) -> usize {
    let mut row: Vec<usize> = (0..=other.chars().count()).collect();
    for (i, a) in one.chars().enumerate() {
        let mut before = row[0];
        row[0] = i + 1;
        for (j, b) in other.chars().enumerate() {
            let replaced = before + usize::from(a != b);
            before = row[j + 1];
            row[j + 1] = replaced.min(before + 1).min(row[j] + 1);
        }
    }
    row[row.len() - 1]
}

pub(crate) fn names(path: &syn::Path) -> Vec<String> {
    path.segments
        .iter()
        .map(|it| it.ident.to_string())
        .collect()
}

fn is_test(item: &syn::Item) -> bool {
    matches!(item, syn::Item::Mod(it) if it.ident == "tests")
}

fn no_generics(file: usize, generics: &syn::Generics) -> Result<(), Fault> {
    let mut parameters = generics.params.iter();
    match parameters.find(|it| !matches!(it, syn::GenericParam::Lifetime(_))) {
        None => Ok(()),
        Some(parameter) => unknown(
            place_of(file, parameter),
            "type parameters of structs, traits and `impl`s",
        ),
    }
}

fn where_bounds<'a>(
    generics: &'a syn::Generics,
    name: &syn::Ident,
) -> Option<&'a syn::punctuated::Punctuated<syn::TypeParamBound, syn::Token![+]>> {
    let mut predicates = generics.where_clause.iter().flat_map(|it| &it.predicates);
    predicates.find_map(|it| match it {
        syn::WherePredicate::Type(it) => match &it.bounded_ty {
            syn::Type::Path(ty) if ty.path.is_ident(name) => Some(&it.bounds),
            _ => None,
        },
        _ => None,
    })
}

pub(crate) fn literal(length: &syn::Expr) -> Option<usize> {
    match length {
        syn::Expr::Lit(syn::ExprLit {
            lit: syn::Lit::Int(it),
            ..
        }) => it.base10_parse().ok(),
        _ => None,
    }
}

pub(crate) fn generic(name: &str) -> Head {
    match name {
        "Option" => Head::Option,
        "Vec" => Head::Vec,
        "Range" => Head::Range,
        "Iterator" => Head::Iterator,
        _ => Head::Box,
    }
}

/// What every file knows.
fn standard(name: &str) -> Option<Named> {
    let plain = |head| Some(Named::Type(Type::plain(head)));
    match name {
        "f64" => plain(Head::F64),
        "f32" => plain(Head::F32),
        "bool" => plain(Head::Bool),
        "str" => plain(Head::Str),
        "Option" => Some(Named::Generic("Option")),
        "Box" => Some(Named::Generic("Box")),
        "Vec" => Some(Named::Generic("Vec")),
        _ => Int::named(name).and_then(|int| plain(Head::Int(int))),
    }
}

/// What `use common::rtweekend::*` brings.
fn prelude() -> HashMap<String, Named> {
    let types = [
        ("Vec3", Head::Vec3),
        ("Point3", Head::Vec3),
        ("Color", Head::Vec3),
        ("Ray", Head::Ray),
        ("Camera", Head::Camera),
        ("Picture", Head::Picture),
    ];
    let types = types.map(|(name, head)| (name, Named::Type(Type::plain(head))));
    let functions = ["sky", "render"].map(|name| (name, Named::Library(name)));
    let all = types.into_iter().chain(functions);
    all.map(|(name, named)| (name.to_owned(), named)).collect()
}

fn of_std(modules: &[&str], name: &str) -> Option<Named> {
    match (modules, name) {
        (["rc"], "Rc") => Some(Named::Generic("Rc")),
        (["sync"], "Arc") => Some(Named::Generic("Arc")),
        (["boxed"], "Box") => Some(Named::Generic("Box")),
        (["option"], "Option") => Some(Named::Generic("Option")),
        (["vec"], "Vec") => Some(Named::Generic("Vec")),
        (["cmp"], "Ordering") => Some(Named::Type(Type::plain(Head::Ordering))),
        (["ops"], "Range") => Some(Named::Generic("Range")),
        (["f64"], "consts") => Some(Named::Module),
        (["f64", "consts"], _) => constant(name),
        (["f64"], "INFINITY") => Some(Named::Number(f64::INFINITY)),
        (["f64"], "EPSILON") => Some(Named::Number(f64::EPSILON)),
        _ => None,
    }
}

fn constant(name: &str) -> Option<Named> {
    use std::f64::consts;
    Some(Named::Number(match name {
        "PI" => consts::PI,
        "TAU" => consts::TAU,
        "E" => consts::E,
        "SQRT_2" => consts::SQRT_2,
        "FRAC_PI_2" => consts::FRAC_PI_2,
        "FRAC_1_SQRT_2" => consts::FRAC_1_SQRT_2,
        _ => return None,
    }))
}
