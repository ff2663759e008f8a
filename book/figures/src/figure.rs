//! What the book knows about a figure.

use glam::DVec2;

use crate::svg::{Style, Svg, escape, styled};

/// A figure: words, and a function that draws it.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// How pages name it: `{{figure NAME}}`.
    pub name: &'static str,
    /// A few words, read aloud where the drawing cannot be seen.
    pub title: &'static str,
    /// What is to be seen, in sentences, for whoever cannot see it.
    pub description: &'static str,
    /// What stands below it on the page; `*t*` is a number, `**P**` a vector.
    pub caption: &'static str,
    /// Draws it as an `<svg>` element in one line, which a page can take in.
    pub draw: fn() -> String,
}

impl Figure {
    /// The caption as HTML.
    pub fn caption(&self) -> String {
        html(self.caption)
    }

    /// An empty drawing with the words of this figure.
    pub(crate) fn sheet(&self, width: f64, height: f64) -> Svg {
        let size = DVec2::new(width, height);
        Svg::new("drawing", self.name, self.title, self.description, size)
    }
}

/// A text in HTML; in it `*t*` is a number, `**P**` a vector.
pub fn html(text: &str) -> String {
    let html = |(text, style)| match (escape(text), style) {
        (text, Style::Plain) => text,
        (text, Style::Italic) => format!("<i>{text}</i>"),
        (text, Style::Vector) => format!("<b>{text}</b>"),
    };
    styled(text).map(html).collect()
}
