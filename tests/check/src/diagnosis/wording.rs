//! What there is to say about a set of mistakes, wherever it is said.

use crate::names::companion;
use common::rtweekend::Color;

use super::{But, Chosen, Conversion, Curve, Explains, Near, Scene, Set};
use slips::{Ball, Slip};

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
        let chosen = self.scene.chosen.told();
        let chosen = chosen.map_or(String::new(), |chosen| format!(", {chosen}"));
        format!("{who} {}{wrapped}{chosen}:", self.extent(pixels))
    }

    /// How to find out which mistake it is, if there are several.
    pub fn how_to_tell(&self, scene: &Scene) -> String {
        if self.mistakes.len() < 2 {
            return String::new();
        }
        let Some(telling) = &self.telling else {
            return "\n  This picture can't tell them apart, and no probe can: look for each.\n"
                .to_owned();
        };
        let group = |group: &Vec<usize>| {
            let names: Vec<String> = group.iter().map(|&n| names_of(&self.mistakes[n])).collect();
            names.join(", ")
        };
        let groups: Vec<String> = telling.groups.iter().map(group).collect();
        let (name, probe) = (scene.chapter.name(), telling.probe.name);
        format!(
            "\n  This picture can't tell them apart. The probe {probe} can: {}.\n  Change your program to\n    {}\n  and then: {} check {name} --probe {probe} PICTURE\n",
            groups.join(" | "),
            telling.probe.lines(scene.chapter).replace('\n', "\n    "),
            companion(),
        )
    }

    fn extent(&self, pixels: usize) -> String {
        let (far, off, compared) = (self.fit.far, self.fit.off, self.fit.compared);
        match self.explains {
            Explains::All if compared == pixels => "exactly this picture".to_owned(),
            Explains::All => format!("this picture in all {compared} pixels that were compared"),
            Explains::AllButOneLevel => {
                format!("this picture, but for one level in {off} of {compared} pixels")
            }
            Explains::Antialiased => {
                "this picture, if each pixel is the mean of several rays".to_owned()
            }
            Explains::Most if far > 0 => format!(
                "most of this picture, but not all: {far} of {compared} pixels are still wrong"
            ),
            Explains::Most => format!(
                "most of this picture, but not all: {off} of {compared} pixels are still a level off"
            ),
        }
    }
}

impl Near {
    /// What it is instead of the book's picture, after "right, but".
    pub fn told(&self) -> String {
        let chosen = self.scene.chosen.told();
        let buts = self.but.iter().map(But::told);
        let all: Vec<String> = chosen.into_iter().chain(buts).collect();
        all.join(", and ")
    }
}

impl Chosen {
    /// What the reader chose, if it is not the book's.
    pub fn told(&self) -> Option<String> {
        let all: Vec<String> = [self.colors(), self.places()]
            .into_iter()
            .flatten()
            .collect();
        (!all.is_empty()).then(|| all.join(", and "))
    }

    fn places(&self) -> Option<String> {
        let ball = |ball: Ball| {
            let [x, y, z, radius] =
                [ball.center.x, ball.center.y, ball.center.z, ball.radius].map(rounded);
            format!("of radius {radius} at ({x}, {y}, {z})")
        };
        let [sphere, ground] = self.balls;
        let sphere = sphere.map(|sphere| {
            if sphere.radius == 0.0 {
                return "no small sphere".to_owned();
            }
            format!(
                "a sphere {}, or farther away and as much larger",
                ball(sphere)
            )
        });
        let ground = ground.map(|ground| format!("a ground {}", ball(ground)));
        let zoom = self.viewport_height.map(|height| {
            format!(
                "a viewport {} high, or another focal length",
                rounded(height)
            )
        });
        let all: Vec<String> = [sphere, ground, zoom].into_iter().flatten().collect();
        (!all.is_empty()).then(|| format!("in a scene of your own: {}", all.join(" and ")))
    }

    fn colors(&self) -> Option<String> {
        let color = |color: Color| {
            let [r, g, b] = color.to_array().map(rounded);
            format!("({r}, {g}, {b})")
        };
        let sky = self.sky.map(|[below, above]| match below == above {
            true => format!("a sky of {}", color(below)),
            false => format!(
                "a sky from {} below to {} above",
                color(below),
                color(above)
            ),
        });
        let paint = self
            .paint
            .map(|paint| format!("a sphere of {}", color(paint)));
        let blue = self.blue.map(|blue| format!("blue {}", rounded(blue)));
        let all: Vec<String> = [sky, paint, blue].into_iter().flatten().collect();
        (!all.is_empty()).then(|| format!("in colors of your own: {}", all.join(" and ")))
    }
}

impl But {
    fn told(&self) -> String {
        match self {
            Self::Antialiased { samples } => {
                let count = match samples {
                    Some(samples) if *samples < 150.0 => {
                        format!(
                            "about {} samples a pixel, or fewer on a grid",
                            about(*samples)
                        )
                    }
                    Some(_) => "a hundred samples a pixel or more".to_owned(),
                    None => "several samples a pixel".to_owned(),
                };
                format!("antialiased, with {count}: that is the next chapter of the book")
            }
            Self::Curve(curve) => curve.told(),
            Self::Rounded {
                off,
                far: 0,
                compared,
            } => format!(
                "not to the last bit: {off} of {compared} pixels are a level off, as by another way of rounding"
            ),
            Self::Rounded { off, far, compared } => format!(
                "not to the last bit: of {compared} pixels {off} are off, all by a level but {far} at edges, as with less precision"
            ),
        }
    }
}

impl Curve {
    fn told(&self) -> String {
        let ends = self.examples();
        let ends: Vec<String> = ends
            .map(|(level, found)| format!("{level} is {found}"))
            .collect();
        let power = self.power.map_or(String::new(), |power| {
            format!(", near the power {power:.2}, as gamma correction has it")
        });
        format!("with all levels on a curve{power}: {}", ends.join(", "))
    }
}

/// To a thousandth.
fn rounded(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0
}

/// With one digit that counts: nobody could tell 90 samples from 100.
fn about(samples: f64) -> f64 {
    let scale = 10_f64.powf(samples.max(1.0).log10().floor());
    (samples / scale).round().max(1.0) * scale
}

/// The names of slips that were made together.
pub fn names_of(mistake: &[&Slip]) -> String {
    let names: Vec<&str> = mistake.iter().map(|slip| slip.name).collect();
    names.join(" and ")
}
