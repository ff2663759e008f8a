//! One question: does this ray meet this sphere, and where?

use std::fmt;

use common::rtweekend::*;

use crate::oracle::Exact;

/// A ray and a sphere. Prints as Rust code that can be pasted into a test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// The center of the sphere.
    pub center: Point3,
    /// The radius of the sphere.
    pub radius: f64,
    /// The ray.
    pub ray: Ray,
}

/// Half the distance from 1 to the next `f64`: the largest relative error of
/// one rounded operation.
pub const U: f64 = f64::EPSILON / 2.0;

impl Case {
    /// The same question with numbers that are never rounded.
    ///
    /// # Panics
    /// If a number is not finite: then there is no exact answer.
    pub fn exact(&self) -> Exact {
        Exact::new(self.center, self.radius, &self.ray)
            .expect("strategies make finite cases, and laws ask for finite ones only")
    }

    /// a = d·d, rounded: the squared length of the ray's direction.
    pub fn a(&self) -> f64 {
        self.ray.direction.length_squared()
    }

    /// M = oc·oc + r², rounded: the square of the length that rounding errors
    /// are measured against. Nothing in the quadratic is much longer than √M.
    pub fn m(&self) -> f64 {
        (self.center - self.ray.origin).length_squared() + self.radius * self.radius
    }

    /// √(M/a): how long √M is in lengths of the ray's direction. No root is
    /// farther away than twice that.
    pub fn t_scale(&self) -> f64 {
        (self.m() / self.a()).sqrt()
    }

    /// Whether no number on the way to the root overflows, and none that counts
    /// underflows.
    ///
    /// Between 1e-300 and 1e300, twenty times a·M is still a number, and what
    /// underflow takes away, 5e-324 at a time, is far below u·a·M. All error
    /// bounds hold on this condition.
    pub fn is_well_scaled(&self) -> bool {
        let (a, m) = (self.a(), self.m());
        [a, m, a * m]
            .iter()
            .all(|scale| (1e-300..=1e300).contains(scale))
    }

    /// The same ray, pointing the other way.
    pub fn turned_round(&self) -> Self {
        self.with_ray(self.ray.origin, -self.ray.direction)
    }

    /// The same sphere, with another ray.
    pub fn with_ray(&self, origin: Point3, direction: Vec3) -> Self {
        Self {
            ray: Ray::new(origin, direction),
            ..*self
        }
    }

    /// The ten numbers of the case: center, radius, origin, direction.
    pub fn numbers(&self) -> [f64; 10] {
        let ([cx, cy, cz], r) = (self.center.to_array(), self.radius);
        let [qx, qy, qz] = self.ray.origin.to_array();
        let [dx, dy, dz] = self.ray.direction.to_array();
        [cx, cy, cz, r, qx, qy, qz, dx, dy, dz]
    }

    /// The case with these ten numbers, in the order of [`Case::numbers`].
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

/// A case with a range of `t`, as the laws for intervals take it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithInterval {
    /// The ray and the sphere.
    pub case: Case,
    /// The lower end, left out.
    pub t_min: f64,
    /// The upper end, left out.
    pub t_max: f64,
}

impl fmt::Display for WithInterval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { case, t_min, t_max } = self;
        write!(f, "{case}\nlet (t_min, t_max) = ({t_min:?}, {t_max:?});")
    }
}
