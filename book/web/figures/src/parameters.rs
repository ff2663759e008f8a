//! The parameters of a figure: numbers with names, ranges and steps.

use common::rtweekend::*;

use crate::number::spoken;
use crate::plane::xy;

/// A number that a reader changes in a live figure ([`Movable`](crate::Movable)), with its name,
/// range, step and default.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// The name of the field that holds the number in the figure's own struct of parameters; the x
    /// and y of a point or vector share one field.
    pub field: &'static str,
    /// The label of the slider, such as "d, to the right".
    pub name: &'static str,
    /// The least value that a reader can set.
    pub least: f64,
    /// The greatest value that a reader can set, if `most_beside` leaves it.
    pub most: f64,
    /// The number of steps of the slider in an interval of length 1: 20 for steps of 0.05, and 1
    /// for a number that is always whole.
    pub steps: f64,
    /// The value with which the figure is first shown.
    pub default: f64,
    /// Returns the greatest value for the values of all parameters of the figure, in their order,
    /// if these may lower it below `most`; `None` if the greatest value is always `most`.
    pub most_beside: Option<fn(&[f64]) -> f64>,
    /// True if a greater value is farther down on the drawing, so that the arrow key for down means
    /// more.
    pub downwards: bool,
    /// The names of the values `least`, `least` + 1 and so on, if a reader chooses from a list;
    /// empty for a number with a slider.
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

    /// Makes a choice from a list, whose first entry is the default.
    pub(crate) const fn choice(name: &'static str, choices: &'static [&'static str]) -> Self {
        Self {
            choices,
            ..Self::whole(name, 0.0, (choices.len() - 1) as f64, 0.0)
        }
    }

    /// Returns the greatest value while all parameters have the values `numbers`.
    pub(crate) fn most_among(&self, numbers: &[f64]) -> f64 {
        let most = self.most_beside.map(|most_beside| most_beside(numbers));
        most.map_or(self.most, |most| most.min(self.most))
    }

    /// Brings a value into the range, and onto a whole number if it is one; the default for NaN or
    /// infinity.
    pub(crate) fn confine(&self, value: f64) -> f64 {
        let confined = value.clamp(self.least, self.most);
        match self.steps {
            _ if !value.is_finite() => self.default,
            1.0 => confined.round(),
            _ => confined,
        }
    }

    /// Returns the value on the nearest step of the slider: the `f64` nearest to a short decimal.
    pub(crate) fn on_a_step(&self, value: f64) -> f64 {
        self.confine((value * self.steps).round() / self.steps)
    }

    /// Writes a value in words, for a reader who cannot see the slider.
    pub(crate) fn in_words(&self, value: f64) -> String {
        match self.choices.get((value - self.least) as usize) {
            Some(&choice) => choice.to_owned(),
            None => spoken(value).replace('−', "minus "),
        }
    }
}

/// The parameters of a figure as a struct, which can be read from a list of numbers and written as
/// one.
pub(crate) trait FigureParameters: Sized + 'static {
    /// The parameters, in the order of the fields: two for a point.
    const PARAMETERS: &'static [Parameter];

    /// Reads the struct from numbers in the order of `PARAMETERS`.
    fn of(numbers: &[f64]) -> Self;

    /// Returns the numbers of the struct in the order of `PARAMETERS`.
    fn numbers(&self) -> Vec<f64>;
}

/// A field of a figure's parameters: a number, or a point or vector of the plane, which is two
/// numbers.
pub(crate) trait ParameterField {
    /// Takes the field's numbers from the front of a list.
    fn read(numbers: &mut impl Iterator<Item = f64>) -> Self;
    /// Appends the field's numbers to a list.
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

/// Declares the parameters of a figure: for each field, its type and one [`Parameter`], or two for
/// a point.
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
