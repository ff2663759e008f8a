//! Live figures: what a figure shows for other numbers than the page's, while a reader
//! drags them.
//!
//! A page shows each figure as a drawing that was made when the book was woven. Where a
//! figure is live, a reader may move what is in it, and the same function of [`figures`]
//! draws it anew, here compiled to WebAssembly. All that is known about a figure is
//! known here: which numbers there are, where on the sheet they can be grasped, what a
//! drag does to them, and the sentence below. The script of the page,
//! `book/notes/live/figures.js`, only carries numbers there and words back. The pictures
//! of the chapters are in [`picture`], with `book/notes/live/pictures.js`.
//!
//! To make another figure live:
//! 1. Its function in `figures` draws whatever numbers it is given, and what the page
//!    shows is its default.
//! 2. A module here says what a reader can change, as a [`Live`], and [`FIGURES`] names it.
//!    From then on `{{figure NAME}}` weaves it with its handles.
//! 3. `.ci/live` builds the module of the pages anew, and `cargo test live` tells whether
//!    it answers as this crate does.

mod digits;
mod discriminant;
mod edge;
#[cfg(target_family = "wasm")]
mod exports;
mod face_normal;
mod live;
mod nearest;
mod normal_colors;
pub mod picture;
mod ray;
mod viewport_grid;

pub use live::{Action, Answer, Handle, Live, Number};

/// All live figures, in reading order. A page names them by their place.
pub static FIGURES: &[Live] = &[
    ray::LIVE,
    viewport_grid::LIVE,
    discriminant::LIVE,
    normal_colors::LIVE,
    nearest::LIVE,
    face_normal::LIVE,
    digits::LIVE,
    edge::LIVE,
];

/// The live figure of that name.
pub fn find(name: &str) -> Option<&'static Live> {
    FIGURES.iter().find(|live| live.name == name)
}
