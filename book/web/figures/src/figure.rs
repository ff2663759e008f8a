//! The words of a figure, read from a Markdown text beside its code: `walk.md` beside `walk.rs`.

use crate::svg::Svg;

/// The words of a figure, each a plain text in one line; in the caption, question and solution
/// `*t*` marks a number, `**P**` a vector.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The name of the figure in `{{figure NAME}}` on a page.
    pub name: &'static str,
    /// A title of a few words, read aloud to a reader who cannot see the drawing.
    pub title: String,
    /// A description in sentences, for a reader who cannot see the drawing.
    pub description: String,
    /// The caption below the figure, in which `*t*` marks a number and `**P**` a vector.
    pub caption: String,
    /// A question to the reader about the figure, and then what to do with it.
    pub question: String,
    /// The answer to `question`, which the page shows when the reader asks for it.
    pub solution: String,
}

impl Figure {
    /// Reads the words of the figure `name` from `text`: five paragraphs, in the order of the
    /// fields, the title behind `# `.
    ///
    /// # Panics
    /// If there are fewer paragraphs.
    pub(crate) fn read(name: &'static str, text: &str) -> Self {
        let mut paragraphs = text.trim_start_matches("# ").trim_end().split("\n\n");
        let mut next = || {
            let paragraph = paragraphs.next().expect("five paragraphs");
            paragraph.replace('\n', " ")
        };
        Self {
            name,
            title: next(),
            description: next(),
            caption: next(),
            question: next(),
            solution: next(),
        }
    }

    /// Returns an empty drawing with the title and description of the figure, 400 by `height`
    /// units.
    pub(crate) fn sheet(&self, height: f64) -> Svg {
        Svg::new(self.name, &self.title, &self.description, height)
    }
}

/// Reads the words of a figure from the text beside its code, when they are first needed.
macro_rules! figure {
    ($name:literal) => {
        std::sync::LazyLock::new(|| {
            crate::figure::Figure::read($name, include_str!(concat!($name, ".md")))
        })
    };
}
pub(crate) use figure;
