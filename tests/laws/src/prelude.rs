//! Laws for a prelude: each operator and function of vectors and rays is asked directly,
//! with numbers so small that the answer can be worked out by head.

use std::mem::discriminant;

use common::rtweekend::*;
use slips::{Chapter, Program};

use crate::numbers::in_words;
use crate::question::{Question, RAYS};
use crate::verdict::{Broken, Verdict};

/// Vectors and rays, as somebody computes them.
#[allow(missing_docs)] // Each field is named after the function that it calls.
pub struct Prelude<'a> {
    pub add: &'a dyn Fn(Vec3, Vec3) -> Vec3,
    pub sub: &'a dyn Fn(Vec3, Vec3) -> Vec3,
    pub neg: &'a dyn Fn(Vec3) -> Vec3,
    pub mul: &'a dyn Fn(f64, Vec3) -> Vec3,
    pub dot: &'a dyn Fn(Vec3, Vec3) -> f64,
    pub length_squared: &'a dyn Fn(Vec3) -> f64,
    pub length: &'a dyn Fn(Vec3) -> f64,
    pub normalize: &'a dyn Fn(Vec3) -> Vec3,
    pub ray: &'a dyn Fn(Point3, Vec3) -> Ray,
    pub at: &'a dyn Fn(Ray, f64) -> Point3,
}

/// What a prelude is asked: one of its functions, and what it is given.
#[allow(missing_docs)] // As above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Asked {
    Mul(f64, Vec3),
    Add(Vec3, Vec3),
    Neg(Vec3),
    Sub(Vec3, Vec3),
    Dot(Vec3, Vec3),
    LengthSquared(Vec3),
    Length(Vec3),
    Normalize(Vec3),
    Ray(Point3, Vec3),
    At(Ray, f64),
}

/// A function of a prelude answers as small numbers say, where it is written at all.
///
/// They are added and multiplied without rounding, so this holds to the bit, but for a
/// unit vector. One question tells a product that is rounded before the sum from a fused
/// one: 10 · 0.1 is 1 to an `f64`, though `0.1` is a little more than a tenth.
///
/// A swapped letter (`u.z * u.z`) draws the right picture in four chapters of five, because
/// there every z is −1.
pub fn small_numbers_are_worked_out_by_head(
    answer: &dyn Fn(&Asked) -> Option<Vec<f64>>,
    asked: &Asked,
) -> Verdict {
    let (found, expected) = (answer(asked), asked.right());
    if asked.same(&found, &expected) {
        return Ok(());
    }
    let [law, usually, page] = asked.law();
    let said = |answer: Option<Vec<f64>>| words(&answer.unwrap_or_default());
    Err(Broken {
        law,
        found: format!("{} is {}", asked.call(words), said(found)),
        allowed: said(expected),
        usually,
        page,
    })
}

impl Asked {
    /// What the prelude answers, as numbers.
    pub fn put_to(&self, prelude: &Prelude) -> Vec<f64> {
        match *self {
            Self::Mul(t, v) => numbers((prelude.mul)(t, v)),
            Self::Add(u, v) => numbers((prelude.add)(u, v)),
            Self::Neg(v) => numbers((prelude.neg)(v)),
            Self::Sub(u, v) => numbers((prelude.sub)(u, v)),
            Self::Dot(u, v) => vec![(prelude.dot)(u, v)],
            Self::LengthSquared(v) => vec![(prelude.length_squared)(v)],
            Self::Length(v) => vec![(prelude.length)(v)],
            Self::Normalize(v) => numbers((prelude.normalize)(v)),
            Self::Ray(origin, direction) => of_ray((prelude.ray)(origin, direction)),
            Self::At(ray, t) => numbers((prelude.at)(ray, t)),
        }
    }

    /// What the program answers.
    pub fn put_to_program(&self, program: &Program) -> Vec<f64> {
        let squared = |v| (program.squared)(program, v);
        self.put_to(&Prelude {
            // The book divides by multiplying with the reciprocal.
            mul: &|t, v| (program.over)(v, 1.0 / t),
            add: &program.plus,
            neg: &|v| -v,
            sub: &|u, v| u - v,
            dot: &program.dot,
            length_squared: &squared,
            length: &|v| squared(v).sqrt(),
            normalize: &program.unit,
            ray: &Ray::new,
            at: &|ray, t| (program.at)(program, &ray, t),
        })
    }

    /// The function, and what it is given, each number, vector and ray `written` in some way.
    fn call(&self, written: fn(&[f64]) -> String) -> String {
        let (function, given) = match *self {
            Self::Mul(t, v) => ("mul", vec![vec![t], numbers(v)]),
            Self::Add(u, v) => ("add", vec![numbers(u), numbers(v)]),
            Self::Neg(v) => ("neg", vec![numbers(v)]),
            Self::Sub(u, v) => ("sub", vec![numbers(u), numbers(v)]),
            Self::Dot(u, v) => ("dot", vec![numbers(u), numbers(v)]),
            Self::LengthSquared(v) => ("length_squared", vec![numbers(v)]),
            Self::Length(v) => ("length", vec![numbers(v)]),
            Self::Normalize(v) => ("normalize", vec![numbers(v)]),
            Self::Ray(origin, direction) => ("ray", vec![numbers(origin), numbers(direction)]),
            Self::At(ray, t) => ("at", vec![of_ray(ray), vec![t]]),
        };
        let given: Vec<String> = given.iter().map(|it| written(it)).collect();
        format!("{function}({})", given.join(", "))
    }

    /// The law, what breaks it most often, and where to read of it.
    fn law(&self) -> [&'static str; 3] {
        match self {
            Self::Mul(..) => [
                "a number times a vector multiplies each letter",
                "a letter stands twice, or is left out",
                EQUATION_OF_A_RAY,
            ],
            Self::Add(..) => [
                "a sum of vectors adds equal letters",
                "a letter stands twice: u.x + v.x, u.y + v.y, u.z + v.z",
                EQUATION_OF_A_RAY,
            ],
            Self::Neg(_) => [
                "minus a vector turns the sign of each letter",
                "a minus is missing, or a letter stands twice",
                "chapter 5: outward, or against the ray",
            ],
            Self::Sub(..) => [
                "a difference of vectors subtracts equal letters",
                "a plus where a minus should be, or the two are swapped",
                "chapter 2: oc",
            ],
            Self::Dot(..) => [
                "a dot product multiplies equal letters and adds",
                "a letter is swapped: u.x*v.x + u.y*v.y + u.z*v.z",
                "equation (5) of the notes",
            ],
            Self::LengthSquared(_) => [
                "the square of a length is the vector times itself",
                "a letter is swapped, or the root is taken: v.x*v.x + v.y*v.y + v.z*v.z",
                "equation (5) of the notes",
            ],
            Self::Length(_) => [
                "a length is the root of its square",
                "the root is not taken, or twice",
                COLOR_OF_THE_SKY,
            ],
            Self::Normalize(_) => [
                "a unit vector has length 1 and points where the vector does",
                "the vector is not divided by its length, the root of v.x² + v.y² + v.z²",
                COLOR_OF_THE_SKY,
            ],
            Self::Ray(..) => [
                "a ray has the origin and the direction that it is made of",
                "the two are swapped",
                EQUATION_OF_A_RAY,
            ],
            Self::At(..) => [
                "the point at t is t directions away from the origin",
                "the origin is left out, the direction is changed first, or the product and the \
                 sum are fused",
                EQUATION_OF_A_RAY,
            ],
        }
    }
}

const EQUATION_OF_A_RAY: &str = "equation (1) of the notes";
const COLOR_OF_THE_SKY: &str = "chapter 1: the color of the sky";

impl Question for Asked {
    /// None of a function that is not written yet.
    type Answer = Option<Vec<f64>>;

    const KIND: &'static str = "prelude";

    const FUNCTION: &'static str = "prelude";

    const CHAPTERS: &'static [Chapter] = RAYS;

    fn answer_of(&self, program: &Program) -> Self::Answer {
        Some(self.put_to_program(program))
    }

    fn same(&self, one: &Self::Answer, other: &Self::Answer) -> bool {
        let rounding = match self {
            Self::Normalize(_) => 1e-12,
            _ => 0.0,
        };
        let near = |(one, other): (&f64, &f64)| {
            one == other || (one - other).abs() <= rounding || one.is_nan() && other.is_nan()
        };
        match (one, other) {
            (Some(one), Some(other)) => one.iter().zip(other).all(near),
            _ => true,
        }
    }

    fn telling() -> Vec<Self> {
        let v = |x: i32, y: i32, z: i32| Vec3::new(x.into(), y.into(), z.into());
        let (u, w) = (v(1, 2, 3), v(4, 5, 6));
        let ray = Ray::new(v(1, -2, 3), v(5, 7, -11));
        let rounds = Ray::new(Point3::splat(-1.0), Vec3::splat(10.0));
        vec![
            Self::Mul(2.0, u),
            Self::Mul(-0.5, v(8, -2, 6)),
            Self::Add(u, w),
            Self::Add(v(-4, 9, 2), v(3, -8, 6)),
            Self::Neg(u),
            Self::Neg(v(-4, 5, -6)),
            Self::Sub(w, v(1, 3, 2)),
            Self::Sub(v(-4, 9, 2), v(3, -8, 6)),
            Self::Dot(u, w),
            Self::Dot(w, u),
            Self::Dot(v(1, 0, 0), v(0, 1, 0)),
            Self::Dot(v(0, 1, 0), v(0, 0, 1)),
            Self::Dot(v(-4, 9, 2), v(3, -8, 6)),
            Self::LengthSquared(u),
            Self::LengthSquared(v(4, 0, -3)),
            Self::Length(v(1, 2, 2)),
            Self::Length(v(4, 0, -3)),
            Self::Normalize(v(0, 4, 0)),
            Self::Normalize(v(0, 3, 4)),
            Self::Normalize(v(1, 2, -2)),
            Self::Normalize(Vec3::new(0.125, 0.0, 0.0)),
            Self::Ray(u, w),
            Self::At(Ray::new(u, w), 2.0),
            Self::At(ray, 0.0),
            Self::At(ray, -2.0),
            Self::At(rounds, 0.1),
        ]
    }

    fn is_akin(&self, other: &Self) -> bool {
        discriminant(self) == discriminant(other)
    }

    fn as_test(&self, prelude: &str) -> String {
        let right = code(&self.right().unwrap_or_default());
        let call = self.call(code).replacen('(', ")(", 1);
        let found = format!("({prelude}().{call}");
        match self {
            Self::Normalize(_) => format!("assert!(({found} - {right}).length() < 1e-9);"),
            _ => format!("assert_eq!({found}, {right});"),
        }
    }
}

fn numbers(v: Vec3) -> Vec<f64> {
    v.to_array().to_vec()
}

fn of_ray(ray: Ray) -> Vec<f64> {
    [numbers(ray.origin), numbers(ray.direction)].concat()
}

/// A number, a vector or a ray as a person writes it.
fn words(numbers: &[f64]) -> String {
    match numbers {
        [number] => format!("{number}"),
        &[x, y, z] => in_words(Vec3::new(x, y, z)),
        _ => {
            let (origin, direction) = numbers.split_at(3);
            format!("{} + t*{}", words(origin), words(direction))
        }
    }
}

/// The same as Rust has it.
fn code(numbers: &[f64]) -> String {
    match numbers {
        [number] => format!("{number:?}"),
        [x, y, z] => format!("Vec3::new({x:?}, {y:?}, {z:?})"),
        _ => {
            let (origin, direction) = numbers.split_at(3);
            format!("Ray::new({}, {})", code(origin), code(direction))
        }
    }
}
