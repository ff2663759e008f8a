//! Definition pass: what each declared item is, and the types of its parts.

use std::mem;

use super::{FieldDef, Meaning, Module, Names, Resolved, Signature, TypeScope, names};
use crate::operators::ArithOp;
use crate::read::at;
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

/// The syntax tree of a function's signature and body, or of a constant's value.
#[derive(Clone, Copy)]
pub(crate) enum ItemBody<'a> {
    Function(&'a syn::Signature, &'a syn::Block),
    Constant(&'a syn::Expr),
}

/// Collects all that the files declare, each given by its name and syntax tree. The root is the
/// file whose name ends with `lib.rs`, or else the first. Beside the names stands the body of each
/// function; `None` for one that a trait only declares.
///
/// # Errors
/// The faults in declarations, from the first pass that finds any.
///
/// # Panics
/// If there is no file.
pub(crate) fn collect<'a>(
    files: &'a [(String, syn::File)],
) -> Result<(Names, Vec<Option<ItemBody<'a>>>), Vec<Refusal>> {
    let mut collector = Collector {
        files,
        names: Names::default(),
        items: Vec::new(),
        imports: Vec::new(),
        blocks: Vec::new(),
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

/// The state of the passes over declarations.
pub(super) struct Collector<'a> {
    pub(super) files: &'a [(String, syn::File)],
    pub(super) names: Names,
    /// All items, each with the number of its module.
    pub(super) items: Vec<(usize, &'a syn::Item)>,
    /// All imports: the number of the module, the path, and its span.
    pub(super) imports: Vec<(usize, Vec<String>, Span)>,
    /// The bodies of functions that declare items, each with the number of the module that it
    /// forms.
    pub(super) blocks: Vec<(&'a syn::Block, usize)>,
    /// The body of each function; `None` for one that a trait only declares.
    pub(super) bodies: Vec<Option<ItemBody<'a>>>,
    pub(super) faults: Vec<Refusal>,
}

impl<'a> Collector<'a> {
    pub(super) fn at(&self, module: usize, it: &impl syn::spanned::Spanned) -> Span {
        at(self.names.modules[module].file, it)
    }

    pub(super) fn unread(
        &self,
        module: usize,
        it: &impl syn::spanned::Spanned,
        what: &str,
    ) -> Refusal {
        Refusal::unread(self.at(module, it), what)
    }

    /// Resolves all types and paths in declarations, after all names are declared.
    fn define(&mut self) {
        let items = mem::take(&mut self.items);
        let each = |own: &mut Self, work: fn(&mut Self, usize, &'a syn::Item) -> Resolved| {
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
            each(self, Self::item);
        }
        if self.faults.is_empty() {
            let checked = self.names.check_traits();
            let checked = checked.and_then(|()| self.names.check_structs());
            self.faults.extend(checked.err());
            self.index();
        }
    }

    /// Resolves a `type … = …`; it is called again for an alias of a later alias.
    fn alias(&mut self, module: usize, item: &'a syn::Item) -> Resolved {
        let syn::Item::Type(it) = item else {
            return Ok(());
        };
        let ty = self.names.ty(&TypeScope::of(module), &it.ty)?;
        let names = &mut self.names.modules[module].names;
        let entry = names.get_mut(&it.ident.to_string());
        entry.expect("it was declared").named = Meaning::Type(ty);
        Ok(())
    }

    /// Resolves the types in an item.
    fn item(&mut self, module: usize, item: &'a syn::Item) -> Resolved {
        let context = TypeScope::of(module);
        match item {
            syn::Item::Struct(it) => self.fields(&context, it),
            syn::Item::Trait(it) => self.promises(context, it),
            syn::Item::Fn(it) => {
                let number = self.number(module, &it.sig.ident);
                let is_public = is_public(&it.vis);
                self.put(number, &context, &it.sig, Some(&it.block), is_public)
            }
            syn::Item::Const(it) => {
                let number = self.number(module, &it.ident);
                self.constant(number, &context, &it.ident, (&it.ty, &it.expr))
            }
            syn::Item::Static(it) => {
                let number = self.number(module, &it.ident);
                self.constant(number, &context, &it.ident, (&it.ty, &it.expr))
            }
            syn::Item::Impl(it) => self.implementation(context, it),
            _ => Ok(()),
        }
    }

    /// Returns what a declared name means.
    fn declared(&self, module: usize, name: &syn::Ident) -> Meaning {
        let names = &self.names.modules[module].names;
        names[&name.to_string()].named.clone()
    }

    /// Returns the number of a declared function.
    fn number(&self, module: usize, name: &syn::Ident) -> usize {
        match self.declared(module, name) {
            Meaning::Function(number) => number,
            other => unreachable!("it was declared as a function, and not as {other:?}"),
        }
    }

    /// Resolves the methods of a trait.
    fn promises(&mut self, context: TypeScope, it: &'a syn::ItemTrait) -> Resolved {
        let Meaning::Trait(own) = self.declared(context.module, &it.ident) else {
            return Ok(());
        };
        let module = context.module;
        let context = TypeScope {
            own: Some(Ctor::Dyn(own).into()),
            ..context
        };
        for item in &it.items {
            let syn::TraitItem::Fn(method) = item else {
                return Err(self.unread(module, item, "this in a trait"));
            };
            if let Some(default) = &method.default {
                let what = "functions that a trait gives to all";
                return Err(self.unread(module, default, what));
            }
            let function = self.method(&context, &method.sig, None, true)?;
            self.names.traits[own].methods.push(function);
        }
        Ok(())
    }

    /// Resolves the fields of a struct.
    fn fields(&mut self, context: &TypeScope, it: &syn::ItemStruct) -> Resolved {
        let Meaning::Type(Type(Ctor::Own(own), _)) = self.declared(context.module, &it.ident)
        else {
            return Ok(());
        };
        let fields = it.fields.iter().enumerate().map(|(n, field)| {
            let name = field.ident.as_ref();
            Ok(FieldDef {
                name: name.map_or(n.to_string(), ToString::to_string),
                ty: self.names.ty(context, &field.ty)?,
                is_public: is_public(&field.vis),
            })
        });
        self.names.structs[own as usize].fields = fields.collect::<Resolved<_>>()?;
        Ok(())
    }

    /// Resolves the signature of the function with a known number, and keeps its body.
    fn put(
        &mut self,
        number: usize,
        context: &TypeScope,
        it: &'a syn::Signature,
        block: Option<&'a syn::Block>,
        is_public: bool,
    ) -> Resolved {
        let mut signature = self.names.signature(context, it)?;
        let is_it = |own: &&(&syn::Block, usize)| block.is_some_and(|it| std::ptr::eq(it, own.0));
        if let Some((_, module)) = self.blocks.iter().find(is_it) {
            signature.inside = *module;
        }
        signature.is_public = is_public;
        self.names.functions[number] = signature;
        self.bodies[number] = block.map(|block| ItemBody::Function(it, block));
        Ok(())
    }

    /// Numbers a method, and resolves its signature.
    fn method(
        &mut self,
        context: &TypeScope,
        it: &'a syn::Signature,
        block: Option<&'a syn::Block>,
        is_public: bool,
    ) -> Resolved<usize> {
        self.function();
        let number = self.names.functions.len() - 1;
        self.put(number, context, it, block, is_public)?;
        Ok(number)
    }

    /// Resolves the type of a constant, which counts as a function without parameters.
    fn constant(
        &mut self,
        number: usize,
        context: &TypeScope,
        name: &syn::Ident,
        (ty, value): (&syn::Type, &'a syn::Expr),
    ) -> Resolved {
        self.names.functions[number] = Signature {
            name: name.to_string(),
            module: context.module,
            inside: context.module,
            at: self.at(context.module, name),
            is_public: true,
            is_constant: true,
            of: context.own.clone(),
            result: self.names.ty(context, ty)?,
            ..Signature::default()
        };
        self.bodies[number] = Some(ItemBody::Constant(value));
        Ok(())
    }

    /// Resolves the functions in an `impl`.
    fn implementation(&mut self, context: TypeScope, it: &'a syn::ItemImpl) -> Resolved {
        let module = context.module;
        self.no_generics(module, &it.generics)?;
        let own = self.names.ty(&context, &it.self_ty)?;
        let (mut in_trait, mut in_standard) = (None, None);
        if let Some((path, _)) = &it.trait_ {
            match self.names.found(module, &names(path)) {
                Ok(Meaning::Trait(found)) => {
                    self.names.traits[found].implemented_for.push(own.clone());
                    in_trait = Some(found);
                }
                Ok(Meaning::Standard(name)) => in_standard = Some(name),
                Err(lost) => {
                    let (at, path) = (self.at(module, path), names(path));
                    return Err(self.names.not_found(module, at, "trait", &path, lost));
                }
                Ok(_) => return Err(self.unread(module, path, "this trait")),
            }
        }
        let mut context = TypeScope {
            own: Some(own),
            ..context
        };
        for item in &it.items {
            match item {
                syn::ImplItem::Type(it) => {
                    let ty = self.names.ty(&context, &it.ty)?;
                    context.parameters.insert(format!("Self::{}", it.ident), ty);
                }
                syn::ImplItem::Fn(method) => {
                    let is_public = is_public(&method.vis);
                    if is_public && it.trait_.is_some() {
                        return Err(self.no_visibility(module, &method.vis));
                    }
                    let made =
                        self.method(&context, &method.sig, Some(&method.block), is_public)?;
                    let made = &mut self.names.functions[made];
                    made.in_trait = in_trait;
                    made.in_standard.clone_from(&in_standard);
                }
                syn::ImplItem::Const(it) => {
                    self.function();
                    let made = self.names.functions.len() - 1;
                    self.constant(made, &context, &it.ident, (&it.ty, &it.expr))?;
                }
                _ => return Err(self.unread(module, item, "this in an `impl`")),
            }
        }
        Ok(())
    }

    /// Makes the refusal of a `pub` in the `impl` of a trait.
    fn no_visibility(&self, module: usize, visibility: &syn::Visibility) -> Refusal {
        let message = "visibility qualifiers are not permitted here";
        let label = "trait items always share the visibility of their trait";
        let at = self.at(module, visibility);
        Refusal::new(at, message, label, "leave the `pub` out")
    }

    /// Finds the functions that no name calls: operators and defaults; and the text's own types of
    /// rays and vectors.
    fn index(&mut self) {
        let names = &mut self.names;
        for (n, own) in names.functions.iter().enumerate() {
            match (own.in_standard.as_deref(), own.of.as_ref().map(|it| it.0)) {
                (Some("Neg"), _) => names.negations.push(n),
                (Some("Default"), Some(Ctor::Own(kind))) => {
                    names.structs[kind as usize].default = Some(n);
                }
                (Some(name), _) => {
                    let plain = name.trim_end_matches("Assign");
                    let sign = ArithOp::of_trait(plain);
                    let operator = sign.map(|it| (it, plain != name, n));
                    names.operators.extend(operator);
                }
                (None, Some(Ctor::Own(kind))) if own.name == "default" => {
                    names.structs[kind as usize].default = Some(n);
                }
                _ => {}
            }
        }
        // Vectors are what a ray is made of, and that is what `ray_color` takes.
        let own_kind = |ty: Option<&Type>| match ty?.stripped().0 {
            Ctor::Own(kind) => Some(kind),
            _ => None,
        };
        let mut functions = names.functions.iter();
        let ray_color = functions.find(|it| it.name == "ray_color" && it.of.is_none());
        names.own_ray = ray_color.and_then(|it| own_kind(it.parameters.first()));
        names.own_vec3 = names.own_ray.and_then(|ray| {
            let first = names.structs[ray as usize].fields.first();
            own_kind(first.map(|it| &it.ty))
        });
    }

    /// Refuses type parameters.
    pub(super) fn no_generics(&self, module: usize, generics: &syn::Generics) -> Resolved {
        let mut parameters = generics.params.iter();
        match parameters.find(|it| !matches!(it, syn::GenericParam::Lifetime(_))) {
            None => Ok(()),
            Some(parameter) => {
                let what = "type parameters of structs, traits and `impl`s";
                Err(self.unread(module, parameter, what))
            }
        }
    }
}

/// Returns true for any `pub`, also one with parentheses.
pub(super) fn is_public(visibility: &syn::Visibility) -> bool {
    !matches!(visibility, syn::Visibility::Inherited)
}

/// Returns true for a module `tests`, which is not read.
pub(super) fn is_test(item: &syn::Item) -> bool {
    matches!(item, syn::Item::Mod(it) if it.ident == "tests")
}
