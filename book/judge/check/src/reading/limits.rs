//! Limits on the size of the files and pictures that are read.

/// The largest file that is read, in bytes. A P3 text of [`MOST_PIXELS`] fits.
pub const MOST_BYTES: usize = 1 << 29;

/// The most pixels that a picture may have: 3840 × 2160 twice, and a little more.
///
/// With it, reading takes no more than another 5 · 2²⁷ bytes beside the file: 6 for each pixel of
/// the result, and up to 8 while a PNG is unpacked, or a copy of a text in UTF-16 or behind a
/// byte-order mark.
pub const MOST_PIXELS: u64 = 1 << 24;
