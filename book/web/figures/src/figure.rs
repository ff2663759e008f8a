//! What the book knows about a figure.

use crate::svg::Svg;

/// The words of a figure.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// The name in `{{figure NAME}}` of a page.
    pub name: &'static str,
    /// A few words, read aloud where the drawing cannot be seen.
    pub title: &'static str,
    /// A description in sentences, for a reader who cannot see the drawing.
    pub description: &'static str,
    /// The words below it on the page; `*t*` is a number, `**P**` a vector.
    pub caption: &'static str,
    /// A question to the reader; `*t*` is a number, `**P**` a vector.
    pub question: &'static str,
    /// The answer to it: closed on the page, until it is asked for.
    pub solution: &'static str,
}

impl Figure {
    /// Returns an empty drawing with the words of this figure.
    pub(crate) fn sheet(&self, height: f64) -> Svg {
        Svg::new(self.name, self.title, self.description, height)
    }
}
