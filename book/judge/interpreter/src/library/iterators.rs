//! Iterators: values one after the other, each made when it is asked for.

use std::rc::Rc;

use super::{Native, library};
use crate::host::{Eval, Host};
use crate::operators::Sign;
use crate::refusal::{At, Refusal};
use crate::types::{Head, Type};
use crate::value::{Data, Iter, Value};

/// What gives the values of a list or a range, one after the other.
pub(crate) fn iterator(host: &mut dyn Host, of: &Value, at: At) -> Eval<Iter> {
    Ok(match &of.data {
        Data::List(list) => Iter::List(Rc::clone(list), 0, list.all.len(), of.lent.min(1)),
        Data::Range(ends, is_closed) if of.lent == 0 => match (&ends[0].data, &ends[1].data) {
            (Data::Int(from, int), Data::Int(to, other)) => {
                let int = int.joined(*other).unwrap_or(*int);
                Iter::Range(from.get(), to.get() + i128::from(*is_closed), int)
            }
            (Data::Int(from, int), Data::Unit) => Iter::Range(from.get(), int.ends().1, *int),
            _ => return no_iterator(host, of, at),
        },
        Data::Iter(it) => Iter::Shared(Rc::clone(it)),
        Data::Mut(address) => match &host.followed(of).data {
            Data::List(list) => Iter::Places(address.clone(), 0, list.all.len()),
            Data::Iter(it) => Iter::Shared(Rc::clone(it)),
            _ => return no_iterator(host, of, at),
        },
        _ => return no_iterator(host, of, at),
    })
}

fn no_iterator<T>(host: &mut dyn Host, of: &Value, at: At) -> Eval<T> {
    let refusal = match of.data {
        Data::Some(_) | Data::None => Refusal::unread(at, "loops over an `Option`"),
        _ => {
            let message = format!("{} is not an iterator", host.said(of));
            Refusal::new(at, message, "", "")
        }
    };
    Err(host.refuse(refusal))
}

/// The next value.
pub(crate) fn next(host: &mut dyn Host, each: &mut Iter, at: At) -> Eval<Option<Value>> {
    Ok(match each {
        Iter::List(list, from, to, lent) => {
            let value = (*from < *to).then(|| list.all[*from].clone().more_lent(*lent));
            *from += 1;
            value
        }
        Iter::Places(list, from, to) => {
            let value = (*from < *to).then(|| Data::Mut(list.part(*from)).into());
            *from += 1;
            value
        }
        Iter::Range(from, to, int) => {
            let is_there = *from < *to;
            *from += i128::from(is_there);
            is_there.then(|| Value::whole(*from - 1, *int))
        }
        Iter::Rev(of) => last(host, of, at)?,
        Iter::Shared(it) => {
            let it = Rc::clone(it);
            let mut it = it.borrow_mut();
            next(host, &mut it, at)?
        }
        Iter::Map(..) | Iter::Filter(..) | Iter::FilterMap(..) => by_function(host, each, at)?,
        _ => by_number(host, each, at)?,
    })
}

/// The next value that a function makes or chooses.
fn by_function(host: &mut dyn Host, each: &mut Iter, at: At) -> Eval<Option<Value>> {
    Ok(match each {
        Iter::Map(of, f) => match next(host, of, at)? {
            Some(it) => Some(host.apply(f, &mut [it], at)?),
            None => None,
        },
        Iter::Filter(of, f) => loop {
            match next(host, of, at)? {
                Some(it) if host.asked(f, &mut [it.clone().lent()], at)? => break Some(it),
                Some(_) => host.turn(at)?,
                None => break None,
            }
        },
        Iter::FilterMap(of, f) => loop {
            let Some(it) = next(host, of, at)? else {
                break None;
            };
            host.turn(at)?;
            let it = host.apply(f, &mut [it], at)?;
            let it = host.declared(it, &Type::of(Head::Option, Type::UNKNOWN), at)?;
            if let Some(it) = it.option() {
                break Some(it);
            }
        },
        _ => None,
    })
}

/// The next value of those that are counted, or come from two.
fn by_number(host: &mut dyn Host, each: &mut Iter, at: At) -> Eval<Option<Value>> {
    Ok(match each {
        Iter::Copied(of) => next(host, of, at)?.map(|it| Value {
            lent: it.lent.saturating_sub(1),
            ..it
        }),
        Iter::Enumerate(of, n) => next(host, of, at)?.map(|it| {
            *n += 1;
            Data::Tuple([Value::usize(*n - 1), it].into()).into()
        }),
        Iter::Zip(both) => {
            let [one, other] = &mut **both;
            match next(host, one, at)? {
                Some(one) => {
                    next(host, other, at)?.map(|other| Data::Tuple([one, other].into()).into())
                }
                None => None,
            }
        }
        Iter::Chain(both) => {
            let [one, other] = &mut **both;
            match next(host, one, at)? {
                Some(it) => Some(it),
                None => next(host, other, at)?,
            }
        }
        Iter::Take(_, 0) => None,
        Iter::Take(of, left) => {
            *left -= 1;
            next(host, of, at)?
        }
        Iter::Skip(of, left) => {
            while *left > 0 {
                *left -= 1;
                host.turn(at)?;
                next(host, of, at)?;
            }
            next(host, of, at)?
        }
        Iter::StepBy(of, step, has_begun) => {
            for _ in 1..if *has_begun { *step } else { 1 } {
                next(host, of, at)?;
            }
            *has_begun = true;
            next(host, of, at)?
        }
        _ => None,
    })
}

/// The last value that is left.
fn last(host: &mut dyn Host, each: &mut Iter, at: At) -> Eval<Option<Value>> {
    Ok(match each {
        Iter::List(list, from, to, lent) => (*from < *to).then(|| {
            *to -= 1;
            list.all[*to].clone().more_lent(*lent)
        }),
        Iter::Range(from, to, int) => (*from < *to).then(|| {
            *to -= 1;
            Value::whole(*to, *int)
        }),
        Iter::Rev(of) => next(host, of, at)?,
        Iter::Map(of, f) => match last(host, of, at)? {
            Some(it) => Some(host.apply(f, &mut [it], at)?),
            None => None,
        },
        // What else there is is listed first.
        other => {
            let all = rest(host, other, at)?;
            let count = all.len();
            let list = Value::vector(all).list();
            *other = Iter::List(list, 0, count, 0);
            last(host, other, at)?
        }
    })
}

fn rest(host: &mut dyn Host, each: &mut Iter, at: At) -> Eval<Vec<Value>> {
    let mut all = Vec::new();
    while let Some(value) = next(host, each, at)? {
        host.turn(at)?;
        host.take(value.size(), at)?;
        all.push(value);
    }
    Ok(all)
}

/// The first value of which the function says that, and its number.
fn found(
    host: &mut dyn Host,
    a: &[Value],
    (lent, wanted): (u8, bool),
    at: At,
) -> Eval<Option<(usize, Value)>> {
    let mut each = iterator(host, &a[0], at)?;
    let mut n = 0;
    while let Some(value) = next(host, &mut each, at)? {
        host.turn(at)?;
        if host.asked(&a[1], &mut [value.clone().more_lent(lent)], at)? == wanted {
            return Ok(Some((n, value)));
        }
        n += 1;
    }
    Ok(None)
}

/// The value that is on that side of all others, of equal ones the first or the last.
fn extreme(host: &mut dyn Host, a: &[Value], is_least: bool, at: At) -> Eval {
    let mut each = iterator(host, &a[0], at)?;
    let mut best: Option<Value> = None;
    while let Some(value) = next(host, &mut each, at)? {
        host.turn(at)?;
        let is_better = match &best {
            None => true,
            Some(best) => {
                let given = &mut [best.clone().lent(), value.clone().lent()];
                let order = host.apply(&a[1], given, at)?;
                let order = host.declared(order, &Head::Ordering.into(), at)?.ordering();
                if is_least {
                    order.is_gt()
                } else {
                    order.is_le()
                }
            }
        };
        if is_better {
            best = Some(value);
        }
    }
    Ok(best.into())
}

/// What all values come to, one after the other, from a beginning.
fn folded(host: &mut dyn Host, each: &mut Iter, start: Value, f: &Value, at: At) -> Eval {
    let mut sum = start;
    while let Some(value) = next(host, each, at)? {
        host.turn(at)?;
        sum = host.apply(f, &mut [sum, value], at)?;
    }
    Ok(sum)
}

/// The sum or the product of all values.
fn total(host: &mut dyn Host, of: &Value, sign: Sign, at: At) -> Eval {
    let mut each = iterator(host, of, at)?;
    let mut total: Option<Value> = None;
    while let Some(value) = next(host, &mut each, at)? {
        host.turn(at)?;
        total = Some(match total {
            None => value.owned(),
            Some(total) => host.arithmetic(sign, total, value, at)?,
        });
    }
    // Of nothing, only what it is declared to be would say which zero.
    let nothing = match sign {
        Sign::Plus => -0.0,
        _ => 1.0,
    };
    Ok(total.unwrap_or_else(|| nothing.into()))
}

/// An iterator that is made of another.
fn made(host: &mut dyn Host, of: &Value, at: At, make: impl FnOnce(Box<Iter>) -> Iter) -> Eval {
    let of = iterator(host, of, at)?;
    Ok(Value::iter(make(Box::new(of))))
}

pub(super) static TABLE: &[Native] = library! {
    ITERATOR {
        into_iter self () => |host, a, at| Ok(Value::iter(iterator(host, &a[0], at)?));
        iter self () => |host, a, at| Ok(Value::iter(iterator(host, &a[0], at)?));
        by_ref self () => |host, a, at| Ok(Value::iter(iterator(host, &a[0], at)?));
        next self () => |host, a, at| {
            let mut each = iterator(host, &a[0], at)?;
            Ok(next(host, &mut each, at)?.into())
        };
        map self (Fn(1)) => |host, a, at| {
            let f = Rc::new(a[1].clone());
            made(host, &a[0], at, |it| Iter::Map(it, f))
        };
        filter self (Fn(1)) => |host, a, at| {
            let f = Rc::new(a[1].clone());
            made(host, &a[0], at, |it| Iter::Filter(it, f))
        };
        filter_map self (Fn(1)) => |host, a, at| {
            let f = Rc::new(a[1].clone());
            made(host, &a[0], at, |it| Iter::FilterMap(it, f))
        };
        enumerate self () => |host, a, at| made(host, &a[0], at, |it| Iter::Enumerate(it, 0));
        rev self () => |host, a, at| made(host, &a[0], at, Iter::Rev);
        copied self () => |host, a, at| made(host, &a[0], at, Iter::Copied);
        cloned self () => |host, a, at| made(host, &a[0], at, Iter::Copied);
        take self (Usize) => |host, a, at| {
            let count = a[1].int();
            made(host, &a[0], at, |it| Iter::Take(it, count))
        };
        skip self (Usize) => |host, a, at| {
            let count = a[1].int();
            made(host, &a[0], at, |it| Iter::Skip(it, count))
        };
        step_by self (Usize) => |host, a, at| {
            let step = a[1].int();
            made(host, &a[0], at, |it| Iter::StepBy(it, step, false))
        };
        zip self (Any) => |host, a, at| {
            let other = iterator(host, &a[1], at)?;
            made(host, &a[0], at, |it| Iter::Zip(Box::new([*it, other])))
        };
        chain self (Any) => |host, a, at| {
            let other = iterator(host, &a[1], at)?;
            made(host, &a[0], at, |it| Iter::Chain(Box::new([*it, other])))
        };
        find self (Fn(1)) => |host, a, at| {
            Ok(found(host, a, (1, true), at)?.map(|it| it.1).into())
        };
        find_map self (Fn(1)) => |host, a, at| {
            let f = Rc::new(a[1].clone());
            let of = iterator(host, &a[0], at)?;
            Ok(next(host, &mut Iter::FilterMap(Box::new(of), f), at)?.into())
        };
        position self (Fn(1)) => |host, a, at| {
            Ok(found(host, a, (0, true), at)?.map(|it| Value::usize(it.0)).into())
        };
        any self (Fn(1)) => |host, a, at| Ok(found(host, a, (0, true), at)?.is_some().into());
        all self (Fn(1)) => |host, a, at| Ok(found(host, a, (0, false), at)?.is_none().into());
        fold self (Any, Fn(2)) => |host, a, at| {
            let mut each = iterator(host, &a[0], at)?;
            folded(host, &mut each, a[1].clone(), &a[2], at)
        };
        reduce self (Fn(2)) => |host, a, at| {
            let mut each = iterator(host, &a[0], at)?;
            Ok(match next(host, &mut each, at)? {
                Some(first) => Some(folded(host, &mut each, first, &a[1], at)?),
                None => None,
            }
            .into())
        };
        for_each self (Fn(1)) => |host, a, at| {
            let mut each = iterator(host, &a[0], at)?;
            while let Some(value) = next(host, &mut each, at)? {
                host.turn(at)?;
                host.apply(&a[1], &mut [value], at)?;
            }
            Ok(Value::default())
        };
        min_by self (Fn(2)) => |host, a, at| extreme(host, a, true, at);
        max_by self (Fn(2)) => |host, a, at| extreme(host, a, false, at);
        sum self () => |host, a, at| total(host, &a[0], Sign::Plus, at);
        product self () => |host, a, at| total(host, &a[0], Sign::Times, at);
        count self () => |host, a, at| {
            let mut each = iterator(host, &a[0], at)?;
            Ok(Value::usize(rest(host, &mut each, at)?.len()))
        };
        last self () => |host, a, at| {
            let mut each = iterator(host, &a[0], at)?;
            Ok(rest(host, &mut each, at)?.pop().into())
        };
        collect self () => |host, a, at| {
            let mut each = iterator(host, &a[0], at)?;
            Ok(Value::vector(rest(host, &mut each, at)?))
        };
    }
    RANGE {
        contains self (Any) => |_, a, _| {
            let Data::Range(ends, is_closed) = &a[0].data else {
                unreachable!("types are checked");
            };
            let is_after = ends[0].compared(&a[1]).is_some_and(std::cmp::Ordering::is_le);
            let is_before = match a[1].compared(&ends[1]) {
                Some(order) => order.is_lt() || *is_closed && order.is_eq(),
                None => matches!(ends[1].data, Data::Unit),
            };
            Ok((is_after && is_before).into())
        };
    }
};
