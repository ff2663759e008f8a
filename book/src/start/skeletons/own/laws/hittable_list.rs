//! Your prelude, sphere, record, list and `ray_color`, under the laws: `cargo test`

use std::cell::Cell;

use common::rtweekend as ours;
use laws::list::World;
use laws::prelude::Prelude;
use laws::record::Hit;
use laws::runner::succeed;
use laws::{Chapter, Trial};
use my_chapter::rtweekend::{Ray, Vec3};
use my_chapter::{HitRecord, Hittable, HittableList, Sphere};
use ours::Point3;

#[test]
fn prelude_sphere_record_list_and_ray_color_obey_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    succeed(trial.prelude(&|asked| asked.put_to(&prelude())));
    succeed(trial.nearest_in_range(&hit));
    succeed(trial.record(&record));
    succeed(trial.list(&nearest));
    succeed(trial.range(&range));
    succeed(trial.ray_color(&ray_color));
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

fn range(ray: &ours::Ray) -> Option<[f64; 2]> {
    let nothing = Nothing::default();
    my_chapter::ray_color(&own_ray(*ray), &nothing);
    nothing.asked.get()
}

/// Is never hit, and keeps the range that it was asked for.
#[derive(Default)]
struct Nothing {
    asked: Cell<Option<[f64; 2]>>,
}

impl Hittable for Nothing {
    fn hit(&self, _ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        self.asked.set(Some([t_min, t_max]));
        None
    }
}

fn ray_color(ray: &ours::Ray) -> ours::Color {
    our(my_chapter::ray_color(&own_ray(*ray), &my_chapter::world()))
}
