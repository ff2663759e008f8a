//! The figures of the book: pure functions from numbers to SVG.
