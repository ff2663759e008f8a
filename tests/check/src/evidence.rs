//! Evidence: all that is known of what a reader did, in the same bits as the picture.
//!
//! What is known besides the picture costs one who believes an explanation as much as it
//! surprises them: answers that their program would not give, a line that is right where
//! it should be wrong, a warning of the compiler about a name that they have no reason to
//! drop.

use std::cmp::Reverse;

use slips::{Edition, Letters, Program, Slip, Unseen, Words};

use crate::explanations::{Degradation, Hypothesis};
use crate::mutants;
use crate::reading::Reading;
use crate::scene::Scene;
use crate::sources::{Line, Said, Sources, Unlike, in_no_language};

/// How many answers were given, and how many of them a program would not give.
pub type Asked<'a> = dyn Fn(&Program) -> (usize, usize) + 'a;

/// What is known besides the picture.
#[derive(Default)]
pub struct Known<'a> {
    /// The letters in which the reader writes; without them, those of the edition.
    pub letters: Option<Letters>,
    /// Whether the reader can have made a slip; any, if nothing is known.
    pub can_be_made: Option<&'a dyn Fn(&Slip) -> bool>,
    /// What the reader wrote.
    pub sources: Sources,
    /// What the reader's functions answered.
    pub answers: Option<&'a Asked<'a>>,
    /// What the compiler warned of, in its words.
    pub warnings: Vec<String>,
    /// Whether each step of the chapter has been done before, if steps are judged.
    pub steps: Vec<bool>,
}

impl Known<'_> {
    /// What there is to say of a slip in the scene, in the reader's letters.
    pub fn words(&self, slip: &Slip, scene: &Scene) -> Words {
        let is_older = scene.edition != Edition::V4;
        let letters = match self.letters {
            Some(Letters::Python(_)) => Letters::Python(scene.edition),
            // In Rust there are the lines of our chapters, which follow version 4.
            Some(Letters::Rust) if is_older && slip.has_older_words() => {
                Letters::Book(scene.edition)
            }
            Some(letters) => letters,
            None => Letters::Book(scene.edition),
        };
        slip.words(letters, scene.chapter)
    }

    /// The same to be read: a change of the chapter without what Rust alone has, if the reader
    /// writes something else and has not typed it just so.
    pub(crate) fn read_words(&self, slip: &Slip, scene: &Scene) -> Words {
        let words = self.words(slip, scene);
        let is_in_rust = self.sources.is_empty() || self.letters == Some(Letters::Rust);
        match !slip.name.is_empty() || is_in_rust || self.sources.have_line(&words.wrong) {
            true => words,
            false => Words {
                wrong: in_no_language(&words.wrong).into(),
                right: in_no_language(&words.right).into(),
                why: words.why,
            },
        }
    }

    /// Whether the reader can have made the slip, as far as it is known.
    pub fn can_be_made(&self, slip: &Slip, scene: &Scene) -> bool {
        self.can_be_made.is_none_or(|can_be| can_be(slip)) && self.said(slip, scene) != Said::Right
    }

    /// Slips whose wrong line is in the reader's files, where no picture of the scene shows
    /// them.
    pub fn suspected(&self, scene: &Scene) -> Vec<&'static Slip> {
        let is_meant = |slip: &&'static Slip| {
            let is_equivalent =
                matches!(slip.unseen_in(scene.chapter), Some(Unseen::Equivalent(_)));
            !is_equivalent && self.can_be_made(slip, scene)
        };
        // Where the functions were asked, more is known than a line.
        if self.answers.is_some() {
            return Vec::new();
        }
        let is_there = |slip: &&Slip| self.said(slip, scene) == Said::Wrong;
        let right = scene.program(&[]).run(scene.chapter.book_width()).picture();
        let hides = |slip: &&'static Slip| {
            let program = scene.program(&[slip]);
            program.run(scene.chapter.book_width()).picture() == right
        };
        let found = scene.slips().filter(is_meant).filter(is_there);
        let found = found.filter(hides);
        let mut found: Vec<_> = found.collect();
        found.sort_by_key(|slip| Reverse(slip.reports()));
        found.extend(mutants::hidden(scene.chapter, &self.sources));
        found
    }

    /// The few places that are not as the chapter has them, if one of them may have the
    /// mistake: an own prelude may have it too, unless a function answers wrongly.
    pub(crate) fn unlike(&self, scene: &Scene) -> &[Unlike] {
        let is_right = || self.is_answered_by(&scene.unchanged().program(&[]));
        match self.sources.have_a_prelude() && is_right() {
            true => &[],
            false => self.sources.unlike(),
        }
    }

    /// What the reader's files say of the slip. A line that an older edition has is wrong in
    /// a mixture only, which no single line tells.
    pub(crate) fn said(&self, slip: &Slip, scene: &Scene) -> Said {
        let is_mixture = slip.is_of_another_edition() && self.letters != Some(Letters::Rust);
        match self.sources.say(&self.words(slip, scene)) {
            Said::Wrong if is_mixture => Said::Neither,
            said => said,
        }
    }

    /// The reader's line that makes the slip, if it is found.
    pub fn line_of(&self, slip: &Slip, scene: &Scene) -> Option<Line> {
        let is_wrong = self.said(slip, scene) == Said::Wrong;
        let line = || self.sources.line_of(self.words(slip, scene));
        is_wrong.then(line).flatten()
    }

    /// Whether the reader's functions answer as the program would.
    pub(crate) fn is_answered_by(&self, program: &Program) -> bool {
        self.answers.is_none_or(|unlike| unlike(program).1 == 0)
    }
}

/// All that is known of what a reader did.
pub(crate) struct Evidence<'a> {
    /// The scene that the picture is meant to show; the chapter's own instead of a probe
    /// that is about another width.
    pub(crate) scene: Scene,
    /// The picture.
    pub(crate) reading: &'a Reading,
    /// Whether it has numbers that are none.
    pub(crate) has_no_levels: bool,
    /// What is known besides.
    pub(crate) known: &'a Known<'a>,
    /// What is taken to have happened to the picture on its way, and the bits that tell it.
    pub(crate) degradation: Option<(Degradation, f64)>,
}

/// An answer that is not explained, out of some hundred, and what it is instead.
const ANSWER: f64 = 14.0;
/// Of more answers than one in fifty nobody can say that they are due to rounding.
const REFUTING: usize = 50;
/// The line of a slip that is in none of the reader's files: it is written in other words, as
/// one line in three is, and a line as wrong as that is in one file in fifty by chance.
const NOT_FOUND: f64 = 7.0;
/// The same where a line is known that is not the chapter's.
const ELSEWHERE: f64 = 2.0;
/// A line that is as it should be: its copy elsewhere may be wrong, once in thousands.
const FOUND_RIGHT: f64 = 16.0;
/// A place that is not as the chapter has it: one line in ten is, in a right program too.
const TYPED: f64 = 9.0;
/// A warning comes for another reason.
const WARNING: f64 = 5.0;

impl<'a> Evidence<'a> {
    pub(crate) fn new(scene: &Scene, reading: &'a Reading, known: &'a Known<'a>) -> Self {
        let is_about_another_width = scene
            .probe
            .is_some_and(|probe| probe.spheres.is_none() && probe.width != reading.width);
        Self {
            scene: match is_about_another_width {
                true => scene.without_probe(),
                false => *scene,
            },
            reading,
            has_no_levels: reading.outside().is_some(),
            known,
            degradation: None,
        }
    }

    /// The same, if that happened to the picture.
    pub(crate) fn degraded(&self, degradation: Degradation) -> Self {
        Self {
            degradation: Some((degradation, degradation.name())),
            ..*self
        }
    }

    /// Width and height of the picture that the program drew.
    pub(crate) fn size(&self) -> (u32, u32) {
        let own = (self.reading.width, self.reading.height);
        let degradation = self.degradation.map(|(degradation, _)| degradation);
        degradation.map_or(own, |it| it.size(self.reading))
    }

    /// Whether numbers and mistakes are looked for in the scene, or it is known as right alone: an
    /// edition of two weeks is rare, and so is the first in a later shape.
    pub(crate) fn is_usual(&self, scene: &Scene) -> bool {
        let (width, height) = self.size();
        let is_rare = scene.edition == Edition::V3_1_0 || scene.is_in_a_later_shape(width, height);
        scene.edition == self.scene.edition || !is_rare
    }

    /// How high right pictures of that width are, by the editions that will do.
    pub(crate) fn heights(&self, width: u32) -> Vec<u32> {
        let scenes = self.scene.by_editions(width, 1);
        let mut heights: Vec<u32> = scenes.map(|it| it.in_own_shape().height(width)).collect();
        heights.sort_unstable();
        heights.dedup();
        heights
    }

    /// The slips that the reader can have made in the scene.
    pub(crate) fn slips(&self, scene: &Scene) -> impl Iterator<Item = &'static Slip> {
        let chapter = scene.chapter;
        let unnamed = slips::unnamed().filter(move |slip| slip.chapters.contains(&chapter));
        scene
            .slips()
            .chain(unnamed)
            .filter(|slip| self.may_be_wrong(slip))
    }

    /// Whether the reader can have made the slip.
    pub(crate) fn may_be_wrong(&self, slip: &Slip) -> bool {
        self.known.can_be_made.is_none_or(|can_be| can_be(slip))
    }

    /// The same hypothesis with what the evidence besides the picture costs.
    pub(crate) fn weighed(&self, it: Hypothesis) -> Hypothesis {
        Hypothesis {
            name: it.name + self.besides(&it),
            ..it
        }
    }

    /// What the evidence besides the picture costs one who believes the hypothesis.
    pub(crate) fn besides(&self, it: &Hypothesis) -> f64 {
        self.answers(it) + self.files(it) + self.warnings(it)
    }

    /// The length of what the reader typed otherwise than the chapter has it, in few places:
    /// that explains all there is, since all the rest is right.
    pub(crate) fn typed(&self) -> Option<f64> {
        let places = self.known.unlike(&self.scene).len();
        (places > 0).then_some(TYPED * places as f64)
    }

    /// What the reader's functions answered. Programs don't answer by chance: slips that
    /// would answer otherwise have not been made, and steps not been reached.
    fn answers(&self, it: &Hypothesis) -> f64 {
        let Some(unlike) = self.known.answers else {
            return 0.0;
        };
        let (asked, unlike) = unlike(&it.scene.unchanged().program(&it.slips));
        let is_plain = it.slips.is_empty() && it.scene.step().is_none();
        match unlike * REFUTING > asked && !is_plain {
            true => f64::INFINITY,
            false => ANSWER * unlike as f64,
        }
    }

    /// What a line costs that is not found in the reader's files, if there are any.
    pub(crate) fn unfound(&self) -> f64 {
        match self.known.sources.is_empty() {
            true => 0.0,
            false => NOT_FOUND,
        }
    }

    /// What the reader wrote.
    fn files(&self, it: &Hypothesis) -> f64 {
        let known = self.known;
        if known.sources.is_empty() {
            return 0.0;
        }
        let is_unlike = !known.unlike(&self.scene).is_empty();
        let cost = |slip: &&'static Slip| match known.said(slip, &it.scene) {
            Said::Wrong => 0.0,
            Said::Neither if is_unlike => ELSEWHERE,
            Said::Neither => NOT_FOUND,
            Said::Right => FOUND_RIGHT,
        };
        let is_further = it.scene.step().is_some() && known.sources.is_written();
        let step = if is_further { FOUND_RIGHT } else { 0.0 };
        step + it.slips.iter().map(cost).sum::<f64>()
    }

    /// What the compiler warned of: a name that the wrong line does not use any more.
    fn warnings(&self, it: &Hypothesis) -> f64 {
        let is_dropped = |name: &str| {
            it.slips.iter().any(|slip| {
                let words = self.known.words(slip, &it.scene);
                words.right.contains(name) && !words.wrong.contains(name)
            })
        };
        let about_names = self.known.warnings.iter().filter(|it| it.contains('`'));
        let unexplained = about_names.filter(|warning| {
            let mut names = warning.split('`').skip(1).step_by(2);
            !names.any(is_dropped)
        });
        WARNING * unexplained.count() as f64
    }
}
