//! A trace of one pixel: every number on its way from a column and a row to its levels.

use common::rtweekend::*;

use crate::chapter::Chapter;
use crate::program::{Ball, Program};

/// The numbers of a pixel, in the order in which a program finds them.
#[derive(Clone, Debug)]
pub struct Traced {
    /// The ray, if there is one.
    pub ray: Option<Ray>,
    /// The quadratic of each sphere.
    pub spheres: Vec<Quadratic>,
    /// The hit that wins.
    pub hit: Option<(f64, Point3, Vec3)>,
    /// The color, each component from 0 to 1.
    pub color: Color,
    /// The three numbers in the file.
    pub levels: [i32; 3],
}

/// The quadratic of a ray and a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic {
    /// Its a, b or h, and c.
    pub coefficients: [f64; 3],
    /// b² − 4ac, or h² − ac.
    pub discriminant: f64,
    /// The ray parameter of the hit, in lengths of the ray's direction.
    pub t: Option<f64>,
}

impl Program {
    /// The numbers of the pixel in a column and a row of a picture of that width.
    pub fn traced(&self, width: u32, column: u32, row: u32) -> Traced {
        let camera = self.camera(width);
        let color = (self.color)(self, &camera, column, row);
        let components = color.to_array();
        let casts_rays = self.chapter != Chapter::BuildTest;
        let ray = casts_rays.then(|| (self.ray)(self, &camera, column, row));
        let quadratics = |ray| {
            self.world
                .iter()
                .map(move |&ball| self.quadratic(ball, &ray))
        };
        let hit = |ray: Ray| {
            let (t, ball) = self.search(&ray)?;
            let point = (self.hit_point)(self, &ray, t);
            let outward = (self.outward)(self, point, ball);
            Some((t, point, (self.face)(self, ray.direction, outward)))
        };
        Traced {
            ray,
            spheres: ray.into_iter().flat_map(quadratics).collect(),
            hit: ray.and_then(hit),
            color,
            levels: self.channels.map(|it| (self.level)(components[it])),
        }
    }

    fn quadratic(&self, ball: Ball, ray: &Ray) -> Quadratic {
        let [a, b, c] = self.coefficients(ball, ray);
        Quadratic {
            coefficients: [a, b, c],
            discriminant: (self.discriminant)(self.four, a, b, c),
            t: self.hit(ball, ray, self.t_min, self.t_max),
        }
    }
}

/// A label and what it is about.
pub type Row = (String, String);

impl Traced {
    /// The numbers with their names in that chapter, from the viewport to the levels.
    pub fn rows(&self, chapter: Chapter) -> Vec<Row> {
        let mut rows: Vec<Row> = Vec::new();
        let mut row = |label: String, said: String| rows.push((label, said));
        if let Some(ray) = self.ray {
            row("point on the viewport".into(), vector(ray.at(1.0)));
            row("origin".into(), vector(ray.origin));
            row("direction".into(), vector(ray.direction));
        }
        let middle = match chapter {
            Chapter::RedSphere | Chapter::Normals => "b",
            _ => "h",
        };
        for (n, it) in self.spheres.iter().enumerate() {
            let of = match self.spheres.len() {
                1 => String::new(),
                _ => format!(", sphere {}", n + 1),
            };
            let [a, b, c] = it.coefficients.map(number);
            for (label, said) in [("a", a), (middle, b), ("c", c)] {
                row(format!("{label}{of}"), said);
            }
            row(format!("discriminant{of}"), number(it.discriminant));
            let t = it.t.map_or("no hit".to_owned(), number);
            row(format!("t{of}"), t);
        }
        if let Some((_, point, normal)) = self.hit {
            row("point".into(), vector(point));
            row("normal".into(), vector(normal));
        }
        row("color".into(), vector(self.color));
        let [r, g, b] = self.levels;
        row("levels".into(), format!("{r} {g} {b}"));
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
