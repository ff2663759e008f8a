//! Lazy painting in strips: a picture is painted when its bytes are asked for.

use std::convert::Infallible;
use std::fmt;
use std::io::{self, Write};
use std::sync::OnceLock;
use std::thread;

use super::block::{BLOCK, Block};
use super::p3::push_pixels;
use super::ring::in_order;
use crate::color::{Color, write_color};

/// A picture: rows of pixels from the top, each pixel three bytes (red, green, blue) from left to
/// right.
///
/// A picture knows its size and how to paint any part of itself. It is painted when its bytes are
/// asked for, which it then keeps, or its text. To be printed, it is never held as a whole, so even
/// a very large one takes little memory.
pub struct Picture {
    width: u32,
    height: u32,
    source: PictureBytes,
}

/// The bytes of a picture, or how to paint them.
enum PictureBytes {
    /// Bytes that are painted when they are first asked for, and then kept.
    Recipe {
        paint: Box<Paint>,
        painted: OnceLock<Vec<u8>>,
    },
    /// Bytes that were given.
    Bytes(Vec<u8>),
}

/// A function that paints the pixels of a block: column, row and number of pixels.
type Paint = dyn Fn(u32, u32, usize) -> Block + Send + Sync;

impl Picture {
    /// Makes a picture whose pixel in column `i` and row `j`, counted from 0 at the top left, has
    /// the color `color_at(i, j)`. Both sizes are in pixels and must not be 0.
    ///
    /// A pixel depends on nothing but its place, so the picture is the same whichever thread paints
    /// which part.
    pub fn paint(
        width: u32,
        height: u32,
        color_at: impl Fn(u32, u32) -> Color + Send + Sync + 'static,
    ) -> Self {
        Self::from_levels(
            width,
            height,
            #[inline(always)]
            move |i, j| {
                let mut pixel = [0; 3];
                write_color(&mut pixel, color_at(i, j));
                pixel
            },
        )
    }

    /// Makes a picture like [`Picture::paint`], from levels in place of colors: `levels_at(i, j)`
    /// returns red, green and blue as the picture stores them, 0 to 255.
    pub fn from_levels(
        width: u32,
        height: u32,
        levels_at: impl Fn(u32, u32) -> [u8; 3] + Send + Sync + 'static,
    ) -> Self {
        debug_assert!(width > 0 && height > 0, "nothing to paint");
        Self {
            width,
            height,
            source: PictureBytes::Recipe {
                paint: Box::new(move |i, j, columns| {
                    Block::paint(
                        columns,
                        #[inline(always)]
                        |k| levels_at(i + k as u32, j),
                    )
                }),
                painted: OnceLock::new(),
            },
        }
    }

    /// Makes a picture from its bytes: red, green and blue of pixel `j * width + i`, row by row
    /// from the top. Returns `None` if their number is not 3·width·height.
    pub fn from_rgb(width: u32, height: u32, rgb: Vec<u8>) -> Option<Self> {
        (rgb.len() == 3 * width as usize * height as usize).then(|| Self {
            width,
            height,
            source: PictureBytes::Bytes(rgb),
        })
    }

    /// Returns the number of pixels in a row.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Returns the number of rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Returns all bytes: red, green and blue of pixel `j * width + i`, row by row from the top.
    /// The first call paints them.
    pub fn rgb(&self) -> &[u8] {
        match &self.source {
            PictureBytes::Recipe { painted, .. } => {
                painted.get_or_init(|| self.rgb_with_threads(self.threads()))
            }
            PictureBytes::Bytes(rgb) => rgb,
        }
    }

    /// Returns a copy of the bytes of [`Picture::rgb`], which it does not keep. If they are not yet
    /// there, this number of threads paints them, at least one.
    pub fn rgb_with_threads(&self, threads: usize) -> Vec<u8> {
        let mut rgb = Vec::with_capacity(3 * self.width as usize * self.height as usize);
        let paint = |strip, bytes: &mut Vec<u8>| self.push_strip(strip, bytes);
        let Ok::<(), Infallible>(()) = in_order(self.strips(), threads, paint, |bytes| {
            rgb.extend_from_slice(bytes);
            Ok(())
        });
        rgb
    }

    /// Returns the number of strips, the pieces that a picture is painted in: up to 2560 pixels
    /// each, in reading order.
    pub fn strips(&self) -> usize {
        (self.blocks_in_row() * self.height as usize).div_ceil(STRIP)
    }

    /// Appends the bytes of one strip, counted from 0, to `rgb`, so that a picture can be shown
    /// while it is painted. All strips in order make up [`Picture::rgb`]; one beyond the last has
    /// no bytes.
    pub fn push_strip(&self, strip: usize, rgb: &mut Vec<u8>) {
        for (block, columns) in self.blocks(strip) {
            for k in 0..columns {
                rgb.extend([block.red[k], block.green[k], block.blue[k]]);
            }
        }
    }

    /// Writes the picture as the book's programs do: as P3 (plain PPM) text, one pixel per line.
    ///
    /// # Errors
    /// The first error of `out`, after which nothing is written.
    pub fn write_p3(&self, out: &mut dyn Write) -> io::Result<()> {
        self.write_p3_with_threads(self.threads(), out)
    }

    /// Writes the text of [`Picture::write_p3`], painted and formatted with this number of threads,
    /// at least one.
    ///
    /// # Errors
    /// The first error of `out`, after which nothing is written.
    pub fn write_p3_with_threads(&self, threads: usize, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "P3\n{} {}\n255\n", self.width, self.height)?;
        let describe = |strip, text: &mut Vec<u8>| {
            for (block, columns) in self.blocks(strip) {
                push_pixels(text, &block, columns);
            }
        };
        in_order(self.strips(), threads, describe, |text| out.write_all(text))
    }

    /// Returns the number of threads to paint with: one for a small picture, at most eight and as
    /// many as there are processors.
    fn threads(&self) -> usize {
        match (self.strips() / STRIPS_WORTH_A_THREAD).min(MOST_THREADS) {
            // To ask the system how many there are takes as long as a strip.
            0 | 1 => 1,
            several => thread::available_parallelism().map_or(1, |most| several.min(most.get())),
        }
    }

    /// Paints a strip: returns its blocks in reading order, each with the number of its pixels that
    /// lie inside the picture.
    fn blocks(&self, strip: usize) -> impl Iterator<Item = (Block, usize)> {
        let in_row = self.blocks_in_row();
        let end = (in_row * self.height as usize).min((strip + 1) * STRIP);
        (strip * STRIP..end).map(move |n| {
            let (i, j) = (n % in_row * BLOCK, n / in_row);
            let columns = BLOCK.min(self.width as usize - i);
            let block = match &self.source {
                PictureBytes::Recipe { paint, painted } if painted.get().is_none() => {
                    paint(i as u32, j as u32, columns)
                }
                _ => {
                    let first = 3 * (j * self.width as usize + i);
                    Block::from_rgb(&self.rgb()[first..][..3 * columns])
                }
            };
            (block, columns)
        })
    }

    fn blocks_in_row(&self) -> usize {
        (self.width as usize).div_ceil(BLOCK)
    }
}

/// The number of blocks in a strip, which a thread paints in one go. The text of so many stays in
/// the processor's first cache, and takes few pages of memory: the first touch of each costs a
/// microsecond.
const STRIP: usize = 32;

/// The number of strips that take about half a millisecond: a thread for fewer would save less than
/// it costs to start.
const STRIPS_WORTH_A_THREAD: usize = 32;

/// The largest number of threads: more would only wait for the one that writes.
const MOST_THREADS: usize = 8;

impl PartialEq for Picture {
    fn eq(&self, other: &Self) -> bool {
        self.width == other.width && self.height == other.height && self.rgb() == other.rgb()
    }
}

impl fmt::Debug for Picture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Picture of {} × {} pixels", self.width, self.height)
    }
}
