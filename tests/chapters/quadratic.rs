//! Each chapter's rays and intersection, under the laws that it is old enough for.
//!
//! The laws and their bounds are in the package `laws`, and so are the rays and
//! spheres, and the mistakes that a report names.

use std::convert::identity;

use common::rtweekend::*;
use laws::camera::Pixel;
use laws::prelude::Prelude;
use laws::trial::{Outcome, one_case};
use laws::{Case, Chapter, Trial};

use crate::more;

pub(crate) mod gradient {
    use super::*;

    #[test]
    fn obeys_its_laws() {
        assert_lawful(Chapter::Gradient, |trial| {
            attempt(trial)?;
            trial.ray_color(&::gradient::ray_color)
        });
    }

    /// Every later chapter stands on these small functions.
    pub(crate) fn is_lawful() -> bool {
        attempt(&Trial::of(Chapter::Gradient)).is_ok()
    }

    fn attempt(trial: &Trial) -> Outcome {
        trial.prelude(&prelude())?;
        trial.pixel_ray(&|&Pixel {
                              width,
                              place: [i, j],
                          }| Camera::new(width).ray(i, j))
    }

    fn prelude() -> Prelude<'static> {
        Prelude {
            mul: &|t, v| t * v,
            add: &|u, v| u + v,
            neg: &|v| -v,
            sub: &|u, v| u - v,
            dot: &|u, v| u.dot(v),
            length_squared: &|v| v.length_squared(),
            length: &|v| v.length(),
            normalize: &|v| v.normalize(),
            ray: &|origin, direction| Ray::new(origin, direction),
            at: &|ray, t| ray.at(t),
        }
    }
}

mod red_sphere {
    use super::*;

    #[test]
    fn obeys_its_laws() {
        assert_lawful(Chapter::RedSphere, |trial| {
            trial.decision(&::red_sphere::hit_sphere)?;
            trial.ray_color(&::red_sphere::ray_color)
        });
    }
}

mod normals {
    use super::*;

    #[test]
    fn obeys_its_laws() {
        assert_lawful(Chapter::Normals, |trial| {
            trial.nearer_root(&::normals::hit_sphere)?;
            trial.ray_color(&::normals::ray_color)
        });
        solves_what_was_once_special(&::normals::hit_sphere);
    }
}

mod half_b_sphere {
    use super::*;

    #[test]
    fn obeys_its_laws() {
        assert_lawful(Chapter::HalfBSphere, |trial| {
            trial.nearer_root(&::half_b_sphere::hit_sphere)?;
            trial.ray_color(&::half_b_sphere::ray_color)
        });
        solves_what_was_once_special(&::half_b_sphere::hit_sphere);
    }
}

mod hittable_list {
    use super::*;
    use ::hittable_list;

    #[test]
    fn obeys_its_laws() {
        assert_lawful(Chapter::HittableList, |trial| {
            trial.nearest_in_range(&hit)?;
            trial.record(&record)?;
            trial.list(&nearest)?;
            trial.ray_color(&ray_color)
        });
        solves_what_was_once_special(&|center, radius, ray: &Ray| {
            hit(center, radius, ray, f64::NEG_INFINITY, f64::INFINITY)
        });
    }

    laws::functions_of_a_list!(hittable_list, Ray, identity, identity, identity);
}

/// Fails with the first law that is broken, and says where there is more to see.
fn assert_lawful(chapter: Chapter, attempt: impl Fn(&Trial) -> Outcome) {
    if let Err(report) = attempt(&Trial::of(chapter)) {
        panic!(
            "\n\nChapter `{}` breaks a law.\n\n{report}\n\n{}",
            chapter.name(),
            more(chapter.name())
        );
    }
}

/// The cases of a file, each of which was once hard for somebody.
fn solves_what_was_once_special(solve: &laws::nearer_root::Solver) {
    let lines = include_str!("regressions.txt").lines();
    for line in lines.filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let numbers = line.split_whitespace().map(str::parse);
        let numbers: Vec<f64> = numbers.map(|number| number.expect("a number")).collect();
        let case = Case::from_numbers(numbers.try_into().expect("a case is ten numbers"));
        one_case(solve, &case);
    }
}
