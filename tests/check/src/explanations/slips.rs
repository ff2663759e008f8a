//! A slip, or two that were made together.

use super::right::{by_editions, shape, steps};
use super::{Conversion, Evidence, Hypothesis};
use crate::mutants;
use crate::sources::Said;
use ::slips::{Edition, Slip};

/// One of some hundred slips, where one program in two has one.
pub(super) const ONE: f64 = 8.0;
/// Two slips are twice as much, and a little more: whoever made one looks for it.
pub(crate) const TWO: f64 = 18.0;
/// The formula of the neighboring chapter in its place.
const OTHER_FORMULA: f64 = 4.0;
/// A cast to a byte, as few programs have it.
const WRAPPED: f64 = 4.0;

/// Bits of slips beside what else there is.
pub(crate) fn name_of(slips: &[&Slip]) -> f64 {
    [0.0, ONE, TWO][slips.len()]
}

/// Programs with one slip.
pub(crate) fn single(evidence: &Evidence) -> Vec<Hypothesis> {
    let scenes = scenes(evidence);
    let other_formula = scenes.iter().filter_map(|it| {
        Some(Hypothesis {
            scene: it.scene.with_the_other_formula()?,
            name: it.name + OTHER_FORMULA,
            ..it.clone()
        })
    });
    let wrapped = scenes.first().filter(|_| !evidence.has_no_levels);
    let wrapped = wrapped.map(|it| Hypothesis {
        conversion: Conversion::Wrapped,
        name: it.name + WRAPPED,
        ..it.clone()
    });
    let all: Vec<Hypothesis> = other_formula.chain(wrapped).collect();
    let all = scenes.into_iter().chain(all);
    let singles = all.flat_map(|right| with_a_slip(evidence, &right, ONE));
    singles.map(|it| evidence.weighed(it)).collect()
}

/// One change in some hundred places of a chapter, in each of which some ten others could
/// stand.
const MUTANT: f64 = 11.0;

/// One of the few dozen expressions of a reader's that are not the chapter's.
const TYPED: f64 = 6.0;

/// The chapter's own text with one change that the catalogue doesn't know.
pub(crate) fn mutants(evidence: &Evidence, edition: Edition) -> Vec<Hypothesis> {
    changed(
        evidence,
        edition,
        mutants::of(evidence.scene.chapter),
        MUTANT,
    )
}

/// The chapter's own text with an expression as the reader has it.
pub(crate) fn typed(evidence: &Evidence, edition: Edition) -> Vec<Hypothesis> {
    let typed = mutants::typed(evidence.scene.chapter, &evidence.known.sources);
    changed(evidence, edition, typed, TYPED)
}

fn changed(
    evidence: &Evidence,
    edition: Edition,
    changes: impl IntoIterator<Item = &'static Slip>,
    name: f64,
) -> Vec<Hypothesis> {
    let rights = by_editions(evidence, evidence.scene, name).into_iter();
    let mut rights = rights.filter(|it| it.scene.edition == edition);
    let Some(right) = rights.next().filter(|it| it.scene.probe.is_none()) else {
        return Vec::new();
    };
    // They are made of version 4, and its camera is no other edition's.
    let is_run = |slip: &&Slip| edition == Edition::V4 || !slip.is_of_the_camera();
    let changes = changes.into_iter().filter(is_run);
    let changes = changes.filter(|slip| evidence.may_be_wrong(slip));
    let with = |slip| Hypothesis {
        slips: vec![slip],
        ..right.clone()
    };
    changes.map(with).collect()
}

/// The right program with each slip that can be made in it.
fn with_a_slip(evidence: &Evidence, right: &Hypothesis, name: f64) -> Vec<Hypothesis> {
    let with = |slip| Hypothesis {
        slips: vec![slip],
        name: right.name + name,
        ..right.clone()
    };
    evidence.slips(&right.scene).map(with).collect()
}

/// Programs with two slips. Many pairs draw a picture by chance: where files are known, one
/// of the two is in them.
pub(crate) fn two(evidence: &Evidence) -> impl Iterator<Item = Hypothesis> {
    scenes(evidence).into_iter().flat_map(|right| {
        let slips: Vec<_> = evidence.slips(&right.scene).collect();
        let is_found = |slip: &&Slip| {
            let known = evidence.known;
            known.sources.is_empty() || known.said(slip, &right.scene) == Said::Wrong
        };
        let is_found: Vec<bool> = slips.iter().map(is_found).collect();
        let pairs: Vec<_> = (0..slips.len())
            .flat_map(|n| (n + 1..slips.len()).map(move |other| (n, other)))
            .filter(|&(n, other)| is_found[n] || is_found[other])
            .map(|(n, other)| vec![slips[n], slips[other]])
            .collect();
        pairs.into_iter().map(move |slips| Hypothesis {
            slips,
            name: right.name + TWO,
            ..right.clone()
        })
    })
}

/// The scene by each edition, in the chapter's own shape too where the picture has another.
fn scenes(evidence: &Evidence) -> Vec<Hypothesis> {
    let mut scenes = by_editions(evidence, evidence.scene, 0.0);
    scenes.retain(|it| evidence.is_usual(&it.scene));
    let own_shape = scenes.iter().filter(|it| it.scene.has_another_shape());
    // A slip may give the shape.
    let own_shape = own_shape.map(|it| Hypothesis {
        scene: it.scene.in_own_shape(),
        name: it.name - shape(&it.scene),
        ..it.clone()
    });
    let own_shape: Vec<Hypothesis> = own_shape.collect();
    scenes.extend(own_shape);
    scenes.extend(steps(evidence));
    scenes
}
