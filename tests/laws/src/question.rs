//! Questions to each kind of function, with answers as plain numbers, which can be compared, kept
//! in a file, and read again.

use std::fmt::Debug;

use common::rtweekend::*;
use proptest::strategy::Strategy;

use crate::camera::CameraPixel;
use crate::case::{Case, IntervalCase, of_ray};
use crate::list::World;
use crate::oracle::ExactCase;
use crate::prelude::{PRELUDE_FUNCTIONS, Prelude, PreludeQuestion};
use crate::ray_color;
use crate::record::RecordedHit;
use crate::strategies::{self, samples};

/// A question to one function of a program, with all numbers that the function is given. Each
/// variant is for one kind of function.
#[derive(Clone, Debug)]
pub enum Question {
    /// Small numbers for a function or operator on the program's vectors or rays, its [`Prelude`].
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

/// The functions of a program, in the form in which a [`Question`] calls them. The provided methods
/// are those of `common`, which are right, for programs without a camera or vectors of their own.
pub trait Functions {
    /// Returns the nearer `t` at which the line of the ray meets the sphere, in lengths of the
    /// direction, negative behind the origin; any number for a hit if the program only decides.
    /// `None` for a miss.
    fn hit_sphere(&self, case: &Case) -> Option<f64>;
    /// Returns the record of the nearest hit of a sphere between the ends of an interval, both
    /// excluded; `None` for a miss.
    fn record(&self, asked: &IntervalCase) -> Option<RecordedHit>;
    /// Returns the `t` of the nearest hit of several spheres between the ends of an interval, both
    /// excluded, in lengths of the direction; `None` for a miss.
    fn nearest(&self, world: &World) -> Option<f64>;
    /// Returns the color of what the ray meets in the program's scene, each component linear from 0
    /// to 1.
    fn ray_color(&self, ray: &Ray) -> Color;

    /// Returns the ray that the program's camera casts through a pixel; provided: the right one.
    fn pixel_ray(&self, pixel: &CameraPixel) -> Ray {
        pixel.expected_ray()
    }
    /// Returns the dot product of two vectors.
    fn dot(&self, u: Vec3, v: Vec3) -> f64 {
        u.dot(v)
    }
    /// Returns the squared length of a vector.
    fn length_squared(&self, v: Vec3) -> f64 {
        v.length_squared()
    }
    /// Returns the unit vector in the direction of `v`, which no question makes zero.
    fn normalize(&self, v: Vec3) -> Vec3 {
        v.normalize()
    }
}

/// How many questions tell mistakes in one function apart. With fewer, some mistakes give equal
/// answers.
const TELLING: u32 = 250;

impl Question {
    /// Lists twenty [telling questions](telling_cases) to each of the ten functions on vectors and
    /// rays, function by function, in the order of [`PRELUDE_FUNCTIONS`].
    pub fn of_prelude() -> Vec<Self> {
        let telling = PRELUDE_FUNCTIONS.iter().flat_map(|it| it.telling_cases());
        telling.map(Self::Prelude).collect()
    }

    /// Lists [telling questions](telling_cases) about one ray and one sphere: whether the ray hits,
    /// if `kind` is [`Question::Decision`], or at which `t`, if it is [`Question::Root`].
    pub fn of_sphere(kind: fn(Case) -> Self) -> Vec<Self> {
        of(kind, &strategies::ordinary())
    }

    /// Lists [telling questions](telling_cases) that ask for the record of a ray's hit with one
    /// sphere in an interval.
    pub fn of_record() -> Vec<Self> {
        of(Self::Record, &strategies::ordinary_with_interval())
    }

    /// Lists [telling questions](telling_cases) that ask for the `t` of a ray's nearest hit with
    /// several spheres.
    pub fn of_list() -> Vec<Self> {
        of(Self::Nearest, &strategies::worlds())
    }

    /// Lists [telling questions](telling_cases) that ask for the color of a ray.
    pub fn of_ray_color() -> Vec<Self> {
        of(Self::RayColor, &ray_color::rays())
    }

    /// Calls the function of `program` that the question is about, and returns the answer as
    /// numbers: empty for a miss, `t` for a root, 0 for a hit that is only decided, three
    /// components for a color or vector, six for a ray. A record has `t`, 1 or 0 for the front
    /// face, the point and the normal, in this order; that of a tangent only `t`. A panic in the
    /// program is passed on.
    pub fn put_to(&self, program: &dyn Functions) -> Vec<f64> {
        match self {
            Self::Prelude(asked) => Prelude::of_program(program, |prelude| asked.put_to(prelude)),
            Self::Decision(case) => decided(program.hit_sphere(case).is_some()),
            Self::Root(case) => program.hit_sphere(case).into_iter().collect(),
            Self::Record(asked) => of_hit(asked, program.record(asked)),
            Self::Nearest(world) => program.nearest(world).into_iter().collect(),
            Self::RayColor(ray) => program.ray_color(ray).to_array().to_vec(),
            Self::PixelRay(pixel) => of_ray(program.pixel_ray(pixel)),
        }
    }

    /// Returns true if two answers to this question, in the form of [`put_to`](Self::put_to), are
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
    /// center and radius of each sphere; for a [`Prelude`] two vectors and `t`.
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
            Self::RayColor(ray) => of_ray(*ray),
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
                Self::RayColor(Ray::new(Vec3::new(x, y, z), Vec3::new(dx, dy, dz)))
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

/// Turns the first 250 cases of a strategy into questions.
fn of<T: Debug>(kind: fn(T) -> Question, strategy: &impl Strategy<Value = T>) -> Vec<Question> {
    telling_cases(strategy).into_iter().map(kind).collect()
}

/// Draws the first 250 values of a strategy, in its order. They are the same in every run, and
/// enough that different mistakes in a function give different answers.
pub fn telling_cases<T: Debug>(strategy: &impl Strategy<Value = T>) -> Vec<T> {
    samples(strategy, TELLING)
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
pub(crate) fn decided(is_hit: bool) -> Vec<f64> {
    is_hit.then_some(0.0).into_iter().collect()
}

/// Lists the numbers of a record: `t`, the front face as 0 or 1, the point, the normal. A miss has
/// none; a tangent only `t`, since there rounding decides which side is hit.
pub(crate) fn of_hit(asked: &IntervalCase, hit: Option<RecordedHit>) -> Vec<f64> {
    let Some(hit) = hit else {
        return Vec::new();
    };
    if ExactCase::of(&asked.case).discriminant().is_eq() {
        return vec![hit.t];
    }
    let vectors = [hit.point.to_array(), hit.normal.to_array()].concat();
    [vec![hit.t, f64::from(hit.front_face)], vectors].concat()
}
