//! Name resolution: modules, what they declare and import, who may see it, and which types
//! the signatures name.

mod collect;
mod standard;

use std::collections::HashMap;

use strsim::levenshtein;

pub(crate) use collect::{Inside, collect};

use crate::node::At;
use crate::prelude::{self, NATIVES, Native};
use crate::read::Refusal;
use crate::types::{Head, Type};

/// All that the files declare.
#[derive(Debug, Default)]
pub(crate) struct Names {
    pub(crate) modules: Vec<Module>,
    pub(crate) kinds: Vec<Kind>,
    pub(crate) traits: Vec<Trait>,
    pub(crate) functions: Vec<Signature>,
}

/// A file, or a part of one in brackets.
#[derive(Debug, Default)]
pub(crate) struct Module {
    name: String,
    pub(crate) file: u32,
    parent: usize,
    names: HashMap<String, Entry>,
    /// What it imports by a `*`: names of its own go before these.
    globs: Vec<(Vec<String>, bool)>,
}

#[derive(Clone, Debug)]
struct Entry {
    named: Named,
    is_public: bool,
}

/// What a name can be.
#[derive(Clone, Debug)]
pub(crate) enum Named {
    Module(usize),
    /// What our chapters import.
    Prelude,
    Type(Type),
    Trait(usize),
    /// A function, or a constant, which is a function without parameters.
    Function(usize),
    /// A type of the library that takes others.
    Generic(Head),
    /// A function of the library, by its name.
    Library(&'static str),
    /// A constant of the library.
    Number(f64),
    /// Something else of the standard library, by its name.
    Standard(String),
    /// Whatever that path leads to.
    Import(Vec<String>),
}

/// Which part of a path was not found, and whether it is there but private.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lost {
    part: usize,
    is_private: bool,
}

/// A struct of the reader's.
#[derive(Debug)]
pub(crate) struct Kind {
    pub(crate) name: String,
    pub(crate) module: usize,
    pub(crate) fields: Vec<Field>,
    pub(crate) derives: Vec<String>,
}

impl Kind {
    /// The names of its fields, and their types.
    pub(crate) fn known(&self) -> Vec<(&str, Type)> {
        let fields = self.fields.iter();
        fields.map(|it| (it.name.as_str(), it.ty.clone())).collect()
    }
}

#[derive(Debug)]
pub(crate) struct Field {
    pub(crate) name: String,
    pub(crate) ty: Type,
    pub(crate) is_public: bool,
}

#[derive(Debug)]
pub(crate) struct Trait {
    pub(crate) name: String,
    /// The functions that an implementation has.
    pub(crate) methods: Vec<usize>,
    pub(crate) implemented_for: Vec<Type>,
}

/// The parameters and the result of a function.
#[derive(Clone, Debug, Default)]
pub(crate) struct Signature {
    pub(crate) name: String,
    pub(crate) module: usize,
    pub(crate) at: At,
    pub(crate) is_public: bool,
    pub(crate) parameters: Vec<Type>,
    /// Whether the first is `self`.
    pub(crate) has_self: bool,
    pub(crate) result: Type,
    /// Whose function it is, if it is in an `impl`.
    pub(crate) of: Option<Type>,
    /// In which trait of the reader's it is, or in which of the standard library.
    pub(crate) in_trait: Option<usize>,
    pub(crate) in_standard: Option<String>,
    pub(crate) is_constant: bool,
}

/// What a type is read with.
#[derive(Clone, Default)]
pub(crate) struct Context {
    pub(crate) module: usize,
    pub(crate) own: Option<Type>,
    pub(crate) parameters: HashMap<String, Type>,
}

/// What is called.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Callee {
    Own(usize),
    /// By the trait of the receiver.
    Dynamic(usize),
    Native(&'static Native),
}

/// So many imports may follow each other.
const LONGEST: u32 = 8;

impl Names {
    pub(crate) fn file(&self, module: usize) -> u32 {
        self.modules[module].file
    }

    /// Whether a module is another one or is in it.
    fn is_within(&self, module: usize, other: usize) -> bool {
        module == other || module != 0 && self.is_within(self.modules[module].parent, other)
    }

    /// Whether what a module declares may be used in another.
    pub(crate) fn sees(&self, from: usize, module: usize, is_public: bool) -> bool {
        is_public || self.is_within(from, module)
    }

    /// What a path means in the module.
    pub(crate) fn found(&self, module: usize, path: &[String]) -> Result<Named, Lost> {
        self.resolved(module, path, 0)
    }

    fn resolved(&self, from: usize, path: &[String], depth: u32) -> Result<Named, Lost> {
        let lost = |part, is_private| Lost { part, is_private };
        if depth > LONGEST {
            return Err(lost(0, false));
        }
        if let Some(named) = standard::by_path(path) {
            return Ok(named);
        }
        // A module and something else may have one name: which is meant, its place says.
        let keys = |part: usize| {
            if part + 1 < path.len() {
                [module_key(&path[part]), path[part].clone()]
            } else {
                [path[part].clone(), module_key(&path[part])]
            }
        };
        let mut named = match path[0].as_str() {
            "crate" => Named::Module(0),
            "self" => Named::Module(from),
            "super" => Named::Module(self.modules[from].parent),
            _ => {
                let mut seen = keys(0).into_iter();
                let seen = seen.find_map(|name| self.seen(from, &name, depth));
                seen.ok_or(lost(0, false))?
            }
        };
        for (part, name) in path.iter().enumerate().skip(1) {
            named = match named {
                Named::Module(module) => {
                    let [first, second] =
                        keys(part).map(|name| self.member(from, module, &name, depth));
                    let found = first.or_else(|one| second.map_err(|other| one || other));
                    found.map_err(|is_private| lost(part, is_private))?
                }
                Named::Prelude => standard::prelude(name).ok_or(lost(part, false))?,
                Named::Standard(module) => {
                    standard::within(&module, name).ok_or(lost(part, false))?
                }
                _ => return Err(lost(part, false)),
            };
        }
        Ok(named)
    }

    /// What a single name means, where nothing says where it is from.
    fn seen(&self, from: usize, name: &str, depth: u32) -> Option<Named> {
        let own = self.member(from, from, name, depth);
        own.ok().or_else(|| standard::everywhere(name))
    }

    /// What a module has by that name; if nothing, whether it is there and private.
    fn member(&self, from: usize, module: usize, name: &str, depth: u32) -> Result<Named, bool> {
        let own = &self.modules[module];
        if let Some(entry) = own.names.get(name) {
            return match &entry.named {
                _ if !self.sees(from, module, entry.is_public) => Err(true),
                Named::Import(path) => self
                    .resolved(module, path, depth + 1)
                    .map_err(|it| it.is_private),
                named => Ok(named.clone()),
            };
        }
        let globs = own.globs.iter().filter(|it| self.sees(from, module, it.1));
        let mut found =
            globs.filter_map(|(path, _)| match self.resolved(module, path, depth + 1) {
                Ok(Named::Prelude) => standard::prelude(name),
                Ok(Named::Standard(module)) => standard::within(&module, name),
                Ok(Named::Module(other)) if other != module => {
                    self.member(module, other, name, depth + 1).ok()
                }
                _ => None,
            });
        found.next().ok_or(false)
    }

    /// Whether methods of the trait may be called in the module: it has it by its name.
    fn has_in_scope(&self, module: usize, of: usize) -> bool {
        let name = &self.traits[of].name;
        matches!(self.seen(module, name, 0), Some(Named::Trait(it)) if it == of)
    }

    /// Says what is wrong with a path in a `use`.
    fn unresolved(&self, at: At, path: &[String], lost: Lost) -> Refusal {
        let part = &path[lost.part];
        if lost.is_private {
            return private("item", part, at);
        }
        let message = format!("unresolved import `{}`", path[..=lost.part].join("::"));
        let label = match path[..lost.part].join("::").as_str() {
            "" | "crate" => format!("could not find `{part}` in the crate root"),
            module => format!("no `{part}` in `{module}`"),
        };
        let help = if lost.part + 1 < path.len() {
            format!("`mod {part};` in `src/lib.rs` declares the file `src/{part}.rs`")
        } else {
            String::new()
        };
        Refusal::new(at, &message, &label, &help)
    }

    /// Says that there is no such name, and which one was meant.
    pub(crate) fn not_found(
        &self,
        module: usize,
        at: At,
        what: &str,
        path: &[String],
        lost: Lost,
    ) -> Refusal {
        let name = &path[lost.part];
        if lost.is_private {
            return private(what, name, at);
        }
        let message = if lost.part + 1 < path.len() {
            format!("cannot find module or crate `{name}` in this scope")
        } else {
            format!("cannot find {what} `{name}` in this scope")
        };
        let mut elsewhere = self.modules.iter().filter(|it| !it.name.is_empty());
        let help = if standard::prelude(name).is_some() {
            "`use common::rtweekend::*;` is missing".to_owned()
        } else if let Some(other) = elsewhere.find(|it| it.names.contains_key(name)) {
            format!("`use crate::{}::{name};` is missing", other.name)
        } else {
            let own = self.modules[module].names.keys().map(String::as_str);
            there_is(name, own.chain(standard::PRELUDE.map(|it| it.0)))
        };
        Refusal::new(at, &message, "not found in this scope", &help)
    }

    /// Whether a value of that type has the trait.
    pub(crate) fn implements(&self, ty: &Type, of: usize) -> bool {
        match ty.0 {
            Head::Unknown | Head::Never => true,
            Head::Dyn(own) => own == of,
            _ => self.traits[of].implemented_for.contains(ty),
        }
    }

    /// The function of that name in an `impl` for the type, of that trait if one is named.
    pub(crate) fn method(&self, ty: &Type, name: &str, of_trait: Option<usize>) -> Option<usize> {
        let is_it = |it: &Signature| {
            it.name == name
                && it.of.as_ref() == Some(ty)
                && (of_trait.is_none() || it.in_trait == of_trait)
        };
        self.functions.iter().position(is_it)
    }

    pub(crate) fn method_of(&self, of: &Trait, name: &str) -> Option<usize> {
        let mut methods = of.methods.iter().copied();
        methods.find(|&it| self.functions[it].name == name)
    }

    /// The function of that name that the type has, the reader's before those of the library.
    pub(crate) fn callee(&self, ty: &Type, name: &str) -> Option<Callee> {
        if let Head::Dyn(of) = ty.0 {
            return self.method_of(&self.traits[of], name).map(Callee::Dynamic);
        }
        if let Some(own) = self.method(ty, name, None) {
            return Some(Callee::Own(own));
        }
        let has = match ty.0 {
            Head::Own(_) => name == "clone" && self.derives(ty, "Clone"),
            _ => true,
        };
        let mut owners = prelude::owners(ty).iter().filter(|_| has);
        owners
            .find_map(|owner| prelude::native(owner, name))
            .map(Callee::Native)
    }

    /// Whether the compiler writes that trait for the type, or the reader has.
    pub(crate) fn derives(&self, ty: &Type, name: &str) -> bool {
        let derived = match ty.0 {
            Head::Own(kind) => self.kinds[kind].derives.iter().any(|it| it == name),
            _ => false,
        };
        derived
            || self
                .functions
                .iter()
                .any(|it| it.of.as_ref() == Some(ty) && it.in_standard.as_deref() == Some(name))
    }

    /// Why a method may not be called here: it is private, or its trait is not imported.
    pub(crate) fn hidden(&self, module: usize, function: usize, at: At) -> Option<Refusal> {
        let own = &self.functions[function];
        let (name, of) = (&own.name, own.of.as_ref());
        if own.in_trait.is_none()
            && own.in_standard.is_none()
            && !self.sees(module, own.module, own.is_public)
        {
            let what = if own.has_self {
                "method"
            } else {
                "associated function"
            };
            return Some(private(what, name, at));
        }
        let of_trait = own.in_trait.filter(|&it| !self.has_in_scope(module, it))?;
        let on = of.map_or(String::new(), |it| format!(" for `{}`", it.name(self)));
        let message = format!("no method named `{name}` found{on} in the current scope");
        let trait_name = &self.traits[of_trait].name;
        let help = format!(
            "items from traits can only be used if the trait is in scope: `use` the trait `{trait_name}`"
        );
        Some(Refusal::new(at, &message, "", &help))
    }

    /// Says that a value has no such method, or that it is not known here, and which was meant.
    pub(crate) fn no_method(&self, ty: &Type, name: &str, at: At) -> Refusal {
        let last = ty.stripped();
        let own = self
            .functions
            .iter()
            .filter(|it| it.of.as_ref() == Some(last));
        let owners = prelude::owners(last);
        let natives = NATIVES.iter().filter(|it| owners.contains(&it.owner));
        let known = own
            .map(|it| it.name.as_str())
            .chain(natives.map(|it| it.signature.name.as_str()));
        let help = if self.fields_of(last).iter().any(|it| it.0 == name) {
            format!("`{name}` is a field: without `()`")
        } else {
            there_is(name, known)
        };
        let message = format!(
            "no method named `{name}` found for `{}` in the current scope",
            ty.name(self)
        );
        if !help.is_empty() && !help.starts_with("there") {
            return Refusal::new(at, &message, "", &help);
        }
        self.lacks(last, name, &message, &help, at)
    }

    /// That a type has nothing of that name. The standard library and glam have more than is
    /// known here: only of the chapters' own types and the reader's everything is known.
    pub(crate) fn lacks(
        &self,
        ty: &Type,
        name: &str,
        message: &str,
        help: &str,
        at: At,
    ) -> Refusal {
        let is_ours = matches!(
            ty.0,
            Head::Own(_) | Head::Dyn(_) | Head::Ray | Head::Picture
        );
        if is_ours {
            return Refusal::new(at, message, "", help);
        }
        let what = match ty.0 {
            Head::Unknown => format!("`{name}`"),
            _ => format!("`{name}` of `{}`", ty.name(self)),
        };
        Refusal::unknown(at, &what).or_help(help)
    }

    /// The number of a field and its type; or what is wrong with asking for it.
    pub(crate) fn field(
        &self,
        ty: &Type,
        name: &str,
        module: usize,
        at: At,
    ) -> Result<(usize, Type), Refusal> {
        let on = ty.stripped();
        let known = self.fields_of(on);
        let Some(n) = known.iter().position(|it| it.0 == name) else {
            let help = match self.callee(on, name) {
                Some(_) => format!("`{name}` is a method: `.{name}(…)`"),
                None => there_is(name, known.iter().map(|it| it.0)),
            };
            let message = format!("no field `{name}` on type `{}`", ty.name(self));
            return Err(Refusal::new(at, &message, "unknown field", &help));
        };
        if let Head::Own(kind) = on.0 {
            let own = &self.kinds[kind];
            if !self.sees(module, own.module, own.fields[n].is_public) {
                let message = format!("field `{name}` of struct `{}` is private", own.name);
                let help = "`pub` before it shows it to other files";
                return Err(Refusal::new(at, &message, "private field", help));
            }
        }
        Ok((n, known[n].1.clone()))
    }

    /// The names and the types of what a value has.
    pub(crate) fn fields_of(&self, ty: &Type) -> Vec<(&str, Type)> {
        const NUMBERS: [&str; 8] = ["0", "1", "2", "3", "4", "5", "6", "7"];
        match ty.0 {
            Head::Own(kind) => self.kinds[kind].known(),
            Head::Tuple => NUMBERS.into_iter().zip(ty.1.iter().cloned()).collect(),
            head => prelude::fields(head).collect(),
        }
    }
}

/// That something is there, but not to be used here.
fn private(what: &str, name: &str, at: At) -> Refusal {
    let message = format!("{what} `{name}` is private");
    let help = "`pub` before it shows it to other files";
    Refusal::new(at, &message, &format!("private {what}"), help)
}

/// Which name was meant, if one is like it.
pub(crate) fn there_is<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> String {
    similar(name, among).map_or(String::new(), |it| format!("there is `{it}`"))
}

/// The name that is most like this one, if one is.
fn similar<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let near = |other: &&str| {
        let distance = levenshtein(name, other);
        let is_part = name.starts_with(other) || other.starts_with(name);
        distance * 3 <= name.len().max(3) || is_part && name.len().min(other.len()) > 2
    };
    among
        .filter(near)
        .min_by_key(|other| (levenshtein(name, other), *other))
}

/// By what a module is kept among names.
fn module_key(name: &str) -> String {
    format!("{name}::")
}

/// The names in a path, one after the other.
pub(crate) fn names(path: &syn::Path) -> Vec<String> {
    path.segments
        .iter()
        .map(|it| it.ident.to_string())
        .collect()
}
