mod hittable;
mod hittable_list;
mod sphere;

pub use hittable::{HitRecord, Hittable};
pub use hittable_list::HittableList;
pub use sphere::Sphere;

use common::rtweekend::*;

pub fn picture(width: u32) -> Picture {
    let world = world();
    render(width, move |ray| ray_color(ray, &world))
}

pub fn world() -> HittableList {
    let mut world = HittableList::default();
    world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5));
    world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));
    world
}

pub fn ray_color(ray: &Ray, world: &dyn Hittable) -> Color {
    if let Some(record) = world.hit(ray, 0.0, f64::INFINITY) {
        return 0.5 * (record.normal + Vec3::ONE);
    }
    sky(ray)
}
