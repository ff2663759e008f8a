//! A chart: its words, its files, and the function that draws it.

use std::fs;
use std::path::Path;

use crate::svg::Svg;

/// A chart: words, the files that it is drawn from, and a function that does it.
#[derive(Clone, Copy, Debug)]
pub struct Chart {
    /// How pages name it: `{{chart NAME}}`.
    pub name: &'static str,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// What is to be seen, in sentences, for a reader who cannot see it.
    pub description: &'static str,
    /// What stands below it on the page.
    pub caption: &'static str,
    /// The names of its panels, if a reader sees one at a time and chooses which.
    pub choices: &'static [&'static str],
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
    /// An `<svg>` element in one line for each panel.
    pub panels: Vec<String>,
    /// The same numbers as a table in Markdown.
    pub table: String,
}

impl Chart {
    /// Draws it from its files in the folder `notes`.
    ///
    /// # Errors
    /// A file that cannot be read, or what is wrong in which line of it.
    pub fn draw_from(&self, notes: &Path) -> Result<Drawn, String> {
        let read = |file: &&str| {
            let path = notes.join(file);
            fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))
        };
        let texts: Vec<String> = self.files.iter().map(read).collect::<Result<_, _>>()?;
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        (self.draw)(&texts)
    }

    /// An empty drawing with the words of this chart.
    pub(super) fn sheet(&self, height: f64) -> Svg {
        Svg::new(self.name, self.title, self.description, height)
    }

    /// An empty drawing for a panel of several, with what it shows.
    pub(super) fn panel(&self, place: usize, shows: &str, height: f64) -> Svg {
        let name = format!("{}_{place}", self.name);
        let title = format!("{}: {shows}", self.title);
        Svg::new(&name, &title, self.description, height)
    }
}

/// A table in Markdown: names in the first columns, so many, and then numbers.
pub(super) fn table(
    names: usize,
    heads: &[String],
    rows: impl Iterator<Item = Vec<String>>,
) -> String {
    let line = |cells: &[String]| {
        let cells = cells.iter().map(|cell| format!(" {cell} |"));
        format!("|{}\n", cells.collect::<String>().replace("  |", " |"))
    };
    let rule = format!(
        "|{}{}\n",
        "---|".repeat(names),
        "---:|".repeat(heads.len() - names)
    );
    let rows = rows.map(|row| line(&row));
    line(heads) + &rule + &rows.collect::<String>()
}
