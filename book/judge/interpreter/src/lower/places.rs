//! Places: variables, their fields and parts, and what may be changed.

use std::sync::Arc;

use super::{Lowered, Lowerer};
use crate::names::words::private;
use crate::node::{Field, Node, Root, Step, Target};
use crate::refusal::{At, Refusal};
use crate::types::Type;

impl Lowerer<'_> {
    /// The place that an expression names, if it names one.
    pub(super) fn place(&mut self, it: &syn::Expr) -> Lowered<Option<Target>> {
        let at = self.at(it);
        match it {
            syn::Expr::Paren(it) => self.place(&it.expr),
            syn::Expr::Path(path) => {
                let name = path.path.get_ident().map(ToString::to_string);
                let local = name.and_then(|it| self.variable(&it));
                Ok(local.map(|local| Target {
                    root: Root::Local(local.slot),
                    steps: Vec::new(),
                    fixed: None,
                    at,
                }))
            }
            syn::Expr::Field(it) => {
                let step = Step::Field(self.field_named(it)?);
                self.part(&it.base, step, at)
            }
            syn::Expr::Index(it) => {
                let index = self.expr(&it.index)?;
                let step = Step::Index(index, self.at(&it.index));
                self.part(&it.expr, step, at)
            }
            syn::Expr::Unary(it) if matches!(it.op, syn::UnOp::Deref(_)) => {
                let root = Root::Through(self.expr(&it.expr)?);
                Ok(Some(Target {
                    root,
                    steps: Vec::new(),
                    fixed: None,
                    at,
                }))
            }
            _ => Ok(None),
        }
    }

    fn part(&mut self, of: &syn::Expr, step: Step, at: At) -> Lowered<Option<Target>> {
        Ok(self.place(of)?.map(|mut target| {
            target.steps.push(step);
            target.at = at;
            target
        }))
    }

    /// A place that is borrowed to be changed. Whether its variable is a mutable reference is
    /// seen when it runs.
    pub(super) fn mutable(&self, target: Target) -> Target {
        let Root::Local(slot) = target.root else {
            return target;
        };
        let local = self.locals.iter().rev().find(|it| it.slot == slot);
        let fixed = local.filter(|it| !it.is_mut).map(|local| {
            let name = &local.name;
            let message =
                format!("cannot borrow `{name}` as mutable, as it is not declared as mutable");
            Refusal::new(target.at, message, "", &format!("`let mut {name}`"))
        });
        Target { fixed, ..target }
    }

    pub(super) fn assignment(&mut self, it: &syn::ExprAssign) -> Lowered {
        let at = self.at(&it.right);
        if let syn::Expr::Tuple(all) = &*it.left {
            let targets = all.elems.iter().map(|it| match it {
                syn::Expr::Infer(_) => Ok((None, self.at(it))),
                it => Ok((Some(self.assigned(it)?), self.at(it))),
            });
            let targets = targets.collect::<Lowered<_>>()?;
            let value = self.expr(&it.right)?;
            return Ok(Node::SetAll(targets, Box::new(value)));
        }
        if matches!(&*it.left, syn::Expr::Infer(_)) {
            let value = self.expr(&it.right)?;
            return Ok(Node::Block(vec![value], false));
        }
        let value = self.expr(&it.right)?;
        let target = self.assigned(&it.left)?;
        Ok(Node::Set(Box::new(target), Box::new(value), at))
    }

    fn assigned(&mut self, left: &syn::Expr) -> Lowered<Target> {
        let at = self.at(left);
        if let Some(target) = self.place(left)? {
            if let (Root::Local(slot), []) = (&target.root, target.steps.as_slice()) {
                let local = self.locals.iter().rev().find(|it| it.slot == *slot);
                if let Some(local) = local.filter(|it| !it.is_mut) {
                    let name = &local.name;
                    let message = format!("cannot assign twice to immutable variable `{name}`");
                    return self.fault(at, &message, "", &format!("`let mut {name}`"));
                }
                return Ok(target);
            }
            return Ok(self.mutable(target));
        }
        // What is no place may be a name that is not there.
        self.expr(left)?;
        self.refused(at, "invalid left-hand side of assignment")
    }

    pub(super) fn field(&mut self, it: &syn::ExprField) -> Lowered {
        let base = self.expr(&it.base)?;
        if self.is_open(&it.base) {
            return self.needs_a_type(self.at(&it.base));
        }
        let field = self.field_named(it)?;
        Ok(Node::Field(Box::new(base), field))
    }

    /// Whether it is a variable of which the compiler wants to know the type.
    pub(super) fn is_open(&self, it: &syn::Expr) -> bool {
        let syn::Expr::Path(path) = it else {
            return false;
        };
        let name = path.path.get_ident().map(ToString::to_string);
        name.and_then(|it| self.variable(&it))
            .is_some_and(|it| it.is_open)
    }

    /// Of what is not known nothing can be asked: neither here nor there.
    pub(super) fn needs_a_type<T>(&self, at: At) -> Lowered<T> {
        let help = "say its type where it begins: `let x: …`, or `|x: …|`";
        self.fault(at, "type annotations needed", "cannot infer type", help)
    }

    fn field_named(&mut self, it: &syn::ExprField) -> Lowered<Arc<Field>> {
        let at = self.at_span(syn::spanned::Spanned::span(&it.member));
        let name = member(&it.member);
        let kinds = &self.names.kinds;
        let module = self.context.module;
        let mut is_hidden = false;
        let own = kinds.iter().map(|kind| {
            let n = kind.field(&name)?;
            let is_seen = self
                .names
                .sees(module, kind.module, kind.fields[n].is_public);
            is_hidden |= !is_seen;
            is_seen.then_some(n as u32)
        });
        let among = |all: &[&str]| all.iter().position(|it| *it == name);
        let field = Field {
            own: own.collect(),
            vec3: among(&["x", "y", "z"]),
            ray: among(&["origin", "direction"]),
            number: name.parse().ok(),
            at,
            name,
        };
        let is_library = field.vec3.is_some() || field.ray.is_some() || field.number.is_some();
        if is_library || field.own.iter().any(Option::is_some) {
            return Ok(Arc::new(field));
        }
        if is_hidden {
            return Err(private("field", &field.name, at));
        }
        Err(self.names.no_field(&field.name, &Type::UNKNOWN, at))
    }

    pub(super) fn index(&mut self, it: &syn::ExprIndex) -> Lowered {
        let at = self.at_any(it);
        let of = self.expr(&it.expr)?;
        let by = self.expr(&it.index)?;
        if matches!(by, Node::Range(..)) {
            return self.unread(self.at(&it.index), "slices by a range");
        }
        Ok(Node::Index(Box::new([of, by]), at))
    }
}

/// The name of a field, or its number.
pub(super) fn member(it: &syn::Member) -> String {
    match it {
        syn::Member::Named(name) => name.to_string(),
        syn::Member::Unnamed(n) => n.index.to_string(),
    }
}
