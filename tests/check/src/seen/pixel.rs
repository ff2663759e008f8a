//! The first pixel that differs, with all numbers as they should be on its way.

use slips::Chapter;

use super::view::View;

impl View<'_> {
    /// What a reader's program should print for that pixel.
    pub(super) fn first_pixel(&self) -> Option<String> {
        let n = *self.wrong.iter().min()?;
        let program = self.program();
        let (i, j) = (n % self.reading.width, n / self.reading.width);
        let [red, green, blue] = self.expected(n);
        let color = format!("levels {red} {green} {blue}");
        let traced = program.traced(self.reading.width, i, j);
        let (Some(ray), Some(quadratic)) = (traced.ray, traced.spheres.first()) else {
            return Some(format!("In column {i}, row {j} there should be {color}."));
        };
        let [x, y, z] = ray.direction.to_array();
        let [a, linear, c] = quadratic.coefficients;
        let discriminant = quadratic.discriminant;
        let name = match program.chapter {
            Chapter::RedSphere | Chapter::Normals => "b",
            _ => "h",
        };
        let hit = match traced.hit {
            Some((t, ..)) => format!("it hits at t = {t:.4}"),
            None => "it hits nothing".to_owned(),
        };
        Some(format!(
            "In column {i}, row {j} the ray has the direction ({x:.4}, {y:.4}, {z:.4}); with the first sphere a = {a:.4}, {name} = {linear:.4}, c = {c:.4}, the discriminant is {discriminant:.4}, {hit}, and there should be {color}.",
        ))
    }
}
