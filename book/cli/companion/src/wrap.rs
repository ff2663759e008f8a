//! Line breaking: text as wide as the terminal, bold and colored if that can be.

use check::answer::Answer;
pub(crate) use check::text::filled;
use check::text::{self, Style};

use crate::terminal::Palette;

/// Returns how wide text should be, in characters: as the terminal, but no wider than is easy to
/// read.
pub(crate) fn text_width() -> usize {
    let columns = terminal_size::terminal_size().map_or(80, |(width, _)| usize::from(width.0));
    columns.clamp(30, 96)
}

/// Breaks `text` into lines that are no wider than that, those after the first with this indent.
pub(crate) fn wrap_hanging(text: &str, indent: usize) -> String {
    filled(text, text_width(), "", &" ".repeat(indent))
}

/// Returns the style of standard output: plain where there is no terminal, where it can't, and
/// where the reader does not want color.
pub(crate) fn style() -> Style {
    Style {
        is_colored: Palette::of_stdout().is_some(),
    }
}

/// Lays out an answer, a line each with its end.
pub(crate) fn lay_out(answer: &Answer) -> String {
    let lines = text::answer_lines(answer, style(), text_width(), text::MOST_LINES);
    lines.iter().map(|line| format!("{line}\n")).collect()
}
