//! Text: the result for people, in the terminal.

use std::path::Path;

use check::answer::{Headline, Hidden, Judged, Part, Where};
use check::names::{self, companion};
use check::workspace;
use slips::Slip;

use crate::terminal::Palette;

/// Bold and color, or neither.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    colored: bool,
}

impl Style {
    /// Plain where nobody looks, where the terminal can't, and where the reader
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
    let parts: String = parts.iter().map(|part| told(part, style)).collect();
    let report = report.map(|page| format!("\nThe page is {}\n", names::spelled(page)));
    headline(&judged.headline(), style) + &parts + &report.unwrap_or_default()
}

/// Right, wrong, or why it is no picture.
pub(crate) fn headline(said: &Headline, style: Style) -> String {
    let verdict = match said.is_right {
        true => style.green(said.verdict),
        false => style.red(said.verdict),
    };
    let notes: String = said.notes.iter().map(|note| format!("{note}\n")).collect();
    format!("{}{verdict}{}\n{notes}", said.before, said.after)
}

fn told(part: &Part, style: Style) -> String {
    let row = |(label, said): &(&str, String)| {
        let label = style.dim(&format!("{label:<9}"));
        format!("    {label} {said}\n")
    };
    match part {
        Part::Hidden(hidden) => advice(hidden),
        Part::Where(it) => whereabouts(it, style),
        Part::Sentence(said) => format!("\n{said}\n"),
        Part::Title(said) => format!("\n{}\n", style.bold(said)),
        Part::Name(name) => format!("\n  {}\n", style.bold(name)),
        Part::Rows(rows) => rows.iter().map(row).collect(),
        Part::Read(slips) => slips
            .iter()
            .flat_map(|slip| look(slip))
            .map(|it| row(&it))
            .collect(),
    }
}

fn advice(hidden: &Hidden) -> String {
    let width = hidden.groups.iter().map(|(label, _)| label.len()).max();
    let width = width.unwrap_or_default();
    let group = |(label, names): &(String, String)| format!("  {label:<width$}  {names}\n");
    let groups: String = hidden.groups.iter().map(group).collect();
    let next = hidden.next.as_ref().map_or(String::new(), |next| {
        format!(
            "Next: {}; and then\n  {}\n",
            next.change,
            next.scene.command()
        )
    });
    format!("\n{}\n{groups}{next}", hidden.intro)
}

fn whereabouts(it: &Where, style: Style) -> String {
    let label = |label: &str| style.dim(&format!("{label:<7}"));
    let map: String = it
        .map
        .iter()
        .map(|line| format!("          {line}\n"))
        .collect();
    format!(
        "\n  {} {}\n{map}  {} {}\n",
        label("where"),
        it.whereabouts,
        label("first"),
        it.first
    )
}

/// The page and the file that have it right.
fn look(slip: &Slip) -> impl Iterator<Item = (&'static str, String)> {
    let code = workspace::source(slip).map(|file| ("code", file));
    [("read", read(slip))].into_iter().chain(code)
}

/// A page that can be opened, or else what to look for in the book.
fn read(slip: &Slip) -> String {
    workspace::page(slip).unwrap_or_else(|| match workspace::workspace() {
        Some(_) => format!("{}: {} book weaves it", slip.page_in_words(), companion()),
        None => slip.page_in_words(),
    })
}
