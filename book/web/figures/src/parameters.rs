//! The parameters of a figure: numbers with names, ranges and steps.

use common::rtweekend::*;

use crate::number::spoken;
use crate::plane::xy;

/// A number that a reader can change.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// The field of the parameters that it belongs to.
    pub field: &'static str,
    /// Its name, for a reader.
    pub name: &'static str,
    /// The least value.
    pub least: f64,
    /// The greatest value.
    pub most: f64,
    /// The number of steps of the slider that make 1.
    pub steps: f64,
    /// The value of the figure on the page.
    pub default: f64,
    /// The greatest value beside these numbers, if they leave less room.
    pub most_beside: Option<fn(&[f64]) -> f64>,
    /// True if more is farther down on the drawing.
    pub downwards: bool,
    /// The names of the values, from `least` on, if it is a choice.
    pub choices: &'static [&'static str],
}

impl Parameter {
    /// Makes a number from `least` to `most`, in steps of 0.05.
    pub(crate) const fn new(name: &'static str, least: f64, most: f64, default: f64) -> Self {
        Self {
            field: "",
            name,
            least,
            most,
            steps: 20.0,
            default,
            most_beside: None,
            downwards: false,
            choices: &[],
        }
    }

    /// Makes a whole number from `least` to `most`.
    pub(crate) const fn whole(name: &'static str, least: f64, most: f64, default: f64) -> Self {
        Self {
            steps: 1.0,
            ..Self::new(name, least, most, default)
        }
    }

    /// Makes a choice of these, of which the first is on the page.
    pub(crate) const fn choice(name: &'static str, choices: &'static [&'static str]) -> Self {
        Self {
            choices,
            ..Self::whole(name, 0.0, (choices.len() - 1) as f64, 0.0)
        }
    }

    /// Returns the greatest value beside the others.
    pub(crate) fn most_among(&self, numbers: &[f64]) -> f64 {
        let most = self.most_beside.map(|most_beside| most_beside(numbers));
        most.map_or(self.most, |most| most.min(self.most))
    }

    pub(crate) fn confine(&self, value: f64) -> f64 {
        let confined = value.clamp(self.least, self.most);
        match self.steps {
            _ if !value.is_finite() => self.default,
            1.0 => confined.round(),
            _ => confined,
        }
    }

    /// Returns the nearest value on a step: the quotient is the double nearest to a short decimal.
    pub(crate) fn on_a_step(&self, value: f64) -> f64 {
        self.confine((value * self.steps).round() / self.steps)
    }

    /// Writes the value in words, for a reader who cannot see the slider.
    pub(crate) fn in_words(&self, value: f64) -> String {
        match self.choices.get((value - self.least) as usize) {
            Some(&choice) => choice.to_owned(),
            None => spoken(value).replace('−', "minus "),
        }
    }
}

/// The parameters of a figure, as numbers.
pub(crate) trait FigureParameters: Sized + 'static {
    /// The numbers, in the order of the fields.
    const PARAMETERS: &'static [Parameter];

    /// Reads them from a list in that order.
    fn of(numbers: &[f64]) -> Self;

    /// Returns them as such a list.
    fn numbers(&self) -> Vec<f64>;
}

/// A field of the parameters: a number, or a point of the plane, which is two.
pub(crate) trait ParameterField {
    fn read(numbers: &mut impl Iterator<Item = f64>) -> Self;
    fn write(&self, numbers: &mut Vec<f64>);
}

impl ParameterField for f64 {
    fn read(numbers: &mut impl Iterator<Item = f64>) -> Self {
        numbers.next().expect("a number for each field")
    }

    fn write(&self, numbers: &mut Vec<f64>) {
        numbers.push(*self);
    }
}

impl ParameterField for Vec3 {
    fn read(numbers: &mut impl Iterator<Item = f64>) -> Self {
        xy(f64::read(numbers), f64::read(numbers))
    }

    fn write(&self, numbers: &mut Vec<f64>) {
        numbers.extend([self.x, self.y]);
    }
}

/// Declares the parameters of a figure, each field with the one [`Parameter`] or the two that it
/// is.
macro_rules! parameters {
    ($($field:ident: $kind:ty = $($number:expr),+;)*) => {
        /// The parameters that a reader can change.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Parameters {
            $($field: $kind,)*
        }

        impl crate::parameters::FigureParameters for Parameters {
            const PARAMETERS: &'static [Parameter] =
                &[$($(Parameter { field: stringify!($field), ..$number }),+),*];

            fn of(numbers: &[f64]) -> Self {
                let mut numbers = numbers.iter().copied();
                Self { $($field: crate::parameters::ParameterField::read(&mut numbers)),* }
            }

            fn numbers(&self) -> Vec<f64> {
                let mut numbers = Vec::new();
                $(crate::parameters::ParameterField::write(&self.$field, &mut numbers);)*
                numbers
            }
        }
    };
}
pub(crate) use parameters;
