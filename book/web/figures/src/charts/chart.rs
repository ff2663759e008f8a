//! A chart: its words, its files, and the function that draws it.

use std::fs;
use std::path::Path;

use crate::svg::Svg;

/// A chart: words, the files that it is drawn from, and a function that does it.
#[derive(Clone, Copy, Debug)]
pub struct Chart {
    /// The name in `{{chart NAME}}` of a page.
    pub name: &'static str,
    /// A few words, read aloud where the chart cannot be seen.
    pub title: &'static str,
    /// A description in sentences, for a reader who cannot see the chart.
    pub description: &'static str,
    /// The words below it on the page.
    pub caption: &'static str,
    /// The names of its panels, if a reader sees one at a time and chooses which.
    pub choices: &'static [&'static str],
    /// Its files, as paths from the folder `book/notes`.
    pub files: &'static [&'static str],
    /// Draws it from the text of these files, in this order.
    ///
    /// # Errors
    /// A message that names the file and the line that is wrong.
    pub draw: fn(&[&str]) -> Result<DrawnChart, String>,
}

/// A chart that was drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnChart {
    /// An `<svg>` element in one line for each panel.
    pub panels: Vec<String>,
    /// Its numbers as a table in Markdown.
    pub table: String,
}

impl Chart {
    /// Draws it from its files in the folder `notes`.
    ///
    /// # Errors
    /// A file that cannot be read, or what is wrong in which line of it.
    pub fn draw_from(&self, notes: &Path) -> Result<DrawnChart, String> {
        let read = |file: &&str| {
            let path = notes.join(file);
            fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))
        };
        let texts: Vec<String> = self.files.iter().map(read).collect::<Result<_, _>>()?;
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        (self.draw)(&texts)
    }

    /// Returns an empty drawing with the words of this chart.
    pub(super) fn sheet(&self, height: f64) -> Svg {
        Svg::new(self.name, self.title, self.description, height)
    }

    /// Returns an empty drawing for the panel number `place`, which `shows` this.
    pub(super) fn panel(&self, place: usize, shows: &str, height: f64) -> Svg {
        let name = format!("{}_{place}", self.name);
        let title = format!("{}: {shows}", self.title);
        Svg::new(&name, &title, self.description, height)
    }
}

/// Writes a table in Markdown, whose first columns, `names` of them, are words,
/// and the others numbers.
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
