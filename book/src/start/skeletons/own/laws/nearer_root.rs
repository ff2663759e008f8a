//! Your function, under the laws: `cargo test`

use common::rtweekend as theirs;
use my_chapter::{hit_sphere, ray::Ray, vec3::Vec3};

#[test]
fn hit_sphere_obeys_the_laws() {
    laws::runner::nearer_root(&|center, radius, ray: &theirs::Ray| {
        hit_sphere(own(center), radius, &Ray::new(own(ray.origin), own(ray.direction)))
    });
}

fn own(v: theirs::Vec3) -> Vec3 {
    Vec3::new(v.x, v.y, v.z)
}
