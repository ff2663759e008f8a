//! Rays that are as close to a tangent, and to each other, as numbers can be.

use common::rtweekend::*;

use super::case::Case;
use crate::method::Method;
use crate::precision::Precision;

/// A ray that is as near to a tangent as numbers of that precision allow: the last that
/// hits, found by bisection. It comes slantwise, so that no product is exact.
pub fn tangent(precision: Precision) -> Case {
    let at = |x| Case {
        center: Point3::ZERO,
        radius: 0.5,
        ray: Ray::new(Point3::new(x, 0.75, -1.5), Vec3::new(-0.25, -0.375, 1.0)),
    };
    let (mut inside, mut outside) = (0.5, 1.0);
    // Each step gains a digit, and no precision here has more than 53.
    for _ in 0..53 {
        let x = 0.5 * (inside + outside);
        let hit = at(x).put_to(&Method::EXACT, f64::NEG_INFINITY, f64::INFINITY);
        if hit.is_some() {
            inside = x;
        } else {
            outside = x;
        }
    }
    match precision {
        Precision::Double => at(inside),
        Precision::Single => at(f64::from(inside as f32)),
    }
}

/// The tangent, moved by whole steps of its origin to the right and upwards.
///
/// A step is an ulp: between ½ and 1, where both coordinates lie, all neighbors are so
/// far apart.
pub fn beside(tangent: &Case, precision: Precision, right: f64, up: f64) -> Case {
    let Ray { origin, direction } = tangent.ray;
    let step = precision.epsilon() / 2.0;
    tangent.with_ray(origin + step * Vec3::new(right, up, 0.0), direction)
}
