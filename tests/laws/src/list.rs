//! The law for the search of a list of spheres.

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Ball, Chapter, Program};

use crate::Verdict;
use crate::question::{Question, code, of_ray, vector};

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

/// The answer of a list is the least of its members' own answers, in whatever order they
/// are added.
pub fn the_nearest_of_all_members_is_returned(search: &Search, world: &World) -> Verdict {
    let alone = world.spheres.iter().filter_map(|&sphere| {
        search(&World {
            spheres: vec![sphere],
            ..world.clone()
        })
    });
    let (found, expected) = (search(world), alone.reduce(f64::min));
    prop_assert!(
        found == expected,
        "the law:  of all that a ray hits, the nearest counts\n\
         found:    {found:?}\n\
         allowed:  {expected:?}, the least of the members' own answers\n\
         read:     chapter 5: closest_so_far"
    );
    Ok(())
}

impl World {
    /// What the list of a program finds.
    pub(crate) fn nearest_of(&self, program: &Program) -> Option<f64> {
        let ball = |&(center, radius): &(Point3, f64)| Ball { center, radius };
        let balls: Vec<Ball> = self.spheres.iter().map(ball).collect();
        program.search_among(&balls, &self.ray, self.t_min, self.t_max)
    }
}

impl Question for World {
    fn kind(&self) -> &'static str {
        "list"
    }

    fn as_test(&self, _: Chapter) -> String {
        let sphere = |&(center, radius): &_| format!("({}, {radius:?})", vector(center));
        let spheres: Vec<String> = self.spheres.iter().map(sphere).collect();
        let spheres = spheres.join(",\n    ");
        let ray = code(&of_ray(self.ray));
        let [t_min, t_max] = [self.t_min, self.t_max].map(|end| code(&[end]));
        format!(
            "let spheres = vec![\n    {spheres},\n];\nlet ray = {ray};\n\
             let world = laws::list::World {{ spheres, ray, t_min: {t_min}, t_max: {t_max} }};\n\
             laws::holds(laws::list::the_nearest_of_all_members_is_returned(&nearest, &world));"
        )
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        self.nearest_of(program).into_iter().collect()
    }
}
