//! What made a picture, and the file that it makes.

use std::fmt;

use check::diagnosis::{Chosen, Scene};
use check::png;
use check::reading::{Reading, read};
use common::rtweekend::*;
use slips::{Edition, Program, Slip};

use super::readers::Kind;
use crate::reading::p6;
use suite::drawn::p3;
use suite::random::Random;

/// What made a picture.
#[derive(Clone)]
pub(super) struct Truth {
    pub(super) kind: Kind,
    /// The scene that the reader says it is.
    pub(super) asked: Scene,
    /// The scene that it is, by the reader's edition and in the reader's colors.
    pub(super) scene: Scene,
    /// Width and height in a ratio of the reader's own.
    pub(super) shape: Option<[u32; 2]>,
    pub(super) width: u32,
    pub(super) slips: Vec<&'static Slip>,
    pub(super) rays: Option<Rays>,
    pub(super) curve: Option<Curve>,
    pub(super) format: Format,
}

/// Several rays a pixel, the mean of which is its color.
#[derive(Clone, Copy)]
pub(super) struct Rays {
    pub(super) count: u32,
    /// Whether they stand in rows and columns, and not anywhere.
    pub(super) on_a_grid: bool,
    /// Which of all random places they have.
    pub(super) seed: u64,
}

/// What components go through before they are levels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Curve {
    SquareRoot,
    Power22,
    Srgb,
}

/// How the picture is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    /// As C++ prints it, with numbers that are no levels.
    Printed,
    P3,
    P6,
    Png,
}

/// A truth and its picture.
pub(super) struct Case {
    pub(super) truth: Truth,
    pub(super) bytes: Vec<u8>,
    pub(super) reading: Reading,
}

impl Case {
    /// The picture of a truth.
    pub(super) fn of(truth: Truth) -> Self {
        let truth = truth.without_what_is_not_seen();
        let bytes = truth.drawn().bytes(truth.format);
        Self {
            reading: read(&bytes).expect("it is a picture"),
            bytes,
            truth,
        }
    }
}

impl Truth {
    /// How many pixels it has.
    pub(super) fn pixels(&self) -> u32 {
        let camera = self.program_with(&self.slips).camera(self.width);
        camera.image_width * camera.image_height
    }

    /// Without slips that change nothing here, or make of one edition another, and colors
    /// that are the book's.
    fn without_what_is_not_seen(mut self) -> Self {
        let drawn = self.drawn();
        for n in (0..self.slips.len()).rev() {
            let mut without = self.clone();
            without.slips.remove(n);
            let by_editions = [self.scene.edition].into_iter().chain(Edition::ALL);
            let mut same = by_editions.map(|edition| {
                let mut same = without.clone();
                same.scene.edition = edition;
                same
            });
            let seen = same.find(|same| same.drawn() == drawn);
            self = seen.unwrap_or(self);
        }
        let mut plain = self.clone();
        plain.scene.chosen = Chosen::default();
        match plain.drawn() == drawn {
            true => plain,
            false => self,
        }
    }

    /// Whether an edition of the book draws the scene that the reader was asked for.
    pub(super) fn is_right(&self) -> bool {
        self.slips.is_empty()
            && self.rays.is_none()
            && self.curve.is_none()
            && self.scene.chosen == Chosen::default()
            && self.is_as_asked()
    }

    /// Whether its width and height have a ratio that no edition gives them.
    pub(super) fn has_own_shape(&self) -> bool {
        let books = Self {
            shape: None,
            ..self.clone()
        };
        books.pixels() != self.pixels()
    }

    /// Whether it is the chapter, and the probe, that the reader says it is.
    pub(super) fn is_as_asked(&self) -> bool {
        (self.asked.chapter, self.asked.probe) == (self.scene.chapter, self.scene.probe)
    }

    /// The program that draws it with one ray a pixel, with these slips instead of its own.
    pub(super) fn program_with(&self, slips: &[&Slip]) -> Program {
        let mut program = self.scene.without_probe().program(&[]);
        if let Some([across, down]) = self.shape {
            program.aspect_ratio = f64::from(across) / f64::from(down);
            program.image_height = |width, ratio| ((width / ratio) as u32).max(1);
            // Until version 4 the viewport had the ratio that was wished for.
            program.viewport_ratio = match self.scene.edition {
                Edition::V4 => |width, height, _| width / height,
                _ => |_, _, ratio| ratio,
            };
        }
        for slip in slips {
            program = slip.put_to(program);
        }
        match self.scene.probe {
            Some(probe) => probe.put_to(program).expect("the scene has room for it"),
            None => program,
        }
    }

    /// What it draws with one ray a pixel, on no curve.
    pub(super) fn plain(&self) -> Drawn {
        let truth = Self {
            rays: None,
            curve: None,
            ..self.clone()
        };
        truth.drawn()
    }

    /// The picture as its file has it.
    pub(super) fn drawn(&self) -> Drawn {
        let program = self.program_with(&self.slips);
        let camera = program.camera(self.width);
        let (columns, rows) = (camera.image_width, camera.image_height);
        let (width, height) = (program.header)(columns, rows);
        let level = self.level(&program);
        let mut random = Random(self.rays.map_or(1, |rays| rays.seed | 1));
        let pixel = |n| {
            let (i, j) = (program.order)(n, columns, rows);
            let color = self.color(&program, &camera, (i, j), &mut random);
            let color = color.to_array().map(|component| match self.curve {
                Some(curve) => curve.apply(component),
                None => component,
            });
            program.channels.map(|channel| {
                let level = level(color[channel]);
                match self.format {
                    Format::Printed => level,
                    _ => level.clamp(0, 255),
                }
            })
        };
        Drawn {
            width,
            height,
            pixels: (0..columns * rows).map(pixel).collect(),
        }
    }

    /// Who takes several rays, or a curve, is a chapter ahead, and has its levels.
    fn level(&self, program: &Program) -> fn(f64) -> i32 {
        let is_ahead = self.rays.is_some() || self.curve.is_some();
        let has_own = self.slips.iter().any(|slip| changes_levels(slip));
        match self.scene.edition {
            Edition::V1 | Edition::V1InDouble | Edition::V3_0 => program.level,
            _ if is_ahead && !has_own => |component| (256.0 * component.clamp(0.0, 0.999)) as i32,
            _ => program.level,
        }
    }

    fn color(
        &self,
        program: &Program,
        camera: &Camera,
        (i, j): (u32, u32),
        random: &mut Random,
    ) -> Color {
        let Some(rays) = self.rays else {
            return (program.color)(program, camera, i, j);
        };
        let [width, height] = [camera.image_width, camera.image_height].map(f64::from);
        let [across, down] = (program.divisors)(width, height);
        // Before version 4, a column is a part of the whole edge, and begins at its left end.
        let (u, v, middle) = match program.edition.counts_from_below() {
            true => (
                camera.pixel_delta_u / across,
                camera.pixel_delta_v / down,
                0.0,
            ),
            false => (camera.pixel_delta_u, camera.pixel_delta_v, 0.5),
        };
        let mut sum = Color::ZERO;
        for n in 0..rays.count {
            let [x, y] = rays.place(n, random);
            let moved = Camera {
                pixel00: camera.pixel00 + (x - middle) * u + (y - middle) * v,
                ..*camera
            };
            sum += (program.color)(program, &moved, i, j);
        }
        sum / f64::from(rays.count)
    }
}

/// Whether the slip changes how a component becomes a level.
pub(super) fn changes_levels(slip: &Slip) -> bool {
    levels(slip).any(|[right, wrong]| right != wrong)
}

/// Whether it changes no level by more than one.
pub(super) fn is_a_rounding(slip: &Slip) -> bool {
    changes_levels(slip) && levels(slip).all(|[right, wrong]| right.abs_diff(wrong) <= 1)
}

/// Levels without the slip and with it, of components that are close to where a level
/// begins and of others.
fn levels(slip: &Slip) -> impl Iterator<Item = [i32; 2]> {
    let right = Program::right(slip.chapters[0]);
    let wrong = slip.put_to(right);
    let components = (0..4096).flat_map(|n| {
        let n = f64::from(n);
        [n / 4095.0, n / 16.0 / 255.999]
    });
    components.map(move |component| [(right.level)(component), (wrong.level)(component)])
}

impl Rays {
    /// Where in the pixel the nth ray goes through, from 0 to 1.
    fn place(self, n: u32, random: &mut Random) -> [f64; 2] {
        if !self.on_a_grid {
            return [(); 2].map(|()| random.below(1 << 30) as f64 / f64::from(1 << 30));
        }
        let side = self.count.isqrt();
        [n % side, n / side].map(|at| (f64::from(at) + 0.5) / f64::from(side))
    }
}

impl Curve {
    /// The power that it is, or is near.
    pub(super) fn power(self) -> f64 {
        match self {
            Self::SquareRoot => 1.0 / 2.0,
            Self::Power22 | Self::Srgb => 1.0 / 2.2,
        }
    }

    pub(super) fn apply(self, component: f64) -> f64 {
        match self {
            Self::SquareRoot => component.sqrt(),
            Self::Power22 => component.powf(1.0 / 2.2),
            Self::Srgb if component <= 0.003_130_8 => 12.92 * component,
            Self::Srgb => 1.055 * component.powf(1.0 / 2.4) - 0.055,
        }
    }
}

/// The numbers of a file.
#[derive(PartialEq, Eq)]
pub(super) struct Drawn {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) pixels: Vec<[i32; 3]>,
}

impl Drawn {
    fn bytes(&self, format: Format) -> Vec<u8> {
        let Self {
            width,
            height,
            pixels,
        } = self;
        if format == Format::Printed {
            let lines = pixels.iter().map(|[r, g, b]| format!("{r} {g} {b}\n"));
            let pixels: String = lines.collect();
            return format!("P3\n{width} {height}\n255\n{pixels}").into_bytes();
        }
        let levels = pixels.iter().flatten();
        let rgb = levels.map(|&level| level.clamp(0, 255) as u8).collect();
        let picture = Picture::from_rgb(*width, *height, rgb).expect("its size");
        match format {
            Format::P6 => p6(&picture),
            Format::Png => png::encode(&picture),
            _ => p3(&picture),
        }
    }
}

impl fmt::Display for Truth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { scene, width, .. } = self;
        write!(
            f,
            "{} by {:?}, {width} wide",
            scene.chapter.name(),
            scene.edition
        )?;
        if let Some([across, down]) = self.shape {
            write!(f, ", {across}:{down}")?;
        }
        if let Some(probe) = scene.probe {
            write!(f, ", probe {}", probe.name)?;
        }
        if !self.is_as_asked() {
            let probe = self.asked.probe.map_or("", |probe| probe.name);
            write!(f, ", said to be {} {probe}", self.asked.chapter.name())?;
        }
        for slip in &self.slips {
            write!(f, ", {}", slip.name)?;
        }
        if let Some(told) = scene.chosen.told() {
            write!(f, ", {told}")?;
        }
        if let Some(rays) = self.rays {
            let places = if rays.on_a_grid {
                "on a grid"
            } else {
                "at random"
            };
            write!(f, ", {} rays {places}", rays.count)?;
        }
        if let Some(curve) = self.curve {
            write!(f, ", {curve:?}")?;
        }
        write!(f, ", {:?}", self.format)
    }
}
