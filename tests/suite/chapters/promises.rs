//! What the chapters promise beside their laws and their pictures: it stands on right
//! chapters, so cargo runs it once the program `chapters` passes.

mod camera;
mod details;
mod editions;
mod speed;
