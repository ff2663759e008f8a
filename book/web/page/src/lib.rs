//! What the pages call, compiled to WebAssembly: bytes and numbers in; words and pixels out.
//!
//! Nothing is computed here that is not computed elsewhere: the live figures are those of
//! [`figures`], a picture is [`checked`] by the package `check`, and a text that is [`typed`] is
//! run by `interpreter`. `.ci/live` builds the modules that the scripts in `book/notes/live`
//! load.

pub mod breaking;
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

/// The bytes of a picture as a canvas has them: four a pixel.
fn rgba(picture: &Picture) -> Vec<u8> {
    let (pixels, _) = picture.rgb().as_chunks();
    let opaque = |&[r, g, b]: &[u8; 3]| [r, g, b, u8::MAX];
    pixels.iter().flat_map(opaque).collect()
}
