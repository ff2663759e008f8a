//! Line breaking: text as wide as the terminal.

/// How wide text should be, in characters: as the terminal, but no wider than is easy to
/// read.
pub(crate) fn text_width() -> usize {
    let columns = terminal_size::terminal_size().map_or(80, |(width, _)| usize::from(width.0));
    columns.clamp(30, 96)
}

/// `text` in lines that are no wider than that, those after the first with this indent.
pub(crate) fn hanging(text: &str, indent: usize) -> String {
    let indent = " ".repeat(indent);
    let options = textwrap::Options::new(text_width()).subsequent_indent(&indent);
    textwrap::fill(text, options)
}
