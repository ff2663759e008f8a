//! What a text may use without declaring it: the standard library, and our prelude.

use std::f64::consts;

use super::Named;
use crate::types::{Head, Int, Type};

/// The names that `use common::rtweekend::*` brings.
pub(super) const PRELUDE: [(&str, Named); 7] = [
    ("Vec3", Named::Type(Type(Head::Vec3, Vec::new()))),
    ("Point3", Named::Type(Type(Head::Vec3, Vec::new()))),
    ("Color", Named::Type(Type(Head::Vec3, Vec::new()))),
    ("Ray", Named::Type(Type(Head::Ray, Vec::new()))),
    ("Picture", Named::Type(Type(Head::Picture, Vec::new()))),
    ("sky", Named::Library("sky")),
    ("render", Named::Library("render")),
];

pub(super) fn prelude(name: &str) -> Option<Named> {
    let mut all = PRELUDE.into_iter();
    let known = all.find(|it| it.0 == name).map(|it| it.1);
    known.or_else(|| (name == "Camera").then(|| Named::Standard(name.to_owned())))
}

/// Finds what every file knows by that name.
pub(super) fn everywhere(name: &str) -> Option<Named> {
    let plain = |head: Head| Some(Named::Type(head.into()));
    match name {
        "f64" => plain(Head::F64),
        "f32" => plain(Head::F32),
        "bool" => plain(Head::Bool),
        "str" | "String" => plain(Head::Str),
        "Option" => Some(Named::Generic(Head::Option)),
        "Box" => Some(Named::Generic(Head::Box)),
        "Vec" => Some(Named::Generic(Head::Vec)),
        "Default" | "Clone" | "Copy" | "PartialEq" | "PartialOrd" | "Debug" | "Send" | "Sync"
        | "Sized" | "From" | "Into" | "Iterator" | "IntoIterator" | "Eq" | "Ord" | "Drop"
        | "ToString" | "Result" | "Err" | "char" | "i8" | "i16" | "isize" | "i128" | "u128"
        | "drop" => Some(Named::Standard(name.to_owned())),
        _ => Int::named(name).and_then(|int| plain(Head::Int(int))),
    }
}

/// Finds what a path leads to that begins outside of the crate.
pub(super) fn by_path(path: &[String]) -> Option<Named> {
    let path: Vec<&str> = path.iter().map(String::as_str).collect();
    match path.as_slice() {
        ["common", "rtweekend"] => Some(Named::Prelude),
        ["common", "rtweekend", name] => prelude(name),
        ["std" | "core", rest @ ..] => of_std(rest),
        ["f64", "consts", name] => constant(name),
        _ => None,
    }
}

/// Finds what a module of the standard library has by that name.
pub(super) fn within(module: &str, name: &str) -> Option<Named> {
    match module {
        "consts" => constant(name),
        "fmt" => of_std(&[module, name]),
        _ => None,
    }
}

fn of_std(path: &[&str]) -> Option<Named> {
    match path {
        ["rc", "Rc"] | ["sync", "Arc"] | ["boxed", "Box"] => Some(Named::Generic(Head::Box)),
        ["option", "Option"] => Some(Named::Generic(Head::Option)),
        ["vec", "Vec"] => Some(Named::Generic(Head::Vec)),
        ["ops", "Range"] => Some(Named::Generic(Head::Range)),
        ["cmp", "Ordering"] => Some(Named::Type(Head::Ordering.into())),
        ["fmt", "Result" | "Formatter" | "Error"] => Some(Named::Type(Type::UNKNOWN)),
        ["f64", "consts", name] => constant(name),
        ["f64", name] if number(name).is_some() => number(name).map(Named::Number),
        [.., name] => Some(Named::Standard((*name).to_owned())),
        [] => None,
    }
}

/// Returns a constant of `f64`.
pub(crate) fn number(name: &str) -> Option<f64> {
    Some(match name {
        "INFINITY" => f64::INFINITY,
        "NEG_INFINITY" => f64::NEG_INFINITY,
        "MAX" => f64::MAX,
        "MIN" => f64::MIN,
        "MIN_POSITIVE" => f64::MIN_POSITIVE,
        "EPSILON" => f64::EPSILON,
        "NAN" => f64::NAN,
        _ => return None,
    })
}

fn constant(name: &str) -> Option<Named> {
    Some(Named::Number(match name {
        "PI" => consts::PI,
        "TAU" => consts::TAU,
        "FRAC_PI_2" => consts::FRAC_PI_2,
        "FRAC_PI_4" => consts::FRAC_PI_4,
        "SQRT_2" => consts::SQRT_2,
        _ => return Some(Named::Standard(name.to_owned())),
    }))
}
