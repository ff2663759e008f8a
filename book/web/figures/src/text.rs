//! The text of labels: `*t*` is a number, `**P**` a vector, and `_{0}` a subscript.

/// The size of a label, in units of the viewBox.
pub(crate) const TEXT: f64 = 14.0;

/// The size of a less important label.
pub(crate) const SMALL: f64 = 12.0;

/// The size of a subscript.
const SUBSCRIPT: f64 = 11.0;

/// Returns the text without its marks.
pub(crate) fn plain(text: &str) -> String {
    text.replace('*', "")
}

/// Writes the text in HTML.
pub fn html(text: &str) -> String {
    marked(text, ["<i>", "</i>"], ["<b>", "</b>"])
}

/// Writes the text in SVG.
pub(crate) fn spans(label: &str) -> String {
    let mut spans = String::new();
    for (n, piece) in label.split(['{', '}']).enumerate() {
        let [italic, vector] = ["italic", "vector"].map(|it| format!("<tspan class=\"{it}\">"));
        let piece = piece.trim_end_matches('_');
        let piece = marked(piece, [&italic, "</tspan>"], [&vector, "</tspan>"]);
        spans += &match n {
            _ if n == 0 || piece.is_empty() => piece,
            _ if n % 2 == 0 => format!("<tspan dy=\"-4\">{piece}</tspan>"),
            _ => format!("<tspan dy=\"4\" font-size=\"{SUBSCRIPT}\">{piece}</tspan>"),
        };
    }
    spans
}

/// Puts these tags around each number, and around each vector.
fn marked(text: &str, number: [&str; 2], vector: [&str; 2]) -> String {
    let within = |text: String, n: usize, [open, close]: [&str; 2]| match n % 2 {
        0 => text,
        _ => format!("{open}{text}{close}"),
    };
    let numbers = |text: &str| -> String {
        let pieces = text.split('*').enumerate();
        pieces
            .map(|(n, piece)| within(escape(piece), n, number))
            .collect()
    };
    let pieces = text.split("**").enumerate();
    pieces
        .map(|(n, piece)| within(numbers(piece), n, vector))
        .collect()
}

/// Returns how wide a label is at most, in the usual fonts.
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

/// Writes text that means itself in XML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
