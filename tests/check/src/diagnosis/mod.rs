//! Diagnosis by synthesis: draws what each known mistake draws, and compares.
//!
//! Every slip is a program, so the question is which programs draw *this*
//! picture. A look at a few thousand pixels leaves a handful, and these are
//! compared pixel by pixel. Slips that draw the same picture are one [`Set`]:
//! the picture can't tell them apart, but a probe may.
//!
//! What a reader may have chosen, and not mistaken, is asked first: the edition of the
//! book, the shape, colors, several rays a pixel. See [`Near`].

mod another;
mod antialiasing;
mod candidates;
mod chosen;
mod curve;
mod fitted;
mod near;
mod scene;
mod search;
mod shape;
mod sight;
mod telling;
mod wording;

use crate::reading::Reading;
use slips::Slip;

pub(crate) use candidates::spread;
pub use candidates::{Conversion, Fit};
pub use curve::Curve;
pub use near::{But, Near};
pub use scene::{Chosen, Scene};
use search::Search;
pub use shape::giving as slips_giving;
pub use telling::Telling;
pub use wording::names_of;

/// What may have drawn a picture that is not right to the last bit.
#[derive(Clone, Debug)]
pub struct Diagnosis {
    /// The scene that it shows, by the edition that comes nearest.
    pub scene: Scene,
    /// What it is if it is right but for something that is no mistake.
    pub near: Option<Near>,
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
    /// The scene that they were made in.
    pub scene: Scene,
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
    /// Every pixel, if it is the mean of several rays.
    Antialiased,
    /// At least half of the pixels that are wrong.
    Most,
}

/// How many sets a reader is told of.
const MOST_SETS: usize = 3;

/// Finds what may have drawn the reader's picture of the scene, which is not right to
/// the last bit in any edition.
///
/// Asked in this order, until something explains it: one slip, to the last bit; a choice
/// of the reader's own, to the last bit; two slips, likewise; one slip but for single
/// levels; a choice, as far as can be seen; and then slips that explain most of it.
pub fn diagnose(scene: &Scene, reading: &Reading) -> Diagnosis {
    let search = Search::new(scene, reading);
    let scene = search.nearest();
    let found = |near: Option<Near>, sets: Vec<Set>| Diagnosis {
        scene: match (&near, sets.first()) {
            (Some(near), _) => near.scene,
            (None, Some(set)) => set.scene,
            (None, None) => scene,
        },
        near,
        sets,
        sights: Vec::new(),
    };
    let single = search.single_slips();
    if single.first().is_some_and(Set::is_exact) {
        return found(None, told(single));
    }
    let near = search.near();
    if near.as_ref().is_some_and(Near::is_exact) {
        return found(near, Vec::new());
    }
    let pairs = search.pairs();
    if pairs.first().is_some_and(Set::is_exact) {
        return found(None, told(pairs));
    }
    // What both explain but for single levels is explained by that which leaves fewer.
    let rounded = near.as_ref().and_then(Near::rounded);
    let is_better = |set: &Set| {
        let left = set.fit.off as f64 / set.fit.compared as f64;
        set.is_enough() && rounded.is_none_or(|rounded| left < rounded)
    };
    if single.first().is_some_and(is_better) {
        return found(None, told(single));
    }
    if near.is_some() {
        return found(near, Vec::new());
    }
    let antialiased = search.antialiased_slips();
    if !antialiased.is_empty() {
        return found(None, told(antialiased));
    }
    if let near @ Some(_) = search.near_in_colors() {
        return found(near, Vec::new());
    }
    let fitted = search.fitted();
    if let near @ Some(_) = near::near(&fitted, reading) {
        return found(near, Vec::new());
    }
    let mut beside = search.slips_beside(&fitted);
    if !beside.first().is_some_and(Set::is_enough) {
        beside.extend(search.slips_in_colors());
    }
    let mut sets: Vec<Set> = [single, beside, pairs].concat();
    sets.sort_by_key(|set| set.explains);
    let sights = match sets.iter().any(Set::is_enough) {
        true => Vec::new(),
        false => sight::sights(&scene, reading),
    };
    Diagnosis {
        sights,
        ..found(None, told(sets))
    }
}

/// The scene by the edition whose right picture comes nearest to the reader's.
pub(crate) fn nearest(scene: &Scene, reading: &Reading) -> Scene {
    Search::new(scene, reading).nearest()
}

/// Those sets that a reader is told of, with what tells their mistakes apart.
fn told(mut sets: Vec<Set>) -> Vec<Set> {
    sets.truncate(MOST_SETS);
    for set in &mut sets {
        set.telling = telling::apart(&set.scene, &set.mistakes);
    }
    sets
}

impl Set {
    /// Whether every pixel that was compared is explained to the last bit.
    pub fn is_exact(&self) -> bool {
        self.explains == Explains::All
    }

    /// Whether nothing is left to explain but single levels.
    pub fn is_enough(&self) -> bool {
        self.explains != Explains::Most
    }
}
