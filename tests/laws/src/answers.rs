//! Answers as evidence: the answers of functions to telling questions, and the outcomes of their
//! laws, kept in a file, so that a judge in another process can weigh them beside a picture.
//!
//! Each line of the file is a JSON object: an answer, or the verdict on one function after its
//! answers. Numbers are written as text, because JSON has no NaN and no infinity. A function
//! that never returns leaves the answers that it gave before.

use std::collections::HashMap;
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

use tinyjson::JsonValue;

use crate::question::{Functions, Question};
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
    /// The numbers that the function answered, in the order of [`Question::put_to`]; empty for a
    /// miss.
    pub answer: Vec<f64>,
}

impl Answered {
    /// Returns true if the program answers this question equally, but for roundings.
    fn is_given_by(&self, program: &dyn Functions) -> bool {
        let Self { question, answer } = self;
        question.answers_agree(answer, &question.put_to(program))
    }
}

/// A comparison of recorded answers with those of another program: how many there are, and how many
/// differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mismatch {
    /// How many questions are recorded in all, also if the count stopped before the last.
    pub asked: usize,
    /// How many of these questions the other program answers otherwise; at most the limit of
    /// [`Answers::mismatch_with`].
    pub differing: usize,
}

/// The answers that a program's functions gave to [`Question`]s, recorded in order.
#[derive(Clone, Debug, Default)]
pub struct Answers {
    /// Each question with its answer, in the order in which they were asked; empty if nothing was
    /// asked.
    pub given: Vec<Answered>,
}

impl Answers {
    /// Puts all `questions` to the functions of `program`, in their order, and records the answers.
    /// A panic in the program is passed on.
    pub fn of(program: &dyn Functions, questions: Vec<Question>) -> Self {
        let questions = questions.into_iter();
        let answered = questions.map(|question| {
            let answer = question.put_to(program);
            Answered { question, answer }
        });
        Self {
            given: answered.collect(),
        }
    }

    /// Returns true if `program` answers the last of the recorded questions equally, up to
    /// rounding; also if none is recorded.
    pub fn last_is_given_by(&self, program: &dyn Functions) -> bool {
        let last = self.given.last();
        last.is_none_or(|it| it.is_given_by(program))
    }

    /// Puts the recorded questions to `program`, in their order, and counts the answers that differ
    /// from the recorded ones by more than rounding. Stops when `most` of them differ; if `most` is
    /// 0, nothing is asked.
    pub fn mismatch_with(&self, program: &dyn Functions, most: usize) -> Mismatch {
        let differing = self.given.iter().filter(|it| !it.is_given_by(program));
        Mismatch {
            asked: self.given.len(),
            differing: differing.take(most).count(),
        }
    }
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
    /// Parses the text of such a file, one JSON object per line, up to the first line that is cut
    /// off: the program that wrote it may have ended there. An empty text gives an empty result.
    pub fn read(text: &str) -> Self {
        let mut told = Self::default();
        for line in text.lines() {
            let Ok(JsonValue::Object(line)) = line.parse() else {
                break;
            };
            if let Some(function) = text_of(&line, "of") {
                let outcome = outcome(&line, &told.answers);
                let outcome = outcome.map(|outcome| FunctionOutcome { function, outcome });
                told.outcomes.extend(outcome);
            } else {
                told.answers.given.extend(answer(&line));
            }
        }
        told
    }
}

/// A line of the file. The last answer before the verdict of a broken law is that to the smallest
/// case that breaks it; only `set_face_normal` has no answers.
pub(crate) enum AnswerLine<'a> {
    /// A question, and the answer as numbers.
    Answer(&'a Question, &'a [f64]),
    /// The name of a function, and the outcome of all its laws.
    Verdict(&'static str, &'a Outcome),
}

impl AnswerLine<'_> {
    /// Appends the line to the file, which it creates if there is none.
    ///
    /// # Panics
    /// If the file can't be written.
    pub(crate) fn keep(&self, file: &Path) {
        let line = self.as_json() + "\n";
        let opened = OpenOptions::new().create(true).append(true).open(file);
        opened
            .and_then(|mut opened| opened.write_all(line.as_bytes()))
            .unwrap_or_else(|cause| panic!("{}: {cause}", file.display()));
    }

    /// Formats the line as a JSON object.
    fn as_json(&self) -> String {
        let text = |it: &str| JsonValue::from(it.to_owned());
        let numbers = |all: &[f64]| {
            let all = all.iter().map(|number| text(&format!("{number:?}")));
            JsonValue::from(all.collect::<Vec<_>>())
        };
        let mut fields = match self {
            Self::Answer(question, answer) => vec![
                ("kind", text(question.kind())),
                ("question", numbers(&question.numbers())),
                ("answer", numbers(answer)),
            ],
            Self::Verdict(of, _) => vec![("of", text(of))],
        };
        match self {
            Self::Answer(..) | Self::Verdict(_, Ok(())) => {}
            Self::Verdict(_, Err(Complaint::NotWritten(place))) => {
                fields.push(("not_written", text(place)));
            }
            Self::Verdict(_, Err(Complaint::Broken(report))) => {
                let Report { broken, test, .. } = &**report;
                let parts = [
                    &broken.law,
                    &*broken.found,
                    &broken.allowed,
                    &broken.read,
                    test,
                ];
                fields.extend(PARTS.into_iter().zip(parts.map(text)));
            }
        }
        let fields = fields.into_iter().map(|(name, it)| (name.to_owned(), it));
        let object = JsonValue::Object(fields.collect());
        object.stringify().expect("no text here is a number")
    }
}

/// The names of a report's parts in JSON.
const PARTS: [&str; 5] = ["law", "found", "allowed", "read", "test"];

/// The fields of a line's JSON object.
type Fields = HashMap<String, JsonValue>;

/// Returns the text of a field; `None` if there is no such field, or no text in it.
fn text_of(line: &Fields, name: &str) -> Option<String> {
    line.get(name)?.get::<String>().cloned()
}

/// Reads the question and the answer of a line; `None` if it has none.
fn answer(line: &Fields) -> Option<Answered> {
    let numbers = |name: &str| -> Option<Vec<f64>> {
        let numbers: &Vec<JsonValue> = line.get(name)?.get()?;
        let number = |it: &JsonValue| it.get::<String>()?.parse().ok();
        numbers.iter().map(number).collect()
    };
    let question = Question::read(&text_of(line, "kind")?, &numbers("question")?)?;
    let answer = numbers("answer")?;
    Some(Answered { question, answer })
}

/// Reads the outcome of a function's laws from a line. Its report gets all answers `before` it.
fn outcome(line: &Fields, before: &Answers) -> Option<Outcome> {
    if let Some(place) = text_of(line, "not_written") {
        return Some(Err(Complaint::NotWritten(place)));
    }
    if !line.contains_key("law") {
        return Some(Ok(()));
    }
    let parts: Vec<String> = PARTS.iter().filter_map(|it| text_of(line, it)).collect();
    let [law, found, allowed, read, test] = parts.try_into().ok()?;
    let (law, read) = (law.into(), read.into());
    let broken = BrokenLaw {
        law,
        found,
        allowed,
        read,
    };
    Some(Err(Complaint::of(broken, before.clone(), test)))
}

#[cfg(test)]
mod tests {
    use common::rtweekend::*;

    use super::*;
    use crate::{Case, ChapterScene, Trial};

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
        let kinds = [
            Question::of_prelude(),
            Question::of_sphere(Question::Decision),
            Question::of_record(),
            Question::of_list(),
            Question::of_ray_color(),
        ];
        for question in kinds.concat() {
            let numbers = question.numbers();
            let read = Question::read(question.kind(), &numbers).expect("it is a question");
            assert_eq!((read.kind(), read.numbers()), (question.kind(), numbers));
        }
    }
}
