//! Each chapter's rays and intersection, under the laws that it is old enough for.
//!
//! The laws and their bounds are in the package `laws`, and so are the rays and spheres. No judge is
//! built here: the command that [`more`] prints asks it which known mistake it is.

use std::convert::identity;

use common::rtweekend::*;
use laws::camera::CameraPixel;
use laws::nearer_root::{Solver, obeys_every_law};
use laws::prelude::Prelude;
use laws::{Case, ChapterScene, IntervalCase, Outcome, Trial, functions_of_a_list, holds};

use crate::more;

mod obeys_its_laws {
    use super::*;

    #[test]
    fn gradient() {
        assert_lawful("gradient", |trial| {
            rays_are_lawful(trial)?;
            trial.ray_color(ChapterScene::Sky, &gradient::ray_color)
        });
    }

    #[test]
    fn red_sphere() {
        assert_lawful("red_sphere", |trial| {
            trial.decision(&red_sphere::hit_sphere)?;
            trial.ray_color(ChapterScene::Disc, &red_sphere::ray_color)
        });
    }

    #[test]
    fn normals() {
        assert_lawful("normals", |trial| {
            trial.nearer_root(&normals::hit_sphere)?;
            trial.ray_color(ChapterScene::Ball, &normals::ray_color)
        });
    }

    #[test]
    fn half_b_sphere() {
        assert_lawful("half_b_sphere", |trial| {
            trial.nearer_root(&half_b_sphere::hit_sphere)?;
            trial.ray_color(ChapterScene::Ball, &half_b_sphere::ray_color)
        });
    }

    #[test]
    fn hittable_list() {
        assert_lawful("hittable_list", |trial| {
            trial.set_face_normal(&set_face_normal)?;
            trial.record(&record)?;
            trial.list(&record, &nearest)?;
            trial.ray_color(ChapterScene::List, &ray_color)
        });
    }
}

functions_of_a_list!(hittable_list, Ray, identity, identity, identity);

/// Fails with the first law that is broken, and says where there is more to see.
fn assert_lawful(chapter: &str, attempt: impl Fn(&Trial) -> Outcome) {
    if let Err(complaint) = attempt(&Trial::default()) {
        panic!(
            "\n\nChapter `{chapter}` breaks a law.\n\n{complaint}\n\n{}",
            more(chapter)
        );
    }
}

/// Tries the small functions on which every later chapter stands, and the camera.
pub(crate) fn rays_are_lawful(trial: &Trial) -> Outcome {
    trial.prelude(&Prelude::of_common())?;
    trial.pixel_ray(&|pixel: &CameraPixel| Camera::new(pixel.width).ray(pixel.i, pixel.j))
}

/// Tries the cases of a file, each of which was once hard for some method.
#[test]
fn what_was_once_special_is_solved() {
    let on_the_line = |center, radius, ray: &Ray| {
        let case = Case::new(center, radius, *ray);
        record(&IntervalCase::unbounded(case)).map(|hit| hit.t)
    };
    let solvers: [&Solver; 3] = [
        &normals::hit_sphere,
        &half_b_sphere::hit_sphere,
        &on_the_line,
    ];
    let lines = include_str!("regressions.txt").lines();
    for line in lines.filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let numbers = line.split_whitespace().map(str::parse);
        let numbers: Vec<f64> = numbers.map(|number| number.expect("a number")).collect();
        let case = Case::from_numbers(numbers.try_into().expect("a case is ten numbers"));
        for solve in solvers {
            holds(obeys_every_law(solve, &case));
        }
    }
}
