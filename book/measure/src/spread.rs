//! Order statistics: what came out when something was measured several times.

/// The median and the extremes of several numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Half of the numbers are less, half are greater.
    pub median: f64,
    /// The least number.
    pub least: f64,
    /// The greatest number.
    pub greatest: f64,
}

impl Spread {
    /// The spread of `numbers`; the median of an even number of them is the greater
    /// of the two in the middle.
    pub fn of(mut numbers: Vec<f64>) -> Self {
        numbers.sort_by(f64::total_cmp);
        Self {
            median: numbers[numbers.len() / 2],
            least: numbers[0],
            greatest: numbers[numbers.len() - 1],
        }
    }
}
