//! Your prelude and your function, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::prelude::Prelude;
use my_chapter::hit_sphere as own_hit_sphere;
use my_chapter::rtweekend::{Ray, Vec3};

#[test]
fn prelude_and_hit_sphere_obey_the_laws() {
    laws::runner::prelude(&prelude());
    laws::runner::nearer_root(&hit_sphere);
}

fn hit_sphere(center: ours::Point3, radius: f64, ray: &ours::Ray) -> Option<f64> {
    own_hit_sphere(own(center), radius, &own_ray(*ray))
}
