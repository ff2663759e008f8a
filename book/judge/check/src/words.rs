//! The sentences of a finding, once for terminal, page and report.

use std::iter;

use slips::{Chapter, Letters, Probe, Slip};

use crate::Row;
use crate::candidate::{Conversion, Left};
use crate::known::Known;
use crate::scene::Scene;
use crate::search::{Change, Drawn, Mutant, Repair, Right};
use crate::sources::{Found, Line};
use crate::verdict::{Finding, Mistakes, Near};

/// So many mistakes that draw the same are named.
const NAMED: usize = 4;
/// So many warnings of a compiler.
const WARNINGS: usize = 2;

impl Finding {
    /// What explains the picture, or else what is to be seen.
    pub fn rows(&self, known: &Known) -> Vec<Row> {
        if let Some(repair) = &self.repair {
            let why = self
                .single()
                .first()
                .map(|slip| known.words(slip, &self.scene).why);
            let why = why.filter(|why| !why.is_empty());
            let why = why.map(|why| ("why", why.to_owned()));
            return repair.rows().chain(why).collect();
        }
        if self.near.is_some() {
            return Vec::new();
        }
        let warnings = known.warnings.iter().take(WARNINGS);
        let warnings = warnings.map(|it| ("warned", it.clone()));
        let explained = match &self.mistakes {
            Some(mistakes) => mistakes.rows(known),
            None if self.drawn.is_told() => self.drawn.rows(known, &self.scene),
            None => {
                let seen = self.sights.iter().map(|it| ("seen", it.clone()));
                let first = self.first.iter().cloned();
                let drawn = self.drawn.rows(known, &self.scene);
                seen.chain(first).chain(drawn).collect()
            }
        };
        warnings.chain(explained).collect()
    }

    /// A small change that tells the mistakes apart, and the command that judges its picture.
    pub fn next(
        &self,
        letters: Option<Letters>,
        command: impl Fn(Probe) -> String,
    ) -> Option<String> {
        let probe = self.mistakes.as_ref()?.telling?;
        let change = probe.lines(self.scene.chapter, letters).replace('\n', "; ");
        Some(format!(
            "draw the probe {}, which tells some of them apart: {change}; and then {}",
            probe.name,
            command(probe),
        ))
    }
}

impl Mistakes {
    /// How well the mistakes explain a picture of that many pixels.
    pub fn title(&self, pixels: usize) -> String {
        let is_pair = self.all[0].len() > 1;
        let who = match (self.all.len() > 1, is_pair) {
            (false, false) => "One known mistake draws",
            (true, false) => "Each of these known mistakes draws",
            (false, true) => "Two known mistakes together draw",
            (true, true) => "Each of these pairs of known mistakes draws",
        };
        let wrapped = if self.conversion == Conversion::Wrapped {
            " (if levels beyond 255 begin again at 0, as with a cast to a byte in C)"
        } else {
            ""
        };
        let has_others = self.all.len() > 1;
        let others = if has_others {
            ", and so may others"
        } else {
            ""
        };
        let recognized = match (self.is_in_text, self.all.len()) {
            (true, _) => "",
            (false, 1) if !is_pair => ". Its line was not recognized in your files",
            (false, _) => ". Their lines were not recognized in your files",
        };
        format!(
            "{who} {}{wrapped}{others}{recognized}:",
            self.extent(pixels)
        )
    }

    fn extent(&self, pixels: usize) -> String {
        if self.left.is_nothing() {
            return "exactly this picture".to_owned();
        }
        format!("this picture, but for {}", self.left.said(pixels))
    }

    /// Each mistake in the reader's letters.
    fn rows(&self, known: &Known) -> Vec<Row> {
        if let [mistake] = &self.all[..] {
            return self.in_full(mistake, known);
        }
        let wrong = |mistake: &Vec<&'static Slip>| {
            let words = mistake.iter().map(|slip| known.words(slip, &self.scene));
            let wrong: Vec<String> = words.map(|words| words.wrong.into_owned()).collect();
            format!("{}  ({})", wrong.join("; "), names_of(mistake))
        };
        let labels = iter::once("perhaps").chain(iter::repeat("or"));
        let shown = labels.zip(self.all.iter().take(NAMED).map(wrong));
        let more = self.all.len().saturating_sub(NAMED);
        let more = (more > 0).then(|| ("also", format!("{more} others that are known")));
        shown.chain(more).collect()
    }

    fn in_full(&self, mistake: &[&'static Slip], known: &Known) -> Vec<Row> {
        let rows = mistake.iter().flat_map(|slip| {
            let words = known.words(slip, &self.scene);
            let label = if self.is_in_text {
                "probably"
            } else {
                "perhaps"
            };
            let lines = match known.line_of(slip, &self.scene) {
                Some(found) => found.rows(),
                None => vec![
                    (label, words.wrong.into_owned()),
                    ("should be", words.right.into_owned()),
                ],
            };
            let lines = lines.into_iter().chain([("why", words.why.to_owned())]);
            lines.filter(|(_, said)| !said.is_empty())
        });
        rows.collect()
    }
}

impl Drawn {
    /// What is known of the edits that draw it, if that are few.
    pub fn title(&self) -> Option<&'static str> {
        let title = match self.all.len() {
            1 if self.count == 1 => "One edit of the chapter's text draws exactly this picture:",
            _ => "Each of these edits draws exactly this picture, and so may others:",
        };
        Some(title).filter(|_| self.is_told())
    }

    /// The likeliest lines, each in the reader's letters.
    fn rows(&self, known: &Known, scene: &Scene) -> Vec<Row> {
        let letters = known.letters.unwrap_or(Letters::Book(scene.edition));
        let typed = |line: &str| letters.spelled(line, scene.chapter);
        if let ([it], 1) = (&self.all[..], self.count) {
            if it.wrong.is_empty() {
                return vec![("missing", typed(&it.right))];
            }
            return match &it.yours {
                Some(yours) => yours.rows(),
                None => vec![
                    ("perhaps", typed(&it.wrong)),
                    ("should be", typed(&it.right)),
                ],
            };
        }
        let said = |it: &Mutant| match (&*it.wrong, &it.yours) {
            (_, Some(yours)) => yours.line.to_string(),
            ("", None) => format!("{}  left out", typed(&it.right)),
            (wrong, None) => typed(wrong),
        };
        let labels = iter::once("perhaps").chain(iter::repeat("or"));
        let rows = labels.zip(self.all.iter().map(said));
        let many = (!self.all.is_empty() && !self.is_told()).then(|| {
            (
                "",
                "and many others draw this picture: it does not tell".to_owned(),
            )
        });
        rows.chain(many).collect()
    }
}

impl Near {
    /// What it is instead of the book's picture, after "right, but".
    pub fn clause(&self, pixels: usize) -> String {
        if self.left.is_nothing() {
            return String::new();
        }
        format!("for {}", self.left.said(pixels))
    }
}

impl Left {
    /// How many pixels are off, and where.
    fn said(&self, pixels: usize) -> String {
        let span = |name: &str, [first, last]: [u32; 2]| {
            if first == last {
                format!("{name} {first}")
            } else {
                format!("{name}s {first} to {last}")
            }
        };
        let off = self.off;
        if self.is_rounding() {
            return format!(
                "one level in {off} of {pixels} pixels, as with single precision or another way of rounding"
            );
        }
        let (columns, rows) = (span("column", self.columns), span("row", self.rows));
        format!("{off} of {pixels} pixels, in {columns}, {rows}")
    }
}

/// The names of slips that were made together. Of one without a name, what it says in the
/// chapter's own words.
pub fn names_of(mistake: &[&'static Slip]) -> String {
    let name = |slip: &&'static Slip| match slip.name {
        "" => {
            let chapter = slip.chapters().next().unwrap_or(Chapter::HittableList);
            slip.words(Letters::Rust, chapter).wrong
        }
        name => name.into(),
    };
    let names: Vec<_> = mistake.iter().map(name).collect();
    names.join(" and ")
}

impl Repair {
    /// The reader's lines and what should be there, and that it was tried.
    fn rows(&self) -> impl Iterator<Item = Row> {
        let with = match &self.changes[..] {
            [_] => "with it",
            _ => "with all of this",
        };
        let is_foreign = matches!(
            &self.changes[..],
            [Change {
                right: Right::Spelled(_),
                ..
            }]
        );
        let tried = if is_foreign {
            "the chapter with your line in its place draws your picture".to_owned()
        } else if self.is_hidden {
            format!("{with} your functions answer as the chapter's do")
        } else {
            format!("{with} your program draws the picture")
        };
        let changes = self.changes.iter().flat_map(Change::rows);
        changes.chain([("tried", tried)])
    }
}

impl Change {
    fn rows(&self) -> Vec<Row> {
        let Line { file, number, .. } = &self.yours;
        let right = match &self.right {
            Right::More(line) => {
                return vec![("missing", format!("above {file}:{number}  {line}"))];
            }
            Right::Line(line) | Right::Spelled(line) => line.clone(),
            Right::Nothing => "left out".to_owned(),
        };
        vec![("yours", self.yours.to_string()), ("should be", right)]
    }
}

impl Found {
    fn rows(&self) -> Vec<Row> {
        let yours = ("yours", self.line.to_string());
        vec![yours, ("should be", self.right.clone())]
    }
}
