//! Declarations: what each item of the files is, and the types of its parts.

use syn::visit::{self, Visit};

use crate::fault::{Fault, PRELUDE, Span};
use crate::names::{Item, KindDef, Names, Parameter, Scope, Signature, Variant};
use crate::value::{Kind, Shape, kind};

/// The syntax of a function, or of a constant's value.
#[derive(Clone, Copy)]
pub(crate) enum Source<'t> {
    Function(&'t syn::Signature, &'t syn::Block),
    Constant(&'t syn::Expr),
}

/// Adds to `names` what the files declare, and returns the source of each function and constant.
///
/// # Errors
/// If a type is not known, or something is declared that is not read here.
pub(crate) fn collect<'t>(
    names: &mut Names,
    files: impl IntoIterator<Item = (u16, &'t syn::File)>,
) -> Result<Vec<Source<'t>>, Fault> {
    let mut all = Items::default();
    for (file, tree) in files {
        all.file = file;
        all.visit_file(tree);
    }
    let mut collector = Collector {
        first_kind: names.kinds.len() as Kind,
        first_function: names.signatures.len(),
        names,
        sources: Vec::new(),
    };
    let mut items = all.items.iter();
    items.try_for_each(|(file, item)| collector.name(*file, item))?;
    // One alias may stand for another that comes later.
    for _ in 0..2 {
        for (file, item) in &all.items {
            let _ = collector.alias(*file, item);
        }
    }
    for (file, item) in &all.items {
        collector.alias(*file, item)?;
    }
    for (file, item) in &all.items {
        collector.define(*file, item)?;
    }
    Ok(collector.sources)
}

/// All items, also those in modules and in bodies, each with its file.
#[derive(Default)]
struct Items<'t> {
    items: Vec<(u16, &'t syn::Item)>,
    file: u16,
}

impl<'t> Visit<'t> for Items<'t> {
    fn visit_item(&mut self, item: &'t syn::Item) {
        self.items.push((self.file, item));
        visit::visit_item(self, item);
    }

    fn visit_item_mod(&mut self, module: &'t syn::ItemMod) {
        // Tests are not run here.
        if !module.attrs.iter().any(|it| it.path().is_ident("cfg")) {
            visit::visit_item_mod(self, module);
        }
    }
}

/// Traits whose functions Rust calls where the text does not name them.
const IMPLIED: [&str; 11] = [
    "PartialEq",
    "PartialOrd",
    "Ord",
    "Deref",
    "DerefMut",
    "Index",
    "IndexMut",
    "Iterator",
    "IntoIterator",
    "Neg",
    "Not",
];

struct Collector<'n, 't> {
    names: &'n mut Names,
    /// The first type and the first function that these files declare.
    first_kind: Kind,
    first_function: usize,
    sources: Vec<Source<'t>>,
}

impl<'t> Collector<'_, 't> {
    /// Gives names to types and traits, and notes names that `use` replaces.
    fn name(&mut self, file: u16, item: &syn::Item) -> Result<(), Fault> {
        match item {
            syn::Item::Struct(it) => return self.kind(&it.ident, false, file),
            syn::Item::Enum(it) => return self.kind(&it.ident, true, file),
            syn::Item::Trait(it) => self.add(&it.ident, Item::Trait),
            syn::Item::Use(it) => self.rename(&it.tree),
            _ => {}
        }
        Ok(())
    }

    fn add(&mut self, name: &syn::Ident, item: Item) {
        self.names.items.insert(name.to_string(), item);
    }

    /// Refuses a second item of one name in the reader's files, since modules count for nothing
    /// here. A name of the prelude can be taken.
    fn check_is_new(&self, name: &syn::Ident, file: u16) -> Result<(), Fault> {
        let taken = match self.names.items.get(&name.to_string()) {
            Some(Item::Type(kind)) => *kind >= self.first_kind,
            Some(Item::Function(n)) => *n >= self.first_function,
            _ => false,
        };
        match taken {
            true => Err(twice(name, file)),
            false => Ok(()),
        }
    }

    fn kind(&mut self, name: &syn::Ident, is_enum: bool, file: u16) -> Result<(), Fault> {
        self.check_is_new(name, file)?;
        self.add(name, Item::Type(self.names.kinds.len() as Kind));
        let at = Span::of(file, name);
        let name = name.to_string();
        // The prelude makes values of its own types.
        if file < PRELUDE && ["Vec3", "Point3", "Color", "Ray"].contains(&&*name) {
            return Err(Fault::unread(at, format!("a `{name}` of your own")));
        }
        self.names.kinds.push(KindDef {
            name,
            is_enum,
            ..KindDef::default()
        });
        Ok(())
    }

    fn rename(&mut self, tree: &syn::UseTree) {
        match tree {
            syn::UseTree::Path(it) => self.rename(&it.tree),
            syn::UseTree::Group(it) => it.items.iter().for_each(|it| self.rename(it)),
            syn::UseTree::Rename(it) if it.rename != it.ident => {
                let (new, old) = (it.rename.to_string(), it.ident.to_string());
                self.names.renamed.insert(new, old);
            }
            _ => {}
        }
    }

    fn alias(&mut self, file: u16, item: &syn::Item) -> Result<(), Fault> {
        if let syn::Item::Type(it) = item {
            let scope = Scope::of(file, None, &[&it.generics]);
            let kind = self.names.ty(&it.ty, &scope)?;
            self.add(&it.ident, Item::Type(kind));
        }
        Ok(())
    }

    /// Refuses to read a `use` that lets variants be named without their enum.
    fn check_use(&self, file: u16, tree: &syn::UseTree) -> Result<(), Fault> {
        match tree {
            syn::UseTree::Group(it) => it.items.iter().try_for_each(|it| self.check_use(file, it)),
            syn::UseTree::Path(it) => match self.names.items.get(&it.ident.to_string()) {
                Some(Item::Type(kind)) if self.names.kind(*kind).is_enum => {
                    let at = Span::of(file, &it.ident);
                    Err(Fault::unread(at, "variants without the name of their enum"))
                }
                _ => self.check_use(file, &it.tree),
            },
            _ => Ok(()),
        }
    }

    /// Adds fields, functions and constants.
    fn define(&mut self, file: u16, item: &'t syn::Item) -> Result<(), Fault> {
        let scope = |generics| Scope::of(file, None, &[generics]);
        match item {
            syn::Item::Struct(it) => {
                self.variant(&it.ident, &it.ident, &it.fields, scope(&it.generics))
            }
            syn::Item::Enum(it) => it.variants.iter().try_for_each(|variant| {
                let scope = scope(&it.generics);
                self.variant(&it.ident, &variant.ident, &variant.fields, scope)
            }),
            syn::Item::Use(it) => self.check_use(file, &it.tree),
            syn::Item::Fn(it) => self.function(&it.sig, &it.block, scope(&it.sig.generics)),
            syn::Item::Const(it) => self.constant(&it.ident, &it.ty, &it.expr, scope(&it.generics)),
            syn::Item::Static(it) => {
                let scope = Scope::of(file, None, &[]);
                self.constant(&it.ident, &it.ty, &it.expr, scope)
            }
            syn::Item::Impl(it) => self.members(file, it),
            syn::Item::Trait(it) => it.items.iter().try_for_each(|part| match part {
                syn::TraitItem::Fn(of) if of.default.is_some() => {
                    let at = Span::of(file, &of.sig.ident);
                    Err(Fault::unread(at, "functions that a trait gives to all"))
                }
                _ => Ok(()),
            }),
            _ => Ok(()),
        }
    }

    /// Adds the functions and constants of an `impl` block.
    fn members(&mut self, file: u16, block: &'t syn::ItemImpl) -> Result<(), Fault> {
        let scope = Scope::of(file, None, &[&block.generics]);
        let of_trait = block.trait_.as_ref().and_then(|it| it.0.segments.last());
        let is_own = |name: &&&str| of_trait.is_some_and(|it| it.ident == **name);
        if let Some(name) = IMPLIED.iter().find(is_own).filter(|_| file < PRELUDE) {
            let at = Span::of(file, &block.self_ty);
            return Err(Fault::unread(at, format!("an `impl` of `{name}`")));
        }
        let owner = self.names.ty(&block.self_ty, &scope)?;
        if owner == kind::ANY {
            let at = Span::of(file, &block.self_ty);
            return Err(Fault::unread(at, "an `impl` for any type"));
        }
        let owner = Some(owner);
        block.items.iter().try_for_each(|part| match part {
            syn::ImplItem::Fn(of) => {
                let generics = [&block.generics, &of.sig.generics];
                self.function(&of.sig, &of.block, Scope::of(file, owner, &generics))?;
                // The prelude's operators are called by their signs.
                let signature = self.names.signatures.last_mut();
                let operator = signature.filter(|_| file >= PRELUDE && of_trait.is_some());
                operator.into_iter().for_each(|it| it.is_method = false);
                Ok(())
            }
            syn::ImplItem::Const(of) => {
                let scope = Scope::of(file, owner, &[&block.generics]);
                self.constant(&of.ident, &of.ty, &of.expr, scope)
            }
            _ => Ok(()),
        })
    }

    /// Adds a variant of an enum, or the only one of a struct.
    fn variant(
        &mut self,
        owner: &syn::Ident,
        name: &syn::Ident,
        fields: &syn::Fields,
        mut scope: Scope,
    ) -> Result<(), Fault> {
        let Some(&Item::Type(kind)) = self.names.items.get(&owner.to_string()) else {
            return Ok(());
        };
        scope.owner = Some(kind);
        let mut variant = Variant {
            name: name.to_string(),
            fields: Vec::new(),
        };
        for (n, field) in fields.iter().enumerate() {
            let name = field.ident.as_ref().map(ToString::to_string);
            let kind = self.names.ty(&field.ty, &scope)?;
            variant.fields.push((name.unwrap_or(n.to_string()), kind));
        }
        let variants = &mut self.names.kinds[usize::from(kind)].variants;
        variants.push(variant);
        let shape = Shape::new(kind, variants.len() as u8 - 1);
        // Those of an option need no `Option::`.
        if kind == kind::OPTION {
            self.add(name, Item::Variant(shape));
        }
        Ok(())
    }

    fn function(
        &mut self,
        sig: &'t syn::Signature,
        block: &'t syn::Block,
        scope: Scope,
    ) -> Result<(), Fault> {
        let mut parameters = Vec::new();
        for input in &sig.inputs {
            let (kind, is_lent) = match input {
                syn::FnArg::Receiver(it) => {
                    let is_lent = matches!(it.kind, syn::ReceiverKind::Reference(_, _, Some(_)));
                    (kind::ANY, is_lent)
                }
                syn::FnArg::Typed(it) => (self.names.ty(&it.ty, &scope)?, is_lent(&it.ty)),
            };
            parameters.push(Parameter { kind, is_lent });
        }
        let result = match &sig.output {
            syn::ReturnType::Default => kind::UNIT,
            syn::ReturnType::Type(_, ty) if is_lent(ty) => {
                let at = Span::of(scope.file, ty);
                return Err(Fault::unread(at, "functions that return `&mut`"));
            }
            syn::ReturnType::Type(_, ty) => self.names.ty(ty, &scope)?,
        };
        let signature = Signature {
            parameters,
            result,
            is_method: sig.receiver().is_some(),
            scope,
            ..Signature::default()
        };
        self.declare(&sig.ident, signature, Source::Function(sig, block))
    }

    fn constant(
        &mut self,
        name: &syn::Ident,
        ty: &syn::Type,
        value: &'t syn::Expr,
        scope: Scope,
    ) -> Result<(), Fault> {
        let result = self.names.ty(ty, &scope)?;
        let signature = Signature {
            result,
            scope,
            is_constant: true,
            ..Signature::default()
        };
        self.declare(name, signature, Source::Constant(value))
    }

    fn declare(
        &mut self,
        name: &syn::Ident,
        mut signature: Signature,
        source: Source<'t>,
    ) -> Result<(), Fault> {
        let number = self.names.signatures.len();
        signature.name = name.to_string();
        if let Some(owner) = signature.scope.owner {
            let owner = &mut self.names.kinds[usize::from(owner)];
            let mut own = owner.functions.iter();
            if own.any(|(known, n)| *known == signature.name && *n >= self.first_function) {
                return Err(twice(name, signature.scope.file));
            }
            owner.functions.push((signature.name.clone(), number));
            signature.name = format!("{}::{name}", owner.name);
        } else {
            self.check_is_new(name, signature.scope.file)?;
            self.add(name, Item::Function(number));
        }
        self.names.signatures.push(signature);
        self.sources.push(source);
        Ok(())
    }
}

fn twice(name: &syn::Ident, file: u16) -> Fault {
    let at = Span::of(file, name);
    Fault::unread(at, format!("a second item with the name `{name}`"))
}

/// Returns true for `&mut`.
pub(crate) fn is_lent(ty: &syn::Type) -> bool {
    matches!(ty, syn::Type::Reference(it) if it.mutability.is_some())
}
