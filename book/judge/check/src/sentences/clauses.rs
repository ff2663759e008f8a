//! Clauses of which sentences are made, and rows that several have.

use std::iter;

use laws::Report;
use slips::{Chapter, Languages, Slip, steps};

use crate::answer::{Row, RowKind};
use crate::candidate::Unexplained;
use crate::names;
use crate::sources::CorrectedLine;
use crate::task::{Task, Version};

/// Returns the line of the reader's list of done things for a step of a chapter, counted from 1, in
/// plain text: `normals: step 1 shows what it should`.
pub fn step_done_line(chapter: Chapter, step: usize) -> String {
    format!("{}: step {step} shows what it should", chapter.name())
}

/// Returns the line of the reader's list of done things for the right picture of a chapter, in
/// plain text: `normals: the picture is right, to the last bit`.
pub fn picture_done_line(chapter: Chapter) -> String {
    format!("{}: the picture is right, to the last bit", chapter.name())
}

/// Names a task: `step 1 of normals`, `normals with the probe far`.
pub(super) fn named(task: &Task) -> String {
    let step = task
        .step
        .map_or(String::new(), |step| format!("step {} of ", step + 1));
    let probe = task
        .probe
        .map_or(String::new(), |it| format!(" with the probe {}", it.name));
    format!("{step}{}{probe}", task.chapter.name())
}

/// Names the step at an index from 0, and how many there are: `Step 1 of 3`.
pub(super) fn step_of(chapter: Chapter, step: usize) -> String {
    format!("Step {} of {}", step + 1, steps::of_chapter(chapter).len())
}

/// Says by which version of the book a task is drawn: ` by version 3 of the book`. Returns an empty
/// text for version 4, which the chapters follow.
pub(crate) fn by(task: &Task) -> String {
    match task.version {
        Version::Three => format!(" {}", slips::version_3().right),
        Version::Four => String::new(),
    }
}

/// Counts differing pixels: `1 of 90 pixels differs`.
pub(super) fn differ(count: usize, total: usize) -> String {
    let differ = if count == 1 { "differs" } else { "differ" };
    format!("{count} of {total} pixels {differ}")
}

/// Names a range of columns or rows: `row 3`, `rows 3 to 7`.
pub(super) fn span(name: &str, [first, last]: [u32; 2]) -> String {
    match first == last {
        true => format!("{name} {first}"),
        false => format!("{name}s {first} to {last}"),
    }
}

impl Unexplained {
    /// Says how many pixels are off, and where.
    pub(super) fn said(&self) -> String {
        let of = format!("{} of {} pixels", self.off, self.compared);
        if self.is_rounding() {
            return format!("a difference of one level in {of}");
        }
        let (columns, rows) = (span("column", self.columns), span("row", self.rows));
        format!("{of}, in {columns}, {rows}")
    }

    /// Says how well a program draws a picture.
    pub(super) fn drawn(&self) -> String {
        match (self.is_nothing(), self.compared < self.total) {
            (true, false) => "exactly your picture".to_owned(),
            (true, true) => format!(
                "your picture: each of {} pixels that were compared, of {}",
                self.compared, self.total
            ),
            (false, _) => format!("your picture, but for {}", self.said()),
        }
    }
}

/// Joins the names of slips (known mistakes) that are made together by `and`; empty for none. A
/// slip without a name is called by its wrong line in Rust.
pub fn mistake_name(mistake: &[&'static Slip]) -> String {
    let name = |slip: &&'static Slip| match slip.name {
        "" => {
            let chapter = slip.chapters().next().unwrap_or(Chapter::HittableList);
            slip.lines_in(Languages::Rust, chapter).swap_remove(0).wrong
        }
        name => name.into(),
    };
    let names: Vec<_> = mistake.iter().map(name).collect();
    names.join(" and ")
}

/// Makes a row, unless its text is empty.
pub(super) fn row(kind: RowKind, text: &str) -> Option<Row> {
    (!text.is_empty()).then(|| Row::new(kind, text))
}

/// Makes two rows: a wrong line, and what should be in its place.
pub(super) fn line_and_right(kind: RowKind, line: &str, right: &str) -> Vec<Row> {
    vec![Row::new(kind, line), Row::new(RowKind::ShouldBe, right)]
}

/// Makes a row of each line: the first is a [`Perhaps`](RowKind::Perhaps), each further one an
/// [`Or`](RowKind::Or).
pub(super) fn alternatives(lines: impl Iterator<Item = String>) -> impl Iterator<Item = Row> {
    let kinds = iter::once(RowKind::Perhaps).chain(iter::repeat(RowKind::Or));
    kinds.zip(lines).map(|(kind, line)| Row::new(kind, line))
}

impl CorrectedLine {
    /// Lists the reader's line and the right one.
    pub(super) fn rows(&self) -> Vec<Row> {
        let right = match &*self.right {
            "" => "left out",
            right => right,
        };
        line_and_right(RowKind::Yours, &self.line.to_string(), right)
    }
}

/// Lists the parts of a report on a broken law, a property that a function must have: the law, what
/// was found and what is allowed, known mistakes with the same answers if there are any, and where
/// the law is explained.
pub fn law_rows(report: &Report) -> Vec<Row> {
    let broken = &report.broken;
    let kinds = iter::once(RowKind::SameAs).chain(iter::repeat(RowKind::More));
    let same_as = kinds
        .zip(&report.same_as)
        .map(|(kind, it)| Row::new(kind, it));
    let rows = [
        (RowKind::Law, &*broken.law),
        (RowKind::Found, &broken.found),
        (RowKind::Allowed, &broken.allowed),
    ];
    let rows = rows.into_iter().map(|(kind, it)| Row::new(kind, it));
    rows.chain(same_as)
        .chain([Row::new(RowKind::Read, &*broken.read)])
        .collect()
}

/// Makes a row [`Printed`](RowKind::Printed) of each line that a compiler or a program has printed;
/// none for an empty text. Control characters, which a terminal would obey, are escaped.
pub fn printed_rows(text: &str) -> Vec<Row> {
    let lines = text.lines();
    lines
        .map(|line| Row::new(RowKind::Printed, names::escape_for_terminal(line)))
        .collect()
}
