//! Promises of the chapters and `common` beside pictures and laws. They stand on right
//! chapters, so cargo tests them once the program `chapters` passes.

mod camera;
mod color;
mod details;
mod engine;
