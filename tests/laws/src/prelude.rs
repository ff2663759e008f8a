//! Laws for a prelude: each operator and function of vectors and rays is asked directly,
//! with numbers so small that the answer can be worked out by head.

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Chapter, Program};

use crate::broken::{Broken, Verdict};
use crate::nearer_root::U;
use crate::question::{Question, code, of_ray};
use crate::strategies::{ahead_if_zero, samples, whole_vector};

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

/// One of the functions of a prelude, and what there is to say of it.
#[derive(Debug)]
pub struct Function {
    /// Its name.
    pub(crate) name: &'static str,
    /// What it takes: the vectors `u` and `v`, the number `t`, or the ray `r` from u along v.
    takes: &'static str,
    /// How far rounding may take an answer, in relation to it.
    rounding: f64,
    law: &'static str,
    usually: &'static str,
    page: &'static str,
    answer: fn(&Prelude, &Asked) -> Vec<f64>,
    right: fn([f64; 3], [f64; 3], f64) -> Vec<f64>,
}

/// What a function of a prelude is asked.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    function: &'static Function,
    u: Vec3,
    v: Vec3,
    t: f64,
}

/// A function of a prelude answers as small numbers say.
///
/// They are added and multiplied without rounding, so this holds to the bit, but for a
/// unit vector. Tenths tell a product that is rounded before the sum from a fused
/// one: 10 · 0.1 is 1 to an `f64`, though `0.1` is a little more than a tenth.
///
/// A swapped letter (`u.z * u.z`) draws the right picture in four chapters of five, because
/// there every z is −1.
pub fn small_numbers_are_worked_out_by_head(prelude: &Prelude, asked: &Asked) -> Verdict {
    let function = asked.function;
    let (found, right) = (asked.put_to(prelude), asked.right());
    if asked.same(&found, &right) {
        return Ok(());
    }
    Err(Broken {
        law: function.law,
        found: format!("{}{} is {}", function.name, asked.given(), code(&found)),
        allowed: code(&right),
        usually: function.usually,
        page: function.page,
    })
}

impl Function {
    /// What is asked of it.
    pub(crate) fn questions(&'static self) -> impl Strategy<Value = Asked> {
        let number = prop_oneof![(-8..=8).prop_map(|k| 0.5 * f64::from(k)), tenths()];
        (whole_vector(9), whole_vector(9), number).prop_map(move |(u, v, t)| Asked {
            function: self,
            u,
            v: ahead_if_zero(v),
            t,
        })
    }
}

fn tenths() -> impl Strategy<Value = f64> {
    (1..=9).prop_map(|k| f64::from(k) / 10.0)
}

impl Asked {
    /// What the prelude answers.
    pub(crate) fn put_to(&self, prelude: &Prelude) -> Vec<f64> {
        (self.function.answer)(prelude, self)
    }

    fn right(&self) -> Vec<f64> {
        (self.function.right)(self.u.to_array(), self.v.to_array(), self.t)
    }

    fn ray(&self) -> Ray {
        Ray::new(self.u, self.v)
    }

    /// What is given to the function, as Rust has it.
    fn given(&self) -> String {
        let given = self.function.takes.chars().map(|letter| match letter {
            'u' => code(&self.u.to_array()),
            'v' => code(&self.v.to_array()),
            'r' => code(&of_ray(self.ray())),
            _ => code(&[self.t]),
        });
        format!("({})", given.collect::<Vec<_>>().join(", "))
    }
}

/// Does something with the functions of a program.
pub fn of_program<T>(program: &Program, act: impl FnOnce(&Prelude) -> T) -> T {
    let squared = |v| (program.squared)(program, v);
    act(&Prelude {
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

impl Question for Asked {
    fn kind(&self) -> &'static str {
        self.function.name
    }

    fn as_test(&self, _: Chapter) -> String {
        let Function { name, rounding, .. } = self.function;
        let found = format!("(prelude().{name}){}", self.given());
        let right = code(&self.right());
        if *rounding > 0.0 {
            format!("assert!(({found} - {right}).length() < 1e-9);")
        } else {
            format!("assert_eq!({found}, {right});")
        }
    }

    /// What doesn't round is the same to the bit.
    fn same(&self, one: &[f64], other: &[f64]) -> bool {
        let rounding = self.function.rounding;
        let is_near = |(one, other): (&f64, &f64)| (one - other).abs() <= rounding * other.abs();
        one.iter().zip(other).all(is_near)
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        of_program(program, |prelude| self.put_to(prelude))
    }

    fn ordinary(_: Chapter) -> BoxedStrategy<Self> {
        let functions = proptest::sample::select(FUNCTIONS.iter().collect::<Vec<_>>());
        functions.prop_flat_map(Function::questions).boxed()
    }

    fn telling(_: Chapter) -> Vec<Self> {
        let of = |function: &'static Function| samples(&function.questions(), 20);
        FUNCTIONS.iter().flat_map(of).collect()
    }
}

const EQUATION_OF_A_RAY: &str = "equation (1) of the notes";
const COLOR_OF_THE_SKY: &str = "chapter 1: the color of the sky";
const DOT_PRODUCT: &str = "equation (5) of the notes";

/// Later ones may be made of earlier ones.
pub static FUNCTIONS: [Function; 10] = [
    Function {
        name: "mul",
        takes: "tv",
        rounding: 4.0 * U,
        law: "a number times a vector multiplies each letter",
        usually: "a letter stands twice, or is left out",
        page: EQUATION_OF_A_RAY,
        answer: |it, asked| (it.mul)(asked.t, asked.v).to_array().to_vec(),
        right: |_, v, t| v.map(|v| t * v).to_vec(),
    },
    Function {
        name: "add",
        takes: "uv",
        rounding: 0.0,
        law: "a sum of vectors adds equal letters",
        usually: "a letter stands twice: u.x + v.x, u.y + v.y, u.z + v.z",
        page: EQUATION_OF_A_RAY,
        answer: |it, asked| (it.add)(asked.u, asked.v).to_array().to_vec(),
        right: |[x, y, z], [a, b, c], _| vec![x + a, y + b, z + c],
    },
    Function {
        name: "neg",
        takes: "u",
        rounding: 0.0,
        law: "minus a vector turns the sign of each letter",
        usually: "a minus is missing, or a letter stands twice",
        page: "chapter 5: outward, or against the ray",
        answer: |it, asked| (it.neg)(asked.u).to_array().to_vec(),
        right: |u, _, _| u.map(|u| -u).to_vec(),
    },
    Function {
        name: "sub",
        takes: "uv",
        rounding: 0.0,
        law: "a difference of vectors subtracts equal letters",
        usually: "a plus where a minus should be, or the two are swapped",
        page: "chapter 2: oc",
        answer: |it, asked| (it.sub)(asked.u, asked.v).to_array().to_vec(),
        right: |[x, y, z], [a, b, c], _| vec![x - a, y - b, z - c],
    },
    Function {
        name: "dot",
        takes: "uv",
        rounding: 0.0,
        law: "a dot product multiplies equal letters and adds",
        usually: "a letter is swapped: u.x*v.x + u.y*v.y + u.z*v.z",
        page: DOT_PRODUCT,
        answer: |it, asked| vec![(it.dot)(asked.u, asked.v)],
        right: |u, v, _| vec![dot(u, v)],
    },
    Function {
        name: "length_squared",
        takes: "v",
        rounding: 0.0,
        law: "the square of a length is the vector times itself",
        usually: "a letter is swapped, or the root is taken: v.x*v.x + v.y*v.y + v.z*v.z",
        page: DOT_PRODUCT,
        answer: |it, asked| vec![(it.length_squared)(asked.v)],
        right: |_, v, _| vec![dot(v, v)],
    },
    Function {
        name: "length",
        takes: "v",
        rounding: 0.0,
        law: "a length is the root of its square",
        usually: "the root is not taken, or twice",
        page: COLOR_OF_THE_SKY,
        answer: |it, asked| vec![(it.length)(asked.v)],
        right: |_, v, _| vec![dot(v, v).sqrt()],
    },
    Function {
        name: "normalize",
        takes: "v",
        rounding: 4.0 * U,
        law: "a unit vector has length 1 and points where the vector does",
        usually: "the vector is not divided by its length, the root of v.x² + v.y² + v.z²",
        page: COLOR_OF_THE_SKY,
        answer: |it, asked| (it.normalize)(asked.v).to_array().to_vec(),
        right: |_, v, _| v.map(|letter| letter / dot(v, v).sqrt()).to_vec(),
    },
    Function {
        name: "ray",
        takes: "uv",
        rounding: 0.0,
        law: "a ray has the origin and the direction that it is made of",
        usually: "the two are swapped",
        page: EQUATION_OF_A_RAY,
        answer: |it, asked| of_ray((it.ray)(asked.u, asked.v)),
        right: |origin, direction, _| [origin, direction].concat(),
    },
    Function {
        name: "at",
        takes: "rt",
        rounding: 0.0,
        law: "the point at t is t directions away from the origin",
        usually: "the origin is left out, the direction is changed first, or the product and the \
                  sum are fused",
        page: EQUATION_OF_A_RAY,
        answer: |it, asked| (it.at)(asked.ray(), asked.t).to_array().to_vec(),
        right: |[x, y, z], [u, v, w], t| vec![x + t * u, y + t * v, z + t * w],
    },
];

fn dot([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> f64 {
    x * a + y * b + z * c
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Trial;

    #[test]
    fn the_first_wrong_function_is_told_and_what_is_not_written_is_not_asked() {
        let first_wrong = |prelude: &Prelude| {
            let outcome = Trial::of(Chapter::Gradient).prelude(prelude);
            outcome.err().map(|report| report.broken.found)
        };
        let found = of_program(&Program::right(Chapter::Gradient), |right| {
            assert_eq!(first_wrong(right), None);
            first_wrong(&Prelude {
                neg: &|_| panic!("not yet implemented"),
                dot: &|u, v| u.x * v.x + u.y * v.y + u.z * u.z,
                length_squared: &|v| v.x * v.x + v.y * v.y,
                ..*right
            })
        });
        assert!(found.is_some_and(|found| found.starts_with("dot(")));
    }
}
