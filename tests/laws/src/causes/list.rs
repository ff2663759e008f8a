//! The mistakes in the search for the nearest hit of a list.

use common::rtweekend::*;
use speed_vs_accuracy::Case;

use super::{Hypothesis, Mistake, Question};
use crate::intervals::WithInterval;
use crate::list::{World, worlds};
use crate::runner::endless;

/// The hits of all members in the order of the list, each looked for in the whole
/// range.
fn hits(world: &World, t_max: f64) -> impl DoubleEndedIterator<Item = f64> {
    let hit = move |&(center, radius)| {
        let case = Case {
            center,
            radius,
            ray: world.ray,
        };
        let t_min = world.t_min;
        WithInterval { case, t_min, t_max }.right()
    };
    world.spheres.iter().filter_map(hit)
}

type Search = fn(&World) -> Option<f64>;

const SEARCHES: &[(Mistake, Search)] = &[
    (
        Mistake {
            names: &["closest-ignored"],
            wrong: "if (object.hit(r, t_min, t_max, rec))",
            right: "if (object.hit(r, t_min, closest_so_far, rec))",
        },
        |world| hits(world, world.t_max).next_back(),
    ),
    (
        Mistake {
            names: &["first-hit-wins"],
            wrong: "if (object.hit(…)) return true",
            right: "closest_so_far = rec.t; …",
        },
        |world| hits(world, world.t_max).next(),
    ),
    (
        Mistake {
            names: &["farthest-wins"],
            wrong: "if (rec.t > closest_so_far)",
            right: "if (rec.t < closest_so_far)",
        },
        |world| hits(world, world.t_max).reduce(f64::max),
    ),
    (
        Mistake {
            names: &[],
            wrong: "closest_so_far = infinity",
            right: "closest_so_far = t_max",
        },
        |world| hits(world, f64::INFINITY).reduce(f64::min),
    ),
];

impl Question for World {
    type Answer = Option<f64>;

    const FUNCTION: &'static str = "{Hittable, HittableList, Sphere}";

    fn right(&self) -> Option<f64> {
        hits(self, self.t_max).reduce(f64::min)
    }

    fn same(&self, one: &Option<f64>, other: &Option<f64>) -> bool {
        match (one, other) {
            (Some(one), Some(other)) => (one - other).abs() <= 1e-6 * (one.abs() + other.abs()),
            _ => one == other,
        }
    }

    fn telling() -> Vec<Self> {
        endless(&worlds(), "").take(100).collect()
    }

    fn hypotheses() -> Vec<Hypothesis<Self>> {
        let hypothesis = |&(mistake, search): &(Mistake, Search)| Hypothesis::new(mistake, search);
        SEARCHES.iter().map(hypothesis).collect()
    }

    fn is_degenerate(&self) -> bool {
        let is_point = |&(_, radius): &(_, f64)| radius <= 0.0;
        self.ray.direction == Vec3::ZERO || self.spheres.iter().any(is_point)
    }
}
