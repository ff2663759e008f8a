//! Interprets the Rust in which the chapters are written, and what readers type instead.
//!
//! Read in this order: `value` and `integers` are what a program computes with, `machine` and
//! `calls` run it, `place` changes what lies in variables. `names` says what names mean, and
//! `collect` gathers them from the files. `lower` turns each function into closures: an operator is
//! added in `operators`, and for vectors in `texts/prelude.rs`, a pattern in `lower/patterns`, a
//! function of the standard library in `natives` or as text in `texts/std.rs`. `program` and
//! `canvas` are what others call.
//!
//! It runs a text and is no compiler. Syntax, names, counts of arguments and `mut` are checked when
//! a text is read, types when values meet. Moves, borrows, privacy, and lines that never run are
//! not checked. What the compiler may accept and is not read here is refused by its name. Floats
//! are computed in the order in which the text has them, so a picture is that of the compiled
//! program to the last bit.

mod calls;
mod canvas;
mod collect;
mod fault;
mod integers;
mod lower;
mod machine;
mod names;
mod natives;
pub mod nesting;
mod operators;
mod place;
mod program;
mod syntax;
mod value;

pub use canvas::Canvas;
pub use fault::{Fault, FaultKind, Span};
pub use machine::TracedValue;
pub use program::{PRELUDE_TEXT, Program, SourceFile, read};
pub use value::{Value, format_number};
