//! Line breaking: text as wide as the terminal, bold and colored if the terminal can show that.

use check::answer::Answer;
pub(crate) use check::text::filled;
use check::text::{self, Style};

pub(crate) use crate::terminal::text_width;

use crate::terminal::Palette;

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
