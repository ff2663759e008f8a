//! Paths: a name that is a variable, a constant or a function, and whose it is.

use std::sync::Arc;

use super::{Lowered, Lowerer};
use crate::library;
use crate::names::words::{private, there_is};
use crate::names::{Named, names};
use crate::node::{Closure, Node};
use crate::refusal::{At, Refusal};
use crate::types::{Head, Owners, Type};

/// What is called by its path.
pub(super) enum Callee {
    Own(usize),
    Native(usize),
    /// A method of a trait.
    OfTrait,
    /// What a derive or the library has by default.
    Default(Type),
    /// A struct whose fields have numbers.
    Struct(u32),
}

impl Lowerer<'_> {
    /// A name that is a value: a variable, a constant, a function.
    pub(super) fn path(&mut self, it: &syn::ExprPath) -> Lowered {
        let path = names(&it.path);
        if let [name] = path.as_slice()
            && let Some(local) = self.variable(name)
        {
            return Ok(Node::Local(local.slot));
        }
        if path.last().is_some_and(|it| it == "None") {
            return Ok(Node::None);
        }
        let at = self.at_any(it);
        if let Ok(Named::Number(number)) = self.names.found(self.context.module, &path) {
            return Ok(Node::Float(number));
        }
        let (owner, name) = self.owner(&path, at)?;
        if let Some(owner) = &owner
            && self.names.method(owner.0, &name).is_none()
            && let Some(constant) = library::constant(owner.0, &name)
        {
            return Ok(constant);
        }
        match self.callee(owner.as_ref(), &name, &path, at, "value")? {
            Callee::Own(function) if self.names.functions[function].is_constant => {
                Ok(Node::Constant(function, at))
            }
            Callee::Own(function) => Ok(Node::Function(function)),
            Callee::Native(native) => Ok(Node::NativeFunction(native)),
            Callee::Default(ty) => {
                let body = self.default_of(&ty, at)?;
                let parameters = Vec::new();
                let closure = Closure { parameters, body };
                Ok(Node::Closure(Arc::new(closure), false))
            }
            Callee::Struct(kind) if self.names.kinds[kind as usize].fields.is_empty() => {
                Ok(Node::New(kind, Vec::new(), None))
            }
            Callee::Struct(_) => self.unread(at, "structs as functions"),
            Callee::OfTrait => self.unread(at, "methods of traits as values"),
        }
    }

    /// The type before the last `::`, if a type is there, and what comes after.
    pub(super) fn owner(&self, path: &[String], at: At) -> Lowered<(Option<Type>, String)> {
        let (name, before) = path.split_last().expect("a path has a name");
        let own = self.context.own.clone().filter(|_| before == ["Self"]);
        let owner = match (before, own) {
            ([], _) => None,
            (_, Some(own)) => Some(own),
            (before, None) => match self.names.found(self.context.module, before) {
                Ok(Named::Type(ty)) => Some(ty),
                Ok(Named::Generic(head)) => Some(Type::of(head, Type::UNKNOWN)),
                Ok(Named::Trait(of)) => Some(Head::Dyn(of).into()),
                Ok(Named::Standard(of)) => {
                    return self.unread(at, &format!("`{of}::{name}`"));
                }
                Ok(_) => None,
                Err(lost) => {
                    let module = self.context.module;
                    return Err(self.names.not_found(module, at, "type", before, lost));
                }
            },
        };
        Ok((owner, name.clone()))
    }

    /// The function that a path names.
    pub(super) fn callee(
        &self,
        owner: Option<&Type>,
        name: &str,
        path: &[String],
        at: At,
        what: &str,
    ) -> Lowered<Callee> {
        let module = self.context.module;
        if let Some(owner) = owner {
            return self.callee_of(owner, name, at);
        }
        let named = match (path, &self.context.own) {
            ([name], Some(own)) if name == "Self" => Ok(Named::Type(own.clone())),
            (path, _) => self.names.found(module, path),
        };
        match named {
            Ok(Named::Function(function)) => Ok(Callee::Own(function)),
            Ok(Named::Library(name)) => {
                let native = library::function(Owners::NONE, name);
                Ok(Callee::Native(native.expect("it is listed")))
            }
            Ok(Named::Type(Type(Head::Own(kind), _)))
                if self.names.kinds[kind as usize].is_tuple =>
            {
                Ok(Callee::Struct(kind))
            }
            Ok(Named::Standard(name)) => self.unread(at, &format!("`{name}`")),
            Ok(_) => {
                let message = format!("expected {what}, found `{}`", path.join("::"));
                self.fault(at, &message, &format!("not a {what}"), "")
            }
            Err(lost) => {
                let refusal = self.names.not_found(module, at, what, path, lost);
                let locals = self.locals.iter().map(|it| it.name.as_str());
                let is_local = path.len() == 1 && what == "value";
                Err(refusal.or_help(&there_is(name, locals.filter(|_| is_local))))
            }
        }
    }

    fn callee_of(&self, owner: &Type, name: &str, at: At) -> Lowered<Callee> {
        if let Head::Dyn(of) = owner.0 {
            let mut methods = self.names.traits[of].methods.iter();
            if methods.any(|&it| self.names.functions[it].name == name) {
                return Ok(Callee::OfTrait);
            }
        }
        if let Some(own) = self.names.method(owner.0, name) {
            if !self.names.shows(self.context.module, own) {
                return Err(self.hidden(own, at));
            }
            return Ok(Callee::Own(own));
        }
        if name == "default" {
            self.default_of(owner, at)?;
            return Ok(Callee::Default(owner.clone()));
        }
        if let Some(native) = library::function(Owners::of(owner.0), name) {
            return Ok(Callee::Native(native));
        }
        let ty = owner.name(self.names);
        let message = format!(
            "no function or associated item named `{name}` found for `{ty}` in the current scope"
        );
        match owner.0 {
            Head::Own(_) | Head::Dyn(_) | Head::Ray | Head::Picture => {
                self.fault(at, &message, "", "")
            }
            _ => self.unread(at, &format!("`{name}` of `{ty}`")),
        }
    }

    /// Says why a function may not be called here.
    pub(super) fn hidden(&self, function: usize, at: At) -> Refusal {
        let own = &self.names.functions[function];
        let name = &own.name;
        let Some(of) = own.in_trait else {
            let what = if own.has_self {
                "method"
            } else {
                "associated function"
            };
            return private(what, name, at);
        };
        let of = &self.names.traits[of].name;
        let message = format!("no method named `{name}` found");
        let help = format!(
            "items from traits can only be used if the trait is in scope: `use` the trait `{of}`"
        );
        Refusal::new(at, message, "", &help)
    }
}
