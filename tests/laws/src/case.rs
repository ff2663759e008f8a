//! A case: the ray and the sphere about which a law asks a function, alone or with a range of `t`.

use std::fmt;

use common::rtweekend::*;

use crate::nearer_root::Solver;

/// A ray and a sphere: where does the one meet the other?
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// The center of the sphere.
    pub center: Point3,
    /// The radius of the sphere; its sign does not matter.
    pub radius: f64,
    /// The ray.
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

    /// Returns the answer of `solve` to this case; `None` for a miss.
    pub fn solve(&self, solve: &Solver) -> Option<f64> {
        solve(self.center, self.radius, &self.ray)
    }

    /// Computes a = d·d, rounded: the squared length of the ray's direction.
    pub fn a(&self) -> f64 {
        self.ray.direction.length_squared()
    }

    /// Computes h = d·oc, rounded, with oc = center − origin: half of −b in the quadratic equation.
    pub fn h(&self) -> f64 {
        self.ray.direction.dot(self.center - self.ray.origin)
    }

    /// Computes M = oc·oc + r², rounded, with oc = center − origin: the square of the length that
    /// rounding errors are compared with. Nothing in the quadratic is much longer than √M.
    pub fn m(&self) -> f64 {
        (self.center - self.ray.origin).length_squared() + self.radius * self.radius
    }

    /// Computes √(M/a), the length √M in lengths of the ray's direction. No root is farther away
    /// than twice that. Infinite or NaN if the direction is zero.
    pub fn t_scale(&self) -> f64 {
        // The roots of both first: the quotient may be too small for a number.
        self.m().sqrt() / self.a().sqrt()
    }

    /// Returns true if no step of finding the root overflows, and no underflow is large enough to
    /// matter. False for a direction of zero, NaN or an infinite number.
    ///
    /// Between 1e-300 and 1e300, twenty times a·M is still a number, and what underflow takes away,
    /// 5e-324 at a time, is far below u·a·M. All error bounds hold on this condition.
    pub fn is_well_scaled(&self) -> bool {
        let (a, m) = (self.a(), self.m());
        [a, m, a * m]
            .iter()
            .all(|scale| (1e-300..=1e300).contains(scale))
    }

    /// Returns the case of the same sphere and another ray, from `origin` along `direction`.
    pub fn with_ray(&self, origin: Point3, direction: Vec3) -> Self {
        Self::new(self.center, self.radius, ray_from(origin, direction))
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
        let ray = ray_from(Point3::new(qx, qy, qz), Vec3::new(dx, dy, dz));
        Self::new(Point3::new(cx, cy, cz), r, ray)
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [center, radius, ray] = [
            &self.center.to_array()[..],
            &[self.radius],
            &numbers_of_ray(self.ray),
        ]
        .map(code);
        write!(
            f,
            "let center = {center};\nlet radius = {radius};\nlet ray = {ray};"
        )
    }
}

/// A ray, a sphere and an open interval of `t` in which a hit counts, as the `Sphere::hit` of
/// chapter 5 takes them. No hit counts if `t_min` is not below `t_max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntervalCase {
    /// The ray and the sphere.
    pub case: Case,
    /// The lower end of the interval, excluded, in lengths of the ray's direction.
    pub t_min: f64,
    /// The upper end of the interval, excluded, in lengths of the ray's direction.
    pub t_max: f64,
}

/// A function that takes center, radius, ray, `t_min` and `t_max`, and returns the nearest root
/// between the two, both excluded, in lengths of the direction; `None` if there is none.
pub type RangeSolver<'a> = dyn Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> + 'a;

impl IntervalCase {
    /// Combines a ray and a sphere with the interval in which a camera sees what is hit, from 0 to
    /// ∞.
    pub fn ahead(case: Case) -> Self {
        let (t_min, t_max) = (0.0, f64::INFINITY);
        Self { case, t_min, t_max }
    }

    /// Combines a ray and a sphere with the unbounded interval, from −∞ to ∞.
    pub fn unbounded(case: Case) -> Self {
        let (t_min, t_max) = (f64::NEG_INFINITY, f64::INFINITY);
        Self { case, t_min, t_max }
    }

    /// Calls `solve` with the numbers of this case, and returns its answer.
    pub fn solve(&self, solve: &RangeSolver) -> Option<f64> {
        let case = &self.case;
        solve(case.center, case.radius, &case.ray, self.t_min, self.t_max)
    }
}

impl fmt::Display for IntervalCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { case, t_min, t_max } = self;
        let [t_min, t_max] = [t_min, t_max].map(|&end| code(&[end]));
        write!(f, "{case}\nlet (t_min, t_max) = ({t_min}, {t_max});")
    }
}

/// Lists the numbers of a ray: origin, then direction.
pub fn numbers_of_ray(ray: Ray) -> Vec<f64> {
    [ray.origin.to_array(), ray.direction.to_array()].concat()
}

/// Makes the ray from `origin` along `direction`. Laws use no function that they may judge.
pub(crate) const fn ray_from(origin: Point3, direction: Vec3) -> Ray {
    Ray { origin, direction }
}

/// Computes the point of a ray at the parameter `t`, by no function that laws may judge.
pub(crate) fn point_at(ray: &Ray, t: f64) -> Point3 {
    ray.origin + t * ray.direction
}

/// Writes one number, the three of a vector or the six of a ray as an expression of Rust.
pub(crate) fn code(numbers: &[f64]) -> String {
    match *numbers {
        [f64::INFINITY] => "f64::INFINITY".to_owned(),
        [f64::NEG_INFINITY] => "f64::NEG_INFINITY".to_owned(),
        [number] => format!("{number:?}"),
        [x, y, z] => format!("Vec3::new({x:?}, {y:?}, {z:?})"),
        _ => {
            let (origin, direction) = numbers.split_at(3);
            format!("Ray::new({}, {})", code(origin), code(direction))
        }
    }
}

/// Writes a vector as an expression of Rust.
pub(crate) fn vector(v: Vec3) -> String {
    code(&v.to_array())
}
