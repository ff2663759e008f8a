//! A cached answer of the oracle: the error of a wrong one takes a few operations
//! instead of long integers.

use speed_vs_accuracy::Precision;

use laws::oracle::Exact;

/// The nearest root, kept so that an error takes a few operations instead of
/// long integers.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// The `f64` nearest to the root.
    nearest: f64,
    /// How far the root is above that, in ulps of the precision.
    rest: f64,
    /// An ulp of the precision.
    ulp: f64,
}

impl Truth {
    /// The nearest root of `exact` between `t_min` and `t_max`, if there is one.
    pub fn of(exact: &Exact, precision: Precision, t_min: f64, t_max: f64) -> Option<Self> {
        let root = exact.nearest_root_in(t_min, t_max)?;
        let nearest = root.rounded();
        let is_below = root < nearest;
        // The ulp is that of the root, also where it rounds to a power of two.
        let below = toward_zero(
            nearest.abs(),
            is_below == (nearest > 0.0) && root != nearest,
        );
        let ulp_of_double = below.next_up() - below;
        let ulp = match precision {
            Precision::Double => ulp_of_double,
            Precision::Single => {
                let below = single_below(below);
                f64::from(below.next_up()) - f64::from(below)
            }
        };
        let away = root.error_in_ulps(nearest) * (ulp_of_double / ulp);
        Some(Self {
            nearest,
            rest: if is_below { -away } else { away },
            ulp,
        })
    }

    /// The `f64` nearest to the root.
    pub fn nearest(&self) -> f64 {
        self.nearest
    }

    /// How far `t` is from the root, in units of the last place that a number of
    /// the precision near the root has.
    pub fn error_in_ulps(&self, t: f64) -> f64 {
        ((t - self.nearest) / self.ulp - self.rest).abs()
    }
}

fn toward_zero(size: f64, by_a_step: bool) -> f64 {
    if by_a_step { size.next_down() } else { size }
}

/// The greatest `f32` not above `t`, which is not negative.
fn single_below(t: f64) -> f32 {
    let nearest = t as f32;
    if f64::from(nearest) > t {
        nearest.next_down()
    } else {
        nearest
    }
}
