//! Text: the result for people, in the terminal.

use std::path::Path;

use check::answer::{Headline, Judged, Part};
use check::blind_spots::Next;
use check::names::{self, companion};
use check::{Row, workspace};
use slips::{Letters, Slip};

use crate::terminal::Palette;
use crate::wrap::filled;

/// Bold and color, or neither.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    colored: bool,
}

impl Style {
    /// Plain where there is no terminal, where it can't, and where the reader
    /// does not want it.
    pub(crate) fn of_stdout() -> Self {
        Self {
            colored: Palette::of_stdout().is_some(),
        }
    }

    /// Neither bold nor color.
    pub(crate) fn plain() -> Self {
        Self { colored: false }
    }

    pub(crate) fn bold(self, text: &str) -> String {
        self.wrapped("1", text)
    }

    pub(crate) fn dim(self, text: &str) -> String {
        self.wrapped("2", text)
    }

    fn red(self, text: &str) -> String {
        self.wrapped("31", text)
    }

    pub(crate) fn green(self, text: &str) -> String {
        self.wrapped("32", text)
    }

    fn wrapped(self, code: &str, text: &str) -> String {
        if self.colored {
            format!("\x1b[{code}m{text}\x1b[0m")
        } else {
            text.to_owned()
        }
    }
}

/// The whole result.
pub(crate) fn text(judged: &Judged, report: Option<&Path>, style: Style) -> String {
    let parts = judged.parts();
    let letters = judged.known.letters;
    let parts = parts.iter().map(|part| part_as_text(part, letters, style));
    let parts: String = parts.collect();
    let report = report.map(|page| format!("\nThe page is {}\n", names::spelled(page)));
    headline(&judged.headline(), style) + &parts + &report.unwrap_or_default()
}

/// Right, wrong, or why it is no picture.
pub(crate) fn headline(said: &Headline, style: Style) -> String {
    let verdict = if said.is_right {
        style.green(said.verdict)
    } else {
        style.red(said.verdict)
    };
    let first = wrapped(&format!("{}{verdict}{}", said.before, said.after), "", "");
    let notes = said.notes.iter().flat_map(|note| note.lines());
    let notes: String = notes.map(|note| wrapped(note, "", "  ")).collect();
    first + &notes
}

fn part_as_text(part: &Part, letters: Option<Letters>, style: Style) -> String {
    match part {
        Part::Title(said) => format!("\n{}\n", style.bold(wrapped(said, "", "").trim_end())),
        Part::Name(name) => format!("  {}\n", style.bold(name)),
        Part::Rows(rows) => rows.iter().map(|it| row(it, style)).collect(),
        Part::Read(slip) => look(slip, letters).map(|it| row(&it, style)).collect(),
        Part::Next(next) => probe(next),
    }
}

/// A label, and what it is about in as many lines as that takes.
fn row((label, said): &Row, style: Style) -> String {
    let shown = format!("    {} ", style.dim(&format!("{label:<9}")));
    // A path stays on one line.
    if ["code", "read"].contains(label) {
        return format!("{shown}{said}\n");
    }
    wrapped(said, &shown, &" ".repeat(14))
}

fn probe(next: &Next) -> String {
    let chapter = next.scene.chapter.name();
    let how = match next.scene.probe {
        Some(_) => format!(". What to change: {} probes {chapter}", companion()),
        None => ".".to_owned(),
    };
    format!("\n{}{how}\n", next.why())
}

/// How wide the answer is, whatever the terminal.
const WIDTH: usize = 100;

/// The text, with this before its first line and that before the others.
fn wrapped(text: &str, first: &str, rest: &str) -> String {
    filled(text, WIDTH, first, rest) + "\n"
}

/// The page that has it right, and the file for those who read its language.
fn look(slip: &Slip, letters: Option<Letters>) -> impl Iterator<Item = Row> {
    let is_rust = letters == Some(Letters::Rust);
    let code = workspace::source(slip).filter(|_| is_rust);
    let code = code.map(|file| ("code", file));
    [("read", read(slip))].into_iter().chain(code)
}

/// A page that can be opened, or else what to look for in the book.
fn read(slip: &Slip) -> String {
    workspace::page(slip).unwrap_or_else(|| match workspace::workspace() {
        Some(_) => format!("{}: {} book weaves it", slip.page_in_words(), companion()),
        None => slip.page_in_words(),
    })
}
