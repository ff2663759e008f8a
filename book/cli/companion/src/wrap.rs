//! Line breaking: text as wide as the terminal, bold and colored if the terminal can show that.

use check::answer::Answer;
pub(crate) use check::text::filled;
use check::text::{self, Style};

use crate::terminal::{self, Palette};

/// Returns the width of text in characters: as wide as the terminal, but at least 30 and at most
/// 96.
pub(crate) fn text_width() -> usize {
    let columns = terminal::size().map_or(80, |(columns, _)| columns);
    columns.clamp(30, 96) as usize
}

/// Breaks `text` into lines of at most [`text_width`] characters, and indents those after the first
/// by `indent` blanks.
pub(crate) fn wrap_hanging(text: &str, indent: usize) -> String {
    filled(text, text_width(), "", &" ".repeat(indent))
}

/// Returns the style for standard output: plain unless it is a terminal with colors and the reader
/// wants them.
pub(crate) fn style() -> Style {
    Style {
        is_colored: Palette::of_stdout().is_some(),
    }
}

/// Writes an answer as at most `most` lines for the terminal, each with a line break at its end.
pub(crate) fn lay_out(answer: &Answer, most: usize) -> String {
    let lines = text::answer_lines(answer, style(), text_width(), most);
    lines.iter().map(|line| format!("{line}\n")).collect()
}
