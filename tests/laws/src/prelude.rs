//! Laws for a prelude: each operator and function of vectors and rays is asked directly,
//! with numbers so small that the answer can be worked out by head.

use common::rtweekend::*;
use proptest::prelude::*;

use crate::case::{code, numbers_of_ray, point_at, ray_from, vector};
use crate::nearer_root::U;
use crate::strategies::{ahead_if_zero, samples, whole_vector};
use crate::verdict::{BrokenLaw, LawResult};

/// A program's own vectors and rays, its *prelude*: their operators and functions, as closures that
/// laws ask one by one.
pub struct Prelude<'a> {
    /// Returns the sum of two vectors.
    pub add: &'a dyn Fn(Vec3, Vec3) -> Vec3,
    /// Returns the first vector minus the second.
    pub sub: &'a dyn Fn(Vec3, Vec3) -> Vec3,
    /// Returns the opposite of a vector: each component with the other sign.
    pub neg: &'a dyn Fn(Vec3) -> Vec3,
    /// Returns a number times a vector, component by component.
    pub mul: &'a dyn Fn(f64, Vec3) -> Vec3,
    /// Returns the dot product of two vectors.
    pub dot: &'a dyn Fn(Vec3, Vec3) -> f64,
    /// Returns the squared length of a vector.
    pub length_squared: &'a dyn Fn(Vec3) -> f64,
    /// Returns the length of a vector.
    pub length: &'a dyn Fn(Vec3) -> f64,
    /// Returns the unit vector in the direction of its argument, which the laws never make zero.
    pub normalize: &'a dyn Fn(Vec3) -> Vec3,
    /// Returns the ray that starts at a point and goes along a direction.
    pub ray: &'a dyn Fn(Point3, Vec3) -> Ray,
    /// Returns the point of a ray at `t`: the origin plus `t` times the direction.
    pub at: &'a dyn Fn(Ray, f64) -> Point3,
}

/// One of the ten functions of a [`Prelude`].
#[derive(Debug)]
pub struct PreludeFunction {
    /// A call of the function as Rust has it, with the vectors `u` and `v` and the number `t`.
    call: &'static str,
    /// The largest relative error that rounding may cause in an answer.
    rounding: f64,
    answer: PreludeCall,
}

/// A function that asks one function of a prelude, and lists the answer's numbers.
type PreludeCall = fn(&Prelude, &PreludeQuestion) -> Vec<f64>;

/// The arguments of a question to one function of a [`Prelude`]: two vectors and a number, of which
/// each function takes those that it needs.
#[derive(Clone, Copy, Debug)]
pub struct PreludeQuestion {
    pub(crate) function: &'static PreludeFunction,
    pub(crate) u: Vec3,
    pub(crate) v: Vec3,
    pub(crate) t: f64,
}

/// Tests that the asked function of `prelude` answers small numbers as one works them out by head.
///
/// The answer must be equal to the bit, but for a unit vector and a number times a vector, whose
/// components may have a relative error of 4u. In `at`, tenths tell a product that is rounded before
/// the sum from a fused one: 10 · 0.1 is 1 to an `f64`, though `0.1` is a little more than a tenth.
///
/// A swapped letter (`u.z * u.z`) draws the right picture in four chapters of five, because there
/// every z is −1.
pub fn small_numbers_are_worked_out_by_head(
    prelude: &Prelude,
    asked: &PreludeQuestion,
) -> LawResult {
    let (found, right) = (asked.put_to(prelude), asked.right());
    let name = asked.function.name();
    BrokenLaw::unless(asked.answers_agree(&found, &right), || BrokenLaw {
        law: "a function of the prelude gives what one works out by head".into(),
        found: format!("{name}{} is {}", asked.given(), code(&found)),
        allowed: code(&right),
        read: "chapter 1, and equations (1) to (5) of the notes".into(),
    })
}

impl PreludeFunction {
    /// Returns the name of the function, such as `dot`.
    pub(crate) fn name(&self) -> &'static str {
        self.call.split('(').next().expect("a call has a name")
    }

    /// Makes questions to this function: whole vectors with components from −9 to 9, and halves or
    /// tenths for `t`.
    pub(crate) fn questions(&'static self) -> impl Strategy<Value = PreludeQuestion> {
        let tenths = (1..=9).prop_map(|k| f64::from(k) / 10.0);
        let number = prop_oneof![(-8..=8).prop_map(|k| 0.5 * f64::from(k)), tenths];
        (whole_vector(9), whole_vector(9), number).prop_map(move |(u, v, t)| PreludeQuestion {
            function: self,
            u,
            v: ahead_if_zero(v),
            t,
        })
    }

    /// Lists twenty questions, always the same ones, by whose answers mistakes in this function
    /// differ.
    pub fn telling_cases(&'static self) -> Vec<PreludeQuestion> {
        samples(&self.questions(), 20)
    }
}

impl PreludeQuestion {
    /// Returns the answer of a prelude as numbers.
    pub fn put_to(&self, prelude: &Prelude) -> Vec<f64> {
        (self.function.answer)(prelude, self)
    }

    fn right(&self) -> Vec<f64> {
        // The rays of `common` are under this law, too.
        self.put_to(&Prelude {
            ray: &|origin, direction| Ray { origin, direction },
            at: &|ray, t| point_at(&ray, t),
            ..Prelude::of_common()
        })
    }

    /// Writes the arguments in parentheses, as Rust has them.
    fn given(&self) -> String {
        let (_, given) = self.function.call.split_at(self.function.name().len());
        given
            .replace('u', &vector(self.u))
            .replace('v', &vector(self.v))
            .replace('t', &code(&[self.t]))
    }

    /// Writes the body of a test that asks this question again.
    pub(crate) fn as_test(&self) -> String {
        let found = format!("(prelude().{}){}", self.function.name(), self.given());
        let right = code(&self.right());
        if self.function.rounding > 0.0 {
            format!("assert!(({found} - {right}).length() < 1e-9);")
        } else {
            format!("assert_eq!({found}, {right});")
        }
    }

    /// Returns true if two answers to this question differ by no more than the relative error that
    /// the function's rounding allows; NaN differs from every number.
    pub(crate) fn answers_agree(&self, one: &[f64], other: &[f64]) -> bool {
        let rounding = self.function.rounding;
        let is_near = |(one, other): (&f64, &f64)| (one - other).abs() <= rounding * other.abs();
        one.iter().zip(other).all(is_near)
    }
}

impl Prelude<'_> {
    /// Returns the operators and functions of the package `common`, whose vectors are glam's.
    pub fn of_common() -> Self {
        Self {
            mul: &|t, v| t * v,
            add: &|u, v| u + v,
            neg: &|v| -v,
            sub: &|u, v| u - v,
            dot: &|u, v| u.dot(v),
            length_squared: &|v| v.length_squared(),
            length: &|v| v.length(),
            normalize: &|v| v.normalize(),
            ray: &|origin, direction| Ray::new(origin, direction),
            at: &|ray, t| ray.at(t),
        }
    }
}

/// All functions of a [`Prelude`], from `mul` to `at`: each comes after those of which it may be
/// made.
pub static PRELUDE_FUNCTIONS: [PreludeFunction; 10] = {
    const fn function(call: &'static str, rounding: f64, answer: PreludeCall) -> PreludeFunction {
        PreludeFunction {
            call,
            rounding,
            answer,
        }
    }
    [
        function("mul(t, v)", 4.0 * U, |it, a| numbers((it.mul)(a.t, a.v))),
        function("add(u, v)", 0.0, |it, a| numbers((it.add)(a.u, a.v))),
        function("neg(u)", 0.0, |it, a| numbers((it.neg)(a.u))),
        function("sub(u, v)", 0.0, |it, a| numbers((it.sub)(a.u, a.v))),
        function("dot(u, v)", 0.0, |it, a| vec![(it.dot)(a.u, a.v)]),
        function("length_squared(v)", 0.0, |it, a| {
            vec![(it.length_squared)(a.v)]
        }),
        function("length(v)", 0.0, |it, a| vec![(it.length)(a.v)]),
        function("normalize(v)", 4.0 * U, |it, a| {
            numbers((it.normalize)(a.v))
        }),
        function("ray(u, v)", 0.0, |it, a| numbers_of_ray((it.ray)(a.u, a.v))),
        function("at(Ray::new(u, v), t)", 0.0, |it, a| {
            numbers((it.at)(ray_from(a.u, a.v), a.t))
        }),
    ]
};

fn numbers(v: Vec3) -> Vec<f64> {
    v.to_array().to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Trial;

    #[test]
    #[expect(clippy::todo, reason = "a function that is not written is tried")]
    fn the_first_wrong_function_is_told_or_else_the_first_that_is_not_written() {
        let told = |prelude: &Prelude| {
            let outcome = Trial::default().prelude(prelude);
            outcome.err().map_or(String::new(), |it| it.to_string())
        };
        let right = Prelude::of_common();
        assert_eq!(told(&right), "");
        let unwritten = Prelude {
            neg: &|_| todo!(),
            ..right
        };
        let place = format!("not written yet: todo!() at {}:", file!());
        assert!(told(&unwritten).starts_with(&place), "{}", told(&unwritten));
        let both = Prelude {
            dot: &|u, v| u.x * v.x + u.y * v.y + u.z * u.z,
            length_squared: &|v| v.x * v.x + v.y * v.y,
            ..unwritten
        };
        assert!(told(&both).contains("found:    dot("), "{}", told(&both));
    }
}
