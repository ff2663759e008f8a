//! Diagnosis by synthesis: draws what each known mistake draws, and compares.
//!
//! Every slip is a program, so the question is which programs draw *this*
//! picture. A look at a few thousand pixels leaves a handful, and these are
//! compared pixel by pixel. Slips that draw the same picture are one [`Set`]:
//! the picture can't tell them apart, but a probe may.

mod another;
mod candidates;
mod scene;
mod shape;
mod sight;
mod telling;
mod wording;

use common::rtweekend::Picture;

use crate::reading::Reading;
use crate::slips::Slip;

pub(crate) use candidates::spread;
use candidates::{Candidate, Evidence, Judged};
pub use candidates::{Conversion, Fit};
pub use scene::Scene;
pub use shape::giving as slips_giving;
pub use telling::Telling;
pub use wording::names_of;

/// What may have drawn a wrong picture.
#[derive(Clone, Debug, Default)]
pub struct Diagnosis {
    /// Mistakes that explain it, best first.
    pub sets: Vec<Set>,
    /// What can be seen, where no mistake explains it all.
    pub sights: Vec<String>,
}

impl Diagnosis {
    /// Whether one mistake alone draws the picture, to the last bit.
    pub fn is_certain(&self) -> bool {
        let draws_it = |set: &Set| set.explains == Explains::All && set.mistakes[0].len() == 1;
        self.sets.first().is_some_and(draws_it)
    }
}

/// Mistakes that draw the same picture.
#[derive(Clone, Debug)]
pub struct Set {
    /// One slip each, or two that were made together; those that more people
    /// reported come first.
    pub mistakes: Vec<Vec<&'static Slip>>,
    /// How well they explain the picture.
    pub explains: Explains,
    /// How far their picture is from the reader's.
    pub fit: Fit,
    /// What becomes of numbers that are no levels.
    pub conversion: Conversion,
    /// A small change of scene that tells them apart, if there is one.
    pub telling: Option<Telling>,
}

/// How much of a picture is explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Explains {
    /// Every pixel that was compared, to the last bit.
    All,
    /// Every pixel, but some are one level off.
    AllButOneLevel,
    /// At least half of the pixels that are wrong.
    Most,
}

/// How many pixels are compared after the first glance.
const FIRST_LOOK: u32 = 2000;
/// How many are compared in the end: all of a picture 800 pixels wide.
const SECOND_LOOK: u32 = 400_000;
/// How many candidates are worth a longer look than a glance.
const FEW: usize = 48;
/// How many are worth the longest: more than any set has mistakes.
const FEWER: usize = 16;
/// How many pixels are compared where thousands of pairs have to be judged.
const GLANCE: u32 = 64;
/// How many sets a reader is told of.
const MOST_SETS: usize = 3;

/// Finds what may have drawn the reader's picture. `right` is the right one in
/// the same size.
pub fn diagnose(scene: &Scene, reading: &Reading, right: &Picture) -> Diagnosis {
    let evidence = Evidence::new(reading, right);
    let own_shape = scene.height(reading.width) == reading.height;
    // Someone may have chosen another shape, and made a mistake besides.
    let shaped = scene.shaped(reading.width, reading.height);
    let scenes: &[&Scene] = if own_shape {
        &[scene]
    } else {
        &[scene, &shaped]
    };
    let conversions: &[Conversion] = match reading.outside() {
        Some(_) => &[Conversion::Printed],
        None => &[Conversion::Clamped, Conversion::Wrapped],
    };
    let mut sets: Vec<Set> = Vec::new();
    for scene in scenes {
        for &conversion in conversions {
            if !sets.iter().any(Set::is_enough) {
                let mut found = explanations(scene, &evidence, conversion);
                // Most programs print nothing that a conversion could change.
                found.retain(|set| !set.is_among(&sets));
                sets.append(&mut found);
            }
        }
    }
    sets.sort_by_key(|set| set.explains == Explains::Most);
    sets.truncate(MOST_SETS);
    for set in &mut sets {
        set.telling = telling::apart(scene, &set.mistakes);
    }
    let sights = if sets.iter().any(Set::is_enough) {
        Vec::new()
    } else {
        sight::sights(scene, reading, right)
    };
    Diagnosis { sets, sights }
}

impl Set {
    /// Whether nothing is left to explain but single levels.
    pub fn is_enough(&self) -> bool {
        self.explains != Explains::Most
    }

    fn is_among(&self, sets: &[Self]) -> bool {
        let first = |set: &Self| set.mistakes[0].iter().map(|slip| slip.name).collect();
        let own: Vec<&str> = first(self);
        sets.iter().any(|set| first(set) == own)
    }
}

/// The sets of single slips, and of pairs where no single slip is enough.
fn explanations(scene: &Scene, evidence: &Evidence, conversion: Conversion) -> Vec<Set> {
    let reading = evidence.reading;
    let program = |slips: &[&'static Slip]| Candidate::of(scene, reading, slips, conversion);
    let many = evidence.places(SECOND_LOOK);
    // In another shape than the chapter's there is no right program. Then every
    // pixel has to be explained, if only by its being there.
    let right = program(&[]);
    let judge_right = |places: &[u32]| right.as_ref()?.judge(reading, places, places.len());
    let right_one = judge_right(&many);
    let baseline = right_one.map_or(Fit::nothing(many.len()), |(fit, _)| fit);
    if baseline.off == 0 {
        return Vec::new();
    }
    let draws_right = right_one.map(|(_, mark)| mark);
    // What does not explain half of what is wrong is not reported. Some more is
    // let through, because a few pixels don't tell exactly.
    let most = |judged: Option<(Fit, u64)>, places: &[u32]| {
        judged.map_or(places.len(), |(fit, _)| fit.far) * 3 / 4
    };
    let glance = evidence.places(GLANCE);
    let few = evidence.places(FIRST_LOOK);
    let looks = [
        (FEW, &few, most(judge_right(&few), &few)),
        (FEWER, &many, most(right_one, &many)),
    ];
    let explained_by = |mut found: Vec<Judged>| {
        for (count, places, most) in looks {
            let best_of_them = found.into_iter().map(|judged| judged.candidate).take(count);
            found = candidates::best(reading, best_of_them, places, most);
        }
        found.retain(|judged| draws_right != Some(judged.mark));
        sets(found, baseline)
    };

    let slips: Vec<&'static Slip> = scene.slips().collect();
    let singles = slips.iter().filter_map(|&slip| program(&[slip]));
    let most_at_a_glance = most(judge_right(&glance), &glance);
    let single = explained_by(candidates::best(
        reading,
        singles,
        &glance,
        most_at_a_glance,
    ));
    if single
        .first()
        .is_some_and(|set| set.explains == Explains::All)
    {
        return single;
    }
    let pairs = (0..slips.len())
        .flat_map(|n| slips[n + 1..].iter().map(move |&other| (n, other)))
        .filter_map(|(n, other)| program(&[slips[n], other]));
    // Two slips explain a lot by chance, so they have to explain everything.
    let mut pair = explained_by(candidates::best(reading, pairs, &glance, 0));
    let enough = single.first().is_some_and(Set::is_enough);
    pair.retain(|set| {
        set.explains == Explains::All || (!enough && set.is_enough() && baseline.far > 0)
    });
    if enough {
        single.into_iter().chain(pair).collect()
    } else {
        pair.into_iter().chain(single).collect()
    }
}

/// Puts together what draws the same picture, and keeps what explains enough.
fn sets(judged: Vec<Judged>, baseline: Fit) -> Vec<Set> {
    let mut sets: Vec<(u64, Set)> = Vec::new();
    for Judged {
        candidate,
        fit,
        mark,
    } in judged
    {
        let Some(explains) = explains(fit, baseline) else {
            continue;
        };
        match sets.iter_mut().find(|(same, _)| *same == mark) {
            Some((_, set)) => set.mistakes.push(candidate.slips),
            None => sets.push((
                mark,
                Set {
                    mistakes: vec![candidate.slips],
                    explains,
                    fit,
                    conversion: candidate.conversion,
                    telling: None,
                },
            )),
        }
    }
    let mut sets: Vec<Set> = sets.into_iter().map(|(_, set)| set).collect();
    let Some(best) = sets.first().map(|set| (set.explains, set.fit)) else {
        return sets;
    };
    // What is much worse than the best is not worth a reader's time.
    sets.retain(|set| {
        set.explains == best.0 && set.fit.far <= 2 * best.1.far && set.fit.off <= 2 * best.1.off
    });
    for set in &mut sets {
        let reported = |mistake: &Vec<&Slip>| -> usize {
            mistake.iter().map(|slip| slip.evidence.len()).sum()
        };
        set.mistakes
            .sort_by_key(|mistake| std::cmp::Reverse(reported(mistake)));
    }
    sets
}

fn explains(fit: Fit, without: Fit) -> Option<Explains> {
    let half = if without.far > 0 {
        2 * fit.far <= without.far && fit.off <= without.off
    } else {
        2 * fit.off <= without.off
    };
    if fit.off == 0 {
        Some(Explains::All)
    } else if fit.far == 0 && without.far > 0 {
        Some(Explains::AllButOneLevel)
    } else {
        half.then_some(Explains::Most)
    }
}
