//! Concrete syntax: in which language a slip is said.

use crate::edition::Edition;

/// The language in which a line is shown, so that readers find it in their own code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letters {
    /// The C++ of that edition of the book, or what is near to it.
    Book(Edition),
    /// Rust, as the chapters here are written.
    Rust,
    /// Python, with the names of the book.
    Python,
}
