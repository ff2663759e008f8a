//! Metamorphic relations for the search of a list of spheres.

use common::rtweekend::*;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::intervals::WithInterval;
use crate::strategies;
use crate::verdict::{Broken, Verdict};

/// Spheres, a ray, and a range of `t`.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// Center and radius of each sphere, in the order in which they are added.
    pub spheres: Vec<(Point3, f64)>,
    /// The ray.
    pub ray: Ray,
    /// The lower end of the range, left out.
    pub t_min: f64,
    /// The upper end of the range, left out.
    pub t_max: f64,
}

/// Searches a world for the nearest `t` in its range.
pub type Search<'a> = dyn Fn(&World) -> Option<f64> + 'a;

/// Up to eleven spheres around one that the ray is aimed at: before it, behind
/// it, or overlapping it.
pub fn worlds() -> impl Strategy<Value = World> {
    let asked = strategies::with_interval(prop_oneof![
        strategies::book_rays(),
        strategies::integers(),
        strategies::far(0.5..=3.0),
        strategies::inside(),
    ]);
    let move_and_size = (-3.0..3.0, 0.5..2.0);
    (asked, vec(move_and_size, 0..11), 0..11usize).prop_map(|(asked, others, place)| {
        let WithInterval { case, t_min, t_max } = asked;
        let towards = case.center - case.ray.origin;
        let mut spheres: Vec<(Point3, f64)> = others
            .into_iter()
            .map(|(by, size)| (case.center + by * towards, size * case.radius))
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

/// The answer of a list is the least of its members' own answers.
pub fn the_nearest_of_all_members_is_returned(search: &Search, world: &World) -> Verdict {
    let alone = world.spheres.iter().filter_map(|&sphere| {
        search(&World {
            spheres: vec![sphere],
            ..world.clone()
        })
    });
    let (found, expected) = (search(world), alone.reduce(f64::min));
    if found == expected {
        return Ok(());
    }
    Err(Broken {
        law: "of all that a ray hits, the nearest counts",
        found: format!("{found:?}"),
        allowed: format!("{expected:?}, the least of the members' own answers"),
        usually: "closest_so_far does not start at t_max, or is not handed to the next object, or \
                not updated; or the search ends at the first hit, or before the end of the list",
        page: "chapter 5: closest_so_far",
    })
}

/// Adding the members the other way round, or starting with another one,
/// changes nothing.
pub fn the_order_of_members_does_not_matter(search: &Search, world: &World) -> Verdict {
    let mut reversed = world.clone();
    reversed.spheres.reverse();
    let mut rotated = world.clone();
    rotated.spheres.rotate_left(1);
    let expected = search(world);
    for other in [reversed, rotated] {
        let found = search(&other);
        if found != expected {
            return Err(Broken {
                law: "the order in which things are added does not matter",
                found: format!("{found:?} for {:?}", other.spheres),
                allowed: format!("{expected:?}"),
                usually: "the last hit wins, or the first, instead of the nearest",
                page: "chapter 5: closest_so_far",
            });
        }
    }
    Ok(())
}

/// Two programs find the same in one world, to the last bit.
pub fn both_find_the_same(search: &Search, other: &Search, world: &World) -> Verdict {
    let (found, expected) = (search(world), other(world));
    if found == expected {
        return Ok(());
    }
    Err(Broken {
        law: "a list is nothing but its members, and a list in a list is no different",
        found: format!("{found:?}"),
        allowed: format!("{expected:?}"),
        usually: "the range is not handed on as it came (closest_so_far starts at t_max), or the hit \
                of a member is changed",
        page: "chapter 5: a list is hittable too",
    })
}
