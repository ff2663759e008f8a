//! The words of a figure, which stand in a text beside its code: `walk.md` beside `walk.rs`.

use crate::svg::Svg;

/// The words of a figure.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The name in `{{figure NAME}}` of a page.
    pub name: &'static str,
    /// A few words, read aloud where the drawing cannot be seen.
    pub title: String,
    /// A description in sentences, for a reader who cannot see the drawing.
    pub description: String,
    /// The words below it on the page; `*t*` is a number, `**P**` a vector.
    pub caption: String,
    /// A question to the reader; `*t*` is a number, `**P**` a vector.
    pub question: String,
    /// The answer to it: closed on the page, until it is asked for.
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

    /// Returns an empty drawing with the words of this figure.
    pub(crate) fn sheet(&self, height: f64) -> Svg {
        Svg::new(self.name, &self.title, &self.description, height)
    }
}

/// Reads the words of a figure, once, from the text beside its code.
macro_rules! figure {
    ($name:literal) => {
        std::sync::LazyLock::new(|| {
            crate::figure::Figure::read($name, include_str!(concat!($name, ".md")))
        })
    };
}
pub(crate) use figure;
