//! Neighbors of the right picture: right, but for something that is no mistake.

use std::iter;

use super::antialiasing::{self, Around, Seen};
use super::candidates::{distance, spread};
use super::curve::Curve;
use super::scene::{Chosen, Scene};
use crate::reading::Reading;
use slips::{Output, Program};

/// A picture that is right, but for something that is no mistake.
#[derive(Clone, Debug)]
pub struct Near {
    /// The scene, in the reader's own colors if there are some.
    pub scene: Scene,
    /// What else is not the book's.
    pub but: Vec<But>,
}

/// What a picture has that the book's does not have.
#[derive(Clone, Debug, PartialEq)]
pub enum But {
    /// Each pixel is the mean of several rays.
    Antialiased {
        /// About how many, if there are edges enough to tell.
        samples: Option<f64>,
    },
    /// All levels went through the same curve, as gamma correction does it.
    Curve(Curve),
    /// So many of the pixels that were compared are a level off, and so many at edges
    /// are those of a neighbor: other rounding, or less precision.
    Rounded {
        /// Pixels that are off.
        off: usize,
        /// Those of them that are off by more than a level.
        far: usize,
        /// Pixels that were compared.
        compared: usize,
    },
}

impl Near {
    /// How many rays each pixel is the mean of; of a picture that is not antialiased, as
    /// many as one can imagine.
    fn samples(&self) -> f64 {
        let samples = self.but.iter().find_map(|but| match but {
            But::Antialiased { samples } => Some(samples.unwrap_or(0.0)),
            _ => None,
        });
        samples.unwrap_or(f64::INFINITY)
    }

    /// Which share of the pixels is off, if nothing but rounding makes it so.
    pub(super) fn rounded(&self) -> Option<f64> {
        match self.but[..] {
            [But::Rounded { off, compared, .. }] if self.scene.chosen == Chosen::default() => {
                Some(off as f64 / compared as f64)
            }
            _ => None,
        }
    }

    /// Whether the reader's choice explains each pixel to the last bit.
    pub fn is_exact(&self) -> bool {
        self.but.is_empty()
    }
}

/// How many pixels are looked at first, and then.
const LOOKS: [u32; 2] = [300, 4000];
/// In how many edges are looked for, and single pixels that speak against a rounding: all
/// of a picture 800 pixels wide.
const LONG_LOOK: u32 = 400_000;
/// Of so many pixels one may be that of a ray that grazes a sphere.
const GRAZING: u32 = 20_000;
/// In how many scenes a curve is looked for.
const NEARBY: usize = 2;

/// What the picture is if it is right but for choices: the first of these scenes that it
/// shows to the last bit, or else as far as can be seen, if need be on a curve.
pub(super) fn near(scenes: &[Scene], reading: &Reading) -> Option<Near> {
    if reading.outside().is_some() {
        return None;
    }
    let shows = |scene: &&Scene| {
        let output = scene.program(&[]).run(reading.width);
        (0..reading.pixels.len() as u32).all(|n| off(&output, reading, n) == 0)
    };
    let exact = scenes.iter().find(shows).map(|&scene| Near {
        scene,
        but: Vec::new(),
    });
    let plain = || {
        // Of equals the last is taken, and the first one is the nearest. Beside the wrong
        // camera the mean of many rays looks like that of few.
        let all = scenes.iter().rev();
        all.filter_map(|scene| View::new(scene, reading, None).near())
            .max_by(|one, other| one.samples().total_cmp(&other.samples()))
    };
    let curved = || {
        scenes.iter().take(NEARBY).find_map(|scene| {
            let curve = Curve::of(scene, reading)?;
            View::new(scene, reading, Some(curve)).near()
        })
    };
    exact.or_else(plain).or_else(curved)
}

/// How far the reader's pixel is from what a program draws.
fn off(output: &Output, reading: &Reading, n: u32) -> u16 {
    let drawn = output.pixel(n).map(|level| level.clamp(0, 255) as i16);
    distance(drawn, reading.pixels[n as usize])
}

/// A picture beside that of a scene, whose levels may have gone through a curve.
struct View<'a> {
    scene: &'a Scene,
    program: Program,
    reading: &'a Reading,
    curve: Option<Curve>,
}

impl<'a> View<'a> {
    fn new(scene: &'a Scene, reading: &'a Reading, curve: Option<Curve>) -> Self {
        Self {
            scene,
            program: scene.program(&[]),
            reading,
            curve,
        }
    }

    fn near(&self) -> Option<Near> {
        let mut seen = Seen::default();
        for look in LOOKS {
            seen = self.seen(look);
            if 20 * seen.strange > seen.compared {
                return None;
            }
        }
        let but = self.curve.clone().map(But::Curve).into_iter();
        // A curve is known of levels that are there, and a rim may have others.
        let few = match self.curve {
            Some(_) => seen.compared / 100,
            None => 0,
        };
        if !seen.is_antialiased() && seen.is_rounded_but_for(few) {
            return match self.curve {
                Some(_) => Some(self.with(but)),
                None => self.rounded().map(|but| self.with(iter::once(but))),
            };
        }
        if !seen.is_antialiased() {
            return None;
        }
        let samples = match self.curve {
            Some(_) => None,
            None => antialiasing::samples(&self.program, self.reading, self.far()),
        };
        // One sample elsewhere than in the middle makes no mixtures.
        let are_several = samples.is_none_or(|samples| samples > 1.5);
        are_several.then(|| self.with(iter::once(But::Antialiased { samples }).chain(but)))
    }

    /// The pixels that are off by more than a level.
    fn far(&self) -> impl Iterator<Item = u32> {
        let output = self.program.run(self.reading.width);
        let is_far = move |n: &u32| off(&output, self.reading, *n) > 1;
        spread(LONG_LOOK, self.reading.pixels.len() as u32).filter(is_far)
    }

    /// How many pixels are off, if not one of them is by more than a rounding.
    fn rounded(&self) -> Option<But> {
        let camera = self.program.camera(self.reading.width);
        let output = self.program.run(self.reading.width);
        let total = self.reading.pixels.len() as u32;
        let (mut far, mut strange) = (0, 0);
        for n in self.far() {
            far += 1;
            let around = Around::of(&self.program, &camera, n);
            let found = self.reading.pixels[n as usize];
            strange += u32::from(!around.may_be_moved_to(found));
            // A ray that grazes the sphere may hit it somewhere else.
            if !around.is_edge() || strange > 1 + total / GRAZING {
                return None;
            }
        }
        Some(But::Rounded {
            off: spread(LONG_LOOK, total)
                .filter(|&n| off(&output, self.reading, n) > 0)
                .count(),
            far,
            compared: LONG_LOOK.min(total) as usize,
        })
    }

    fn with(&self, but: impl Iterator<Item = But>) -> Near {
        Near {
            scene: *self.scene,
            but: but.collect(),
        }
    }

    fn seen(&self, look: u32) -> Seen {
        let camera = self.program.camera(self.reading.width);
        let mut seen = Seen::default();
        for n in spread(look, self.reading.pixels.len() as u32) {
            let mut around = Around::of(&self.program, &camera, n);
            let middle = around.middle();
            if let Some(curve) = &self.curve {
                around.map(|level| curve.apply(level));
            }
            let found = self.reading.pixels[n as usize];
            match &self.curve {
                Some(curve) => seen.add(&around, curve.settled(middle, found), 2),
                None => seen.add(&around, found, 1),
            }
        }
        seen
    }
}
