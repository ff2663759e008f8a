//! Terms of which the levels of a surface may be sums, and these sums in words.

use glam::DVec4;

use super::fit::{Fit, LITTLE};
use super::said::{NEAR, number};

/// The terms of which levels are sums.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Terms {
    One,
    Rows,
    Columns,
    /// The y of the direction, divided by its length.
    UnitY,
    Both,
    Unit,
    Normal,
    /// The red component itself, so colors lie on a line.
    Red,
}

impl Terms {
    pub(super) const BEHIND: [Self; 6] = [
        Self::One,
        Self::Rows,
        Self::Columns,
        Self::UnitY,
        Self::Both,
        Self::Unit,
    ];
    /// The same but for sums of all three components of a direction.
    pub(super) const SIMPLE: [Self; 5] = [
        Self::One,
        Self::Rows,
        Self::Columns,
        Self::UnitY,
        Self::Both,
    ];
    pub(super) const OF_A_THING: [Self; 6] = [
        Self::One,
        Self::UnitY,
        Self::Rows,
        Self::Columns,
        Self::Both,
        Self::Normal,
    ];

    /// How many levels all but some pixels may be off.
    pub(super) fn most_off(self) -> f64 {
        match self {
            Self::One | Self::Normal => 4.0,
            Self::Unit => 2.5,
            _ => 1.75,
        }
    }

    pub(super) fn is_a_vector(self) -> bool {
        matches!(self, Self::Unit | Self::Normal)
    }

    pub(super) fn count(self) -> u32 {
        match self {
            Self::One => 1,
            Self::Rows | Self::Columns | Self::UnitY | Self::Normal => 2,
            Self::Both => 3,
            Self::Unit => 4,
            Self::Red => 5,
        }
    }
}

/// Whether colors that are told by their red lie between the two of the book's sky.
pub(super) fn is_books(fit: &Fit) -> bool {
    let is_near = |red: f64, book: [f64; 3]| {
        let color = fit.color(DVec4::new(1.0, red, 0.0, 0.0));
        color
            .iter()
            .zip(book)
            .all(|(it, book)| (it - book).abs() < NEAR)
    };
    is_near(1.0, [1.0; 3]) && is_near(0.5, [0.5, 0.7, 1.0])
}

pub(super) fn color(color: [f64; 3]) -> String {
    let [red, green, blue] = color.map(number);
    format!("({red}, {green}, {blue})")
}

/// Each component as a sum of those of a vector.
pub(super) fn sums(fit: &Fit, vector: &str) -> String {
    let sum = |sum: DVec4| {
        let [same, parts @ ..] = sum.to_array();
        let parts = parts.iter().zip(["x", "y", "z"]);
        let parts = parts.filter(|(part, _)| part.abs() >= LITTLE);
        let mut terms: Vec<String> = parts
            .map(|(part, axis)| format!("{} {vector}.{axis}", number(*part)))
            .collect();
        if same.abs() >= LITTLE || terms.is_empty() {
            terms.push(number(same));
        }
        terms.join(" + ").replace("+ -", "- ")
    };
    let [red, green, blue] = fit.components.map(sum);
    format!("red {red}, green {green}, blue {blue}")
}
