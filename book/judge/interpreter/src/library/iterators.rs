//! Iterators: values one after the other, each made when it is asked for.

use std::rc::Rc;

use super::library;
use super::options::{chosen, copied};
use crate::machine::iter::Iter;
use crate::machine::value::{Data, Value};
use crate::machine::{Eval, Machine};
use crate::operators::ArithOp;
use crate::refusal::Span;
use crate::types::Ctor::{self, Unknown};
use crate::types::{Int, Type};

/// The type `usize`.
const USIZE: Ctor = Ctor::Int(Int::Usize);

/// Makes an iterator over a list, a range, another iterator or a mutable reference to a list or an
/// iterator; stops at any other value.
pub(crate) fn iterator(m: &mut Machine<'_>, of: &Value, at: Span) -> Eval<Iter> {
    Ok(match &of.data {
        Data::List(list) => Iter::List(Rc::clone(list), 0, of.lent.min(1)),
        Data::Range(ends, is_closed) if of.lent == 0 => match (&ends[0].data, &ends[1].data) {
            (Data::Int(from, int), Data::Int(to, other)) => {
                let int = int.joined(*other).unwrap_or(*int);
                numbered(from.get(), to.get() + i128::from(*is_closed), int)
            }
            (Data::Int(from, int), Data::Unit) => numbered(from.get(), int.ends().1, *int),
            _ => return no_iterator(m, of, at),
        },
        Data::Iter(it) => Iter::Shared(Rc::clone(it)),
        Data::Mut(address) => match m.end_of(of).data {
            Data::List(list) => {
                let (address, count, mut n) = (address.clone(), list.all.len(), 0);
                Iter::new(move |_| {
                    n += 1;
                    Ok((n <= count).then(|| Data::Mut(address.part(n - 1)).into()))
                })
            }
            Data::Iter(it) => Iter::Shared(it),
            _ => return no_iterator(m, of, at),
        },
        _ => return no_iterator(m, of, at),
    })
}

/// Makes an iterator over the numbers from `from` to before `to`.
fn numbered(from: i128, to: i128, int: Int) -> Iter {
    let mut numbers = from..to;
    Iter::new(move |_| Ok(numbers.next().map(|it| Value::whole(it, int))))
}

/// Stops since a value can't be iterated over.
fn no_iterator<T>(m: &mut Machine<'_>, of: &Value, at: Span) -> Eval<T> {
    match of.data {
        Data::Some(_) | Data::None => m.unread(at, "loops over an `Option`"),
        _ => {
            let name = m.named(of);
            m.wrong(at, format!("`{name}` is not an iterator"), "")
        }
    }
}

/// Returns all values that an iterator has left, within the budget of memory.
pub(super) fn rest(m: &mut Machine<'_>, each: &mut Iter, at: Span) -> Eval<Vec<Value>> {
    let mut all = Vec::new();
    while let Some(value) = each.next(m)? {
        m.turn(at)?;
        m.take(value.size(), at)?;
        all.push(value);
    }
    Ok(all)
}

/// Returns the first value for which a predicate comes to `wanted`, and its number from 0. The
/// predicate gets the value with `lent` more `&`.
fn found(
    m: &mut Machine<'_>,
    a: &[Value],
    (lent, wanted): (u8, bool),
    at: Span,
) -> Eval<Option<(usize, Value)>> {
    let mut each = iterator(m, &a[0], at)?;
    let mut n = 0;
    while let Some(value) = each.next(m)? {
        m.turn(at)?;
        if m.asked(&a[1], &mut [value.clone().more_lent(lent)], at)? == wanted {
            return Ok(Some((n, value)));
        }
        n += 1;
    }
    Ok(None)
}

/// Returns the least or the greatest value by a comparison: of equal ones the first for the least,
/// the last for the greatest, as the standard library does.
fn extreme(m: &mut Machine<'_>, a: &[Value], is_least: bool, at: Span) -> Eval {
    let mut each = iterator(m, &a[0], at)?;
    let Some(mut best) = each.next(m)? else {
        return Ok(None.into());
    };
    while let Some(value) = each.next(m)? {
        m.turn(at)?;
        let given = &mut [best.clone().lent(), value.clone().lent()];
        let order = m.applied(&a[1], given, at)?;
        let order = m.as_declared(order, &Ctor::Ordering.into(), at.into())?;
        if order.ordering().is_gt() == is_least {
            best = value;
        }
    }
    Ok(Some(best).into())
}

/// Folds all values that an iterator has left into one, from `start`.
fn folded(m: &mut Machine<'_>, each: &mut Iter, start: Value, f: &Value, at: Span) -> Eval {
    let mut sum = start;
    while let Some(value) = each.next(m)? {
        m.turn(at)?;
        sum = m.applied(f, &mut [sum, value], at)?;
    }
    Ok(sum)
}

/// Returns the sum or the product of all values, added or multiplied from the first on.
fn total(m: &mut Machine<'_>, of: &Value, sign: ArithOp, at: Span) -> Eval {
    let mut each = iterator(m, of, at)?;
    let Some(first) = each.next(m)? else {
        // Of nothing, only what it is declared to be would say which zero.
        return Ok(if sign == ArithOp::Plus { -0.0 } else { 1.0 }.into());
    };
    let mut total = first.owned();
    while let Some(value) = each.next(m)? {
        m.turn(at)?;
        total = m.combined(sign, total, value, at)?;
    }
    Ok(total)
}

/// Makes an iterator from another: `next` computes each value of the new one with the old one at
/// hand.
fn made(
    m: &mut Machine<'_>,
    of: &Value,
    at: Span,
    mut next: impl FnMut(&mut Machine<'_>, &mut Iter) -> Eval<Option<Value>> + 'static,
) -> Eval {
    let mut of = iterator(m, of, at)?;
    Ok(Value::iter(Iter::new(move |m| next(m, &mut of))))
}

/// Makes an iterator from another: `choose` replaces each value, or leaves it out by `None`.
fn chosen_of(
    m: &mut Machine<'_>,
    of: &Value,
    at: Span,
    mut choose: impl FnMut(&mut Machine<'_>, Value) -> Eval<Option<Value>> + 'static,
) -> Eval {
    made(m, of, at, move |m, of| {
        while let Some(value) = of.next(m)? {
            if let Some(chosen) = choose(m, value)? {
                return Ok(Some(chosen));
            }
            m.turn(at)?;
        }
        Ok(None)
    })
}

library! { table:
    [Ctor::Range | Ctor::Iterator] {
        into_iter self () => |m, a, at| Ok(Value::iter(iterator(m, &a[0], at)?));
        iter self () => |m, a, at| Ok(Value::iter(iterator(m, &a[0], at)?));
        by_ref self () => |m, a, at| Ok(Value::iter(iterator(m, &a[0], at)?));
        next self () => |m, a, at| Ok(iterator(m, &a[0], at)?.next(m)?.into());
        map self (Type::function(1)) => |m, a, at| {
            let f = a[1].clone();
            chosen_of(m, &a[0], at, move |m, it| m.applied(&f, &mut [it], at).map(Some))
        };
        filter self (Type::function(1)) => |m, a, at| {
            let f = a[1].clone();
            chosen_of(m, &a[0], at, move |m, it| {
                Ok(m.asked(&f, &mut [it.clone().lent()], at)?.then_some(it))
            })
        };
        filter_map self (Type::function(1)) => |m, a, at| {
            let f = a[1].clone();
            chosen_of(m, &a[0], at, move |m, it| Ok(chosen(m, &f, &mut [it], at)?.option()))
        };
        copied self () => |m, a, at| chosen_of(m, &a[0], at, |_, it| Ok(Some(copied(it))));
        cloned self () => |m, a, at| chosen_of(m, &a[0], at, |_, it| Ok(Some(copied(it))));
        enumerate self () => |m, a, at| {
            let mut numbers = 0..;
            chosen_of(m, &a[0], at, move |_, it| {
                let number = numbers.next().map(Value::usize);
                Ok(number.map(|n| Value::tuple([n, it])))
            })
        };
        rev self () => |m, a, at| {
            let mut all = None;
            made(m, &a[0], at, move |m, of| {
                if all.is_none() {
                    all = Some(rest(m, of, at)?);
                }
                Ok(all.as_mut().and_then(Vec::pop))
            })
        };
        take self (USIZE) => |m, a, at| {
            let mut left = a[1].int();
            made(m, &a[0], at, move |m, of| {
                left -= 1;
                if left >= 0 { of.next(m) } else { Ok(None) }
            })
        };
        skip self (USIZE) => |m, a, at| {
            let mut left = a[1].int();
            chosen_of(m, &a[0], at, move |_, it| {
                left -= 1;
                Ok((left < 0).then_some(it))
            })
        };
        step_by self (USIZE) => |m, a, at| {
            let (step, mut n) = (a[1].int(), -1);
            if step == 0 {
                return m.panic(at, "assertion failed: step != 0");
            }
            chosen_of(m, &a[0], at, move |_, it| {
                n += 1;
                Ok((n % step == 0).then_some(it))
            })
        };
        zip self (Unknown) => |m, a, at| {
            let mut other = iterator(m, &a[1], at)?;
            made(m, &a[0], at, move |m, of| {
                let Some(one) = of.next(m)? else { return Ok(None) };
                Ok(other.next(m)?.map(|other| Value::tuple([one, other])))
            })
        };
        chain self (Unknown) => |m, a, at| {
            let mut other = iterator(m, &a[1], at)?;
            made(m, &a[0], at, move |m, of| match of.next(m)? {
                None => other.next(m),
                some => Ok(some),
            })
        };
        find self (Type::function(1)) => |m, a, at| {
            Ok(found(m, a, (1, true), at)?.map(|it| it.1).into())
        };
        find_map self (Type::function(1)) => |m, a, at| {
            let mut each = iterator(m, &a[0], at)?;
            while let Some(value) = each.next(m)? {
                m.turn(at)?;
                let value = chosen(m, &a[1], &mut [value], at)?;
                if matches!(value.data, Data::Some(_)) {
                    return Ok(value);
                }
            }
            Ok(None.into())
        };
        position self (Type::function(1)) => |m, a, at| {
            Ok(found(m, a, (0, true), at)?.map(|it| Value::usize(it.0)).into())
        };
        any self (Type::function(1)) => |m, a, at| Ok(found(m, a, (0, true), at)?.is_some().into());
        all self (Type::function(1)) => |m, a, at| Ok(found(m, a, (0, false), at)?.is_none().into());
        fold self (Unknown, Type::function(2)) => |m, a, at| {
            let mut each = iterator(m, &a[0], at)?;
            folded(m, &mut each, a[1].clone(), &a[2], at)
        };
        reduce self (Type::function(2)) => |m, a, at| {
            let mut each = iterator(m, &a[0], at)?;
            match each.next(m)? {
                Some(first) => Ok(Some(folded(m, &mut each, first, &a[1], at)?).into()),
                None => Ok(None.into()),
            }
        };
        for_each self (Type::function(1)) => |m, a, at| {
            let mut each = iterator(m, &a[0], at)?;
            while let Some(value) = each.next(m)? {
                m.turn(at)?;
                m.applied(&a[1], &mut [value], at)?;
            }
            Ok(Value::default())
        };
        min_by self (Type::function(2)) => |m, a, at| extreme(m, a, true, at);
        max_by self (Type::function(2)) => |m, a, at| extreme(m, a, false, at);
        sum self () => |m, a, at| total(m, &a[0], ArithOp::Plus, at);
        product self () => |m, a, at| total(m, &a[0], ArithOp::Times, at);
        count self () => |m, a, at| {
            let mut each = iterator(m, &a[0], at)?;
            Ok(Value::usize(rest(m, &mut each, at)?.len()))
        };
        last self () => |m, a, at| {
            let mut each = iterator(m, &a[0], at)?;
            Ok(rest(m, &mut each, at)?.pop().into())
        };
        collect self () => |m, a, at| {
            let mut each = iterator(m, &a[0], at)?;
            Ok(Value::vector(rest(m, &mut each, at)?))
        };
    }
    [Ctor::Range] {
        contains self (Unknown) => |_, a, _| {
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
}
