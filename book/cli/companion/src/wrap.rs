//! Line breaking: text as wide as the terminal.

use textwrap::{Options, WordSplitter};

/// Returns how wide text should be, in characters: as the terminal, but no wider than is easy to
/// read.
pub(crate) fn text_width() -> usize {
    let columns = terminal_size::terminal_size().map_or(80, |(width, _)| usize::from(width.0));
    columns.clamp(30, 96)
}

/// Breaks `text` into lines that are no wider than that, those after the first with this indent.
pub(crate) fn hanging(text: &str, indent: usize) -> String {
    filled(text, text_width(), "", &" ".repeat(indent))
}

/// Breaks `text` into lines of this width, but for a word that is longer, with `first` before the
/// first of them, and `rest` before the others.
pub(crate) fn filled(text: &str, width: usize, first: &str, rest: &str) -> String {
    let options = Options::new(width)
        .initial_indent(first)
        .subsequent_indent(rest)
        .break_words(false)
        .word_splitter(WordSplitter::NoHyphenation);
    // A size stays on one line.
    let text = text.replace(" × ", "\u{a0}×\u{a0}");
    textwrap::fill(&text, options).replace('\u{a0}', " ")
}
