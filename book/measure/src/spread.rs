//! Order statistics: the median and the spread of a repeated measurement.

/// The median and the quartiles of several numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The middle number in order of size; of an even count, the greater of the two in the middle.
    pub median: f64,
    /// The first quartile, then the third; each is one of the numbers.
    pub quartiles: [f64; 2],
}

impl Spread {
    /// Sorts `numbers` and finds their spread. NaN counts as the greatest number.
    ///
    /// # Panics
    /// If there are no numbers.
    pub fn of(mut numbers: Vec<f64>) -> Self {
        numbers.sort_by(f64::total_cmp);
        let last = numbers.len() - 1;
        Self {
            median: numbers[numbers.len() / 2],
            quartiles: [numbers[last / 4], numbers[last - last / 4]],
        }
    }

    /// Rounds the median to as many digits as the noise allows, at most three: to a multiple of 1,
    /// 2 or 5 in some digit, no finer than half the distance of the quartiles. One digit stays of
    /// the noisiest, so that no time becomes 0. The median has to be above 0.
    pub fn rounded_median(&self) -> f64 {
        let [low, high] = self.quartiles;
        let coarsest = 10_f64.powf(self.median.log10().floor());
        let least = (0.5 * (high - low)).clamp(coarsest / 100.0, coarsest);
        let digit = least.log10().floor();
        let place = 10_f64.powf(digit);
        let step = place
            * match least / place {
                ..=1.0 => 1.0,
                ..=2.0 => 2.0,
                ..=5.0 => 5.0,
                _ => 10.0,
            };
        let decimals = (-digit).max(0.0) as usize;
        let text = format!("{:.decimals$}", (self.median / step).round() * step);
        text.parse().unwrap_or(self.median)
    }
}
