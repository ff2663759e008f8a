//! What the tables of caught slips say.

use std::fmt::Write;

use slips::Chapter;
use slips::{self, Probe, Slip, Unseen};

use super::{Outcome, Shown};

fn percent(share: f64) -> String {
    match 100.0 * share {
        tiny if tiny < 0.05 => "<0.1".to_owned(),
        percent => format!("{percent:.1}"),
    }
}

/// Markdown: what catches each slip first, and which slips
/// a law catches. Each name is an anchor.
pub(super) fn at_a_glance(outcomes: &[Outcome]) -> String {
    let mut page = String::new();
    for (number, first) in Chapter::OF_THE_BOOK.into_iter().enumerate() {
        let numbers: String = (number..6).map(|number| format!(" {number} |")).collect();
        let lines = "---|".repeat(8 - number);
        let name = first.name();
        write!(
            page,
            "## Slips that begin in `{name}`\n\n| slip |{numbers} law |\n|{lines}\n"
        )
        .expect("a string takes it");
        for slip in slips::all().filter(|slip| slip.chapters[0] == first) {
            page += &glance(slip, outcomes);
        }
        page.push('\n');
    }
    page + "## The laws\n\n" + &list_of_laws(outcomes)
}

/// A slip in its first chapter and all that follow, and the numbers of the
/// laws that it breaks before any other.
fn glance(slip: &Slip, outcomes: &[Outcome]) -> String {
    let of_slip = of_slip(outcomes, slip);
    let cell = |chapter: &Chapter| {
        let outcome = of_slip.clone().find(|it| it.chapter == *chapter);
        format!(
            " {} |",
            outcome.map_or(String::new(), Outcome::caught_first_by)
        )
    };
    let chapters = Chapter::OF_THE_BOOK
        .iter()
        .filter(|chapter| **chapter >= slip.chapters[0]);
    let cells: String = chapters.map(cell).collect();
    let broken: Vec<String> = (1..)
        .zip(broken_laws(outcomes))
        .filter(|(_, law)| of_slip.clone().any(|outcome| outcome.breaks(law)))
        .map(|(n, _)| format!("[{n}](#law-{n})"))
        .collect();
    let laws = broken.join(", ");
    let name = slip.name;
    format!("| <span class=\"name\" id=\"{name}\">{name}</span> |{cells} {laws} |\n")
}

impl Outcome {
    fn is_equivalent(&self) -> bool {
        matches!(
            self.slip.unseen_in(self.chapter),
            Some(Unseen::Equivalent(_))
        )
    }

    /// The share of the book's pixels that differ, or else the first probe that
    /// shows the slip, or else that only a law does, or nothing.
    fn caught_first_by(&self) -> String {
        let differs = |(_, verdict): &&(Option<Probe>, Shown)| *verdict != Shown::Same;
        match self.verdicts.iter().find(differs) {
            Some((None, Shown::Pixels(share))) => percent(*share),
            Some((None, _)) => "size".to_owned(),
            Some((Some(probe), _)) => format!("*{}*", probe.name),
            None if self.is_equivalent() => "=".to_owned(),
            None => "law".to_owned(),
        }
    }
}

/// Each law that a slip breaks before any other, and these slips.
fn list_of_laws(outcomes: &[Outcome]) -> String {
    let mut list = String::new();
    for (n, law) in (1..).zip(broken_laws(outcomes)) {
        let breaks = |slip: &&Slip| of_slip(outcomes, slip).any(|outcome| outcome.breaks(law));
        let slips: Vec<String> = slips::all()
            .filter(breaks)
            .map(|slip| format!("[{name}](#{name})", name = slip.name))
            .collect();
        let slips = slips.join(", ");
        writeln!(
            list,
            "{n}. <span id=\"law-{n}\">**{law}**</span> catches {slips}."
        )
        .expect("a string takes it");
    }
    list
}

/// The laws that are broken, in the order of the outcomes.
fn broken_laws(outcomes: &[Outcome]) -> Vec<&str> {
    let mut laws = Vec::new();
    for report in outcomes.iter().filter_map(|it| it.report.as_ref()) {
        if !laws.contains(&report.law()) {
            laws.push(report.law());
        }
    }
    laws
}

fn of_slip<'a>(outcomes: &'a [Outcome], slip: &Slip) -> impl Iterator<Item = &'a Outcome> + Clone {
    let name = slip.name;
    outcomes
        .iter()
        .filter(move |outcome| outcome.slip.name == name)
}
