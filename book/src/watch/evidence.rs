//! The verdict on a picture: compared with the chapter's, with those of its steps, and
//! with what known mistakes draw; and the function behind it, put under the laws.

use std::iter;

use check::blind_spots::BlindSpots;
use check::names::companion;
use check::names_of;
use check::reading::{self, Cause};
use check::scene::Scene;
use check::verdict::{self, Check, Finding, Set};
use common::rtweekend::Picture;
use slips::{Chapter, Letters, Slip, steps};

use super::laws::{self, Answer};
use super::verdict::{Line, Verdict, labeled, printed, step_says};
use crate::done::{picture_is_right, step_is_done};

/// What is known of a picture and the program behind it, and the laws, which can be asked.
pub(super) struct Evidence<'a> {
    pub(super) scene: &'a Scene,
    /// Whether the reader works in a crate that `start` made.
    pub(super) is_crate: bool,
    /// Whether all but the chapter itself is ours, and so has no mistake of the reader's.
    pub(super) is_chapter_only: bool,
    /// Whether the reader's list has this line.
    pub(super) is_done: &'a dyn Fn(&str) -> bool,
    /// Puts the reader's function under the laws, where there is one.
    pub(super) ask_laws: &'a dyn Fn() -> Option<Answer>,
}

impl Evidence<'_> {
    /// The verdict on what the program has printed. Laws are asked where they know more
    /// than the picture.
    pub(super) fn of_picture(&self, bytes: &[u8]) -> Verdict {
        let scene = self.scene;
        if let Some(verdict) = self.of_step(bytes) {
            return verdict;
        }
        match verdict::check(scene, bytes, 0) {
            Check::Right(right) if !right.shape_given_by.is_empty() => Verdict {
                headline: format!(
                    "Right in this shape, {} × {}, which is not the book's.",
                    right.width, right.height
                ),
                cause: in_full(&right.shape_given_by[..1], &right.scene),
                next: "if you chose the shape, nothing is wrong".to_owned(),
                ..Verdict::default()
            },
            Check::Right(right) => {
                let picture = right.scene.right(right.width, right.height);
                self.of_right_picture(&right.scene, picture)
            }
            Check::Near(finding) => Verdict {
                headline: format!("Right, but {}.", finding.but()),
                next: "as the book has it, it can be compared to the last bit".to_owned(),
                pictures: Some((finding.yours, finding.right)),
                ..Verdict::default()
            },
            Check::Wrong(finding) => self.of_wrong_picture(finding),
            Check::Another { cause, .. } => Verdict {
                headline: sentence(&cause.problem),
                next: cause.fix.split_whitespace().collect::<Vec<_>>().join(" "),
                ..Verdict::default()
            },
            Check::WrongShape { cause, finding } => of_no_picture("wrong", &cause, finding),
            Check::NotAPicture { cause, finding } => of_no_picture("no picture", &cause, finding),
        }
    }

    /// A picture that a step before the last one shows; or a mistake in the next one does.
    fn of_step(&self, bytes: &[u8]) -> Option<Verdict> {
        let scene = self.scene;
        let reading = reading::read(bytes).ok()?;
        let (width, height) = (reading.width, reading.height);
        if scene.probe.is_some() || scene.height(width) != height || reading.outside().is_some() {
            return None;
        }
        let steps = steps::of(scene.chapter);
        let yours = reading.picture();
        let (_, earlier) = steps.split_last()?;
        let shows = |step: &steps::Step| step.picture(width, height).rgb() == yours.rgb();
        let at = earlier.iter().rposition(shows)?;
        if steps[at].has_laws
            && let Some(Answer::Broken(report)) = (self.ask_laws)()
        {
            return Some(Verdict {
                headline: format!(
                    "The picture of step {} is right, but a law is broken.",
                    at + 1
                ),
                cause: law(&report),
                pictures: Some((yours, scene.right(width, height))),
                ..Verdict::default()
            });
        }
        let again = (self.is_done)(&step_is_done(scene.chapter, at + 1));
        let check = verdict::check(scene, bytes, 0);
        let mistakes = check
            .finding()
            .map_or(Vec::new(), |finding| self.mistakes(finding));
        let or = mistakes.iter().take(SHOWN).map(|mistake| {
            let wrong = in_short(mistake, scene);
            labeled("or", format!("step {} says {wrong}", at + 2))
        });
        let (step, all) = (at + 1, steps.len());
        Some(Verdict {
            headline: match again {
                true => format!("This is what step {step} of {all} shows, again."),
                false => format!("Step {step} of {all} is right."),
            },
            cause: or.collect(),
            next: step_says(at + 1, &steps[at + 1]),
            done: vec![step_is_done(scene.chapter, at + 1)],
            pictures: Some((yours, scene.right(width, height))),
            ..Verdict::default()
        })
    }

    fn of_right_picture(&self, scene: &Scene, picture: Picture) -> Verdict {
        let (width, height, chapter) = (picture.width(), picture.height(), self.scene.chapter);
        let verdict = Verdict {
            is_right: true,
            headline: format!(
                "Right{}: all {width} × {height} pixels, to the last bit.",
                scene.edition.said()
            ),
            pictures: Some((picture, scene.right(width, height))),
            next: self.next_chapter(),
            done: vec![match self.scene.probe {
                Some(probe) => format!("{}, probe {}: right", chapter.name(), probe.name),
                None => picture_is_right(chapter),
            }],
            ..Verdict::default()
        };
        match (self.ask_laws)() {
            Some(Answer::Obeyed) => {
                self.with_blind_spots(verdict.and_obeys_the_laws(chapter), width, true)
            }
            Some(Answer::Broken(report)) => Verdict {
                is_right: false,
                headline: "The picture is right, but a law is broken.".to_owned(),
                done: Vec::new(),
                cause: law(&report),
                next: "cargo test, in the folder of your crate, shows the case".to_owned(),
                ..verdict
            },
            Some(Answer::Unknown(errors)) => Verdict {
                is_right: false,
                headline: "The picture is right, but the laws can't be tried.".to_owned(),
                done: Vec::new(),
                cause: printed(&errors),
                next: "cargo test, in the folder of your crate, shows more".to_owned(),
                ..verdict
            },
            None => self.with_blind_spots(verdict, width, false),
        }
    }

    /// Names what can hide from the picture, and the probe that shows most of it: but not
    /// what the reader can't have done, nor what the laws would have found.
    fn with_blind_spots(&self, verdict: Verdict, width: u32, laws_hold: bool) -> Verdict {
        let chapter = self.scene.chapter;
        let is_open = |slip: &&Slip| {
            !(self.is_chapter_only && !slip.is_in_a_chapter()
                || laws_hold && laws::find(&slip.program(chapter)))
        };
        let hidden = BlindSpots::after(self.scene, width);
        let open = hidden.shown_by.into_iter().map(|showing| {
            let slips = showing.slips.iter().copied().filter(is_open);
            let names: Vec<&str> = slips.map(|slip| slip.name).collect();
            (showing, names)
        });
        let Some((showing, names)) = open.max_by_key(|(_, names)| names.len()) else {
            return verdict;
        };
        if names.is_empty() {
            return verdict;
        }
        let change = showing.scene.change(showing.width).replace('\n', "; ");
        let command = showing.scene.probe.map_or(String::new(), |probe| {
            let (companion, chapter) = (companion(), chapter.name());
            format!(
                "; and then {companion} watch {chapter} --probe {} …",
                probe.name
            )
        });
        Verdict {
            cause: vec![
                labeled("can hide", names.join(", ")),
                labeled("to see it", change + &command),
            ],
            ..verdict
        }
    }

    fn next_chapter(&self) -> String {
        let mut chapters = Chapter::OF_THE_BOOK.into_iter();
        let next = chapters.find(|&it| it > self.scene.chapter);
        match (next.map(Chapter::name), self.is_crate) {
            (None, _) => "that was the last chapter to type".to_owned(),
            (Some(name), true) => format!("{name}: {} start {name}", companion()),
            (Some(name), false) => format!("{name}: {} watch {name} -- PROGRAM", companion()),
        }
    }

    fn of_wrong_picture(&self, finding: Finding) -> Verdict {
        let (cause, next) = match &self.mistakes(&finding)[..] {
            [one] => (in_full(one, &finding.scene), String::new()),
            mistakes => match (self.ask_laws)() {
                Some(Answer::Broken(report)) => (law(&report), String::new()),
                Some(Answer::Obeyed) => self.with_laws(&finding, mistakes),
                _ => self.undecided(&finding, mistakes),
            },
        };
        let difference = finding.difference.as_ref();
        let count = difference.map_or(0, |difference| difference.count);
        let total = finding.right.rgb().len() / 3;
        Verdict {
            headline: match finding.levels {
                1 => format!(
                    "Right within one level, but for the last bit: {count} of {total} pixels."
                ),
                _ => format!("Wrong: {count} of {total} pixels."),
            },
            cause,
            next,
            pictures: Some((finding.yours, finding.right)),
            ..Verdict::default()
        }
    }

    /// What is left where the laws hold: no mistake that they would have found.
    fn with_laws(&self, finding: &Finding, mistakes: &[&Mistake]) -> (Vec<Line>, String) {
        let chapter = self.scene.chapter;
        let is_found = |mistake: &Mistake| {
            let mut slips = mistake.iter();
            slips.any(|slip| laws::find(&slip.program(chapter)))
        };
        let left: Vec<&Mistake> = mistakes
            .iter()
            .copied()
            .filter(|it| !is_found(it))
            .collect();
        let (mut cause, next) = match left[..] {
            [one] => (in_full(one, &finding.scene), String::new()),
            _ => self.undecided(finding, &left),
        };
        let laws = "they hold: look at what calls the function, and what becomes of its answer";
        cause.insert(0, labeled("the laws", laws.to_owned()));
        (cause, next)
    }

    /// Several mistakes that draw the same picture, or none that is known.
    fn undecided(&self, finding: &Finding, mistakes: &[&Mistake]) -> (Vec<Line>, String) {
        match mistakes.is_empty() {
            true => (sights(finding), String::new()),
            false => undecided(self.scene, &finding.sets[0], mistakes),
        }
    }

    /// The mistakes that explain the picture; of these, the ones that the reader can have
    /// made.
    fn mistakes<'f>(&self, finding: &'f Finding) -> Vec<&'f Mistake> {
        let set = finding.sets.first();
        let all: Vec<&Mistake> = set.map_or(Vec::new(), |set| set.mistakes.iter().collect());
        let own = |mistake: &&&Mistake| mistake.iter().all(|slip| slip.is_in_a_chapter());
        let of_chapter: Vec<&Mistake> = all.iter().filter(own).copied().collect();
        match self.is_chapter_only && !of_chapter.is_empty() {
            true => of_chapter,
            false => all,
        }
    }
}

/// So many mistakes are shown that draw what an earlier step shows.
const SHOWN: usize = 4;

/// Slips that were made together: most often a single one.
type Mistake = Vec<&'static Slip>;

fn of_no_picture(verdict: &str, cause: &Cause, finding: Option<Box<Finding>>) -> Verdict {
    let slip = finding.as_ref().and_then(|finding| finding.sets.first());
    let slip = slip.filter(|set| set.mistakes.len() == 1);
    Verdict {
        headline: format!("It is {verdict}: {}.", cause.problem),
        cause: slip.map_or(Vec::new(), |set| in_full(&set.mistakes[0], &set.scene)),
        next: cause.fix.clone(),
        pictures: finding.map(|finding| (finding.yours, finding.right)),
        ..Verdict::default()
    }
}

/// A slip, or two that were made together.
fn in_full(mistake: &[&Slip], scene: &Scene) -> Vec<Line> {
    let rows = mistake
        .iter()
        .flat_map(|slip| slip.rows(Letters::Book(scene.edition), scene.chapter));
    rows.map(|(label, said)| labeled(label, said.into_owned()))
        .collect()
}

/// What is wrong in the code, and the names of the slips.
fn in_short(mistake: &Mistake, scene: &Scene) -> String {
    let wrong = mistake.iter().map(|slip| {
        slip.words(Letters::Book(scene.edition), scene.chapter)
            .wrong
    });
    let wrong: Vec<_> = wrong.collect();
    format!("{}  ({})", wrong.join("; "), names_of(mistake))
}

/// Slips that draw the same picture, and how to find out which it is.
fn undecided(scene: &Scene, set: &Set, mistakes: &[&Mistake]) -> (Vec<Line>, String) {
    let labels = iter::once("probably").chain(iter::repeat("or"));
    let one_of = labels
        .zip(mistakes)
        .map(|(label, mistake)| labeled(label, in_short(mistake, &set.scene)));
    let next = match &set.telling {
        Some(telling) => format!(
            "the probe {probe} tells them apart: {}; and then {} watch {} --probe {probe} …",
            telling.probe.lines(scene.chapter).replace('\n', "; "),
            companion(),
            scene.chapter.name(),
            probe = telling.probe.name,
        ),
        None => "look for each: no probe tells them apart".to_owned(),
    };
    (one_of.collect(), next)
}

/// What can be seen where no mistake explains it.
fn sights(finding: &Finding) -> Vec<Line> {
    let seen = finding.sights.iter().cloned();
    let mut lines: Vec<Line> = seen.map(|sight| labeled("seen", sight)).collect();
    if let Some(difference) = &finding.difference {
        let (column, row) = difference.first;
        lines.push(labeled(
            "first",
            format!(
                "column {column}, row {row}: expected {:?}, got {:?}",
                difference.expected, difference.actual
            ),
        ));
    }
    lines
}

/// A report on a law, whose lines have a label, or go on with the one before.
fn law(report: &[String]) -> Vec<Line> {
    let line = |line: &String| match line.split_once(":  ") {
        Some((label, text)) if !label.contains("  ") => {
            labeled(label, text.trim_start().to_owned())
        }
        _ => labeled("", line.trim_start().to_owned()),
    };
    report.iter().map(line).collect()
}

/// With a large letter, and a full stop.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters
        .next()
        .map_or(String::new(), |first| first.to_uppercase().to_string());
    format!("{first}{}.", letters.as_str())
}
