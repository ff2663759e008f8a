//! The judge behind the editor of a page: texts in; pixels and words out.
//!
//! [`interpreter`] reads and draws the text that a reader types, [`laws`] try its functions, and
//! [`check`] judges it in the words that `watch` has for a crate on disk. This module turns the
//! verdict into HTML.

use check::answer::{Answer, Grade, Pictures, Row, RowKind};
use check::attempt::{Attempt, Commands, LawsStatus};
use check::context::Context;
use check::html::{self, HostPage};
use check::lawful;
use check::names::companion_command;
use check::reading::Reading;
use check::seen;
use check::sentences;
use check::sources::Sources;
use check::task::Task;
use check::{TypedText, judge};
use common::rtweekend::*;
use interpreter::{Fault, FaultKind, SourceFile, Span};
use laws::{Complaint, Report, Trial};
use slips::{Chapter, ChapterCode, ChapterProgram, Languages, Slip, steps};

use crate::typing::Caret;

/// A chapter as a reader has typed it so far in a page.
#[derive(Clone, Debug)]
pub struct Draft {
    /// The chapter that the reader types.
    pub chapter: Chapter,
    /// The files in the order in which they are typed: the crate's root, `src/lib.rs`, last. Empty
    /// for [`Chapter::SpeedVsAccuracy`], whose files are not typed.
    pub files: Vec<SourceFile>,
    /// The line at whose end the reader is typing, or `None` if the text counts as finished.
    pub caret: Option<Caret>,
}

/// The judgement on a draft, laid out as HTML.
#[derive(Debug)]
pub struct Feedback {
    /// The grade of the verdict.
    pub grade: Grade,
    /// True if a line counts as unfinished only because the reader is typing at its end: it is to be
    /// judged when the reader rests, or goes elsewhere.
    pub is_waiting: bool,
    /// The places in the draft to be underlined, each with the index of its file in
    /// [`Draft::files`], from 0; empty if no place is at fault.
    pub places: Vec<Span>,
    /// The verdict as one line of HTML, without a line break, which the page reads aloud.
    pub headline: String,
    /// The explanation below the verdict, as HTML; empty if there is none.
    pub rest: String,
}

impl Feedback {
    /// Lays out an answer as HTML, with no place to be underlined.
    fn new(answer: &Answer) -> Self {
        Self {
            grade: answer.headline.grade,
            is_waiting: false,
            places: Vec::new(),
            headline: html::headline(&answer.headline),
            rest: html::details(answer, HostPage::Book),
        }
    }

    /// Makes the feedback while the reader is typing the statement in this line, with what is wrong
    /// with it so far.
    fn being_typed(line: usize, so_far: Option<Row>) -> Self {
        let said = format!("Not finished: you are typing line {line}.");
        Self {
            is_waiting: true,
            ..Self::new(&Answer::sentence(Grade::OnTheWay, said).with(so_far))
        }
    }
}

/// Returns the plain texts with which an editor begins: for each file of the chapter three, its
/// name, its text with `todo!()` in its functions, and its complete text. The last text has the
/// chapter's steps, the instructions to the reader, one per line.
pub fn beginning(chapter: Chapter) -> Vec<String> {
    let files = Draft::skeleton(chapter).files.into_iter();
    let files = files.zip(Draft::complete(chapter).files);
    let files = files.flat_map(|(empty, full)| [empty.name, empty.text, full.text]);
    let steps: Vec<&str> = steps::of_chapter(chapter)
        .iter()
        .map(|step| step.instruction)
        .collect();
    files.chain([steps.join("\n")]).collect()
}

impl Draft {
    /// Returns a draft of the chapter's files with `todo!()` as the body of each function to be
    /// typed, and without a caret.
    pub fn skeleton(chapter: Chapter) -> Self {
        Self {
            chapter,
            files: skeletons::files(chapter, false),
            caret: None,
        }
    }

    /// Returns a draft that has the files of the chapter, complete and without comments, and no
    /// caret.
    pub fn complete(chapter: Chapter) -> Self {
        let mut draft = Self::skeleton(chapter);
        for file in &mut draft.files {
            if let Some(full) = chapter.files().iter().find(|it| it.name == file.name) {
                file.text = full.text.to_owned();
            }
        }
        draft
    }

    /// Parses and checks the draft, so that its picture can be drawn.
    ///
    /// # Errors
    /// Returns feedback if a compiler would refuse the text, or if the interpreter can't read it.
    pub fn read(&self) -> Result<interpreter::Program, Feedback> {
        interpreter::read(&self.files).map_err(|fault| self.not_compiled(&fault))
    }

    /// Draws the picture of `program`, as which [`Draft::read`] has read this draft, `width` pixels
    /// wide.
    ///
    /// # Errors
    /// Returns the feedback on a program that panics, or that a compiler would refuse.
    pub fn draw(&self, program: &interpreter::Program, width: u32) -> Result<Picture, Feedback> {
        program.draw(width).map_err(|fault| match fault.kind {
            FaultKind::Stopped => self.stopped(&fault),
            _ => self.not_compiled(&fault),
        })
    }

    /// Judges the draft, which was read as `program` and drew `picture`, and lays out the answer as
    /// HTML: first what is to be seen, or the ray with which a law is broken, then the line. While
    /// the statement at the caret is the beginning of one of the chapter's, the feedback on a wrong
    /// draft says only that this line is being typed.
    pub fn judged(&self, program: interpreter::Program, picture: &Picture) -> Feedback {
        let asked = ChapterProgram::from_reader(self.chapter, program.clone());
        let laws = laws_of(&asked);
        let mut answer = self.answer_under(laws.as_ref(), &asked, &program, picture);
        // A line that the picture never runs is run by the laws.
        if let Some(fault) = program.first_refusal() {
            return self.not_compiled(fault);
        }
        if answer.headline.grade != Grade::Wrong {
            return Feedback::new(&answer);
        }
        if let Some(line) = self.begun_line() {
            return Feedback::being_typed(line, None);
        }
        let seen = self.seen(&answer, picture);
        match &laws {
            Some(LawsStatus::Broken(report)) if seen.is_empty() => show_ray(&mut answer, report),
            _ => drop(answer.rows.splice(0..0, seen)),
        }
        Feedback::new(&answer)
    }

    /// Observes what `picture` shows beside the right one, unless the answer has told it.
    fn seen(&self, answer: &Answer, picture: &Picture) -> Vec<Row> {
        let is_told = answer.rows.iter().any(|it| it.kind == RowKind::Seen);
        let Some(Pictures { right, .. }) = answer.pictures.as_ref().filter(|_| !is_told) else {
            return Vec::new();
        };
        let (task, reading) = (Task::of(self.chapter), Reading::of(picture));
        let (seen, _) = seen::observe(&task, &reading, right);
        let seen = seen.into_iter().take(MOST_SEEN);
        seen.map(|it| Row::new(RowKind::Seen, it)).collect()
    }

    /// Judges the draft, which was read as `program` and drew `picture`: compares the picture with
    /// the right one, tries the laws (properties that a right function has) on its functions, and
    /// compares its lines with the chapter's. The caret counts for nothing.
    pub fn answer(&self, program: &interpreter::Program, picture: &Picture) -> Answer {
        let asked = ChapterProgram::from_reader(self.chapter, program.clone());
        self.answer_under(laws_of(&asked).as_ref(), &asked, program, picture)
    }

    /// Judges the draft with the outcome of the laws, which were tried on `asked`. A picture of one of
    /// the chapter's steps is not called right if a line of the draft is wrong: many a mistake draws
    /// white, or only sky.
    fn answer_under(
        &self,
        laws: Option<&LawsStatus>,
        asked: &ChapterProgram,
        program: &interpreter::Program,
        picture: &Picture,
    ) -> Answer {
        let task = Task::of(self.chapter);
        let answers = lawful::answers_of(asked, lawful::questions(self.chapter));
        let compare = |program: &ChapterProgram| {
            lawful::mismatch_with(&answers, self.chapter, program, MOST_UNLIKE)
        };
        let can_be_made =
            |slip: &Slip| slip.is_possible_in_rust() && slip.is_typed_in(self.chapter);
        let reading = Reading::of(picture);
        let answer = |steps: usize| {
            let context = Context {
                languages: Languages::Rust,
                can_be_made: Some(&can_be_made),
                sources: Sources::of_chapter(self.files.clone(), self.chapter),
                typed: Some(TypedText {
                    files: &self.files,
                    program,
                }),
                answers: laws.is_some().then_some(&compare),
                warnings: Vec::new(),
                steps: vec![false; steps],
            };
            let attempt = Attempt {
                laws,
                commands: self.commands(),
                ..Attempt::new(task, &context)
            };
            attempt.answer(judge(&task, &reading, 0, &context))
        };
        let with_steps = answer(steps::of_chapter(self.chapter).len());
        if with_steps.is_right() || with_steps.done.is_empty() {
            return with_steps;
        }
        let whole = answer(0);
        let is_wrong_there = whole.rows.iter().any(|it| it.kind == RowKind::Yours);
        if is_wrong_there { whole } else { with_steps }
    }

    /// Returns what the reader can do next, beside the buttons of the page.
    fn commands(&self) -> Commands<'_> {
        let (name, companion) = (self.chapter.name(), companion_command());
        Commands {
            judge: Box::new(move |probe| {
                let probe = probe.map_or("", |probe| probe.name);
                format!("{companion} watch {name} --probe {probe}, at home")
            }),
            // A button below the answer leads on.
            start: None,
            test: "",
        }
    }

    /// Returns the feedback on a text that can't be run: calm, if the reader is still typing the
    /// line.
    fn not_compiled(&self, fault: &Fault) -> Feedback {
        let habit = self.habit(fault);
        let row = |words: String| Row::new(RowKind::Printed, words);
        let place = self.place(fault).map_or(String::new(), |it| it + "  ");
        let words = match &habit {
            Some(rust) => format!("{}: {rust}", fault.message),
            None => fault.message.clone(),
        };
        if let Some(line) = self.unfinished_line(fault) {
            let rests = self.caret.is_some_and(|it| it.rests);
            let so_far = rests.then(|| row(format!("So far: {words}")));
            return Feedback::being_typed(line, so_far);
        }
        match fault.kind {
            FaultKind::Unread => {
                let number = fault.place().map_or(0, |it| it.line);
                let what = &fault.message;
                let may = if habit.is_some() { "" } else { "; cargo may" };
                let said = format!("This page cannot read line {number} ({what}){may}.");
                let habit = habit.map(|rust| row(place + &rust));
                Feedback::new(&Answer::sentence(Grade::OnTheWay, said).with(habit))
            }
            FaultKind::Unfinished => {
                let said = format!("Not finished: {}.", fault.message);
                Feedback::new(&Answer::sentence(Grade::OnTheWay, said))
            }
            _ => Feedback {
                places: fault.place().into_iter().collect(),
                ..Feedback::new(&sentences::not_compiled(1, vec![row(place + &words)]))
            },
        }
    }

    /// Returns the feedback on a program that stopped while it was drawn.
    fn stopped(&self, fault: &Fault) -> Feedback {
        let is_unwritten = fault.message.starts_with(NOT_WRITTEN);
        if let Some(place) = self.first_unwritten().filter(|_| is_unwritten) {
            return Feedback::new(&sentences::not_written(self.chapter, &place, &[]));
        }
        let place = self.place(fault);
        let place = place.map_or(String::new(), |place| format!(" at {place}"));
        let said = format!("The program stopped{place}: {}.", fault.message);
        Feedback {
            places: fault.place().into_iter().collect(),
            ..Feedback::new(&Answer::sentence(Grade::Wrong, said))
        }
    }

    /// Returns the place of the first `todo!()`, in the order in which the files are typed: the
    /// picture stops at the last.
    fn first_unwritten(&self) -> Option<String> {
        self.files.iter().find_map(|SourceFile { name, text }| {
            let lines = text.lines().zip(1..);
            let mut places = lines.filter_map(|(line, n)| Some((n, line.find("todo!()")? + 1)));
            let (line, column) = places.next()?;
            Some(format!("{name}:{line}:{column}"))
        })
    }

    /// Returns the place of a fault as rustc writes it: `file:line:column`, both counted from 1.
    fn place(&self, fault: &Fault) -> Option<String> {
        let place = fault.place()?;
        let name = &self.files[usize::from(place.file)].name;
        Some(format!("{name}:{}:{}", place.line, place.start + 1))
    }
}

/// The beginning of the message of a panic in `todo!()`.
const NOT_WRITTEN: &str = "not yet implemented";
/// The number of observations that are told before a line is.
const MOST_SEEN: usize = 2;
/// The number of answers unlike a program's at which counting stops.
const MOST_UNLIKE: usize = 60;
/// The number of cases for each law: the interpreter is a hundred times slower than compiled code.
const CASES: u32 = 100;

/// Puts the law of the report before all rows of the answer, with the smallest case that breaks it.
fn show_ray(answer: &mut Answer, report: &Report) {
    let is_of_law = |it: &Row| [RowKind::Law, RowKind::Found, RowKind::Allowed].contains(&it.kind);
    answer.rows.retain(|it| !is_of_law(it));
    let mut rows: Vec<Row> = sentences::law_rows(report)
        .into_iter()
        .filter(is_of_law)
        .collect();
    let is_of_case = |it: &&str| it.starts_with("let ") && !it.contains("laws::");
    let case = report.test.lines().filter(is_of_case);
    let case: Vec<&str> = case.collect();
    if !case.is_empty() {
        rows.insert(
            1,
            Row::new(RowKind::More, format!("for `{}`", case.join(" "))),
        );
    }
    answer.rows.splice(0..0, rows);
}

/// Tries the laws on the program's functions. Returns `None` for the chapters without a sphere.
fn laws_of(program: &ChapterProgram) -> Option<LawsStatus> {
    if program.chapter <= Chapter::Gradient {
        return None;
    }
    let trial = Trial {
        cases: CASES,
        ..Trial::default()
    };
    let outcome = lawful::try_laws(program, &trial);
    Some(
        match lawful::explained(outcome, program.chapter, Languages::Rust) {
            Ok(()) => LawsStatus::Obeyed,
            Err(Complaint::Broken(report)) => LawsStatus::Broken(report),
            Err(Complaint::NotWritten(place)) => LawsStatus::NotWritten(place),
        },
    )
}
