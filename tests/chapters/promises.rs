//! What the chapters and `common` promise beside pictures and laws. It stands on right
//! chapters, so cargo runs it once the program `chapters` passes.

mod camera;
mod color;
mod details;
mod engine;
