//! A symbol table: modules, what they declare and import, and who may see it.

mod check;
pub(crate) mod collect;
mod declare;
mod resolve;
pub(crate) mod standard;
mod types;
pub(crate) mod words;

use std::collections::HashMap;

use crate::operators::ArithOp;
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

/// The result of a pass over declarations.
pub(crate) type Resolved<T = ()> = Result<T, Refusal>;

/// All that the files declare. Modules, structs, traits and functions are meant by their numbers in
/// these lists.
#[derive(Debug, Default)]
pub(crate) struct Names {
    pub(crate) modules: Vec<Module>,
    pub(crate) structs: Vec<StructDef>,
    pub(crate) traits: Vec<TraitDef>,
    pub(crate) functions: Vec<Signature>,
    /// The text's functions for operators: the operator, true for an assignment such as `+=`, and
    /// the function's number.
    pub(crate) operators: Vec<(ArithOp, bool, usize)>,
    /// The numbers of the text's functions for `-` before a value.
    pub(crate) negations: Vec<usize>,
    /// The number of the text's own struct for rays, if it has one; rays are then not those of
    /// `common`.
    pub(crate) own_ray: Option<u32>,
    /// The number of the text's own struct for vectors, if it has one.
    pub(crate) own_vec3: Option<u32>,
}

/// A file, a `mod` in braces, or a function that declares items.
#[derive(Debug, Default)]
pub(crate) struct Module {
    name: String,
    /// The number of the file.
    pub(crate) file: u32,
    /// The number of the module around it; 0 for the root.
    parent: usize,
    /// True for a function, which sees all names around it.
    is_block: bool,
    /// The declared names; those of modules have `::` behind them, since another item may be called
    /// so, too.
    names: HashMap<String, Entry>,
    /// The path of each module that is imported by a `*`, and true if the import is public.
    /// Declared names have precedence.
    globs: Vec<(Vec<String>, bool)>,
}

/// The meaning of a declared name, and its visibility.
#[derive(Clone, Debug)]
struct Entry {
    named: Meaning,
    is_public: bool,
}

/// A meaning of a path or name.
#[derive(Clone, Debug)]
pub(crate) enum Meaning {
    /// A module, by its number.
    Module(usize),
    /// The module `common::rtweekend`.
    Prelude,
    Type(Type),
    /// A trait of the text, by its number.
    Trait(usize),
    /// A function of the text by its number, or a constant, which counts as a function without
    /// parameters.
    Function(usize),
    /// A library type with one parameter, as `Vec`.
    Generic(Ctor),
    /// A function of `common`, by its name.
    Library(&'static str),
    /// A constant of the library, by its value.
    Number(f64),
    /// Anything else of the standard library, by its name: known, but not to be used.
    Standard(String),
    /// An import, by its path.
    Import(Vec<String>),
}

/// The reason why a path leads nowhere: the number of its first part without a meaning, and true if
/// that part exists but is private.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PathError {
    part: usize,
    is_private: bool,
}

/// A struct of the text.
#[derive(Debug)]
pub(crate) struct StructDef {
    pub(crate) name: String,
    /// The number of the module in which it is declared.
    pub(crate) module: usize,
    pub(crate) fields: Vec<FieldDef>,
    /// The traits in its `#[derive(…)]`.
    pub(crate) derives: Vec<String>,
    /// True for a tuple struct or unit struct, whose name is a value.
    pub(crate) is_tuple: bool,
    pub(crate) at: Span,
    /// The number of its own function `default`.
    pub(crate) default: Option<usize>,
}

impl StructDef {
    /// Returns the number of the field of that name.
    pub(crate) fn field(&self, name: &str) -> Option<usize> {
        self.fields.iter().position(|it| it.name == name)
    }

    /// Returns true if the struct derives the trait of that name.
    pub(crate) fn derives(&self, name: &str) -> bool {
        self.derives.iter().any(|it| it == name)
    }
}

/// A field of a struct.
#[derive(Debug)]
pub(crate) struct FieldDef {
    pub(crate) name: String,
    pub(crate) ty: Type,
    pub(crate) is_public: bool,
}

/// A trait of the text.
#[derive(Debug, Default)]
pub(crate) struct TraitDef {
    pub(crate) name: String,
    /// The numbers of the methods that it declares.
    pub(crate) methods: Vec<usize>,
    /// The types that have it.
    pub(crate) implemented_for: Vec<Type>,
}

/// The declaration of a function or a constant.
#[derive(Clone, Debug, Default)]
pub(crate) struct Signature {
    pub(crate) name: String,
    pub(crate) module: usize,
    /// The number of the module in which its body resolves names: the one that it forms, if it
    /// declares items.
    pub(crate) inside: usize,
    pub(crate) at: Span,
    pub(crate) is_public: bool,
    pub(crate) parameters: Vec<Type>,
    /// True if the first parameter is `self`.
    pub(crate) has_self: bool,
    pub(crate) result: Type,
    /// The type of the `impl` or trait in which it stands.
    pub(crate) of: Option<Type>,
    /// The number of the text's trait that its `impl` implements.
    pub(crate) in_trait: Option<usize>,
    /// The name of the standard library's trait that its `impl` implements.
    pub(crate) in_standard: Option<String>,
    /// True for a constant, which counts as a function without parameters.
    pub(crate) is_constant: bool,
}

/// The surroundings in which a type is resolved.
#[derive(Clone, Default)]
pub(crate) struct TypeScope {
    pub(crate) module: usize,
    /// The meaning of `Self`.
    pub(crate) own: Option<Type>,
    /// The meanings of type parameters, and of `Self::Output` and the like.
    pub(crate) parameters: HashMap<String, Type>,
}

impl TypeScope {
    /// Returns the scope of a module, without `Self`.
    pub(crate) fn of(module: usize) -> Self {
        Self {
            module,
            ..Self::default()
        }
    }
}

/// Returns the key under which a module is kept among declared names.
fn module_key(name: &str) -> String {
    format!("{name}::")
}

/// Returns the parts of a path.
pub(crate) fn names(path: &syn::Path) -> Vec<String> {
    let segments = path.segments.iter();
    segments.map(|it| it.ident.to_string()).collect()
}
