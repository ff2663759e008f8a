//! Pixels as they stand in a file, their distance, and samples of them.

/// Red, green and blue as they stand in a file, levels from 0 to 255 or other numbers.
pub(crate) type Pixel = [i16; 3];

/// Returns the largest difference of a component between a pixel that was drawn and one that was
/// found in a file, in levels.
///
/// C++ prints −2³¹ for NaN and for a number that an integer can't hold, where Rust has 0 or the
/// nearest integer: these have the distance 0.
pub(crate) fn distance(drawn: Pixel, found: Pixel) -> u16 {
    let [red, green, blue] = [0, 1, 2].map(|c| match (drawn[c], found[c]) {
        (0 | i16::MAX, i16::MIN) => 0,
        (drawn, found) => found.abs_diff(drawn),
    });
    red.max(green).max(blue)
}

/// Returns up to `count` indices below `total` in the low-discrepancy order of the golden ratio, so
/// that they don't align with the columns of a picture; all indices in order if `total` is no more
/// than `count`.
pub(crate) fn spread(count: u32, total: u32) -> impl Iterator<Item = u32> + Clone {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let evenly = move |n: u32| ((u64::from(n).wrapping_mul(GOLDEN) >> 32) * u64::from(total)) >> 32;
    let all = count >= total;
    (0..count.min(total)).map(move |n| if all { n } else { evenly(n) as u32 })
}
