//! Integers: an `i64` and its type. One of no known type, as a literal, takes that of the other; it
//! is computed as an `i32`.

use std::ops::RangeInclusive;

use crate::value::{Kind, Value, kind};

/// Returns true for the types of integers.
#[inline]
pub(crate) fn is_integer(kind: Kind) -> bool {
    (kind::INT..=kind::ISIZE).contains(&kind)
}

/// Returns the numbers of a type of integer.
fn range(kind: Kind) -> RangeInclusive<i128> {
    let unsigned = |bits: u32| 0..=(1 << bits) - 1;
    let signed = |bits: u32| -(1 << (bits - 1))..=(1 << (bits - 1)) - 1;
    match kind {
        kind::U8 => unsigned(8),
        kind::U16 => unsigned(16),
        kind::U32 => unsigned(32),
        kind::U64 | kind::USIZE => unsigned(64),
        kind::I8 => signed(8),
        kind::I16 => signed(16),
        kind::INT | kind::I32 => signed(32),
        kind::I64 | kind::ISIZE => signed(64),
        other => unreachable!("type {other} is no integer"),
    }
}

/// Returns true if a type of integer has a number.
pub(crate) fn has(kind: Kind, number: i64) -> bool {
    range(kind).contains(&number.into())
}

/// Converts a number or a truth as `as` does; `None` for another value or another type. One beyond
/// the largest `i64` becomes that.
pub(crate) fn cast(value: &Value, to: Kind) -> Option<Value> {
    if to == kind::FLOAT {
        return match value {
            Value::Int(number, _) => Some((*number as f64).into()),
            number => number.float().map(Value::from),
        };
    }
    if !is_integer(to) {
        return None;
    }
    let (least, most) = range(to).into_inner();
    let number = match *value {
        Value::Float(number) => (number as i128).clamp(least, most),
        Value::Int(number, _) => least + (i128::from(number) - least).rem_euclid(most - least + 1),
        Value::Bool(truth) => truth.into(),
        _ => return None,
    };
    Some(Value::Int(number.try_into().unwrap_or(i64::MAX), to))
}

/// Returns the type of both operands; `None` if they have two.
#[inline]
pub(crate) fn joined(one: Kind, other: Kind) -> Option<Kind> {
    match (one, other) {
        (kind::INT, kind) | (kind, kind::INT) => Some(kind),
        (one, other) => (one == other).then_some(one),
    }
}

/// Finds the type of integer with that name, as at the end of a literal.
pub(crate) fn named(name: &str) -> Option<Kind> {
    let mut kinds = kind::INT + 1..=kind::ISIZE;
    kinds.find(|it| kind::NAMES[usize::from(*it)] == name)
}

/// Returns true if an `f64` holds each number of the type, so that `f64::from` takes it.
pub(crate) fn is_in_a_float(kind: Kind) -> bool {
    kind == kind::INT || is_integer(kind) && *range(kind).end() < 1 << 32
}
