//! The style sheet that all drawings share.

/// The style sheet of all drawings, which the pages load: for each idea a color in light and in
/// dark, and a class for each way to draw.
pub const CSS: &str = include_str!("../../../theme/figures.css");

/// Makes the text of a complete SVG file of `svg`, an element that
/// [`Svg::finish`](crate::Svg::finish) returned: with the style sheet, a background, and colors
/// that follow the reader's preference for light or dark.
pub fn standalone(svg: &str) -> String {
    let style = format!(
        "<style>:root {{ color-scheme: light dark }}\n{CSS}</style>\
         <rect class=\"paper\" width=\"100%\" height=\"100%\"/>"
    );
    svg.replacen("</desc>", &format!("</desc>{style}"), 1) + "\n"
}
