//! Exact comparison of a picture with that of a program: some pixels first, then all of them.

use std::hash::{DefaultHasher, Hash, Hasher};

use slips::{Output, Slip};

use crate::pixels::{Pixel, distance, spread};
use crate::reading::Reading;
use crate::task::Task;

/// A program that may have drawn a picture.
#[derive(Clone)]
pub(crate) struct Candidate {
    /// The task that the program draws.
    pub(crate) task: Task,
    /// The slips that are made in the program; none if it is right.
    pub(crate) slips: Vec<&'static Slip>,
    /// The treatment of numbers that are no levels.
    pub(crate) conversion: Conversion,
}

/// The treatment of a color component that is no level from 0 to 255: printed, clamped or wrapped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conversion {
    /// The number is printed as it is, as in C++.
    Printed,
    /// The number becomes 0 or 255, the nearer one, as in Rust.
    Clamped,
    /// The lowest eight bits of the number are kept, as a cast to a byte does in C.
    Wrapped,
}

/// The pixels of a reader's picture for which the program that explains it gives another color:
/// their number, and the columns and rows in which they lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unexplained {
    /// Number of pixels that differ at all.
    pub off: usize,
    /// Number of pixels that differ by more than one level in a component.
    pub far: usize,
    /// The first and the last column with such a pixel, counted from 0; both 0 if there is none.
    pub columns: [u32; 2],
    /// The first and the last row with such a pixel, counted from 0 at the top; both 0 if there is
    /// none.
    pub rows: [u32; 2],
}

/// A comparison of a sample of pixels of a program with the reader's.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SampleComparison {
    /// Number of pixels of the sample that differ at all.
    pub(crate) off: usize,
    /// Number of pixels of the sample that differ by more than one level in a component.
    pub(crate) far: usize,
    /// A hash of the program's pixels in the sample: equal for programs that draw the same.
    pub(crate) mark: u64,
}

/// The size of the sample that is compared before all pixels are.
const GLANCE: u32 = 100;
/// The number of pixels of the sample that may differ by chance, beyond twice the expected number.
const CHANCE: usize = 4;

/// A mistake explains most of a picture if it leaves at most 1 wrong pixel in `MOST`.
const MOST: usize = 4;
/// A mistake explains nearly all of a picture if it leaves at most 1 wrong pixel in `NEARLY_ALL`.
const NEARLY_ALL: usize = 100;

impl Candidate {
    /// Runs the program; `None` if its picture has another size than the reader's.
    pub(crate) fn output(&self, reading: &Reading) -> Option<Output> {
        let program = self.task.program(&self.slips);
        let size = (reading.width, reading.height);
        // A header may swap the two, and then the width that was asked for
        // stands where the height should.
        let fitting = |asked| Some(program.run(asked)).filter(|output| output.size() == size);
        fitting(size.0).or_else(|| fitting(size.1))
    }

    /// Returns the `n`th printed pixel of the output, after the conversion.
    pub(crate) fn pixel(&self, output: &Output, n: u32) -> Pixel {
        output.pixel(n).map(|level| self.conversion.apply(level))
    }

    /// Returns true if, judged by a sample of [`GLANCE`] pixels, the program may leave at most
    /// `most` pixels unexplained.
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

    /// Compares a sample of `count` pixels with the reader's; `None` if the sizes differ.
    pub(crate) fn compare_sample(&self, reading: &Reading, count: u32) -> Option<SampleComparison> {
        let output = self.output(reading)?;
        let mut sample = SampleComparison::default();
        let mut hasher = DefaultHasher::new();
        for n in spread(count, reading.pixels.len() as u32) {
            let pixel = self.pixel(&output, n);
            let off = distance(pixel, reading.pixels[n as usize]);
            sample.off += usize::from(off > 0);
            sample.far += usize::from(off > 1);
            pixel.hash(&mut hasher);
        }
        sample.mark = hasher.finish();
        Some(sample)
    }

    /// Compares all pixels with the reader's. `None` if the sizes differ, or if more than `most`
    /// pixels differ and one of them by more than a level.
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

    /// Iterates over all pixels of the program, row by row from the top; `None` if the sizes
    /// differ.
    fn pixels<'a>(&'a self, reading: &'a Reading) -> Option<Box<dyn Iterator<Item = Pixel> + 'a>> {
        let output = self.output(reading)?;
        // The right picture is drawn sooner by what is compiled.
        let is_compiled = self.slips.is_empty() && self.task.is_as_compiled();
        if is_compiled && self.conversion != Conversion::Wrapped {
            let right = self.task.right_picture(reading.width, reading.height);
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
    /// Turns a number into what a file has for it.
    pub(crate) fn apply(self, level: i32) -> i16 {
        match self {
            Self::Printed => level.clamp(i16::MIN.into(), i16::MAX.into()) as i16,
            Self::Clamped => level.clamp(0, 255) as i16,
            Self::Wrapped => i16::from(level as u8),
        }
    }
}

impl Unexplained {
    /// Returns all pixels of the picture, each as off by more than a level.
    pub(crate) fn all(reading: &Reading) -> Self {
        Self {
            off: reading.pixels.len(),
            far: reading.pixels.len(),
            columns: [0, reading.width - 1],
            rows: [0, reading.height - 1],
        }
    }

    /// Adds a pixel that is `off` levels off. Pixels come row by row from the top.
    fn add(&mut self, column: u32, row: u32, off: u16) {
        if self.off == 0 {
            (self.columns, self.rows) = ([column; 2], [row; 2]);
        }
        self.off += 1;
        self.far += usize::from(off > 1);
        self.columns = [self.columns[0].min(column), self.columns[1].max(column)];
        self.rows[1] = row;
    }

    /// Returns true if these pixels are few beside `all` that the right program leaves unexplained:
    /// one in [`NEARLY_ALL`], or one in [`MOST`] and as few of those that are off by more than a
    /// level, if there are any in `all`.
    pub(crate) fn is_little_of(&self, all: &Self) -> bool {
        let is_most = MOST * self.off <= all.off && MOST * self.far <= all.far;
        self.is_nearly_nothing_of(all) || is_most && all.far > 0
    }

    /// Returns true if these pixels are none, or at most one in [`NEARLY_ALL`] of `all`.
    pub(crate) fn is_nearly_nothing_of(&self, all: &Self) -> bool {
        self.is_nothing() || NEARLY_ALL * self.off <= all.off
    }

    /// Returns true if no pixel is unexplained.
    pub(crate) fn is_nothing(&self) -> bool {
        self.off == 0
    }

    /// Returns true if there are such pixels, and all of them are off by one level.
    pub(crate) fn is_rounding(&self) -> bool {
        self.off > 0 && self.far == 0
    }
}
