//! Structs: initializers, and what is there by default.

use super::places::member;
use super::{Lowered, Lowerer};
use crate::library;
use crate::names::{Named, names};
use crate::node::{Arguments, Node};
use crate::refusal::{At, Refusal};
use crate::types::{Head, Owners, Type};

impl Lowerer<'_> {
    pub(super) fn structure(&mut self, it: &syn::ExprStruct) -> Lowered {
        let ty = self.struct_named(&it.path)?;
        let mut nodes = self.fields_given(it, &ty)?;
        let at = self.at_any(&it.path);
        if let Head::Own(kind) = ty.0 {
            let base = match &it.rest {
                Some(rest) => Some(Box::new(self.given(rest, &ty)?)),
                None => None,
            };
            return Ok(Node::New(kind, nodes, base));
        }
        if it.rest.is_some() {
            return self.unread(at, "such an initializer");
        }
        nodes.sort_by_key(|it| it.0);
        let nodes: Vec<Node> = nodes.into_iter().map(|it| it.1).collect();
        let new = library::function(Owners::of(ty.0), "new");
        let places = vec![at; nodes.len()].into();
        let nodes = nodes.into();
        let arguments = Arguments { nodes, places, at };
        Ok(Node::Native(new.expect("it is listed"), arguments))
    }

    /// The type that a path names, which has fields.
    pub(super) fn struct_named(&self, path: &syn::Path) -> Lowered<Type> {
        let (path, at) = (names(path), self.at_any(path));
        let named = match (path.as_slice(), &self.context.own) {
            ([name], Some(own)) if name == "Self" => Ok(Named::Type(own.clone())),
            (path, _) => self.names.found(self.context.module, path),
        };
        let what = "struct, variant or union type";
        match named {
            Ok(Named::Type(ty)) if matches!(ty.0, Head::Own(_) | Head::Vec3 | Head::Ray) => Ok(ty),
            Ok(Named::Standard(name)) => self.unread(at, &format!("`{name}`")),
            Ok(_) => {
                let message = format!("expected {what}, found `{}`", path.join("::"));
                self.fault(at, &message, &format!("not a {what}"), "")
            }
            Err(lost) => {
                let module = self.context.module;
                Err(self.names.not_found(module, at, what, &path, lost))
            }
        }
    }

    /// The number and the type of a field of a struct, or of a vector or a ray.
    pub(super) fn field_of(&self, ty: &Type, name: &str, at: At) -> Lowered<(usize, Type)> {
        let found = match ty.0 {
            Head::Own(kind) => {
                let kind = &self.names.kinds[kind as usize];
                let n = kind.field(name);
                if let Some(n) = n
                    && !self
                        .names
                        .sees(self.context.module, kind.module, kind.fields[n].is_public)
                {
                    return Err(crate::names::words::private("field", name, at));
                }
                n.map(|n| (n, kind.fields[n].ty.clone()))
            }
            head => {
                let (all, of): (&[&str], Head) = match head {
                    Head::Vec3 => (&["x", "y", "z"], Head::F64),
                    _ => (&["origin", "direction"], Head::Vec3),
                };
                let n = all.iter().position(|it| *it == name);
                n.map(|n| (n, of.into()))
            }
        };
        found.ok_or_else(|| self.names.no_field(name, ty, at))
    }

    /// The fields of an initializer by their numbers.
    fn fields_given(&mut self, it: &syn::ExprStruct, ty: &Type) -> Lowered<Vec<(usize, Node)>> {
        let mut nodes: Vec<(usize, Node)> = Vec::new();
        for field in &it.fields {
            let name = member(&field.member);
            let at = self.at_any(&field.member);
            let (n, of) = self.field_of(ty, &name, at)?;
            if nodes.iter().any(|it| it.0 == n) {
                return self.refused(at, format!("field `{name}` specified more than once"));
            }
            nodes.push((n, self.given(&field.expr, &of)?));
        }
        let all: Vec<&str> = match ty.0 {
            Head::Own(kind) => {
                let fields = self.names.kinds[kind as usize].fields.iter();
                fields.map(|it| it.name.as_str()).collect()
            }
            Head::Vec3 => vec!["x", "y", "z"],
            _ => vec!["origin", "direction"],
        };
        let mut missing = (0..all.len()).filter(|n| nodes.iter().all(|it| it.0 != *n));
        match missing.next() {
            Some(n) if it.rest.is_none() => {
                let (field, name) = (all[n], ty.name(self.names));
                let message = format!("missing field `{field}` in initializer of `{name}`");
                self.refused(self.at_any(&it.path), message)
            }
            _ => Ok(nodes),
        }
    }

    /// What `Default` gives for a type, if it gives something.
    pub(super) fn default_of(&self, ty: &Type, at: At) -> Lowered {
        let has_none = match ty.0 {
            Head::Own(kind) => {
                let kind = &self.names.kinds[kind as usize];
                kind.default.is_none() && !kind.derives("Default")
            }
            Head::Ray | Head::Picture | Head::Dyn(_) => true,
            Head::Unknown => return self.unread(at, "a default without its type"),
            _ => false,
        };
        if has_none {
            let message = format!(
                "no function or associated item named `default` found for `{}` in the current scope",
                ty.name(self.names)
            );
            let help = "`#[derive(Default)]` above the struct gives one";
            return Err(Refusal::new(at, message, "", help));
        }
        Ok(Node::Default(Box::new(ty.clone()), at))
    }
}
