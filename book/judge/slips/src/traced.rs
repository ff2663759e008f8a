//! A trace of one pixel: every number on its way from a column and a row to its levels.

use common::rtweekend::*;

use crate::chapter::Chapter;
use crate::program::Program;

/// A label and what it is about.
pub type Row = (String, String);

impl Program {
    /// The numbers of the pixel in a column and a row of a picture of that width, with their
    /// names in the chapter, from the viewport to the levels.
    pub fn traced(&self, width: u32, column: u32, row: u32) -> Vec<Row> {
        let camera = self.camera(width);
        let color = (self.color)(self, &camera, column, row);
        let levels = self.channels.map(|it| (self.level)(color.to_array()[it]));
        let mut rows = Vec::new();
        if self.chapter != Chapter::BuildTest {
            rows = self.traced_ray(&self.ray(&camera, column, row));
        }
        let [r, g, b] = levels;
        rows.push(("color".into(), vector(color)));
        rows.push(("levels".into(), format!("{r} {g} {b}")));
        rows
    }

    /// The ray, the quadratic of each sphere, and the hit that wins.
    fn traced_ray(&self, ray: &Ray) -> Vec<Row> {
        let mut rows: Vec<Row> = Vec::new();
        let mut row = |label: &str, of: &str, said| rows.push((format!("{label}{of}"), said));
        row("point on the viewport", "", vector(ray.at(1.0)));
        row("origin", "", vector(ray.origin));
        row("direction", "", vector(ray.direction));
        let middle = match self.chapter {
            Chapter::RedSphere | Chapter::Normals => "b",
            _ => "h",
        };
        for (n, &ball) in (1..).zip(self.world) {
            let of = match self.world.len() {
                1 => String::new(),
                _ => format!(", sphere {n}"),
            };
            let [a, b, c] = self.coefficients(ball, ray);
            let discriminant = (self.discriminant)(self.four, a, b, c);
            let t = self.hit(ball, ray, self.t_min, self.t_max);
            row("a", &of, number(a));
            row(middle, &of, number(b));
            row("c", &of, number(c));
            row("discriminant", &of, number(discriminant));
            row("t", &of, t.map_or("no hit".to_owned(), number));
        }
        if let Some((t, ball)) = self.search(ray) {
            let point = ray.at(t);
            let outward = (self.outward)(self, point, ball);
            let normal = (self.face)(self, ray.direction, outward);
            row("point", "", vector(point));
            row("normal", "", vector(normal));
        }
        rows
    }
}

/// Lines with tabs: a label of the first, and what each has for it.
pub fn side_by_side(all: &[Vec<Row>]) -> String {
    let [first, others @ ..] = all else {
        return String::new();
    };
    let said = |rows: &Vec<Row>, label: &str| {
        let row = rows.iter().find(|(other, _)| other == label);
        row.map_or("none".to_owned(), |(_, said)| said.clone())
    };
    let more = others.iter().flatten();
    let more = more.filter(|(label, _)| first.iter().all(|(other, _)| other != label));
    let labels = first.iter().chain(more).map(|(label, _)| label);
    let line = |label: &String| {
        let columns = all.iter().map(|rows| said(rows, label));
        let columns: Vec<String> = columns.collect();
        format!("{label}\t{}", columns.join("\t"))
    };
    labels.map(line).collect::<Vec<_>>().join("\n")
}

fn vector(of: Vec3) -> String {
    let [x, y, z] = of.to_array().map(number);
    format!("({x}, {y}, {z})")
}

/// To a millionth, or with four digits that count if it is smaller than most.
fn number(it: f64) -> String {
    match it.abs() {
        small if small != 0.0 && small < 1e-3 => format!("{it:.3e}"),
        _ => format!("{}", (it * 1e6).round() / 1e6),
    }
}
