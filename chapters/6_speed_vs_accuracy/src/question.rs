//! One ray and one sphere, as every method is asked about them.

use common::rtweekend::*;

use crate::method::{Method, Solve};
use crate::single::SingleRay;

/// Does this ray meet this sphere, and where?
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Question {
    /// The center of the sphere.
    pub center: Point3,
    /// The radius of the sphere.
    pub radius: f64,
    /// The ray.
    pub ray: Ray,
}

/// The two kinds of numbers that methods compute with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// `f64`: 53 digits of base two, exponents to ±1000.
    Double,
    /// `f32`: 24 digits, exponents to ±126.
    Single,
}

impl Question {
    /// What `method` answers: the nearest root between `t_min` and `t_max`.
    ///
    /// A method in `f32` is asked the question [rounded](Question::rounded), and
    /// its answer widened.
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

    /// The question with numbers that `precision` can hold, the nearest ones:
    /// itself in `f64`.
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

    /// Where the ray is at `t`, computed in `precision`.
    pub fn point(&self, t: f64, precision: Precision) -> Point3 {
        match precision {
            Precision::Double => self.ray.at(t),
            Precision::Single => {
                let SingleRay { origin, direction } = self.single_ray();
                (origin + t as f32 * direction).as_dvec3()
            }
        }
    }

    /// The ray, rounded to `f32`.
    #[inline]
    pub fn single_ray(&self) -> SingleRay {
        SingleRay {
            origin: self.ray.origin.as_vec3(),
            direction: self.ray.direction.as_vec3(),
        }
    }
}

impl Precision {
    /// The precision that `method` computes with, seen from outside.
    pub fn of(method: &Method) -> Self {
        match method.solve {
            Solve::Double(_) => Self::Double,
            Solve::Single(_) => Self::Single,
        }
    }

    /// As it is called in Rust.
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "f64",
            Self::Single => "f32",
        }
    }
}
