//! The numbers of a picture as they stand in a file: levels from 0 to 255, or others.

use common::rtweekend::Picture;

use super::cause::Cause;

/// A picture that was read from a file, with its numbers as a reader's program wrote them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Width in pixels, at least 1.
    pub width: u32,
    /// Height in pixels, at least 1.
    pub height: u32,
    /// Red, green and blue of each pixel, `j * width + i`, row by row from the top.
    ///
    /// Levels are from 0 to 255. A P3 text may hold other numbers, such as 256 and −107, which tell
    /// much about a mistake; beyond 16 bits they become the largest or the smallest number.
    pub pixels: Vec<[i16; 3]>,
    /// A flaw of the file with which the picture can be read, but viewers don't show all of it:
    /// another encoding of a text, or transparent pixels of a PNG. `None` if there is none.
    pub flaw: Option<Cause>,
}

/// The numbers of a picture that are no levels: below 0 or above 255.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InvalidLevels {
    /// Number of pixels with at least one such number, at least 1.
    pub count: usize,
    /// Column and row of the first such pixel, counted from 0 at the top left, row by row.
    pub first: [u32; 2],
    /// Red, green and blue of that pixel, as the file has them.
    pub pixel: [i16; 3],
    /// The lowest number of the whole picture.
    pub lowest: i16,
    /// The highest number of the whole picture.
    pub highest: i16,
}

impl Reading {
    /// Returns the reading of a file without a flaw that holds this picture.
    pub fn of(picture: &Picture) -> Self {
        let (pixels, _) = picture.rgb().as_chunks::<3>();
        Self {
            width: picture.width(),
            height: picture.height(),
            pixels: pixels.iter().map(|pixel| pixel.map(i16::from)).collect(),
            flaw: None,
        }
    }

    /// Returns the picture as a viewer shows it: numbers below 0 become 0, those above 255 become
    /// 255.
    ///
    /// # Panics
    /// If there are more or fewer pixels than the size says.
    pub fn picture(&self) -> Picture {
        let levels = self.pixels.iter().flatten();
        let rgb = levels.map(|&level| level.clamp(0, 255) as u8).collect();
        Picture::from_rgb(self.width, self.height, rgb)
            .expect("a reading has as many pixels as its size says")
    }

    /// Returns true if all pixels have the same color.
    pub fn has_one_color(&self) -> bool {
        self.pixels.iter().all(|pixel| *pixel == self.pixels[0])
    }

    /// Finds the numbers that are no levels; `None` if all are from 0 to 255.
    pub fn invalid_levels(&self) -> Option<InvalidLevels> {
        let is_outside = |pixel: &[i16; 3]| pixel.iter().any(|level| !(0..256).contains(level));
        let n = self.pixels.iter().position(is_outside)?;
        let levels = || self.pixels.iter().flatten().copied();
        Some(InvalidLevels {
            count: self
                .pixels
                .iter()
                .filter(|&pixel| is_outside(pixel))
                .count(),
            first: [n as u32 % self.width, n as u32 / self.width],
            pixel: self.pixels[n],
            lowest: levels().min()?,
            highest: levels().max()?,
        })
    }
}
