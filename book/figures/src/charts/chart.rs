//! A chart: its words, its files, and the function that draws it.

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
    /// The same for a page that is too narrow for that, as a phone is: a page has
    /// both, and the style sheet shows one of them.
    pub narrow: String,
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

    /// An empty drawing with the words of this chart.
    pub(super) fn sheet(&self, layout: Layout, height: f64) -> Svg {
        let size = DVec2::new(layout.width(), height);
        let (class, name) = match layout {
            Layout::Wide => ("drawing wide", self.name.to_owned()),
            Layout::Narrow => ("drawing narrow", format!("{}_narrow", self.name)),
        };
        Svg::new(class, &name, self.title, self.description, size)
    }
}

impl Drawn {
    /// What `draw` draws in both layouts, and the table.
    pub(super) fn new(table: String, draw: impl Fn(Layout) -> String) -> Self {
        Self {
            svg: draw(Layout::Wide),
            narrow: draw(Layout::Narrow),
            table,
        }
    }
}

/// How much room there is beside each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Layout {
    /// As on a page of a book.
    Wide,
    /// As on a phone: what is beside each other in a wide chart is below each other.
    Narrow,
}

impl Layout {
    /// The width of every chart.
    pub(super) fn width(self) -> f64 {
        self.choose(720.0, 340.0)
    }

    /// One of two values.
    pub(super) fn choose<T>(self, wide: T, narrow: T) -> T {
        match self {
            Layout::Wide => wide,
            Layout::Narrow => narrow,
        }
    }
}
