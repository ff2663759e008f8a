//! The numbers of a picture as they stand in a file, levels or not.

use common::rtweekend::Picture;

use super::cause::Cause;

/// A picture as a reader's program wrote it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Pixels in a row, at least 1.
    pub width: u32,
    /// Number of rows, at least 1.
    pub height: u32,
    /// Red, green and blue, row by row from the top.
    ///
    /// A P3 text may hold numbers that no level can be, such as 256 and −107,
    /// and they tell much about a mistake. What 16 bits can't hold stops at
    /// ±2¹⁵, which is far beyond what any mistake needs.
    pub pixels: Vec<[i16; 3]>,
    /// What keeps a viewer from the text, if a shell has put it into another encoding.
    pub encoding: Option<Cause>,
}

/// Numbers that are no levels: below 0 or above 255.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outside {
    /// How many pixels have at least one.
    pub count: usize,
    /// Column and row of the first one.
    pub first: (u32, u32),
    /// Its red, green and blue.
    pub pixel: [i16; 3],
    /// The lowest number of the picture.
    pub lowest: i16,
    /// The highest number of the picture.
    pub highest: i16,
}

impl Reading {
    /// Returns this picture as numbers from a file hold it.
    pub fn of(picture: &Picture) -> Self {
        let (pixels, _) = picture.rgb().as_chunks::<3>();
        Self {
            width: picture.width(),
            height: picture.height(),
            pixels: pixels.iter().map(|pixel| pixel.map(i16::from)).collect(),
            encoding: None,
        }
    }

    /// Returns the picture that a viewer can show: numbers stop at 0 and 255.
    ///
    /// # Panics
    /// If there are more or fewer pixels than the size says.
    pub fn picture(&self) -> Picture {
        let levels = self.pixels.iter().flatten();
        let rgb = levels.map(|&level| level.clamp(0, 255) as u8).collect();
        Picture::from_rgb(self.width, self.height, rgb)
            .expect("a reading has as many pixels as its size says")
    }

    /// Returns true if all pixels are of the same color.
    pub fn is_plain(&self) -> bool {
        self.pixels.iter().all(|pixel| *pixel == self.pixels[0])
    }

    /// The numbers that are no levels, if there are any.
    pub fn outside(&self) -> Option<Outside> {
        let is_outside = |pixel: &[i16; 3]| pixel.iter().any(|level| !(0..256).contains(level));
        let n = self.pixels.iter().position(is_outside)?;
        let levels = || self.pixels.iter().flatten().copied();
        Some(Outside {
            count: self
                .pixels
                .iter()
                .filter(|&pixel| is_outside(pixel))
                .count(),
            first: (n as u32 % self.width, n as u32 / self.width),
            pixel: self.pixels[n],
            lowest: levels().min()?,
            highest: levels().max()?,
        })
    }
}
