//! The chapters themselves, and what they share: their laws, their colors, their
//! pictures.
//!
//! All other tests stand on right chapters and are the program `suite`. Cargo runs
//! that one next, and only if all of these pass: a mistake in a chapter is told once,
//! by the law that it breaks and the picture that it draws.

mod book_pictures;
mod camera;
mod color;
mod drawn;
mod left_out;
mod quadratic;
