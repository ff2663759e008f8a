//! Every sentence that a reader gets, in the order in which it is read: the verdicts, the
//! explanations, and the advice on what to do next.

mod advice;
mod explanations;
mod verdicts;

use std::iter;

use slips::{Chapter, Languages, Slip, steps};

use crate::answer::{Row, RowKind};
use crate::candidate::Unexplained;
use crate::task::Task;

pub(crate) use explanations::ONLY_SKY;
pub use explanations::{law_rows, printed_rows};
pub use verdicts::{broken_so_far, not_compiled, not_written, refused};

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
fn named(task: &Task) -> String {
    let step = task
        .step()
        .map_or(String::new(), |step| format!("step {} of ", step + 1));
    let probe = task
        .probe
        .map_or(String::new(), |it| format!(" with the probe {}", it.name));
    format!("{step}{}{probe}", task.chapter.name())
}

/// Names the step at an index from 0, and how many there are: `Step 1 of 3`.
fn step_of(chapter: Chapter, step: usize) -> String {
    format!("Step {} of {}", step + 1, steps::of_chapter(chapter).len())
}

/// Says by which version of the book a task is drawn: ` by version 3 of the book`. Returns an empty
/// text for version 4, which the chapters follow.
pub(crate) fn by(task: &Task) -> String {
    match task.is_by_version_3() {
        true => format!(" {}", slips::version_3().right),
        false => String::new(),
    }
}

/// Counts differing pixels: `1 of 90 pixels differs`.
fn differ(count: usize, total: usize) -> String {
    let differ = if count == 1 { "differs" } else { "differ" };
    format!("{count} of {total} pixels {differ}")
}

/// Names a range of columns or rows: `row 3`, `rows 3 to 7`.
fn span(name: &str, [first, last]: [u32; 2]) -> String {
    match first == last {
        true => format!("{name} {first}"),
        false => format!("{name}s {first} to {last}"),
    }
}

impl Unexplained {
    /// Says how many of so many `pixels` are off, and where.
    fn said(&self, pixels: usize) -> String {
        let off = self.off;
        if self.is_rounding() {
            return format!(
                "a difference of one level in {off} of {pixels} pixels, as single precision or another way of rounding makes it"
            );
        }
        let (columns, rows) = (span("column", self.columns), span("row", self.rows));
        format!("{off} of {pixels} pixels, in {columns}, {rows}")
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
fn row(kind: RowKind, text: &str) -> Option<Row> {
    (!text.is_empty()).then(|| Row::new(kind, text))
}

/// Makes two rows: a wrong line, and what should be in its place.
fn line_and_right(kind: RowKind, line: &str, right: &str) -> Vec<Row> {
    vec![Row::new(kind, line), Row::new(RowKind::ShouldBe, right)]
}

/// Makes a row of each line: the first is a [`Perhaps`](RowKind::Perhaps), each further one an
/// [`Or`](RowKind::Or).
fn alternatives(lines: impl Iterator<Item = String>) -> impl Iterator<Item = Row> {
    let kinds = iter::once(RowKind::Perhaps).chain(iter::repeat(RowKind::Or));
    kinds.zip(lines).map(|(kind, line)| Row::new(kind, line))
}
