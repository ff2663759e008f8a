//! What the book knows about a figure.

use glam::DVec2;

use crate::svg::Svg;
use crate::text::html;

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

    /// An empty drawing with the words of this figure, as wide as all are.
    pub(crate) fn sheet(&self, height: f64) -> Svg {
        let size = DVec2::new(400.0, height);
        Svg::new(self.name, self.title, self.description, size)
    }
}
