//! The right answer of the oracle, and how far off others are, in ulps of their precision.

use laws::oracle::{Exact, Root};
use speed_vs_accuracy::Precision;

/// The nearest root in a range.
#[derive(Clone, Copy, Debug)]
pub struct Truth<'a> {
    root: Root<'a>,
    precision: Precision,
}

impl<'a> Truth<'a> {
    /// The nearest root of `exact` between `t_min` and `t_max`, if there is one.
    pub fn of(exact: &'a Exact, precision: Precision, t_min: f64, t_max: f64) -> Option<Self> {
        let root = exact.nearest_root_in(t_min, t_max)?;
        Some(Self { root, precision })
    }

    /// The `f64` nearest to the root.
    pub fn nearest(&self) -> f64 {
        self.root.rounded()
    }

    /// How far `t` is from the root, in units of the last place that a number of
    /// the precision near the root has.
    pub fn error_in_ulps(&self, t: f64) -> f64 {
        let ulp = self.precision.epsilon() / f64::EPSILON;
        self.root.error_in_ulps(t) / ulp
    }
}
