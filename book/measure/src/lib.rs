//! What is measured: how exact each method of chapter 6 is, how many pixels it gets
//! wrong, how often each way to leave a surface is wrong about the sun, and how long
//! everything takes.

pub mod accuracy;
pub mod contest;
pub mod cost;
pub mod exact_departure;
pub mod machine;
pub mod needs;
pub mod population;
pub mod progress;
pub mod rival;
pub mod scene_file;
pub mod shadows;
pub mod spread;
pub mod truth;
pub mod worst;
pub mod wrong_pixels;
