//! Name resolution: what names mean. All files, modules and blocks share one list of names, and of
//! a path the last two names count.

use std::collections::HashMap;
use std::slice;

use crate::fault::{Fault, Span};
use crate::integers;
use crate::natives;
use crate::value::{Kind, Native, Shape, Target, Value, kind};

/// Types of the standard library that are not read here.
pub(crate) const UNREAD: [&str; 13] = [
    "f32", "i128", "u128", "char", "str", "String", "Result", "RefCell", "Cell", "Cow", "HashMap",
    "VecDeque", "Duration",
];

/// The meaning of a path.
#[derive(Clone, Copy)]
pub(crate) enum Item {
    Type(Kind),
    Trait,
    Variant(Shape),
    /// A function or a constant, by its number.
    Function(usize),
    /// `default` of a type whose text has no such function.
    Default(Kind),
    Native(&'static Native),
}

/// A struct, an enum, or a type that is known from the start.
#[derive(Clone, Default)]
pub(crate) struct KindDef {
    pub(crate) name: String,
    pub(crate) is_enum: bool,
    /// The variants of an enum; a struct is the only variant of itself.
    pub(crate) variants: Vec<Variant>,
    /// The functions and constants of its `impl` blocks: names and numbers.
    pub(crate) functions: Vec<(String, usize)>,
}

/// A variant of an enum, or a struct: its name, and the names and types of its fields.
#[derive(Clone)]
pub(crate) struct Variant {
    pub(crate) name: String,
    pub(crate) fields: Vec<(String, Kind)>,
}

impl Variant {
    pub(crate) fn field(&self, name: &str) -> Option<usize> {
        self.fields.iter().position(|it| it.0 == name)
    }
}

/// What is declared of a function, or of a constant.
#[derive(Clone, Default)]
pub(crate) struct Signature {
    /// The name, behind that of the type if it has one: `Sphere::hit`.
    pub(crate) name: String,
    pub(crate) scope: Scope,
    pub(crate) parameters: Vec<Parameter>,
    pub(crate) result: Kind,
    /// True if it can be called behind a point.
    pub(crate) is_method: bool,
    pub(crate) is_constant: bool,
}

/// What is declared of a parameter.
#[derive(Clone, Copy)]
pub(crate) struct Parameter {
    pub(crate) kind: Kind,
    /// True for a `&mut`: what the function makes of it goes back to the caller's place.
    pub(crate) is_lent: bool,
}

/// Where a piece of text stands: in which file, and what `Self` and the generic names mean there.
#[derive(Clone, Default)]
pub(crate) struct Scope {
    pub(crate) file: u16,
    pub(crate) owner: Option<Kind>,
    pub(crate) generics: Vec<String>,
}

impl Scope {
    /// Makes the scope of an item with these generic parameters.
    pub(crate) fn of(file: u16, owner: Option<Kind>, generics: &[&syn::Generics]) -> Self {
        let generics = generics.iter().flat_map(|it| it.type_params());
        let generics = generics.map(|it| it.ident.to_string()).collect();
        Self {
            file,
            owner,
            generics,
        }
    }
}

/// All that is declared.
#[derive(Clone, Default)]
pub(crate) struct Names {
    pub(crate) kinds: Vec<KindDef>,
    pub(crate) items: HashMap<String, Item>,
    /// The names that `use` replaces by others.
    pub(crate) renamed: HashMap<String, String>,
    pub(crate) signatures: Vec<Signature>,
}

impl Names {
    /// Makes the names that are known from the start and that no text declares.
    pub(crate) fn new() -> Self {
        let mut names = Self::default();
        for (kind, name) in (0..kind::VEC3).zip(kind::NAMES) {
            let name = (*name).to_owned();
            names.items.insert(name.clone(), Item::Type(kind));
            names.kinds.push(KindDef {
                name,
                ..KindDef::default()
            });
        }
        for name in ["Rc", "Arc"] {
            names.items.insert(name.to_owned(), Item::Type(kind::BOX));
        }
        names
    }

    /// Returns what a path means: by its last name, or by the last two if the first of these is a
    /// type. Names of modules say nothing here.
    pub(crate) fn find(&self, path: &[String], scope: &Scope) -> Option<Item> {
        let (last, before) = path.split_last()?;
        let own = scope.owner.filter(|_| last == "Self").map(Item::Type);
        if let [.., owner] = before
            && let Some(Item::Type(kind)) = self.find(slice::from_ref(owner), scope)
        {
            return self.associated(kind, last);
        }
        own.or_else(|| self.items.get(last).copied())
            .or_else(|| self.find(slice::from_ref(self.renamed.get(last)?), &Scope::default()))
            .or_else(|| self.associated(kind::CONSTS, last))
    }

    /// Returns the function, the constant or the variant of that name which belongs to a type.
    pub(crate) fn associated(&self, kind: Kind, name: &str) -> Option<Item> {
        let def = self.kinds.get(usize::from(kind))?;
        if let Some((_, number)) = def.functions.iter().find(|it| it.0 == name) {
            return Some(Item::Function(*number));
        }
        let variant = def.variants.iter().position(|it| it.name == name);
        if let Some(variant) = variant.filter(|_| def.is_enum) {
            return Some(Item::Variant(Shape::new(kind, variant as u8)));
        }
        if name == "default" && self.default_of(kind).is_some() {
            return Some(Item::Default(kind));
        }
        let native = natives::named(name).find(|it| it.of == kind);
        if native.is_none() && integers::is_integer(kind) && kind != kind::INT {
            return self.associated(kind::INT, name);
        }
        native.map(Item::Native)
    }

    pub(crate) fn kind(&self, kind: Kind) -> &KindDef {
        &self.kinds[usize::from(kind)]
    }

    pub(crate) fn variant(&self, shape: Shape) -> &Variant {
        &self.kind(shape.kind).variants[usize::from(shape.variant)]
    }

    /// Lists the functions with that name which take `self`, each with its type.
    pub(crate) fn methods(&self, name: &str) -> Vec<(Kind, usize)> {
        let all = (0..).zip(&self.kinds);
        let all = all.flat_map(|(kind, def)| def.functions.iter().map(move |it| (kind, it)));
        let own = all.filter(|(_, it)| it.0 == name && self.signatures[it.1].is_method);
        own.map(|(kind, it)| (kind, it.1)).collect()
    }

    /// Lists all names of functions that belong to types.
    pub(crate) fn functions_of_types(&self) -> impl Iterator<Item = &str> {
        let own = self.kinds.iter().flat_map(|def| &def.functions);
        let own = own.map(|(name, _)| name.as_str());
        own.chain(natives::all().map(|it| it.name))
    }

    /// Lists the names of all fields.
    pub(crate) fn fields(&self) -> impl Iterator<Item = &str> {
        let variants = self.kinds.iter().flat_map(|def| &def.variants);
        variants.flat_map(|it| &it.fields).map(|it| it.0.as_str())
    }

    /// Returns true if what a function makes of its parameter `n` goes back to the caller.
    pub(crate) fn changes(&self, target: Target, n: usize) -> bool {
        match target {
            Target::Own(of) => {
                let parameter = self.signatures[of].parameters.get(n);
                parameter.is_some_and(|parameter| parameter.is_lent)
            }
            Target::Native(native) => n < native.changes,
            Target::Variant(_) | Target::Default(_) => false,
        }
    }

    /// Returns how many arguments a function takes.
    pub(crate) fn takes(&self, target: Target) -> usize {
        match target {
            Target::Own(n) => self.signatures[n].parameters.len(),
            Target::Native(native) => native.takes,
            Target::Variant(shape) => self.variant(shape).fields.len(),
            Target::Default(_) => 0,
        }
    }

    /// Returns the kind of a type.
    ///
    /// # Errors
    /// If it has a name that is not known or not read.
    pub(crate) fn ty(&self, ty: &syn::Type, scope: &Scope) -> Result<Kind, Fault> {
        match ty {
            syn::Type::Reference(it) => self.ty(&it.elem, scope),
            syn::Type::Paren(it) => self.ty(&it.elem, scope),
            syn::Type::Group(it) => self.ty(&it.elem, scope),
            syn::Type::Array(it) => self.ty(&it.elem, scope).map(|_| kind::LIST),
            syn::Type::Slice(it) => self.ty(&it.elem, scope).map(|_| kind::LIST),
            syn::Type::Tuple(it) if it.elems.is_empty() => Ok(kind::UNIT),
            syn::Type::Tuple(it) => {
                let mut all = it.elems.iter();
                all.try_for_each(|part| self.ty(part, scope).map(drop))?;
                Ok(kind::TUPLE)
            }
            syn::Type::Path(it) => self.path_type(&it.path, scope),
            _ => Ok(kind::ANY),
        }
    }

    fn path_type(&self, path: &syn::Path, scope: &Scope) -> Result<Kind, Fault> {
        let names = path_names(path);
        let (at, last) = (Span::of(scope.file, path), &names[names.len() - 1]);
        let is_generic = |name: &String| scope.generics.contains(name);
        if is_generic(&names[0]) || names.len() > 1 && names[0] == "Self" {
            return Ok(kind::ANY);
        }
        let arguments = match &path.segments[names.len() - 1].arguments {
            syn::PathArguments::AngleBracketed(all) => self.arguments(all, scope)?,
            _ => Vec::new(),
        };
        match self.find(&names, scope) {
            Some(Item::Type(kind::BOX)) => Ok(arguments.first().copied().unwrap_or(kind::ANY)),
            Some(Item::Type(kind)) => Ok(kind),
            Some(Item::Trait) => {
                let message = format!("`{last}` is a trait: write `&dyn {last}`");
                Err(Fault::refused(at, message))
            }
            _ if UNREAD.contains(&last.as_str()) => Err(Fault::unread(at, format!("`{last}`"))),
            _ => {
                let known = self.items.iter().filter(|it| matches!(it.1, Item::Type(_)));
                let known = known.map(|(name, _)| name.as_str());
                Err(Fault::refused(at, format!("there is no type `{last}`")).or_meant(last, known))
            }
        }
    }

    /// Returns the kinds of the types between `<` and `>`.
    ///
    /// # Errors
    /// If one has a name that is not known or not read.
    pub(crate) fn arguments(
        &self,
        all: &syn::AngleBracketedGenericArguments,
        scope: &Scope,
    ) -> Result<Vec<Kind>, Fault> {
        let types = all.args.iter().filter_map(|argument| match argument {
            syn::GenericArgument::Type(ty) => Some(ty),
            _ => None,
        });
        types.map(|ty| self.ty(ty, scope)).collect()
    }

    /// Returns the value that a derived `default()` has of a type; `None` if it has none, or if a
    /// text computes it.
    pub(crate) fn default_of(&self, kind: Kind) -> Option<Value> {
        Some(match kind {
            _ if integers::is_integer(kind) => Value::Int(0, kind),
            kind::FLOAT => Value::Float(0.0),
            kind::BOOL => Value::Bool(false),
            kind::LIST => Value::list([]),
            kind::OPTION => None.into(),
            _ => {
                let def = self.kinds.get(usize::from(kind)).filter(|it| !it.is_enum)?;
                if def.functions.iter().any(|it| it.0 == "default") {
                    return None;
                }
                let fields = def.variants.first()?.fields.iter();
                let fields = fields
                    .map(|it| self.default_of(it.1))
                    .collect::<Option<Vec<_>>>()?;
                Value::data(Shape::new(kind, 0), fields)
            }
        })
    }

    /// Names a type for a message.
    pub(crate) fn shown(&self, kind: Kind) -> &str {
        match kind {
            kind::VEC3 => "Vec3",
            kind::ANY => "_",
            _ => &self.kind(kind).name,
        }
    }
}

/// Returns the names of a path.
pub(crate) fn path_names(path: &syn::Path) -> Vec<String> {
    path.segments
        .iter()
        .map(|it| it.ident.to_string())
        .collect()
}
