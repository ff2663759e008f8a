//! A picture in memory, and the text that the book calls an image.

use std::io::{self, Write};
use std::num::NonZero;
use std::thread;

use crate::color::{Color, write_color};

/// Rows of pixels from top to bottom, each pixel three bytes: red, green, blue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: u32,
    height: u32,
    rgb: Vec<u8>,
}

impl Picture {
    /// Paints the pixel in column `i` and row `j` with `color_at(i, j)`.
    ///
    /// Large pictures are shared out to all processors. A pixel depends on
    /// nothing but its place, so the result is the same for any number of them.
    pub fn paint(width: u32, height: u32, color_at: impl Fn(u32, u32) -> Color + Sync) -> Self {
        let worthwhile = pixel_count(width, height) / PIXELS_WORTH_A_THREAD + 1;
        let available = thread::available_parallelism().map_or(1, NonZero::get);
        Self::paint_with_threads(available.min(worthwhile), width, height, color_at)
    }

    /// The same picture, painted in at most `threads` bands of rows at once.
    pub fn paint_with_threads(
        threads: usize,
        width: u32,
        height: u32,
        color_at: impl Fn(u32, u32) -> Color + Sync,
    ) -> Self {
        debug_assert!(width > 0 && height > 0 && threads > 0, "nothing to paint");
        let mut rgb = vec![0; 3 * pixel_count(width, height)];
        let rows = (height as usize).div_ceil(threads);
        let paint_band = |index: usize, band: &mut [u8]| {
            paint_rows(band, width, (index * rows) as u32, &color_at);
        };
        let mut bands = rgb.chunks_mut(rows * 3 * width as usize).enumerate();
        // The last band is painted right here: a picture that needs one thread
        // only starts none, which also lets it run where threads do not exist.
        let last = bands.next_back();
        thread::scope(|scope| {
            for (index, band) in bands {
                scope.spawn(move || paint_band(index, band));
            }
            if let Some((index, band)) = last {
                paint_band(index, band);
            }
        });
        Self { width, height, rgb }
    }

    /// A picture from its bytes, or `None` if their number is not 3·width·height.
    pub fn from_rgb(width: u32, height: u32, rgb: Vec<u8>) -> Option<Self> {
        (rgb.len() == 3 * pixel_count(width, height)).then_some(Self { width, height, rgb })
    }

    /// Pixels in a row.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Number of rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All bytes: three a pixel, row by row from the top.
    pub fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// Writes the picture as the book does: a P3 (plain PPM) text with a pixel
    /// a line.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_p3(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "P3\n{} {}\n255\n", self.width, self.height)?;
        // Formatting the three numbers of a pixel takes longer than tracing its
        // ray, and there are only 256 of them: format each once, then copy.
        let decimals: [String; 256] = std::array::from_fn(|level| level.to_string());
        let mut text = Vec::with_capacity("255 255 255\n".len() * self.width as usize);
        for row in self.rgb.chunks_exact(3 * self.width as usize) {
            text.clear();
            for pixel in row.chunks_exact(3) {
                for (&level, separator) in pixel.iter().zip(b"  \n") {
                    text.extend_from_slice(decimals[usize::from(level)].as_bytes());
                    text.push(*separator);
                }
            }
            out.write_all(&text)?;
        }
        Ok(())
    }
}

/// So many pixels take about a quarter of a millisecond. A thread for fewer
/// would save less than it costs to start.
const PIXELS_WORTH_A_THREAD: usize = 1 << 14;

fn pixel_count(width: u32, height: u32) -> usize {
    width as usize * height as usize
}

fn paint_rows(band: &mut [u8], width: u32, first_row: u32, color_at: &impl Fn(u32, u32) -> Color) {
    let (pixels, _) = band.as_chunks_mut::<3>();
    for (row, j) in pixels.chunks_exact_mut(width as usize).zip(first_row..) {
        for (pixel, i) in row.iter_mut().zip(0..) {
            write_color(pixel, color_at(i, j));
        }
    }
}
