//! Answers as evidence: the answers of functions to telling questions, and the outcomes of their
//! laws, kept in a file, so that a judge in another process can weigh them beside a picture.
//!
//! Each line of the file is an answer, or the verdict on one function after its answers, with tabs
//! between its parts. A function that never returns leaves the answers that it gave before.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

use crate::question::Question;
use crate::verdict::{BrokenLaw, Complaint, Outcome, Report};

/// The name of the environment variable that holds the path of the file to which a
/// [`Trial`](crate::Trial) appends the tried functions' answers and verdicts. Without the variable,
/// no file is written.
pub const ANSWERS_VARIABLE: &str = "LAWS_ANSWERS";

/// A question that was put to a function, with the function's answer.
#[derive(Clone, Debug)]
pub struct Answered {
    /// The question, with all numbers that the function was given.
    pub question: Question,
    /// The numbers that the function answered, empty for a miss: `t` for a root, 0 for a hit that is
    /// only decided, three components for a color or vector, six for a ray. A record has `t`, 1 or 0
    /// for the front face, the point and the normal; that of a tangent only `t`.
    pub answer: Vec<f64>,
}

/// The answers that a program's functions gave to [`Question`]s, recorded in order.
#[derive(Clone, Debug, Default)]
pub struct Answers {
    /// Each question with its answer, in the order in which they were asked; empty if nothing was
    /// asked.
    pub given: Vec<Answered>,
}

/// The outcome of a [`Trial`](crate::Trial) of one function, as an [`AnswerFile`] has it.
#[derive(Clone, Debug)]
pub struct FunctionOutcome {
    /// The name that the trial has in the file: `hit_sphere`, `sphere`, `list`, `prelude`,
    /// `pixel_ray`, `ray_color` or `set_face_normal`.
    pub function: String,
    /// The outcome of all laws for the function: `Ok` if they hold, else the broken law or the
    /// place of a `todo!()`.
    pub outcome: Outcome,
}

/// The parsed content of a file to which a [`Trial`](crate::Trial) appends answers and verdicts.
#[derive(Debug, Default)]
pub struct AnswerFile {
    /// The answers of all tried functions, in the order in which they were written; may be empty.
    pub answers: Answers,
    /// The outcome for each tried function, in the order in which they were tried. Missing are a
    /// function whose trial did not end, and a `ray_color` about which the laws make no claim.
    pub outcomes: Vec<FunctionOutcome>,
}

impl AnswerFile {
    /// Parses the text of such a file, up to the first line that is cut off: the program that wrote
    /// it may have ended there. An empty text gives an empty result.
    pub fn read(text: &str) -> Self {
        let mut told = Self::default();
        for line in text
            .split_inclusive('\n')
            .map_while(|line| line.strip_suffix('\n'))
        {
            match line.split('\t').collect::<Vec<_>>()[..] {
                [VERDICT, function, ref said @ ..] => {
                    told.outcomes
                        .extend(outcome(said, &told.answers).map(|outcome| {
                            let function = function.to_owned();
                            FunctionOutcome { function, outcome }
                        }));
                }
                [kind, question, answer] => {
                    told.answers.given.extend(answered(kind, question, answer));
                }
                _ => {}
            }
        }
        told
    }
}

/// The first word of a line with a verdict.
const VERDICT: &str = "verdict";

/// Writes an answer as a line of the file: the kind of the question, its numbers, the answer's. The
/// last answer before the verdict of a broken law is that to the smallest case that breaks it; only
/// `set_face_normal` has no answers.
pub(crate) fn answer_line(question: &Question, answer: &[f64]) -> String {
    let [asked, answer] = [&question.numbers()[..], answer].map(|numbers| {
        let words = numbers.iter().map(|number| format!("{number:?}"));
        words.collect::<Vec<_>>().join(" ")
    });
    [question.kind(), &asked, &answer].join("\t")
}

/// Writes the outcome of all laws for a function as a line of the file.
pub(crate) fn verdict_line(function: &str, outcome: &Outcome) -> String {
    let mut words = vec![VERDICT, function];
    match outcome {
        Ok(()) => words.push("obeyed"),
        Err(Complaint::NotWritten(place)) => words.extend(["not written", place]),
        Err(Complaint::Broken(report)) => {
            let Report { broken, test, .. } = &**report;
            words.extend([
                "broken",
                &broken.law,
                &broken.found,
                &broken.allowed,
                &broken.read,
            ]);
            words.extend(test.lines());
        }
    }
    words.join("\t")
}

/// Appends a line to the file, which it creates if there is none.
///
/// # Panics
/// If the file can't be written.
pub(crate) fn append(file: &Path, line: String) {
    let opened = OpenOptions::new().create(true).append(true).open(file);
    opened
        .and_then(|mut opened| opened.write_all((line + "\n").as_bytes()))
        .unwrap_or_else(|cause| panic!("{}: {cause}", file.display()));
}

/// Reads a question and its answer; `None` if they are none.
fn answered(kind: &str, question: &str, answer: &str) -> Option<Answered> {
    let numbers = |words: &str| -> Option<Vec<f64>> {
        words
            .split_whitespace()
            .map(|word| word.parse().ok())
            .collect()
    };
    let question = Question::read(kind, &numbers(question)?)?;
    let answer = numbers(answer)?;
    Some(Answered { question, answer })
}

/// Reads the outcome of a function's laws. Its report gets all answers `before` it.
fn outcome(said: &[&str], before: &Answers) -> Option<Outcome> {
    Some(match *said {
        ["obeyed"] => Ok(()),
        ["not written", place] => Err(Complaint::NotWritten(place.to_owned())),
        ["broken", law, found, allowed, read, ref test @ ..] => {
            let broken = BrokenLaw {
                law: law.to_owned().into(),
                found: found.to_owned(),
                allowed: allowed.to_owned(),
                read: read.to_owned().into(),
            };
            Err(Complaint::of(broken, before.clone(), test.join("\n")))
        }
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use common::rtweekend::*;

    use super::*;
    use crate::prelude::PRELUDE_FUNCTIONS;
    use crate::question::telling_cases;
    use crate::{Case, ChapterScene, Trial, strategies};

    /// Runs a trial whose answers go to a file, and returns the file's text and the outcome.
    fn lines(trial: impl Fn(&Trial) -> Outcome) -> (String, Outcome) {
        let folder = std::env::temp_dir().join(format!("laws-{}", std::process::id()));
        let _ = std::fs::remove_file(&folder);
        let outcome = trial(&Trial {
            answers: Some(folder.clone()),
            ..Trial::default()
        });
        let text = std::fs::read_to_string(&folder).expect("it is kept");
        std::fs::remove_file(&folder).expect("it is there");
        (text, outcome)
    }

    #[test]
    fn what_is_kept_reads_back_as_far_as_it_goes() {
        let no_number = |case: &Case| Some(1.0 / 0.0 * case.h()).filter(|_| case.a() > 1.0);
        let (text, outcome) = lines(|trial| {
            trial.ray_color(ChapterScene::Sky, &sky)?;
            trial.nearer_root(&|center, radius, ray| no_number(&Case::new(center, radius, *ray)))
        });
        let Err(Complaint::Broken(report)) = outcome else {
            panic!("t is not finite");
        };
        let AnswerFile {
            mut answers,
            outcomes,
        } = AnswerFile::read(&text);
        let tried: Vec<&str> = outcomes.iter().map(|it| &*it.function).collect();
        assert_eq!(tried, ["ray_color", "hit_sphere"]);
        let [Ok(()), Err(Complaint::Broken(read))] = [0, 1].map(|n| &outcomes[n].outcome) else {
            panic!("{outcomes:?}");
        };
        assert_eq!((&read.broken, &read.test), (&report.broken, &report.test));
        // A NaN has many bits.
        let said = |answers: &Answers| format!("{:?}", answers.given);
        assert_eq!(said(&read.answers), said(&answers));
        let own = answers
            .given
            .split_off(answers.given.len() - report.answers.given.len());
        assert_eq!(format!("{own:?}"), said(&report.answers));
        // A program may end before it has written a line.
        let (whole, _) = text.split_at(text.len() / 2);
        let answers = AnswerFile::read(whole).answers.given;
        assert_eq!(answers.len(), whole.lines().count() - 2);
    }

    #[test]
    fn questions_of_all_kinds_read_back() {
        let prelude = PRELUDE_FUNCTIONS.iter().flat_map(|it| it.telling_cases());
        let [decisions, roots] = [Question::Decision, Question::Root].map(|kind| {
            let cases = telling_cases(&strategies::ordinary());
            cases.into_iter().map(kind)
        });
        let records = telling_cases(&strategies::ordinary_with_interval());
        let lists = telling_cases(&strategies::worlds());
        let pixels = telling_cases(&strategies::pixels());
        let questions = prelude.map(Question::Prelude).chain(decisions).chain(roots);
        let questions = questions.chain(records.into_iter().map(Question::Record));
        let questions = questions.chain(lists.into_iter().map(Question::Nearest));
        for question in questions.chain(pixels.into_iter().map(Question::PixelRay)) {
            let numbers = question.numbers();
            let read = Question::read(question.kind(), &numbers).expect("it is a question");
            assert_eq!((read.kind(), read.numbers()), (question.kind(), numbers));
        }
    }
}
