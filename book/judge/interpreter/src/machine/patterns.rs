//! Pattern matching: whether a value matches, and the names of its parts.

use super::Machine;
use crate::host::Eval;
use crate::node::{Arm, Node, Pattern};
use crate::refusal::{At, Refusal};
use crate::types::{Head, Type};
use crate::value::{Data, Value};

impl Machine<'_> {
    /// Whether the value matches; if so, its parts have their names.
    pub(super) fn binds(&mut self, pattern: &Pattern, value: &Value) -> Eval<bool> {
        Ok(match pattern {
            Pattern::Any => true,
            Pattern::Bind(slot) => {
                let slot = self.base + slot;
                self.stack[slot] = value.clone();
                true
            }
            Pattern::BindAs(slot, of) => {
                let slot = self.base + slot;
                self.stack[slot] = value.clone();
                self.binds(of, value)?
            }
            Pattern::Typed(of, ty, at) => {
                let value = self.as_declared(value.clone(), ty, *at, None)?;
                self.binds(of, &value)?
            }
            Pattern::Ref(of, at) => match value.lent {
                0 => {
                    let said = self.ty(value).said(&self.code.names);
                    let label = format!("expected {said}, found reference");
                    let help = "leave the `&` out";
                    return self.refused(Refusal::new(*at, "mismatched types", &label, help));
                }
                lent => {
                    let (lent, data) = (lent - 1, value.data.clone());
                    self.binds(of, &Value { lent, data })?
                }
            },
            Pattern::Or(all) => {
                for pattern in all {
                    if self.binds(pattern, value)? {
                        return Ok(true);
                    }
                }
                false
            }
            Pattern::Equal(node, at) => self.is_equal(node, value, *at)?,
            Pattern::Within(from, to, is_closed, at) => {
                self.is_within([from.as_ref(), to.as_ref()], *is_closed, value, *at)?
            }
            pattern => self.parts_bind(pattern, value)?,
        })
    }

    fn parts_bind(&mut self, pattern: &Pattern, value: &Value) -> Eval<bool> {
        let whole = match &value.data {
            Data::Mut(_) => &self.end_of(value),
            _ => value,
        };
        match (pattern, &whole.data) {
            (Pattern::None, Data::None) => Ok(true),
            (Pattern::None, Data::Some(_)) | (Pattern::Some(..), Data::None) => Ok(false),
            (Pattern::Some(of, _), Data::Some(_)) => {
                let part = part(value, whole, 0);
                self.binds(of, &part)
            }
            (Pattern::Struct(head, fields, _), _) if *head == whole.head() => {
                self.all_bind(fields, value, whole)
            }
            (Pattern::Tuple(count, fields, _), Data::Tuple(all)) if all.len() == *count => {
                self.all_bind(fields, value, whole)
            }
            (Pattern::List(all, at), Data::List(list)) => {
                let (wanted, length) = (all.len(), list.all.len());
                if list.is_array && wanted != length {
                    let message =
                        format!("pattern requires {wanted} elements but array has {length}");
                    return self.refused(Refusal::new(*at, message, "", ""));
                }
                for (n, pattern) in all.iter().enumerate() {
                    if wanted != length || !self.binds(pattern, &part(value, whole, n))? {
                        return Ok(false);
                    }
                }
                Ok(wanted == length)
            }
            _ => self.other_type(pattern, whole),
        }
    }

    fn all_bind(
        &mut self,
        fields: &[(usize, Pattern)],
        value: &Value,
        whole: &Value,
    ) -> Eval<bool> {
        for (n, pattern) in fields {
            if !self.binds(pattern, &part(value, whole, *n))? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// A pattern for values of another type.
    fn other_type<T>(&mut self, pattern: &Pattern, value: &Value) -> Eval<T> {
        let unknown = |count| vec![Type::UNKNOWN; count];
        let (found, at) = match pattern {
            Pattern::Some(_, at) => (Type::of(Head::Option, Type::UNKNOWN), *at),
            Pattern::Struct(head, _, at) => ((*head).into(), *at),
            Pattern::Tuple(count, _, at) => (Type(Head::Tuple, unknown(*count)), *at),
            Pattern::List(all, at) => (Type(Head::Array(all.len()), unknown(1)), *at),
            _ => (Type::of(Head::Option, Type::UNKNOWN), At::default()),
        };
        let names = &self.code.names;
        let wanted = self.ty(value);
        let said = found.said(names);
        let refusal = names.mismatch(&wanted, &found, &said, at);
        self.refused(refusal)
    }

    fn is_equal(&mut self, node: &Node, value: &Value, at: At) -> Eval<bool> {
        let wanted = self.eval(node)?;
        let value = self.end_of(value).owned();
        if !wanted.clone().owned().is_like(&value) {
            let ty = self.ty(&value);
            return self.mismatch(&wanted, &ty, at, Some(node));
        }
        Ok(wanted.equals(&value))
    }

    fn is_within(
        &mut self,
        ends: [Option<&Node>; 2],
        is_closed: bool,
        value: &Value,
        at: At,
    ) -> Eval<bool> {
        let value = self.end_of(value).owned();
        for (is_end, node) in ends.into_iter().enumerate() {
            let Some(node) = node else { continue };
            let end = self.eval(node)?;
            if !end.is_like(&value) {
                let ty = self.ty(&value);
                return self.mismatch(&end, &ty, at, Some(node));
            }
            let is_inside = value.compared(&end).is_some_and(|order| match is_end {
                0 => order.is_ge(),
                _ => order.is_lt() || is_closed && order.is_eq(),
            });
            if !is_inside {
                return Ok(false);
            }
        }
        Ok(true)
    }

    #[inline(never)]
    pub(super) fn matched(&mut self, of: &Node, arms: &[Arm], at: At) -> Eval {
        let value = self.eval(of)?;
        for arm in arms {
            let is_it = self.binds(&arm.pattern, &value)?;
            if is_it && arm.guard.as_ref().map_or(Ok(true), |it| self.truth(it))? {
                return self.eval(&arm.body);
            }
        }
        let message = "non-exhaustive patterns: no arm matches this value";
        self.refused(Refusal::new(at, message, "", ""))
    }

    #[inline(never)]
    pub(super) fn bound(&mut self, pattern: &Pattern, value: &Node, other: Option<&Node>) -> Eval {
        let value = self.operand(value)?;
        match pattern {
            Pattern::Bind(slot) => {
                if let Some(notes) = &mut self.notes {
                    notes.push((self.function, Some(*slot), value.clone()));
                }
                let slot = self.base + slot;
                self.stack[slot] = value;
            }
            pattern => {
                if !self.binds(pattern, &value)?
                    && let Some(other) = other
                {
                    self.eval(other)?;
                }
            }
        }
        Ok(Value::default())
    }
}

/// A part of a value behind a reference is behind one, too.
fn part(value: &Value, whole: &Value, n: usize) -> Value {
    match &value.data {
        Data::Mut(address) => Data::Mut(address.part(n)).into(),
        _ => whole.part(n).more_lent(whole.lent.min(1)),
    }
}
