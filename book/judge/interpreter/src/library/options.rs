//! Options and boxes.

use std::rc::Rc;

use super::library;
use crate::machine::value::{Data, Value};
use crate::machine::{Eval, Machine};
use crate::refusal::Span;
use crate::types::Ctor::{self, Unknown};
use crate::types::Type;

/// Calls a function that must come to an option.
pub(super) fn chosen(m: &mut Machine<'_>, f: &Value, given: &mut [Value], at: Span) -> Eval {
    let value = m.applied(f, given, at)?;
    m.as_declared(value, &Type::of(Ctor::Option, Type::UNKNOWN), at.into())
}

/// Returns the value with one `&` less, if it has one.
pub(super) fn copied(value: Value) -> Value {
    Value {
        lent: value.lent.saturating_sub(1),
        ..value
    }
}

/// Returns the value inside of `Some`, without the `&` of the option itself.
fn inside(value: &Value) -> Option<Value> {
    match &value.data {
        Data::Some(it) => Some((**it).clone()),
        _ => None,
    }
}

library! { table:
    [Ctor::Option] {
        is_some self () => |_, a, _| Ok(inside(&a[0]).is_some().into());
        is_none self () => |_, a, _| Ok(inside(&a[0]).is_none().into());
        is_some_and self (Type::function(1)) => |m, a, at| match inside(&a[0]) {
            Some(it) => Ok(m.asked(&a[1], &mut [it], at)?.into()),
            None => Ok(false.into()),
        };
        is_none_or self (Type::function(1)) => |m, a, at| match inside(&a[0]) {
            Some(it) => Ok(m.asked(&a[1], &mut [it], at)?.into()),
            None => Ok(true.into()),
        };
        unwrap self () => |m, a, at| match inside(&a[0]) {
            Some(it) => Ok(it),
            None => m.panic(at, "called `Option::unwrap()` on a `None` value"),
        };
        expect self (Type::of(Ctor::Ref, Ctor::Str.into())) => |m, a, at| match inside(&a[0]) {
            Some(it) => Ok(it),
            None => m.panic(at, "called `Option::expect()` on a `None` value"),
        };
        unwrap_or self (Unknown) => |_, a, _| Ok(inside(&a[0]).unwrap_or_else(|| a[1].clone()));
        unwrap_or_else self (Type::function(0)) => |m, a, at| match inside(&a[0]) {
            Some(it) => Ok(it),
            None => m.applied(&a[1], &mut [], at),
        };
        map self (Type::function(1)) => |m, a, at| match inside(&a[0]) {
            Some(it) => Ok(Some(m.applied(&a[1], &mut [it], at)?).into()),
            None => Ok(None.into()),
        };
        map_or self (Unknown, Type::function(1)) => |m, a, at| match inside(&a[0]) {
            Some(it) => m.applied(&a[2], &mut [it], at),
            None => Ok(a[1].clone()),
        };
        map_or_else self (Type::function(0), Type::function(1)) => |m, a, at| match inside(&a[0]) {
            Some(it) => m.applied(&a[2], &mut [it], at),
            None => m.applied(&a[1], &mut [], at),
        };
        and_then self (Type::function(1)) => |m, a, at| match inside(&a[0]) {
            Some(it) => chosen(m, &a[1], &mut [it], at),
            None => Ok(None.into()),
        };
        filter self (Type::function(1)) => |m, a, at| match inside(&a[0]) {
            Some(it) if m.asked(&a[1], &mut [it.clone().lent()], at)? => Ok(Some(it).into()),
            _ => Ok(None.into()),
        };
        or self (Type::of(Ctor::Option, Type::UNKNOWN)) =>
            |_, a, _| Ok(inside(&a[0]).or_else(|| inside(&a[1])).into());
        or_else self (Type::function(0)) => |m, a, at| match inside(&a[0]) {
            Some(it) => Ok(Some(it).into()),
            None => chosen(m, &a[1], &mut [], at),
        };
        zip self (Type::of(Ctor::Option, Type::UNKNOWN)) => |_, a, _| {
            let both = inside(&a[0]).zip(inside(&a[1]));
            Ok(both.map(|(one, other)| Value::tuple([one, other])).into())
        };
        as_ref self () => |_, a, _| Ok(inside(&a[0]).map(Value::lent).into());
        copied self () => |_, a, _| Ok(inside(&a[0]).map(copied).into());
        cloned self () => |_, a, _| Ok(inside(&a[0]).map(copied).into());
        take mut () => |m, a, _| {
            let before = m.end_of(&a[0]);
            m.change(&a[0], |it| *it = None.into());
            Ok(before.owned())
        };
    }
    [Ctor::Box] {
        new _ (Unknown) => |m, a, at| {
            m.keep(&a[0], at)?;
            Ok(Data::Box(Rc::new(a[0].clone())).into())
        };
        as_ref self () => |_, a, _| Ok(a[0].part(0).owned().lent());
        clone self () => |_, a, _| Ok(a[0].clone().owned());
    }
}
