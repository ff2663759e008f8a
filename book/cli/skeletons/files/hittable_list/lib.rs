mod hittable;
mod hittable_list;
mod sphere;

pub use hittable::HitRecord;
pub use hittable_list::HittableList;
pub use sphere::Sphere;

use common::rtweekend::*;

/// Returns the picture of the [`world`], `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    let world = world();
    render(width, move |ray| ray_color(ray, &world))
}

/// Returns the scene: a small sphere, and below it a large one for the ground.
pub fn world() -> HittableList {
    let mut world = HittableList::default();
    world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5));
    world
}

/// Returns the nearest hit's normal as a color, or the sky's color.
pub fn ray_color(ray: &Ray, world: &HittableList) -> Color {
    todo!()
}
