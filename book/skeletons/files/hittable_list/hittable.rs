/// Anything that a ray can hit.
pub trait Hittable {
    /// The nearest hit with `t_min` < `t` < `t_max`, if there is one.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord>;
}

/// What there is to know about a hit.
#[derive(Clone, Copy, Debug, Default)]
pub struct HitRecord {
    /// The ray parameter.
    pub t: f64,
    /// The point on the surface.
    pub point: Point3,
    /// The unit normal at that point, always against the ray.
    pub normal: Vec3,
    /// Whether the ray came from outside.
    pub front_face: bool,
}

impl HitRecord {
    /// Sets `front_face`, and `normal` to whichever of `outward_normal`, which has
    /// unit length, and its opposite points against `ray`.
    pub fn set_face_normal(&mut self, ray: &Ray, outward_normal: Vec3) {
        todo!()
    }
}
