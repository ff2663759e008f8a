//! Pixels as they stand in a file, how far two of them are apart, and which are looked at.

/// Red, green and blue as they stand in a file.
pub(crate) type Pixel = [i16; 3];

/// The largest difference of two pixels in a component, in levels.
///
/// C++ prints −2³¹ for NaN and for what an integer can't hold, where Rust has 0
/// or the nearest integer: that counts as the same.
pub(crate) fn distance(drawn: Pixel, found: Pixel) -> u16 {
    let [red, green, blue] = [0, 1, 2].map(|c| match (drawn[c], found[c]) {
        (0 | i16::MAX, i16::MIN) => 0,
        (drawn, found) => found.abs_diff(drawn),
    });
    red.max(green).max(blue)
}

/// Up to `count` numbers below `total`, spread evenly and in no step with the
/// width of a picture: multiples of the golden ratio without their integer part.
pub(crate) fn spread(count: u32, total: u32) -> impl Iterator<Item = u32> + Clone {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let evenly = move |n: u32| ((u64::from(n).wrapping_mul(GOLDEN) >> 32) * u64::from(total)) >> 32;
    let all = count >= total;
    (0..count.min(total)).map(move |n| if all { n } else { evenly(n) as u32 })
}
