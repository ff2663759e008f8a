//! Text: the result for people, in the terminal.

use std::fmt::Write;
use std::path::Path;

use check::names::{self, companion};
use check::scene::Scene;
use check::told;
use check::verdict::{Check, Finding, Near};
use check::{names_of, workspace};
use slips::{Chapter, Edition, Letters, Slip};

use super::judged::Judged;
use super::map;
use crate::terminal::Palette;

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
            colored: Palette::of_stdout().is_some(),
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
    if let Check::Right(right) = &judged.check {
        for (label, said) in told::suspected(&right.scene, &judged.known) {
            text += &format!("    {} {said}\n", style.dim(&format!("{label:<9}")));
        }
    }
    if let Some(blind_spots) = &judged.blind_spots {
        write!(text, "\n{}", blind_spots.advice(&judged.scene)).expect("a string takes it");
    }
    match &judged.check {
        Check::Near(finding) => {
            if finding.near.as_ref().is_some_and(Near::is_for_pixels) {
                text += &whereabouts(finding, style);
            }
            text += &diagnosis(judged, finding, style);
        }
        other => {
            if let Some(finding) = other.finding() {
                text += &whereabouts(finding, style);
                text += &diagnosis(judged, finding, style);
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
            let by = Edition::said(&right.editions);
            let notes = given_by(&right.shape_given_by) + &edition(&right.scene);
            format!(
                "{source} is {}{by}{shape}: {how}.\n{notes}",
                style.green("right")
            )
        }
        Check::Near(finding) => {
            let (right, notes) = (style.green("right"), edition(&finding.scene));
            format!(
                "{source} is {right}{}, but {}.\n{notes}",
                Edition::said(&finding.editions),
                finding.but()
            )
        }
        Check::Wrong(finding) => {
            let verdict = match finding.levels {
                0 | 1 => style.red("right within one level, but not to the last bit"),
                _ => style.red("wrong"),
            };
            let notes = edition(&finding.scene);
            // What happened to the file comes first: what is wrong is so beyond it.
            let way = finding.degradation;
            let way = way.map_or(String::new(), |way| {
                format!("{}, and beyond that ", way.clause())
            });
            format!(
                "{source} is {way}{verdict}: {}.\n{notes}",
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

/// What the edition of a scene has otherwise than the one that this workspace follows.
fn edition(scene: &Scene) -> String {
    let [with_rays, build_test] = scene.edition.differs_by();
    let differs = match scene.chapter {
        Chapter::BuildTest => build_test,
        _ => with_rays,
    };
    match scene.edition {
        Edition::V4 => String::new(),
        _ => format!(
            "What it has otherwise than version 4, which this workspace follows: {differs}.\nTo be judged by version 4 alone: --edition 4.\n"
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
        Edition::said(&finding.editions)
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

fn diagnosis(judged: &Judged, finding: &Finding, style: Style) -> String {
    let mut text = String::new();
    let pixels = finding.right.rgb().len() / 3;
    let is_unknown = finding.near.is_none() && finding.sets.is_empty();
    if let Some(set) = finding.sets.first() {
        text += &format!("\n{}\n", style.bold(&set.title(pixels)));
        if let [mistake] = &set.mistakes[..] {
            text += &format!("\n  {}\n", style.bold(&names_of(mistake)));
        }
    } else if finding.difference.is_some() && is_unknown {
        let known = style.bold("No mistake in the catalogue draws this picture.");
        text += &format!("\n{known}\n");
    }
    let rows = finding.rows(&judged.known).into_iter();
    let other = |scene: &Scene| {
        (
            "also",
            format!("it is the picture of a probe: {}", scene.command()),
        )
    };
    let command = |probe| judged.scene.probed_command(probe);
    let next = finding.how_to_tell(command).map(|next| ("next", next));
    let rows = rows.chain(where_to_look(finding)).chain(next);
    for (label, said) in rows.chain(finding.others.iter().map(other)) {
        let label = style.dim(&format!("{label:<9}"));
        text += &format!("    {label} {said}\n");
    }
    text
}

/// The page and the file that have it right, of a single slip.
fn where_to_look(finding: &Finding) -> Vec<(&'static str, String)> {
    let [set] = &finding.sets[..] else {
        return Vec::new();
    };
    let [mistake] = &set.mistakes[..] else {
        return Vec::new();
    };
    let look = |slip: &&Slip| {
        let code = workspace::source(slip).map(|file| ("code", file));
        [("read", read(slip))].into_iter().chain(code)
    };
    mistake.iter().flat_map(look).collect()
}

/// A page that can be opened, or else what to look for in the book.
fn read(slip: &Slip) -> String {
    workspace::page(slip).unwrap_or_else(|| match workspace::workspace() {
        Some(_) => format!("{}: {} book weaves it", slip.page_in_words(), companion()),
        None => slip.page_in_words(),
    })
}
