//! Structs: initializers, and the values of `Default`.

use super::calls::made;
use super::paths::no_function;
use super::places::member;
use super::{Expr, Lowered, Lowerer};
use crate::library;
use crate::machine::Thunk;
use crate::machine::value::Value;
use crate::names::words::unexpected;
use crate::names::{Meaning, names};
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

impl Lowerer<'_> {
    /// Lowers the initializer of a struct.
    pub(super) fn structure(&mut self, it: &syn::ExprStruct) -> Lowered {
        let ty = self.struct_named(&it.path)?;
        let mut fields = self.fields_given(it, &ty)?;
        let at = self.at_any(&it.path);
        if let Ctor::Own(kind) = ty.0 {
            let base = it.rest.as_ref().map(|rest| self.given(rest, &ty));
            return Ok(made(kind, fields, base.transpose()?.map(|it| it.run), at));
        }
        if it.rest.is_some() {
            return self.unread(at, "such an initializer");
        }
        fields.sort_by_key(|it| it.0);
        let new = library::function(ty.0, "new").expect("it is listed");
        Ok(Expr::new(at, move |m| {
            let values = fields.iter().map(|it| it.1.eval(m));
            let mut values: Vec<Value> = values.collect::<Result<_, _>>()?;
            m.native(new, &mut values, &at.into())
        }))
    }

    /// Returns the type with fields that a path names.
    pub(super) fn struct_named(&self, path: &syn::Path) -> Lowered<Type> {
        let (path, at) = (names(path), self.at_any(path));
        let what = "struct, variant or union type";
        match self.names.expected(&self.context, &path, what, at)? {
            Meaning::Type(ty) if matches!(ty.0, Ctor::Own(_) | Ctor::Vec3 | Ctor::Ray) => Ok(ty),
            _ => Err(unexpected(what, &path, at)),
        }
    }

    /// Returns the number and the type of a field of a struct, a vector or a ray.
    pub(super) fn field_of(&self, ty: &Type, name: &str, at: Span) -> Lowered<(usize, Type)> {
        let fields = self.names.fields(ty);
        let n = fields.iter().position(|it| *it == name);
        let n = n.ok_or_else(|| self.names.no_field(name, ty, at))?;
        let of = match ty.0 {
            Ctor::Own(kind) => {
                let kind = &self.names.structs[kind as usize];
                let (field, module) = (&kind.fields[n], self.context.module);
                if !self.names.sees(module, kind.module, field.is_public) {
                    return Err(crate::names::words::private("field", name, at));
                }
                field.ty.clone()
            }
            Ctor::Vec3 => Ctor::F64.into(),
            _ => Ctor::Vec3.into(),
        };
        Ok((n, of))
    }

    /// Lowers the fields of an initializer, each with its number.
    fn fields_given(&mut self, it: &syn::ExprStruct, ty: &Type) -> Lowered<Vec<(usize, Thunk)>> {
        let mut fields: Vec<(usize, Thunk)> = Vec::new();
        for field in &it.fields {
            let name = member(&field.member);
            let at = self.at_any(&field.member);
            let (n, of) = self.field_of(ty, &name, at)?;
            if fields.iter().any(|it| it.0 == n) {
                return self.refused(at, format!("field `{name}` specified more than once"));
            }
            fields.push((n, self.given(&field.expr, &of)?.run));
        }
        let all = self.names.fields(ty);
        let mut missing = (0..all.len()).filter(|n| fields.iter().all(|it| it.0 != *n));
        match missing.next() {
            Some(n) if it.rest.is_none() => {
                let (field, name) = (all[n], ty.name(self.names));
                let message = format!("missing field `{field}` in initializer of `{name}`");
                self.refused(self.at_any(&it.path), message)
            }
            _ => Ok(fields),
        }
    }

    /// Lowers `Default::default()` of a type; refuses a type that has none.
    pub(super) fn default_of(&self, ty: &Type, at: Span) -> Lowered {
        let has_none = match ty.0 {
            Ctor::Own(kind) => {
                let kind = &self.names.structs[kind as usize];
                kind.default.is_none() && !kind.derives("Default")
            }
            Ctor::Ray | Ctor::Picture | Ctor::Dyn(_) => true,
            Ctor::Unknown => return self.unread(at, "a default without its type"),
            _ => false,
        };
        if has_none {
            let message = no_function("default", &ty.name(self.names));
            let help = "`#[derive(Default)]` above the struct gives one";
            return Err(Refusal::new(at, message, "", help));
        }
        let ty = ty.clone();
        Ok(Expr::new(at, move |m| m.default(&ty, at)))
    }
}
