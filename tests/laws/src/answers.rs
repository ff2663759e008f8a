//! Answers as evidence: what a function said to the telling questions, and what came of its laws,
//! kept in a file, so that a judge in another process can weigh them beside a picture.
//!
//! Each line of the file is a JSON object: an answer, or the verdict on one function behind its
//! answers. Numbers are text, for which JSON has no NaN and no infinity. A function
//! that never returns leaves what it answered before.

use std::collections::HashMap;
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

use tinyjson::JsonValue;

use crate::question::{Functions, Question};
use crate::verdict::{Broken, Complaint, Outcome, Report};

/// The environment variable that names the file.
pub const ANSWERS: &str = "LAWS_ANSWERS";

/// What functions answered.
#[derive(Clone, Debug, Default)]
pub struct Answers {
    /// Questions and answers, in their order.
    pub given: Vec<(Question, Vec<f64>)>,
}

impl Answers {
    /// Asks a program.
    pub fn of(program: &dyn Functions, questions: Vec<Question>) -> Self {
        let questions = questions.into_iter();
        let answered = questions.map(|question| {
            let answer = question.put_to(program);
            (question, answer)
        });
        Self {
            given: answered.collect(),
        }
    }

    /// Returns true if the program gives the last answer, too.
    pub fn ends_as(&self, program: &dyn Functions) -> bool {
        let last = self.given.last();
        last.is_none_or(|(question, answer)| question.same(answer, &question.put_to(program)))
    }

    /// Counts all answers, and those that the program does not give, up to `most`.
    pub fn unlike(&self, program: &dyn Functions, most: usize) -> (usize, usize) {
        let given = self.given.iter();
        let unlike =
            given.filter(|(question, answer)| !question.same(answer, &question.put_to(program)));
        (self.given.len(), unlike.take(most).count())
    }
}

/// What a file of answers tells.
#[derive(Debug, Default)]
pub struct Told {
    /// All answers.
    pub answers: Answers,
    /// What came of each function, by its name.
    pub outcomes: Vec<(String, Outcome)>,
}

impl Told {
    /// Reads as far as there are whole lines: a program may have ended before it wrote the rest.
    pub fn read(text: &str) -> Self {
        let mut told = Self::default();
        for line in text.lines() {
            let Ok(line) = line.parse::<JsonValue>() else {
                break;
            };
            if let Some(given) = answer(&line) {
                told.answers.given.push(given);
            } else if let Some((of, mut outcome)) = verdict(&line) {
                if let Err(Complaint::Broken(report)) = &mut outcome {
                    let before = told.answers.given.iter().cloned();
                    report.answers.given.splice(0..0, before);
                }
                told.outcomes.push((of, outcome));
            }
        }
        told
    }
}

/// What is written to the file.
pub(crate) enum Line<'a> {
    Answer(&'a Question, &'a [f64]),
    /// What came of the function of that name.
    Verdict(&'static str, &'a Outcome),
}

impl Line<'_> {
    /// Adds the line to the file.
    ///
    /// # Panics
    /// If that can't be written.
    pub(crate) fn keep(&self, file: &Path) {
        let line = self.text() + "\n";
        let opened = OpenOptions::new().create(true).append(true).open(file);
        opened
            .and_then(|mut opened| opened.write_all(line.as_bytes()))
            .unwrap_or_else(|cause| panic!("{}: {cause}", file.display()));
    }

    fn text(&self) -> String {
        let mut fields = match self {
            Self::Answer(question, answer) => asked(question, answer).to_vec(),
            Self::Verdict(of, outcome) => {
                let mut fields = vec![("of", JsonValue::from((*of).to_owned()))];
                match outcome {
                    Ok(()) => {}
                    Err(Complaint::NotWritten(place)) => {
                        fields.push(("not_written", place.clone().into()));
                    }
                    Err(Complaint::Broken(report)) => fields.extend(broken(report)),
                }
                fields
            }
        };
        let fields = fields.drain(..).map(|(name, it)| (name.to_owned(), it));
        let object = JsonValue::Object(fields.collect());
        object.stringify().expect("no text here is a number")
    }
}

fn asked(question: &Question, answer: &[f64]) -> [(&'static str, JsonValue); 3] {
    let numbers =
        |all: &[f64]| -> Vec<JsonValue> { all.iter().map(|it| format!("{it:?}").into()).collect() };
    [
        ("kind", question.kind().to_owned().into()),
        ("question", numbers(&question.numbers()).into()),
        ("answer", numbers(answer).into()),
    ]
}

fn broken(report: &Report) -> Vec<(&'static str, JsonValue)> {
    let Broken {
        law,
        found,
        allowed,
        read,
    } = report.broken.clone();
    let mut fields = vec![
        ("law", law.into_owned().into()),
        ("found", found.into()),
        ("allowed", allowed.into()),
        ("read", read.into_owned().into()),
        ("test", report.test.clone().into()),
    ];
    let smallest = report.answers.given.last();
    fields.extend(
        smallest
            .iter()
            .flat_map(|(question, answer)| asked(question, answer)),
    );
    fields
}

fn field<'a>(line: &'a JsonValue, name: &str) -> Option<&'a JsonValue> {
    line.get::<HashMap<String, JsonValue>>()?.get(name)
}

fn text(line: &JsonValue, name: &str) -> Option<String> {
    field(line, name)?.get::<String>().cloned()
}

fn numbers(line: &JsonValue, name: &str) -> Option<Vec<f64>> {
    let numbers: &Vec<JsonValue> = field(line, name)?.get()?;
    let number = |it: &JsonValue| it.get::<String>()?.parse().ok();
    numbers.iter().map(number).collect()
}

fn question(line: &JsonValue) -> Option<(Question, Vec<f64>)> {
    let question = Question::read(&text(line, "kind")?, &numbers(line, "question")?)?;
    Some((question, numbers(line, "answer")?))
}

/// Reads an answer, if the line is about no verdict.
fn answer(line: &JsonValue) -> Option<(Question, Vec<f64>)> {
    text(line, "of").is_none().then(|| question(line)).flatten()
}

fn verdict(line: &JsonValue) -> Option<(String, Outcome)> {
    let of = text(line, "of")?;
    if let Some(place) = text(line, "not_written") {
        return Some((of, Err(Complaint::NotWritten(place))));
    }
    let Some(law) = text(line, "law") else {
        return Some((of, Ok(())));
    };
    let report = Report {
        broken: Broken {
            law: law.into(),
            found: text(line, "found")?,
            allowed: text(line, "allowed")?,
            read: text(line, "read")?.into(),
        },
        answers: Answers {
            given: question(line).into_iter().collect(),
        },
        same_as: Vec::new(),
        test: text(line, "test")?,
    };
    Some((of, Err(Complaint::Broken(Box::new(report)))))
}

#[cfg(test)]
mod tests {
    use common::rtweekend::*;

    use super::*;
    use crate::{Case, Scene, Trial};

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
            trial.ray_color(Scene::Sky, &sky)?;
            trial.nearer_root(&|center, radius, ray| no_number(&Case::new(center, radius, *ray)))
        });
        let Err(Complaint::Broken(report)) = outcome else {
            panic!("t is not finite");
        };
        let told = Told::read(&text);
        let [
            (ray_color, Ok(())),
            (hit_sphere, Err(Complaint::Broken(read))),
        ] = &told.outcomes[..]
        else {
            panic!("{:?}", told.outcomes);
        };
        assert_eq!((&**ray_color, &**hit_sphere), ("ray_color", "hit_sphere"));
        assert_eq!((&read.broken, &read.test), (&report.broken, &report.test));
        // The smallest case stands behind all that was answered.
        let all = told.answers.given.iter().chain(read.answers.given.last());
        // A NaN has many bits.
        let said = |(question, answer): &(Question, Vec<f64>)| {
            format!("{} {:?} {answer:?}", question.kind(), question.numbers())
        };
        let read: Vec<_> = read.answers.given.iter().map(said).collect();
        assert_eq!(all.map(said).collect::<Vec<_>>(), read);
        let given = report.answers.given.iter().map(said);
        assert!(
            given.eq(read[read.len() - report.answers.given.len()..]
                .iter()
                .cloned())
        );
        // A program may end before it has written a line.
        let (whole, _) = text.split_at(text.len() / 2);
        let answers = Told::read(whole).answers.given;
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
