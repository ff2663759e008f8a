//! Blind spots: the known mistakes that draw a right picture, and what shows them.
//!
//! Found by drawing, like a diagnosis: a slip is hidden if its program draws the
//! right picture to the last bit, at the very width that the reader drew.

use std::iter;

use crate::pixels::spread;
use crate::scene::Scene;
use slips::{Chapter, Output, PROBES, Slip, Unseen};

/// What right pictures of a chapter leave open.
#[derive(Clone, Debug)]
pub struct BlindSpots {
    /// Pictures that show the hidden slips, the one that shows most of them first,
    /// of equals the cheapest: the first is what to draw next. No slip is in two.
    pub shown_by: Vec<Showing>,
    /// The slips that no picture shows, only a law.
    pub by_law: Vec<&'static Slip>,
}

/// A picture to draw, and the slips that would spoil it.
#[derive(Clone, Debug)]
pub struct Showing {
    /// A probe, or the chapter's own scene if it was drawn too small to show them.
    pub scene: Scene,
    /// How wide to draw it, in pixels.
    pub width: u32,
    /// The slips.
    pub slips: Vec<&'static Slip>,
}

impl BlindSpots {
    /// What a right picture of `scene`, so many pixels wide, can't show. That of a probe
    /// follows the chapter's own at the book's width, so only the rest is left to it.
    pub fn after(scene: &Scene, width: u32) -> Self {
        let chapter = scene.chapter;
        let own = (scene.without_probe(), chapter.book_width());
        let before = scene.probe.map(|_| own);
        let right: Vec<(Scene, u32)> = before.into_iter().chain([(*scene, width)]).collect();
        Self::of(chapter, &right)
    }

    /// What right pictures of these scenes of `chapter`, each so many pixels wide,
    /// can't show even together.
    ///
    /// Slips that change no picture and break no law are left out: whoever makes
    /// one has a right program.
    pub fn of(chapter: Chapter, right: &[(Scene, u32)]) -> Self {
        let passed: Vec<Exam> = right.iter().map(|&exam| Exam::new(exam)).collect();
        let unseen = |slip: &Slip| slip.unseen_in(chapter);
        let hidden = slips::all()
            .filter(|slip| slip.chapters.contains(&chapter))
            .filter(|slip| !matches!(unseen(slip), Some(Unseen::Equivalent(_))))
            .filter(|slip| passed.iter().all(|exam| exam.hides(slip)));
        let (by_law, hidden): (Vec<_>, Vec<_>) = hidden.partition(|slip| unseen(slip).is_some());
        let own = right.first().map(|(scene, _)| scene.without_probe());
        let own = own.or_else(|| Scene::new(chapter, None));
        let exams = own.into_iter().flat_map(exams);
        let exams = exams.filter(|exam| !passed.iter().any(|passed| passed.is(exam)));
        Self {
            shown_by: cover(exams.map(|exam| exam.showing(&hidden)).collect()),
            by_law,
        }
    }
}

/// What a reader of the chapter can draw: its own picture as large as in the book,
/// and the probes, the cheapest change first.
fn exams(own: Scene) -> impl Iterator<Item = Exam> {
    let probes = PROBES.map(|probe| (own.with_probe(probe), probe.width));
    iter::once((Some(own), own.chapter.book_width()))
        .chain(probes)
        .filter_map(|(scene, width)| Some(Exam::new((scene?, width))))
}

/// Few of the pictures that show as much as all of them: again and again the one that
/// shows most of what is left.
fn cover(mut left: Vec<Showing>) -> Vec<Showing> {
    let mut cover = Vec::new();
    // Of equals `max_by_key` takes the last one.
    while let Some(best) = left.iter().rev().max_by_key(|showing| showing.slips.len())
        && !best.slips.is_empty()
    {
        let best = best.clone();
        for showing in &mut left {
            showing.slips.retain(|slip| !best.shows(slip));
        }
        cover.push(best);
    }
    cover
}

impl Showing {
    fn shows(&self, slip: &Slip) -> bool {
        self.slips.iter().any(|shown| shown.name == slip.name)
    }
}

/// A picture that a program has to draw, and those of its pixels that are looked at.
struct Exam {
    scene: Scene,
    width: u32,
    right: Vec<(u32, [u8; 3])>,
}

/// How many pixels are looked at first: most slips differ in one of them.
const GLANCE: u32 = 500;
/// How many are looked at in the end, spread over the picture: a third of the book's. More
/// would keep the reader waiting, and a test compares all.
const LOOK: u32 = 30_000;

impl Exam {
    fn new((scene, width): (Scene, u32)) -> Self {
        let output = scene.program(&[]).run(width);
        let (columns, rows) = output.size();
        let places = spread(GLANCE, columns * rows).chain(spread(LOOK, columns * rows));
        Self {
            scene,
            width,
            right: places.map(|n| (n, levels(&output, n))).collect(),
        }
    }

    fn is(&self, other: &Self) -> bool {
        self.scene.probe == other.scene.probe && self.width == other.width
    }

    /// Whether a program with the slip draws this very picture.
    fn hides(&self, slip: &'static Slip) -> bool {
        let [right, wrong] =
            [&[][..], &[slip]].map(|slips| self.scene.program(slips).run(self.width));
        let is_right = |&(n, right): &(u32, [u8; 3])| levels(&wrong, n) == right;
        wrong.size() == right.size() && self.right.iter().all(is_right)
    }

    fn showing(&self, slips: &[&'static Slip]) -> Showing {
        let shown = slips.iter().copied().filter(|slip| !self.hides(slip));
        Showing {
            scene: self.scene,
            width: self.width,
            slips: shown.collect(),
        }
    }
}

/// The `n`th pixel as Rust draws it, where a conversion to a byte stops at 0 and 255.
fn levels(output: &Output, n: u32) -> [u8; 3] {
    output.pixel(n).map(|level| level.clamp(0, 255) as u8)
}

impl BlindSpots {
    /// The picture to draw next: it shows most of the mistakes that may have been made.
    pub fn next(&self, may_be: impl Fn(&Slip) -> bool) -> Option<Next> {
        let hidden = |showing: &Showing| showing.slips.iter().filter(|slip| may_be(slip)).count();
        let all = self.shown_by.iter().map(|it| (hidden(it), it));
        let (hidden, showing) = all.rev().max_by_key(|(hidden, _)| *hidden)?;
        (hidden > 0).then_some(Next {
            scene: showing.scene,
            width: showing.width,
            hidden,
        })
    }
}

/// A picture to draw after a right one.
pub struct Next {
    /// Its scene.
    pub scene: Scene,
    /// How wide to draw it, in pixels.
    pub width: u32,
    /// How many known mistakes show there that the pictures before hide.
    pub hidden: usize,
}

impl Next {
    /// What to change in a program, on one line.
    pub fn change(&self) -> String {
        self.scene.change(self.width).replace('\n', "; ")
    }
}
