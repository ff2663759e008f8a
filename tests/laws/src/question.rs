//! Questions to each kind of function, with answers as plain numbers, which can be compared, kept
//! in a file, and read again.

use std::fmt::Debug;

use common::rtweekend::*;
use proptest::strategy::Strategy;

use crate::camera::CameraPixel;
use crate::case::{Case, IntervalCase, ray_from};
use crate::list::World;
use crate::oracle::ExactCase;
use crate::prelude::{PRELUDE_FUNCTIONS, PreludeQuestion};
use crate::record::RecordedHit;
use crate::strategies::samples;

pub use crate::case::numbers_of_ray;

/// A question to one function of a program, with all numbers that the function is given. Each
/// variant is for one kind of function.
#[derive(Clone, Debug)]
pub enum Question {
    /// Small numbers for a function or operator on the program's vectors or rays.
    Prelude(PreludeQuestion),
    /// A ray and a sphere for the `hit_sphere` of chapter 2, which only decides between hit and
    /// miss.
    Decision(Case),
    /// A ray and a sphere for the `hit_sphere` of chapters 3 and 4, which returns the nearer root.
    Root(Case),
    /// A ray, a sphere and an interval for the `Sphere::hit` of chapter 5, which returns a record.
    Record(IntervalCase),
    /// A ray, spheres and an interval for the `HittableList::hit` of chapter 5, which is asked for
    /// the `t` of the nearest hit.
    Nearest(World),
    /// A ray for `ray_color`, which returns the color of what the ray meets.
    RayColor(Ray),
    /// A pixel for the camera, which returns the ray through the pixel.
    PixelRay(CameraPixel),
}

impl Question {
    /// Returns true if two answers to this question, as a [`Trial`](crate::Trial) records them, are
    /// equal, up to rounding.
    pub fn answers_agree(&self, one: &[f64], other: &[f64]) -> bool {
        match self {
            Self::Prelude(asked) => asked.answers_agree(one, other),
            _ => nearly_equal(one, other),
        }
    }

    /// Returns the name of the kind of this question in a file of answers.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Prelude(asked) => asked.function.name(),
            Self::Decision(_) => "decision",
            Self::Root(_) => "root",
            Self::Record(_) => "record",
            Self::Nearest(_) => "nearest",
            Self::RayColor(_) => "ray_color",
            Self::PixelRay(_) => "pixel_ray",
        }
    }

    /// Lists all numbers of the question in the order in which a file of answers has them: of a
    /// case as [`Case::numbers`], then `t_min` and `t_max`; of a ray the origin, then the
    /// direction; of a pixel the width, the column and the row; of a list the ray, both ends, then
    /// center and radius of each sphere; for a prelude two vectors and `t`.
    pub fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Prelude(PreludeQuestion { u, v, t, .. }) => {
                [&u.to_array()[..], &v.to_array(), &[*t]].concat()
            }
            Self::Decision(case) | Self::Root(case) => case.numbers().to_vec(),
            Self::Record(IntervalCase { case, t_min, t_max }) => {
                [&case.numbers()[..], &[*t_min, *t_max]].concat()
            }
            Self::Nearest(world) => world.numbers(),
            Self::RayColor(ray) => numbers_of_ray(*ray),
            Self::PixelRay(CameraPixel { width, i, j }) => {
                [width, i, j].map(|&it| it.into()).to_vec()
            }
        }
    }

    /// Makes the question of that kind from its numbers; `None` if there is no such kind, or the
    /// count of numbers does not fit.
    pub(crate) fn read(kind: &str, numbers: &[f64]) -> Option<Self> {
        let case = || Some(Case::from_numbers(numbers.try_into().ok()?));
        Some(match (kind, numbers) {
            ("decision", _) => Self::Decision(case()?),
            ("root", _) => Self::Root(case()?),
            ("record", [case @ .., t_min, t_max]) => Self::Record(IntervalCase {
                case: Case::from_numbers(case.try_into().ok()?),
                t_min: *t_min,
                t_max: *t_max,
            }),
            ("nearest", _) => Self::Nearest(World::read(numbers)?),
            ("ray_color", &[x, y, z, dx, dy, dz]) => {
                Self::RayColor(ray_from(Vec3::new(x, y, z), Vec3::new(dx, dy, dz)))
            }
            ("pixel_ray", numbers) => {
                let numbers: [f64; 3] = numbers.try_into().ok()?;
                let [width, i, j] = numbers.map(|it| it as u32);
                Self::PixelRay(CameraPixel { width, i, j })
            }
            (name, &[x, y, z, vx, vy, vz, t]) => Self::Prelude(PreludeQuestion {
                function: PRELUDE_FUNCTIONS.iter().find(|it| it.name() == name)?,
                u: Vec3::new(x, y, z),
                v: Vec3::new(vx, vy, vz),
                t,
            }),
            _ => return None,
        })
    }
}

/// Draws the first 250 values of a strategy, in its order. They are the same in every run, and
/// enough that different mistakes in a function give different answers.
pub fn telling_cases<T: Debug>(strategy: &impl Strategy<Value = T>) -> Vec<T> {
    samples(strategy, 250)
}

/// Returns true if two answers have equally many numbers, and each pair of them differs by at most
/// 10⁻⁹ · (1 + |one| + |other|), about a thousand times the rounding of ordinary questions. Two NaN
/// are equal here, and so are equal infinities.
pub fn nearly_equal(one: &[f64], other: &[f64]) -> bool {
    let near = |(one, other): (&f64, &f64)| {
        let allowed = 1e-9 * (1.0 + one.abs() + other.abs());
        let is_near = allowed.is_finite() && (one - other).abs() <= allowed;
        one == other || is_near || one.is_nan() && other.is_nan()
    };
    one.len() == other.len() && one.iter().zip(other).all(near)
}

/// Lists a decision's number: 0 for a hit, none for a miss.
pub fn decided(is_hit: bool) -> Vec<f64> {
    is_hit.then_some(0.0).into_iter().collect()
}

/// Lists the numbers of a record: `t`, the front face as 0 or 1, the point, the normal. A miss has
/// none; a tangent only `t`, since there rounding decides which side is hit.
pub fn numbers_of_hit(asked: &IntervalCase, hit: Option<RecordedHit>) -> Vec<f64> {
    let Some(hit) = hit else {
        return Vec::new();
    };
    if ExactCase::of(&asked.case).discriminant().is_eq() {
        return vec![hit.t];
    }
    let vectors = [hit.point.to_array(), hit.normal.to_array()].concat();
    [vec![hit.t, f64::from(hit.front_face)], vectors].concat()
}
