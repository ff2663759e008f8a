//! What it means to be hit.

use common::rtweekend::*;

use crate::many::HitMany;
use crate::sphere::Sphere;

/// Anything that a ray can hit: a sphere, or a list of such things.
///
/// `Send + Sync`, because threads look at one world together. Nobody changes it
/// while they do, so nothing needs to be counted or locked. `HitMany` comes with
/// `hit`: see many.rs, later.
pub trait Hittable: HitMany + Send + Sync {
    /// The nearest hit with `t_min` < `t` < `t_max`, if there is one.
    ///
    /// Both ends are left out, so a ray that starts on a surface does not hit it
    /// at `t` = 0. Where rounding turns that 0 into 1e-17, it still does.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit>;
}

/// Where a ray hits, and which sphere: all that it takes to find the nearest of
/// many.
///
/// The rest is worked out once, for the winner, by [`Hit::record`]. Whatever a
/// ray hits in this scene is a sphere in the end, so a hit names one; a scene
/// with other shapes would need something more general here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
    /// What the ray hits there.
    pub sphere: Sphere,
}

impl Hit {
    /// All there is to know about the hit that `ray` made.
    #[inline(always)]
    pub fn record(&self, ray: &Ray) -> HitRecord {
        let point = ray.at(self.t);
        let outward_normal = self.sphere.outward_normal(point);
        let mut record = HitRecord {
            t: self.t,
            point,
            normal: outward_normal,
            front_face: true,
        };
        record.set_face_normal(ray, outward_normal);
        record
    }
}

/// A hit in full, as coloring needs it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HitRecord {
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
    /// The point on the surface.
    pub point: Point3,
    /// The unit normal at that point, always against the ray.
    pub normal: Vec3,
    /// Whether the ray came from outside.
    pub front_face: bool,
}

impl HitRecord {
    /// Sets `front_face`, and `normal` to whichever of `outward_normal` and its
    /// opposite points against `ray`.
    ///
    /// `outward_normal` must have unit length. A ray that only grazes the
    /// surface, at a right angle to the normal, counts as coming from inside.
    #[inline(always)]
    pub fn set_face_normal(&mut self, ray: &Ray, outward_normal: Vec3) {
        self.front_face = ray.direction.dot(outward_normal) < 0.0;
        self.normal = if self.front_face {
            outward_normal
        } else {
            -outward_normal
        };
    }
}
