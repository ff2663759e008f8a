//! Stratified sampling: pixels to look at before all are compared.

use super::estimate;
use crate::bits::Pixel;
use crate::reading::Reading;

/// A prime, so that a walk with this stride is in step with nothing.
const STRIDE: usize = 97;

/// Bits of a pixel that is far off, about.
const FAR: f64 = 13.0;

/// Some pixels, each with the number of pixels that it stands for.
pub(crate) struct Places {
    places: Vec<(u32, f64)>,
}

impl Places {
    /// Up to `count` places: a third of them among the pixels that `drawn` leaves
    /// unexplained, which may be rare and tell most.
    pub(crate) fn new(reading: &Reading, drawn: Option<&[Pixel]>, count: u32) -> Self {
        let all = 0..reading.pixels.len() as u32;
        let is_left = |n: &u32| {
            let n = *n as usize;
            drawn.is_none_or(|drawn| estimate(drawn[n], reading.pixels[n]) > 0.0)
        };
        let (left, explained): (Vec<u32>, Vec<u32>) = all.partition(is_left);
        let share = (count / 3).min(left.len() as u32);
        let mut places = sample(
            &left,
            share.max(count.saturating_sub(explained.len() as u32)),
        );
        places.extend(sample(&explained, count - share));
        // Both kinds are soon among those that were looked at.
        let mixed = (0..STRIDE).flat_map(|first| (first..places.len()).step_by(STRIDE));
        Self {
            places: mixed.map(|n| places[n]).collect(),
        }
    }

    /// By how much an estimate may be wrong: by what one place stands for.
    pub(crate) fn give(&self) -> f64 {
        let most = self.places.iter().map(|(_, pixels)| *pixels);
        FAR * most.fold(0.0, f64::max)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = (u32, f64)> + '_ {
        self.places.iter().copied()
    }
}

fn sample(pixels: &[u32], count: u32) -> Vec<(u32, f64)> {
    let all = pixels.len() as u32;
    let weight = f64::from(all) / f64::from(count.min(all)).max(1.0);
    let some = spread(count, all).map(|n| (pixels[n as usize], weight));
    some.collect()
}

/// Up to `count` numbers below `total`, spread evenly and in no step with the
/// width of a picture: multiples of the golden ratio without their integer part.
pub(crate) fn spread(count: u32, total: u32) -> impl Iterator<Item = u32> {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let evenly = move |n: u32| ((u64::from(n).wrapping_mul(GOLDEN) >> 32) * u64::from(total)) >> 32;
    let all = count >= total;
    (0..count.min(total)).map(move |n| if all { n } else { evenly(n) as u32 })
}
