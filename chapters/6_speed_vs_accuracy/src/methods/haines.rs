//! The discriminant as a distance: r² less the square of how far the line passes from
//! the center. For small spheres far away.

use common::rtweekend::*;

use super::half_b_q::nearest_by_q;
use crate::method::{Discriminant, Method};

impl Method {
    /// The discriminant from the point that is nearest to the center.
    pub const HAINES: Self = Self {
        discriminant: Discriminant::Distance,
        root_cancels: true,
        ..Self::double("haines", haines)
    };

    /// The same, and roots that do not cancel.
    pub const HAINES_Q: Self = Self {
        discriminant: Discriminant::Distance,
        ..Self::double("haines_q", haines_q)
    };
}

/// The discriminant from the point of the line that is nearest to the center:
/// D/a is r² less the square of its distance.
///
/// Cost: 1 √, 1 ÷, both roots included; the ÷ is paid by misses too. Error of
/// D/a: u·(4l·|oc| + 8l² + 2r²) with l the distance. Fails: by the decision,
/// twice in a million from 10¹¹ radii away, and ten times as often with each factor
/// of ten; by the digits of t above a large sphere, where the root cancels and h/a
/// has been rounded: worse than `half_b` on the book's own ground. Source: Haines, Günther and Akenine-Möller, *Precision Improvements
/// for Ray/Sphere Intersection*, in Ray Tracing Gems, 2019; Hearn and Baker.
#[inline]
pub fn haines(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let per_a = 1.0 / ray.direction.length_squared();
    let middle = ray.direction.dot(oc) * per_a;
    let across = oc - middle * ray.direction;
    let discriminant_per_a = radius * radius - across.length_squared();
    if discriminant_per_a < 0.0 {
        return None;
    }
    let half_chord = (discriminant_per_a * per_a).sqrt();
    let in_range = |t: &f64| t_min < *t && *t < t_max;
    Some(middle - half_chord)
        .filter(in_range)
        .or_else(|| Some(middle + half_chord).filter(in_range))
}

/// The discriminant of [`haines`], the roots of [`half_b_q`](crate::half_b_q): what Ray Tracing
/// Gems recommends.
///
/// Cost: 1 √, 2 ÷, of which misses pay one. Error: that of `haines` in D, that
/// of c in a root near the origin. Fails: near the surface, where c has lost its
/// digits; on the book's ground its worst t is a hundred times worse than that
/// of `half_b_q`. Source: as `haines`.
#[inline]
pub fn haines_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let r_squared = radius * radius;
    let across = oc - (h / a) * ray.direction;
    let discriminant = a * (r_squared - across.length_squared());
    let c = oc.length_squared() - r_squared;
    nearest_by_q(a, h, c, discriminant, t_min, t_max)
}
