//! How a list finds the nearest hit: each hit ends the interval for the next sphere. Spheres
//! and ray move, the order changes, the loop goes on turn by turn, and slips break it.

use hittable_list::{Hittable, HittableList, Sphere};
use slips::{Ball, Chapter, Program, World};

use crate::vocabulary::*;

parameters! {
    one: Point3 =
        Number::new("Sphere 1, to the right", 0.0, 4.4, 2.9),
        Number::new("Sphere 1, upwards", -0.45, 0.45, 0.3);
    two: Point3 =
        Number::new("Sphere 2, to the right", 0.0, 4.4, 1.85),
        Number::new("Sphere 2, upwards", -0.45, 0.45, -0.25);
    three: Point3 =
        Number::new("Sphere 3, to the right", 0.0, 4.4, 3.8),
        Number::new("Sphere 3, upwards", -0.45, 0.45, -0.2);
    d: Vec3 =
        Number::new("d, to the right", 0.25, 2.0, 1.0),
        Number::new("d, upwards", -0.5, 0.5, 0.0);
    q: Point3 =
        Number::new("Q, to the right", 0.0, 2.0, 0.0),
        Number::new("Q, upwards", -0.6, 0.6, 0.0);
    turns: f64 = Number::whole("Turns", 0.0, 3.0, 3.0);
    list: f64 = Number::choice("The list", LISTS);
    search: f64 = Number::choice("The search", SEARCHES);
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: Figure {
        name: "nearest",
        title: "The nearest hit wins",
        description: "A ray passes through three spheres: first through sphere 2, then through sphere 1, \
            last through sphere 3. Below, a bar for each sphere, in the order of the list, shows for \
            which t it is asked. Sphere 1 is asked for all t above 0, and hit. The bar of sphere 2 \
            ends at that hit, and sphere 2 is hit nearer. The bar of sphere 3 ends there, and nothing \
            is hit. A last bar, as long, is closest_so_far.",
        caption: "A list asks each sphere in turn. After a hit, the next sphere should be asked only for nearer \
            places, so that a sphere behind the nearest hit so far cannot win.",
        draw: || LIVE.on_page(),
    },
    question: "Which sphere wins if you change the order of the list? And which, if the search \
        returns at the first hit? Can you place the spheres so that even that is right?",
    solution: "Always the nearest one. If the search returns at the first hit, the first sphere of the list that is \
        hit wins: that is right only if it is also the nearest.",
    handles: &[
        point!(PLANE, one),
        point!(PLANE, two),
        point!(PLANE, three),
        point!(PLANE, d from q),
        point!(PLANE, q),
    ],
    actions: &[("Next turn", |it| it.turns = (it.turns + 1.0) % 4.0)],
    answer,
};

/// The orders of the list: who comes first, second and third, as places of the spheres.
const ORDERS: [[usize; 3]; 6] = [
    [0, 1, 2],
    [0, 2, 1],
    [1, 0, 2],
    [1, 2, 0],
    [2, 0, 1],
    [2, 1, 0],
];
const LISTS: &[&str] = &[
    "1, 2, 3", "1, 3, 2", "2, 1, 3", "2, 3, 1", "3, 1, 2", "3, 2, 1",
];

/// The search as it should be, and two slips: their names in the catalogue. The second one
/// goes on after a hit.
const SLIPS: [&str; 2] = ["first-hit-wins", "closest-ignored"];
const SEARCHES: &[&str] = &[
    "as it should be",
    "returns at the first hit",
    "closest_so_far is not handed on",
];

/// The radii of the three spheres.
const RADII: [f64; 3] = [0.7, 0.6, 0.5];

impl Parameters {
    fn scene(&self, slipped: Option<Program>) -> Scene {
        let centers = [self.one, self.two, self.three];
        Scene {
            spheres: std::array::from_fn(|n| Ball {
                center: centers[n],
                radius: RADII[n],
            }),
            order: ORDERS[self.list as usize],
            ray: Ray::new(self.q, self.d),
            turns: self.turns as usize,
            slipped,
            goes_on: self.search >= 2.0,
        }
    }
}

/// Spheres in an order, and a ray, in the plane of x and y.
struct Scene {
    /// The spheres 1, 2 and 3.
    spheres: [Ball; 3],
    /// The list: who comes first, second and third, as places in `spheres`.
    order: [usize; 3],
    ray: Ray,
    /// How many of the list have had their turn.
    turns: usize,
    /// What a slip makes of the search; or else it is that of chapter 5.
    slipped: Option<Program>,
    /// Whether the slip goes on after a hit.
    goes_on: bool,
}

/// What becomes of a sphere when it has its turn.
struct Turn {
    /// The number of the sphere.
    sphere: usize,
    /// Up to which t it is asked, if at all.
    t_max: Option<f64>,
    /// Where it is hit before that.
    hit: Option<f64>,
}

impl Turn {
    fn in_words(&self) -> String {
        let sphere = self.sphere;
        let Some(end) = self.t_max.map(in_digits) else {
            return format!("Sphere {sphere} is not asked: the search has returned.");
        };
        let result = match self.hit.map(in_digits) {
            None => "not hit there".to_owned(),
            Some(t) => format!("hit at {t}"),
        };
        format!("Sphere {sphere} is asked for 0 < *t* < {end}, and {result}.")
    }
}

impl Scene {
    /// The turns so far. A search of the list as far as it has come tells what it holds after
    /// each of them.
    fn turns(&self) -> Vec<Turn> {
        let turn = |n: usize| {
            let [before, after] = [n, n + 1].map(|count| self.held_after(count));
            Turn {
                sphere: self.order[n] + 1,
                t_max: self.t_max(before.map(|(t, _)| t)),
                hit: after.filter(|_| after != before).map(|(t, _)| t),
            }
        };
        (0..self.turns).map(turn).collect()
    }

    /// What the search holds after the turns so far: t, and the number of the sphere.
    fn held(&self) -> Option<(f64, usize)> {
        self.held_after(self.turns)
    }

    fn held_after(&self, turns: usize) -> Option<(f64, usize)> {
        let list = &self.order.map(|place| self.spheres[place])[..turns];
        let (t, place) = match self.slipped {
            None => nearest(list, &self.ray)?,
            Some(program) => {
                let world = World::of(list);
                let (t, hit) = Program { world, ..program }.search(&self.ray)?;
                (t, list.iter().position(|&it| it == hit)?)
            }
        };
        Some((t, self.order[place] + 1))
    }

    /// Up to which t the next sphere is asked, given the t of the last hit; `None` if it is
    /// not asked.
    fn t_max(&self, last_hit: Option<f64>) -> Option<f64> {
        match self.slipped {
            None => Some(last_hit.unwrap_or(f64::INFINITY)),
            Some(_) if last_hit.is_some() && !self.goes_on => None,
            Some(program) => Some(program.t_max),
        }
    }
}

/// The t of the nearest hit by the list of chapter 5, and the place of the sphere that is hit.
fn nearest(list: &[Ball], ray: &Ray) -> Option<(f64, usize)> {
    let sphere = |&Ball { center, radius }| Sphere::new(center, radius);
    let t_of = |object: &dyn Hittable| object.hit(ray, 0.0, f64::INFINITY).map(|it| it.t);
    let mut world = HittableList::default();
    list.iter().for_each(|ball| world.add(sphere(ball)));
    let nearest = t_of(&world)?;
    // Of two that are equally near, the first one counts.
    let place = list
        .iter()
        .position(|ball| t_of(&sphere(ball)) == Some(nearest))?;
    Some((nearest, place))
}

fn answer(parameters: &Parameters) -> Answer {
    let right = parameters.scene(None);
    let slip = chosen(parameters.search, &SLIPS);
    let slipped = slip.map(|slip| parameters.scene(Some(slip.program(Chapter::HittableList))));
    let shown = slipped.as_ref().unwrap_or(&right);
    let held = |turns| right.held_after(turns).map_or(f64::INFINITY, |(t, _)| t);
    let held: Vec<String> = (0..=right.turns).map(|n| in_digits(held(n))).collect();
    let sentence = match shown.turns().last() {
        Some(turn) => turn.in_words() + &end(shown, &right),
        None => "No sphere has had its turn: the first one will be asked for every *t* above 0."
            .to_owned(),
    };
    Answer::new(draw(shown), sentence, vec![("held", held.join(", "))])
}

/// What comes out when all had their turn.
fn end(shown: &Scene, right: &Scene) -> String {
    if shown.turns < shown.order.len() {
        return String::new();
    }
    match (shown.held(), right.held()) {
        (Some((t, sphere)), Some((nearest, nearer))) if t > nearest => format!(
            " Sphere {sphere} wins, and is painted over sphere {nearer}, which is nearer: its *t* is {}.",
            in_digits(nearest)
        ),
        (Some((_, sphere)), _) => format!(" Sphere {sphere} wins, and no other is nearer."),
        (None, _) => " No sphere is hit ahead of **Q**.".to_owned(),
    }
}

/// A t of a hit, or the end of an interval, in few digits.
fn in_digits(t: f64) -> String {
    match t {
        f64::INFINITY => "∞".to_owned(),
        _ => three_digits(t),
    }
}

/// Where the scene is on the sheet, and its size.
const PLANE: Plane = Plane::new(24.0, 96.0, 82.0);
const SIZE: DVec2 = DVec2::new(400.0, 192.0);

/// The greatest t on a bar.
const MOST: f64 = 4.4;

/// All t for which a sphere is asked, in that row below the scene. Below a ray to the right,
/// one unit of t is as long as in the scene.
fn bar(row: usize) -> Axis {
    let y = 226.0 + 38.0 * row as f64;
    Axis::new(PLANE.origin.x, y, MOST * PLANE.scale, 0.0, MOST)
}

/// Draws the spheres and the ray, then a bar for each turn so far, and what is held.
fn draw(scene: &Scene) -> Svg {
    let mut svg = LIVE.figure.sheet(352.0);
    for (Ball { center, radius }, name) in scene.spheres.iter().zip(1..) {
        let middle = PLANE.point(*center);
        svg.circle("sphere area", middle, PLANE.scale * radius);
        let down = middle + DVec2::new(0.0, 5.0);
        svg.label("sphere", down, Middle, &format!("{name}"));
    }
    PLANE.draw_line(&mut svg, &scene.ray, SIZE, f64::INFINITY);
    PLANE.draw_ray(&mut svg, &scene.ray);
    let turns = scene.turns();
    for (turn, row) in turns.iter().zip(0..) {
        draw_turn(&mut svg, turn, row);
        let point = turn.hit.map(|t| PLANE.point(scene.ray.at(t)));
        if let Some(point) = point.filter(|it| it.cmple(SIZE).all()) {
            svg.circle("ray hollow", point, 5.0);
        }
    }
    draw_held(&mut svg, scene, turns.len());
    svg
}

fn draw_turn(svg: &mut Svg, turn: &Turn, row: usize) {
    svg.small_label("ink", above(row), Start, &turn.in_words());
    if let Some(end) = turn.t_max {
        draw_bar(svg, "sphere", end, row);
    }
    if let Some(t) = turn.hit.filter(|&t| t < MOST) {
        svg.circle("ray hollow", bar(row).at(t), 5.0);
    }
}

fn draw_held(svg: &mut Svg, scene: &Scene, row: usize) {
    let held = scene.held();
    let (t, sphere) = match held {
        None => (f64::INFINITY, String::new()),
        Some((t, sphere)) => (t, format!(", sphere {sphere}")),
    };
    let name = match scene.t_max(held.map(|(t, _)| t)) {
        Some(_) => "closest_so_far",
        None => "returned *t*",
    };
    let words = format!("{name} = {}{sphere}", in_digits(t));
    svg.small_label("ray", above(row), Start, &words);
    draw_bar(svg, "ray", t, row);
}

/// All t from 0 to `end`.
fn draw_bar(svg: &mut Svg, idea: &str, end: f64, row: usize) {
    let (from, to) = (bar(row).start, bar(row).at(end));
    let bold = format!("{idea} bold");
    if end >= MOST {
        return svg.arrow(&bold, from, to);
    }
    let half = DVec2::new(0.0, 6.0);
    svg.line(&bold, from, to);
    svg.line(&format!("{idea} line"), to - half, to + half);
}

fn above(row: usize) -> DVec2 {
    bar(row).start - DVec2::new(0.0, 10.0)
}
