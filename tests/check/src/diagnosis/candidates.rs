//! Hypotheses: programs that may have drawn a picture, and how well each explains it.

use std::hash::{DefaultHasher, Hasher};

use super::scene::Scene;
use crate::reading::Reading;
use slips::{Output, Slip};

/// A program with slips in it, and how its numbers get into a file.
#[derive(Clone)]
pub(super) struct Candidate {
    pub(super) slips: Vec<&'static Slip>,
    pub(super) conversion: Conversion,
    output: Output,
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

/// How far a program's picture is from the reader's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fit {
    /// Pixels that are more than one level off.
    pub far: usize,
    /// Pixels that are off at all.
    pub off: usize,
    /// Pixels that were compared.
    pub compared: usize,
}

impl Fit {
    /// What fits nowhere.
    pub(super) fn nothing(compared: usize) -> Self {
        Self {
            far: compared,
            off: compared,
            compared,
        }
    }
}

/// A candidate after comparison; candidates with the same mark draw the same.
pub(super) struct Judged {
    pub(super) candidate: Candidate,
    pub(super) fit: Fit,
    pub(super) mark: u64,
}

impl Candidate {
    /// The program with those slips, if its picture has the reader's size.
    pub(super) fn of(
        scene: &Scene,
        reading: &Reading,
        slips: &[&'static Slip],
        conversion: Conversion,
    ) -> Option<Self> {
        let (width, height) = (reading.width, reading.height);
        let program = scene.program(slips);
        // A header may swap the two, and then the width that was asked for
        // stands where the height should.
        let output = [width, height]
            .map(|asked| program.run(asked))
            .into_iter()
            .find(|output| output.size() == (width, height))?;
        Some(Self {
            slips: slips.to_vec(),
            conversion,
            output,
        })
    }

    /// The `n`th pixel as it stands in the file.
    pub(super) fn pixel(&self, n: u32) -> [i16; 3] {
        self.output
            .pixel(n)
            .map(|level| self.conversion.apply(level))
    }

    /// Compares with the reader's picture at some places, and gives up when more
    /// than `most` pixels are far off.
    pub(super) fn judge(
        &self,
        reading: &Reading,
        places: &[u32],
        most: usize,
    ) -> Option<(Fit, u64)> {
        let mut fit = Fit {
            far: 0,
            off: 0,
            compared: places.len(),
        };
        let mut hasher = DefaultHasher::new();
        for &n in places {
            let drawn = self.pixel(n);
            hasher.write_u64(in_one(drawn));
            let found = reading.pixels[n as usize];
            let distance = distance(drawn, found);
            fit.off += usize::from(distance > 0);
            fit.far += usize::from(distance > 1);
            if fit.far > most {
                return None;
            }
        }
        Some((fit, hasher.finish()))
    }
}

impl Conversion {
    fn apply(self, level: i32) -> i16 {
        match self {
            Self::Printed => level.clamp(i16::MIN.into(), i16::MAX.into()) as i16,
            Self::Clamped => level.clamp(0, 255) as i16,
            Self::Wrapped => i16::from(level as u8),
        }
    }
}

/// A pixel as one number, which is a third of the work to hash.
fn in_one(levels: [i16; 3]) -> u64 {
    let levels = levels.map(|level| u64::from(level as u16));
    levels[0] << 32 | levels[1] << 16 | levels[2]
}

/// The largest difference of two pixels in a component, in levels.
///
/// C++ prints −2³¹ for NaN and for what an integer can't hold, where Rust has 0
/// or the nearest integer: that counts as the same.
pub(super) fn distance(drawn: [i16; 3], found: [i16; 3]) -> u16 {
    let components = drawn.into_iter().zip(found).map(|(drawn, found)| {
        let same_in_cpp = found == i16::MIN && matches!(drawn, 0 | i16::MAX);
        if same_in_cpp {
            0
        } else {
            drawn.abs_diff(found)
        }
    });
    components.max().unwrap_or(0)
}

/// In so many pixels what is wrong is looked for first.
const SOME_EVIDENCE: u32 = 20_000;
/// So many wrong pixels are enough.
const ENOUGH: usize = 400;
/// If there are fewer, all pixels of a picture 800 pixels wide are looked at.
const MOST_EVIDENCE: u32 = 400_000;

/// The reader's picture, and where it is not the right one.
pub(super) struct Evidence<'a> {
    pub(super) reading: &'a Reading,
    differing: Vec<u32>,
}

impl<'a> Evidence<'a> {
    /// `right` draws what is right in the same size; without it, all is wrong.
    pub(super) fn new(reading: &'a Reading, right: Option<&Candidate>) -> Self {
        let total = reading.pixels.len() as u32;
        let differs =
            |n: &u32| right.is_none_or(|right| right.pixel(*n) != reading.pixels[*n as usize]);
        let some: Vec<u32> = spread(SOME_EVIDENCE, total).filter(differs).collect();
        Self {
            reading,
            differing: match some.len() < ENOUGH {
                true => spread(MOST_EVIDENCE, total).filter(differs).collect(),
                false => some,
            },
        }
    }

    /// Up to `count` places: half of them anywhere, half of them where something
    /// is wrong, which may be rare. All places if there are not more.
    pub(super) fn places(&self, count: u32) -> Vec<u32> {
        let total = self.reading.pixels.len() as u32;
        if total <= count {
            return (0..total).collect();
        }
        let mut places: Vec<u32> = spread(count / 2, total).collect();
        places.extend(
            spread(count / 2, self.differing.len() as u32).map(|n| self.differing[n as usize]),
        );
        places.sort_unstable();
        places.dedup();
        places
    }
}

/// Up to `count` numbers below `total`, spread evenly and in no step with the
/// width of a picture: multiples of the golden ratio without their integer part.
pub(crate) fn spread(count: u32, total: u32) -> impl Iterator<Item = u32> {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let evenly = move |n: u32| ((u64::from(n).wrapping_mul(GOLDEN) >> 32) * u64::from(total)) >> 32;
    let all = count >= total;
    (0..count.min(total)).map(move |n| if all { n } else { evenly(n) as u32 })
}

/// The best candidates after a look at `places`, best first.
///
/// Those with more than `most` pixels far off are out, and so are those that are
/// more than twice as bad as the best.
pub(super) fn best(
    reading: &Reading,
    candidates: impl IntoIterator<Item = Candidate>,
    places: &[u32],
    mut most: usize,
) -> Vec<Judged> {
    let mut judged: Vec<Judged> = Vec::new();
    for candidate in candidates {
        if let Some((fit, mark)) = candidate.judge(reading, places, most) {
            // A few pixels don't tell exactly, hence the little more.
            let twice = match fit.far {
                0 => 0,
                far => 2 * far + places.len() / 100,
            };
            most = most.min(twice);
            judged.push(Judged {
                candidate,
                fit,
                mark,
            });
        }
    }
    judged.sort_by_key(|judged| judged.fit);
    judged
}
