//! The search: which slips, in which of the scenes that may be meant, draw a picture.

use super::antialiasing::{Around, Seen};
use super::candidates::{self, Candidate, Conversion, Evidence, Fit, Judged};
use super::chosen;
use super::fitted::fitted;
use super::near::{Near, near};
use super::scene::Scene;
use super::{Explains, Set};
use crate::reading::Reading;
use slips::{Program, Slip};

/// How many pixels are compared after the first glance.
const FIRST_LOOK: u32 = 2000;
/// How many are compared where only those at edges tell.
const LOOK_AT_EDGES: u32 = 10_000;
/// How many are compared then: all of a picture 200 pixels wide.
const SECOND_LOOK: u32 = 25_000;
/// How many are compared of what seems to explain everything: all of a picture 800 pixels
/// wide.
const LAST_LOOK: u32 = 400_000;
/// How many candidates are worth a longer look than a glance.
const FEW: usize = 48;
/// How many are worth the longest: more than any set has mistakes.
const FEWER: usize = 16;
/// How many pixels are compared where thousands of pairs have to be judged.
const GLANCE: u32 = 64;
/// In how many scenes two slips are looked for: the nearest ones.
const FOR_PAIRS: usize = 4;
/// In how many scenes anything else is.
const NEARBY: usize = 2;

/// A reader's picture, and the scenes that it may be meant to show.
pub(super) struct Search<'a> {
    pub(super) reading: &'a Reading,
    /// Whether it has numbers that are none.
    pub(super) has_no_levels: bool,
    /// As the editions have them: the nearest first.
    pub(super) scenes: Vec<Scene>,
    /// With colors of the reader's own, where there are some.
    pub(super) chosen: Vec<Scene>,
}

impl<'a> Search<'a> {
    pub(super) fn new(scene: &Scene, reading: &'a Reading) -> Self {
        let fitting = scene.by_editions(reading.width, reading.height);
        let scenes = nearest_first(fitting.collect(), reading);
        let chosen = scenes
            .iter()
            .filter_map(|scene| chosen::chosen(scene, reading));
        Self {
            reading,
            has_no_levels: reading.outside().is_some(),
            chosen: nearest_first(chosen.collect(), reading),
            scenes,
        }
    }

    /// The scene whose right picture comes nearest.
    pub(super) fn nearest(&self) -> Scene {
        self.scenes[0]
    }

    /// The sets of single slips: of the scene in which they explain most. In a shape that
    /// is not the chapter's, a slip may have given it.
    pub(super) fn single_slips(&self) -> Vec<Set> {
        let own_shape = self.scenes.iter().map(|scene| scene.in_own_shape());
        let mut scenes: Vec<Scene> = match self.scenes[0].has_another_shape() {
            true => own_shape.chain(self.scenes.iter().copied()).collect(),
            false => self.scenes.clone(),
        };
        // The formula of the neighboring chapter draws the same picture.
        let neighbors = nearby(&self.scenes).iter();
        scenes.extend(neighbors.filter_map(|scene| scene.with_the_other_formula()));
        self.best(&scenes, |looks| looks.single_slips())
    }

    /// What the picture is if it is right but for how it was drawn, or in colors of the
    /// reader's own to the last bit.
    pub(super) fn near(&self) -> Option<Near> {
        let in_colors = || self.near_in_colors().filter(Near::is_exact);
        near(&self.scenes, self.reading).or_else(in_colors)
    }

    /// What the picture is if it is right but for colors.
    pub(super) fn near_in_colors(&self) -> Option<Near> {
        near(&self.chosen, self.reading)
    }

    /// The nearest scene, with the reader's colors if there are some, and with spheres or
    /// a field of view of the reader's own.
    pub(super) fn fitted(&self) -> Vec<Scene> {
        if self.has_no_levels || self.reading.is_plain() {
            return Vec::new();
        }
        let nearest = self.chosen.first().unwrap_or(&self.scenes[0]);
        fitted(nearest, self.reading)
    }

    /// The sets of single slips beside what the reader chose.
    pub(super) fn slips_beside(&self, fitted: &[Scene]) -> Vec<Set> {
        let scenes: Vec<Scene> = fitted.iter().chain(nearby(&self.chosen)).copied().collect();
        self.best(&scenes, |looks| looks.single_slips())
    }

    /// The sets of single slips beside colors that are taken from where the slip puts them.
    pub(super) fn slips_in_colors(&self) -> Vec<Set> {
        let places: Vec<u32> =
            candidates::spread(GLANCE, self.reading.pixels.len() as u32).collect();
        let scenes = nearby(&self.scenes).iter().flat_map(|scene| {
            scene.slips().filter_map(|slip| {
                let scene = chosen::chosen_beside(scene, &[slip], self.reading)?;
                let candidate = Candidate::of(&scene, self.reading, &[slip], Conversion::Clamped)?;
                let (fit, _) = candidate.judge(self.reading, &places, 1)?;
                (fit.far <= 1).then_some(scene)
            })
        });
        let scenes: Vec<Scene> = scenes.take(FEWER).collect();
        self.best(&scenes, |looks| looks.single_slips())
    }

    /// The sets of two slips that explain everything.
    pub(super) fn pairs(&self) -> Vec<Set> {
        let mut scenes = self.scenes[..self.scenes.len().min(FOR_PAIRS)].to_vec();
        if self.scenes[0].has_another_shape() {
            scenes.insert(0, self.scenes[0].in_own_shape());
        }
        self.best(&scenes, |looks| looks.pairs())
    }

    /// The sets of single slips that draw the picture with several rays a pixel.
    pub(super) fn antialiased_slips(&self) -> Vec<Set> {
        self.best(nearby(&self.scenes), |looks| looks.antialiased_slips())
    }

    /// Those of the first scene that has some to the last bit, or else the best of all.
    fn best(&self, scenes: &[Scene], find: impl Fn(&Looks) -> Vec<Set>) -> Vec<Set> {
        let conversions: &[Conversion] = match self.has_no_levels {
            true => &[Conversion::Printed],
            false => &[Conversion::Clamped, Conversion::Wrapped],
        };
        let mut best: Vec<Set> = Vec::new();
        for &conversion in conversions {
            // Few programs print what wraps around: once for the nearest scene is enough.
            let scenes = match conversion {
                Conversion::Wrapped => &scenes[..scenes.len().min(1)],
                _ => scenes,
            };
            for scene in scenes {
                let looks = Looks::new(*scene, &self.nearest(), self.reading, conversion);
                let found = find(&looks);
                let is_better = match (found.first(), best.first()) {
                    (Some(found), Some(best)) => found.is_better_than(best),
                    (found, _) => found.is_some(),
                };
                if is_better {
                    best = found;
                }
                if best.first().is_some_and(Set::is_exact) {
                    return best;
                }
            }
        }
        best
    }
}

fn nearby(scenes: &[Scene]) -> &[Scene] {
    &scenes[..scenes.len().min(NEARBY)]
}

/// The scenes whose right pictures come nearest first; of equals, the first as before.
fn nearest_first(scenes: Vec<Scene>, reading: &Reading) -> Vec<Scene> {
    let places: Vec<u32> = candidates::spread(FIRST_LOOK, reading.pixels.len() as u32).collect();
    let fit = |scene: &Scene| {
        let right = Candidate::of(scene, reading, &[], Conversion::Clamped);
        let judged = right.and_then(|right| right.judge(reading, &places, places.len()));
        judged.map_or(Fit::nothing(places.len()), |(fit, _)| fit)
    };
    let mut scenes: Vec<(Fit, Scene)> = scenes
        .into_iter()
        .map(|scene| (fit(&scene), scene))
        .collect();
    // Where much is wrong, a few pixels more or less say nothing about the edition.
    let share = |count: usize, parts: usize| (parts * count).div_ceil(places.len());
    scenes.sort_by_key(|&(fit, _)| match share(fit.far, 10) {
        0 | 1 => (0, fit.far, fit.off),
        far => (far, share(fit.off, 50).min(45), 0),
    });
    scenes.into_iter().map(|(_, scene)| scene).collect()
}

impl Set {
    /// Whether it explains more of the picture. By a little, it may be so by chance.
    fn is_better_than(&self, other: &Self) -> bool {
        if self.explains == Explains::Most && other.explains == Explains::Most {
            5 * self.fit.far < 4 * other.fit.far
        } else {
            (self.explains, self.fit) < (other.explains, other.fit)
        }
    }
}

/// Looks of growing length at a picture that may show one scene.
struct Looks<'a> {
    scene: Scene,
    reading: &'a Reading,
    conversion: Conversion,
    /// What the scene's own program draws, if it has the picture's shape.
    right: Option<Candidate>,
    /// What that of the nearest scene draws.
    nearest: Option<Candidate>,
    evidence: Evidence<'a>,
}

impl<'a> Looks<'a> {
    fn new(scene: Scene, nearest: &Scene, reading: &'a Reading, conversion: Conversion) -> Self {
        let right = Candidate::of(&scene, reading, &[], conversion);
        let nearest = Candidate::of(nearest, reading, &[], conversion);
        let evidence = Evidence::new(reading, right.as_ref());
        Self {
            scene,
            reading,
            conversion,
            right,
            nearest,
            evidence,
        }
    }

    fn program(&self, slips: &[&'static Slip]) -> Option<Candidate> {
        Candidate::of(&self.scene, self.reading, slips, self.conversion)
    }

    /// How well the scene's own program does at these places.
    ///
    /// In another shape than the chapter's there is no right program. Then every pixel has
    /// to be explained, if only by its being there.
    fn without_slips(&self, places: &[u32]) -> (Fit, Option<u64>) {
        let right = self.right.as_ref();
        let judged = right.and_then(|right| right.judge(self.reading, places, places.len()));
        match judged {
            Some((fit, mark)) => (fit, Some(mark)),
            None => (Fit::nothing(places.len()), None),
        }
    }

    /// How many pixels may stay far off for an explanation to be one. What does not
    /// explain half of what is wrong is not reported. Some more is let through, because a
    /// few pixels don't tell exactly.
    fn most(&self, places: &[u32]) -> usize {
        self.without_slips(places).0.far * 3 / 4
    }

    fn single_slips(&self) -> Vec<Set> {
        let glance = self.evidence.places(GLANCE);
        let singles = self.scene.slips().filter_map(|slip| self.program(&[slip]));
        let most = self.most(&glance);
        self.explained_by(candidates::best(self.reading, singles, &glance, most))
    }

    /// Two slips explain a lot by chance, so they have to explain everything.
    fn pairs(&self) -> Vec<Set> {
        let slips: Vec<&'static Slip> = self.scene.slips().collect();
        let pairs = (0..slips.len())
            .flat_map(|n| slips[n + 1..].iter().map(move |&other| (n, other)))
            .filter_map(|(n, other)| self.program(&[slips[n], other]));
        let glance = self.evidence.places(GLANCE);
        let mut sets = self.explained_by(candidates::best(self.reading, pairs, &glance, 0));
        let is_far_off = self.without_slips(&glance).0.far > 0;
        sets.retain(|set| set.is_exact() || (set.is_enough() && is_far_off));
        sets
    }

    /// What the picture is with several rays a pixel, beside a program's with one.
    fn seen(&self, program: &Program, places: &[u32]) -> Seen {
        let camera = program.camera(self.reading.width);
        let mut seen = Seen::default();
        for &n in places {
            let found = self.reading.pixels[n as usize];
            seen.add(&Around::of(program, &camera, n), found, 1);
        }
        seen
    }

    /// A slip has to explain much that the right program does not: many a small shift and
    /// every rounding is lost in several rays.
    fn antialiased_slips(&self) -> Vec<Set> {
        let [glance, few] = [GLANCE, LOOK_AT_EDGES].map(|count| self.evidence.places(count));
        let right = self.seen(&self.scene.program(&[]), &few);
        let plain = self.scene.slips().filter_map(|slip| {
            let candidate = self.program(&[slip])?;
            let program = self.scene.program(&[slip]);
            let at_a_glance = self.seen(&program, &glance);
            if 10 * at_a_glance.strange > at_a_glance.compared {
                return None;
            }
            let seen = self.seen(&program, &few);
            let (_, mark) = candidate.judge(self.reading, &few, few.len())?;
            let fit = Fit {
                far: seen.strange,
                off: seen.off,
                compared: few.len(),
            };
            let is_better = 3 * seen.strange < right.strange;
            (is_better && seen.is_antialiased()).then_some(Judged {
                candidate,
                fit,
                mark,
            })
        });
        let mut plain: Vec<Judged> = plain.collect();
        plain.sort_by_key(|judged| judged.fit);
        let best = plain.first().map(|judged| judged.mark);
        plain.retain(|judged| Some(judged.mark) == best);
        let mistakes = plain.iter().map(|judged| judged.candidate.slips.clone());
        let mistakes: Vec<_> = mistakes.collect();
        plain
            .first()
            .map(|judged| Set {
                scene: self.scene,
                mistakes,
                explains: Explains::Antialiased,
                fit: judged.fit,
                conversion: self.conversion,
                telling: None,
            })
            .into_iter()
            .collect()
    }

    /// What is left of the candidates after a longer look, and after the longest, as sets.
    fn explained_by(&self, mut found: Vec<Judged>) -> Vec<Set> {
        let many = self.evidence.places(SECOND_LOOK);
        let (without, draws_right) = self.without_slips(&many);
        if without.off == 0 {
            return Vec::new();
        }
        for (count, places) in [(FEW, &self.evidence.places(FIRST_LOOK)), (FEWER, &many)] {
            let most = self.most(places);
            let best_of_them = found.into_iter().map(|judged| judged.candidate).take(count);
            found = candidates::best(self.reading, best_of_them, places, most);
        }
        found.retain(|judged| draws_right != Some(judged.mark));
        if found.iter().any(|judged| judged.fit.off == 0) {
            let all = self.evidence.places(LAST_LOOK);
            let exact = found.into_iter().filter(|judged| judged.fit.off == 0);
            let exact = exact.map(|judged| judged.candidate);
            let found = candidates::best(self.reading, exact, &all, all.len());
            return self.sets(found, self.without_slips(&all).0, &all);
        }
        self.sets(found, without, &many)
    }

    /// Puts together what draws the same picture, and keeps what explains enough.
    fn sets(&self, judged: Vec<Judged>, without: Fit, places: &[u32]) -> Vec<Set> {
        let most = self.most_to_be_left(places);
        let mut sets: Vec<(u64, Set)> = Vec::new();
        for Judged {
            candidate,
            fit,
            mark,
        } in judged
        {
            let Some(explains) = explains(fit, without) else {
                continue;
            };
            let is_idle = || fit.far > most || !self.is_seen(&candidate, places);
            if explains == Explains::Most && is_idle() {
                continue;
            }
            match sets.iter_mut().find(|(same, _)| *same == mark) {
                Some((_, set)) => set.mistakes.push(candidate.slips),
                None => sets.push((
                    mark,
                    Set {
                        scene: self.scene,
                        mistakes: vec![candidate.slips],
                        explains,
                        fit,
                        conversion: self.conversion,
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
            let reported =
                |mistake: &Vec<&Slip>| -> usize { mistake.iter().map(|slip| slip.reports()).sum() };
            set.mistakes
                .sort_by_key(|mistake| std::cmp::Reverse(reported(mistake)));
        }
        sets
    }

    /// How many pixels a mistake may leave far off: in this edition it has to do better
    /// than another edition does without any.
    fn most_to_be_left(&self, places: &[u32]) -> usize {
        let nearest = self.nearest.as_ref();
        let judged = nearest.and_then(|nearest| nearest.judge(self.reading, places, places.len()));
        judged.map_or(places.len(), |(fit, _)| fit.far / 2)
    }

    /// Whether what the candidate does to the right picture is mostly seen in the
    /// reader's. One that makes a sphere vanish does not draw most of a picture that
    /// shows it, however much else it explains.
    fn is_seen(&self, candidate: &Candidate, places: &[u32]) -> bool {
        let Some(right) = &self.right else {
            return true;
        };
        let changed = places
            .iter()
            .filter(|&&n| candidates::distance(candidate.pixel(n), right.pixel(n)) > 1);
        let (mut count, mut seen) = (0, 0);
        for &n in changed {
            count += 1;
            let found = self.reading.pixels[n as usize];
            seen += usize::from(candidates::distance(candidate.pixel(n), found) <= 1);
        }
        2 * seen >= count
    }
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
