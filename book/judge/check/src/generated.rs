//! Inverse mutation testing: finds the single edits of a chapter's text, of those that people make
//! when they type, whose programs draw a given picture.

use std::collections::HashSet;

use edits::{Defined, Edit, schemata};
use interpreter::{Canvas, PRELUDE_TEXT};
use laws::answers::Answers;
use slips::{ChapterCode, ChapterProgram};

use crate::candidate::{Candidate, Drawn, Unexplained};
use crate::case::Case;
use crate::explanation::{Explanation, described_beside};
use crate::lawful;
use crate::sources::{CorrectedLine, LineStatus, squeezed};
use crate::work::{self, Work};

/// A single edit of a chapter's text, as the edited line before and after.
#[derive(Clone, Debug)]
pub struct Generated {
    /// The chapter's line in Rust. Where the edit touches several lines, they are joined.
    pub right: String,
    /// The line with the edit made; empty if the edit deletes the line.
    pub wrong: String,
    /// The line of the reader that has the edit, with its correction; `None` if it is not found.
    pub(crate) yours: Option<CorrectedLine>,
    /// The program with the edit.
    pub(crate) program: ChapterProgram,
}

/// What a program does, by which it is told from others.
struct Effects {
    answers: Answers,
    /// The pixels of its pictures at the widths in [`SMALL`].
    small: Vec<[i32; 3]>,
}

/// The most edits for which a picture tells something of the mistake: many edits draw only sky.
pub(crate) const MOST: usize = 5;
/// The widths in pixels of the pictures by which edits are told apart.
const SMALL: [u32; 2] = [24, 33];
/// The number of edits that are shown.
const SHOWN: u64 = 3;
/// The rank above which no edit of the chapter's own files is tried.
const UNLIKELY: u32 = 7;
/// The rank above which no edit of other files is tried.
const LIKELY: u32 = 4;
/// The functions around a chapter, by which a color becomes a pixel of the file.
const AROUND: [&str; 4] = ["header", "place", "print", "level"];
/// One in so many questions of [`lawful::questions`] is asked.
const ASKED: usize = 3;
/// The price of the answers to them.
const ANSWERS: u64 = 3000;

/// An edit to be tried, with the function that it changes.
pub(crate) struct Try<'a> {
    pub(crate) name: &'a str,
    pub(crate) text: &'a str,
    pub(crate) edit: Edit,
    /// The program that has all edits of that function, and the number of this one there.
    all: ChapterProgram,
    number: u32,
    /// The picture of that program, as far as the function has no part in making it.
    canvas: Option<Canvas>,
}

/// Lists the single edits, of ranks up to `unlikely`, of those functions of a program for which
/// `is_edited` holds of the text, the likeliest first, to draw pictures `width` pixels wide.
pub(crate) fn tries<'a>(
    program: &'a ChapterProgram,
    defined: &Defined,
    width: u32,
    is_edited: impl Fn(&str) -> bool,
    unlikely: u32,
    work: &Work,
) -> Vec<Try<'a>> {
    let mut all = Vec::new();
    for (name, text) in program.functions().filter(|it| is_edited(it.1)) {
        let mut edits = edits::of_function(name, text, defined).unwrap_or_default();
        edits.retain(|it| it.rank <= unlikely);
        let (schema, numbers) = schemata::mutants(text, &edits, 1);
        let is_read = work.take(work::BYTE * schema.len() as u64 + work::START);
        let Some(mutants) = is_read
            .then(|| program.with_function(name, &schema))
            .flatten()
        else {
            continue;
        };
        let canvas = has_picture_without(program, name, text, width)
            .then(|| mutants.code().canvas(width).ok())
            .flatten();
        all.extend(edits.into_iter().zip(numbers).map(|(edit, number)| Try {
            name,
            text,
            edit,
            all: mutants.clone(),
            number,
            canvas: canvas.clone(),
        }));
    }
    all.sort_by_key(|it| it.edit.rank);
    all
}

/// Returns true if a function has no part in making the picture and in the loop around it: without
/// it there still is one, whose pixels can't be computed.
fn has_picture_without(program: &ChapterProgram, name: &str, text: &str, width: u32) -> bool {
    let head = text.find('{').map_or(text, |at| &text[..at]);
    let without = program.with_function(name, &format!("{head} {{ panic!() }}"));
    !AROUND.contains(&name) && without.is_some_and(|it| it.code().canvas(width).is_ok())
}

impl Try<'_> {
    /// Returns the program with the edit.
    pub(crate) fn program(&self) -> ChapterProgram {
        let code = self.all.code().with_mutant(self.number);
        ChapterProgram::from_reader(self.all.chapter, code)
    }

    /// Returns the picture with the edit, if its function has no part in making it.
    pub(crate) fn canvas(&self) -> Option<Canvas> {
        let canvas = self.canvas.as_ref()?;
        Some(canvas.with_mutant(self.number))
    }

    /// Makes the edit in the text itself; `None` if it can't be read.
    fn made(&self, right: &ChapterProgram) -> Option<Generated> {
        let lines = self.edit.lines(self.text);
        Some(Generated {
            right: squeezed(&lines.old),
            wrong: squeezed(&lines.new),
            yours: None,
            program: right.with_function(self.name, &self.edit.applied_to(self.text))?,
        })
    }
}

/// Finds the single edits of the chapter that draw the picture and that the reader's files do not
/// rule out; `None` if there is none. Edits with equal effects count once. The search ends when the
/// work is spent, or with more than [`MOST`] edits: then the picture tells none of them.
pub(crate) fn explanation(case: &Case) -> Option<Explanation> {
    if case.task.probe.is_some() {
        return None;
    }
    let right = Candidate::right(described_beside(case), case.conversion());
    let program = right.program();
    let files = program.chapter.files();
    let texts = files.iter().map(|it| it.text).chain([PRELUDE_TEXT]);
    let texts: Vec<&str> = texts.collect();
    let defined = Defined::by(&texts).ok()?;
    let mut found: Vec<(Candidate, Effects)> = Vec::new();
    let mut seen = HashSet::new();
    // What is found is compared as a whole.
    let whole = SHOWN * work::FEWEST * work::pixel(program.chapter);
    let reserve = case.work.set_aside(whole.min(case.work.left() / 2));
    let width = case.reading.width;
    let is_own = |text: &str| files.iter().any(|file| file.text.contains(text));
    let round = |is_own_round: bool, unlikely: u32| {
        let is_edited = |text: &str| is_own(text) == is_own_round;
        tries(&program, &defined, width, is_edited, unlikely, &case.work)
    };
    // What was typed before, or for the reader, is less likely wrong.
    let rounds = [(true, UNLIKELY), (false, LIKELY)].into_iter();
    for it in rounds.flat_map(|(is_own, unlikely)| round(is_own, unlikely)) {
        if found.len() > MOST || case.work.left() == 0 {
            break;
        }
        if !may_draw(case, &right, &it) || !seen.insert(it.edit.applied_to(it.text)) {
            continue;
        }
        let (Some(made), true) = (it.made(&program), case.work.take(work::TEXT)) else {
            continue;
        };
        let status = case.context.sources.status(&program, &made.program);
        if status == LineStatus::Right {
            continue;
        }
        let Some(effects) = Effects::of(&made.program, &case.work) else {
            break;
        };
        let yours = match status {
            LineStatus::Wrong(line) => Some(line),
            _ => None,
        };
        let made = Generated { yours, ..made };
        add(&mut found, (right.edited(made), effects));
    }
    case.work.add(&reserve);
    of_found(case, found)
}

/// Returns true if the program with an edit draws a sample of the picture.
fn may_draw(case: &Case, right: &Candidate, it: &Try) -> bool {
    let drawn = match it.canvas() {
        Some(canvas) => Drawn::edited(canvas, right, case.reading, &case.work),
        None => {
            let program = it.program();
            let edited = right.edited(Generated::unnamed(program));
            edited.drawn(case.reading, &case.work)
        }
    };
    drawn.is_some_and(|it| case.places().are_drawn_by(&it))
}

/// Adds a candidate, unless one has the same effects; one that is found in the reader's files
/// replaces it.
fn add(found: &mut Vec<(Candidate, Effects)>, new: (Candidate, Effects)) {
    let is_in_text = |it: &Candidate| it.edit.as_ref().is_some_and(|it| it.yours.is_some());
    match found.iter_mut().find(|it| it.1.are_those_of(&new.1)) {
        Some(known) if is_in_text(&new.0) && !is_in_text(&known.0) => *known = new,
        Some(_) => {}
        None => found.push(new),
    }
}

/// Makes the explanation of the candidates: those that are found in the reader's files, if some are.
/// If they are few, only those that draw every pixel.
fn of_found(case: &Case, found: Vec<(Candidate, Effects)>) -> Option<Explanation> {
    let mut by: Vec<Candidate> = found.into_iter().map(|it| it.0).collect();
    let is_in_text = |it: &Candidate| it.edit.as_ref().is_some_and(|it| it.yours.is_some());
    let is_any_in_text = by.iter().any(is_in_text);
    by.retain(|it| !is_any_in_text || is_in_text(it));
    let mut left = Unexplained::default();
    if by.len() <= MOST {
        let mut rest = by.len() as u64;
        by.retain(|it| {
            let part = case.work.part(rest);
            rest -= 1;
            let found = it.unexplained(case.reading, &part, 0);
            case.work.add(&part);
            let is_it = found.is_some_and(|it| it.is_nothing());
            left = found.filter(|_| is_it).unwrap_or(left);
            is_it
        });
    }
    (!by.is_empty()).then(|| Explanation {
        count: by.len(),
        by,
        left,
        is_in_text: is_any_in_text || case.context.sources.is_empty(),
    })
}

impl Generated {
    /// Makes an edit of which only the program is known.
    fn unnamed(program: ChapterProgram) -> Self {
        Self {
            right: String::new(),
            wrong: String::new(),
            yours: None,
            program,
        }
    }
}

impl Effects {
    /// Runs a program to see its effects; `None` if no work is left.
    fn of(program: &ChapterProgram, work: &Work) -> Option<Self> {
        let small = SMALL.map(|width| program.run(width));
        let count: u64 = small
            .iter()
            .map(|it| u64::from(it.size().0 * it.size().1))
            .sum();
        let price = ANSWERS + count * work::pixel(program.chapter);
        work.take(price).then(|| Self {
            answers: answers(program),
            small: small
                .iter()
                .flat_map(|it| it.pixels().collect::<Vec<_>>())
                .collect(),
        })
    }

    fn are_those_of(&self, other: &Self) -> bool {
        let mut answers = self.answers.given.iter().zip(&other.answers.given);
        self.small == other.small
            && answers.all(|(one, other)| one.question.answers_agree(&one.answer, &other.answer))
    }
}

/// Asks a program questions about all of its functions, and returns them with its answers.
pub(crate) fn answers(program: &ChapterProgram) -> Answers {
    let questions = lawful::questions(program.chapter).into_iter();
    lawful::answers_of(program, questions.step_by(ASKED))
}
