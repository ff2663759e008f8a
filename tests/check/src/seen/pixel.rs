//! The first pixel that differs, with all numbers as they should be on its way.

use slips::Chapter;

use super::view::View;

impl View<'_> {
    /// What a reader's program should print for that pixel.
    pub(super) fn first_pixel(&self) -> Option<String> {
        let n = *self.wrong.iter().min()?;
        let program = self.program();
        let camera = program.camera(self.reading.width);
        let (i, j) = (n % self.reading.width, n / self.reading.width);
        let [red, green, blue] = self.expected(n);
        let color = format!("levels {red} {green} {blue}");
        if program.balls().len() == 0 {
            return Some(format!("In column {i}, row {j} there should be {color}."));
        }
        let ray = (program.ray)(&program, &camera, i, j);
        let [x, y, z] = ray.direction.to_array();
        let ball = program.balls().next()?;
        let oc = (program.oc)(ball.center, ray.origin);
        let a = (program.a)(&program, ray.direction);
        let linear = (program.linear)((program.dot)(ray.direction, oc));
        let c = (program.constant)((program.squared)(&program, oc), ball.radius);
        let discriminant = (program.discriminant)(a, linear, c);
        let name = match program.chapter {
            Chapter::RedSphere | Chapter::Normals => "b",
            _ => "h",
        };
        let hit = match program.search(&ray) {
            Some((t, _)) => format!("it hits at t = {t:.4}"),
            None => "it hits nothing".to_owned(),
        };
        Some(format!(
            "In column {i}, row {j} the ray has the direction ({x:.4}, {y:.4}, {z:.4}); with the first sphere a = {a:.4}, {name} = {linear:.4}, c = {c:.4}, the discriminant is {discriminant:.4}, {hit}, and there should be {color}.",
        ))
    }
}
