//! Strategies for spheres that touch, meet or nearly are one.

use common::rtweekend::*;
use laws::list::World;
use laws::oracle::ExactCase;
use laws::strategies::{ahead_if_zero, unit, whole_vector};
use laws::{Case, IntervalCase};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use crate::methods::hostile::{self, ulps_away, with_hostile_interval};

/// Makes worlds of several spheres that are hard to tell apart: one of all kinds in this file.
pub(crate) fn hostile() -> impl Strategy<Value = World> {
    prop_oneof![
        2 => beside_one(),
        1 => through_one_point(),
        1 => mirrored(),
    ]
}

/// Makes a hostile case with its interval, and one to five neighbors of its sphere, in any order.
fn beside_one() -> impl Strategy<Value = World> {
    let asked = with_hostile_interval(hostile::hostile());
    (asked, vec(neighbor(), 1..=5), 0..=5_usize).prop_map(|(asked, neighbors, place)| {
        let IntervalCase { case, t_min, t_max } = asked;
        let mut spheres: Vec<(Point3, f64)> = neighbors
            .into_iter()
            .map(|neighbor| neighbor.of(&case))
            .collect();
        spheres.insert(place.min(spheres.len()), (case.center, case.radius));
        World {
            spheres,
            ray: case.ray,
            t_min,
            t_max,
        }
    })
}

/// A sphere beside another one, whose radius is the unit of its sizes.
#[derive(Clone, Copy, Debug)]
enum Neighbor {
    /// An equal sphere, or almost: so many ulps off in each coordinate of the center and in the
    /// radius.
    Twin([i32; 4]),
    /// A sphere with the same center, and with so many times the radius.
    Nested(f64),
    /// A sphere in this direction, with so many times the radius, that touches the other up to
    /// rounding: from outside, or from inside if negative.
    Touching(Vec3, f64),
    /// A sphere in this direction, with so many times the radius, through the point that the ray
    /// hits, up to rounding.
    ThroughTheHit(Vec3, f64),
    /// A sphere anywhere: its center and its radius.
    Stranger(Point3, f64),
}

fn neighbor() -> impl Strategy<Value = Neighbor> {
    let size = || prop_oneof![-1.0..3.0, Just(1.0), Just(-0.5)];
    prop_oneof![
        [ulps(), ulps(), ulps(), ulps()].prop_map(Neighbor::Twin),
        size().prop_map(Neighbor::Nested),
        (unit(), size()).prop_map(|(way, size)| Neighbor::Touching(way, size)),
        (unit(), size()).prop_map(|(way, size)| Neighbor::ThroughTheHit(way, size)),
        hostile::hostile().prop_map(|case| Neighbor::Stranger(case.center, case.radius)),
    ]
}

impl Neighbor {
    fn of(self, case: &Case) -> (Point3, f64) {
        let Case { center, radius, .. } = *case;
        match self {
            Self::Twin([x, y, z, r]) => {
                let [cx, cy, cz] = center.to_array();
                let moved = [(cx, x), (cy, y), (cz, z)].map(|(x, ulps)| ulps_away(x, ulps));
                (Point3::from(moved), ulps_away(radius, r))
            }
            Self::Nested(size) => (center, size * radius),
            Self::Touching(way, size) => (center + (1.0 + size) * radius * way, size * radius),
            Self::ThroughTheHit(way, size) => {
                let exact = ExactCase::of(case);
                let root = exact.nearest_root_in(0.0, f64::INFINITY);
                let point = case.ray.at(root.map_or(1.0, |root| root.rounded()));
                (point + size * radius * way, size * radius)
            }
            Self::Stranger(center, radius) => (center, radius),
        }
    }
}

/// Spheres of whole numbers through one point of the ray, which some of them enter
/// there, some leave and some touch: their roots there are equal.
fn through_one_point() -> impl Strategy<Value = World> {
    // Three sides of a box, and its diagonal.
    let boxes = vec![
        [0.0, 0.0, 1.0, 1.0],
        [0.0, 3.0, 4.0, 5.0],
        [1.0, 2.0, 2.0, 3.0],
        [2.0, 3.0, 6.0, 7.0],
        [1.0, 4.0, 8.0, 9.0],
        [4.0, 4.0, 7.0, 9.0],
    ];
    let sphere = (select(boxes), any::<[bool; 3]>(), 0..3_usize, 1..=9, ulps()).prop_map(
        |([x, y, z, diagonal], signs, turn, size, ulps)| {
            let mut away = reflected([x, y, z], signs);
            away.rotate_left(turn);
            let size = f64::from(size);
            (size * Vec3::from(away), ulps_away(size * diagonal, ulps))
        },
    );
    // One end in two lies at that root, or an ulp from it.
    let end = || prop_oneof![Just(None), ulps().prop_map(Some)];
    let ray = (whole_vector(99), whole_vector(9), 1..=9);
    (vec(sphere, 2..=6), ray, end(), end()).prop_map(
        |(mut spheres, (origin, direction, t), low, high)| {
            let (direction, t) = (ahead_if_zero(direction), f64::from(t));
            for (center, _) in &mut spheres {
                *center += origin + t * direction;
            }
            World {
                spheres,
                ray: Ray::new(origin, direction),
                t_min: low.map_or(0.0, |ulps| ulps_away(t, ulps)),
                t_max: high.map_or(f64::INFINITY, |ulps| ulps_away(t, ulps)),
            }
        },
    )
}

/// Mirror images of one sphere in planes through the ray: their roots are equal, and
/// most of them are irrational.
fn mirrored() -> impl Strategy<Value = World> {
    let image = (any::<[bool; 3]>(), ulps());
    (whole_vector(9), 1..=9, 1..=9, vec(image, 2..=6)).prop_map(
        |(center, radius, speed, images)| {
            let image = |([swapped, left, down], ulps): ([bool; 3], i32)| {
                let [x, y, z] = center.to_array();
                let [x, y] = if swapped { [y, x] } else { [x, y] };
                let center = reflected([x, y, z], [left, down, false]);
                (Point3::from(center), ulps_away(f64::from(radius), ulps))
            };
            World {
                spheres: images.into_iter().map(image).collect(),
                ray: Ray::new(10.0 * Vec3::Z, f64::from(speed) * Vec3::NEG_Z),
                t_min: 0.0,
                t_max: f64::INFINITY,
            }
        },
    )
}

/// Makes a number of ulps: most often none, or one or two up or down.
fn ulps() -> impl Strategy<Value = i32> {
    prop_oneof![3 => Just(0), 1 => -2..=2]
}

fn reflected(mut numbers: [f64; 3], signs: [bool; 3]) -> [f64; 3] {
    for (number, negative) in numbers.iter_mut().zip(signs) {
        *number *= if negative { -1.0 } else { 1.0 };
    }
    numbers
}
