//! The same again for eighty rays at once: three times as fast, and nothing
//! new. Skip it when you read this chapter for the first time.
//!
//! To ask a boxed thing for one hit is a virtual call, which ends what the
//! compiler can do with several rays together. So the question is asked once
//! for many rays: each thing has a [`HitMany::hit_many`] of its own, compiled
//! for it alone, that knows which `hit` it calls.

use std::sync::LazyLock;

use common::rtweekend::*;

use crate::hittable::{Hit, Hittable};
use crate::hittable_list::HittableList;
use crate::ray_color;
use crate::sphere::Sphere;

/// The nearest hits of many rays; `t` = ∞ where there is none.
pub type Hits = Many<Hit, 5>;

/// Pixels with the colors that [`ray_color`] returns for `rays`.
pub fn paint(rays: &Rays, world: &HittableList) -> Pixels {
    let mut nearest = NOTHING_HIT.clone();
    for object in world.objects() {
        object.hit_many(rays, &mut nearest);
    }
    // What was found stands for the world: each ray hits it as it did before.
    Pixels::paint(
        #[inline(always)]
        |k| ray_color(&rays.get(k), &nearest.get(k)),
    )
}

/// Where many rays begin. To copy it is faster than to write it for each block.
static NOTHING_HIT: LazyLock<Hits> = LazyLock::new(|| {
    Hits::repeat(Hit {
        t: f64::INFINITY,
        sphere: Sphere::new(Point3::ZERO, 0.0),
    })
});

/// Everything that can be hit by one ray can be hit by many.
pub trait HitMany {
    /// Replaces each of the hits in `nearest` by a nearer one on this thing, if
    /// there is one with `t` > 0.
    fn hit_many(&self, rays: &Rays, nearest: &mut Hits);
}

impl<T: Hittable> HitMany for T {
    fn hit_many(&self, rays: &Rays, nearest: &mut Hits) {
        nearest.update(
            #[inline(always)]
            |k, hit| self.hit(&rays.get(k), 0.0, hit.t).unwrap_or(hit),
        );
    }
}

/// A hit that was found, and no more: whoever looks again finds just that.
impl Hittable for Hit {
    #[inline(always)]
    fn hit(&self, _ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        (t_min < self.t && self.t < t_max).then_some(*self)
    }
}

impl From<Hit> for [f64; 5] {
    #[inline(always)]
    fn from(Hit { t, sphere }: Hit) -> Self {
        let [x, y, z] = sphere.center.to_array();
        [t, x, y, z, sphere.radius]
    }
}

impl From<[f64; 5]> for Hit {
    #[inline(always)]
    fn from([t, x, y, z, radius]: [f64; 5]) -> Self {
        let center = Point3::new(x, y, z);
        let sphere = Sphere { center, radius };
        Self { t, sphere }
    }
}
