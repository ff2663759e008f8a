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

/// Returns the library's function `Type::name` by its type and name. A function without a type, as
/// `sky`, has the type `!` here.
pub(crate) fn function(ctor: Ctor, name: &str) -> Option<&'static Native> {
    ALL.iter().find(|it| it.name == name && (it.owner)(ctor))
}

/// Returns all methods of the library with that name, for whatever type.
pub(crate) fn methods(name: &str) -> impl Iterator<Item = &'static Native> {
    ALL.iter()
        .filter(move |it| it.on.is_some() && it.name == name)
}

/// Returns the names of all methods of the library.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().filter(|it| it.on.is_some()).map(|it| it.name)
}

/// Defines a table of functions: in brackets their types, then for each its name, how it takes its
/// receiver, the types of its other parameters, and what it does. A receiver `self` is a value,
/// `mut` the address of one, and `_` means that there is none.
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
