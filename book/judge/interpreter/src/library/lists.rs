//! Vectors, arrays and slices.

use std::rc::Rc;

use super::iterators::{iterator, rest};
use super::library;
use crate::machine::value::{Data, Value};
use crate::machine::{Eval, Machine};
use crate::refusal::Span;
use crate::types::Ctor::{self, Unknown};
use crate::types::{Int, Type};

/// Appends values to the list behind a mutable reference, and stops at one of another type.
fn added(m: &mut Machine<'_>, to: &Value, all: Vec<Value>, at: Span) -> Eval {
    let list = m.end_of(to).list();
    let (of, mut first) = (list.of.clone(), list.all.first().cloned());
    drop(list);
    let mut checked = Vec::new();
    for value in all {
        let value = m.as_declared(value, &of, at.into())?;
        if let Some(first) = &first {
            m.must_be_like(&value, first, at.into())?;
        }
        m.keep(&value, at)?;
        first.get_or_insert_with(|| value.clone());
        checked.push(value);
    }
    changed(m, to, |list| list.append(&mut checked));
    Ok(Value::default())
}

/// Changes the list behind a mutable reference in its place.
fn changed(m: &mut Machine<'_>, list: &Value, mut change: impl FnMut(&mut Vec<Value>)) {
    m.change(list, |it| {
        if let Data::List(list) = &mut it.data {
            change(&mut Rc::make_mut(list).all);
        }
    });
}

library! { table:
    [Ctor::Vec] {
        new _ () => |_, _, _| Ok(Value::vector(Vec::new()));
        with_capacity _ (Ctor::Int(Int::Usize)) => |_, _, _| Ok(Value::vector(Vec::new()));
        push mut (Unknown) => |m, a, at| {
            let value = std::mem::take(&mut a[1]);
            added(m, &a[0], vec![value], at)
        };
        extend mut (Unknown) => |m, a, at| {
            let mut each = iterator(m, &a[1], at)?;
            let all = rest(m, &mut each, at)?;
            added(m, &a[0], all, at)
        };
        pop mut () => |m, a, _| {
            let mut last = None;
            changed(m, &a[0], |list| last = list.pop());
            Ok(last.into())
        };
        clear mut () => |m, a, _| {
            changed(m, &a[0], Vec::clear);
            Ok(Value::default())
        };
    }
    [Ctor::Vec | Ctor::Array(_) | Ctor::Slice] {
        len self () => |_, a, _| Ok(Value::usize(a[0].list().all.len()));
        is_empty self () => |_, a, _| Ok(a[0].list().all.is_empty().into());
        first self () => |_, a, _| Ok(a[0].list().all.first().cloned().map(Value::lent).into());
        last self () => |_, a, _| Ok(a[0].list().all.last().cloned().map(Value::lent).into());
        get self (Ctor::Int(Int::Usize)) => |_, a, _| {
            let part = a[0].list().all.get(a[1].int() as usize).cloned();
            Ok(part.map(Value::lent).into())
        };
        iter self () => |m, a, at| {
            let list = a[0].clone().owned().lent();
            Ok(Value::iter(iterator(m, &list, at)?))
        };
        iter_mut mut () => |m, a, at| Ok(Value::iter(iterator(m, &a[0], at)?));
        into_iter self () => |m, a, at| Ok(Value::iter(iterator(m, &a[0], at)?));
        to_vec self () => |_, a, _| Ok(Value::vector(a[0].list().all.clone()));
        contains self (Unknown) => |_, a, _| {
            Ok(a[0].list().all.iter().any(|it| it.equals(&a[1])).into())
        };
    }
    [Ctor::Array(_)] {
        map self (Type::function(1)) => |m, a, at| {
            let mut all = Vec::new();
            for value in &a[0].list().all {
                m.turn(at)?;
                all.push(m.applied(&a[1], &mut [value.clone()], at)?);
            }
            m.take(all.len() * size_of::<Value>(), at)?;
            Ok(Value::array(all))
        };
    }
}
