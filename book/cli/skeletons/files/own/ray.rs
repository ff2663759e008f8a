//! A ray, and where it is at `t`.

use crate::vec3::{Point3, Vec3};

/// P(t) = origin + t · direction.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub origin: Point3,
    pub direction: Vec3,
}

impl Ray {
    pub const fn new(origin: Point3, direction: Vec3) -> Self {
        Self { origin, direction }
    }

    pub fn at(&self, t: f64) -> Point3 {
        todo!()
    }
}
