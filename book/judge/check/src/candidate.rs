//! Exact comparison: a program that may have drawn a picture, and the pixels that it leaves.

use std::hash::{DefaultHasher, Hash, Hasher};

use slips::{Output, Slip};

use crate::pixels::{Pixel, distance, spread};
use crate::reading::Reading;
use crate::task::Task;

/// A program that may have drawn a picture.
#[derive(Clone)]
pub(crate) struct Candidate {
    /// The scene.
    pub(crate) task: Task,
    /// The slips that were made.
    pub(crate) slips: Vec<&'static Slip>,
    /// What becomes of numbers that are no levels.
    pub(crate) conversion: Conversion,
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

/// The pixels of a picture that a program does not draw.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unexplained {
    /// How many are off at all.
    pub off: usize,
    /// How many are off by more than one level.
    pub far: usize,
    /// The first and the last column of these pixels.
    pub columns: [u32; 2],
    /// The first and the last row.
    pub rows: [u32; 2],
}

/// Some pixels of a program beside the reader's.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Look {
    /// How many are off at all.
    pub(crate) off: usize,
    /// How many are off by more than one level.
    pub(crate) far: usize,
    /// A hash of these pixels: programs that draw them share it.
    pub(crate) mark: u64,
}

/// How many pixels are looked at before all of them are.
const GLANCE: u32 = 100;
/// By chance so many more of these may be off than of all.
const CHANCE: usize = 4;

/// A mistake that leaves pixels leaves at most one in so many of those that are wrong; where
/// it leaves one in a hundred, it may be of any of them.
const MOST: usize = 4;
const NEARLY_ALL: usize = 100;

impl Candidate {
    /// Returns what the program prints, if its picture has the reader's size.
    pub(crate) fn output(&self, reading: &Reading) -> Option<Output> {
        let program = self.task.program(&self.slips);
        let size = (reading.width, reading.height);
        // A header may swap the two, and then the width that was asked for
        // stands where the height should.
        let fitting = |asked| Some(program.run(asked)).filter(|output| output.size() == size);
        fitting(size.0).or_else(|| fitting(size.1))
    }

    /// The nth pixel of what it prints.
    pub(crate) fn pixel(&self, output: &Output, n: u32) -> Pixel {
        output.pixel(n).map(|level| self.conversion.apply(level))
    }

    /// Returns true if it may leave no more than `most` pixels, by the look of some.
    pub(crate) fn may_leave(&self, reading: &Reading, most: usize) -> bool {
        let Some(output) = self.output(reading) else {
            return false;
        };
        let total = reading.pixels.len();
        let allowed = CHANCE + 2 * (most.min(total) * GLANCE as usize / total);
        let places = spread(GLANCE, total as u32);
        let far =
            places.filter(|&n| distance(self.pixel(&output, n), reading.pixels[n as usize]) > 1);
        far.take(allowed + 1).count() <= allowed
    }

    /// Returns what so many of its pixels are beside the reader's, if its picture has the same
    /// size.
    pub(crate) fn look(&self, reading: &Reading, count: u32) -> Option<Look> {
        let output = self.output(reading)?;
        let mut look = Look::default();
        let mut hasher = DefaultHasher::new();
        for n in spread(count, reading.pixels.len() as u32) {
            let pixel = self.pixel(&output, n);
            let off = distance(pixel, reading.pixels[n as usize]);
            look.off += usize::from(off > 0);
            look.far += usize::from(off > 1);
            pixel.hash(&mut hasher);
        }
        look.mark = hasher.finish();
        Some(look)
    }

    /// The pixels that it leaves; `None` if they are more than `most`, and some of them are
    /// off by more than a level.
    pub(crate) fn unexplained(&self, reading: &Reading, most: usize) -> Option<Unexplained> {
        let mut unexplained = Unexplained::default();
        let pixels = self.pixels(reading)?;
        for (n, (pixel, found)) in (0..).zip(pixels.zip(&reading.pixels)) {
            let off = distance(pixel, *found);
            if off > 0 {
                unexplained.add(n % reading.width, n / reading.width, off);
                if unexplained.far > 0 && unexplained.off > most {
                    return None;
                }
            }
        }
        Some(unexplained)
    }

    /// All that it prints, if its picture has the reader's size.
    fn pixels<'a>(&'a self, reading: &'a Reading) -> Option<Box<dyn Iterator<Item = Pixel> + 'a>> {
        let output = self.output(reading)?;
        // The right picture is drawn sooner by what is compiled.
        let is_compiled = self.slips.is_empty() && self.task.is_as_compiled();
        if is_compiled && self.conversion != Conversion::Wrapped {
            let right = self.task.right(reading.width, reading.height);
            let pixels = (0..reading.pixels.len()).map(move |n| {
                let level = |channel: usize| right.rgb()[3 * n + channel].into();
                [level(0), level(1), level(2)]
            });
            return Some(Box::new(pixels));
        }
        let all = 0..reading.pixels.len() as u32;
        Some(Box::new(all.map(move |n| self.pixel(&output, n))))
    }
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

impl Unexplained {
    /// The whole picture.
    pub(crate) fn all(reading: &Reading) -> Self {
        Self {
            off: reading.pixels.len(),
            far: reading.pixels.len(),
            columns: [0, reading.width - 1],
            rows: [0, reading.height - 1],
        }
    }

    fn add(&mut self, column: u32, row: u32, off: u16) {
        if self.off == 0 {
            (self.columns, self.rows) = ([column; 2], [row; 2]);
        }
        self.off += 1;
        self.far += usize::from(off > 1);
        self.columns = [self.columns[0].min(column), self.columns[1].max(column)];
        self.rows[1] = row;
    }

    /// Returns true if a mistake that leaves this explains what a right program leaves: nearly all
    /// of it, or most of it and of what is off by more than a level.
    pub(crate) fn is_little_of(&self, all: &Self) -> bool {
        let is_most = MOST * self.off <= all.off && MOST * self.far <= all.far;
        self.is_nearly_nothing_of(all) || is_most && all.far > 0
    }

    /// Returns true if it explains nearly all of that.
    pub(crate) fn is_nearly_nothing_of(&self, all: &Self) -> bool {
        self.is_nothing() || NEARLY_ALL * self.off <= all.off
    }

    /// Returns true if nothing is left.
    pub(crate) fn is_nothing(&self) -> bool {
        self.off == 0
    }

    /// Returns true if all that is left is off by one level.
    pub(crate) fn is_rounding(&self) -> bool {
        self.off > 0 && self.far == 0
    }
}
