//! How a list finds the nearest hit: each hit ends the interval for the next sphere. Spheres
//! and ray move, the order changes, the loop goes on turn by turn, and mistakes break it.

use hittable_list::{Hittable, Sphere};

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
    search: f64 = Number::choice("The search", &[
        "as it should be",
        "returns at the first hit",
        "closest_so_far is not handed on",
    ]);
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
        question: "Which sphere wins if you change the order of the list? And which, if the search \
        returns at the first hit? Can you place the spheres so that even that is right?",
        solution: "Always the nearest one. If the search returns at the first hit, the first sphere of the list that is \
        hit wins: that is right only if it is also the nearest.",
    },
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

/// The list: the spheres in their order.
const LISTS: &[&str] = &[
    "1, 2, 3", "1, 3, 2", "2, 1, 3", "2, 3, 1", "3, 1, 2", "3, 2, 1",
];

/// The radii of the three spheres.
const RADII: [f64; 3] = [0.7, 0.6, 0.5];

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

impl Parameters {
    fn centers(&self) -> [Point3; 3] {
        [self.one, self.two, self.three]
    }

    fn ray(&self) -> Ray {
        Ray::new(self.q, self.d)
    }

    /// The turns so far.
    fn turns(&self) -> Vec<Turn> {
        let mut turns: Vec<Turn> = Vec::new();
        let list = LISTS[self.list as usize].split(", ");
        for name in list.take(self.turns as usize) {
            let number: usize = name.parse().expect("the number of a sphere");
            let sphere = Sphere::new(self.centers()[number - 1], RADII[number - 1]);
            let t_max = self.t_max(held(&turns));
            let hit = t_max.and_then(|t_max| sphere.hit(&self.ray(), 0.0, t_max));
            turns.push(Turn {
                sphere: number,
                t_max,
                hit: hit.map(|it| it.t),
            });
        }
        turns
    }

    /// Up to which t the next sphere is asked; `None` if it is not asked.
    fn t_max(&self, held: Option<(f64, usize)>) -> Option<f64> {
        match (self.search as u8, held) {
            (0, Some((closest_so_far, _))) => Some(closest_so_far),
            (1, Some(_)) => None,
            _ => Some(f64::INFINITY),
        }
    }
}

/// What the search holds after these turns: t, and the number of the sphere.
fn held(turns: &[Turn]) -> Option<(f64, usize)> {
    let mut last_first = turns.iter().rev();
    last_first.find_map(|turn| Some((turn.hit?, turn.sphere)))
}

fn answer(it: &Parameters) -> Answer {
    let right = Parameters { search: 0.0, ..*it }.turns();
    let closest = (0..=right.len()).map(|n| held(&right[..n]));
    let closest = closest.map(|held| in_digits(held.map_or(f64::INFINITY, |(t, _)| t)));
    let closest: Vec<String> = closest.collect();
    let turns = it.turns();
    let sentence = match turns.last() {
        Some(turn) => turn.in_words() + &end(&turns, &right),
        None => "No sphere has had its turn: the first one will be asked for every *t* above 0."
            .to_owned(),
    };
    let says = vec![("held", closest.join(", "))];
    Answer::new(draw(it, &turns), sentence, says)
}

/// What comes out when all had their turn.
fn end(turns: &[Turn], right: &[Turn]) -> String {
    match (held(turns), held(right)) {
        _ if turns.len() < RADII.len() => String::new(),
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
const SIZE: DVec2 = spot(400.0, 192.0);

/// The greatest t on a bar.
const MOST: f64 = 4.4;

/// All t for which a sphere is asked, in that row below the scene. Below a ray to the right,
/// one unit of t is as long as in the scene.
fn bar(row: usize) -> Axis {
    let y = 226.0 + 38.0 * row as f64;
    Axis::new(PLANE.origin.x, y, MOST * PLANE.scale, 0.0, MOST)
}

/// Draws the spheres and the ray, then a bar for each turn so far, and what is held.
fn draw(it: &Parameters, turns: &[Turn]) -> Svg {
    let mut svg = LIVE.figure.sheet(352.0);
    for ((center, radius), name) in it.centers().iter().zip(RADII).zip(1..) {
        let middle = PLANE.point(*center);
        svg.circle("sphere area", middle, PLANE.scale * radius);
        svg.label("sphere", middle.down(5.0), Middle, &format!("{name}"));
    }
    PLANE.draw_line(&mut svg, &it.ray(), SIZE, f64::INFINITY);
    PLANE.draw_ray(&mut svg, &it.ray());
    for (turn, row) in turns.iter().zip(0..) {
        draw_row(
            &mut svg,
            row,
            ["ink", "sphere"],
            &turn.in_words(),
            turn.t_max,
        );
        if let Some(t) = turn.hit.filter(|&t| t < MOST) {
            svg.circle("ray hollow", bar(row).point(t), 5.0);
        }
        let point = turn.hit.map(|t| PLANE.point(it.ray().at(t)));
        if let Some(point) = point.filter(|it| it.cmple(SIZE).all()) {
            svg.circle("ray hollow", point, 5.0);
        }
    }
    let held = held(turns);
    let name = match it.t_max(held) {
        Some(_) => "closest_so_far",
        None => "returned *t*",
    };
    let (t, words) = match held {
        None => (f64::INFINITY, format!("{name} = ∞")),
        Some((t, sphere)) => (t, format!("{name} = {}, sphere {sphere}", in_digits(t))),
    };
    draw_row(&mut svg, turns.len(), ["ray"; 2], &words, Some(t));
    svg
}

/// Words, and below them a bar from 0 to `end`, in these colors.
fn draw_row(svg: &mut Svg, row: usize, ideas: [&str; 2], words: &str, end: Option<f64>) {
    let from = bar(row).start;
    svg.small_label(ideas[0], from.down(-10.0), Start, words);
    let Some(end) = end else {
        return;
    };
    let to = bar(row).point(end);
    let [line, bold] = ["line", "bold"].map(|stroke| format!("{} {stroke}", ideas[1]));
    if end >= MOST {
        return svg.arrow(&bold, from, to);
    }
    svg.line(&bold, from, to);
    svg.line(&line, to.down(-6.0), to.down(6.0));
}
