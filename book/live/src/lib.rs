//! What a page calls, compiled to WebAssembly: the live figures of [`figures`], and the
//! pictures of the chapters.
//!
//! The scripts of the pages, in `book/notes/live`, only carry numbers here and words and
//! pixels back. `.ci/live` builds the module that they load.

#[cfg(target_family = "wasm")]
mod exports;
pub mod picture;
