//! The explanation of a picture as rows: the reader's lines and the right ones, or else what is
//! seen; and the rows of a broken law, or of lines that were printed.

use std::iter;

use laws::Report;
use slips::Slip;

use super::{alternatives, line_and_right, mistake_name, row};
use crate::answer::{Row, RowKind};
use crate::candidate::Conversion;
use crate::context::Context;
use crate::names;
use crate::search::{DrawingMutants, Mutant, Repair};
use crate::sources::CorrectedLine;
use crate::verdict::{Finding, Mistakes};

/// How many mistakes that draw the same picture are named at most.
const NAMED: usize = 3;
/// How many warnings of a compiler are shown at most.
const WARNINGS: usize = 2;
/// An observation about a picture whose every ray misses.
pub(crate) const ONLY_SKY: &str = "There is only sky: no sphere is to be seen.";

impl Finding {
    /// Lists what explains the picture, the most important row first: the lines of a repair; or
    /// else, after up to two warnings of the compiler, mistakes or edits that draw the picture, or
    /// what is to be seen. Empty if the picture is right but for a few pixels.
    pub fn rows(&self, context: &Context) -> Vec<Row> {
        if let Some(repair) = &self.repair {
            return repair.rows();
        }
        if self.almost_right.is_some() {
            return Vec::new();
        }
        let warnings = context.warnings.iter().take(WARNINGS);
        let warnings = warnings.map(|it| Row::new(RowKind::Warned, it));
        warnings.chain(self.explained(context)).collect()
    }

    /// Lists the mistakes or edits that draw the picture, or else what is to be seen.
    fn explained(&self, context: &Context) -> Vec<Row> {
        // A hundred mistakes draw only sky: a picture alone tells none of them.
        let is_sky = self.shows_only_sky();
        match &self.mistakes {
            Some(it) if is_sky && (context.sources.is_empty() || !it.is_in_text) => {
                let many = "many more mistakes draw only sky: the picture can't tell them apart";
                let rows = iter::once(Row::new(RowKind::Seen, ONLY_SKY)).chain(it.perhaps(context));
                return rows.chain(row(RowKind::More, many)).collect();
            }
            Some(it) => return it.rows(context, self.total()),
            None if self.drawn.is_informative() => return self.drawn.rows(),
            None => {}
        }
        let seen = self
            .observations
            .iter()
            .map(|it| Row::new(RowKind::Seen, it));
        let seen = seen.chain(self.first_pixel.iter().cloned());
        let drawn = self.drawn.rows();
        let unknown =
            (drawn.is_empty() && self.observations.len() != 1).then(|| self.nothing_known(context));
        seen.chain(drawn).chain(unknown).collect()
    }

    /// Says that no known mistake was found.
    fn nothing_known(&self, context: &Context) -> Row {
        let said = match self.task.probe {
            Some(_) => {
                "no known mistake draws this picture and leaves the chapter's own right: is that one right?"
            }
            None if context.sources.is_empty() => "no known mistake draws this picture",
            None => "no known mistake that can be in your files draws this picture",
        };
        Row::new(RowKind::Tried, said)
    }
}

impl Mistakes {
    /// Lists the only mistake in full, or the first of several by their wrong lines, and how they
    /// were tried on a picture of so many `pixels`.
    fn rows(&self, context: &Context, pixels: usize) -> Vec<Row> {
        let rows = match &self.all[..] {
            [mistake] => self.in_full(mistake, context),
            _ => self.perhaps(context).collect(),
        };
        let tried = Row::new(RowKind::Tried, self.tried(pixels));
        rows.into_iter().chain([tried]).collect()
    }

    /// Lists the wrong line, the right line and the reason of each slip of a mistake, and below them
    /// the lines in Rust that stand for those in C++.
    fn in_full(&self, mistake: &[&'static Slip], context: &Context) -> Vec<Row> {
        let rows = mistake.iter().flat_map(|slip| {
            let said = &context.slip_lines(slip, &self.task)[0];
            let kind = match self.is_in_text {
                true => RowKind::Probably,
                false => RowKind::Perhaps,
            };
            let lines = match context.wrong_line(slip, &self.task) {
                Some(found) => found.rows(),
                None => line_and_right(kind, &said.wrong, &said.right),
            };
            lines.into_iter().chain(row(RowKind::Why, slip.why))
        });
        let in_rust = mistake.iter().flat_map(|slip| {
            let lines = context.slip_lines(slip, &self.task);
            let line = lines.into_iter().nth(1).unwrap_or_default();
            line_and_right(RowKind::InRust, &line.wrong, &line.right)
        });
        let rows = rows.chain(in_rust).filter(|it| !it.text.is_empty());
        rows.collect()
    }

    /// Lists the wrong lines of the first few mistakes, each in C++ and in Rust.
    fn perhaps(&self, context: &Context) -> impl Iterator<Item = Row> {
        let wrong = |mistake: &Vec<&'static Slip>, n: usize| {
            let lines = mistake.iter().map(|slip| {
                let mut lines = context.slip_lines(slip, &self.task);
                let n = n.min(lines.len() - 1);
                lines.swap_remove(n).wrong.into_owned()
            });
            lines.collect::<Vec<_>>().join("; ")
        };
        let first = |it: &Vec<&'static Slip>| format!("{}  ({})", wrong(it, 0), mistake_name(it));
        let all: Vec<_> = self.all.iter().take(NAMED).collect();
        let rows = alternatives(all.iter().map(|it| first(it)));
        let rows = rows.zip(&all).flat_map(|(line, mistake)| {
            let in_rust = Some(wrong(mistake, 1)).filter(|it| *it != wrong(mistake, 0));
            iter::once(line).chain(in_rust.map(|it| Row::new(RowKind::InRust, it)))
        });
        rows.collect::<Vec<_>>().into_iter()
    }

    /// Says how well the mistakes explain a picture of so many `pixels`, and whether their lines
    /// were found in the reader's files.
    fn tried(&self, pixels: usize) -> String {
        let is_pair = self.all[0].len() > 1;
        let with = match (&self.all[..], is_pair) {
            ([one], false) if one[0].name.is_empty() => "this mistake".to_owned(),
            ([one], false) => format!("the mistake {}", one[0].name),
            ([one], true) => format!("both mistakes, {},", mistake_name(one)),
            (_, false) => "any of these mistakes".to_owned(),
            (_, true) => "any of these pairs".to_owned(),
        };
        let draws = match self.unexplained.is_nothing() {
            true => "draws exactly your picture".to_owned(),
            false => format!(
                "draws your picture, but for {}",
                self.unexplained.said(pixels)
            ),
        };
        let wrapped = match self.conversion {
            Conversion::Wrapped => ", if levels beyond 255 begin again at 0, as in a byte of C",
            _ => "",
        };
        let others = match self.all.len() {
            1 => String::new(),
            2..=NAMED => ", and so may others".to_owned(),
            all => format!(", and so may others; {all} are known"),
        };
        let recognized = match (self.is_in_text, self.all.len() > 1 || is_pair) {
            (true, _) => "",
            (false, false) => ". The wrong line was not found in your files",
            (false, true) => ". The wrong lines were not found in your files",
        };
        format!("the chapter with {with} {draws}{wrapped}{others}{recognized}")
    }
}

impl DrawingMutants {
    /// Lists the likeliest edits of the chapter that draw the picture, in Rust, and how they were
    /// tried; nothing if there is none.
    fn rows(&self) -> Vec<Row> {
        let said = |it: &Mutant| match (&*it.wrong, &it.yours) {
            (_, Some(yours)) => yours.line.to_string(),
            ("", None) => format!("{}  left out", it.right),
            (wrong, None) => wrong.to_owned(),
        };
        let mut rows = match &self.likeliest[..] {
            [] => return Vec::new(),
            [it] if self.count == 1 => match (&*it.wrong, &it.yours) {
                ("", _) => vec![Row::new(RowKind::Missing, &*it.right)],
                (_, Some(yours)) => yours.rows(),
                (wrong, None) => line_and_right(RowKind::Perhaps, wrong, &it.right),
            },
            all => alternatives(all.iter().map(said)).collect(),
        };
        let tried = match (self.count, self.is_informative()) {
            (1, _) => "the chapter with this one edit draws exactly your picture",
            (_, true) => {
                "the chapter with any of these edits draws exactly your picture, and so may others"
            }
            (_, false) => {
                "many more edits of the chapter draw your picture, which does not tell them apart"
            }
        };
        rows.push(Row::new(RowKind::Tried, tried));
        rows
    }
}

impl Repair {
    /// Lists the reader's wrong line with what should be there, and how that was tried.
    fn rows(&self) -> Vec<Row> {
        let tried = match self.is_hidden {
            true => "with this change your functions answer as the chapter's do",
            false => "with this change your program draws the picture",
        };
        let mut rows = self.line.rows();
        rows.push(Row::new(RowKind::Tried, tried));
        rows
    }
}

impl CorrectedLine {
    /// Lists the reader's line and the right one.
    fn rows(&self) -> Vec<Row> {
        let right = match &*self.right {
            "" => "left out",
            right => right,
        };
        line_and_right(RowKind::Yours, &self.line.to_string(), right)
    }
}

/// Lists the parts of a report on a broken law, a property that a function must have: the law, what
/// was found and what is allowed, known mistakes with the same answers if there are any, and where
/// the law is explained.
pub fn law_rows(report: &Report) -> Vec<Row> {
    let broken = &report.broken;
    let kinds = iter::once(RowKind::SameAs).chain(iter::repeat(RowKind::More));
    let same_as = kinds
        .zip(&report.same_as)
        .map(|(kind, it)| Row::new(kind, it));
    let rows = [
        (RowKind::Law, &*broken.law),
        (RowKind::Found, &broken.found),
        (RowKind::Allowed, &broken.allowed),
    ];
    let rows = rows.into_iter().map(|(kind, it)| Row::new(kind, it));
    rows.chain(same_as)
        .chain([Row::new(RowKind::Read, &*broken.read)])
        .collect()
}

/// Makes a row [`Printed`](RowKind::Printed) of each line that a compiler or a program has printed;
/// none for an empty text. Control characters, which a terminal would obey, are escaped.
pub fn printed_rows(text: &str) -> Vec<Row> {
    let lines = text.lines();
    lines
        .map(|line| Row::new(RowKind::Printed, names::escape_for_terminal(line)))
        .collect()
}
