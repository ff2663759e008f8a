//! How a list finds the nearest hit: each hit ends the interval for the next sphere. Spheres
//! and ray move, the order changes, the loop goes on turn by turn, and slips break it.

use common::rtweekend::*;
use glam::DVec2;
use hittable_list::{Hittable, HittableList, Sphere};
use slips::{Ball, Chapter, Program, World};

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::three_digits;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
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
};

parameters! {
    x_1: Number::new("Sphere 1, to the right", 0.0, 4.4, 2.9),
    y_1: Number::new("Sphere 1, upwards", -0.45, 0.45, 0.3),
    x_2: Number::new("Sphere 2, to the right", 0.0, 4.4, 1.85),
    y_2: Number::new("Sphere 2, upwards", -0.45, 0.45, -0.25),
    x_3: Number::new("Sphere 3, to the right", 0.0, 4.4, 3.8),
    y_3: Number::new("Sphere 3, upwards", -0.45, 0.45, -0.2),
    d_x: Number::new("d, to the right", 0.25, 2.0, 1.0),
    d_y: Number::new("d, upwards", -0.5, 0.5, 0.0),
    q_x: Number::new("Q, to the right", 0.0, 2.0, 0.0),
    q_y: Number::new("Q, upwards", -0.6, 0.6, 0.0),
    turns: Number::whole("Turns", 0.0, 3.0, 3.0),
    list: Number::choice("The list", LISTS),
    search: Number::choice("The search", SEARCHES),
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "Which sphere wins if you change the order of the list? And which, if the search \
        returns at the first hit? Can you place the spheres so that even that is right?",
    solution: "Always the nearest one. If the search returns at the first hit, the first sphere of the list that is \
        hit wins: that is right only if it is also the nearest.",
    handles: &[
        Handle::new(&["x_1", "y_1"], |it, to| {
            [it.x_1, it.y_1, _] = PLANE.place(to).to_array();
        }),
        Handle::new(&["x_2", "y_2"], |it, to| {
            [it.x_2, it.y_2, _] = PLANE.place(to).to_array();
        }),
        Handle::new(&["x_3", "y_3"], |it, to| {
            [it.x_3, it.y_3, _] = PLANE.place(to).to_array();
        }),
        Handle::new(&["d_x", "d_y"], |it, to| {
            [it.d_x, it.d_y, _] = (PLANE.place(to) - it.ray().origin).to_array();
        }),
        Handle::new(&["q_x", "q_y"], |it, to| {
            [it.q_x, it.q_y, _] = PLANE.place(to).to_array();
        }),
    ],
    actions: &[Action::new("Next turn", |it| {
        it.turns = (it.turns + 1.0) % 4.0;
    })],
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

/// The search as it should be, and two slips: their names in the catalogue, and whether they
/// go on after a hit.
const SLIPS: [(&str, bool); 2] = [("first-hit-wins", false), ("closest-ignored", true)];
const SEARCHES: &[&str] = &[
    "as it should be",
    "returns at the first hit",
    "closest_so_far is not handed on",
];

/// The radii of the three spheres.
const RADII: [f64; 3] = [0.7, 0.6, 0.5];

impl Parameters {
    fn ray(&self) -> Ray {
        Ray::new(
            Point3::new(self.q_x, self.q_y, 0.0),
            Vec3::new(self.d_x, self.d_y, 0.0),
        )
    }

    fn spheres(&self) -> [Ball; 3] {
        let [one, two, three] = RADII;
        [
            Ball::new(self.x_1, self.y_1, 0.0, one),
            Ball::new(self.x_2, self.y_2, 0.0, two),
            Ball::new(self.x_3, self.y_3, 0.0, three),
        ]
    }

    fn scene(&self, search: Search) -> Scene {
        Scene {
            spheres: self.spheres(),
            order: ORDERS[self.list as usize],
            ray: self.ray(),
            turns: self.turns as usize,
            search,
        }
    }
}

/// Who searches the list.
#[expect(clippy::large_enum_variant, reason = "there is one at a time")]
#[derive(Clone, Copy)]
enum Search {
    /// The list of chapter 5.
    Right,
    /// What a slip makes of it, and whether that goes on after a hit.
    Slipped(Program, bool),
}

impl Search {
    /// The t of the hit that counts, and the place in the list of the sphere that is hit.
    fn winner(&self, list: &[Ball], ray: &Ray) -> Option<(f64, usize)> {
        match self {
            Self::Right => {
                let mut world = HittableList::default();
                for &Ball { center, radius } in list {
                    world.add(Sphere::new(center, radius));
                }
                let t_of =
                    |object: &dyn Hittable| object.hit(ray, 0.0, f64::INFINITY).map(|it| it.t);
                let nearest = t_of(&world)?;
                // Of two that are equally near, the first one counts.
                let mut list = list.iter();
                let place = list.position(|&Ball { center, radius }| {
                    t_of(&Sphere::new(center, radius)) == Some(nearest)
                })?;
                Some((nearest, place))
            }
            Self::Slipped(program, _) => {
                let program = Program {
                    world: World::of(list),
                    ..*program
                };
                let (t, hit) = program.search(ray)?;
                let place = list.iter().position(|&it| it == hit)?;
                Some((t, place))
            }
        }
    }

    /// Up to which t the next sphere is asked, given the t of the last hit; `None` if it is
    /// not asked.
    fn t_max(&self, last_hit: Option<f64>) -> Option<f64> {
        match self {
            Self::Right => Some(last_hit.unwrap_or(f64::INFINITY)),
            Self::Slipped(program, goes_on) => {
                (*goes_on || last_hit.is_none()).then_some(program.t_max)
            }
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
    search: Search,
}

fn answer(parameters: &Parameters) -> Answer {
    let right = parameters.scene(Search::Right);
    let slip = (parameters.search as usize)
        .checked_sub(1)
        .map(|n| SLIPS[n]);
    let slipped = slip.and_then(|(name, goes_on)| {
        let program = slips::find(name)?.program(Chapter::HittableList);
        Some(parameters.scene(Search::Slipped(program, goes_on)))
    });
    let shown = slipped.as_ref().unwrap_or(&right);
    let held: Vec<String> = (0..=right.turns)
        .map(|turns| right.held_after(turns))
        .map(|held| in_digits(held.map_or(f64::INFINITY, |(t, _)| t)))
        .collect();
    let [one, two, three] = shown.spheres.map(|sphere| sphere.center);
    Answer {
        drawing: draw(shown),
        sentence: format!("{}{}", turn(shown), end(shown, &right)),
        handles: [one, two, three, shown.ray.at(1.0), shown.ray.origin]
            .map(|it| PLANE.point(it))
            .into(),
        says: vec![("held", held.join(", "))],
    }
}

/// What happened in the last turn.
fn turn(shown: &Scene) -> String {
    let Some(Turn { sphere, t_max, hit }) = shown.turns().pop() else {
        return "No sphere has had its turn: the first one will be asked for every *t* above 0."
            .to_owned();
    };
    match (t_max.map(in_digits), hit.map(in_digits)) {
        (None, _) => format!("Sphere {sphere} is not asked: the search has returned."),
        (Some(end), None) => {
            format!("Sphere {sphere} is asked for 0 < *t* < {end}, and not hit there.")
        }
        (Some(end), Some(t)) => {
            format!("Sphere {sphere} is asked for 0 < *t* < {end}, and hit at {t}.")
        }
    }
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

/// What becomes of a sphere when it has its turn.
struct Turn {
    /// The number of the sphere.
    sphere: usize,
    /// Up to which t it is asked, if at all.
    t_max: Option<f64>,
    /// Where it is hit before that.
    hit: Option<f64>,
}

impl Scene {
    /// The turns so far. A search of the list as far as it has come tells what it holds after
    /// each of them.
    fn turns(&self) -> Vec<Turn> {
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
    fn held(&self) -> Option<(f64, usize)> {
        self.held_after(self.turns)
    }

    fn held_after(&self, turns: usize) -> Option<(f64, usize)> {
        let (t, place) = self.winner(turns)?;
        Some((t, self.order[place] + 1))
    }

    fn winner(&self, count: usize) -> Option<(f64, usize)> {
        let list = self.order.map(|place| self.spheres[place]);
        self.search.winner(&list[..count], &self.ray)
    }
}

/// A t of a hit, or the end of an interval, in few digits.
fn in_digits(t: f64) -> String {
    match t {
        f64::INFINITY => "∞".to_owned(),
        _ => three_digits(t),
    }
}

/// Where the scene is on the sheet.
const PLANE: Plane = Plane::new(24.0, 96.0, 82.0);

/// The size of the part of the sheet with the scene.
const SCENE: DVec2 = DVec2::new(400.0, 192.0);

/// Draws the spheres and the ray, then a bar for each turn so far, and what is held.
fn draw(scene: &Scene) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 352.0);
    draw_scene(&mut svg, scene);
    let ray = &scene.ray;
    let turns = scene.turns();
    for (turn, row) in turns.iter().zip(0..) {
        draw_turn(&mut svg, turn, row);
        let point = turn.hit.map(|t| PLANE.point(ray.at(t)));
        if let Some(point) = point.filter(|it| it.cmple(SCENE).all()) {
            svg.circle("ray hollow", point, 5.0);
        }
    }
    draw_held(&mut svg, scene, turns.len());
    svg
}

fn draw_scene(svg: &mut Svg, Scene { spheres, ray, .. }: &Scene) {
    for &Ball { center, radius } in spheres {
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
    for (sphere, name) in spheres.iter().zip(1..) {
        let at = PLANE.point(sphere.center) + DVec2::new(0.0, 5.0);
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

fn draw_held(svg: &mut Svg, scene: &Scene, row: usize) {
    let held = scene.held();
    let (t, sphere) = match held {
        None => (f64::INFINITY, String::new()),
        Some((t, sphere)) => (t, format!(", sphere {sphere}")),
    };
    let name = match scene.search.t_max(held.map(|(t, _)| t)) {
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
