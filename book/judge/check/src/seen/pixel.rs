//! The first pixel that differs, and the numbers of its ray in a right program.

use super::side_by_side::SideBySide;
use crate::answer::{Row, RowKind};

impl SideBySide<'_> {
    /// Lists the first pixel that differs, with its right and its wrong color, and the numbers that
    /// a right program computes there. Empty if no pixel differs.
    pub(super) fn first_pixel(&self) -> Vec<Row> {
        let pixels = 0..self.reading.pixels.len() as u32;
        let mut differing = pixels.filter(|&n| self.expected(n) != self.found(n));
        let Some(n) = differing.next() else {
            return Vec::new();
        };
        let (i, j) = (n % self.reading.width, n / self.reading.width);
        let (should, is) = (self.expected(n), self.found(n));
        // What 16 bits can't hold was cut off.
        let is = is.map(|level| match level {
            i16::MIN => format!("{level} or less"),
            i16::MAX => format!("{level} or more"),
            _ => level.to_string(),
        });
        let is = is.join(", ");
        let first = format!("column {i}, row {j}: should be {should:?}, yours is [{is}]");
        let numbers = self.output().trace(n).into_iter();
        let numbers = numbers.filter(|it| TELLING.contains(&&*it.label));
        let numbers: Vec<_> = numbers
            .map(|it| format!("{} = {}", it.label, it.value))
            .collect();
        let said = format!("as they should be there: {}", numbers.join("; "));
        let numbers = (!numbers.is_empty()).then(|| Row::new(RowKind::Numbers, said));
        [Row::new(RowKind::First, first)]
            .into_iter()
            .chain(numbers)
            .collect()
    }
}

/// The names of the numbers that are listed: of the ray, and of its intersection with the sphere.
const TELLING: [&str; 9] = [
    "unit_direction",
    "oc",
    "a",
    "b",
    "h",
    "c",
    "discriminant",
    "t",
    "normal",
];
