//! What is measured: how exact each method of chapter 6 is, how many pixels it gets
//! wrong, and how long everything takes.

pub mod accuracy;
pub mod climb;
pub mod machine;
pub mod population;
pub mod rival;
pub mod scenes;
pub mod spread;
pub mod tightness;
pub mod worst;
