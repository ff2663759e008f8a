//! Vectors, arrays and slices.

use std::rc::Rc;

use super::iterators::{iterator, next};
use super::{Native, library};
use crate::host::{Eval, Host};
use crate::refusal::{At, Refusal};
use crate::types::Type;
use crate::value::{Data, Iter, List, Value};

/// Adds values to a list that is changed in its place.
fn added(host: &mut dyn Host, to: &Value, all: Vec<Value>, at: At) -> Eval {
    let (mut of, mut first) = (Type::UNKNOWN, None);
    host.change(to, &mut |it| {
        if let Data::List(list) = &it.data {
            of = list.of.clone();
            first = list.all.first().cloned();
        }
    });
    let mut checked = Vec::new();
    for value in all {
        let value = host.declared(value, &of, at)?;
        if let Some(first) = &first
            && !value.is_like(first)
        {
            let label = format!("expected {}, found {}", host.said(first), host.said(&value));
            return Err(host.refuse(Refusal::new(at, "mismatched types", &label, "")));
        }
        host.keep(&value, at)?;
        first.get_or_insert_with(|| value.clone());
        checked.push(value);
    }
    host.change(to, &mut |it| {
        if let Data::List(list) = &mut it.data {
            Rc::make_mut(list).all.append(&mut checked);
        }
    });
    Ok(Value::default())
}

fn list(value: &Value) -> Rc<List> {
    value.list()
}

pub(super) static TABLE: &[Native] = library! {
    VEC {
        new _ () => |_, _, _| Ok(Value::vector(Vec::new()));
        with_capacity _ (Usize) => |_, _, _| Ok(Value::vector(Vec::new()));
        push mut (Any) => |host, a, at| {
            let value = std::mem::take(&mut a[1]);
            added(host, &a[0], vec![value], at)
        };
        extend mut (Any) => |host, a, at| {
            let mut each = iterator(host, &a[1], at)?;
            let mut all = Vec::new();
            while let Some(value) = next(host, &mut each, at)? {
                host.turn(at)?;
                all.push(value);
            }
            added(host, &a[0], all, at)
        };
        pop mut () => |host, a, _| {
            let mut last = None;
            host.change(&a[0], &mut |it| {
                if let Data::List(list) = &mut it.data {
                    last = Rc::make_mut(list).all.pop();
                }
            });
            Ok(last.into())
        };
        clear mut () => |host, a, _| {
            host.change(&a[0], &mut |it| {
                if let Data::List(list) = &mut it.data {
                    Rc::make_mut(list).all.clear();
                }
            });
            Ok(Value::default())
        };
    }
    LIST {
        len self () => |_, a, _| Ok(Value::usize(list(&a[0]).all.len()));
        is_empty self () => |_, a, _| Ok(list(&a[0]).all.is_empty().into());
        first self () => |_, a, _| Ok(list(&a[0]).all.first().cloned().map(Value::lent).into());
        last self () => |_, a, _| Ok(list(&a[0]).all.last().cloned().map(Value::lent).into());
        get self (Usize) => |_, a, _| {
            let part = list(&a[0]).all.get(a[1].int() as usize).cloned();
            Ok(part.map(Value::lent).into())
        };
        iter self () => |_, a, _| {
            let list = list(&a[0]);
            let count = list.all.len();
            Ok(Value::iter(Iter::List(list, 0, count, 1)))
        };
        iter_mut mut () => |host, a, at| Ok(Value::iter(iterator(host, &a[0], at)?));
        into_iter self () => |host, a, at| Ok(Value::iter(iterator(host, &a[0], at)?));
        to_vec self () => |_, a, _| Ok(Value::vector(list(&a[0]).all.clone()));
        contains self (Any) => |_, a, _| {
            Ok(list(&a[0]).all.iter().any(|it| it.equals(&a[1])).into())
        };
    }
    ARRAY {
        map self (Fn(1)) => |host, a, at| {
            let mut all = Vec::new();
            for value in &list(&a[0]).all {
                host.turn(at)?;
                all.push(host.apply(&a[1], &mut [value.clone()], at)?);
            }
            host.take(all.len() * size_of::<Value>(), at)?;
            Ok(Value::array(all))
        };
    }
};
