mod hittable;
mod hittable_list;
mod sphere;

pub use hittable::{HitRecord, Hittable};
pub use hittable_list::HittableList;
pub use sphere::Sphere;

/// The picture at `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    let world = world();
    render(width, move |ray| ray_color(ray, &world))
}

/// What there is to see.
pub fn world() -> HittableList {
    let mut world = HittableList::default();
    world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5));
    world
}

// show ray_color
/// The normal of the nearest hit in front of the ray as a color, or the sky.
pub fn ray_color(ray: &Ray, world: &dyn Hittable) -> Color {
    todo!()
}
