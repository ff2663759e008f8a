//! Promises of the chapters and `common` beside pictures and laws. They stand on right
//! chapters: cargo tests those first.

mod camera;
mod color;
mod details;
mod engine;
