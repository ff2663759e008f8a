//! Your function, under the laws: `cargo test`

use common::rtweekend as theirs;
use my_red_sphere::{ray::Ray, vec3::Vec3};

#[test]
fn hit_sphere_obeys_the_laws() {
    laws::runner::decision(&hit_sphere);
}

fn hit_sphere(center: theirs::Point3, radius: f64, ray: &theirs::Ray) -> bool {
    let ray = Ray::new(own(ray.origin), own(ray.direction));
    my_red_sphere::hit_sphere(own(center), radius, &ray)
}

fn own(v: theirs::Vec3) -> Vec3 {
    Vec3::new(v.x, v.y, v.z)
}
