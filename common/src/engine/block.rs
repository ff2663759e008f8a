//! Auto-vectorization: a loop over a structure of arrays that the compiler turns
//! into SIMD instructions.
//!
//! A processor adds four or eight pairs of numbers (*lanes*) in the time that one
//! takes, and divides them nearly so. The compiler uses that by itself where a
//! loop does the same, turn by turn, to numbers that lie side by side. So all
//! there is to do is to paint the pixels of a row in one loop, and to store their
//! components side by side. What happens in a turn is the chapter's own code.
//!
//! One would use this wherever the same plain arithmetic is done to many values;
//! where a turn calls a function that only the running program knows, as through
//! a box, the loop takes one pixel at a time and gives the same bytes.

#[cfg(all(feature = "lanes", not(plain)))]
use multiversion::multiversion;

/// The number of pixels in a block: a multiple of 8, the most lanes that a processor has here, and
/// a divisor of most widths: 400, 1280, 1920, 3840.
pub(super) const BLOCK: usize = 80;

/// Pixels side by side in a row, as a structure of arrays: the levels 0–255 that a picture stores.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) red: [u8; BLOCK],
    pub(super) green: [u8; BLOCK],
    pub(super) blue: [u8; BLOCK],
}

impl Block {
    const BLACK: Self = Self {
        red: [0; BLOCK],
        green: [0; BLOCK],
        blue: [0; BLOCK],
    };

    /// Paints `count` pixels, at most [`BLOCK`], in the levels `levels_at(0)`, `levels_at(1)` and so
    /// on: red, green and blue; the rest stay black.
    #[inline]
    pub(super) fn paint(count: usize, levels_at: impl Fn(usize) -> [u8; 3]) -> Self {
        let mut block = Self::BLACK;
        paint(&mut block, count, levels_at);
        block
    }

    /// Makes a block of at most [`BLOCK`] pixels from their bytes: red, green and blue of each. The
    /// rest stay black.
    pub(super) fn from_rgb(rgb: &[u8]) -> Self {
        let mut block = Self::BLACK;
        let (pixels, _) = rgb.as_chunks();
        for (k, pixel) in pixels.iter().enumerate() {
            [block.red[k], block.green[k], block.blue[k]] = *pixel;
        }
        block
    }
}

// The compiler makes three versions of this loop: for any processor, for one with
// AVX2 (four lanes), and for one with AVX-512 (eight). The program chooses when it
// runs. An operation rounds alike in all. Without the feature `lanes`, or with
// `--cfg plain`, there is only the version for any processor.
#[cfg_attr(
    all(feature = "lanes", not(plain)),
    multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))
)]
fn paint<F: Fn(usize) -> [u8; 3]>(block: &mut Block, count: usize, levels_at: F) {
    for k in 0..count.min(BLOCK) {
        [block.red[k], block.green[k], block.blue[k]] = levels_at(k);
    }
}
