//! Place expressions: variables, fields and elements that can be assigned to or borrowed.

use std::sync::Arc;

use super::{Expr, Lowered, Lowerer};
use crate::library;
use crate::machine::value::Address;
use crate::machine::{Eval, ExprForm, FieldAccess, Machine, PlaceExpr, Thunk};
use crate::names::words::private;
use crate::refusal::{Refusal, Span};
use crate::types::Type;

impl Lowerer<'_> {
    /// Lowers an expression as a place that can be assigned to; `None` if it is none, as a sum.
    pub(super) fn place(&mut self, it: &syn::Expr) -> Lowered<Option<PlaceExpr>> {
        let at = self.at(it);
        Ok(match it {
            syn::Expr::Paren(it) => self.place(&it.expr)?,
            syn::Expr::Path(_) => {
                let slot = self.variable_of(it).map(|it| it.slot);
                slot.map(|slot| place(at, Some(slot), Some(slot), move |m| Ok(m.address_of(slot))))
            }
            syn::Expr::Field(it) => {
                let field = self.field_named(it)?;
                self.place(&it.base)?.map(|base| {
                    place(at, None, base.root, move |m| {
                        let address = (base.address)(m)?;
                        let (whole, value) = m.opened(address, at)?;
                        Ok(whole.part(m.number(&value, &field)?))
                    })
                })
            }
            syn::Expr::Index(it) => {
                let index = self.expr(&it.index)?;
                self.place(&it.expr)?.map(|base| {
                    place(at, None, base.root, move |m| {
                        let address = (base.address)(m)?;
                        let (whole, value) = m.opened(address, at)?;
                        let by = index.run.eval(m)?;
                        Ok(whole.part(m.index(&value, &by, index.spot.at)?))
                    })
                })
            }
            syn::Expr::Unary(it) if matches!(it.op, syn::UnOp::Deref(_)) => {
                let reference = self.expr(&it.expr)?.run;
                Some(place(at, None, None, move |m| {
                    let reference = reference.eval(m)?;
                    m.address_behind(reference, at)
                }))
            }
            _ => None,
        })
    }

    /// Prepares a place for a change: notes the refusal in case its variable is not `mut`. Only the
    /// running program shows if the variable holds a mutable reference, which needs no `mut`.
    pub(super) fn mutable(&self, place: PlaceExpr) -> PlaceExpr {
        let Some(slot) = place.root else {
            return place;
        };
        let local = self.locals.iter().rev().find(|it| it.slot == slot);
        let fixed = local.filter(|it| !it.is_mut).map(|local| {
            let name = &local.name;
            let message =
                format!("cannot borrow `{name}` as mutable, as it is not declared as mutable");
            Refusal::new(place.at, message, "", &format!("`let mut {name}`"))
        });
        PlaceExpr { fixed, ..place }
    }

    /// Lowers `… = …`.
    pub(super) fn assignment(&mut self, it: &syn::ExprAssign) -> Lowered {
        let at = self.at(&it.right);
        if let syn::Expr::Tuple(all) = &*it.left {
            return self.assignments(all, &it.right, at);
        }
        let Expr { run, spot } = self.expr(&it.right)?;
        if matches!(&*it.left, syn::Expr::Infer(_)) {
            return Ok(Expr::new(at, move |m| {
                run.eval(m).map(|_| Default::default())
            }));
        }
        let place = self.assigned(&it.left)?;
        Ok(Expr::new(at, move |m| {
            let value = run.eval(m)?;
            m.put(&place, value, spot)
        }))
    }

    /// Lowers an assignment to a tuple of places.
    fn assignments(&mut self, all: &syn::ExprTuple, value: &syn::Expr, at: Span) -> Lowered {
        let places = all.elems.iter().map(|it| match it {
            syn::Expr::Infer(_) => Ok(None),
            it => self.assigned(it).map(Some),
        });
        let places = places.collect::<Lowered<Vec<_>>>()?;
        let value = self.expr(value)?.run;
        Ok(Expr::new(at, move |m| {
            let value = value.eval(m)?;
            let values = m.parted(&value, places.len(), at)?;
            for (place, value) in places.iter().zip(values) {
                if let Some(place) = place {
                    m.put(place, value, place.at.into())?;
                }
            }
            Ok(Default::default())
        }))
    }

    /// Lowers the left side of an assignment.
    fn assigned(&mut self, left: &syn::Expr) -> Lowered<PlaceExpr> {
        let at = self.at(left);
        let Some(place) = self.place(left)? else {
            // What is no place may be a name that is not there.
            self.expr(left)?;
            return self.refused(at, "invalid left-hand side of assignment");
        };
        let local = place
            .local
            .and_then(|slot| self.locals.iter().rev().find(|it| it.slot == slot));
        match local {
            Some(local) if !local.is_mut => {
                let name = &local.name;
                let message = format!("cannot assign twice to immutable variable `{name}`");
                self.fault(at, &message, "", &format!("`let mut {name}`"))
            }
            Some(_) => Ok(place),
            None => Ok(self.mutable(place)),
        }
    }

    /// Lowers the access to a field.
    pub(super) fn field(&mut self, it: &syn::ExprField) -> Lowered {
        let Expr { run, spot } = self.expr(&it.base)?;
        if spot.form == ExprForm::Open {
            return self.needs_a_type(spot.at);
        }
        let field = self.field_named(it)?;
        let at = Span {
            end: field.at.end,
            ..spot.at
        };
        Ok(match run {
            Thunk::Local(slot) => Expr::new(at, move |m| m.field_of_local(slot, &field)),
            run => Expr::new(at, move |m| {
                let value = run.eval(m)?;
                m.field(value, &field)
            }),
        })
    }

    /// Finds the fields of that name in all types; refuses a name that no type has.
    fn field_named(&mut self, it: &syn::ExprField) -> Lowered<Arc<FieldAccess>> {
        let at = self.at_any(&it.member);
        let name = member(&it.member);
        let module = self.context.module;
        let mut is_hidden = false;
        let own = self.names.structs.iter().map(|kind| {
            let n = kind.field(&name)?;
            let is_public = kind.fields[n].is_public;
            let is_seen = self.names.sees(module, kind.module, is_public);
            is_hidden |= !is_seen;
            is_seen.then_some(n as u32)
        });
        let among = |all: &[&str]| all.iter().position(|it| *it == name);
        let field = FieldAccess {
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
        let refusal = self.names.no_field(&field.name, &Type::UNKNOWN, at);
        Err(match library::methods(&field.name).next() {
            Some(it) => refusal.or_help(&format!("`{0}` is a method: `.{0}(…)`", it.name)),
            None => refusal,
        })
    }

    /// Lowers `…[…]`.
    pub(super) fn index(&mut self, it: &syn::ExprIndex) -> Lowered {
        let at = self.at_any(it);
        if matches!(&*it.index, syn::Expr::Range(_)) {
            return self.unread(self.at(&it.index), "slices by a range");
        }
        let (of, by) = (self.expr(&it.expr)?.run, self.expr(&it.index)?.run);
        Ok(Expr::new(at, move |m| {
            let list = of.eval(m)?;
            let index = by.eval(m)?;
            m.indexed(&list, &index, at)
        }))
    }
}

/// Makes a place of the function that finds its address.
fn place(
    at: Span,
    local: Option<usize>,
    root: Option<usize>,
    address: impl Fn(&mut Machine<'_>) -> Eval<Address> + Send + Sync + 'static,
) -> PlaceExpr {
    PlaceExpr {
        local,
        root,
        fixed: None,
        address: Box::new(address),
        at,
    }
}

/// Returns the name of a field, or the number of a tuple's part as text.
pub(super) fn member(it: &syn::Member) -> String {
    match it {
        syn::Member::Named(name) => name.to_string(),
        syn::Member::Unnamed(n) => n.index.to_string(),
    }
}
