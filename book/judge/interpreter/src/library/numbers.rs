//! Numbers: floats of both kinds, integers, truth and order.

use std::cmp::Ordering;

use super::{Native, library};
use crate::host::Eval;
use crate::refusal::Refusal;
use crate::types::Int;
use crate::value::{Data, Value};

/// A number or a truth.
fn plain(value: impl Into<Value>) -> Eval {
    Ok(value.into())
}

fn order(value: Ordering) -> Eval {
    Ok(Data::Ordering(value).into())
}

/// Functions of one number or two that come to a number, or to a truth.
macro_rules! floats {
    (
        { $($one:ident)* } { $($two:ident)* } { $($is:ident)* } { $($rest:tt)* }
        { $($single:ident)* } { $($singles:ident)* }
    ) => {
        library! {
            F64 {
                $($one self () => |_, a, _| plain(a[0].float().$one());)*
                $($two self (Own) => |_, a, _| plain(a[0].float().$two(a[1].float()));)*
                $($is self () => |_, a, _| plain(a[0].float().$is());)*
                $($rest)*
            }
            F32 {
                $($single self () => |_, a, _| match a[0].data {
                    Data::Single(it) => Ok(Data::Single(it.$single()).into()),
                    _ => unreachable!("types are checked"),
                };)*
                $($singles self (Own) => |_, a, _| match (&a[0].data, &a[1].data) {
                    (Data::Single(one), Data::Single(other)) => {
                        Ok(Data::Single(one.$singles(*other)).into())
                    }
                    _ => Ok(a[0].clone()),
                };)*
                from _ (Any) => |host, a, at| match a[0].data {
                    Data::Single(it) => Ok(Data::Single(it).into()),
                    Data::Int(it, Int::U8 | Int::U16 | Int::Any) => {
                        Ok(Data::Single(it.get() as f32).into())
                    }
                    _ => no_conversion(host, "f32", &a[0], at),
                };
                powi self (I32) => |_, a, _| match a[0].data {
                    Data::Single(it) => Ok(Data::Single(it.powi(a[1].int() as i32)).into()),
                    _ => unreachable!("types are checked"),
                };
            }
        }
    };
}

pub(super) static FLOATS: &[Native] = floats! {
    {
        sqrt abs floor ceil round trunc fract signum recip exp ln cbrt
        sin cos tan asin acos atan to_radians to_degrees exp2 log10 log2 sinh cosh tanh
    }
    { max min powf atan2 hypot copysign rem_euclid log }
    { is_nan is_finite is_infinite is_sign_negative is_sign_positive }
    {
        powi self (I32) => |_, a, _| plain(a[0].float().powi(a[1].int() as i32));
        mul_add self (Own, Own) =>
            |_, a, _| plain(a[0].float().mul_add(a[1].float(), a[2].float()));
        clamp self (Own, Own) => |host, a, at| {
            let [x, least, most] = [0, 1, 2].map(|n| a[n].float());
            if least <= most {
                plain(x.clamp(least, most))
            } else {
                host.panic(at, "min > max, or either was NaN")
            }
        };
        from _ (Any) => |host, a, at| match a[0].data {
            Data::Int(_, int) if int == Int::Any || int.ends().1 < 1 << 32 => {
                plain(a[0].float())
            }
            Data::Float(_) | Data::Single(_) if a[0].lent == 0 => plain(a[0].float()),
            _ => no_conversion(host, "f64", &a[0], at),
        };
        total_cmp self (OwnLent) => |_, a, _| order(a[0].float().total_cmp(&a[1].float()));
        partial_cmp self (OwnLent) => |_, a, _| {
            let order = a[0].compared(&a[1]).map(|it| Value::from(Data::Ordering(it)));
            Ok(order.into())
        };
    }
    { sqrt abs floor ceil round trunc fract signum recip }
    { max min }
};

fn no_conversion(
    host: &mut dyn crate::host::Host,
    to: &str,
    from: &Value,
    at: crate::refusal::At,
) -> Eval {
    let from = host.said(from);
    let from = from.trim_matches('`');
    let message = format!("the trait bound `{to}: From<{from}>` is not satisfied");
    Err(host.refuse(Refusal::new(at, message, "", &format!("`… as {to}`"))))
}

pub(super) static OTHERS: &[Native] = library! {
    INT {
        max self (Own) => |_, a, _| Ok(a[usize::from(a[1].int() > a[0].int())].clone().owned());
        min self (Own) => |_, a, _| Ok(a[usize::from(a[1].int() < a[0].int())].clone().owned());
        clamp self (Own, Own) => |_, a, _| {
            let n = if a[0].int() < a[1].int() { 1 } else { 0 };
            let n = if a[0].int() > a[2].int() { 2 } else { n };
            Ok(a[n].clone().owned())
        };
        abs self () => |_, a, _| match a[0].data {
            Data::Int(it, int) => Ok(Value::whole(it.get().abs(), int)),
            _ => unreachable!("types are checked"),
        };
        cmp self (OwnLent) => |_, a, _| order(a[0].int().cmp(&a[1].int()));
    }
    BOOL {
        then_some self (Any) => |_, a, _| Ok(a[0].truth().then(|| a[1].clone()).into());
        then self (Fn(0)) => |host, a, at| match a[0].truth() {
            true => Ok(Some(host.apply(&a[1], &mut [], at)?).into()),
            false => Ok(None.into()),
        };
    }
    ORDERING {
        reverse self () => |_, a, _| order(a[0].ordering().reverse());
        is_lt self () => |_, a, _| plain(a[0].ordering().is_lt());
        is_gt self () => |_, a, _| plain(a[0].ordering().is_gt());
        is_le self () => |_, a, _| plain(a[0].ordering().is_le());
        is_ge self () => |_, a, _| plain(a[0].ordering().is_ge());
        is_eq self () => |_, a, _| plain(a[0].ordering().is_eq());
    }
    ANY {
        clone self () => |_, a, _| Ok(match &a[0].data {
            Data::Iter(it) => Value::iter(it.borrow().clone()),
            _ => a[0].clone().owned(),
        });
    }
};
