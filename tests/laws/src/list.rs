//! The law for the search of a list of spheres.

use common::rtweekend::*;

use crate::case::{Case, IntervalCase, code, numbers_of_ray, ray_from, vector};
use crate::nearer_root::said;
use crate::record::RecordSolver;
use crate::verdict::{BrokenLaw, LawResult};

/// A question to a list of spheres: which of them does a ray hit first, within an open interval of
/// `t`?
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// The center and the radius of each sphere, in the order in which the spheres are added to the
    /// list; may be empty: every ray then misses.
    pub spheres: Vec<(Point3, f64)>,
    /// The ray that is traced.
    pub ray: Ray,
    /// The lower end of the interval, excluded, in lengths of the ray's direction.
    pub t_min: f64,
    /// The upper end of the interval, excluded, in lengths of the ray's direction.
    pub t_max: f64,
}

/// A function that puts a world's spheres into a list and returns the `t` of the nearest hit, in
/// lengths of the ray's direction; `None` for a miss.
pub type ListSolver<'a> = dyn Fn(&World) -> Option<f64> + 'a;

/// Tests that `search`, a list's search for the nearest hit, returns the least `t` that `record`
/// finds for any sphere alone, in whatever order the spheres are added; `None` if all are missed or
/// there are none.
pub fn the_nearest_of_all_members_is_returned(
    record: &RecordSolver,
    search: &ListSolver,
    world: &World,
) -> LawResult {
    let alone = world.spheres.iter().filter_map(|&(center, radius)| {
        let (t_min, t_max) = (world.t_min, world.t_max);
        let case = Case::new(center, radius, world.ray);
        Some(record(&IntervalCase { case, t_min, t_max })?.t)
    });
    let (found, expected) = (search(world), alone.reduce(f64::min));
    BrokenLaw::unless(found == expected, || BrokenLaw {
        law: "of all that a ray hits, the nearest counts".into(),
        found: said(found),
        allowed: format!("{}, the least of the spheres' own answers", said(expected)),
        read: "chapter 5: closest_so_far".into(),
    })
}

impl World {
    /// Writes the body of a test that asks about this world again.
    pub(crate) fn as_test(&self) -> String {
        let sphere = |&(center, radius): &_| format!("({}, {radius:?})", vector(center));
        let spheres: Vec<String> = self.spheres.iter().map(sphere).collect();
        let spheres = spheres.join(",\n    ");
        let ray = code(&numbers_of_ray(self.ray));
        let [t_min, t_max] = [self.t_min, self.t_max].map(|end| code(&[end]));
        format!(
            "let spheres = vec![\n    {spheres},\n];\nlet ray = {ray};\n\
             let world = laws::list::World {{ spheres, ray, t_min: {t_min}, t_max: {t_max} }};\n\
             let law = laws::list::the_nearest_of_all_members_is_returned;\n\
             laws::holds(law(&record, &nearest, &world));"
        )
    }

    /// Lists the numbers of the world: origin and direction of the ray, `t_min`, `t_max`, and then
    /// center and radius of each sphere.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        let spheres = self.spheres.iter();
        let spheres = spheres.flat_map(|(center, radius)| [center.x, center.y, center.z, *radius]);
        let ray = numbers_of_ray(self.ray).into_iter();
        let ends = [self.t_min, self.t_max];
        ray.chain(ends).chain(spheres).collect()
    }

    /// Makes the world whose [`World::numbers`] these are; `None` if no world has so many.
    pub(crate) fn read(numbers: &[f64]) -> Option<Self> {
        let (&[x, y, z, dx, dy, dz, t_min, t_max], spheres) = numbers.split_first_chunk()?;
        let (spheres, []) = spheres.as_chunks() else {
            return None;
        };
        let sphere = |&[x, y, z, radius]: &[f64; 4]| (Point3::new(x, y, z), radius);
        Some(Self {
            spheres: spheres.iter().map(sphere).collect(),
            ray: ray_from(Point3::new(x, y, z), Vec3::new(dx, dy, dz)),
            t_min,
            t_max,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::tests::record;
    use crate::{Complaint, Trial};

    /// Returns the least answer of the spheres but for the first few: a wrong list.
    fn without(few: usize, world: &World) -> Option<f64> {
        let spheres = world.spheres.iter().skip(few);
        let cases = spheres.map(|&(center, radius)| Case::new(center, radius, world.ray));
        let World { t_min, t_max, .. } = *world;
        let hits = cases.filter_map(|case| record(&IntervalCase { case, t_min, t_max }));
        hits.map(|hit| hit.t).reduce(f64::min)
    }

    fn found_and_allowed(search: &ListSolver) -> Option<[String; 2]> {
        match Trial::default().list(&record, search) {
            Err(Complaint::Broken(report)) => Some([report.broken.found, report.broken.allowed]),
            outcome => outcome.map(|()| None).expect("all is written"),
        }
    }

    #[test]
    fn a_sphere_that_the_list_forgets_is_what_is_allowed() {
        assert_eq!(found_and_allowed(&|world| without(0, world)), None);
        let searches: [&ListSolver; 2] = [&|world| without(1, world), &|_| None];
        for search in searches {
            let [found, allowed] = found_and_allowed(search).expect("the law is broken");
            assert_eq!(found, "a miss");
            assert_eq!(allowed, "t = 1.0, the least of the spheres' own answers");
        }
    }
}
