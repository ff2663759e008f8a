//! Questions: what each kind of function is asked. All answers are plain numbers, so they
//! can be compared, kept in a file, and read again.

use std::fmt::{self, Debug};

use common::rtweekend::*;
use slips::{Chapter, Program};
use speed_vs_accuracy::Case;

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
}

/// Whether two answers are the same, but for a thousand times as much rounding as they
/// take in ordinary questions.
pub fn same(one: &[f64], other: &[f64]) -> bool {
    let near = |(one, other): (&f64, &f64)| {
        let allowed = 1e-9 * (1.0 + one.abs() + other.abs());
        let is_near = allowed.is_finite() && (one - other).abs() <= allowed;
        one == other || is_near || one.is_nan() && other.is_nan()
    };
    one.len() == other.len() && one.iter().zip(other).all(near)
}

/// A case with a range of `t`, as a sphere of chapter 5 takes it. Before, the range is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithInterval {
    /// The ray and the sphere.
    pub case: Case,
    /// The lower end, left out.
    pub t_min: f64,
    /// The upper end, left out.
    pub t_max: f64,
}

/// A function from center, radius, ray, `t_min` and `t_max` to the nearest root
/// between the two.
pub type RangeSolver<'a> = dyn Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> + 'a;

impl WithInterval {
    /// The answer of `solve` to this case.
    pub fn solve(&self, solve: &RangeSolver) -> Option<f64> {
        let Case {
            center,
            radius,
            ray,
        } = &self.case;
        solve(*center, *radius, ray, self.t_min, self.t_max)
    }
}

impl fmt::Display for WithInterval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { case, t_min, t_max } = self;
        let [t_min, t_max] = [t_min, t_max].map(|&end| code(&[end]));
        write!(f, "{case}\nlet (t_min, t_max) = ({t_min}, {t_max});")
    }
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
