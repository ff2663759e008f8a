//! An adapter for any language: a function that is asked by lines of text, and answers by lines.
//!
//! A line asks about one ray and one sphere, a line answers. So a program in any language can be
//! put under the laws of a Rust function, if it reads and prints numbers.

use std::cell::RefCell;

use common::rtweekend::*;
use proptest::test_runner::TestCaseResult;
use slips::Chapter;
use speed_vs_accuracy::Case;

use crate::intervals::{
    no_t_outside_the_interval_is_returned, the_nearest_root_in_the_interval_is_returned,
};
use crate::nearer_root::{self, NEARER_ROOT, Solver, root_bound};
use crate::oracle::Exact;
use crate::question::WithInterval;
use crate::record::{self, Hit};
use crate::trial::{Report, Trial};

/// What stands for an infinite end: not every language reads infinity, and no root that is asked
/// for is as far away.
pub const FAR: f64 = 1e300;

/// Asks a program for the root in a range; before chapter 5, the range is left out.
pub type Ask<'a> = dyn Fn(&WithInterval) -> Option<f64> + 'a;

/// A broken law, and what was asked about the smallest case that breaks it.
pub type Broken = (Box<Report>, Vec<WithInterval>);

/// A law for a function of this kind.
type Law<'a> = Box<dyn Fn(&WithInterval) -> TestCaseResult + 'a>;

/// The question as a line: center, radius, origin, direction, and in chapter 5 the range, as
/// decimal numbers that read back to the same bits.
pub fn line(chapter: Chapter, asked: &WithInterval) -> String {
    let range = [asked.t_min, asked.t_max].map(|end| end.clamp(-FAR, FAR));
    let range = if chapter == Chapter::HittableList {
        &range[..]
    } else {
        &[]
    };
    let numbers = asked.case.numbers();
    let words = numbers
        .iter()
        .chain(range)
        .map(|number| format!("{number:?}"));
    words.collect::<Vec<_>>().join(" ")
}

/// What a line answers; `None` if that is no answer.
///
/// If a program `says_minus_one` for a miss, as the book's C++ in chapters 3 and 4, that counts as
/// one, unless it is the root.
pub fn read(
    chapter: Chapter,
    asked: &WithInterval,
    line: &str,
    says_minus_one: bool,
) -> Option<Option<f64>> {
    let has_t = chapter != Chapter::RedSphere;
    match line {
        "miss" => return Some(None),
        "hit" if !has_t => return Some(Some(0.0)),
        _ => {}
    }
    let is_nan = line.to_ascii_lowercase().contains("nan");
    let number = if is_nan { f64::NAN } else { line.parse().ok()? };
    let may_be_a_miss = number == -1.0 && chapter < Chapter::HittableList;
    let is_a_miss = says_minus_one && may_be_a_miss && !is_root(&asked.case, number);
    has_t.then_some((!is_a_miss).then_some(number))
}

/// Whether `t` is the nearer root, as far as rounding lets it be known.
fn is_root(case: &Case, t: f64) -> bool {
    let exact = Exact::of(case);
    let bound = root_bound(case, exact.discriminant_margin());
    let root = exact.nearer_root();
    root.is_some_and(|root| (root.rounded() - t).abs() <= bound)
}

impl Trial {
    /// The intersection of the chapter in a program of any language, as that of a Rust function.
    ///
    /// # Errors
    /// If a law is broken.
    pub fn any_language(&self, ask: &Ask) -> Result<(), Broken> {
        let last = RefCell::new(Vec::new());
        let ask_and_keep = |asked: &WithInterval| {
            let mut last = last.borrow_mut();
            if !last.contains(asked) {
                last.push(*asked);
            }
            ask(asked)
        };
        let laws = self.laws_for(&ask_and_keep);
        let laws = laws.iter().map(|law| {
            |asked: &WithInterval| {
                last.borrow_mut().clear();
                law(asked)
            }
        });
        let laws: Vec<_> = laws.collect();
        let outcome = self.of_a_sphere(&|asked| self.answer(ask, asked), &laws);
        outcome.map_err(|report| (report, last.take()))
    }

    /// The laws of `hit_sphere`, in chapter 5 on the whole line, and then those of a range.
    fn laws_for<'a>(&self, ask: &'a Ask) -> Vec<Law<'a>> {
        let is_decision = self.chapter == Chapter::RedSphere;
        let of_root = NEARER_ROOT.into_iter().map(|law| -> Law {
            Box::new(move |asked| law(&*on_the_line(is_decision, ask), &asked.case))
        });
        let mut laws: Vec<Law> = of_root.collect();
        if self.chapter == Chapter::HittableList {
            let in_range = |center, radius, ray: &Ray, t_min, t_max| {
                let case = Case::new(center, radius, *ray);
                ask(&WithInterval { case, t_min, t_max })
            };
            laws.push(Box::new(move |asked| {
                no_t_outside_the_interval_is_returned(&in_range, asked)
            }));
            laws.push(Box::new(move |asked| {
                the_nearest_root_in_the_interval_is_returned(&in_range, asked)
            }));
        }
        laws
    }

    /// The numbers of an answer. To a `t` in chapter 5 belongs the record that is right there.
    fn answer(&self, ask: &Ask, asked: &WithInterval) -> Vec<f64> {
        if self.chapter == Chapter::HittableList {
            return record::numbers(asked, &|asked| Some(right_record(&asked.case, ask(asked)?)));
        }
        let is_decision = self.chapter == Chapter::RedSphere;
        record::root(self.chapter, &*on_the_line(is_decision, ask), asked)
    }
}

/// What the program says of a line that goes both ways.
fn on_the_line<'a>(is_decision: bool, ask: &'a Ask) -> Box<Solver<'a>> {
    let root = move |center, radius, ray: &Ray| {
        ask(&WithInterval {
            case: Case::new(center, radius, *ray),
            t_min: -FAR,
            t_max: FAR,
        })
    };
    if is_decision {
        let decide = move |center, radius, ray: &Ray| root(center, radius, ray).is_some();
        Box::new(nearer_root::decision(decide))
    } else {
        Box::new(root)
    }
}

/// The record of a hit at `t`, as chapter 5 fills it.
fn right_record(case: &Case, t: f64) -> Hit {
    let point = case.ray.at(t);
    let outward = (point - case.center) * (1.0 / case.radius);
    let front_face = case.ray.direction.dot(outward) < 0.0;
    let normal = if front_face { outward } else { -outward };
    Hit {
        t,
        point,
        normal,
        front_face,
    }
}

#[cfg(test)]
mod tests {
    use speed_vs_accuracy::half_b;

    use super::*;

    #[test]
    fn a_right_function_holds_the_laws_in_each_chapter() {
        let near = |asked: &WithInterval| {
            let Case {
                center,
                radius,
                ray,
            } = asked.case;
            half_b(center, radius, &ray, asked.t_min, asked.t_max)
        };
        for chapter in [Chapter::RedSphere, Chapter::Normals, Chapter::HittableList] {
            let outcome = Trial::of(chapter).any_language(&near);
            assert!(outcome.is_ok(), "{chapter:?}");
        }
    }

    #[test]
    fn the_books_word_for_a_miss_is_one_unless_it_is_the_root() {
        let said = |z, chapter| {
            let case = Case::new(
                Vec3::new(0.0, 0.0, z),
                1.0,
                Ray::new(Vec3::ZERO, Vec3::NEG_Z),
            );
            let [t_min, t_max] = [-FAR, FAR];
            read(chapter, &WithInterval { case, t_min, t_max }, "-1", true)
        };
        assert_eq!(said(0.0, Chapter::Normals), Some(Some(-1.0)));
        assert_eq!(said(-3.0, Chapter::Normals), Some(None));
        assert_eq!(said(-3.0, Chapter::HittableList), Some(Some(-1.0)));
    }
}
