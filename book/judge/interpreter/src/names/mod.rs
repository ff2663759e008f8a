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

/// The result of a pass over names and types, or the fault that it finds.
pub(crate) type Resolved<T = ()> = Result<T, Refusal>;

/// All that the files declare.
#[derive(Debug, Default)]
pub(crate) struct Names {
    pub(crate) modules: Vec<Module>,
    pub(crate) structs: Vec<StructDef>,
    pub(crate) traits: Vec<TraitDef>,
    pub(crate) functions: Vec<Signature>,
    /// The reader's functions for operators: those that change their left side, too.
    pub(crate) operators: Vec<(ArithOp, bool, usize)>,
    pub(crate) negations: Vec<usize>,
    /// The reader's own structs of rays and vectors, if they are not ours.
    pub(crate) own_ray: Option<u32>,
    pub(crate) own_vec3: Option<u32>,
}

/// A file, a part of one in brackets, or a function that declares something.
#[derive(Debug, Default)]
pub(crate) struct Module {
    name: String,
    pub(crate) file: u32,
    parent: usize,
    /// True for a function, which sees all that is around it.
    is_block: bool,
    names: HashMap<String, Entry>,
    /// The modules that it imports by a `*`, and whether others see that: names of its own go
    /// before these.
    globs: Vec<(Vec<String>, bool)>,
}

#[derive(Clone, Debug)]
struct Entry {
    named: Meaning,
    is_public: bool,
}

/// A meaning of a name.
#[derive(Clone, Debug)]
pub(crate) enum Meaning {
    Module(usize),
    /// The module that our chapters import.
    Prelude,
    Type(Type),
    Trait(usize),
    /// A function, or a constant, which is a function without parameters.
    Function(usize),
    /// A type of the library that takes others.
    Generic(Ctor),
    /// A function of the library, by its name.
    Library(&'static str),
    /// A constant of the library.
    Number(f64),
    /// Something else of the standard library, by its name.
    Standard(String),
    /// Whatever that path leads to.
    Import(Vec<String>),
}

/// The number of the part of a path that was not found, which may be there but private.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PathError {
    part: usize,
    is_private: bool,
}

/// A struct of the reader's.
#[derive(Debug)]
pub(crate) struct StructDef {
    pub(crate) name: String,
    pub(crate) module: usize,
    pub(crate) fields: Vec<FieldDef>,
    pub(crate) derives: Vec<String>,
    /// True if its fields have numbers, or there are none: its name is a value.
    pub(crate) is_tuple: bool,
    pub(crate) at: Span,
    /// The reader's own `default`.
    pub(crate) default: Option<usize>,
}

impl StructDef {
    pub(crate) fn field(&self, name: &str) -> Option<usize> {
        self.fields.iter().position(|it| it.name == name)
    }

    pub(crate) fn derives(&self, name: &str) -> bool {
        self.derives.iter().any(|it| it == name)
    }
}

#[derive(Debug)]
pub(crate) struct FieldDef {
    pub(crate) name: String,
    pub(crate) ty: Type,
    pub(crate) is_public: bool,
}

#[derive(Debug, Default)]
pub(crate) struct TraitDef {
    pub(crate) name: String,
    /// The functions that an implementation has.
    pub(crate) methods: Vec<usize>,
    pub(crate) implemented_for: Vec<Type>,
}

/// The declaration of a function: its parameters, its result, and whose it is.
#[derive(Clone, Debug, Default)]
pub(crate) struct Signature {
    pub(crate) name: String,
    pub(crate) module: usize,
    /// The module in which its body looks names up: itself, if it declares something.
    pub(crate) inside: usize,
    pub(crate) at: Span,
    pub(crate) is_public: bool,
    pub(crate) parameters: Vec<Type>,
    /// True if the first is `self`.
    pub(crate) has_self: bool,
    pub(crate) result: Type,
    /// Whose function it is, if it is in an `impl`.
    pub(crate) of: Option<Type>,
    /// In which trait of the reader's it is, or in which of the standard library.
    pub(crate) in_trait: Option<usize>,
    pub(crate) in_standard: Option<String>,
    pub(crate) is_constant: bool,
}

/// The surroundings in which a type is read: its module, `Self` and type parameters.
#[derive(Clone, Default)]
pub(crate) struct TypeScope {
    pub(crate) module: usize,
    pub(crate) own: Option<Type>,
    pub(crate) parameters: HashMap<String, Type>,
}

impl TypeScope {
    pub(crate) fn of(module: usize) -> Self {
        Self {
            module,
            ..Self::default()
        }
    }
}

/// Returns by what a module is kept among names.
fn module_key(name: &str) -> String {
    format!("{name}::")
}

/// Returns the names in a path, one after the other.
pub(crate) fn names(path: &syn::Path) -> Vec<String> {
    let segments = path.segments.iter();
    segments.map(|it| it.ident.to_string()).collect()
}
