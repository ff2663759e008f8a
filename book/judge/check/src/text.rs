//! The layout of an answer in a terminal: labeled lines of a given width, colored or not.

use textwrap::{Options, WordSplitter};

use crate::answer::{Answer, Grade, Headline, Row, RowKind};
use crate::names;
use crate::workspace;

/// The style of texts in a terminal: with bold and color, or plain.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// True if the terminal obeys the codes for bold and color.
    pub is_colored: bool,
}

/// The most lines of an answer, so that it is read at one glance.
pub const MOST_LINES: usize = 16;

/// Lays out an answer in at most `most` lines of `width` characters for a terminal: the headline,
/// as many rows as there is room for, the pages to read, and what to do next. A `…` stands for rows
/// that are left out. The headline, the pages and the advice are never cut, even if they need more
/// lines.
pub fn answer_lines(answer: &Answer, style: Style, width: usize, most: usize) -> Vec<String> {
    let mut lines = headline(&answer.headline, style, width);
    let read = answer.read.iter().map(|slip| {
        let page = workspace::page(slip);
        style.labeled("read") + &page.unwrap_or_else(|| slip.page_in_words())
    });
    let next = match &*answer.next {
        "" => Vec::new(),
        next => labeled("next", next, style, width),
    };
    let below: Vec<String> = read.chain(next).collect();
    let room = most.saturating_sub(height(&lines, width) + height(&below, width));
    let rows: Vec<_> = answer.rows.iter().map(|it| row(it, style, width)).collect();
    lines.extend(fitting(rows, width, room));
    lines.extend(below);
    lines
}

/// Lays out a headline in lines of `width` characters, with its verdict in the color of its grade.
pub fn headline(headline: &Headline, style: Style, width: usize) -> Vec<String> {
    let [before, verdict, rest] = headline.parts();
    let verdict = match headline.grade {
        Grade::Right => style.green(&verdict),
        Grade::OnTheWay => style.bold(&verdict),
        Grade::Wrong | Grade::NoPicture => style.red(&verdict),
    };
    let [before, rest] = [before, rest].map(|it| names::escape_for_terminal(&it).into_owned());
    let said = filled(&format!("{before}{verdict}{rest}"), width, "", "");
    said.lines().map(str::to_owned).collect()
}

/// Wraps a text into lines of at most `width` characters, the prefixes included: `first` before the
/// first line and `rest` before the others. A longer word is not broken.
pub fn filled(text: &str, width: usize, first: &str, rest: &str) -> String {
    let options = Options::new(width)
        .initial_indent(first)
        .subsequent_indent(rest)
        .break_words(false)
        .word_splitter(WordSplitter::NoHyphenation);
    // A size stays on one line.
    let text = text.replace(" × ", "\u{a0}×\u{a0}");
    textwrap::fill(&text, options).replace('\u{a0}', " ")
}

/// Keeps the first rows for which there is room, in lines of a terminal, with a `…` if some are
/// left out.
fn fitting(rows: Vec<Vec<String>>, width: usize, room: usize) -> Vec<String> {
    if rows.iter().map(|row| height(row, width)).sum::<usize>() <= room {
        return rows.concat();
    }
    let mut left = room.saturating_sub(1);
    let has_room = |row: &Vec<String>| {
        let fits = height(row, width) <= left;
        left -= if fits { height(row, width) } else { left };
        fits
    };
    let mut lines: Vec<String> = rows.into_iter().take_while(has_room).flatten().collect();
    lines.push("…".to_owned());
    lines
}

/// Counts the lines of a terminal of this `width` that these lines fill.
fn height(lines: &[String], width: usize) -> usize {
    let rows = |line: &String| textwrap::core::display_width(line).div_ceil(width).max(1);
    lines.iter().map(rows).sum()
}

/// Lays out a row in lines of this `width`.
fn row(row: &Row, style: Style, width: usize) -> Vec<String> {
    match row.kind {
        RowKind::Printed => vec![row.text.clone()],
        kind => {
            let text = names::escape_for_terminal(&row.text);
            labeled(kind.label(), &text, style, width)
        }
    }
}

/// Wraps a text into lines of this `width`, with the label before the first.
fn labeled(label: &str, text: &str, style: Style, width: usize) -> Vec<String> {
    let rest = " ".repeat(LABEL + 2);
    let said = filled(text, width, &style.labeled(label), &rest);
    said.lines().map(str::to_owned).collect()
}

/// The width of a label, in characters.
const LABEL: usize = 9;

impl Style {
    /// Makes a text bold by a terminal's codes around it; returns it as it is in a plain style.
    pub fn bold(self, text: &str) -> String {
        self.in_code("1", text)
    }

    /// Makes a text pale by a terminal's codes around it; returns it as it is in a plain style.
    pub fn dim(self, text: &str) -> String {
        self.in_code("2", text)
    }

    /// Makes a text red.
    fn red(self, text: &str) -> String {
        self.in_code("31", text)
    }

    /// Makes a text green.
    fn green(self, text: &str) -> String {
        self.in_code("32", text)
    }

    /// Pads a label to its width.
    fn labeled(self, label: &str) -> String {
        self.dim(&format!("{label:<LABEL$}")) + "  "
    }

    /// Puts a text between a terminal's code and the one that ends it.
    fn in_code(self, code: &str, text: &str) -> String {
        match self.is_colored {
            true => format!("\x1b[{code}m{text}\x1b[0m"),
            false => text.to_owned(),
        }
    }
}
