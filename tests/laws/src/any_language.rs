//! An adapter for any language: a function that is asked by lines of text, and answers by lines.
//!
//! A line asks about one ray and one sphere, a line answers. So a program in any language can be
//! put under the laws of a Rust function, if it reads and prints numbers.

use std::cell::RefCell;

use common::rtweekend::*;
use speed_vs_accuracy::Case;

use crate::manner::{Manner, right_record};
use crate::nearer_root::{self, obeys_every_law, root_bound};
use crate::oracle::Exact;
use crate::question::{Question, WithInterval};
use crate::record::{self, Hit};
use crate::trial::Trial;
use crate::verdict::{Complaint, Outcome};

/// What stands for an infinite end: not every language reads infinity, and no root that is asked
/// for is as far away.
pub const FAR: f64 = 1e300;

/// What a function of a chapter answers about one ray and one sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// Whether the line meets the sphere, as in chapter 2.
    Decision,
    /// The nearer root, as in chapters 3 and 4.
    Root,
    /// The nearest hit in a range, as in chapter 5.
    Record,
}

/// Asks a program for the hit in a range, which only a [`Function::Record`] has.
pub type Ask<'a> = dyn Fn(&WithInterval) -> Option<Hit> + 'a;

/// What comes of a program.
pub struct Told {
    /// Whether the laws hold, apart from its manners.
    pub outcome: Outcome,
    /// In which of its answers it differs from version 4 of the book, and no picture shows it.
    pub manners: Vec<Manner>,
    /// What was asked about the smallest case that breaks a law.
    pub last: Vec<WithInterval>,
}

/// Why a line is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoAnswer {
    /// Its numbers have a comma where a decimal point should be.
    DecimalComma,
    /// It is something else.
    Other,
}

impl Function {
    /// The question as a line: center, radius, origin, direction, and for a record the range, as
    /// decimal numbers that read back to the same bits.
    pub fn line(self, asked: &WithInterval) -> String {
        let range = [asked.t_min, asked.t_max].map(|end| end.clamp(-FAR, FAR));
        let range = if self == Self::Record {
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

    /// What a line answers.
    ///
    /// For a record, the normal and `front` or `back` may stand behind `t`; without them, they
    /// count as right. If a program `says_minus_one` for a miss, as the book's C++ in chapters 3
    /// and 4, that counts as one, unless it is the root.
    ///
    /// # Errors
    /// If it is no answer.
    pub fn read(
        self,
        asked: &WithInterval,
        line: &str,
        says_minus_one: bool,
    ) -> Result<Option<Hit>, NoAnswer> {
        let words: Vec<&str> = line.split_whitespace().collect();
        let case = &asked.case;
        match (self, &words[..]) {
            (_, ["miss"]) => Ok(None),
            (Self::Decision, ["hit"]) => Ok(Some(right_record(case, 0.0))),
            (Self::Decision, _) => Err(NoAnswer::Other),
            (Self::Record, [t, x, y, z, side @ ("front" | "back")]) => Ok(Some(Hit {
                normal: Vec3::new(number(x)?, number(y)?, number(z)?),
                front_face: *side == "front",
                ..right_record(case, number(t)?)
            })),
            (_, [t]) => {
                let t = number(t)?;
                let may_be_a_miss = says_minus_one && self == Self::Root && t == -1.0;
                let is_a_miss = may_be_a_miss && !is_root(case, t);
                Ok((!is_a_miss).then(|| right_record(case, t)))
            }
            _ => Err(NoAnswer::Other),
        }
    }
}

/// A number as any language prints it: NaN also as `-nan(ind)`.
fn number(word: &str) -> Result<f64, NoAnswer> {
    let is_nan = word.to_ascii_lowercase().contains("nan");
    let has_comma = || word.replace(',', ".").parse::<f64>().is_ok();
    match word.parse() {
        Ok(number) => Ok(number),
        Err(_) if is_nan => Ok(f64::NAN),
        Err(_) if has_comma() => Err(NoAnswer::DecimalComma),
        Err(_) => Err(NoAnswer::Other),
    }
}

/// Whether `t` is the nearer root, as far as rounding lets it be known.
fn is_root(case: &Case, t: f64) -> bool {
    let exact = Exact::of(case);
    let bound = root_bound(case, exact.discriminant_margin());
    let root = exact.nearer_root();
    root.is_some_and(|root| (root.rounded() - t).abs() <= bound)
}

impl Trial {
    /// A function in a program of any language, as that of a Rust function. Where it differs from
    /// a right one only by a manner, it is taken for right.
    pub fn any_language(&self, function: Function, ask: &Ask) -> Told {
        let manners = Manner::of(function, ask);
        let (used, last) = (RefCell::new(Vec::new()), RefCell::new(Vec::new()));
        let meant = |asked: &WithInterval| {
            last.borrow_mut().push(*asked);
            let found = ask(asked);
            let meant = |manner: &&Manner| manner.meant(function, asked, found.as_ref());
            let Some(manner) = manners.iter().find(|manner| meant(manner).is_some()) else {
                return found;
            };
            used.borrow_mut().push(*manner);
            meant(&manner).flatten()
        };
        let solve = |center, radius, ray: &Ray| {
            let case = Case::new(center, radius, *ray);
            Some(meant(&WithInterval::on_the_line(case))?.t)
        };
        let decide = |center, radius, ray: &Ray| solve(center, radius, ray).is_some();
        let outcome = match function {
            Function::Decision => self.decision(&decide),
            Function::Root => self.nearer_root(&solve),
            Function::Record => self.record(&meant),
        };
        last.borrow_mut().clear();
        if let Err(Complaint::Broken(report)) = &outcome {
            // Asked once more, it breaks the law again.
            let _ = match report.answers.given.last() {
                Some((Question::Decision(case), _)) => {
                    obeys_every_law(&nearer_root::decision(decide), case)
                }
                Some((Question::Root(case), _)) => obeys_every_law(&solve, case),
                Some((Question::Record(asked), _)) => record::obeys_every_law(&meant, asked),
                _ => Ok(()),
            };
        }
        let (used, last) = (used.take(), last.take());
        Told {
            outcome,
            manners: manners.into_iter().filter(|it| used.contains(it)).collect(),
            last: of_one_kind(last),
        }
    }
}

/// Each question once, of the kind of the last one: what is asked about a range is no matter of
/// the whole line.
fn of_one_kind(asked: Vec<WithInterval>) -> Vec<WithInterval> {
    let is_on_the_line = |it: &WithInterval| it.t_min == f64::NEG_INFINITY;
    let kind = asked.last().map(is_on_the_line);
    let mut once: Vec<WithInterval> = Vec::new();
    for it in asked {
        if Some(is_on_the_line(&it)) == kind && !once.contains(&it) {
            once.push(it);
        }
    }
    once
}

#[cfg(test)]
mod tests {
    use speed_vs_accuracy::half_b;

    use super::*;

    type Solve = fn(&WithInterval) -> Option<f64>;

    fn told(function: Function, solve: Solve) -> Told {
        Trial::default().any_language(function, &|asked| {
            Some(right_record(&asked.case, solve(asked)?))
        })
    }

    fn version_4(asked: &WithInterval) -> Option<f64> {
        asked.solve(&half_b)
    }

    /// The roots of the book, with each condition as given.
    fn roots(case: &Case, meets: fn(&f64) -> bool) -> Option<[f64; 2]> {
        let sqrtd = Some(case.discriminant()).filter(meets)?.sqrt();
        Some([(case.h() - sqrtd) / case.a(), (case.h() + sqrtd) / case.a()])
    }

    fn version_3(asked: &WithInterval) -> Option<f64> {
        let WithInterval { case, t_min, t_max } = *asked;
        let roots = roots(&case, |d| *d >= 0.0)?.into_iter();
        roots
            .into_iter()
            .find(|&root| !(root < t_min || t_max < root))
    }

    fn version_1(asked: &WithInterval) -> Option<f64> {
        Some(roots(&asked.case, |d| *d > 0.0)?[0])
    }

    fn in_front(asked: &WithInterval) -> Option<f64> {
        let roots = roots(&asked.case, |d| *d >= 0.0)?;
        roots.into_iter().find(|&t| t >= 0.0)
    }

    fn in_front_from_outside(asked: &WithInterval) -> Option<f64> {
        version_4(asked).filter(|&t| t >= 0.0)
    }

    #[test]
    fn a_function_of_another_edition_is_right_but_for_its_manner() {
        let table: [(Function, Solve, &[Manner]); 9] = [
            (Function::Decision, version_4, &[]),
            (Function::Root, version_4, &[]),
            (Function::Record, version_4, &[]),
            (Function::Record, version_3, &[Manner::EndsCount]),
            (Function::Root, version_1, &[Manner::TangentsMiss]),
            (Function::Decision, version_1, &[Manner::TangentsMiss]),
            (Function::Root, in_front, &[Manner::NothingBehind]),
            (Function::Decision, in_front, &[Manner::NothingBehind]),
            (
                Function::Root,
                in_front_from_outside,
                &[Manner::NothingBehind],
            ),
        ];
        for (at, (function, solve, manners)) in table.into_iter().enumerate() {
            let Told {
                outcome,
                manners: found,
                ..
            } = told(function, solve);
            crate::holds(outcome);
            assert_eq!(found, manners, "row {at}");
        }
    }

    #[test]
    fn a_mistake_is_no_manner() {
        let mistakes: [(Function, Solve); 5] = [
            // `t or "miss"` in Python.
            (Function::Root, |asked| {
                version_4(asked).filter(|&t| t != 0.0)
            }),
            // A manner does not hide the mistake behind it.
            (Function::Root, |asked| in_front(asked).map(|t| 1.001 * t)),
            (Function::Record, |asked| {
                version_3(asked).map(|t| t + 0.001)
            }),
            (Function::Record, in_front),
            (Function::Record, |asked| {
                version_4(&WithInterval {
                    t_min: 0.001,
                    ..*asked
                })
            }),
        ];
        let laws = mistakes.map(|(function, solve)| match told(function, solve).outcome {
            Err(crate::Complaint::Broken(report)) => report.broken.law.into_owned(),
            outcome => format!("{outcome:?}"),
        });
        let the_range = "a hit lies inside the open interval (t_min, t_max)";
        assert_eq!(
            laws,
            [
                "the line hits the sphere exactly when the discriminant is not negative",
                "the point at t lies on the sphere",
                "the point at t lies on the sphere",
                the_range,
                the_range,
            ]
        );
    }

    #[test]
    fn the_books_word_for_a_miss_is_one_unless_it_is_the_root() {
        let said = |z, function: Function| {
            let ray = Ray::new(Vec3::ZERO, Vec3::NEG_Z);
            let case = Case::new(Vec3::new(0.0, 0.0, z), 1.0, ray);
            let hit = function.read(&WithInterval::on_the_line(case), "-1", true);
            hit.map(|hit| hit.map(|hit| hit.t))
        };
        assert_eq!(said(0.0, Function::Root), Ok(Some(-1.0)));
        assert_eq!(said(-3.0, Function::Root), Ok(None));
        assert_eq!(said(-3.0, Function::Record), Ok(Some(-1.0)));
    }
}
