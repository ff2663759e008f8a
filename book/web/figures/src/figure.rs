//! What the book knows about a figure.

use crate::svg::Svg;

/// The words of a figure.
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
    /// What a reader is to find out; `*t*` is a number, `**P**` a vector.
    pub question: &'static str,
    /// What a reader finds out: closed on the page, until it is asked for.
    pub solution: &'static str,
}

impl Figure {
    /// An empty drawing with the words of this figure.
    pub(crate) fn sheet(&self, height: f64) -> Svg {
        Svg::new(self.name, self.title, self.description, height)
    }
}
