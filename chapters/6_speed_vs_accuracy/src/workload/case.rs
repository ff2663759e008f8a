//! A case: one ray and one sphere, as every method is asked about them.

use std::fmt;

use common::rtweekend::*;

use crate::method::{Method, Solve};
use crate::precision::{Precision, SingleRay};

/// A question to a method: does this ray meet this sphere, and at which t?
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// The center of the sphere.
    pub center: Point3,
    /// The radius of the sphere; its sign does not matter.
    pub radius: f64,
    /// The ray; a direction of length 0 makes every method answer a miss.
    pub ray: Ray,
}

impl Case {
    /// Makes the case of a sphere, by its center and radius, and a ray. No number is checked.
    pub const fn new(center: Point3, radius: f64, ray: Ray) -> Self {
        Self {
            center,
            radius,
            ray,
        }
    }

    /// Returns the answer of `method`, right or wrong: the nearest root between `t_min` and
    /// `t_max`, both excluded, in lengths of the direction, or `None` for a miss.
    ///
    /// A method in `f32` gets the case and both ends rounded to `f32`, and its answer is widened.
    #[inline]
    pub fn put_to(&self, method: &Method, t_min: f64, t_max: f64) -> Option<f64> {
        match method.solve {
            Solve::Double(solve) => solve(self.center, self.radius, &self.ray, t_min, t_max),
            Solve::Single(solve) => solve(
                self.center.as_vec3(),
                self.radius as f32,
                &self.single_ray(),
                t_min as f32,
                t_max as f32,
            )
            .map(f64::from),
        }
    }

    /// Returns the case with each number rounded to `precision`: the same case for `f64`. A number
    /// too large for an `f32` becomes infinite, one too small 0.
    pub fn rounded(&self, precision: Precision) -> Self {
        match precision {
            Precision::Double => *self,
            Precision::Single => Self {
                center: self.center.as_vec3().as_dvec3(),
                radius: f64::from(self.radius as f32),
                ray: Ray::new(
                    self.ray.origin.as_vec3().as_dvec3(),
                    self.ray.direction.as_vec3().as_dvec3(),
                ),
            },
        }
    }

    /// Returns the point of the ray at `t`, computed in `precision` and widened to `f64`.
    pub fn point(&self, t: f64, precision: Precision) -> Point3 {
        match precision {
            Precision::Double => self.ray.at(t),
            Precision::Single => {
                let SingleRay { origin, direction } = self.single_ray();
                (origin + t as f32 * direction).as_dvec3()
            }
        }
    }

    /// Returns the ray with each number rounded to `f32`.
    #[inline]
    pub fn single_ray(&self) -> SingleRay {
        SingleRay {
            origin: self.ray.origin.as_vec3(),
            direction: self.ray.direction.as_vec3(),
        }
    }

    /// Computes a = d·d, rounded: the squared length of the ray's direction.
    pub fn a(&self) -> f64 {
        self.ray.direction.length_squared()
    }

    /// Computes h = d·oc, rounded, with oc = center − origin: half of −b in the quadratic equation.
    pub fn h(&self) -> f64 {
        self.ray.direction.dot(self.center - self.ray.origin)
    }

    /// Computes c = oc·oc − r², rounded, with oc = center − origin: negative if the ray starts
    /// inside.
    pub fn c(&self) -> f64 {
        (self.center - self.ray.origin).length_squared() - self.radius * self.radius
    }

    /// Computes D = h² − a·c, rounded as `half_b`, `half_b_q` and the filter of the certified
    /// methods round it, to the bit.
    pub fn discriminant(&self) -> f64 {
        self.h() * self.h() - self.a() * self.c()
    }

    /// Returns the ten numbers of the case, each vector as x, y, z: the center, the radius, the
    /// ray's origin, the ray's direction.
    pub fn numbers(&self) -> [f64; 10] {
        let ([cx, cy, cz], r) = (self.center.to_array(), self.radius);
        let [qx, qy, qz] = self.ray.origin.to_array();
        let [dx, dy, dz] = self.ray.direction.to_array();
        [cx, cy, cz, r, qx, qy, qz, dx, dy, dz]
    }

    /// Makes a case from its ten numbers, in the order of [`Case::numbers`].
    pub fn from_numbers([cx, cy, cz, r, qx, qy, qz, dx, dy, dz]: [f64; 10]) -> Self {
        Self {
            center: Point3::new(cx, cy, cz),
            radius: r,
            ray: Ray::new(Point3::new(qx, qy, qz), Vec3::new(dx, dy, dz)),
        }
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let vector = |v: Vec3| format!("({:?}, {:?}, {:?})", v.x, v.y, v.z);
        write!(
            f,
            "let center = Point3::new{};\nlet radius = {:?};\nlet ray = Ray::new(Point3::new{}, Vec3::new{});",
            vector(self.center),
            self.radius,
            vector(self.ray.origin),
            vector(self.ray.direction),
        )
    }
}
