//! Questions: what each kind of function is asked. All answers are plain numbers, so they
//! can be compared, kept in a file, and read again.

use std::fmt::Debug;

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Chapter, Program};

use crate::intervals::WithInterval;
use crate::list::World;
use crate::prelude::Asked;
use crate::strategies::samples;

/// What a function under test is asked.
pub trait Question: Debug + Send + Sync + 'static {
    /// What questions of this kind are called in a file of answers.
    fn kind(&self) -> &'static str;

    /// What the program of a chapter that has such a function answers.
    fn answer_of(&self, program: &Program) -> Vec<f64>;

    /// Whether two answers are the same, but for roundings.
    fn same(&self, one: &[f64], other: &[f64]) -> bool {
        same(one, other)
    }

    /// The body of a test that asks the function of the chapter this again. It stands where
    /// the function has its name, so it need not guess from where to import it.
    fn as_test(&self, chapter: Chapter) -> String;

    /// Ordinary questions to the function of the chapter. Rounding decides none of them.
    fn ordinary(chapter: Chapter) -> BoxedStrategy<Self>
    where
        Self: Sized;

    /// All kinds of questions, those first that teach most.
    fn kinds(chapter: Chapter) -> Vec<BoxedStrategy<Self>>
    where
        Self: Sized,
    {
        vec![Self::ordinary(chapter)]
    }

    /// Questions to which different mistakes give different answers, always the same ones:
    /// enough for every slip. With fewer, some answer as others do.
    fn telling(chapter: Chapter) -> Vec<Self>
    where
        Self: Sized,
    {
        samples(&Self::ordinary(chapter), 250)
    }
}

/// Whether two answers are the same, but for a thousand times as much rounding as they
/// take in ordinary questions.
pub fn same(one: &[f64], other: &[f64]) -> bool {
    let near = |(one, other): (&f64, &f64)| {
        let allowed = 1e-9 * (1.0 + one.abs() + other.abs());
        one == other || (one - other).abs() <= allowed || one.is_nan() && other.is_nan()
    };
    one.len() == other.len() && one.iter().zip(other).all(near)
}

/// The telling questions to all functions of the chapter, in the order in which they are put.
pub(crate) fn all(chapter: Chapter) -> Vec<Box<dyn Question>> {
    let mut all = Vec::new();
    if chapter > Chapter::BuildTest {
        all.extend(of::<Asked>(chapter));
    }
    if chapter > Chapter::Gradient {
        all.extend(of::<WithInterval>(chapter));
    }
    if chapter == Chapter::HittableList {
        all.extend(of::<World>(chapter));
    }
    if chapter > Chapter::BuildTest {
        all.extend(of::<Ray>(chapter));
    }
    all
}

fn of<Q: Question>(chapter: Chapter) -> Vec<Box<dyn Question>> {
    let telling = Q::telling(chapter).into_iter();
    telling.map(|it| Box::new(it) as _).collect()
}

/// The numbers of a ray.
pub(crate) fn of_ray(ray: Ray) -> Vec<f64> {
    [ray.origin.to_array(), ray.direction.to_array()].concat()
}

/// A number, a vector or a ray as Rust has it.
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

/// A vector as Rust has it.
pub(crate) fn vector(v: Vec3) -> String {
    code(&v.to_array())
}
