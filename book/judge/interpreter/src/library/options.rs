//! Options and boxes.

use std::rc::Rc;

use super::{Native, library};
use crate::host::{Eval, Host};
use crate::refusal::At;
use crate::types::{Head, Type};
use crate::value::{Data, Value};

/// What a function comes to, which is an option.
fn chosen(host: &mut dyn Host, f: &Value, given: &mut [Value], at: At) -> Eval {
    let value = host.apply(f, given, at)?;
    host.declared(value, &Type::of(Head::Option, Type::UNKNOWN), at)
}

fn option(value: Option<Value>) -> Eval {
    Ok(value.into())
}

/// The value behind one reference.
fn copied(value: Value) -> Value {
    Value {
        lent: value.lent.saturating_sub(1),
        ..value
    }
}

/// What an option has, without that of the reference to it.
fn inside(value: &Value) -> Option<Value> {
    match &value.data {
        Data::Some(it) => Some((**it).clone()),
        _ => None,
    }
}

pub(super) static TABLE: &[Native] = library! {
    OPTION {
        is_some self () => |_, a, _| Ok(inside(&a[0]).is_some().into());
        is_none self () => |_, a, _| Ok(inside(&a[0]).is_none().into());
        is_some_and self (Fn(1)) => |host, a, at| match inside(&a[0]) {
            Some(it) => Ok(host.asked(&a[1], &mut [it], at)?.into()),
            None => Ok(false.into()),
        };
        is_none_or self (Fn(1)) => |host, a, at| match inside(&a[0]) {
            Some(it) => Ok(host.asked(&a[1], &mut [it], at)?.into()),
            None => Ok(true.into()),
        };
        unwrap self () => |host, a, at| match inside(&a[0]) {
            Some(it) => Ok(it),
            None => host.panic(at, "called `Option::unwrap()` on a `None` value"),
        };
        expect self (Str) => |host, a, at| match inside(&a[0]) {
            Some(it) => Ok(it),
            None => host.panic(at, "called `Option::expect()` on a `None` value"),
        };
        unwrap_or self (Any) => |_, a, _| Ok(inside(&a[0]).unwrap_or_else(|| a[1].clone()));
        unwrap_or_else self (Fn(0)) => |host, a, at| match inside(&a[0]) {
            Some(it) => Ok(it),
            None => host.apply(&a[1], &mut [], at),
        };
        map self (Fn(1)) => |host, a, at| match inside(&a[0]) {
            Some(it) => option(Some(host.apply(&a[1], &mut [it], at)?)),
            None => option(None),
        };
        map_or self (Any, Fn(1)) => |host, a, at| match inside(&a[0]) {
            Some(it) => host.apply(&a[2], &mut [it], at),
            None => Ok(a[1].clone()),
        };
        map_or_else self (Fn(0), Fn(1)) => |host, a, at| match inside(&a[0]) {
            Some(it) => host.apply(&a[2], &mut [it], at),
            None => host.apply(&a[1], &mut [], at),
        };
        and_then self (Fn(1)) => |host, a, at| match inside(&a[0]) {
            Some(it) => chosen(host, &a[1], &mut [it], at),
            None => option(None),
        };
        filter self (Fn(1)) => |host, a, at| match inside(&a[0]) {
            Some(it) if host.asked(&a[1], &mut [it.clone().lent()], at)? => option(Some(it)),
            _ => option(None),
        };
        or self (Option) => |_, a, _| option(inside(&a[0]).or_else(|| inside(&a[1])));
        or_else self (Fn(0)) => |host, a, at| match inside(&a[0]) {
            Some(it) => option(Some(it)),
            None => chosen(host, &a[1], &mut [], at),
        };
        zip self (Option) => |_, a, _| {
            let both = inside(&a[0]).zip(inside(&a[1]));
            option(both.map(|(one, other)| Data::Tuple([one, other].into()).into()))
        };
        as_ref self () => |_, a, _| option(inside(&a[0]).map(Value::lent));
        copied self () => |_, a, _| option(inside(&a[0]).map(copied));
        cloned self () => |_, a, _| option(inside(&a[0]).map(copied));
        take mut () => |host, a, _| {
            let before = host.followed(&a[0]);
            host.change(&a[0], &mut |it| *it = None.into());
            Ok(before.owned())
        };
        iter self () => |_, a, _| {
            let all = inside(&a[0]).map(Value::lent).into_iter().collect();
            Ok(Value::vector(all))
        };
    }
    BOX {
        new _ (Any) => |host, a, at| {
            host.keep(&a[0], at)?;
            Ok(Data::Box(Rc::new(a[0].clone())).into())
        };
        as_ref self () => |_, a, _| Ok(a[0].part(0).owned().lent());
        clone self () => |_, a, _| Ok(a[0].clone().owned());
    }
};
