//! Generation of cases: readers who follow the book, each in a way of their own.

use check::diagnosis::Scene;
use common::rtweekend::*;
use slips::Chapter;
use slips::{self, Edition, PROBES, Slip};

use super::truth::{Curve, Format, Rays, Truth};
use suite::random::Random;

/// What kind of picture it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Right by an edition before version 4.
    OlderEdition,
    /// Right by version 4.
    Right,
    /// Right, with several rays a pixel.
    Antialiased,
    /// Right, in colors of the reader's own, and perhaps with a slip beside.
    OwnColors,
    /// Right, with all levels on a curve.
    OnACurve,
    /// Right, but of another chapter, or without the change for the probe.
    Another,
    /// One slip.
    OneSlip,
    /// Two slips, the second one often in the file.
    TwoSlips,
    /// A slip, with several rays a pixel.
    AntialiasedSlip,
}

impl Kind {
    /// How many of forty cases are of each kind: as often as readers make it, roughly.
    pub(super) const SHARES: [(Self, usize); 9] = [
        (Self::OlderEdition, 10),
        (Self::Right, 10),
        (Self::Antialiased, 5),
        (Self::OwnColors, 5),
        (Self::OnACurve, 1),
        (Self::Another, 1),
        (Self::OneSlip, 5),
        (Self::TwoSlips, 2),
        (Self::AntialiasedSlip, 1),
    ];
}

/// Neighbors in number have nothing in common.
fn random(seed: u64, number: u64) -> Random {
    let mut random = Random((seed << 32 | number).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    for _ in 0..8 {
        random.below(2);
    }
    random
}

/// One of these.
fn one<T: Copy>(of: &[T], random: &mut Random) -> T {
    of[random.below(of.len())]
}

/// How wide readers like their pictures.
const WIDTHS: [u32; 11] = [100, 128, 160, 200, 200, 256, 300, 320, 400, 480, 640];
/// What shapes they choose instead of the book's.
const SHAPES: [[u32; 2]; 5] = [[4, 3], [1, 1], [2, 1], [3, 2], [16, 9]];
/// The most rays of a picture with several a pixel.
const MOST_RAYS: u32 = 4_000_000;

impl Truth {
    /// That of this number in the bank that grows from a seed.
    pub(super) fn numbered(seed: u64, number: u64) -> Self {
        let mut random = random(seed, number);
        loop {
            let truth = Self::of(&mut random);
            // In some editions a picture one pixel wide has no row.
            if truth.pixels() > 0 {
                return truth;
            }
        }
    }

    fn of(random: &mut Random) -> Self {
        let kind = kind(random);
        let chapter = one(chapters(kind), random);
        let mut truth = Self {
            kind,
            asked: scene(chapter),
            scene: scene(chapter),
            shape: None,
            width: match random.below(2) {
                0 => one(&WIDTHS, random),
                _ => 40 + random.below(601) as u32,
            },
            slips: Vec::new(),
            rays: None,
            curve: None,
            format: one(
                &[Format::Printed, Format::P3, Format::P6, Format::Png],
                random,
            ),
        };
        truth.scene.edition = edition(kind, random);
        if random.below(4) == 0 && truth.scene.edition != Edition::V3_1_0 {
            truth.shape = Some(one(&SHAPES, random));
            if random.below(4) > 0 {
                truth.width = one(&WIDTHS, random);
            }
        }
        let may_have_probe = matches!(kind, Kind::Right | Kind::OlderEdition | Kind::OneSlip);
        if may_have_probe && random.below(10) == 0 {
            truth.take_probe(random);
        }
        truth.take_what_its_kind_has(random);
        truth
    }

    fn take_what_its_kind_has(&mut self, random: &mut Random) {
        match self.kind {
            Kind::OlderEdition | Kind::Right => {}
            Kind::Antialiased => {
                self.take_rays(random);
                match random.below(5) {
                    0 => self.curve = Some(curve(random)),
                    1 => self.take_colors(random),
                    _ => {}
                }
            }
            Kind::OwnColors => {
                self.take_colors(random);
                if random.below(5) == 0 {
                    self.take_slip(random);
                }
            }
            Kind::OnACurve => self.curve = Some(curve(random)),
            Kind::Another => self.be_another(random),
            Kind::OneSlip => self.take_slip(random),
            Kind::TwoSlips => {
                self.take_slip(random);
                match random.below(3) {
                    0 => self.take_slip(random),
                    _ => self.take_slip_in_the_file(random),
                }
            }
            Kind::AntialiasedSlip => {
                self.take_rays(random);
                self.take_slip(random);
            }
        }
    }

    fn take_probe(&mut self, random: &mut Random) {
        let probe = one(&PROBES, random);
        let scenes = [self.asked, self.scene].map(|scene| scene.with_probe(probe));
        if let [Some(asked), Some(scene)] = scenes {
            (self.asked, self.scene) = (asked, scene);
            (self.shape, self.width) = (None, probe.width);
        }
    }

    fn take_rays(&mut self, random: &mut Random) {
        let count = one(&[1, 4, 4, 10, 10, 50, 100, 100], random);
        let pixels = (MOST_RAYS / count).isqrt();
        self.width = self.width.min(pixels).max(40);
        self.rays = Some(Rays {
            count,
            on_a_grid: matches!(count, 4 | 100) && random.below(3) == 0,
            seed: random.below(1 << 30) as u64,
        });
    }

    fn take_colors(&mut self, random: &mut Random) {
        let mut color = || Color::from_array([(); 3].map(|()| component(random)));
        let (below, above, paint) = (color(), color(), color());
        let has_paint = self.scene.chapter == Chapter::RedSphere && random.below(3) > 0;
        let has_sky = !has_paint || random.below(2) == 0;
        let chosen = &mut self.scene.chosen;
        match self.scene.chapter {
            Chapter::BuildTest => chosen.blue = Some(component(random)),
            _ => {
                chosen.sky = has_sky.then_some([below, above]);
                chosen.paint = has_paint.then_some(paint);
            }
        }
    }

    fn take_slip(&mut self, random: &mut Random) {
        let slips: Vec<&Slip> = self.scene.slips().collect();
        self.slips.push(one(&slips, random));
    }

    /// One that can be made in every chapter is one in the file.
    fn take_slip_in_the_file(&mut self, random: &mut Random) {
        let is_in_every_chapter = |slip: &&Slip| slip.chapters == Chapter::OF_THE_BOOK;
        let slips: Vec<&Slip> = slips::all().filter(is_in_every_chapter).collect();
        self.slips.push(one(&slips, random));
    }

    fn be_another(&mut self, random: &mut Random) {
        let probe = one(&PROBES, random);
        match self.asked.with_probe(probe) {
            Some(asked) if probe.spheres.is_some() && random.below(2) == 0 => self.asked = asked,
            _ => self.asked = scene(one(&Chapter::OF_THE_BOOK, random)),
        }
    }
}

/// One of the kinds, as often as its share.
fn kind(random: &mut Random) -> Kind {
    let kinds = Kind::SHARES.into_iter();
    let all: Vec<Kind> = kinds.flat_map(|(kind, share)| vec![kind; share]).collect();
    one(&all, random)
}

/// In a picture without a sphere, several rays a pixel and a curve are hard to see.
fn chapters(kind: Kind) -> &'static [Chapter] {
    let first = match kind {
        Kind::Antialiased | Kind::AntialiasedSlip => 2,
        Kind::OnACurve => 1,
        _ => 0,
    };
    &Chapter::OF_THE_BOOK[first..]
}

fn edition(kind: Kind, random: &mut Random) -> Edition {
    let all = match kind {
        Kind::Right => &Edition::ALL[..1],
        Kind::OlderEdition => &Edition::ALL[1..],
        _ => &Edition::ALL,
    };
    let edition = match random.below(2) {
        0 => all[0],
        _ => one(all, random),
    };
    match (kind, edition) {
        // Its single precision is a copy of the chapter that knows of one ray a pixel.
        (Kind::Antialiased | Kind::AntialiasedSlip, Edition::V1) => Edition::V1InDouble,
        _ => edition,
    }
}

fn scene(chapter: Chapter) -> Scene {
    Scene::new(chapter, None).expect("each chapter has its own scene")
}

fn curve(random: &mut Random) -> Curve {
    one(&[Curve::SquareRoot, Curve::Power22, Curve::Srgb], random)
}

/// Readers like round numbers.
fn component(random: &mut Random) -> f64 {
    let parts = one(&[10, 10, 20, 100, 255], random);
    random.below(parts + 1) as f64 / parts as f64
}
