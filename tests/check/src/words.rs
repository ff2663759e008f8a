//! What there is to say about a set of mistakes, wherever it is said.

use common::rtweekend::Color;

use slips::{Ball, Chapter, Ends, Letters, Program, Slip};

use crate::bits::{Left, Part};
use crate::explanations::{But, Conversion, Curve, Degradation, SINGLE};
use crate::scene::{Chosen, Scene, angle, is_round};
use crate::verdict::{Near, Set};

/// How near components are the same.
const NEARLY: f64 = 0.01;
/// One pixel in so many lies at a rim.
const RIM: usize = 100;

impl Set {
    /// How well the mistakes explain a picture of that many pixels.
    pub fn title(&self, pixels: usize) -> String {
        let several = self.mistakes.len() > 1;
        let both = self.mistakes[0].len() > 1;
        let who = match (several, both) {
            (false, false) => "One mistake draws",
            (true, false) => "Each of these mistakes draws",
            (false, true) => "Two mistakes together draw",
            (true, true) => "Each of these pairs of mistakes draws",
        };
        let wrapped = match self.conversion {
            Conversion::Wrapped => {
                " (if levels beyond 255 begin again at 0, as with a cast to a byte in C)"
            }
            _ => "",
        };
        let chosen = self.scene.clause();
        let chosen = chosen.map_or(String::new(), |chosen| format!(", {chosen}"));
        format!("{who} {}{wrapped}{chosen}:", self.extent(pixels))
    }

    fn extent(&self, pixels: usize) -> String {
        let (far, off) = (self.left.far, self.left.off);
        if !self.but.is_empty() {
            let left = self.left.part.filter(|_| self.but.iter().any(But::is_mean));
            let left = left.map(|_| format!(", but for {}", self.left.placed(pixels)));
            let left = left.unwrap_or_default();
            return format!("this picture, {}{left}", buts(&self.but));
        }
        match (off, far) {
            (0, _) => "exactly this picture".to_owned(),
            (_, 0) => format!("this picture, but for one level in {off} of {pixels} pixels"),
            _ => format!("this picture, but for {}", self.left.placed(pixels)),
        }
    }
}

impl Left {
    /// How many pixels are off, and where, if that is in a small part.
    pub(crate) fn placed(&self, pixels: usize) -> String {
        let span = |name: &str, [first, last]: [u32; 2]| match first == last {
            true => format!("{name} {first}"),
            false => format!("{name}s {first} to {last}"),
        };
        match self.part {
            Some(Part {
                bounds: [columns, rows],
                off,
            }) => format!(
                "{off} of {pixels} pixels in {}, {}",
                span("column", columns),
                span("row", rows)
            ),
            None => format!("{} of {pixels} pixels", self.off),
        }
    }
}

/// What was done to a picture besides.
fn buts(but: &[But]) -> String {
    let all: Vec<String> = but.iter().map(But::clause).collect();
    all.join(", and ")
}

impl Near {
    /// What it is instead of the book's picture, after "right, but".
    pub fn clause(&self, pixels: usize) -> String {
        let chosen = self.scene.clause();
        let buts = self.but.iter().map(But::clause);
        let is_on_its_way = |but: &But| matches!(but, But::Degraded(_));
        let is_by_rays = self.left.is_both_ways && !self.but.iter().any(is_on_its_way);
        // Rays that lie anywhere are off where colors change, at rims that are no edges.
        let has_rays = self.but.iter().any(But::is_mean);
        let is_little = has_rays && RIM * self.left.off <= pixels;
        let left = match (has_rays, self.left.part) {
            (true, Some(_)) => Some(format!("for {}", self.left.placed(pixels))),
            _ if is_little => None,
            _ => self
                .is_for_pixels()
                .then(|| left(&self.left, is_by_rays, pixels)),
        };
        let all: Vec<String> = chosen.into_iter().chain(buts).chain(left).collect();
        all.join(", and ")
    }

    /// Whether it is right to the last bit.
    pub fn is_exact(&self) -> bool {
        self.left.is_nothing() && self.but.is_empty() && self.scene.chosen == Chosen::default()
    }

    /// Whether there are pixels that it does not explain. With several rays a pixel every
    /// one at an edge is explained, though none to the last bit.
    pub fn is_for_pixels(&self) -> bool {
        !self.left.is_nothing()
    }
}

/// The pixels that an explanation leaves: single ones, or a rounding or noise everywhere.
fn left(left: &Left, is_by_rays: bool, pixels: usize) -> String {
    let (off, far) = (left.off, left.far);
    match (off, far) {
        (1, _) if left.is_one_by_one => format!("for {}", left.placed(pixels)),
        _ if left.is_noise(pixels) => format!(
            "with noise: {off} of {pixels} pixels are off, {far} of them by more than a level"
        ),
        (_, 0) => {
            let by = match is_by_rays {
                _ if left.is_rounding(pixels) => {
                    "as with single precision, or another order of operations"
                }
                true => "up and down, as by one random ray a pixel, or less precision",
                false => "as by another way of rounding",
            };
            format!("not to the last bit: {off} of {pixels} pixels are a level off, {by}")
        }
        _ if left.is_one_by_one => format!("for {}", left.placed(pixels)),
        _ => format!(
            "not to the last bit: {off} of {pixels} pixels are off, {far} of them by more than a level, as with less precision, noise, or a file that does not keep each level"
        ),
    }
}

impl Scene {
    /// What the reader chose, if it is not the book's.
    pub fn clause(&self) -> Option<String> {
        let ratio = self.program(&[]).aspect_ratio;
        let all: Vec<String> = [self.chosen.colors(), self.chosen.places(ratio)]
            .into_iter()
            .flatten()
            .collect();
        (!all.is_empty()).then(|| all.join(", and "))
    }
}

/// Why a viewport may be as wide as high in a picture that is not.
pub(crate) const INTEGERS: &str = ", as where width / height is an integer";

impl Chosen {
    /// Spheres, and the viewport in a picture of that ratio.
    fn places(&self, ratio: f64) -> Option<String> {
        let ball = |ball: Ball| {
            let [x, y, z, radius] =
                [ball.center.x, ball.center.y, ball.center.z, ball.radius].map(rounded);
            format!("of radius {radius} at ({x}, {y}, {z}), or farther away and as much larger")
        };
        let [sphere, ground] = self.balls;
        let sphere = sphere.map(|sphere| {
            if sphere.radius == 0.0 {
                return "no small sphere".to_owned();
            }
            format!("a sphere {}", ball(sphere))
        });
        let ground = ground.map(|ground| format!("a ground {}", ball(ground)));
        let zoom = self.viewport_height.map(|height| {
            let (high, focal_length) = (rounded(height), rounded(2.0 / height));
            match self.viewport_width.map(rounded) {
                Some(wide) if wide == high && ratio > 1.0 && ratio < 2.0 => {
                    format!("a viewport {wide} wide and {high} high one unit away{INTEGERS}")
                }
                Some(wide) => format!("a viewport {wide} wide and {high} high one unit away"),
                None if is_round(angle(height)) => {
                    format!("a field of view of {} degrees from above to below", angle(height).round())
                }
                None => format!(
                    "a viewport {high} high one unit away, or a focal length of {focal_length} and one 2 high"
                ),
            }
        });
        let all: Vec<String> = [sphere, ground, zoom].into_iter().flatten().collect();
        (!all.is_empty()).then(|| {
            format!(
                "in a scene of your own, if you chose it: {}",
                all.join(", and ")
            )
        })
    }

    /// How many times as bright as the book's all that is drawn is, if it is: a sum of rays that is
    /// divided by another number than theirs.
    pub(crate) fn times(&self) -> Option<f64> {
        let [below, above] = self.sky?;
        let times = below.x;
        let is_near = |one: f64, other: f64| (one - times * other).abs() < NEARLY;
        let [white, blue] = Program::right(Chapter::Gradient).sky;
        let components = [below, above].into_iter().zip([white, blue]);
        let mut pairs =
            components.flat_map(|(own, book)| own.to_array().into_iter().zip(book.to_array()));
        let are_scaled = |shade: [Ends; 3]| {
            let mut ends = shade.into_iter().enumerate();
            ends.all(|(n, (axis, [low, high]))| {
                axis == n && is_near(low, 0.0) && is_near(high, 1.0)
            })
        };
        // Where blue is full it can't be brighter.
        let is_scaled = pairs.all(|(own, book)| is_near(own, book) || own == 1.0 && times > 1.0);
        let is_another = (times - 1.0).abs() > NEARLY;
        let is_scaled = is_another && is_scaled && self.shade.is_some_and(are_scaled);
        is_scaled.then_some(times)
    }

    fn colors(&self) -> Option<String> {
        if let Some(times) = self.times() {
            return Some(format!(
                "with all colors {} times the book's, as where a sum of rays is divided by another number than theirs",
                rounded(times)
            ));
        }
        let color = |color: Color| {
            let [r, g, b] = color.to_array().map(rounded);
            format!("({r}, {g}, {b})")
        };
        let sky = self.sky.map(|[below, above]| match below == above {
            true => format!("a sky of {}", color(below)),
            false => {
                let (low, high) = (color(below), color(above));
                let unless = match above {
                    Color::ONE => " (or upside down)",
                    _ => "",
                };
                format!("a sky from {low} below to {high} above{unless}")
            }
        });
        let paint = self
            .paint
            .map(|paint| format!("a sphere of {}", color(paint)));
        let blue = self.blue.map(|blue| format!("blue {}", rounded(blue)));
        let shade = self.shade.map(|shade| {
            if shade.iter().all(|(_, [low, high])| low == high) {
                return format!("hits of {}", color(shade.map(|(_, [low, _])| low).into()));
            }
            let [(red, [left, right]), (green, [low, high]), _] = shade;
            let mirrored = match (red == 0 && left > right, green == 1 && low > high) {
                (true, true) => " (or turned by half a turn)",
                (true, false) => " (or mirrored)",
                (false, true) => " (or upside down)",
                (false, false) => "",
            };
            let all = ["red", "green", "blue"].into_iter().zip(shade);
            let all: Vec<String> = all.map(made_of).collect();
            format!("hits with {} by the normal N{mirrored}", all.join(", "))
        });
        let all: Vec<String> = [sky, paint, shade, blue].into_iter().flatten().collect();
        (!all.is_empty()).then(|| {
            format!(
                "in colors of your own, if you chose them: {}",
                all.join(" and ")
            )
        })
    }
}

/// Of what a component of a hit's color is made.
fn made_of((component, (axis, [low, high])): (&str, Ends)) -> String {
    let (times, plus) = (rounded((high - low) / 2.0), rounded((low + high) / 2.0));
    match times {
        0.0 => format!("{component} {plus}"),
        _ => format!("{component} {times} * N.{} + {plus}", ["x", "y", "z"][axis]),
    }
}

impl But {
    fn clause(&self) -> String {
        match self {
            Self::Antialiased { samples, is_lower } => {
                let count = match samples {
                    Some(samples) if *samples < SINGLE => {
                        "one ray a pixel, anywhere in it".to_owned()
                    }
                    Some(samples) if *samples < 150.0 => {
                        format!(
                            "about {} samples a pixel, or fewer on a grid",
                            about(*samples)
                        )
                    }
                    Some(_) => "a hundred samples a pixel or more".to_owned(),
                    None => "several samples a pixel".to_owned(),
                };
                let lower = match is_lower {
                    true => ", up to a row lower, as where rows are counted from above",
                    false => "",
                };
                format!("antialiased, with {count}{lower}: that is the next chapter of the book")
            }
            Self::Curve(curve) => curve.clause(),
            Self::Degraded(degradation) => degradation.clause(),
        }
    }
}

impl Degradation {
    /// What happened, after a comma.
    pub fn clause(&self) -> String {
        match self {
            Self::Scaled {
                from: (width, height),
                ..
            } => {
                format!("scaled on its way, from {width} × {height} pixels")
            }
            Self::Cropped {
                from: (width, height),
                ..
            } => {
                format!(
                    "cropped on its way, or by loops that end early: of {width} × {height} pixels rows or columns are missing"
                )
            }
            Self::Gray(weights) => {
                let names = ["red", "green", "blue"].into_iter().zip(weights);
                let alone = names
                    .filter(|(_, weight)| **weight == 1.0)
                    .map(|(name, _)| name);
                let alone = alone.map(|name| format!(", each component as {name} should be"));
                format!("in gray{}", alone.collect::<String>())
            }
            Self::Palette { colors } => {
                format!("in a palette of {colors} colors, as a GIF has it")
            }
            Self::Jpeg(quality) => {
                let percent = quality.percent;
                format!("through JPEG of a quality about {percent}, which changes levels")
            }
        }
    }
}

impl Curve {
    fn clause(&self) -> String {
        format!("with all levels on a curve{}", self.points())
    }

    /// The same beside what is seen.
    pub(crate) fn said(&self) -> String {
        format!("All levels are on a curve{}.", self.points())
    }

    fn points(&self) -> String {
        let ends = self.examples();
        let ends: Vec<String> = ends
            .map(|(level, found)| format!("{level} is {found}"))
            .collect();
        let power = self.power.map_or(String::new(), |power| {
            format!(", near the power {power:.2}, as gamma correction has it")
        });
        format!("{power}: {}", ends.join(", "))
    }
}

/// To a thousandth. A zero has no sign here.
fn rounded(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0 + 0.0
}

/// With one digit that counts: nobody could tell 90 samples from 100.
fn about(samples: f64) -> f64 {
    let scale = 10_f64.powf(samples.max(1.0).log10().floor());
    (samples / scale).round().max(1.0) * scale
}

/// The names of slips that were made together. Of one without a name, what it says in the
/// chapter's own words.
pub fn names_of(mistake: &[&'static Slip]) -> String {
    let name = |slip: &&'static Slip| match slip.name {
        "" => slip.words(Letters::Rust, slip.chapters[0]).wrong,
        name => name.into(),
    };
    let names: Vec<_> = mistake.iter().map(name).collect();
    names.join(" and ")
}
