//! Places in the text: variables, their fields and elements, and what is assigned to them.

use std::mem;

use super::lowerer::{Lowered, Lowerer};
use crate::fault::{Fault, Span};
use crate::machine::{Code, Machine, Run};
use crate::operators::Op;
use crate::place::{FieldName, Part, Place};
use crate::value::{Value, kind};

impl Lowerer<'_> {
    /// Returns the place that an expression names; `None` if its value lies in none.
    pub(super) fn place(&mut self, expr: &syn::Expr) -> Lowered<Option<Place>> {
        let base = match expr {
            syn::Expr::Path(it) => return Ok(self.variable(&it.path)),
            syn::Expr::Paren(it) => return self.place(&it.expr),
            syn::Expr::Unary(it) if matches!(it.op, syn::UnOp::Deref(_)) => {
                return self.place(&it.expr);
            }
            syn::Expr::Reference(it) if it.mutability.is_some() => return self.place(&it.expr),
            syn::Expr::Field(it) => &it.base,
            syn::Expr::Index(it) => &it.expr,
            _ => return Ok(None),
        };
        let Some(mut place) = self.place(base)? else {
            return Ok(None);
        };
        Ok(Some(match expr {
            syn::Expr::Field(it) => place.part(Part::Field(self.field(&it.member)?)),
            syn::Expr::Index(it) => {
                let slot = self.slot();
                place.indices.push((slot, self.expr(&it.index)?.into()));
                place.part(Part::Index(slot))
            }
            _ => place,
        }))
    }

    /// Returns the place behind a `&mut` that is written here, and the code that reads its value.
    pub(super) fn lent(&mut self, expr: &syn::Expr) -> Lowered<Option<(Place, Code)>> {
        let of = match expr {
            syn::Expr::Reference(it) if it.mutability.is_some() => &it.expr,
            syn::Expr::MethodCall(it) if it.method == "iter_mut" => &it.receiver,
            _ => return Ok(None),
        };
        let Some(mut place) = self.place(of)? else {
            return Ok(None);
        };
        let at = self.at(expr);
        place.changeable(at)?;
        let read = place.read(at);
        // Its other names don't compute the indices again.
        mem::take(&mut place.indices);
        Ok(Some((place, read)))
    }

    /// Looks up a field's name in all types.
    pub(super) fn field(&self, member: &syn::Member) -> Lowered<FieldName> {
        let name = member_name(member);
        let structs = (0..).zip(&self.names.kinds).filter(|it| !it.1.is_enum);
        let fields =
            structs.filter_map(|(kind, it)| Some((kind, it.variants.first()?.field(&name)?)));
        let of_tuple = name.parse().ok().map(|n| (kind::TUPLE, n));
        let of: Vec<_> = fields.chain(of_tuple).collect();
        if of.is_empty() {
            if self.names.functions_of_types().any(|known| known == name) {
                let message = format!("`{name}` is no field: write `.{name}(…)`");
                return self.refused(member, message);
            }
            let known = self.names.fields();
            let fault = Fault::refused(self.at(member), format!("there is no field `{name}`"));
            return Err(fault.or_meant(&name, known));
        }
        Ok(FieldName { name, of })
    }

    pub(super) fn assignment(&mut self, left: &syn::Expr, right: &syn::Expr) -> Lowered {
        let (value, at) = (self.expr(right)?, self.at(left));
        if let syn::Expr::Infer(_) = left {
            return Ok(Code::act(move |m| value.run(m).map(|_| Value::Unit)));
        }
        let place = self.changeable(left, at)?;
        Ok(Code::act(move |m| {
            let value = value.run(m)?;
            place.settle(m)?;
            m.assign(&place, value, at).map(Value::from)
        }))
    }

    fn changeable(&mut self, left: &syn::Expr, at: Span) -> Lowered<Place> {
        let Some(place) = self.place(left)? else {
            if let syn::Expr::Tuple(_) = left {
                return self.unread(left, "an assignment to several places");
            }
            // An unknown name is said to be one.
            self.expr(left)?;
            return self.refused(left, "no value can be assigned to this");
        };
        place.changeable(at)?;
        Ok(place)
    }

    /// Lowers `place += value` and the like.
    pub(super) fn update(&mut self, op: Op, update: &syn::ExprBinary) -> Lowered {
        let (value, at) = (self.expr(&update.right)?, self.at(&update.op));
        let place = self.changeable(&update.left, at)?;
        Ok(Code::act(move |m| {
            let value = value.run(m)?;
            place.settle(m)?;
            let old = place.take(m, at)?;
            let new = m.arithmetic(op, &old, &value, at)?;
            place.put(m, new, at).map(Value::from)
        }))
    }
}

impl Machine<'_> {
    /// Puts a value into a place. It has to be of the type of what was there, unless that is a type
    /// of a text: a `dyn` takes several.
    fn assign(&mut self, place: &Place, mut value: Value, at: Span) -> Run<()> {
        let old = place.take(self, at)?.kind();
        if (kind::BOOL..=kind::CAMERA).contains(&old) {
            self.admit(old, &mut value, at)?;
        }
        place.put(self, value, at)
    }
}

pub(super) fn member_name(member: &syn::Member) -> String {
    match member {
        syn::Member::Named(it) => it.to_string(),
        syn::Member::Unnamed(it) => it.index.to_string(),
    }
}
