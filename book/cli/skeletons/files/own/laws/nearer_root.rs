//! Your prelude and your functions, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::prelude::Prelude;
use laws::{ChapterScene, Trial, holds};
use my_chapter::rtweekend::{Ray, Vec3};

#[test]
fn hit_sphere_obeys_the_laws() {
    holds(Trial::default().nearer_root(&hit_sphere));
}

#[test]
fn ray_color_obeys_the_laws() {
    holds(Trial::default().ray_color(ChapterScene::MyScene, &ray_color));
}

fn hit_sphere(center: ours::Point3, radius: f64, ray: &ours::Ray) -> Option<f64> {
    my_chapter::hit_sphere(own(center), radius, &own_ray(*ray))
}

fn ray_color(ray: &ours::Ray) -> ours::Color {
    our(my_chapter::ray_color(&own_ray(*ray)))
}
