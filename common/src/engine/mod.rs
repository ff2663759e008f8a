//! The engine: from the color of a pixel to the bytes of a file.
//!
//! In the order in which a pixel passes through it: [`render`] asks for colors,
//! `block` stores them many at a time, [`Picture`] cuts the picture into strips,
//! `ring` spreads these over threads, `p3` makes text of them, [`output`] writes
//! it whole with the help of `partial`, `signals` and `standard`, and [`main`] is
//! what a chapter's program does with it all. [`folder`] writes a whole folder, and
//! [`companion`] is the name of the program that does the rest.

mod block;
mod companion;
pub mod folder;
pub mod output;
mod p3;
mod partial;
mod picture;
mod program;
mod render;
mod ring;
#[cfg(unix)]
pub mod signals;
mod standard;

pub use companion::companion;
pub use picture::Picture;
pub use program::{WIDTHS, main, parse_width};
pub use render::render;
