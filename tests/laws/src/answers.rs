//! Answers as evidence: what a function said to the telling questions, kept in a file, so
//! that a judge can weigh them beside a picture.
//!
//! Each line is an answer: the kind of the question, then numbers that read back to the
//! bit. A function that panics or never returns leaves what it answered before.

use std::collections::HashMap;
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

use slips::{Chapter, Program};

use crate::prelude::FUNCTIONS;
use crate::question::{self, Question};

/// The environment variable that names the file.
pub const ANSWERS: &str = "LAWS_ANSWERS";

/// What the functions of a chapter answered.
#[derive(Debug)]
pub struct Answers {
    chapter: Chapter,
    answers: Vec<(Box<dyn Question>, Vec<f64>)>,
}

impl Answers {
    /// The answers in the text of a file. A text without any is no answers.
    pub fn read(chapter: Chapter, text: &str) -> Self {
        let mut lines: HashMap<&str, Vec<&str>> = HashMap::new();
        // What a program was about to write when it ended has no end of its own.
        for line in text
            .split_inclusive('\n')
            .filter_map(|it| it.strip_suffix('\n'))
        {
            let (kind, numbers) = line.split_once(' ').unwrap_or((line, ""));
            lines.entry(kind).or_default().push(numbers);
        }
        let mut lines: HashMap<&str, _> = lines
            .into_iter()
            .map(|(kind, lines)| (kind, lines.into_iter()))
            .collect();
        let questions = question::all(chapter).into_iter();
        let answers = questions.filter_map(|question| {
            let numbers = lines.get_mut(question.kind())?.next()?;
            let numbers = numbers.split_whitespace().map(str::parse);
            Some((question, numbers.collect::<Result<_, _>>().ok()?))
        });
        Self {
            chapter,
            answers: answers.collect(),
        }
    }

    /// What the functions of a program answer, as its chapter has them.
    pub fn of(program: &Program) -> Self {
        let answered = |question: Box<dyn Question>| {
            let answer = question.answer_of(program);
            (question, answer)
        };
        let questions = question::all(program.chapter).into_iter();
        Self {
            chapter: program.chapter,
            answers: questions.map(answered).collect(),
        }
    }

    /// Whether nothing was answered.
    pub fn is_empty(&self) -> bool {
        self.answers.is_empty()
    }

    /// Whether a function of the prelude is wrong, on which all others may stand.
    pub fn has_wrong_prelude(&self) -> bool {
        let right = Program::right(self.chapter);
        let mut answers = self.answers.iter();
        answers.any(|(question, answer)| {
            let is_of_prelude = FUNCTIONS.iter().any(|it| it.name == question.kind());
            is_of_prelude && !question.same(answer, &question.answer_of(&right))
        })
    }

    /// Of how many answers how many are not those of the program. After `most` of them no
    /// more are counted. A program of another chapter has other functions: of none.
    pub fn unlike(&self, program: &Program, most: usize) -> (usize, usize) {
        if program.chapter != self.chapter {
            return (0, 0);
        }
        let answers = self.answers.iter();
        let unlike = answers
            .filter(|(question, answer)| !question.same(answer, &question.answer_of(program)));
        (self.answers.len(), unlike.take(most).count())
    }
}

/// Adds the answer to the file.
///
/// # Panics
/// If that can't be written.
pub(crate) fn add(file: &Path, question: &dyn Question, answer: &[f64]) {
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
        let all = question::all(chapter).into_iter();
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
        assert!(Answers::read(chapter, "hit three\n").is_empty());
    }
}
