//! A program that may have drawn a picture, and its exact comparison with that picture.

use std::hash::{DefaultHasher, Hash, Hasher};

use interpreter::Canvas;
use slips::{ChapterProgram, Output, Slip};

use crate::generated::Generated;
use crate::pixels::{Pixel, distance, spread};
use crate::reading::Reading;
use crate::task::Task;
use crate::work::{self, Work};

/// A program that may have drawn a picture.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// The task that the program draws.
    pub task: Task,
    /// The slips (known mistakes) that are made in the program; none if it is right.
    pub slips: Vec<&'static Slip>,
    /// The treatment of numbers that are no levels.
    pub conversion: Conversion,
    /// A single edit of the program that no slip makes; `None` for none.
    pub(crate) edit: Option<Generated>,
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
    /// Number of pixels of the picture.
    pub total: usize,
    /// Number of pixels that were compared: all, or a part of a large picture.
    pub compared: usize,
    /// Number of pixels that differ at all.
    pub off: usize,
    /// Number of pixels that differ by more than one level in a component.
    pub far: usize,
    /// The largest difference of a component, in levels.
    pub levels: u16,
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

/// The picture of a program, drawn pixel by pixel for its price.
pub(crate) struct Drawn<'a> {
    reading: &'a Reading,
    work: &'a Work,
    source: Source,
    conversion: Conversion,
    price: u64,
    /// True if the program has an edit that no slip makes: where it stops, it draws nothing.
    is_edited: bool,
}

/// What computes the pixels of a picture.
enum Source {
    /// A program that prints them.
    Output(Output),
    /// The picture alone, in the order of a right loop.
    Canvas(Canvas),
}

/// What is no pixel: such numbers stand in no picture that is explained.
const NO_PIXEL: Pixel = [-1; 3];

/// A mistake explains most of a picture if it leaves at most 1 wrong pixel in `MOST`.
const MOST: usize = 4;
/// A mistake explains nearly all of a picture if it leaves at most 1 wrong pixel in `NEARLY_ALL`.
const NEARLY_ALL: usize = 100;

impl Candidate {
    /// Makes the right program of a task.
    pub(crate) fn right(task: Task, conversion: Conversion) -> Self {
        Self {
            task,
            slips: Vec::new(),
            conversion,
            edit: None,
        }
    }

    /// Returns the same program with these slips in place of others.
    pub(crate) fn with(&self, slips: Vec<&'static Slip>) -> Self {
        Self {
            slips,
            ..self.clone()
        }
    }

    /// Returns the same program with an edit made.
    pub(crate) fn edited(&self, edit: Generated) -> Self {
        Self {
            edit: Some(edit),
            ..self.clone()
        }
    }

    /// Returns the program.
    pub(crate) fn program(&self) -> ChapterProgram {
        match &self.edit {
            Some(edit) => edit.program.clone(),
            None => self.task.program(&self.slips),
        }
    }

    /// Runs the program; `None` if its picture has another size than the reader's, or no work is
    /// left.
    pub(crate) fn drawn<'a>(&self, reading: &'a Reading, work: &'a Work) -> Option<Drawn<'a>> {
        let price = match (self.slips.len(), &self.edit) {
            // Of two slips each was read before.
            (0 | 2, None) => work::START,
            _ => work::START + work::TEXT,
        };
        let program = work.take(price).then(|| self.program())?;
        let size = (reading.width, reading.height);
        // A header may swap the two, and then the width that was asked for
        // stands where the height should.
        let fitting = |asked| Some(program.run(asked)).filter(|output| output.size() == size);
        Some(Drawn {
            reading,
            work,
            source: Source::Output(fitting(size.0).or_else(|| fitting(size.1))?),
            conversion: self.conversion,
            price: work::pixel(self.task.chapter),
            is_edited: self.edit.is_some(),
        })
    }

    /// Compares all pixels with the reader's, or in a large picture as many as the work suffices
    /// for. `None` if the sizes differ, if more than `most` pixels differ and one of them by more
    /// than a level, or if too little work is left.
    pub(crate) fn unexplained(
        &self,
        reading: &Reading,
        work: &Work,
        most: usize,
    ) -> Option<Unexplained> {
        let is_compiled = self.slips.is_empty() && self.edit.is_none() && self.task.is_compiled();
        if !is_compiled || self.conversion == Conversion::Wrapped {
            return self.drawn(reading, work)?.unexplained(most);
        }
        let right = self.task.right_picture(reading.width, reading.height);
        let is_as_large = (right.width(), right.height()) == (reading.width, reading.height);
        let (levels, _) = is_as_large.then(|| right.rgb().as_chunks::<3>())?;
        let pixels = (0..).zip(levels.iter().map(|pixel| pixel.map(i16::from)));
        Unexplained::of(reading, pixels, most)
    }
}

impl<'a> Drawn<'a> {
    /// Takes a picture of a chapter's program with an edit; `None` if it has another size than the
    /// reader's, or no work is left.
    pub(crate) fn edited(
        canvas: Canvas,
        right: &Candidate,
        reading: &'a Reading,
        work: &'a Work,
    ) -> Option<Self> {
        let is_as_large = canvas.size() == (reading.width, reading.height);
        (is_as_large && work.take(work::MUTANT)).then_some(Self {
            reading,
            work,
            source: Source::Canvas(canvas),
            conversion: right.conversion,
            price: work::pixel(right.task.chapter),
            is_edited: true,
        })
    }

    /// Returns the `n`th pixel; `None` if no work is left.
    fn pixel(&self, n: u32) -> Option<Pixel> {
        let is_left = self.work.take(self.price);
        let printed = || match &self.source {
            Source::Output(output) => output.printed(n),
            Source::Canvas(canvas) => {
                let color = canvas.color(n % self.reading.width, n / self.reading.width);
                let level = |component| (255.999 * component) as i32;
                color.ok().map(|color| color.to_array().map(level))
            }
        };
        is_left.then(|| match printed() {
            None if self.is_edited => NO_PIXEL,
            pixel => pixel
                .unwrap_or_default()
                .map(|level| self.conversion.apply(level)),
        })
    }

    /// Returns true if at most `most` of these pixels are off by more than `levels`; false if no
    /// work is left.
    pub(crate) fn leaves(&self, places: &[u32], levels: u16, most: usize) -> bool {
        self.count(places, levels, most + 1) <= most
    }

    /// Counts the pixels of these that are off by more than `levels`, up to `most`; `most` if no work
    /// is left.
    pub(crate) fn count(&self, places: &[u32], levels: u16, most: usize) -> usize {
        let mut off = 0;
        for &n in places {
            let Some(drawn) = self.pixel(n).filter(|_| off < most) else {
                return most;
            };
            off += usize::from(distance(drawn, self.reading.pixels[n as usize]) > levels);
        }
        off
    }

    /// Compares a sample of pixels with the reader's; `None` if no work is left.
    pub(crate) fn sample(&self, places: &[u32]) -> Option<SampleComparison> {
        self.sample_within(places, places.len())
    }

    /// Compares a sample of pixels with the reader's; `None` if more than `most` are off by more
    /// than a level, or no work is left.
    pub(crate) fn sample_within(&self, places: &[u32], most: usize) -> Option<SampleComparison> {
        let mut sample = SampleComparison::default();
        let mut hasher = DefaultHasher::new();
        for &n in places {
            let pixel = self.pixel(n)?;
            let off = distance(pixel, self.reading.pixels[n as usize]);
            sample.off += usize::from(off > 0);
            sample.far += usize::from(off > 1);
            if sample.far > most {
                return None;
            }
            pixel.hash(&mut hasher);
        }
        sample.mark = hasher.finish();
        Some(sample)
    }

    /// Compares as many pixels as the work suffices for; as [`Candidate::unexplained`].
    fn unexplained(&self, most: usize) -> Option<Unexplained> {
        let total = self.reading.pixels.len() as u64;
        let count = total.min(self.work.left() / self.price);
        if count < total.min(work::FEWEST) {
            return None;
        }
        let places = spread(count as u32, total as u32);
        let pixels = places.map_while(|n| Some((n, self.pixel(n)?)));
        Unexplained::of(self.reading, pixels, most)
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
    /// Compares pixels, by their numbers, with the reader's. `None` if more than `most` differ and
    /// one of them by more than a level.
    fn of(
        reading: &Reading,
        pixels: impl Iterator<Item = (u32, Pixel)>,
        most: usize,
    ) -> Option<Self> {
        let mut unexplained = Self {
            total: reading.pixels.len(),
            ..Self::default()
        };
        for (n, pixel) in pixels {
            unexplained.compared += 1;
            let off = distance(pixel, reading.pixels[n as usize]);
            if off > 0 {
                unexplained.add(n % reading.width, n / reading.width, off);
                if unexplained.far > 0 && unexplained.off > most {
                    return None;
                }
            }
        }
        Some(unexplained)
    }

    /// Returns all pixels of the picture, each as off by more than a level.
    pub(crate) fn all(reading: &Reading) -> Self {
        Self {
            total: reading.pixels.len(),
            compared: reading.pixels.len(),
            off: reading.pixels.len(),
            far: reading.pixels.len(),
            levels: u16::MAX,
            columns: [0, reading.width - 1],
            rows: [0, reading.height - 1],
        }
    }

    /// Adds a pixel that is `off` levels off.
    fn add(&mut self, column: u32, row: u32, off: u16) {
        if self.off == 0 {
            (self.columns, self.rows) = ([column; 2], [row; 2]);
        }
        self.off += 1;
        self.far += usize::from(off > 1);
        self.levels = self.levels.max(off);
        let wider = |[low, high]: [u32; 2], at: u32| [low.min(at), high.max(at)];
        self.columns = wider(self.columns, column);
        self.rows = wider(self.rows, row);
    }

    /// Returns true if these pixels are few beside `all` that the right program leaves unexplained:
    /// one in [`NEARLY_ALL`], or one in [`MOST`] and no more of those that are off by more than a
    /// level, if there are any in `all`.
    pub(crate) fn is_little_of(&self, all: &Self) -> bool {
        let part = |count: usize| count * all.compared / self.compared.max(1);
        let is_most = MOST * part(self.off) <= all.off && part(self.far) <= all.far;
        self.is_nearly_nothing_of(all) || is_most && all.far > 0
    }

    /// Returns true if these pixels are none, or at most one in [`NEARLY_ALL`] of `all`.
    pub(crate) fn is_nearly_nothing_of(&self, all: &Self) -> bool {
        self.is_nothing() || NEARLY_ALL * self.off * all.compared / self.compared <= all.off
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
