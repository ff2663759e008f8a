//! Numbers: `f64` and `f32`, integers, truth and order.

use super::library;
use crate::machine::value::{Data, Value};
use crate::machine::{Eval, Machine};
use crate::refusal::Span;
use crate::types::Ctor::{Like, Unknown};
use crate::types::{Ctor, Int, Type};

/// Computes a result from one, two or three floats: in `f32` if all are, else in `f64`.
macro_rules! float {
    ($a:ident: $x:ident => $result:expr) => {
        match $a[0].data {
            Data::Single($x) => Ok($result.into()),
            _ => {
                let $x = $a[0].float();
                Ok($result.into())
            }
        }
    };
    ($a:ident: $x:ident $y:ident $($z:ident)? => $result:expr) => {
        match [&$a[0].data, &$a[1].data, &$a[$a.len() - 1].data] {
            [Data::Single($x), Data::Single($y), Data::Single(_last)] => {
                let ($x, $y) = (*$x, *$y);
                $(let $z = *_last;)?
                Ok($result.into())
            }
            _ => {
                let ($x, $y) = ($a[0].float(), $a[1].float());
                $(let $z = $a[2].float();)?
                Ok($result.into())
            }
        }
    };
}

/// Defines the functions of floats: those of one float or two by their names alone, as they are in
/// the standard library, and then the rest.
macro_rules! floats {
    ({ $($one:ident)* } { $($two:ident)* } { $($is:ident)* } $($rest:tt)*) => {
        library! { floats:
            [Ctor::F64 | Ctor::F32] {
                $($one self () => |_, a, _| float!(a: x => x.$one());)*
                $($two self (Like) => |_, a, _| float!(a: x y => x.$two(y));)*
                $($is self () => |_, a, _| float!(a: x => x.$is());)*
                powi self (Ctor::Int(Int::I32)) => |_, a, _| {
                    let n = a[1].int() as i32;
                    float!(a: x => x.powi(n))
                };
                total_cmp self (Type::of(Ctor::Ref, Like.into())) =>
                    |_, a, _| float!(a: x y => x.total_cmp(&y));
                partial_cmp self (Type::of(Ctor::Ref, Like.into())) => |_, a, _| {
                    float!(a: x y => x.partial_cmp(&y).map(Value::from))
                };
                mul_add self (Like, Like) => |_, a, _| float!(a: x y z => x.mul_add(y, z));
                clamp self (Like, Like) => |m, a, at| {
                    if a[1].float() <= a[2].float() {
                        float!(a: x y z => x.clamp(y, z))
                    } else {
                        m.panic(at, "min > max, or either was NaN")
                    }
                };
            }
            $($rest)*
        }
    };
}

floats! {
    {
        sqrt abs floor ceil round trunc fract signum recip exp ln cbrt
        sin cos tan asin acos atan to_radians to_degrees exp2 log10 log2 sinh cosh tanh
    }
    { max min powf atan2 hypot copysign rem_euclid log }
    { is_nan is_finite is_infinite is_sign_negative is_sign_positive }
    [Ctor::F64] {
        from _ (Unknown) => |m, a, at| match a[0].data {
            Data::Int(_, int) if int == Int::Any || int.ends().1 < 1 << 32 => {
                Ok(a[0].float().into())
            }
            Data::Float(_) | Data::Single(_) if a[0].lent == 0 => Ok(a[0].float().into()),
            _ => no_conversion(m, "f64", &a[0], at),
        };
    }
    [Ctor::F32] {
        from _ (Unknown) => |m, a, at| match a[0].data {
            Data::Single(_) if a[0].lent == 0 => Ok(a[0].clone()),
            Data::Int(it, Int::U8 | Int::U16 | Int::Any) => Ok((it.get() as f32).into()),
            _ => no_conversion(m, "f32", &a[0], at),
        };
    }
}

/// Stops since `from` has no conversion of this value, in the compiler's words.
fn no_conversion(m: &mut Machine<'_>, to: &str, from: &Value, at: Span) -> Eval {
    let from = m.named(from);
    let message = format!("the trait bound `{to}: From<{from}>` is not satisfied");
    m.wrong(at, message, &format!("`… as {to}`"))
}

/// Defines the functions of an `Ordering` by their names alone, and then those of integers, truths
/// and texts.
macro_rules! others {
    ({ $($is:ident)* } $($rest:tt)*) => {
        library! { others:
            [Ctor::Ordering] {
                reverse self () => |_, a, _| Ok(a[0].ordering().reverse().into());
                $($is self () => |_, a, _| Ok(a[0].ordering().$is().into());)*
            }
            $($rest)*
        }
    };
}

others! {
    { is_lt is_gt is_le is_ge is_eq }
    [Ctor::Int(_)] {
        max self (Like) => |_, a, _| Ok(a[usize::from(a[1].int() > a[0].int())].clone().owned());
        min self (Like) => |_, a, _| Ok(a[usize::from(a[1].int() < a[0].int())].clone().owned());
        clamp self (Like, Like) => |_, a, _| {
            let n = if a[0].int() < a[1].int() { 1 } else { 0 };
            let n = if a[0].int() > a[2].int() { 2 } else { n };
            Ok(a[n].clone().owned())
        };
        abs self () => |_, a, _| match a[0].data {
            Data::Int(it, int) => Ok(Value::whole(it.get().abs(), int)),
            _ => unreachable!("types are checked"),
        };
        cmp self (Type::of(Ctor::Ref, Like.into())) =>
            |_, a, _| Ok(a[0].int().cmp(&a[1].int()).into());
    }
    [Ctor::Bool] {
        then_some self (Unknown) => |_, a, _| Ok(a[0].truth().then(|| a[1].clone()).into());
        then self (Type::function(0)) => |m, a, at| match a[0].truth() {
            true => Ok(Some(m.applied(&a[1], &mut [], at)?).into()),
            false => Ok(None.into()),
        };
    }
    [
        Ctor::Bool | Ctor::Int(_) | Ctor::F64 | Ctor::F32 | Ctor::Str | Ctor::Ordering | Ctor::Vec3
        | Ctor::Ray | Ctor::Option | Ctor::Vec | Ctor::Array(_) | Ctor::Tuple | Ctor::Range
        | Ctor::Iterator
    ] {
        clone self () => |m, a, at| match &a[0].data {
            Data::Iter(_) => m.unread(at, "copies of iterators"),
            _ => Ok(a[0].clone().owned()),
        };
    }
    [Ctor::Str] {
        new _ () => |_, _, _| Ok(Value::str(""));
        with_capacity _ (Ctor::Int(Int::Usize)) => |_, _, _| Ok(Value::str(""));
        from _ (Type::of(Ctor::Ref, Ctor::Str.into())) => |_, a, _| Ok(a[0].clone().owned());
        to_string self () => |_, a, _| Ok(a[0].clone().owned());
        to_owned self () => |_, a, _| Ok(a[0].clone().owned());
        as_str self () => |_, a, _| Ok(a[0].clone().owned().lent());
        len self () => |_, a, _| Ok(Value::usize(a[0].text().len()));
        is_empty self () => |_, a, _| Ok(a[0].text().is_empty().into());
        push_str mut (Type::of(Ctor::Ref, Ctor::Str.into())) =>
            |m, a, at| m.append(&a[0], &a[1].text(), at);
    }
}
