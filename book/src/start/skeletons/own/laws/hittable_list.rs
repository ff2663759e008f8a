//! Your prelude, your sphere, its record and your list, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::list::World;
use laws::prelude::Prelude;
use laws::record::Hit;
use my_hittable_list::rtweekend::{Ray, Vec3};
use my_hittable_list::{HitRecord, Hittable, HittableList, Sphere};
use ours::Point3;

#[test]
fn prelude_sphere_record_and_list_obey_the_laws() {
    laws::runner::prelude(&prelude());
    laws::runner::nearest_in_range(&hit);
    laws::runner::record(&record);
    laws::runner::list(&nearest);
}

fn hit(center: Point3, radius: f64, ray: &ours::Ray, t_min: f64, t_max: f64) -> Option<f64> {
    Some(record(center, radius, ray, t_min, t_max)?.t)
}

fn record(center: Point3, radius: f64, ray: &ours::Ray, t_min: f64, t_max: f64) -> Option<Hit> {
    let record = Sphere::new(own(center), radius).hit(&own_ray(*ray), t_min, t_max)?;
    let HitRecord { t, point, normal, front_face } = record;
    Some(Hit { t, point: our(point), normal: our(normal), front_face })
}

fn nearest(world: &World) -> Option<f64> {
    let mut list = HittableList::default();
    for &(center, radius) in &world.spheres {
        list.add(Sphere::new(own(center), radius));
    }
    Some(list.hit(&own_ray(world.ray), world.t_min, world.t_max)?.t)
}
