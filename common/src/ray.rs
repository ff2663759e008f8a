//! A ray, and where it is at the ray parameter `t`.

use crate::vec3::{Point3, Vec3};

/// The half-line P(t) = Q + t·d of equation (1): Q is the origin and d the direction. The book has A
/// and b there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The point at `t` = 0, where the ray starts.
    pub origin: Point3,
    /// The vector from `origin` to the point at `t` = 1; it need not have unit length.
    pub direction: Vec3,
}

impl Ray {
    /// Makes the ray from `origin` along `direction`, which may have any length.
    #[inline]
    pub const fn new(origin: Point3, direction: Vec3) -> Self {
        Self { origin, direction }
    }

    /// Returns the point at ray parameter `t`: behind the origin where `t` is
    /// negative.
    ///
    /// `t` counts lengths of `direction`, so it is a distance only if that is
    /// a unit vector.
    #[inline]
    pub fn at(&self, t: f64) -> Point3 {
        self.origin + t * self.direction
    }
}
