//! An adapter for any language: a function that is asked by lines of text, and answers by lines.
//!
//! A line asks about one ray and one sphere, a line answers. So a program in any language can be
//! put under the laws of a Rust function, if it reads and prints numbers.

use std::cell::RefCell;

use common::rtweekend::*;
use slips::Chapter;
use speed_vs_accuracy::Case;

use crate::nearer_root::{self, NEARER_ROOT, Solver, root_bound};
use crate::oracle::Exact;
use crate::question::WithInterval;
use crate::record::{self, Hit};
use crate::trial::{Report, Trial};

/// What stands for an infinite end: not every language reads infinity, and no root that is asked
/// for is as far away.
pub const FAR: f64 = 1e300;

/// Asks a program for the hit in a range; before chapter 5, the range is left out.
pub type Ask<'a> = dyn Fn(&WithInterval) -> Option<Hit> + 'a;

/// A broken law, and what was asked about the smallest case that breaks it.
pub type Broken = (Box<Report>, Vec<WithInterval>);

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
/// In chapter 5, the normal and `front` or `back` may stand behind `t`; without them, they count
/// as right. If a program `says_minus_one` for a miss, as the book's C++ in chapters 3 and 4, that
/// counts as one, unless it is the root.
pub fn read(
    chapter: Chapter,
    asked: &WithInterval,
    line: &str,
    says_minus_one: bool,
) -> Option<Option<Hit>> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let case = &asked.case;
    match (chapter, &words[..]) {
        (_, ["miss"]) => Some(None),
        (Chapter::RedSphere, ["hit"]) => Some(Some(right_record(case, 0.0))),
        (Chapter::RedSphere, _) => None,
        (Chapter::HittableList, [t, x, y, z, side @ ("front" | "back")]) => Some(Some(Hit {
            normal: Vec3::new(number(x)?, number(y)?, number(z)?),
            front_face: *side == "front",
            ..right_record(case, number(t)?)
        })),
        (_, [t]) => {
            let t = number(t)?;
            let may_be_a_miss = t == -1.0 && chapter < Chapter::HittableList;
            let is_a_miss = says_minus_one && may_be_a_miss && !is_root(case, t);
            Some((!is_a_miss).then(|| right_record(case, t)))
        }
        _ => None,
    }
}

/// A number as any language prints it: NaN also as `-nan(ind)`.
fn number(word: &str) -> Option<f64> {
    let is_nan = word.to_ascii_lowercase().contains("nan");
    word.parse().ok().or(is_nan.then_some(f64::NAN))
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
            // What is asked about a range is no matter of the whole line any more.
            if asked.t_min.is_finite() || asked.t_max.is_finite() {
                last.clear();
            }
            if !last.contains(asked) {
                last.push(*asked);
            }
            ask(asked)
        };
        let outcome = if self.chapter == Chapter::HittableList {
            let law = |asked: &WithInterval| {
                last.borrow_mut().clear();
                record::obeys_every_law(&ask_and_keep, asked)
            };
            self.of_a_sphere(&|asked| record::numbers(asked, ask), &[law])
        } else {
            let is_decision = self.chapter == Chapter::RedSphere;
            let [solve, kept] = [ask, &ask_and_keep].map(|ask| on_the_line(is_decision, ask));
            let laws = NEARER_ROOT.map(|law| {
                let (last, kept) = (&last, &*kept);
                move |asked: &WithInterval| {
                    last.borrow_mut().clear();
                    law(kept, &asked.case)
                }
            });
            self.of_a_sphere(&|asked| record::root(self.chapter, &*solve, asked), &laws)
        };
        outcome.map_err(|report| (report, last.take()))
    }
}

/// What the program says of a line that goes both ways.
fn on_the_line<'a>(is_decision: bool, ask: &'a Ask) -> Box<Solver<'a>> {
    let root = move |center, radius, ray: &Ray| {
        let (t_min, t_max) = (f64::NEG_INFINITY, f64::INFINITY);
        let case = Case::new(center, radius, *ray);
        Some(ask(&WithInterval { case, t_min, t_max })?.t)
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
            let t = half_b(center, radius, &ray, asked.t_min, asked.t_max)?;
            Some(right_record(&asked.case, t))
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
            let hit = read(chapter, &WithInterval { case, t_min, t_max }, "-1", true);
            hit.map(|hit| hit.map(|hit| hit.t))
        };
        assert_eq!(said(0.0, Chapter::Normals), Some(Some(-1.0)));
        assert_eq!(said(-3.0, Chapter::Normals), Some(None));
        assert_eq!(said(-3.0, Chapter::HittableList), Some(Some(-1.0)));
    }
}
