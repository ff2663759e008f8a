//! The first pixel that differs, with all numbers as they should be on its way.

use slips::Chapter;

use super::view::View;
use crate::words::Row;

impl View<'_> {
    /// What a reader's program should print for that pixel.
    pub(super) fn first_pixel(&self) -> Vec<Row> {
        let pairs = self.reading.pixels.len() as u32;
        let Some(n) = (0..pairs).find(|&n| self.expected(n) != self.found(n)) else {
            return Vec::new();
        };
        let program = self.program();
        let (i, j) = (n % self.reading.width, n / self.reading.width);
        let (should, is) = (self.expected(n), self.found(n));
        let first = format!("column {i}, row {j}: should be {should:?}, yours {is:?}");
        let mut rows = vec![("first", first)];
        let traced = program.traced(self.reading.width, i, j);
        let vector = |it: common::rtweekend::Vec3| {
            let [x, y, z] = it.to_array();
            format!("({x:.4}, {y:.4}, {z:.4})")
        };
        if let Some(ray) = traced.ray {
            rows.push(("its ray", format!("direction {}", vector(ray.direction))));
        }
        let middle = match program.chapter {
            Chapter::RedSphere | Chapter::Normals => "b",
            _ => "h",
        };
        if let Some(quadratic) = traced.spheres.first() {
            let [a, linear, c] = quadratic.coefficients;
            let discriminant = quadratic.discriminant;
            let numbers = format!(
                "a = {a:.4}, {middle} = {linear:.4}, c = {c:.4}, discriminant = {discriminant:.4}"
            );
            rows.push(("", numbers));
        }
        if let Some((t, _, normal)) = traced.hit {
            rows.push(("", format!("t = {t:.4}, normal {}", vector(normal))));
        } else if !traced.spheres.is_empty() {
            rows.push(("", "it hits nothing".to_owned()));
        }
        rows
    }
}
