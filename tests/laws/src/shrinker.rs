//! Shrinking: from the case that was found to one that people can read.
//!
//! proptest shrinks what a strategy starts from, and what comes out of the
//! strategy still has sixteen digits. This goes on with the numbers themselves.

use std::fmt::Debug;

use speed_vs_accuracy::Case;

use crate::intervals::WithInterval;
use crate::verdict::Verdict;

/// A value that laws are tried on, and that people will read.
pub trait Simplify: Clone + Debug {
    /// Values like this one, each with one thing simpler, the simplest first.
    fn simpler(&self) -> Vec<Self>;

    /// The body of a test that tries this value again.
    fn as_test(&self) -> String;
}

/// Replaces the value by simpler ones as long as the law stays broken.
pub fn simplified<T: Simplify>(mut value: T, law: &impl Fn(&T) -> Verdict) -> T {
    const ROUNDS: usize = 200;
    for _ in 0..ROUNDS {
        match value
            .simpler()
            .into_iter()
            .find(|simpler| law(simpler).is_err())
        {
            Some(simpler) => value = simpler,
            None => break,
        }
    }
    value
}

impl Simplify for Case {
    fn simpler(&self) -> Vec<Self> {
        let numbers = self.numbers();
        let mut cases = Vec::new();
        for (at, &number) in numbers.iter().enumerate() {
            for simpler in simpler_numbers(number) {
                let mut changed = numbers;
                changed[at] = simpler;
                cases.push(Self::from_numbers(changed));
            }
        }
        cases
    }

    fn as_test(&self) -> String {
        format!(
            "{self}\nlaws::runner::one_case(&hit_sphere, &laws::Case {{ center, radius, ray }});"
        )
    }
}

impl Simplify for WithInterval {
    fn simpler(&self) -> Vec<Self> {
        let cases = self
            .case
            .simpler()
            .into_iter()
            .map(|case| Self { case, ..*self });
        let low = simpler_numbers(self.t_min)
            .into_iter()
            .map(|t_min| Self { t_min, ..*self });
        let high = simpler_numbers(self.t_max)
            .into_iter()
            .map(|t_max| Self { t_max, ..*self });
        low.chain(high).chain(cases).collect()
    }

    fn as_test(&self) -> String {
        format!(
            "{self}\nlet case = laws::Case {{ center, radius, ray }};\n\
             laws::runner::one_interval(&hit, &laws::WithInterval {{ case, t_min, t_max }});"
        )
    }
}

/// Numbers that take fewer digits to write than `number`, near it or not.
fn simpler_numbers(number: f64) -> Vec<f64> {
    let digits = |x: f64| format!("{:e}", x.abs()).len();
    let size = if number == 0.0 {
        0.0
    } else {
        number.abs().log10().floor()
    };
    let rounded = (0..=3).map(|keep| {
        let unit = 10f64.powf(size - f64::from(keep));
        (number / unit).round() * unit
    });
    [0.0, 1.0, -1.0, number.round()]
        .into_iter()
        .chain(rounded)
        .filter(|simpler| {
            simpler.is_finite()
                && (digits(*simpler), simpler.abs()) < (digits(number), number.abs())
        })
        .collect()
}
