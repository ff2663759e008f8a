//! Interprets what a reader types in the page: the Rust in which our chapters are written, and
//! what people write instead.
//!
//! `read` parses the files, `names` resolves names, and `lower` turns syntax trees into closures
//! ("lowers" them), which run on `machine` and call `library`. Floats are computed in the order in
//! which the text has them, so a picture is that of the compiled program to the last bit. Names,
//! fields, methods and counts of arguments are checked before a program runs. Types are checked
//! when values meet what is declared, so a line that never ran is not checked:
//! [`Program::unchecked`] lists these. What the interpreter does not read is refused by its name.

mod asked;
mod canvas;
mod library;
mod limits;
mod lower;
mod machine;
mod names;
pub mod nesting;
mod operators;
mod patch;
mod program;
mod read;
mod refusal;
mod types;

pub use asked::{Ball, SphereHit};
pub use canvas::{Canvas, TracedValue, format_number};
pub use program::{ExpectedPixel, Program, SourceFile, UncheckedLines, read};
pub use refusal::{Fault, FaultKind, SourceSpan};

/// The sentence at the end of an answer that calls a typed text right, in plain text: it says that
/// moves and borrows were not checked.
pub const UNCHECKED: &str = "Moves and borrows are not checked here: cargo does that.";
