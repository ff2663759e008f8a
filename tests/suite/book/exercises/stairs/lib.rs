//! The picture of chapter 5 by a list of spheres.

use common::rtweekend::*;

use super::hittable_list::HittableList;
use super::sphere::Sphere;

/// Returns the picture of the [`world()`], `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    let world = world();
    render(width, move |ray| ray_color(ray, &world))
}

/// Returns the scene: a small sphere, and below it a large one for the ground.
pub fn world() -> HittableList {
    let mut world = HittableList::default();
    world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5));
    world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));
    world
}

/// Returns the nearest hit's normal as a color, or the sky's color.
pub fn ray_color(ray: &Ray, world: &HittableList) -> Color {
    if let Some(record) = world.hit(ray, 0.0, f64::INFINITY) {
        return 0.5 * (record.normal + Vec3::ONE);
    }
    sky(ray)
}
