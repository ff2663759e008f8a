//! Laws for a prelude: each operator and function of vectors and rays is asked directly,
//! with numbers so small that the answer can be worked out by head.

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Chapter, Program};

use crate::Verdict;
use crate::nearer_root::U;
use crate::question::{Question, code, of_ray, vector};
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
    /// A call of it, with the vectors `u` and `v` and the number `t`.
    call: &'static str,
    /// How far rounding may take an answer, in relation to it.
    rounding: f64,
    answer: fn(&Prelude, &Asked) -> Vec<f64>,
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
    let (found, right) = (asked.put_to(prelude), asked.right());
    prop_assert!(
        asked.same(&found, &right),
        "the law:  a function of the prelude gives what one works out by head\n\
         found:    {}{} is {}\n\
         allowed:  {}\n\
         read:     chapter 1, and equations (1) to (5) of the notes",
        asked.kind(),
        asked.given(),
        code(&found),
        code(&right)
    );
    Ok(())
}

impl Function {
    /// What it is called.
    pub(crate) fn name(&self) -> &'static str {
        self.call.split('(').next().expect("a call has a name")
    }

    /// What is asked of it.
    pub(crate) fn questions(&'static self) -> impl Strategy<Value = Asked> {
        let tenths = (1..=9).prop_map(|k| f64::from(k) / 10.0);
        let number = prop_oneof![(-8..=8).prop_map(|k| 0.5 * f64::from(k)), tenths];
        (whole_vector(9), whole_vector(9), number).prop_map(move |(u, v, t)| Asked {
            function: self,
            u,
            v: ahead_if_zero(v),
            t,
        })
    }

    /// Questions that tell mistakes in it apart.
    pub(crate) fn telling(&'static self) -> Vec<Asked> {
        samples(&self.questions(), 20)
    }
}

impl Asked {
    /// What the prelude answers.
    pub(crate) fn put_to(&self, prelude: &Prelude) -> Vec<f64> {
        (self.function.answer)(prelude, self)
    }

    fn right(&self) -> Vec<f64> {
        self.answer_of(&Program::right(Chapter::Gradient))
    }

    /// What is given to the function, as Rust has it.
    fn given(&self) -> String {
        let (_, given) = self.function.call.split_at(self.kind().len());
        given
            .replace('u', &vector(self.u))
            .replace('v', &vector(self.v))
            .replace('t', &code(&[self.t]))
    }
}

/// Does something with the functions of a program.
pub fn of_program<T>(program: &Program, act: impl FnOnce(&Prelude) -> T) -> T {
    let squared = |v| (program.squared)(program, v);
    act(&Prelude {
        mul: &|t, v| t * v,
        add: &|u, v| u + v,
        neg: &|v| -v,
        sub: &|u, v| u - v,
        dot: &program.dot,
        length_squared: &squared,
        length: &|v| squared(v).sqrt(),
        normalize: &program.unit,
        ray: &Ray::new,
        at: &|ray, t| ray.at(t),
    })
}

impl Question for Asked {
    fn kind(&self) -> &'static str {
        self.function.name()
    }

    fn as_test(&self, _: Chapter) -> String {
        let found = format!("(prelude().{}){}", self.kind(), self.given());
        let right = code(&self.right());
        if self.function.rounding > 0.0 {
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
}

/// Questions that tell mistakes in all functions apart.
pub(crate) fn telling() -> Vec<Asked> {
    FUNCTIONS.iter().flat_map(Function::telling).collect()
}

/// Later ones may be made of earlier ones.
pub static FUNCTIONS: [Function; 10] = [
    Function {
        call: "mul(t, v)",
        rounding: 4.0 * U,
        answer: |it, asked| (it.mul)(asked.t, asked.v).to_array().to_vec(),
    },
    Function {
        call: "add(u, v)",
        rounding: 0.0,
        answer: |it, asked| (it.add)(asked.u, asked.v).to_array().to_vec(),
    },
    Function {
        call: "neg(u)",
        rounding: 0.0,
        answer: |it, asked| (it.neg)(asked.u).to_array().to_vec(),
    },
    Function {
        call: "sub(u, v)",
        rounding: 0.0,
        answer: |it, asked| (it.sub)(asked.u, asked.v).to_array().to_vec(),
    },
    Function {
        call: "dot(u, v)",
        rounding: 0.0,
        answer: |it, asked| vec![(it.dot)(asked.u, asked.v)],
    },
    Function {
        call: "length_squared(v)",
        rounding: 0.0,
        answer: |it, asked| vec![(it.length_squared)(asked.v)],
    },
    Function {
        call: "length(v)",
        rounding: 0.0,
        answer: |it, asked| vec![(it.length)(asked.v)],
    },
    Function {
        call: "normalize(v)",
        rounding: 4.0 * U,
        answer: |it, asked| (it.normalize)(asked.v).to_array().to_vec(),
    },
    Function {
        call: "ray(u, v)",
        rounding: 0.0,
        answer: |it, asked| of_ray((it.ray)(asked.u, asked.v)),
    },
    Function {
        call: "at(Ray::new(u, v), t)",
        rounding: 0.0,
        answer: |it, asked| {
            (it.at)(Ray::new(asked.u, asked.v), asked.t)
                .to_array()
                .to_vec()
        },
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Trial;

    #[test]
    fn the_first_wrong_function_is_told_and_what_is_not_written_is_not_asked() {
        let first_wrong = |prelude: &Prelude| {
            let outcome = Trial::of(Chapter::Gradient).prelude(prelude);
            outcome.err().map(|report| report.to_string())
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
        assert!(found.is_some_and(|found| found.contains("found:    dot(")));
    }
}
