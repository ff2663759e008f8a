//! Answers as evidence: what a function said to the telling questions, kept in a file, so
//! that a judge can weigh them beside a picture.
//!
//! Each line is an answer: the kind of the question, then numbers that read back to the
//! bit. A function that panics or never returns leaves what it answered before.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

use slips::{Chapter, Program};

use crate::prelude::FUNCTIONS;
use crate::question::Question;
use crate::{prelude, strategies};

/// The environment variable that names the file.
pub const ANSWERS: &str = "LAWS_ANSWERS";

/// What the functions of a chapter answered.
#[derive(Debug)]
pub struct Answers {
    pub(crate) chapter: Chapter,
    pub(crate) given: Vec<(Box<dyn Question>, Vec<f64>)>,
}

impl Answers {
    /// The answers in the text of a file. A text without any is no answers.
    pub fn read(chapter: Chapter, text: &str) -> Self {
        // What a program was about to write when it ended has no end of its own.
        let whole = text.rsplit_once('\n').map_or("", |(whole, _)| whole);
        let mut lines = whole.lines().peekable();
        let answered = |question: Box<dyn Question>| {
            let is_answer = |line: &&str| line.split(' ').next() == Some(question.kind());
            let numbers = lines.next_if(is_answer)?.split(' ').skip(1).map(str::parse);
            let answer = numbers.collect::<Result<_, _>>().ok()?;
            Some((question, answer))
        };
        Self {
            chapter,
            given: telling(chapter).into_iter().filter_map(answered).collect(),
        }
    }

    /// What the functions of a program answer, as its chapter has them.
    pub fn of(program: &Program) -> Self {
        let answered = |question: Box<dyn Question>| {
            let answer = question.answer_of(program);
            (question, answer)
        };
        let questions = telling(program.chapter).into_iter();
        Self {
            chapter: program.chapter,
            given: questions.map(answered).collect(),
        }
    }

    /// Whether a function of the prelude is wrong, on which all others may stand.
    pub fn has_wrong_prelude(&self) -> bool {
        let right = Program::right(self.chapter);
        let mut given = self.given.iter();
        given.any(|(question, answer)| {
            let is_of_prelude = FUNCTIONS.iter().any(|it| it.name() == question.kind());
            is_of_prelude && !question.same(answer, &question.answer_of(&right))
        })
    }

    /// Whether the last answer is that of the program: a mistake that does not give it is not what
    /// it comes from.
    pub(crate) fn ends_as(&self, program: &Program) -> bool {
        let last = self.given.last();
        last.is_none_or(|(question, answer)| question.same(answer, &question.answer_of(program)))
    }

    /// Of how many answers how many are not those of the program. After `most` of them no
    /// more are counted. A program of another chapter has other functions: of none.
    pub fn unlike(&self, program: &Program, most: usize) -> (usize, usize) {
        if program.chapter != self.chapter {
            return (0, 0);
        }
        let given = self.given.iter();
        let unlike =
            given.filter(|(question, answer)| !question.same(answer, &question.answer_of(program)));
        (self.given.len(), unlike.take(most).count())
    }
}

/// The telling questions to all functions of the chapter, in the order in which they are put.
fn telling(chapter: Chapter) -> Vec<Box<dyn Question>> {
    let mut all = Vec::new();
    if chapter > Chapter::BuildTest {
        all.extend(boxed(prelude::telling()));
    }
    if chapter > Chapter::Gradient {
        all.extend(boxed(strategies::telling(&strategies::ordinary_asked())));
    }
    if chapter == Chapter::HittableList {
        all.extend(boxed(strategies::telling(&strategies::worlds())));
    }
    if chapter > Chapter::BuildTest {
        all.extend(boxed(strategies::telling(&strategies::rays())));
    }
    all
}

fn boxed(questions: Vec<impl Question>) -> impl Iterator<Item = Box<dyn Question>> {
    questions.into_iter().map(|it| Box::new(it) as _)
}

/// Adds the answer to the file.
///
/// # Panics
/// If that can't be written.
pub(crate) fn keep(file: &Path, question: &dyn Question, answer: &[f64]) {
    let opened = OpenOptions::new().create(true).append(true).open(file);
    opened
        .and_then(|mut opened| opened.write_all(line(question, answer).as_bytes()))
        .unwrap_or_else(|cause| panic!("{}: {cause}", file.display()));
}

fn line(question: &dyn Question, answer: &[f64]) -> String {
    let numbers = answer.iter().map(|number| format!(" {number:?}"));
    format!("{}{}\n", question.kind(), numbers.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_reads_back_as_far_as_it_goes() {
        let chapter = Chapter::HittableList;
        let right = Program::right(chapter);
        let all = telling(chapter).into_iter();
        let lines = all.map(|it| line(it.as_ref(), &it.answer_of(&right)));
        let lines: Vec<String> = lines.collect();
        // The last line breaks off.
        let text = lines[..700].concat() + &lines[700][..3];
        let answers = Answers::read(chapter, &text);
        assert_eq!(answers.unlike(&right, usize::MAX), (700, 0));
        let slip = slips::find("minus-h")
            .expect("it is known")
            .program(chapter);
        assert!(answers.unlike(&slip, usize::MAX).1 > 100);
        assert_eq!(
            Answers::read(chapter, "sphere three\n").unlike(&slip, 1),
            (0, 0)
        );
    }
}
