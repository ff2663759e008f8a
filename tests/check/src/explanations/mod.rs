//! Explanations: what may have drawn a picture, a file for each kind, and how long each is.
//!
//! The length of an explanation is the bits that name it and its numbers, and the bits of
//! the picture that it leaves unexplained ([`bits`](crate::bits)). What each name costs
//! stands where it is given, with its reason: a bit more is half as likely.

mod antialiased;
mod colors;
mod curve;
mod degraded;
mod more;
mod own;
mod places;
mod ramps;
mod right;
mod silhouettes;
mod slips;
mod turned;

use std::hash::{DefaultHasher, Hasher};

use ::slips::{Output, Slip};

use crate::bits::{Left, Pixel, distance};
use crate::evidence::Evidence;
use crate::reading::Reading;
use crate::scene::Scene;

pub(crate) use antialiased::{SINGLE, antialiased};
pub(crate) use colors::in_colors;
pub use curve::Curve;
pub(crate) use curve::on_a_curve;
pub use degraded::{Degradation, Filter, Quality};
pub(crate) use degraded::{degradations, doubtful, palette};
pub(crate) use more::more;
pub(crate) use own::{Path, chosen_beside_slips, chosen_otherwise, through_the_middle};
pub(crate) use places::{Places, spread};
pub(crate) use ramps::ramps;
pub(crate) use right::right;
pub(crate) use silhouettes::{outlined, silhouettes};
pub(crate) use slips::{TWO, mutants, name_of, single, two, typed};
pub(crate) use turned::turned;

/// A program that may have drawn a picture, before that is measured.
#[derive(Clone)]
pub(crate) struct Hypothesis {
    /// The scene, with what the reader chose.
    pub(crate) scene: Scene,
    /// The slips that were made.
    pub(crate) slips: Vec<&'static Slip>,
    /// What becomes of numbers that are no levels.
    pub(crate) conversion: Conversion,
    /// What happened to the picture on its way.
    pub(crate) degradation: Option<Degradation>,
    /// Bits of its name.
    pub(crate) name: f64,
}

/// What becomes of a number that is no level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conversion {
    /// It is printed, as C++ does.
    Printed,
    /// It stops at 0 or 255, as in Rust.
    Clamped,
    /// Its lowest eight bits are kept, as a cast to a byte does in C.
    Wrapped,
}

impl Conversion {
    pub(crate) fn apply(self, level: i32) -> i16 {
        match self {
            Self::Printed => level.clamp(i16::MIN.into(), i16::MAX.into()) as i16,
            Self::Clamped => level.clamp(0, 255) as i16,
            Self::Wrapped => i16::from(level as u8),
        }
    }
}

/// A program that may have drawn a picture, and how well it tells it.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// The scene, with what the reader chose.
    pub scene: Scene,
    /// The slips that were made: none, one or two.
    pub slips: Vec<&'static Slip>,
    /// What becomes of numbers that are no levels.
    pub conversion: Conversion,
    /// What else was done to the picture, and is no mistake.
    pub but: Vec<But>,
    /// What is seen, where nobody knows which line of a program does it.
    pub seen: Option<Seen>,
    /// Bits of its name.
    pub name: f64,
    /// What it leaves.
    pub left: Left,
    /// Explanations of the same picture have the same mark.
    pub mark: u64,
}

/// What a picture has that the book's does not have, and what is no mistake.
#[derive(Clone, Debug, PartialEq)]
pub enum But {
    /// Each pixel is the mean of several rays.
    Antialiased {
        /// About how many, if there are edges enough to tell.
        samples: Option<f64>,
        /// Whether they lie up to a row lower than the book's, as where the same part of a row is
        /// added and rows are counted from above.
        is_lower: bool,
    },
    /// All levels went through the same curve, as gamma correction does it.
    Curve(Curve),
    /// Something happened to it between the program and the file.
    Degraded(Degradation),
}

impl But {
    /// Whether each pixel is the mean of several rays.
    pub(crate) fn is_mean(&self) -> bool {
        matches!(self, Self::Antialiased { .. })
    }
}

/// What is seen in a picture, where nobody knows which line of a program does it.
#[derive(Clone, Debug, PartialEq)]
pub enum Seen {
    /// So little that many mistakes draw it.
    Little,
    /// The sky and the outlines of a scene, with other colors of all that is hit.
    Shaded {
        /// Whether the sky went through the gamma correction of later chapters.
        is_corrected: bool,
        /// Whether these are as uneven as means of few rays.
        is_grainy: bool,
    },
    /// All of a scene, and something more.
    More(String),
    /// Something that was done to all of it.
    Said(String),
}

impl Seen {
    /// What a sky has that went through gamma correction.
    pub(crate) fn gamma(&self) -> &'static str {
        match self {
            Self::Shaded {
                is_corrected: true, ..
            } => " with gamma correction",
            _ => "",
        }
    }

    /// The same in a sentence.
    pub(crate) fn said(&self) -> String {
        match self {
            Self::Little => "Many mistakes draw nearly this, so it says little.".to_owned(),
            Self::Shaded { .. } => format!(
                "Sky{} and outlines are right; only what is hit has other colors, as with the materials of later chapters.",
                self.gamma()
            ),
            Self::More(said) | Self::Said(said) => said.clone(),
        }
    }
}

/// One pixel in so many is a part.
const PART: usize = 8;

impl Explanation {
    /// Its length in bits.
    pub fn bits(&self) -> f64 {
        self.name + self.left.bits
    }

    /// The program, whatever happened to its picture.
    pub(crate) fn program(&self) -> Hypothesis {
        Hypothesis {
            scene: self.scene,
            slips: self.slips.clone(),
            conversion: self.conversion,
            degradation: None,
            name: self.name,
        }
    }

    /// By how much its length may be another by chance: noise by the square root of its
    /// bits, and more where one rounding spoils many pixels at once.
    pub(crate) fn give(&self) -> f64 {
        let together = self.degradation().map_or(1.0, Degradation::together);
        2.0 * (together * self.left.bits).sqrt()
    }

    /// Whether a part of the picture is as it has it, and not by chance.
    pub(crate) fn is_like(&self, reading: &Reading) -> bool {
        PART * (reading.pixels.len() - self.left.far) > reading.pixels.len()
    }

    /// What happened to the picture on its way, if anything did.
    pub(crate) fn degradation(&self) -> Option<Degradation> {
        let degradation = |but: &But| match but {
            But::Degraded(degradation) => Some(*degradation),
            _ => None,
        };
        self.but.iter().find_map(degradation)
    }
}

impl Hypothesis {
    /// Whether it is the same program, whatever happened to its picture.
    pub(crate) fn is_same_program(&self, other: &Self) -> bool {
        let names = |it: &Self| it.slips.iter().map(|slip| slip.name).collect::<Vec<_>>();
        let place = |it: &Self| {
            (
                it.scene.chapter,
                it.scene.probe,
                it.scene.edition,
                it.conversion,
            )
        };
        place(self) == place(other) && names(self) == names(other)
    }

    /// The same scene without the slips.
    pub(crate) fn without_slips(&self) -> Self {
        Self {
            slips: Vec::new(),
            ..self.clone()
        }
    }

    /// The same scene as the book has it.
    pub(crate) fn in_the_books_colors(self) -> Self {
        Self {
            scene: colors::books(&self.scene),
            name: self.name - colors::name(&self.scene),
            ..self
        }
    }

    /// What the program prints, if its picture has the reader's size.
    pub(crate) fn output(&self, reading: &Reading) -> Option<Output> {
        let own = (reading.width, reading.height);
        let before = |it: Degradation| it.size(reading);
        self.of_size(self.degradation.map_or(own, before))
    }

    fn of_size(&self, size: (u32, u32)) -> Option<Output> {
        let program = self.scene.program(&self.slips);
        // A header may swap the two, and then the width that was asked for
        // stands where the height should.
        let mut outputs = [size.0, size.1].map(|asked| program.run(asked)).into_iter();
        outputs.find(|output| output.size() == size)
    }

    /// Its whole picture.
    pub(crate) fn drawn(&self, reading: &Reading) -> Option<Vec<Pixel>> {
        let before = self.before(&self.output(reading)?);
        Some(match self.degradation {
            Some(degradation) => degradation.of(&before, reading),
            None => before,
        })
    }

    /// The picture before anything happened to it.
    fn before(&self, output: &Output) -> Vec<Pixel> {
        let levels = output.pixels();
        levels
            .map(|pixel| pixel.map(|level| self.conversion.apply(level)))
            .collect()
    }

    /// The nth pixel of what it prints, before anything happened to it.
    pub(crate) fn pixel(&self, output: &Output, n: u32) -> Pixel {
        output.pixel(n).map(|level| self.conversion.apply(level))
    }

    /// How long it is, by all pixels.
    pub(crate) fn measured(&self, reading: &Reading) -> Option<Explanation> {
        let before = self.before(&self.output(reading)?);
        let (left, mark) = match self.degradation {
            Some(Degradation::Palette { .. }) => {
                (degraded::left_in_palette(reading, &before), mark(&before))
            }
            Some(degradation) => self.left(reading, &degradation.of(&before, reading)),
            None => self.left(reading, &before),
        };
        Some(self.leaving(left, mark))
    }

    /// The same where it has been drawn.
    pub(crate) fn explaining(&self, reading: &Reading, drawn: &[Pixel]) -> Explanation {
        let (left, mark) = self.left(reading, drawn);
        self.leaving(left, mark)
    }

    fn left(&self, reading: &Reading, drawn: &[Pixel]) -> (Left, u64) {
        let left = Left::of(reading, drawn);
        (left, mark(drawn))
    }

    /// The same where it is known what it leaves.
    pub(crate) fn leaving(&self, left: Left, mark: u64) -> Explanation {
        Explanation {
            scene: self.scene,
            slips: self.slips.clone(),
            conversion: self.conversion,
            but: self.degradation.map(But::Degraded).into_iter().collect(),
            seen: None,
            name: self.name,
            left,
            mark,
        }
    }

    /// About how long it is, from some places; `None` if that is more than `most`.
    pub(crate) fn estimated(&self, reading: &Reading, places: &Places, most: f64) -> Option<f64> {
        let output = self.output(reading)?;
        let mut bits = self.name;
        for (n, pixels) in places.iter() {
            let source = |it: Degradation| it.source(n, reading);
            let Some(source) = self.degradation.map_or(Some(n), source) else {
                continue;
            };
            let drawn = self.pixel(&output, source);
            let drawn = self.degradation.map_or(drawn, |it| it.color(drawn));
            bits += pixels * estimate(drawn, reading.pixels[n as usize]);
            if bits > most {
                return None;
            }
        }
        Some(bits)
    }
}

/// The same for pictures that are the same.
fn mark(drawn: &[Pixel]) -> u64 {
    let mut hasher = DefaultHasher::new();
    for &[red, green, blue] in drawn {
        let [red, green, blue] = [red, green, blue].map(|level| u64::from(level as u16));
        hasher.write_u64(red << 32 | green << 16 | blue);
    }
    hasher.finish()
}

/// About how many bits a pixel costs to one who expects another: that chooses what is
/// measured, and decides nothing.
pub(crate) fn estimate(drawn: Pixel, found: Pixel) -> f64 {
    match distance(drawn, found) {
        0 => 0.0,
        1 => 2.0,
        off => 6.0 + f64::from(off).log2(),
    }
}
