//! What the book knows about a chart.

use std::fs;
use std::path::Path;

use glam::DVec2;

use crate::svg::Svg;

/// A chart: words, the files that it is drawn from, and a function that does it.
#[derive(Clone, Copy, Debug)]
pub struct Chart {
    /// How pages name it: `{{chart NAME}}`.
    pub name: &'static str,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// What is to be seen, in sentences, for whoever cannot see it.
    pub description: &'static str,
    /// What stands below it on the page.
    pub caption: &'static str,
    /// Its files, as paths from the folder `book/notes`.
    pub files: &'static [&'static str],
    /// Draws it from the text of these files, in this order.
    ///
    /// # Errors
    /// What is wrong in which line of which file.
    pub draw: fn(&[&str]) -> Result<Drawn, String>,
}

/// A chart that was drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// An `<svg>` element in one line.
    pub svg: String,
    /// The same numbers as a table in Markdown.
    pub table: String,
}

impl Chart {
    /// Draws it from its files in the folder `notes`.
    ///
    /// # Errors
    /// A file that cannot be read, or what is wrong in which line of it.
    pub fn draw_from(&self, notes: &Path) -> Result<Drawn, String> {
        let texts: Vec<String> = self
            .files
            .iter()
            .map(|file| {
                let path = notes.join(file);
                fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))
            })
            .collect::<Result<_, _>>()?;
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        (self.draw)(&texts)
    }

    /// An empty drawing with the words of this chart. Pages let it scroll where
    /// they are too narrow for it.
    pub(super) fn sheet(&self, height: f64) -> Svg {
        let size = DVec2::new(WIDTH, height);
        Svg::wide(self.name, self.title, self.description, size)
    }
}

/// The width of every chart.
pub(super) const WIDTH: f64 = 720.0;
