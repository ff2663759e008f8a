//! The functions that the pages call, compiled to WebAssembly: bytes and numbers in; words and
//! pixels out.
//!
//! All that they answer is computed elsewhere: the live figures by the package `figures`, the
//! verdict on a picture ([`checked`]) by `check`, and the picture of a text that is [`typed`] by
//! `interpreter`. `.ci/live` builds the modules that the scripts in `book/notes/live` load.

pub mod checked;
#[cfg(target_family = "wasm")]
mod exports;
mod habits;
pub mod home;
pub mod next;
pub mod typed;
pub mod typing;
mod words;

use common::rtweekend::Picture;

/// Returns the pixels of a picture as a canvas takes them: red, green, blue and 255, row by row
/// from the top.
fn rgba(picture: &Picture) -> Vec<u8> {
    let (pixels, _) = picture.rgb().as_chunks();
    let opaque = |&[r, g, b]: &[u8; 3]| [r, g, b, u8::MAX];
    pixels.iter().flat_map(opaque).collect()
}
