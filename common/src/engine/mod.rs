//! The engine: from the color of a pixel to the bytes of a picture.
//!
//! In the order in which a pixel passes through it: [`render()`] asks for colors,
//! `block` stores them many at a time, [`Picture`] cuts the picture into strips,
//! `ring` spreads these over threads, `p3` makes text of them, and [`main`] is the command line of
//! a chapter, which writes it to standard output or a file.

mod block;
mod command_line;
mod p3;
mod picture;
mod render;
mod ring;

pub use command_line::{WIDTHS, main, parse_width};
pub use picture::Picture;
pub use render::render;
