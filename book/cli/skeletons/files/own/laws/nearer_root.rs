//! Your prelude and your functions, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::prelude::Prelude;
use laws::{Chapter, Trial, all_succeed};
use my_chapter::rtweekend::{Ray, Vec3};

#[test]
fn hit_sphere_obeys_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([trial.nearer_root(&hit_sphere)]);
}

#[test]
fn ray_color_obeys_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([trial.ray_color(&ray_color)]);
}

fn hit_sphere(center: ours::Point3, radius: f64, ray: &ours::Ray) -> Option<f64> {
    my_chapter::hit_sphere(own(center), radius, &own_ray(*ray))
}

fn ray_color(ray: &ours::Ray) -> ours::Color {
    our(my_chapter::ray_color(&own_ray(*ray)))
}
