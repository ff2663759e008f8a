//! A chart: its words, its files, and the function that draws it.

use std::fs;
use std::path::Path;

use crate::svg::Svg;

/// A chart of the book: its words, the files with its numbers, and the function that draws it.
#[derive(Clone, Copy, Debug)]
pub struct Chart {
    /// The name of the chart in `{{chart NAME}}` on a page.
    pub name: &'static str,
    /// A title of a few words as plain text, read aloud to a reader who cannot see the chart.
    pub title: &'static str,
    /// A description in sentences as plain text, for a reader who cannot see the chart.
    pub description: &'static str,
    /// The caption below the chart on the page, as HTML.
    pub caption: &'static str,
    /// The names of the chart's panels, in the order of [`DrawnChart::panels`], from which a reader
    /// chooses one to see; empty if the page shows all panels at once.
    pub choices: &'static [&'static str],
    /// The CSV files that hold the chart's numbers, as paths from the folder `book/notes`; at least
    /// one.
    pub files: &'static [&'static str],
    /// Draws the chart from the texts of `files`, one for each and in their order.
    ///
    /// # Errors
    /// A message that names the file and the line that is wrong.
    pub draw: fn(&[&str]) -> Result<DrawnChart, String>,
}

/// A chart as drawn from its files: SVG elements, and the same numbers as a Markdown table.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnChart {
    /// The panels, each an `<svg>` element in one line.
    pub panels: Vec<String>,
    /// The chart's numbers as a table in Markdown.
    pub table: String,
}

impl Chart {
    /// Draws the chart from its files in the folder `notes`, the path of `book/notes`.
    ///
    /// # Errors
    /// A message that names the file that cannot be read, or the file and the line that is wrong.
    pub fn draw_from(&self, notes: &Path) -> Result<DrawnChart, String> {
        let read = |file: &&str| {
            let path = notes.join(file);
            fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))
        };
        let texts: Vec<String> = self.files.iter().map(read).collect::<Result<_, _>>()?;
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        (self.draw)(&texts)
    }

    /// Returns an empty drawing, 400 by `height` units, for the panel with the number `place`, whose
    /// title ends with `shows`.
    pub(super) fn panel(&self, place: usize, shows: &str, height: f64) -> Svg {
        let name = format!("{}_{place}", self.name);
        let title = format!("{}: {shows}", self.title);
        Svg::new(&name, &title, self.description, height)
    }
}

/// Writes a table in Markdown: the first `names` columns hold words, to the left, and all others
/// numbers, to the right.
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
