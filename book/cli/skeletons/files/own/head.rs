pub mod ray;
pub mod render;
pub mod rtweekend;
pub mod vec3;

use crate::rtweekend::*;
