//! The first pixel that differs, with all numbers as they should be there.

use super::view::View;
use crate::Row;

impl View<'_> {
    /// What a reader's program should print for that pixel.
    pub(super) fn first_pixel(&self) -> Vec<Row> {
        let pixels = 0..self.reading.pixels.len() as u32;
        let mut differing = pixels.filter(|&n| self.expected(n) != self.found(n));
        let Some(n) = differing.next() else {
            return Vec::new();
        };
        let (i, j) = (n % self.reading.width, n / self.reading.width);
        let (should, is) = (self.expected(n), self.found(n));
        let first = format!("column {i}, row {j}: should be {should:?}, yours {is:?}");
        let numbers = self.output().traced(n).into_iter();
        let numbers = numbers.filter(|(label, _)| !KNOWN.contains(&&**label));
        let numbers: Vec<_> = numbers
            .map(|(label, it)| format!("{label} = {it}"))
            .collect();
        let way = (!numbers.is_empty()).then(|| {
            (
                "numbers",
                format!("as they should be there: {}", numbers.join("; ")),
            )
        });
        [("first", first)].into_iter().chain(way).collect()
    }
}

/// What says nothing beside the others.
const KNOWN: [&str; 4] = ["point on the viewport", "origin", "color", "levels"];
