//! Shrinking: from the question on which a law was found broken to one that people
//! can read.

use std::fmt::Debug;

use speed_vs_accuracy::Case;

use crate::intervals::WithInterval;
use crate::nearer_root::Decided;
use crate::record::Recorded;

/// A value that laws are tried on, and that people will read.
pub trait Simplify: Clone + Debug {
    /// Values like this one, each with one thing simpler, the simplest first.
    fn simpler(&self) -> Vec<Self>;

    /// The body of a test that asks `function` about this value again.
    fn as_test(&self, function: &str) -> String;
}

/// Replaces the value by simpler ones as long as they still show what this one does.
pub fn simplified<T: Simplify>(mut value: T, shows: impl Fn(&T) -> bool) -> T {
    const ROUNDS: usize = 200;
    for _ in 0..ROUNDS {
        match value.simpler().into_iter().find(&shows) {
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

    fn as_test(&self, hit_sphere: &str) -> String {
        format!(
            "{self}\nlaws::runner::one_case(&{hit_sphere}, &laws::Case {{ center, radius, ray }});"
        )
    }
}

impl Simplify for Decided {
    fn simpler(&self) -> Vec<Self> {
        self.0.simpler().into_iter().map(Self).collect()
    }

    fn as_test(&self, hit_sphere: &str) -> String {
        let case = self.0;
        format!(
            "{case}\nlaws::runner::one_decision(&{hit_sphere}, &laws::Case {{ center, radius, ray }});"
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

    fn as_test(&self, hit: &str) -> String {
        format!(
            "{self}\nlaws::runner::one_interval(&{hit}, laws::Case {{ center, radius, ray }}, t_min, t_max);"
        )
    }
}

impl Simplify for Recorded {
    fn simpler(&self) -> Vec<Self> {
        self.0.simpler().into_iter().map(Self).collect()
    }

    fn as_test(&self, _: &str) -> String {
        format!(
            "{}\nlet hit = |t_min| Sphere::new(center, radius).hit(&ray, t_min, f64::INFINITY).unwrap();\n\
             let (nearer, farther) = (hit(f64::NEG_INFINITY), hit(hit(f64::NEG_INFINITY).t));\n\
             assert!((nearer.normal.length() - 1.0).abs() < 1e-9 && nearer.front_face && !farther.front_face);\n\
             assert!(ray.direction.dot(nearer.normal) <= 0.0 && ray.direction.dot(farther.normal) <= 0.0);",
            self.0
        )
    }
}

/// A number as Rust has it, which has words for three of them.
pub(crate) fn number(x: f64) -> String {
    if x.is_nan() {
        "f64::NAN".to_owned()
    } else if x == f64::INFINITY {
        "f64::INFINITY".to_owned()
    } else if x == f64::NEG_INFINITY {
        "f64::NEG_INFINITY".to_owned()
    } else {
        format!("{x:?}")
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
