//! How a list finds the nearest hit: each hit ends the interval for the next sphere.

use common::rtweekend::*;
use glam::DVec2;
use hittable_list::{Hittable, HittableList, Sphere};

use crate::figure::Figure;
use crate::number::three_digits;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "nearest",
    title: "The nearest hit wins",
    description: "A ray passes through three spheres: first through sphere 2, then through sphere 1, \
        last through sphere 3. Below, a bar for each sphere, in the order of the list, shows for \
        which t it is asked. Sphere 1 is asked for all t above 0, and hit. The bar of sphere 2 \
        ends at that hit, and sphere 2 is hit nearer. The bar of sphere 3 ends there, and nothing \
        is hit. A last bar, as long, is closest_so_far.",
    caption: "A list asks each sphere in turn, and each hit ends the interval for the next. \
        What is behind the nearest hit so far can no longer win.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Copy)]
pub struct Parameters<'a> {
    /// The spheres 1, 2 and 3: center, in the plane of x and y, and radius.
    pub spheres: [(Point3, f64); 3],
    /// The list: who comes first, second and third, as places in `spheres`.
    pub order: [usize; 3],
    /// A ray in the same plane, to the right.
    pub ray: Ray,
    /// How many of the list have had their turn.
    pub turns: usize,
    /// Who searches the list.
    pub search: &'a dyn Search,
}

/// Finds the hit that counts in a list, in one way or another.
pub trait Search {
    /// Its t, and the place in the list of the sphere that is hit.
    fn winner(&self, list: &[(Point3, f64)], ray: &Ray) -> Option<(f64, usize)>;

    /// Up to which t the next sphere is asked, given the t of the last hit; `None` if it is
    /// not asked.
    fn t_max(&self, last_hit: Option<f64>) -> Option<f64>;
}

/// The list of chapter 5.
#[derive(Clone, Copy, Debug)]
pub struct Right;

impl Search for Right {
    fn winner(&self, list: &[(Point3, f64)], ray: &Ray) -> Option<(f64, usize)> {
        let mut world = HittableList::default();
        for &(center, radius) in list {
            world.add(Sphere::new(center, radius));
        }
        let t_of = |object: &dyn Hittable| object.hit(ray, 0.0, f64::INFINITY).map(|it| it.t);
        let nearest = t_of(&world)?;
        // Of two that are equally near, the first one counts.
        let place = list
            .iter()
            .position(|&(center, radius)| t_of(&Sphere::new(center, radius)) == Some(nearest))?;
        Some((nearest, place))
    }

    fn t_max(&self, closest_so_far: Option<f64>) -> Option<f64> {
        Some(closest_so_far.unwrap_or(f64::INFINITY))
    }
}

impl Default for Parameters<'_> {
    fn default() -> Self {
        Self {
            spheres: [
                (Point3::new(2.9, 0.3, 0.0), 0.7),
                (Point3::new(1.85, -0.25, 0.0), 0.6),
                (Point3::new(3.8, -0.2, 0.0), 0.5),
            ],
            order: [0, 1, 2],
            ray: Ray::new(Point3::ZERO, Vec3::X),
            turns: 3,
            search: &Right,
        }
    }
}

/// What becomes of a sphere when it has its turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// The number of the sphere.
    pub sphere: usize,
    /// Up to which t it is asked, if at all.
    pub t_max: Option<f64>,
    /// Where it is hit before that.
    pub hit: Option<f64>,
}

impl Parameters<'_> {
    /// The turns so far. A search of the list as far as it has come tells what it holds after
    /// each of them.
    pub fn turns(&self) -> Vec<Turn> {
        let turn = |n: usize| {
            let [before, after] = [n, n + 1].map(|count| self.winner(count));
            Turn {
                sphere: self.order[n] + 1,
                t_max: self.search.t_max(before.map(|(t, _)| t)),
                hit: after.filter(|_| after != before).map(|(t, _)| t),
            }
        };
        (0..self.turns).map(turn).collect()
    }

    /// What the search holds after the turns so far: t, and the number of the sphere.
    pub fn held(&self) -> Option<(f64, usize)> {
        let (t, place) = self.winner(self.turns)?;
        Some((t, self.order[place] + 1))
    }

    fn winner(&self, count: usize) -> Option<(f64, usize)> {
        let list = self.order.map(|place| self.spheres[place]);
        self.search.winner(&list[..count], &self.ray)
    }
}

/// A t of a hit, or the end of an interval, in few digits.
pub fn in_digits(t: f64) -> String {
    match t {
        f64::INFINITY => "∞".to_owned(),
        _ => three_digits(t),
    }
}

/// Where the scene is on the sheet.
pub const PLANE: Plane = Plane::new(24.0, 96.0, 82.0);

/// The size of the part of the sheet with the scene.
const SCENE: DVec2 = DVec2::new(400.0, 192.0);

/// Draws the spheres and the ray, then a bar for each turn so far, and what is held.
pub fn draw(parameters: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 352.0);
    draw_scene(&mut svg, parameters);
    let ray = &parameters.ray;
    let turns = parameters.turns();
    for (turn, row) in turns.iter().zip(0..) {
        draw_turn(&mut svg, turn, row);
        let point = turn.hit.map(|t| PLANE.point(ray.at(t)));
        if let Some(point) = point.filter(|it| it.cmple(SCENE).all()) {
            svg.circle("ray hollow", point, 5.0);
        }
    }
    draw_held(&mut svg, parameters, turns.len());
    svg.finish()
}

fn draw_scene(svg: &mut Svg, Parameters { spheres, ray, .. }: &Parameters) {
    for &(center, radius) in spheres {
        svg.circle("sphere area", PLANE.point(center), PLANE.scale * radius);
    }
    let [q, tip] = [0.0, 1.0].map(|t| PLANE.point(ray.at(t)));
    if let Some((_, last)) = PLANE.on_sheet(ray, SCENE) {
        svg.arrow("ray line", q, PLANE.point(ray.at(last)));
    }
    svg.arrow("ray bold", q, tip);
    svg.circle("ray solid", q, 4.5);
    let above = DVec2::new(0.0, -16.0);
    svg.label("ink", q + above, Anchor::Middle, "**Q**");
    svg.label("ray", 0.5 * (q + tip) + above, Anchor::Middle, "**d**");
    for ((center, _), name) in spheres.iter().zip(1..) {
        let at = PLANE.point(*center) + DVec2::new(0.0, 5.0);
        svg.label("sphere", at, Anchor::Middle, &format!("{name}"));
    }
}

fn draw_turn(svg: &mut Svg, turn: &Turn, row: usize) {
    let Turn { sphere, t_max, hit } = *turn;
    let words = match (t_max.map(in_digits), hit.map(in_digits)) {
        (None, _) => "not asked".to_owned(),
        (Some(end), None) => format!("0 < *t* < {end}: no hit"),
        (Some(end), Some(t)) => format!("0 < *t* < {end}: hit at *t* = {t}"),
    };
    let words = format!("sphere {sphere}, {words}");
    svg.label("ink", above(row), Anchor::Start, &words);
    if let Some(end) = t_max {
        draw_bar(svg, "sphere", end, row);
    }
    if let Some(t) = hit.filter(|&t| t < MOST) {
        svg.circle("ray hollow", on_bar(t, row), 5.0);
    }
}

fn draw_held(svg: &mut Svg, parameters: &Parameters, row: usize) {
    let held = parameters.held();
    let (t, sphere) = match held {
        None => (f64::INFINITY, String::new()),
        Some((t, sphere)) => (t, format!(", sphere {sphere}")),
    };
    let name = match parameters.search.t_max(held.map(|(t, _)| t)) {
        Some(_) => "closest_so_far",
        None => "returned *t*",
    };
    let words = format!("{name} = {}{sphere}", in_digits(t));
    svg.label("ray", above(row), Anchor::Start, &words);
    draw_bar(svg, "ray", t, row);
}

/// All t from 0 to `end`.
fn draw_bar(svg: &mut Svg, idea: &str, end: f64, row: usize) {
    let [from, to] = [0.0, end.min(MOST)].map(|t| on_bar(t, row));
    let bold = format!("{idea} bold");
    match end < MOST {
        false => svg.arrow(&bold, from, to),
        true => {
            let half = DVec2::new(0.0, 6.0);
            svg.line(&bold, from, to);
            svg.line(&format!("{idea} line"), to - half, to + half);
        }
    }
}

/// The greatest t on a bar.
const MOST: f64 = 4.4;

/// Below a ray to the right, one unit of t is as long as in the scene.
fn on_bar(t: f64, row: usize) -> DVec2 {
    let [x, y] = [PLANE.origin.x + PLANE.scale * t, 226.0 + 38.0 * row as f64];
    DVec2::new(x, y)
}

fn above(row: usize) -> DVec2 {
    on_bar(0.0, row) - DVec2::new(0.0, 10.0)
}
