//! The judge: of all explanations of a picture the shortest wins.
//!
//! First all are estimated from some pixels, then the likeliest from more, and the few that
//! may win are measured by all of them.

use std::collections::HashSet;

use crate::bits::{self, Pixel};
use crate::evidence::Evidence;
use crate::explanations::{
    But, Degradation, Explanation, Hypothesis, Path, Places, SINGLE, Seen, TWO, antialiased,
    chosen_beside_slips, chosen_otherwise, degradations, doubtful, in_colors, more, mutants,
    name_of, on_a_curve, palette, ramps, right, silhouettes, single, spread, through_the_middle,
    turned, two, typed,
};
use crate::reading::Reading;
use crate::scene::{Chosen, Scene};
use crate::surfaces;
use crate::verdict::TOGETHER;
use ::slips::{Edition, Slip};
use common::rtweekend::Color;

/// What was found.
pub(crate) struct Judgement {
    /// Explanations, the shortest first. The scene itself by some edition is among them.
    pub(crate) found: Vec<Explanation>,
    /// The length of the picture to one who knows nothing.
    pub(crate) unknown: f64,
    /// Whether the scene's picture, where it is just that, tells nothing of it.
    pub(crate) is_strange: bool,
}

/// That nothing is known: one picture in a thousand is no picture of the book at all.
const UNKNOWN: f64 = 10.0;
/// How many pixels are looked at to estimate explanations, and how many may still win
/// after each look (successive halving, Karnin et al., 2013).
const LOOKS: [(u32, usize); 3] = [(300, MANY), (LOOK, FEW), (6000, FEW)];
/// How many tell a little.
const LOOK: u32 = 1500;
/// More than come near a picture by few pixels.
const MANY: usize = 160;
/// More explanations than draw any picture but the right one.
const FEW: usize = 40;
/// How many pictures beside the first one's are measured.
const FEWER: usize = 16;
/// How many pixels of these are measured: those of 6 pictures 400 wide.
const PIXELS: usize = 540_000;
/// The same of those that draw what the first one does: so many times as many.
const ALIKE: usize = 4;
/// After so many pictures that leave so many times as much as the best none is measured.
const MISSES: usize = 3;
const WORSE: f64 = 1.5;
/// What more than this is left of is worth a search for numbers of the reader's own, for
/// several rays and curves: some thirty odd pixels. Less is told pixel by pixel anyway.
const WORTH_A_SEARCH: f64 = 1000.0;

/// What costs more bits a pixel, even to one who knows its neighbors, is no smooth surface:
/// where nothing explains it, no picture of the book's becomes that on any way.
pub(crate) const GRAIN: f64 = 8.0;

/// Names of numbers that are no longer are simple.
const SIMPLE: f64 = 48.0;
/// Of a picture's bits a slip beside numbers of the reader's own leaves one in so many.
const MIXED: f64 = 8.0;
/// The same of several rays a pixel, whose scatter nothing tells.
const SCATTERED: f64 = 1.5;
/// The means of so many rays are no reduced picture's.
const MANY_RAYS: f64 = 36.0;
/// Where more than one pixel in so many is off by more than a level, numbers that were fitted make
/// up for something else: hits are not colored by the normal, spheres are not there.
const LOSSLESS: usize = 500;
/// The same of a part of a larger picture, which keeps each level, but for a cursor.
const CUT: usize = 2000;
/// Of a mean of several rays one pixel in so many may be off, away from edges.
const SMOOTH: usize = 10;
/// What is nearly a picture is off in one pixel of so many.
const NEARLY: usize = 50;
/// How many pixels are looked at where nothing is known of thousands of changes.
const PEEK: u32 = 16;
/// What is shorter than this has been made: a slip that leaves some odd pixels.
const WELL_EXPLAINED: f64 = 100.0;

/// What is shorter than this is a slip whose very line is in the reader's files.
const CONFIRMED: f64 = 11.0;

/// How many pixels are looked at where thousands of pairs have to be estimated.
const GLANCE: u32 = 150;
/// With how many programs it is looked for what happened to the file.
const PROGRAMS: usize = 3;
/// Beside how many slips several rays are looked for.
const SLIPS: usize = 8;

/// Finds the shortest explanations of the evidence.
pub(crate) fn shortest(evidence: &Evidence) -> Judgement {
    let reading = evidence.reading;
    let rights = right(evidence);
    let nearest = nearest(evidence, &rights);
    let drawn = nearest
        .drawn(reading)
        .expect("the scene was fitted to the picture");
    let (alone, beside) = (bits::alone(reading), bits::beside(reading, &drawn));
    let is_strange = alone < beside;
    let alone = alone.min(beside);
    // What is of one color and nothing else, many a mistake draws.
    let alone = match reading.is_plain() {
        true => alone,
        false => alone.min(bits::of_one_color(reading)),
    };
    let unknown = UNKNOWN + evidence.besides(&nearest) + alone;
    let mut search = Search {
        evidence,
        unknown,
        found: vec![nearest.explaining(reading, &drawn)],
    };
    if nearest.scene.step().is_some() || nearest.scene.edition != evidence.scene.edition {
        search.keep(rights[0].measured(reading));
    }
    search.keep(silhouettes(evidence, &rights));
    let singles = rights.iter().cloned().chain(single(evidence));
    let likeliest = search.add(singles.collect::<Vec<_>>(), Some(&drawn), f64::INFINITY);
    search.add_others(&rights, &likeliest);
    search.add_other_editions(&rights);
    search.add_other_slips();
    search.add_colors(&rights);
    let mut found = search.found;
    let one_in = |it: &Explanation| match it.degradation() {
        Some(Degradation::Cropped { .. }) => Some(CUT),
        _ => (it.scene.chosen.is_placed() || it.scene.chosen.shade.is_some()).then_some(LOSSLESS),
    };
    let is_kept = |parts: usize, far: usize| parts * far <= reading.pixels.len();
    found.retain(|it| one_in(it).is_none_or(|parts| is_kept(parts, it.left.far)));
    drop_what_explains_little(&mut found, &evidence.scene);
    drop_losses_of_roundings(&mut found, &evidence.scene);
    drop_changes_like_choices(&mut found);
    // Nor is a change told that nobody has thought of, where it draws only nearly what is there.
    let is_nearly = |it: &Explanation| {
        let is_unnamed = it.slips.iter().any(|slip| slip.name.is_empty());
        is_unnamed && it.but.is_empty() && NEARLY * it.left.off > reading.pixels.len()
    };
    let has_sources = !evidence.known.sources.is_empty();
    found.retain(|it| has_sources || !is_nearly(it));
    found.sort_by(|one, other| one.bits().total_cmp(&other.bits()));
    simplest_first(&mut found);
    Judgement {
        found,
        unknown,
        is_strange,
    }
}

/// Neither a slip nor a sphere of the reader's own is told that leaves one in twenty of the
/// pixels that are wrong without it, or of the bits, but for some odd ones; nor a change of the
/// whole that leaves one in four.
fn drop_what_explains_little(found: &mut Vec<Explanation>, scene: &Scene) {
    let part = |it: &Explanation| match it.seen {
        _ if !it.slips.is_empty() || it.scene.chosen.balls[0].is_some() => Some(20),
        Some(Seen::More(_) | Seen::Said(_)) => Some(4),
        _ => None,
    };
    let is_whole = |it: &Explanation| matches!(it.seen, None | Some(Seen::Little));
    let is_without =
        |it: &&Explanation| part(it).is_none() && is_whole(it) && is_same(&it.scene, scene);
    let without = || found.iter().filter(is_without);
    let wrong = without().map(|it| it.left.far).min();
    let bits = without().map(Explanation::bits).reduce(f64::min);
    found.retain(|it| {
        let explains = |part: usize| {
            Some(part * it.left.far) <= wrong || Some(part as f64 * it.bits()) <= bits
        };
        part(it).is_none_or(explains) || !it.but.is_empty() || it.left.bits < WORTH_A_SEARCH
    });
}

/// Where all is right within a level, edges too, nothing was lost that leaves a quarter of that, nor
/// are there several rays.
fn drop_losses_of_roundings(found: &mut Vec<Explanation>, scene: &Scene) {
    let is_right = |it: &&Explanation| it.slips.is_empty() && is_same(&it.scene, scene);
    let is_rounded = |it: &&Explanation| it.left.far == 0 && it.but.is_empty() && it.seen.is_none();
    let rounded = found.iter().filter(is_right).filter(is_rounded);
    let rounded = rounded.map(Explanation::bits).fold(f64::INFINITY, f64::min);
    let is_lossy = |it: &Explanation| {
        it.degradation().is_some_and(Degradation::is_lossy) || it.but.iter().any(But::is_mean)
    };
    found.retain(|it| !is_lossy(it) || 4.0 * it.bits() < rounded);
}

/// A change that nobody has thought of is none, where it draws what a reader chose.
fn drop_changes_like_choices(found: &mut Vec<Explanation>) {
    let chosen = found.iter().filter(|it| is_choice(it));
    let chosen: HashSet<u64> = chosen.map(|it| it.mark).collect();
    let is_unnamed = |it: &Explanation| it.slips.iter().any(|slip| slip.name.is_empty());
    found.retain(|it| !is_unnamed(it) || !chosen.contains(&it.mark));
}

/// Whether it is the scene in numbers of the reader's own.
fn is_choice(it: &Explanation) -> bool {
    it.slips.is_empty() && is_own(it)
}

/// Whether it has numbers that a reader may well have chosen: a sky that ends in black may have lost
/// a term.
pub(crate) fn is_own(it: &Explanation) -> bool {
    let chosen = it.scene.chosen;
    let has_black = chosen.sky.is_some_and(|sky| sky.contains(&Color::ZERO));
    chosen != Chosen::default() && !chosen.looks_like_a_slip() && !has_black
}

/// Puts first what has the shortest name of all that leave the same noise: lengths of
/// noise vary by the square root of their bits, and single pixels are no noise.
fn simplest_first(found: &mut [Explanation]) {
    let best = &found[0];
    let is_lossy = best.degradation().is_some_and(Degradation::is_lossy);
    if best.left.is_one_by_one && !is_lossy {
        return;
    }
    let most = best.bits() + best.give();
    let alike = found.iter().take_while(|it| it.bits() <= most);
    let simplest = alike
        .enumerate()
        .min_by(|(_, one), (_, other)| one.name.total_cmp(&other.name));
    if let Some((at, _)) = simplest {
        found[..=at].rotate_right(1);
    }
}

/// The scene itself by the edition whose picture comes nearest, with nothing of the reader's own.
fn nearest(evidence: &Evidence, rights: &[Hypothesis]) -> Hypothesis {
    let places = Places::new(evidence.reading, None, LOOK);
    let is_asked = |it: &&Hypothesis| {
        is_same(&it.scene, &evidence.scene) && it.scene.chosen == Chosen::default()
    };
    let length = |it: &&Hypothesis| {
        let length = it.estimated(evidence.reading, &places, f64::INFINITY);
        length.unwrap_or(f64::INFINITY)
    };
    let asked = rights.iter().filter(is_asked);
    let nearest = asked
        .map(|it| (length(&it), it))
        .min_by(|one, other| one.0.total_cmp(&other.0));
    nearest.expect("there is an edition").1.clone()
}

/// Whether it is the same chapter and probe, at whatever step.
pub(crate) fn is_same(one: &Scene, other: &Scene) -> bool {
    (one.chapter, one.probe) == (other.chapter, other.probe)
}

struct Search<'a> {
    evidence: &'a Evidence<'a>,
    /// The length of the picture to one who knows nothing.
    unknown: f64,
    found: Vec<Explanation>,
}

impl Search<'_> {
    fn best(&self) -> &Explanation {
        self.best_of(|_| true)
    }

    /// Keeps these, but for numbers that nobody types: they make up for something else.
    fn keep(&mut self, some: impl IntoIterator<Item = Explanation>) {
        let Reading { width, height, .. } = *self.evidence.reading;
        let ratio = f64::from(width) / f64::from(height);
        let some = some.into_iter();
        let typed = some.filter(|it| it.scene.chosen.is_typed(ratio));
        self.found.extend(typed);
    }

    fn best_of(&self, is_meant: impl Fn(&Explanation) -> bool) -> &Explanation {
        let shortest =
            |one: &&Explanation, other: &&Explanation| one.bits().total_cmp(&other.bits());
        let meant = self.found.iter().filter(|it| is_meant(it));
        meant.min_by(shortest).expect("the nearest is there")
    }

    /// Measures what may win of these; `drawn` is the best that is known. Returns the
    /// likeliest, the first first.
    fn add(
        &mut self,
        all: impl IntoIterator<Item = Hypothesis>,
        drawn: Option<&[Pixel]>,
        most: f64,
    ) -> Vec<Hypothesis> {
        let reading = self.evidence.reading;
        let mut some: Vec<(f64, Hypothesis)> = Vec::new();
        let mut all: Vec<Hypothesis> = all.into_iter().collect();
        let mut most = most;
        for (count, few) in LOOKS {
            let places = Places::new(reading, drawn, count);
            some = likeliest(self.evidence, all, &places, most, few);
            all = some.iter().map(|(_, it)| it.clone()).collect();
            most = f64::INFINITY;
        }
        self.measure(&some);
        all
    }

    /// Measures what may win of these, the likeliest first.
    fn measure(&mut self, some: &[(f64, Hypothesis)]) {
        let reading = self.evidence.reading;
        // Where levels were lost, estimates tell only which is the likeliest.
        let is_lossy = |it: &Hypothesis| it.degradation.is_some_and(Degradation::is_lossy);
        let pictures = (PIXELS / reading.pixels.len()).clamp(1, FEWER);
        let left = |(length, it): &(f64, Hypothesis)| length - it.name;
        let are_alike = |one: f64, other: f64| (one - other).abs() <= 1e-6;
        let least = some.first().map_or(0.0, left);
        let is_least = |it: &(f64, Hypothesis)| {
            are_alike(left(it), least) && it.1.scene.chosen == Chosen::default()
        };
        let names = some.iter().filter(|it| is_least(it)).map(|(_, it)| it.name);
        let shortest = names.fold(f64::INFINITY, f64::min);
        let (mut others, mut all_measured, mut worse) = (0, 0, 0);
        let mut known: Vec<(f64, Explanation)> = Vec::new();
        for it in some {
            // Who draws the same leaves the same, but for roundings. All slips that do and whose
            // names are short enough are told; of numbers that a reader may have typed, the simplest.
            if is_least(it) && it.1.name > shortest + TOGETHER {
                continue;
            }
            others += usize::from(!is_least(it));
            all_measured += 1;
            let most = may_win(self.best().bits().min(self.unknown));
            let are_enough = others > pictures || all_measured > ALIKE * pictures;
            if are_enough || worse == MISSES || it.0 > most && !is_lossy(&it.1) {
                break;
            }
            // Of noise nobody tells by single pixels who drew it.
            let mut alike = known
                .iter()
                .filter(|(other, _)| are_alike(*other, left(it)));
            if let Some((_, by)) = alike.find(|(_, by)| !by.left.is_one_by_one) {
                self.keep([it.1.leaving(by.left, by.mark)]);
            } else if let Some(measured) = it.1.measured(reading) {
                let is_worse = measured.bits() > WORSE * self.best().bits();
                worse = if is_worse { worse + 1 } else { 0 };
                known.push((left(it), measured.clone()));
                self.keep([measured]);
            }
        }
    }

    /// What is no single slip, the surest first.
    fn add_others(&mut self, rights: &[Hypothesis], likeliest: &[Hypothesis]) {
        let grain = GRAIN * self.evidence.reading.pixels.len() as f64;
        if self.unknown > grain && self.best().bits() >= self.unknown {
            return;
        }
        // No chapter draws grain inside right outlines, and no loss leaves their sky but few colors.
        let is_grainy = |it: &Explanation| {
            matches!(
                it.seen,
                Some(Seen::Shaded {
                    is_grainy: true,
                    ..
                })
            )
        };
        let is_of_few = palette(self.evidence.reading).is_some();
        if !is_of_few && self.is_shorter(self.unknown, 1.2, is_grainy) {
            return;
        }
        // Roundings of a right picture are those of another precision.
        let is_rounded = |it: &Explanation| {
            let is_right = it.slips.is_empty() && it.seen.is_none();
            is_right && it.left.is_rounding(self.evidence.reading.pixels.len())
        };
        if self.evidence.known.sources.is_empty() && is_rounded(self.best()) {
            return;
        }
        let nearest = self.nearest_of(rights);
        self.add_several_rays(rights, likeliest, &nearest);
        if self.is_of_many_rays() {
            self.add_more();
            return;
        }
        let tried = self.tried(rights, likeliest);
        self.add_degraded(&tried, degradations(self.evidence, &tried));
        if self.is_degraded() {
            return;
        }
        if self.is_grain() {
            self.add_degraded(&tried, doubtful(self.evidence.reading));
            return;
        }
        let chosen = self.add_changed(&nearest);
        if self.is_worth_a_search() {
            self.keep(ramps(self.evidence, &rights[0]));
        }
        self.add_more();
        if !self.is_antialiased(self.unknown) {
            self.add_changes(typed);
            self.add_changes(mutants);
            self.add_pairs();
            self.add_chosen_beside_slips(&nearest, &chosen);
            if !self.is_well_explained() {
                self.add_degraded(&tried, doubtful(self.evidence.reading));
            }
        }
    }

    /// Whether many pixels are off, and nothing but chance tells which.
    fn is_grain(&self) -> bool {
        let (best, reading) = (self.best(), self.evidence.reading);
        let is_right = best.slips.is_empty() && best.but.is_empty() && best.seen.is_none();
        let is_noise = is_right && best.left.is_noise(reading.pixels.len());
        let drawn = || best.program().drawn(reading);
        is_noise && drawn().is_some_and(|drawn| bits::is_grain(reading, &drawn, 1))
    }

    /// Whether the best leaves so little of the picture as no chance does.
    fn is_well_explained(&self) -> bool {
        MIXED * self.best().bits() < self.unknown
    }

    /// Changes that nobody has thought of, where nothing else explains it all.
    fn add_changes(&mut self, changes: fn(&Evidence, Edition) -> Vec<Hypothesis>) {
        let (evidence, reading) = (self.evidence, self.evidence.reading);
        let enough = match evidence.known.sources.is_empty() {
            true => WELL_EXPLAINED,
            false => CONFIRMED,
        };
        // A slip in another edition draws much by chance, and so do colors that anyone may choose.
        let is_enough = |it: &Explanation| {
            let is_asked = it.scene.edition == evidence.scene.edition;
            is_asked && it.scene.chosen == Chosen::default() && it.bits() < enough
        };
        // Of changes that draw what a reader chose none is told.
        let is_chosen = is_choice(self.best()) && self.best().left.is_nothing();
        if is_chosen || self.found.iter().any(is_enough) {
            return;
        }
        // A single change that is found has to explain most of what is left.
        let most = (self.best().bits() / 4.0).max(WELL_EXPLAINED);
        let Some((best, drawn)) = self.nearest_drawn() else {
            return;
        };
        let places = Places::new(reading, Some(&drawn), PEEK);
        let mut editions = vec![evidence.scene.edition, best.scene.edition];
        editions.dedup();
        let changes = editions.iter().flat_map(|&it| changes(evidence, it));
        let near = changes.filter_map(|it| {
            let length = it.estimated(reading, &places, most)?;
            Some((length, it))
        });
        let mut near: Vec<(f64, Hypothesis)> = near.collect();
        near.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        near.truncate(MANY);
        // Whose name alone is longer than what is known has nothing to add.
        let shortest = self.best().bits();
        let weighed = near.into_iter().map(|(_, it)| evidence.weighed(it));
        let weighed = weighed.filter(|it| it.name < shortest);
        let places = Places::new(reading, Some(&drawn), GLANCE);
        let some = likeliest(evidence, weighed, &places, most, FEW);
        let some = some.into_iter().map(|(_, it)| it).take(FEWER);
        self.add(some, Some(&drawn), f64::INFINITY);
    }

    /// Programs with which it is looked for what happened to the file.
    fn tried(&self, rights: &[Hypothesis], likeliest: &[Hypothesis]) -> Vec<Hypothesis> {
        // What right pictures tell of a size or a place is told first, in any shape.
        let (own, others): (Vec<_>, Vec<_>) = likeliest
            .iter()
            .partition(|it| !it.scene.has_another_shape());
        let tried = own.into_iter().chain(others).take(PROGRAMS);
        let tried = rights.iter().take(1).chain(tried).map(|it| Hypothesis {
            scene: it.scene.in_own_shape(),
            ..it.clone()
        });
        tried.collect()
    }

    /// Right pictures, and slips', to which something happened between program and file.
    fn add_degraded(&mut self, tried: &[Hypothesis], mut found: impl Iterator<Item = Degradation>) {
        let evidence = self.evidence;
        let places = Places::new(evidence.reading, None, LOOK);
        while self.best().left.bits >= WORTH_A_SEARCH
            && let Some(degradation) = found.next()
        {
            let evidence = evidence.degraded(degradation);
            let all = right(&evidence).into_iter().chain(single(&evidence));
            let all: Vec<Hypothesis> = all.collect();
            let best = self.best().program();
            let is_tried = |it: &&Hypothesis| {
                let mut tried = tried.iter().chain([&best]);
                tried.any(|tried| tried.is_same_program(it))
            };
            let shortest = self.best().bits();
            // What tells the loss is known, and estimates are wrong in the rest alone.
            let name = evidence.degradation.map_or(0.0, |(_, name)| name);
            let most = match degradation.is_lossy() {
                true => f64::INFINITY,
                false => name + may_win(shortest.min(self.unknown) - name),
            };
            let may_win =
                |it: &&Hypothesis| it.estimated(evidence.reading, &places, most).is_some();
            let surest = all.iter().filter(is_tried).filter(may_win);
            let surest = surest.filter_map(|it| it.measured(evidence.reading));
            let surest: Vec<Explanation> = surest.collect();
            // A loss that brings none of the likeliest programs nearer has not happened.
            if degradation.is_lossy() && surest.iter().all(|it| it.bits() >= shortest) {
                continue;
            }
            self.keep(surest.iter().cloned());
            let before = self.found.len();
            self.add(all, None, most);
            let added = self.found.split_off(before);
            let is_new = |it: &Explanation| {
                let mut surest = surest.iter().map(Explanation::program);
                !surest.any(|surest| surest.is_same_program(&it.program()))
            };
            self.keep(added.into_iter().filter(is_new));
        }
    }

    /// Whether something happened to the file, and to think so is so much shorter that
    /// nothing else is looked for. Rows and columns are missing by slips as well.
    fn is_degraded(&self) -> bool {
        let is_changed = |it: &Explanation| {
            let way = it.degradation();
            way.is_some_and(|way| !matches!(way, Degradation::Cropped { .. }))
        };
        self.is_shorter(self.unknown, 4.0, is_changed)
    }

    /// The same of several rays a pixel that lie where they should.
    fn is_antialiased(&self, unknown: f64) -> bool {
        // Away from edges it is right, or it makes up for what lies elsewhere.
        let all = self.evidence.reading.pixels.len();
        self.is_shorter(unknown, 1.2, |it| {
            let is_mean = it.but.first().is_some_and(But::is_mean);
            is_mean && it.seen.is_none() && SMOOTH * it.left.off <= all
        })
    }

    fn is_shorter(
        &self,
        unknown: f64,
        times: f64,
        is_meant: impl Fn(&Explanation) -> bool,
    ) -> bool {
        let best = self.best();
        let others = self.best_of(|it| !is_meant(it));
        is_meant(best) && best.bits() < unknown && others.bits() > times * best.bits()
    }

    /// The scene by the edition that was asked for, by the nearest one, and the nearest other
    /// scene.
    fn nearest_of(&self, rights: &[Hypothesis]) -> Vec<Hypothesis> {
        let evidence = self.evidence;
        let places = Places::new(evidence.reading, None, LOOK);
        let is_own = |it: &&Hypothesis| is_same(&it.scene, &evidence.scene);
        let is_meant =
            |it: &&Hypothesis| evidence.is_usual(&it.scene) && it.scene.chosen == Chosen::default();
        let rights = rights.iter().filter(is_meant);
        let (own, others): (Vec<_>, Vec<_>) = rights.partition(is_own);
        let mut nearest: Vec<Hypothesis> = own.first().map(|&it| it.clone()).into_iter().collect();
        let asked = nearest.first().map(|it| it.scene.edition);
        for some in [own, others] {
            // Colors of the reader's own hide which edition is near.
            let colored = some.iter().filter_map(|it| in_colors(evidence, it, LOOK));
            let some = some.iter().map(|&it| it.clone()).chain(colored);
            let some = likeliest(evidence, some, &places, f64::INFINITY, FEW);
            let is_another = |it: &Hypothesis| !is_own(&it) || Some(it.scene.edition) != asked;
            let other = some.into_iter().map(|(_, it)| it).find(is_another);
            nearest.extend(other.map(Hypothesis::in_the_books_colors));
        }
        nearest
    }

    /// Whether it is a picture of a crate that our prelude paints: nothing is chosen there that
    /// is not in the lines.
    fn is_painted(&self) -> bool {
        let sources = &self.evidence.known.sources;
        sources.are_of_the_chapter() && !sources.have_a_prelude()
    }

    /// What the reader chose in the best, by other editions: they may draw the same.
    fn add_other_editions(&mut self, rights: &[Hypothesis]) {
        let best = self.best().program();
        let chosen = best.scene.chosen;
        let is_like = |it: &&Hypothesis| {
            is_same(&it.scene, &best.scene) && it.scene.chosen == Chosen::default()
        };
        let own = rights.iter().filter(is_like);
        let own = own
            .clone()
            .find(|it| it.scene.edition == best.scene.edition)
            .zip(Some(own));
        let Some((own, others)) = own.filter(|_| chosen != Chosen::default()) else {
            return;
        };
        let others = others.filter(|it| it.scene.edition != best.scene.edition);
        // What a slip was needed for, another edition may have by itself.
        let has_slips = usize::from(!best.slips.is_empty());
        let slips = &[best.slips.clone(), Vec::new()][..=has_slips];
        let chosen = others.flat_map(|it| {
            slips.iter().map(|slips| Hypothesis {
                scene: it.scene.with(chosen),
                slips: slips.clone(),
                name: best.name + it.name - own.name + name_of(slips) - name_of(&best.slips),
                ..best.clone()
            })
        });
        let (mark, shortest) = (self.best().mark, self.best().bits());
        let reading = self.evidence.reading;
        let places = Places::new(reading, None, LOOK);
        let may_be = |it: &Hypothesis| it.estimated(reading, &places, may_win(shortest)).is_some();
        let same = chosen
            .filter(may_be)
            .filter_map(|it| it.measured(reading))
            .filter(|it| it.mark == mark || it.bits() < shortest);
        self.keep(same);
    }

    /// Slips that draw the same as one of the best beside what the reader chose.
    fn add_other_slips(&mut self) {
        let (evidence, best) = (self.evidence, self.best().program());
        if best.scene.chosen == Chosen::default() || best.slips.is_empty() {
            return;
        }
        let is_like = |it: &Hypothesis| {
            is_same(&it.scene, &best.scene)
                && it.scene.edition == best.scene.edition
                && it.conversion == best.conversion
        };
        let singles = single(evidence).into_iter().filter(is_like);
        let singles: Vec<Hypothesis> = singles.collect();
        let name = |slip: &Slip| {
            let mut named = singles.iter();
            let named = named.find(|it| it.slips[0].name == slip.name);
            named.map_or(f64::INFINITY, |it| it.name)
        };
        let others = (0..best.slips.len()).flat_map(|n| {
            let (best, name) = (&best, &name);
            singles.iter().map(move |other| {
                let mut slips = best.slips.clone();
                let own = std::mem::replace(&mut slips[n], other.slips[0]);
                Hypothesis {
                    slips,
                    name: best.name + other.name - name(own),
                    ..best.clone()
                }
            })
        });
        let (mark, reading) = (self.best().mark, evidence.reading);
        let Some(drawn) = best.output(reading) else {
            return;
        };
        let is_same = |it: &Hypothesis| {
            let (width, height) = drawn.size();
            let mut places = spread(PEEK, width * height);
            let output = it.output(reading);
            output.is_some_and(|it| places.all(|n| it.pixel(n) == drawn.pixel(n)))
        };
        let same = others.filter(is_same);
        let same = same.filter_map(|it| it.measured(reading));
        let same: Vec<Explanation> = same.filter(|it| it.mark == mark).collect();
        self.keep(same);
    }

    /// Colors that a reader may have chosen instead of the slips that were found, or of one of two.
    fn add_colors(&mut self, rights: &[Hypothesis]) {
        let (best, mark) = (self.best().program(), self.best().mark);
        if best.slips.is_empty() || !self.evidence.known.sources.is_empty() {
            return;
        }
        let plain = best.without_slips();
        let Some(right) = rights.iter().find(|it| it.is_same_program(&plain)) else {
            return;
        };
        let colored = |slips: Vec<&'static Slip>| {
            let it = Hypothesis {
                name: right.name + name_of(&slips),
                slips,
                ..right.clone()
            };
            let colored = in_colors(self.evidence, &it, LOOK)?;
            colored.measured(self.evidence.reading)
        };
        let whole = colored(Vec::new());
        let two = best.slips.iter().filter(|_| best.slips.len() == 2);
        let parts = two.filter_map(|&slip| colored(vec![slip]));
        let parts = parts.filter(|it| it.mark == mark);
        let all: Vec<Explanation> = whole.into_iter().chain(parts).collect();
        self.keep(all);
    }

    /// Several rays a pixel, by right programs and by the likeliest wrong ones.
    fn add_several_rays(
        &mut self,
        rights: &[Hypothesis],
        wrong: &[Hypothesis],
        nearest: &[Hypothesis],
    ) {
        if !self.is_worth_a_search() {
            return;
        }
        let evidence = self.evidence;
        let is_own = |it: &&Hypothesis| is_same(&it.scene, &evidence.scene);
        let Some(drawn) = nearest.first().and_then(|it| it.drawn(evidence.reading)) else {
            return;
        };
        let slips = wrong.iter().filter(|it| !it.slips.is_empty()).take(SLIPS);
        // Without a fraction of a level, single precision is no edition of its own.
        let rights_own = rights.iter().filter(is_own);
        let rights_own = rights_own.filter(|it| it.scene.edition != Edition::V1);
        let others = nearest.iter().filter(|it| !is_own(it));
        let plain = rights_own.chain(others).chain(slips).map(|it| (it, None));
        let found = antialiased(evidence, &drawn, plain);
        self.extend_antialiased(found);
    }

    fn is_worth_a_search(&self) -> bool {
        // That it says little is no explanation, where numbers of the reader's own are one.
        let best = self.best_of(|it| it.seen != Some(Seen::Little));
        best.left.bits >= WORTH_A_SEARCH && !self.is_painted()
    }

    /// Whether it is by so many rays as no reduced picture is, and nothing happened to it besides.
    fn is_of_many_rays(&self) -> bool {
        let best = self.best();
        let is_many = |but: &But| match but {
            But::Antialiased { samples, .. } => samples.is_some_and(|samples| samples > MANY_RAYS),
            _ => false,
        };
        self.is_antialiased(self.unknown) && best.but.iter().any(is_many) && best.left.off == 0
    }

    /// What a reader chose, and no mistake. Returns what may be.
    fn add_changed(&mut self, nearest: &[Hypothesis]) -> Vec<Path> {
        if !self.is_worth_a_search() || self.is_antialiased(f64::INFINITY) {
            return Vec::new();
        }
        let (evidence, reading) = (self.evidence, self.evidence.reading);
        let places = Places::new(reading, None, LOOK);
        let (mut chosen, mut middles) = (Vec::new(), Vec::new());
        for right in nearest {
            let Some(drawn) = right.drawn(reading) else {
                continue;
            };
            self.keep(turned(evidence, right, &drawn));
            let curved = on_a_curve(evidence, right, &drawn);
            if let Some(But::Curve(curve)) = curved.as_ref().and_then(|it| it.but.first()) {
                let curved = [(right, Some(curve))].into_iter();
                self.keep(antialiased(evidence, &drawn, curved));
            }
            self.keep(curved);
            let paths = chosen_otherwise(evidence, right);
            let ends = paths.iter().filter_map(|path| path.last());
            // Nor is it by another edition, or of another chapter, where simple numbers leave nothing.
            let is_explained = ends
                .clone()
                .any(|it| it.name < SIMPLE && it.estimated(reading, &places, it.name).is_some());
            let middle = |it| through_the_middle(evidence, right, it);
            middles.extend(ends.filter(|_| !is_explained).filter_map(middle));
            chosen.extend(paths);
            if is_explained {
                break;
            }
        }
        let likeliest = self.add(chosen.iter().flatten().cloned(), None, f64::INFINITY);
        // What was fitted first makes up for less.
        let firsts = chosen.iter().filter_map(|path| path.first().cloned());
        let tried = likeliest.into_iter().take(1).chain(firsts).chain(middles);
        let tried: Vec<Hypothesis> = tried.collect();
        self.add_antialiased(&tried);
        chosen
    }

    /// These with several rays a pixel.
    fn add_antialiased(&mut self, tried: &[Hypothesis]) {
        if self.is_worth_a_search()
            && let Some(first) = tried.first()
            && let Some(drawn) = first.drawn(self.evidence.reading)
        {
            let tried = tried.iter().map(|it| (it, None));
            let found = antialiased(self.evidence, &drawn, tried);
            self.extend_antialiased(found);
        }
    }

    /// A single ray anywhere in a pixel, beside a slip or numbers of the reader's own, draws much
    /// by chance, so it has to explain nearly all.
    fn extend_antialiased(&mut self, found: Vec<Explanation>) {
        let is_single = |it: &Explanation| match it.but.first() {
            Some(But::Antialiased { samples, .. }) => samples.is_some_and(|count| count < SINGLE),
            _ => false,
        };
        let is_plain =
            |it: &Explanation| it.slips.is_empty() && it.scene.chosen == Chosen::default();
        let unknown = self.unknown;
        // Numbers of the reader's own make up for rays that lie elsewhere.
        let is_fitted = |it: &Explanation| it.scene.chosen.is_placed() && it.seen.is_some();
        let explains = |it: &Explanation| {
            !is_fitted(it) && (!is_single(it) || is_plain(it)) || MIXED * it.bits() < unknown
        };
        self.keep(found.into_iter().filter(explains));
    }

    /// What a reader chose beside a slip or two, where nothing else explains the picture: that
    /// draws much by chance, so it has to explain nearly all.
    fn add_chosen_beside_slips(&mut self, nearest: &[Hypothesis], chosen: &[Path]) {
        let is_chosen = !self.best().scene.chosen.looks_like_a_slip();
        if self.is_well_explained() && is_chosen || self.is_painted() {
            return;
        }
        let beside = nearest
            .iter()
            .flat_map(|right| chosen_beside_slips(self.evidence, right, chosen));
        let beside: Vec<Hypothesis> = beside.collect();
        let before = self.found.len();
        let beside = self.add(beside, None, f64::INFINITY);
        // The mean of several rays is scaled otherwise, so a slip in that may be none.
        let without = beside.iter().find(|it| it.slips.is_empty());
        let tried: Vec<Hypothesis> = beside.first().into_iter().chain(without).cloned().collect();
        self.add_antialiased(&tried);
        let unknown = self.unknown;
        // Two make up for much, so nothing is left beside them.
        let explains = |it: &Explanation| {
            let times = if it.but.is_empty() { MIXED } else { SCATTERED };
            times * it.bits() < unknown && (it.slips.len() < 2 || it.left.far == 0)
        };
        let added = self.found.split_off(before).into_iter();
        self.keep(added.filter(explains));
    }

    /// The same with something more in it.
    fn add_more(&mut self) {
        if surfaces::are_many(self.evidence.reading) {
            return;
        }
        let is_plain =
            |it: &Explanation| it.slips.is_empty() && it.seen.is_none() && it.but.is_empty();
        let has_own_hits =
            |it: &Explanation| it.scene.chosen.paint.is_some() || it.scene.chosen.shade.is_some();
        // A sphere elsewhere is like a part of anything, unless nothing else is left, and so is one
        // of colors that may be any, or seen through any viewport.
        let is_own = |it: &Explanation| {
            let chosen = it.scene.chosen;
            is_plain(it) && !chosen.is_placed() && !has_own_hits(it)
        };
        let nearest = self.found[0].program();
        let chosen = Some(self.best()).filter(|it| is_plain(it) && !is_own(it));
        let chosen = chosen.map(Explanation::program);
        let best = self.best_of(is_own).program();
        // Several rays a pixel are seen beside a slip as well.
        let is_of_rays = |it: &&Explanation| {
            let has_rays = it.left.part.is_some() && it.but.iter().any(But::is_mean);
            has_rays && !it.slips.is_empty() && it.scene.chosen == Chosen::default()
        };
        let of_rays = Some(self.best()).filter(is_of_rays);
        let of_rays = of_rays.map(Explanation::program);
        for it in [nearest, best].into_iter().chain(of_rays) {
            self.keep(more(self.evidence, &it));
        }
        let chosen = chosen.map_or(Vec::new(), |it| more(self.evidence, &it));
        let is_whole =
            |it: &Explanation| it.left.far == 0 && it.but.is_empty() && !has_own_hits(it);
        self.keep(chosen.into_iter().filter(is_whole));
    }

    /// The best program if nothing happened to its picture and nothing was chosen, and that.
    fn nearest_drawn(&self) -> Option<(Hypothesis, Vec<Pixel>)> {
        let is_its_own =
            |it: &Explanation| it.degradation().is_none() && it.scene.chosen == Chosen::default();
        let best = self.best_of(is_its_own).program();
        let drawn = best.drawn(self.evidence.reading)?;
        Some((best, drawn))
    }

    /// Two slips explain a lot by chance, so they have to explain most of what is left.
    fn add_pairs(&mut self) {
        let evidence = self.evidence;
        // Many pairs draw one color everywhere, which says nothing about any of them.
        if evidence.reading.is_plain() {
            return;
        }
        let Some((best, drawn)) = self.nearest_drawn() else {
            return;
        };
        let places = Places::new(evidence.reading, Some(&drawn), GLANCE);
        let length = best.estimated(evidence.reading, &places, f64::INFINITY);
        let most = length.unwrap_or(f64::INFINITY) / 3.0;
        // What the reader may have chosen, a pair may tell in fewer bits.
        let most = most.min(may_win(self.best().bits()));
        if most > TWO {
            let chosen = self.best().scene.edition;
            let editions = [evidence.scene.edition, best.scene.edition, chosen];
            // One in whose own shape it is may be meant, unless it lasted for two weeks.
            let is_meant = |it: &Hypothesis| {
                let is_likely = it.scene.edition != Edition::V3_1_0;
                is_likely && !it.scene.has_another_shape() || editions.contains(&it.scene.edition)
            };
            let pairs = two(evidence).filter(is_meant);
            let some = likeliest(evidence, pairs, &places, most, FEW);
            self.add(
                some.into_iter().map(|(_, it)| evidence.weighed(it)),
                Some(&drawn),
                f64::INFINITY,
            );
        }
    }
}

/// The longest estimate with which an explanation may still be as short as this one:
/// estimates are wrong by half, and by some odd pixels.
fn may_win(bits: f64) -> f64 {
    2.0 * bits + 64.0
}

/// Those of the hypotheses that look shortest, the shortest first, with their lengths; but no slip
/// that draws, at all these places, what a program before it draws without one.
pub(crate) fn likeliest(
    evidence: &Evidence,
    all: impl IntoIterator<Item = Hypothesis>,
    places: &Places,
    most: f64,
    few: usize,
) -> Vec<(f64, Hypothesis)> {
    let mut best: Vec<(f64, Hypothesis)> = Vec::new();
    for it in all {
        let last = best.get(few - 1).map_or(most, |(last, _)| most.min(*last));
        let most = best.first().map_or(last, |(length, _)| {
            last.min(may_win(*length) + places.give())
        });
        if let Some(length) = it.estimated(evidence.reading, places, most) {
            let is_without = |(other, without): &(f64, Hypothesis)| {
                let is_like = (length - it.name - other + without.name).abs() <= 1e-6;
                let is_whole = without.scene.step().is_none() && !without.scene.has_another_shape();
                let is_right = without.slips.is_empty() && is_whole;
                is_like && is_right && without.name <= it.name
            };
            if !it.slips.is_empty() && best.iter().any(is_without) {
                continue;
            }
            let at = best.partition_point(|(other, _)| *other <= length);
            best.insert(at, (length, it));
            best.truncate(few);
        }
    }
    best
}
