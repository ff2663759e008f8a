//! The first pixel that differs, with all numbers as they should be there.

use super::view::View;
use crate::answer::{Row, RowKind};

impl View<'_> {
    /// Returns what a reader's program should print for that pixel.
    pub(super) fn first_pixel(&self) -> Vec<Row> {
        let pixels = 0..self.reading.pixels.len() as u32;
        let mut differing = pixels.filter(|&n| self.expected(n) != self.found(n));
        let Some(n) = differing.next() else {
            return Vec::new();
        };
        let (i, j) = (n % self.reading.width, n / self.reading.width);
        let (should, is) = (self.expected(n), self.found(n));
        let first = format!("column {i}, row {j}: should be {should:?}, yours {is:?}");
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

/// The numbers by which a mistake is found: where the ray goes, and what the sphere makes of it.
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
