//! What the book knows about a figure.

use crate::svg::Svg;
use crate::text::html;

/// A figure: words, and a function that draws it.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// How pages name it: `{{figure NAME}}`.
    pub name: &'static str,
    /// A few words, read aloud where the drawing cannot be seen.
    pub title: &'static str,
    /// What is to be seen, in sentences, for a reader who cannot see it.
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
    pub(crate) fn sheet(&self, height: f64) -> Svg {
        Svg::new(self.name, self.title, self.description, height)
    }
}
