//! How a list finds the nearest hit: each hit ends the interval for the next sphere. Spheres
//! and ray move, and the order of the list changes.

use hittable_list::{Hittable, Sphere};

use crate::prelude::*;

parameters! {
    one: Point3 =
        Parameter::new("Sphere 1, to the right", 0.0, 4.4, 2.9),
        Parameter::new("Sphere 1, upwards", -0.45, 0.45, 0.3);
    two: Point3 =
        Parameter::new("Sphere 2, to the right", 0.0, 4.4, 1.85),
        Parameter::new("Sphere 2, upwards", -0.45, 0.45, -0.25);
    three: Point3 =
        Parameter::new("Sphere 3, to the right", 0.0, 4.4, 3.8),
        Parameter::new("Sphere 3, upwards", -0.45, 0.45, -0.2);
    d: Vec3 =
        Parameter::new("d, to the right", 0.25, 2.0, 1.0),
        Parameter::new("d, upwards", -0.5, 0.5, 0.0);
    q: Point3 =
        Parameter::new("Q, to the right", 0.0, 2.0, 0.0),
        Parameter::new("Q, upwards", -0.6, 0.6, 0.0);
    list: f64 = Parameter::choice("The list", LISTS);
}

/// The live figure: three spheres and a ray to be moved, and the order in which a list asks them.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("nearest"),
    handles: &[
        point!(PLANE, one),
        point!(PLANE, two),
        point!(PLANE, three),
        point!(PLANE, d from q),
        point!(PLANE, q),
    ],
    actions: &[("Sphere 2 first", |it| it.list = 2.0)],
    answer,
};

/// The orders that the list of spheres can have.
const LISTS: &[&str] = &[
    "1, 2, 3", "1, 3, 2", "2, 1, 3", "2, 3, 1", "3, 1, 2", "3, 2, 1",
];

/// The radii of the three spheres.
const RADII: [f64; 3] = [0.7, 0.6, 0.5];

/// One step of the search: the list asks a sphere for a hit.
struct Turn {
    /// The number of the sphere, counted from 1.
    sphere: usize,
    /// The end of the interval of t for which the sphere is asked.
    t_max: f64,
    /// The t at which the ray hits the sphere inside the interval, or `None`.
    hit: Option<f64>,
}

impl Turn {
    /// Says what the sphere is asked and what it answers.
    fn in_words(&self) -> String {
        let (sphere, end) = (self.sphere, in_digits(self.t_max));
        let result = match self.hit.map(in_digits) {
            None => "not hit there".to_owned(),
            Some(t) => format!("hit at {t}"),
        };
        format!("Sphere {sphere} is asked for 0 < *t* < {end}, and {result}.")
    }

    /// Returns the least t that the search has found after this step.
    fn closest_so_far(&self) -> f64 {
        self.hit.unwrap_or(self.t_max)
    }
}

impl Parameters {
    fn centers(&self) -> [Point3; 3] {
        [self.one, self.two, self.three]
    }

    fn ray(&self) -> Ray {
        Ray::new(self.q, self.d)
    }

    /// Searches the list for the nearest hit; returns all steps.
    fn turns(&self) -> Vec<Turn> {
        let mut t_max = f64::INFINITY;
        let list = LISTS[self.list as usize].split(", ");
        list.map(|name| {
            let number: usize = name.parse().expect("the number of a sphere");
            let sphere = Sphere::new(self.centers()[number - 1], RADII[number - 1]);
            let hit = sphere.hit(&self.ray(), 0.0, t_max);
            let turn = Turn {
                sphere: number,
                t_max,
                hit: hit.map(|it| it.t),
            };
            t_max = turn.closest_so_far();
            turn
        })
        .collect()
    }
}

fn answer(chosen: &Parameters) -> DrawnFigure {
    let turns = chosen.turns();
    let held = turns.iter().map(Turn::closest_so_far);
    let held = [f64::INFINITY].into_iter().chain(held).map(in_digits);
    let held: Vec<String> = held.collect();
    let hits: Vec<&Turn> = turns.iter().filter(|turn| turn.hit.is_some()).collect();
    let sentence = match hits.last() {
        Some(turn) => format!(
            "Sphere {} wins at *t* = {}. Of the three, {} {} hit on the way.",
            turn.sphere,
            in_digits(turn.closest_so_far()),
            hits.len(),
            if hits.len() == 1 { "was" } else { "were" },
        ),
        None => "No sphere is hit ahead of **Q**.".to_owned(),
    };
    DrawnFigure::new(draw(chosen, &turns), sentence, [("held", held.join(", "))])
}

/// Writes the t of a hit, or the end of an interval, which may be infinite, in three digits.
fn in_digits(t: f64) -> String {
    match t {
        f64::INFINITY => "∞".to_owned(),
        _ => three_digits(t),
    }
}

/// The place of the scene on the sheet, and the size of its part of the sheet.
const PLANE: Plane = Plane::new(24.0, 96.0, 82.0);
const SIZE: DVec2 = spot(400.0, 192.0);

/// The greatest t on a bar.
const MOST: f64 = 4.4;

/// Returns the axis of t in a row below the scene. If the ray points to the right and has length 1,
/// a unit of t is as long as in the scene.
fn bar(row: usize) -> Axis {
    let y = 226.0 + 38.0 * row as f64;
    Axis::new(PLANE.origin.x, y, MOST * PLANE.scale, 0.0, MOST)
}

/// Draws the spheres and the ray, a bar for each step of the search, and a last bar for its result.
fn draw(chosen: &Parameters, turns: &[Turn]) -> Svg {
    let mut svg = LIVE.figure.sheet(352.0);
    for ((center, radius), name) in chosen.centers().iter().zip(RADII).zip(1..) {
        let middle = PLANE.point(*center);
        svg.circle("sphere area", middle, PLANE.scale * radius);
        svg.label("sphere", middle.down(5.0), Middle, &format!("{name}"));
    }
    PLANE.draw_line(&mut svg, &chosen.ray(), SIZE, f64::INFINITY);
    PLANE.draw_ray(&mut svg, &chosen.ray());
    let mut closest = f64::INFINITY;
    for (turn, row) in turns.iter().zip(0..) {
        draw_row(&mut svg, row, "sphere", &turn.in_words(), turn.t_max);
        if let Some(t) = turn.hit.filter(|&t| t < MOST) {
            svg.circle("ray hollow", bar(row).point(t), 5.0);
        }
        let point = turn.hit.map(|t| PLANE.point(chosen.ray().at(t)));
        if let Some(point) = point.filter(|it| it.cmple(SIZE).all()) {
            svg.circle("ray hollow", point, 5.0);
        }
        closest = turn.closest_so_far();
    }
    let words = format!("closest_so_far = {}", in_digits(closest));
    draw_row(&mut svg, turns.len(), "ray", &words, closest);
    svg
}

/// Writes words, and draws below them a bar from 0 to `end`.
fn draw_row(svg: &mut Svg, row: usize, idea: &str, words: &str, end: f64) {
    let (from, to) = (bar(row).start, bar(row).point(end));
    svg.small_label("ink", from.down(-10.0), Start, words);
    let bold = format!("{idea} bold");
    if end >= MOST {
        return svg.arrow(&bold, from, to);
    }
    svg.line(&bold, from, to);
    svg.line(&format!("{idea} line"), to.down(-6.0), to.down(6.0));
}
