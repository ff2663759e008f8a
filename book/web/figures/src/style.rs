//! One visual language for all drawings.

/// The style sheet of all drawings, which pages load: a color for each idea,
/// for light and for dark, and a class for each way to show it.
pub const CSS: &str = include_str!("../../../theme/figures.css");

/// Makes a file of its own of the drawing `svg`: it brings the style sheet and
/// the paper, and follows the reader's light or dark preference.
pub fn standalone(svg: &str) -> String {
    let style = format!(
        "<style>:root {{ color-scheme: light dark }}\n{CSS}</style>\
         <rect class=\"paper\" width=\"100%\" height=\"100%\"/>"
    );
    svg.replacen("</desc>", &format!("</desc>{style}"), 1) + "\n"
}
