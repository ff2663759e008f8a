//! Your function, under the laws: `cargo test`

use common::rtweekend as theirs;
use my_chapter::{ray::Ray, vec3::Vec3};

#[test]
fn hit_sphere_obeys_the_laws() {
    laws::runner::nearer_root(&hit_sphere);
}

fn hit_sphere(center: theirs::Point3, radius: f64, ray: &theirs::Ray) -> Option<f64> {
    let ray = Ray::new(own(ray.origin), own(ray.direction));
    my_chapter::hit_sphere(own(center), radius, &ray)
}

fn own(v: theirs::Vec3) -> Vec3 {
    Vec3::new(v.x, v.y, v.z)
}
