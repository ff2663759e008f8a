//! What is told of a picture: labeled rows, the same wherever they are shown.

use std::{fmt, iter};

use slips::{Probe, Slip};

use crate::evidence::Known;
use crate::explanations::But;
use crate::scene::Scene;
use crate::sources::{Line, Unlike};
use crate::verdict::{Finding, Set};
use crate::words::names_of;

/// A label and what it is about.
pub type Row = (&'static str, String);

/// So many mistakes are told that explain all there is. What more of them draw is the
/// picture of many things, some of which nobody knows.
pub(crate) const TOLD: usize = 4;
/// So many warnings of a compiler.
const WARNINGS: usize = 2;

impl Finding {
    /// What explains the picture, or else what is to be seen.
    pub fn rows(&self, known: &Known) -> Vec<Row> {
        let warnings = known.warnings.iter().take(WARNINGS);
        let mut rows: Vec<Row> = warnings.map(|it| ("warned", it.clone())).collect();
        rows.extend(lints(known));
        let mistakes = self.mistakes();
        // Where much else may be the cause, what is seen is surer than any of it.
        let label = match self.sights.is_empty() && mistakes.len() == 1 {
            true => "probably",
            false => "perhaps",
        };
        rows.extend(match &mistakes[..] {
            [] => self.unexplained(known),
            [(set, mistake)] => in_full(mistake, label, &set.scene, known),
            several => [unlike(&self.scene, known), in_short(several, label, known)].concat(),
        });
        rows.extend(self.sets.first().and_then(or_by_offsets));
        let sights = self.sights.iter().filter(|_| !mistakes.is_empty());
        let mut seen = sights.map(|sight| ("seen", sight.clone()));
        let (first, last) = (seen.next(), seen.next_back());
        first.into_iter().chain(rows).chain(last).collect()
    }

    /// What tells the mistakes apart, with the command that judges a probe's picture.
    pub fn how_to_tell(&self, command: impl Fn(Probe) -> String) -> Option<String> {
        let set = self.sets.first().filter(|set| set.mistakes.len() > 1)?;
        let Some(telling) = &set.telling else {
            return Some("look for each: no probe tells them apart".to_owned());
        };
        let name = |&n: &usize| names_of(&set.mistakes[n]);
        let groups = telling.groups.iter();
        let groups: Vec<String> = groups
            .map(|group| group.iter().map(name).collect::<Vec<_>>().join(", "))
            .collect();
        Some(format!(
            "the probe {} tells them apart: {}. Change your program to {}; and then {}",
            telling.probe.name,
            groups.join(" | "),
            telling.probe.lines(self.scene.chapter).replace('\n', "; "),
            command(telling.probe),
        ))
    }

    /// All that explain it, with the set that each is of.
    fn mistakes(&self) -> Vec<(&Set, &[&'static Slip])> {
        self.sets
            .iter()
            .flat_map(|set| set.mistakes.iter().map(move |it| (set, &it[..])))
            .collect()
    }

    /// What is not as the chapter has it, and what can be seen.
    fn unexplained(&self, known: &Known) -> Vec<Row> {
        let is_near = self.near.is_some();
        let unlike = unlike(&self.scene, known).into_iter();
        let unlike = unlike.filter(|_| !is_near);
        let seen = self.sights.iter().map(|sight| ("seen", sight.clone()));
        unlike.chain(seen).collect()
    }
}

/// Of a right picture: lines that look like a mistake which no such picture shows.
pub fn suspected(scene: &Scene, known: &Known) -> Vec<Row> {
    let suspected = known.suspected(scene).into_iter().take(2);
    let suspected = suspected.flat_map(|slip| in_full(&[slip], "probably", scene, known));
    lints(known).into_iter().chain(suspected).collect()
}

/// The reader's lines that are wrong in any program.
fn lints(known: &Known) -> Vec<Row> {
    let lints = known.sources.lints().into_iter().take(WARNINGS);
    let said = |(line, why)| ("yours", format!("{line}  ({why})"));
    lints.map(said).collect()
}

/// The reader's lines that are not as the chapter has them, with the chapter's.
pub fn unlike(scene: &Scene, known: &Known) -> Vec<Row> {
    known.unlike(scene).iter().flat_map(rows_of).collect()
}

fn rows_of(unlike: &Unlike) -> Vec<Row> {
    let Unlike { yours, chapter, .. } = unlike;
    match unlike.is_missing {
        true => vec![(
            "missing",
            format!("below {}:{}  {chapter}", yours.file, yours.number),
        )],
        false => vec![("yours", yours.to_string()), ("the page", chapter.clone())],
    }
}

/// What else moves the rays of a pixel, where that is what the slip does.
fn or_by_offsets(set: &Set) -> Option<Row> {
    let right = set.scene.program(&[]);
    let moves = |slip: &&Slip| slip.put_to(right).inset != right.inset;
    let is_moved = set.but.iter().any(But::is_mean) && set.mistakes[0].iter().any(moves);
    let said = "the offsets of the rays run from 0 to 1, or to -1, and not from -0.5 to 0.5";
    is_moved.then(|| ("or", said.to_owned()))
}

/// Slips that were made together, with the reader's own lines if these are found.
fn in_full(
    mistake: &[&'static Slip],
    label: &'static str,
    scene: &Scene,
    known: &Known,
) -> Vec<Row> {
    // Where the chapter has another line, the mistake is there, in whatever words.
    let unlike = unlike(scene, known);
    let is_shown = !unlike.is_empty();
    let rows = mistake.iter().flat_map(|slip| {
        let words = known.read_words(slip, scene);
        let wrong = match known.line_of(slip, scene) {
            Some(line) => ("yours", line.to_string()),
            None => (label, words.wrong.into_owned()),
        };
        let lines = [wrong, ("should be", words.right.into_owned())];
        let lines = lines.into_iter().filter(move |_| !is_shown);
        let why = Some(words.why).filter(|why| !why.is_empty());
        lines.chain(why.map(|why| ("why", why.to_owned())))
    });
    unlike.into_iter().chain(rows).collect()
}

/// What each says instead of the right line.
fn in_short(mistakes: &[(&Set, &[&'static Slip])], label: &'static str, known: &Known) -> Vec<Row> {
    let mut said: Vec<(String, String)> = Vec::new();
    for (set, mistake) in mistakes {
        let wrong = mistake.iter();
        let wrong: Vec<_> = wrong
            .map(|slip| known.read_words(slip, &set.scene).wrong)
            .collect();
        let wrong = wrong.join("; ");
        if said.iter().all(|(other, _)| *other != wrong) {
            let is_named = mistake.iter().any(|slip| !slip.name.is_empty());
            let names = is_named.then(|| names_of(mistake));
            said.push((wrong.clone(), names.unwrap_or(wrong)));
        }
    }
    let labels = iter::once(label).chain(iter::repeat("or"));
    let mut rows: Vec<Row> = labels
        .zip(said.iter().take(TOLD))
        .map(|(label, (wrong, names))| match names == wrong {
            true => (label, wrong.clone()),
            false => (label, format!("{wrong}  ({names})")),
        })
        .collect();
    let others: Vec<&str> = said
        .iter()
        .skip(TOLD)
        .map(|(_, names)| names.as_str())
        .collect();
    if !others.is_empty() {
        rows.push(("also", others.join("; ")));
    }
    rows
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}  {}", self.file, self.number, self.text)
    }
}
