//! Text: the result for people, in the terminal.

use std::fmt::Write;
use std::path::Path;

use check::names::{self, companion};
use check::scene::Scene;
use check::verdict::{Check, Finding, Near};
use check::{names_of, workspace};
use slips::{Edition, Letters, Slip};
use supports_color::Stream;

use super::judged::Judged;
use super::map;

/// Mistakes of one set that are shown in full; of the others only the name.
const SHOWN_IN_FULL: usize = 6;

/// Bold and color, or neither.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    colored: bool,
}

impl Style {
    /// Plain where nobody looks, where the terminal can't, and where the reader
    /// does not want it.
    pub(crate) fn of_stdout() -> Self {
        Self {
            colored: supports_color::on(Stream::Stdout).is_some(),
        }
    }

    /// Neither bold nor color.
    pub(crate) fn plain() -> Self {
        Self { colored: false }
    }

    pub(crate) fn bold(self, text: &str) -> String {
        self.wrapped("1", text)
    }

    pub(crate) fn dim(self, text: &str) -> String {
        self.wrapped("2", text)
    }

    fn red(self, text: &str) -> String {
        self.wrapped("31", text)
    }

    pub(crate) fn green(self, text: &str) -> String {
        self.wrapped("32", text)
    }

    fn wrapped(self, code: &str, text: &str) -> String {
        if self.colored {
            format!("\x1b[{code}m{text}\x1b[0m")
        } else {
            text.to_owned()
        }
    }
}

/// The whole result.
pub(crate) fn text(judged: &Judged, report: Option<&Path>, style: Style) -> String {
    let mut text = headline(judged, style);
    if let Some(blind_spots) = &judged.blind_spots {
        write!(text, "\n{}", blind_spots.advice(&judged.scene)).expect("a string takes it");
    }
    match &judged.check {
        Check::Near(finding) => {
            if finding.near.as_ref().is_some_and(Near::is_for_pixels) {
                text += &whereabouts(finding, style);
            }
            text += &diagnosis(&judged.scene, finding, style);
        }
        other => {
            if let Some(finding) = other.finding() {
                text += &whereabouts(finding, style);
                text += &diagnosis(&judged.scene, finding, style);
            }
        }
    }
    if let Some(page) = report {
        writeln!(text, "\nThe page is {}", names::spelled(page)).expect("a string takes it");
    }
    text
}

/// Right, wrong, or why it is no picture.
pub(crate) fn headline(judged: &Judged, style: Style) -> String {
    let source = &judged.source;
    let name = scene_name(&judged.scene);
    match &judged.check {
        Check::Right(right) => {
            let all = u64::from(right.width) * u64::from(right.height);
            let (width, height, off) = (right.width, right.height, right.off);
            let how = match right.levels {
                0 => format!("all {all} pixels of {name} at {width} × {height}, to the last bit"),
                levels => format!(
                    "{off} of {all} pixels of {name} are off, by no more than {levels}, which is tolerated"
                ),
            };
            let shape = match right.scene.has_another_shape() {
                true => " in this shape, which is not the book's",
                false => "",
            };
            let by = right.scene.edition.said();
            let notes = given_by(&right.shape_given_by) + &edition(right.scene.edition);
            format!(
                "{source} is {}{by}{shape}: {how}.\n{notes}",
                style.green("right")
            )
        }
        Check::Near(finding) => {
            let by = finding.scene.edition;
            let (right, notes) = (style.green("right"), edition(by));
            format!(
                "{source} is {right}{}, but {}.\n{notes}",
                by.said(),
                finding.but()
            )
        }
        Check::Wrong(finding) => {
            let verdict = match finding.levels {
                0 | 1 => style.red("right within one level, but not to the last bit"),
                _ => style.red("wrong"),
            };
            let notes = edition(finding.scene.edition);
            format!(
                "{source} is {verdict}: {}.\n{notes}",
                counts(&name, finding)
            )
        }
        Check::Another { cause, .. } | Check::WrongShape { cause, .. } => {
            let verdict = style.red("wrong");
            format!("{source} is {verdict}: {}.\n{}\n", cause.problem, cause.fix)
        }
        Check::NotAPicture { cause, finding } => {
            let verdict = match finding {
                None => style.red("not a picture"),
                Some(_) => style.red("not a valid picture"),
            };
            format!("{source} is {verdict}: {}.\n{}\n", cause.problem, cause.fix)
        }
    }
}

/// What may have given a picture its shape, if nobody chose it.
fn given_by(slips: &[&Slip]) -> String {
    match slips {
        [] => String::new(),
        slips => {
            let names: Vec<String> = slips
                .iter()
                .map(|slip| {
                    format!(
                        "{} ({})",
                        slip.name,
                        slip.words(Letters::Book(Edition::V4), slip.chapters[0])
                            .wrong
                    )
                })
                .collect();
            format!(
                "If you did not choose this shape, look for {}.\n",
                names.join(", or ")
            )
        }
    }
}

/// What an edition has otherwise than the one that this workspace follows.
fn edition(edition: Edition) -> String {
    match edition {
        Edition::V4 => String::new(),
        older => format!(
            "What it has otherwise than version 4, which this workspace follows: {}.\n--edition 4 insists on that.\n",
            older.differs_by()
        ),
    }
}

fn scene_name(scene: &Scene) -> String {
    let chapter = scene.chapter.name();
    match scene.probe {
        None => chapter.to_owned(),
        Some(probe) => format!("{chapter} with the probe {}", probe.name),
    }
}

fn counts(name: &str, finding: &Finding) -> String {
    let (width, height) = (finding.right.width(), finding.right.height());
    let Some(difference) = &finding.difference else {
        return format!("no pixel differs from {name} at {width} × {height}");
    };
    let (count, total) = (difference.count, difference.total);
    let share = 100.0 * count as f64 / total as f64;
    format!(
        "{count} of {total} pixels ({share:.1} %) are not those of {name} at {width} × {height}{}",
        finding.scene.edition.said()
    )
}

fn whereabouts(finding: &Finding, style: Style) -> String {
    let Some(difference) = &finding.difference else {
        return "\nBut for that, it is the right picture in this size.\n".to_owned();
    };
    let (columns, rows, first) = (difference.columns, difference.rows, difference.first);
    let label = |label: &str| style.dim(&format!("{label:<7}"));
    let mut text = format!(
        "\n  {} columns {} to {}, rows {} to {}; no component is off by more than {}\n",
        label("where"),
        columns.0,
        columns.1,
        rows.0,
        rows.1,
        finding.levels
    );
    for line in map::map(&finding.right, &finding.yours) {
        writeln!(text, "          {line}").expect("a string takes it");
    }
    writeln!(
        text,
        "  {} column {}, row {}: expected {:?}, got {:?}",
        label("first"),
        first.0,
        first.1,
        difference.expected,
        difference.actual
    )
    .expect("a string takes it");
    text
}

fn diagnosis(scene: &Scene, finding: &Finding, style: Style) -> String {
    let mut text = String::new();
    let pixels = finding.right.rgb().len() / 3;
    for set in &finding.sets {
        write!(text, "\n{}\n", style.bold(&set.title(pixels))).expect("a string takes it");
        for mistake in set.mistakes.iter().take(SHOWN_IN_FULL) {
            text += &in_full(mistake, &set.scene, style);
        }
        if set.mistakes.len() > SHOWN_IN_FULL {
            let others: Vec<String> = set.mistakes[SHOWN_IN_FULL..]
                .iter()
                .map(|mistake| names_of(mistake))
                .collect();
            writeln!(text, "\n  Also: {}.", others.join("; ")).expect("a string takes it");
        }
        text += &set.how_to_tell(scene);
    }
    if !finding.others.is_empty() {
        text.push('\n');
    }
    for other in &finding.others {
        let command = other.command();
        writeln!(text, "  It is also the right picture of a probe: {command}")
            .expect("a string takes it");
    }
    let sights = &finding.sights;
    let is_unknown = finding.near.is_none() && finding.sets.is_empty();
    if finding.difference.is_some() && is_unknown {
        let known = style.bold("No mistake in the catalogue draws this picture.");
        write!(text, "\n{known}").expect("a string takes it");
        text.push_str(if sights.is_empty() {
            "\n"
        } else {
            " What can be seen:\n"
        });
        for sight in sights {
            writeln!(text, "  {sight}").expect("a string takes it");
        }
    }
    text
}

fn in_full(mistake: &[&Slip], scene: &Scene, style: Style) -> String {
    let mut text = String::new();
    for slip in mistake {
        let words = slip
            .rows(Letters::Book(scene.edition), scene.chapter)
            .map(|(label, said)| (label, said.into_owned()));
        let code = workspace::source(slip).map(|file| ("code", file));
        let rows = words.into_iter().chain([("read", read(slip))]).chain(code);
        text += &format!("\n  {}\n", style.bold(slip.name));
        for (label, said) in rows {
            let label = style.dim(&format!("{label:<9}"));
            text += &format!("    {label} {said}\n");
        }
    }
    text
}

/// A page that can be opened, or else what to look for in the book.
fn read(slip: &Slip) -> String {
    workspace::page(slip).unwrap_or_else(|| match workspace::workspace() {
        Some(_) => format!("{}: {} book weaves it", slip.page_in_words(), companion()),
        None => slip.page_in_words(),
    })
}
