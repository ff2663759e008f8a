//! The library: each function of Rust and of our prelude that a chapter or its reader may
//! call, by whose it is, its name and what it takes.

mod iterators;
mod lists;
mod numbers;
mod options;
mod pictures;
mod vectors;

use std::sync::LazyLock;

pub(crate) use iterators::iterator;
pub(crate) use pictures::printed;

use crate::machine::Native;
use crate::types::Ctor;

static ALL: LazyLock<Vec<Native>> = LazyLock::new(|| {
    let tables = [
        numbers::floats,
        numbers::others,
        vectors::table,
        options::table,
        lists::table,
        iterators::table,
        pictures::table,
    ];
    tables.iter().flat_map(|table| table()).collect()
});

/// Returns the function of that name before which the type's name stands, or of a name that is
/// no type's: these are those of `!`.
pub(crate) fn function(ctor: Ctor, name: &str) -> Option<&'static Native> {
    ALL.iter().find(|it| it.name == name && (it.owner)(ctor))
}

/// Returns all methods of that name.
pub(crate) fn methods(name: &str) -> impl Iterator<Item = &'static Native> {
    ALL.iter()
        .filter(move |it| it.on.is_some() && it.name == name)
}

/// Returns the names of all methods.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().filter(|it| it.on.is_some()).map(|it| it.name)
}

/// Lists functions: whose each is, its name, what it is called on and takes, and what it does.
/// `self` is a method's, `mut` one that changes it, and `_` stands for a function.
macro_rules! library {
    ($name:ident: $(
        [$owner:pat] { $($function:ident $on:tt ($($take:expr),*) => $run:expr;)* }
    )*) => {
        pub(super) fn $name() -> Vec<crate::machine::Native> {
            vec![$($(crate::machine::Native {
                owner: |ctor| matches!(ctor, $owner),
                name: stringify!($function),
                on: crate::library::on!($on),
                takes: vec![$(crate::types::Type::from($take)),*],
                run: $run,
            },)*)*]
        }
    };
}

macro_rules! on {
    (self) => {
        Some(crate::machine::Receiver::Value)
    };
    (mut) => {
        Some(crate::machine::Receiver::Place)
    };
    (_) => {
        None
    };
}

use {library, on};
