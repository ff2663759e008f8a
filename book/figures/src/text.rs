//! The text of labels: `*t*` is a number, `**P**` a vector, and `_{0}` a subscript.

/// The size of a label, in units of the viewBox.
pub(crate) const TEXT: f64 = 14.0;

/// The size of a less important label.
pub(crate) const SMALL: f64 = 12.0;

/// The size of a subscript.
const SUBSCRIPT: f64 = 11.0;

/// How a letter of a formula looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Style {
    /// A word or a digit.
    Plain,
    /// A number, `*t*`.
    Italic,
    /// A vector, `**P**`.
    Vector,
}

/// The stretches of a text with `*` and `**`.
pub(crate) fn styled(text: &str) -> impl Iterator<Item = (&str, Style)> {
    let outer = [None, Some(Style::Vector)].into_iter().cycle();
    text.split("**").zip(outer).flat_map(|(part, vector)| {
        let inner = [Style::Plain, Style::Italic].into_iter().cycle();
        part.split('*')
            .zip(inner)
            .map(move |(text, style)| (text, vector.unwrap_or(style)))
            .filter(|(text, _)| !text.is_empty())
    })
}

/// The text without its marks.
pub(crate) fn plain(text: &str) -> String {
    styled(text).map(|(piece, _)| piece).collect()
}

/// The text in HTML.
pub fn html(text: &str) -> String {
    let html = |(text, style)| match (escape(text), style) {
        (text, Style::Plain) => text,
        (text, Style::Italic) => format!("<i>{text}</i>"),
        (text, Style::Vector) => format!("<b>{text}</b>"),
    };
    styled(text).map(html).collect()
}

/// The text in SVG.
pub(crate) fn spans(label: &str) -> String {
    let mut spans = String::new();
    let mut lowered = false;
    for (part, style) in styled(label) {
        for piece in part.split_inclusive('}') {
            let (level, low) = piece.split_once("_{").unwrap_or((piece, ""));
            for (text, low) in [(level, false), (low.trim_end_matches('}'), true)] {
                if !text.is_empty() {
                    spans += &span(text, style, lowered, low);
                    lowered = low;
                }
            }
        }
    }
    spans
}

/// A stretch of a label; `lowered` says whether the one before it stood low.
fn span(text: &str, style: Style, lowered: bool, low: bool) -> String {
    let mut attributes = String::new();
    attributes += match style {
        Style::Plain => "",
        Style::Italic => " class=\"italic\"",
        Style::Vector => " class=\"vector\"",
    };
    attributes += match (lowered, low) {
        (false, true) => " dy=\"4\"",
        (true, false) => " dy=\"-4\"",
        _ => "",
    };
    if low {
        attributes += &format!(" font-size=\"{SUBSCRIPT}\"");
    }
    let text = escape(text);
    if attributes.is_empty() {
        text
    } else {
        format!("<tspan{attributes}>{text}</tspan>")
    }
}

/// How wide a label is at most, in the usual fonts.
pub(crate) fn width(label: &str, size: f64) -> f64 {
    let advance = |letter: char| match letter {
        '*' => 0.0,
        'i' | 'j' | 'l' | ' ' | ',' | '.' | ':' => 0.36,
        'f' | 't' | 'r' | '(' | ')' | '-' => 0.44,
        'm' | 'w' | 'M' | 'W' | '−' | '<' | '>' | '=' | '%' | '÷' => 0.96,
        'A'..='Z' => 0.76,
        _ => 0.65,
    };
    size * label.chars().map(advance).sum::<f64>()
}

/// Text that means itself in XML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
