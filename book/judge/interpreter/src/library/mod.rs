//! The library: each function of Rust and of our prelude that a chapter or its reader may
//! call, by whose it is, its name and what it takes.

mod iterators;
mod lists;
mod numbers;
mod options;
mod pictures;
mod texts;
mod vectors;

use common::rtweekend::Vec3;

pub(crate) use iterators::{iterator, next};
pub(crate) use pictures::printed;

use crate::host::{Eval, Host};
use crate::node::Node;
use crate::refusal::At;
use crate::types::{Head, Int, Owners, Type};
use crate::value::{Data, Value};

/// A function of the library.
#[derive(Debug)]
pub(crate) struct Native {
    /// On whose values it is called, or before whose name it stands.
    pub(crate) owners: Owners,
    pub(crate) name: &'static str,
    /// What it is called on, if it is a method.
    pub(crate) on: Option<On>,
    pub(crate) takes: &'static [Take],
    pub(crate) run: Run,
}

type Run = fn(&mut dyn Host, &mut [Value], At) -> Eval;

/// What a method is called on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum On {
    Value,
    /// What it changes.
    Place,
}

/// What a parameter is declared to be.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Take {
    Any,
    /// What the method is called on, or a reference to such a thing.
    Own,
    OwnLent,
    F64,
    I32,
    U32,
    Usize,
    Vec3,
    /// A reference to a ray.
    Ray,
    /// A reference to a text.
    Str,
    Option,
    Array,
    /// A function of so many parameters.
    Fn(usize),
}

impl Native {
    /// Whether it changes what it is called on.
    pub(crate) fn changes(&self) -> bool {
        self.on == Some(On::Place)
    }
}

impl Take {
    /// The type that is declared where a method is called on a value of another.
    pub(crate) fn ty(&self, on: &Type) -> Type {
        let lent = |ty: Type| Type::of(Head::Ref, ty);
        match self {
            Self::Any => Type::UNKNOWN,
            Self::Own => on.clone(),
            Self::OwnLent => lent(on.clone()),
            Self::F64 => Head::F64.into(),
            Self::I32 => Head::Int(Int::I32).into(),
            Self::U32 => Head::Int(Int::U32).into(),
            Self::Usize => Head::Int(Int::Usize).into(),
            Self::Vec3 => Head::Vec3.into(),
            Self::Ray => lent(Head::Ray.into()),
            Self::Str => lent(Head::Str.into()),
            Self::Option => Type::of(Head::Option, Type::UNKNOWN),
            Self::Array => Type::of(Head::Array(3), Head::F64.into()),
            Self::Fn(count) => Type(Head::Fn, vec![Type::UNKNOWN; count + 1]),
        }
    }

    /// Whether a value may be that, where a method is called on another.
    pub(crate) fn accepts(&self, value: &Value, on: &Value) -> bool {
        let is_like = || match (value.head(), on.head()) {
            (Head::Int(one), Head::Int(other)) => one.joined(other).is_some(),
            (one, other) => one == other,
        };
        let is_int =
            |wanted: Int| matches!(&value.data, Data::Int(_, it) if it.joined(wanted).is_some());
        match self {
            Self::Any => true,
            Self::Own => value.lent == 0 && is_like(),
            Self::OwnLent => value.lent > 0 && is_like(),
            Self::F64 => value.lent == 0 && matches!(value.data, Data::Float(_)),
            Self::I32 => value.lent == 0 && is_int(Int::I32),
            Self::U32 => value.lent == 0 && is_int(Int::U32),
            Self::Usize => value.lent == 0 && is_int(Int::Usize),
            Self::Vec3 => value.lent == 0 && matches!(value.data, Data::Vec3(_)),
            Self::Ray => value.lent > 0 && matches!(value.data, Data::Ray(_)),
            Self::Str => value.lent > 0 && matches!(value.data, Data::Str(_)),
            Self::Option => value.lent == 0 && value.head() == Head::Option,
            Self::Array => matches!(value.head(), Head::Array(3)),
            Self::Fn(_) => value.head() == Head::Fn,
        }
    }
}

/// All functions, in tables of at most this many.
static TABLES: [&[Native]; 8] = [
    numbers::FLOATS,
    numbers::OTHERS,
    vectors::TABLE,
    options::TABLE,
    lists::TABLE,
    iterators::TABLE,
    texts::TABLE,
    pictures::TABLE,
];
const SIZE: usize = 256;

/// The function with that number.
pub(crate) fn native(number: usize) -> &'static Native {
    &TABLES[number / SIZE][number % SIZE]
}

fn all() -> impl Iterator<Item = (usize, &'static Native)> {
    let numbered = |(table, all): (usize, &&'static [Native])| {
        let all: &'static [Native] = all;
        all.iter()
            .enumerate()
            .map(move |(n, it)| (SIZE * table + n, it))
    };
    TABLES.iter().enumerate().flat_map(numbered)
}

/// The function of that name that one of the owners has, or that is nobody's.
pub(crate) fn function(owners: Owners, name: &str) -> Option<usize> {
    let is_it = |it: &Native| it.name == name && (it.owners == owners || it.owners.has(owners));
    all().find(|it| is_it(it.1)).map(|it| it.0)
}

/// All methods of that name, and whose they are.
pub(crate) fn methods(name: &str) -> impl Iterator<Item = (Owners, usize)> {
    let all = all().filter(move |(_, it)| it.on.is_some() && it.name == name);
    all.map(|(n, it)| (it.owners, n))
}

/// The names of all methods.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    all().filter(|it| it.1.on.is_some()).map(|it| it.1.name)
}

/// A constant of `f64`.
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

/// A constant of a type of the library.
pub(crate) fn constant(owner: Head, name: &str) -> Option<Node> {
    Some(match (owner, name) {
        (Head::Vec3, name) => Node::Vec3(match name {
            "ZERO" => Vec3::ZERO,
            "ONE" => Vec3::ONE,
            "X" => Vec3::X,
            "Y" => Vec3::Y,
            "Z" => Vec3::Z,
            "NEG_X" => Vec3::NEG_X,
            "NEG_Y" => Vec3::NEG_Y,
            "NEG_Z" => Vec3::NEG_Z,
            _ => return None,
        }),
        (Head::Ordering, name) => Node::Ordering(match name {
            "Less" => std::cmp::Ordering::Less,
            "Equal" => std::cmp::Ordering::Equal,
            "Greater" => std::cmp::Ordering::Greater,
            _ => return None,
        }),
        (Head::F64, name) => Node::Float(number(name)?),
        (Head::F32, name) => Node::Single(match name {
            "INFINITY" => f32::INFINITY,
            "NEG_INFINITY" => f32::NEG_INFINITY,
            "MAX" => f32::MAX,
            "EPSILON" => f32::EPSILON,
            "NAN" => f32::NAN,
            _ => return None,
        }),
        (Head::Int(int), "MAX") => Node::Int(int.ends().1, int),
        (Head::Int(int), "MIN") => Node::Int(int.ends().0, int),
        _ => return None,
    })
}

/// A list of functions, each in one line: whose it is, its name, what it is called on and
/// takes, and what it does.
macro_rules! library {
    ($(
        $owner:ident { $($name:ident $on:tt ($($take:expr),*) => $run:expr;)* }
    )*) => {
        &[$($(crate::library::Native {
            owners: crate::types::Owners::$owner,
            name: stringify!($name),
            on: crate::library::on!($on),
            takes: {
                #[allow(unused_imports, reason = "some take nothing")]
                use crate::library::Take::*;
                &[$($take),*]
            },
            run: $run,
        },)*)*]
    };
}

/// `self` is a method's, `mut` one that changes it, and `_` stands for a function.
macro_rules! on {
    (self) => {
        Some(crate::library::On::Value)
    };
    (mut) => {
        Some(crate::library::On::Place)
    };
    (_) => {
        None
    };
}

use {library, on};
