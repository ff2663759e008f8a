//! Name resolution: what a path means in a module, and who may see it.

use super::{Meaning, Names, PathError, Signature, TypeScope, module_key, standard};
use crate::types::Ctor;

/// How many imports may lead to each other.
const LONGEST: u32 = 8;

impl Names {
    /// Returns true if a module is the other one, or lies within it.
    fn is_within(&self, module: usize, other: usize) -> bool {
        module == other || module != 0 && self.is_within(self.modules[module].parent, other)
    }

    /// Returns the module around a function's own module; another module as it is.
    fn file_module(&self, module: usize) -> usize {
        match &self.modules[module] {
            it if it.is_block => self.file_module(it.parent),
            _ => module,
        }
    }

    /// Returns true if module `from` may use what `module` declares.
    pub(crate) fn sees(&self, from: usize, module: usize, is_public: bool) -> bool {
        is_public || self.is_within(from, module)
    }

    /// Resolves a path in a module.
    pub(crate) fn found(&self, module: usize, path: &[String]) -> Result<Meaning, PathError> {
        self.resolved(module, path, 0)
    }

    /// Resolves a path in a scope, where `Self` may have a meaning.
    pub(crate) fn meant(&self, context: &TypeScope, path: &[String]) -> Result<Meaning, PathError> {
        match (path, &context.own) {
            ([name], Some(own)) if name == "Self" => Ok(Meaning::Type(own.clone())),
            (path, _) => self.found(context.module, path),
        }
    }

    /// Resolves a path behind `depth` imports.
    fn resolved(&self, from: usize, path: &[String], depth: u32) -> Result<Meaning, PathError> {
        let lost = |part, is_private| PathError { part, is_private };
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
            "crate" => Meaning::Module(0),
            "self" => Meaning::Module(self.file_module(from)),
            "super" => Meaning::Module(self.modules[self.file_module(from)].parent),
            _ => {
                let mut seen = keys(0).into_iter();
                let seen = seen.find_map(|name| self.seen(from, &name, depth));
                seen.ok_or(lost(0, false))?
            }
        };
        for (part, name) in path.iter().enumerate().skip(1) {
            named = match named {
                Meaning::Module(module) => {
                    let [first, second] =
                        keys(part).map(|name| self.member(from, module, &name, depth));
                    let found = first.or_else(|one| second.map_err(|other| one || other));
                    found.map_err(|is_private| lost(part, is_private))?
                }
                Meaning::Prelude => standard::prelude(name).ok_or(lost(part, false))?,
                Meaning::Standard(module) => {
                    standard::within(&module, name).ok_or(lost(part, false))?
                }
                _ => return Err(lost(part, false)),
            };
        }
        Ok(named)
    }

    /// Resolves the first name of a path: among the module's own names, those around a function,
    /// and those that every file knows.
    fn seen(&self, from: usize, name: &str, depth: u32) -> Option<Meaning> {
        let own = self.member(from, from, name, depth).ok();
        let around = || match &self.modules[from] {
            it if it.is_block => self.seen(it.parent, name, depth),
            _ => standard::everywhere(name),
        };
        own.or_else(around)
    }

    /// Resolves a name within a module; the error is true if the name is declared there but
    /// private.
    fn member(&self, from: usize, module: usize, name: &str, depth: u32) -> Result<Meaning, bool> {
        let own = &self.modules[module];
        if let Some(entry) = own.names.get(name) {
            return match &entry.named {
                _ if !self.sees(from, module, entry.is_public) => Err(true),
                Meaning::Import(path) => self
                    .resolved(module, path, depth + 1)
                    .map_err(|it| it.is_private),
                named => Ok(named.clone()),
            };
        }
        let globs = own.globs.iter().filter(|it| self.sees(from, module, it.1));
        let mut found =
            globs.filter_map(|(path, _)| match self.resolved(module, path, depth + 1) {
                Ok(Meaning::Prelude) => standard::prelude(name),
                Ok(Meaning::Standard(module)) => standard::within(&module, name),
                Ok(Meaning::Module(other)) if other != module => {
                    self.member(module, other, name, depth + 1).ok()
                }
                _ => None,
            });
        found.next().ok_or(false)
    }

    /// Returns true if a module knows a trait by its name, so that the trait's methods may be
    /// called there.
    fn has_in_scope(&self, module: usize, of: usize) -> bool {
        let name = &self.traits[of].name;
        matches!(self.seen(module, name, 0), Some(Meaning::Trait(it)) if it == of)
    }

    /// Returns true if a method may be called in a module: it is visible there, or its trait is in
    /// scope.
    pub(crate) fn shows(&self, module: usize, function: usize) -> bool {
        let own = &self.functions[function];
        match own.in_trait {
            Some(of) => self.has_in_scope(module, of),
            None => own.in_standard.is_some() || self.sees(module, own.module, own.is_public),
        }
    }

    /// Returns true if a type has a trait.
    pub(crate) fn implements(&self, ctor: Ctor, of: usize) -> bool {
        let mut types = self.traits[of].implemented_for.iter();
        ctor == Ctor::Dyn(of) || types.any(|it| it.0 == ctor)
    }

    /// Returns the number of the struct of that name.
    pub(crate) fn kind(&self, name: &str) -> Option<u32> {
        let kind = self.structs.iter().position(|it| it.name == name)?;
        Some(kind as u32)
    }

    /// Returns the number of a type's function of that name.
    pub(crate) fn method(&self, ctor: Ctor, name: &str) -> Option<usize> {
        let is_it =
            |it: &Signature| it.name == name && it.of.as_ref().is_some_and(|of| of.0 == ctor);
        self.functions.iter().position(is_it)
    }

    /// Lists the functions of that name in all `impl`s and traits, each with its type.
    pub(crate) fn methods(&self, name: &str) -> impl Iterator<Item = (Ctor, usize)> {
        let all = self.functions.iter().enumerate();
        all.filter_map(move |(n, it)| Some((it.of.as_ref().filter(|_| it.name == name)?.0, n)))
    }
}
