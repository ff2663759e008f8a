//! What is measured: how exact each method of chapter 6 is, how many pixels it gets
//! wrong, and how long everything takes.

pub mod accuracy;
pub mod contest;
pub mod cost;
pub mod lanes;
pub mod machine;
pub mod needs;
pub mod population;
pub mod rival;
pub mod scene_file;
pub mod spread;
pub mod truth;
pub mod wrong_pixels;
