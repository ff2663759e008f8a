//! Pattern search (Hooke and Jeeves, 1961): spheres and the field of view as a reader
//! chose them, from the picture.
//!
//! Each number is moved a step up or down as long as that brings the scene's picture
//! nearer to the reader's; then the steps are halved. It finds what is near the place
//! where it begins, so that has to be good: the box around what is not background.

use std::ops::Range;

use common::rtweekend::Point3;

use ::slips::{Ball, Chapter, Program, Room};

use super::{Evidence, Hypothesis, spread};
use crate::bits::{distance, number};
use crate::reading::Reading;
use crate::scene::{Chosen, Scene};

/// How many pixels are compared for each step.
const LOOK: u32 = 2000;
/// A pixel that is off by more levels counts no more: it may be another color for any
/// reason.
const FAR: u16 = 24;

/// How often steps are halved: to half a thousandth of a unit, from a tenth.
const HALVINGS: u32 = 8;
/// Numbers are simple if they are so many to the unit, the earlier the simpler.
const GRIDS: [f64; 6] = [1.0, 2.0, 4.0, 10.0, 20.0, 100.0];
/// How far away a sphere may be thought to be.
const DISTANCES: [f64; 5] = [1.0, 2.0, 1.5, 3.0, 5.0];

fn to_grid(number: f64, grid: f64) -> f64 {
    // A zero has no sign here.
    (number * grid).round() / grid + 0.0
}

/// That the scene is the reader's own, beside its numbers.
const NAME: f64 = 8.0;

/// The program with spheres or a field of view of the reader's own: each with numbers of
/// more and of fewer digits.
pub(crate) fn own_spheres(evidence: &Evidence, right: &Hypothesis) -> Vec<Hypothesis> {
    if evidence.has_no_levels || evidence.reading.is_plain() {
        return Vec::new();
    }
    let fit = Fit::new(&right.scene, evidence.reading);
    let own = [
        fit.first_sphere(),
        fit.ground(&right.scene),
        fit.ground(&fit.without_first_sphere()),
        fit.zoom(),
    ];
    let named = |scene: Scene| {
        let Chosen {
            balls,
            viewport_height,
            ..
        } = scene.chosen;
        let balls = balls.into_iter().flatten();
        let numbers = balls
            .flat_map(|Ball { center, radius }| [center.x, center.y, center.z, radius])
            .chain(viewport_height);
        Hypothesis {
            scene,
            name: right.name + NAME + numbers.map(number).sum::<f64>(),
            ..right.clone()
        }
    };
    own.into_iter().flatten().map(named).collect()
}

/// A picture that a scene is fitted to.
struct Fit<'a> {
    scene: &'a Scene,
    reading: &'a Reading,
    places: Vec<u32>,
}

impl<'a> Fit<'a> {
    fn new(scene: &'a Scene, reading: &'a Reading) -> Self {
        Self {
            scene,
            reading,
            places: spread(LOOK, reading.pixels.len() as u32).collect(),
        }
    }

    /// How far the picture of a scene is from the reader's, in levels, as far as that is
    /// less than `most`.
    fn off(&self, scene: &Scene, most: u32) -> u32 {
        let output = scene.program(&[]).run(self.reading.width);
        let mut sum = 0;
        for &n in &self.places {
            let drawn = output.pixel(n).map(|level| level.clamp(0, 255) as i16);
            sum += u32::from(distance(drawn, self.reading.pixels[n as usize]).min(FAR));
            if sum >= most {
                break;
            }
        }
        sum
    }

    /// The first sphere elsewhere or of another size. Farther away and as much larger it
    /// is the same picture, so any distance will do that makes all its numbers simple.
    fn first_sphere(&self) -> Vec<Scene> {
        if self.scene.chapter.room() == Room::None || self.scene.probe.is_some() {
            return Vec::new();
        }
        let with = |[x, y, z, radius]: [f64; 4]| {
            let mut chosen = self.scene.chosen;
            chosen.balls[0] = Some(Ball::new(x, y, z, radius.abs()));
            self.scene.with(chosen)
        };
        let Some(start) = self.seen_ball() else {
            return Vec::new();
        };
        let start = [start.center.x, start.center.y, start.radius];
        let found = self.searched(start, [0.1; 3], |[x, y, radius]| with([x, y, -1.0, radius]));
        let simple = |distance: f64, grid: f64| {
            let [x, y, radius] = found.map(|number| to_grid(number * distance, grid));
            [x, y, -distance, radius]
        };
        // Somewhere a fine grid has a point near any number, so it is for one distance only.
        let (coarse, fine) = GRIDS.split_at(4);
        let all = DISTANCES
            .into_iter()
            .flat_map(|distance| coarse.iter().map(move |grid| (distance, *grid)))
            .chain(fine.iter().map(|grid| (1.0, *grid)))
            .map(|(distance, grid)| simple(distance, grid));
        all.filter(|[.., radius]| *radius > 0.0).map(with).collect()
    }

    /// The scene with a first sphere of no size, which is none.
    fn without_first_sphere(&self) -> Scene {
        let mut chosen = self.scene.chosen;
        chosen.balls[0] = Some(Ball::new(0.0, 0.0, -1.0, 0.0));
        self.scene.with(chosen)
    }

    /// The second sphere of the list higher or lower, or of another size.
    fn ground(&self, scene: &Scene) -> Vec<Scene> {
        if self.scene.chapter != Chapter::HittableList || self.scene.probe.is_some() {
            return Vec::new();
        }
        let with = |[top, radius]: [f64; 2]| {
            let mut chosen = scene.chosen;
            chosen.balls[1] = Some(Ball::new(0.0, top - radius, -1.0, radius));
            scene.with(chosen)
        };
        let [top, radius] = self.searched([-0.5, 100.0], [0.4, 60.0], with);
        let all = GRIDS.into_iter().flat_map(|fine| {
            let coarse = [0.1].into_iter().chain(GRIDS);
            coarse.map(move |grid| [to_grid(top, fine), to_grid(radius, grid)])
        });
        all.map(with).collect()
    }

    /// The same scene through a higher or lower viewport.
    fn zoom(&self) -> Vec<Scene> {
        if self.scene.chapter == Chapter::BuildTest {
            return Vec::new();
        }
        let with = |[height]: [f64; 1]| {
            let viewport_height = Some(height);
            self.scene.with(Chosen {
                viewport_height,
                ..self.scene.chosen
            })
        };
        let starts = (-8..=8).map(|n| 2.0 * (f64::from(n) / 4.0).exp());
        let start = starts
            .min_by_key(|&start| self.off(&with([start]), u32::MAX))
            .unwrap_or(2.0);
        let [height] = self.searched([start], [start / 8.0], with);
        // Who types a width, or a focal length, has a height with many digits.
        let ratio = f64::from(self.reading.width) / f64::from(self.reading.height);
        let all = GRIDS.into_iter().flat_map(|grid| {
            let (width, focal_length) =
                (to_grid(height * ratio, grid), to_grid(2.0 / height, grid));
            [to_grid(height, grid), width / ratio, 2.0 / focal_length]
        });
        let is_some = |height: &f64| *height > 0.0 && height.is_finite();
        all.filter(is_some).map(|height| with([height])).collect()
    }

    /// Moves numbers by smaller and smaller steps while that brings the picture nearer.
    fn searched<const N: usize>(
        &self,
        start: [f64; N],
        mut steps: [f64; N],
        with: impl Fn([f64; N]) -> Scene,
    ) -> [f64; N] {
        let (mut numbers, mut least) = (start, self.off(&with(start), u32::MAX));
        let mut halvings = 0;
        while halvings < HALVINGS {
            let mut is_nearer = false;
            for (n, way) in (0..N).flat_map(|n| [(n, 1.0), (n, -1.0)]) {
                let mut moved = numbers;
                moved[n] += way * steps[n];
                let moved_off = self.off(&with(moved), least);
                if moved_off < least {
                    (numbers, least, is_nearer) = (moved, moved_off, true);
                }
            }
            if !is_nearer {
                steps = steps.map(|step| step / 2.0);
                halvings += 1;
            }
        }
        numbers
    }

    /// The sphere one unit away that fills the box around all that is not background.
    fn seen_ball(&self) -> Option<Ball> {
        let (width, height) = (self.reading.width, self.reading.height);
        let program = self.scene.program(&[]);
        let background = Program {
            world: &program.world[1..],
            ..program
        };
        let output = background.run(width);
        let (mut columns, mut rows): (Option<Range<u32>>, Option<Range<u32>>) = (None, None);
        for n in spread(BOX, self.reading.pixels.len() as u32) {
            let drawn = output.pixel(n).map(|level| level.clamp(0, 255) as i16);
            if distance(drawn, self.reading.pixels[n as usize]) > 4 {
                let (i, j) = (n % width, n / width);
                let columns = columns.get_or_insert(i..i + 1);
                *columns = columns.start.min(i)..columns.end.max(i + 1);
                let rows = rows.get_or_insert(j..j + 1);
                *rows = rows.start.min(j)..rows.end.max(j + 1);
            }
        }
        let camera = program.camera(width);
        let corner = |i: u32, j: u32| {
            (program.ray)(&program, &camera, i.min(width - 1), j.min(height - 1)).direction
        };
        let (columns, rows) = (columns?, rows?);
        let (from, to) = (
            corner(columns.start, rows.start),
            corner(columns.end, rows.end),
        );
        let middle: Point3 = 0.5 * (from + to);
        // The disc's radius is the tangent of an angle whose sine is the sphere's.
        let on_viewport = 0.25 * ((to.x - from.x).abs() + (to.y - from.y).abs());
        let radius = on_viewport / on_viewport.hypot(1.0);
        Some(Ball::new(middle.x, middle.y, -1.0, radius))
    }
}

/// In how many pixels the box is looked for: all of a picture 400 pixels wide.
const BOX: u32 = 100_000;
