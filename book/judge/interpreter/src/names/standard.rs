//! Built-in names: those of the standard library, and of the prelude in `common`.

use std::f64::consts;

use super::Meaning;
use crate::types::{Ctor, Int, Type};

/// The names that `use common::rtweekend::*` imports.
pub(super) const PRELUDE: [(&str, Meaning); 7] = [
    ("Vec3", Meaning::Type(Type(Ctor::Vec3, Vec::new()))),
    ("Point3", Meaning::Type(Type(Ctor::Vec3, Vec::new()))),
    ("Color", Meaning::Type(Type(Ctor::Vec3, Vec::new()))),
    ("Ray", Meaning::Type(Type(Ctor::Ray, Vec::new()))),
    ("Picture", Meaning::Type(Type(Ctor::Picture, Vec::new()))),
    ("sky", Meaning::Library("sky")),
    ("render", Meaning::Library("render")),
];

/// Resolves a name of `common::rtweekend`.
pub(super) fn prelude(name: &str) -> Option<Meaning> {
    let mut all = PRELUDE.into_iter();
    let known = all.find(|it| it.0 == name).map(|it| it.1);
    known.or_else(|| (name == "Camera").then(|| Meaning::Standard(name.to_owned())))
}

/// Resolves a name that every file knows without an import.
pub(super) fn everywhere(name: &str) -> Option<Meaning> {
    let plain = |ctor: Ctor| Some(Meaning::Type(ctor.into()));
    match name {
        "f64" => plain(Ctor::F64),
        "f32" => plain(Ctor::F32),
        "bool" => plain(Ctor::Bool),
        "str" | "String" => plain(Ctor::Str),
        "Option" => Some(Meaning::Generic(Ctor::Option)),
        "Box" => Some(Meaning::Generic(Ctor::Box)),
        "Vec" => Some(Meaning::Generic(Ctor::Vec)),
        "Default" | "Clone" | "Copy" | "PartialEq" | "PartialOrd" | "Debug" | "Send" | "Sync"
        | "Sized" | "From" | "Into" | "Iterator" | "IntoIterator" | "Eq" | "Ord" | "Drop"
        | "ToString" | "Result" | "Err" | "char" | "i8" | "i16" | "isize" | "i128" | "u128"
        | "drop" => Some(Meaning::Standard(name.to_owned())),
        _ => Int::named(name).and_then(|int| plain(Ctor::Int(int))),
    }
}

/// Resolves a path that begins outside of the crate: with `common`, `std`, `core` or `f64::consts`.
pub(super) fn by_path(path: &[String]) -> Option<Meaning> {
    let path: Vec<&str> = path.iter().map(String::as_str).collect();
    match path.as_slice() {
        ["common", "rtweekend"] => Some(Meaning::Prelude),
        ["common", "rtweekend", name] => prelude(name),
        ["std" | "core", rest @ ..] => of_std(rest),
        ["f64", "consts", name] => constant(name),
        _ => None,
    }
}

/// Resolves a name in a module of the standard library.
pub(super) fn within(module: &str, name: &str) -> Option<Meaning> {
    match module {
        "consts" => constant(name),
        "fmt" => of_std(&[module, name]),
        _ => None,
    }
}

/// Resolves a path in the standard library.
fn of_std(path: &[&str]) -> Option<Meaning> {
    match path {
        ["rc", "Rc"] | ["sync", "Arc"] | ["boxed", "Box"] => Some(Meaning::Generic(Ctor::Box)),
        ["option", "Option"] => Some(Meaning::Generic(Ctor::Option)),
        ["vec", "Vec"] => Some(Meaning::Generic(Ctor::Vec)),
        ["ops", "Range"] => Some(Meaning::Generic(Ctor::Range)),
        ["cmp", "Ordering"] => Some(Meaning::Type(Ctor::Ordering.into())),
        ["fmt", "Result" | "Formatter" | "Error"] => Some(Meaning::Type(Type::UNKNOWN)),
        ["f64", "consts", name] => constant(name),
        ["f64", name] if number(name).is_some() => number(name).map(Meaning::Number),
        [.., name] => Some(Meaning::Standard((*name).to_owned())),
        [] => None,
    }
}

/// Returns the constant of `f64` with that name.
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

/// Resolves a name in `f64::consts`.
fn constant(name: &str) -> Option<Meaning> {
    Some(Meaning::Number(match name {
        "PI" => consts::PI,
        "TAU" => consts::TAU,
        "FRAC_PI_2" => consts::FRAC_PI_2,
        "FRAC_PI_4" => consts::FRAC_PI_4,
        "SQRT_2" => consts::SQRT_2,
        _ => return Some(Meaning::Standard(name.to_owned())),
    }))
}
