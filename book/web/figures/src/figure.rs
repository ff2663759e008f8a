//! The words of a figure, read from a Markdown text beside its code: `walk.md` beside `walk.rs`.

use crate::svg::Svg;

/// The words of a figure, each a plain text in one line; in the caption and the questions `*t*` marks
/// a number, `**P**` a vector.
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
    /// The questions to the reader: at least one, and one more for each further page that shows the
    /// figure.
    pub questions: Vec<Question>,
}

/// A question about a figure, in the same notation.
#[derive(Clone, Debug)]
pub struct Question {
    /// The question, and then what to do with the figure.
    pub question: String,
    /// Its answer, which the page shows when the reader asks for it.
    pub solution: String,
}

impl Figure {
    /// Reads the words of the figure `name` from `text`: paragraphs in the order of the fields, the
    /// title behind `# `, and two for each question.
    ///
    /// # Panics
    /// If there are fewer than five paragraphs, or a question has no answer.
    pub(crate) fn read(name: &'static str, text: &str) -> Self {
        let paragraphs = text.trim_start_matches("# ").trim_end().split("\n\n");
        let paragraphs: Vec<String> = paragraphs.map(|it| it.replace('\n', " ")).collect();
        let [title, description, caption, questions @ ..] = &paragraphs[..] else {
            panic!("{name} has too few paragraphs");
        };
        let question = |pair: &[String]| Question {
            question: pair[0].clone(),
            solution: pair[1].clone(),
        };
        Self {
            name,
            title: title.clone(),
            description: description.clone(),
            caption: caption.clone(),
            questions: questions.chunks(2).map(question).collect(),
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
