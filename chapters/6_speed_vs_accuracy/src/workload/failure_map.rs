//! A map of right and wrong decisions among rays that are as close to a tangent,
//! and to each other, as numbers can be.

use common::rtweekend::*;

use super::case::Case;
use crate::method::Method;
use crate::precision::Precision;

/// What a method decides about a square of neighboring rays.
#[derive(Clone, Debug, PartialEq)]
pub struct FailureMap {
    /// Rays in a row, and rows.
    pub size: usize,
    /// Row by row from above, whether the ray hits.
    pub hits: Vec<bool>,
    /// In the same order, whether the method says the opposite.
    pub wrong: Vec<bool>,
}

/// The decisions of `method` about `size` × `size` parallel rays, whose origins
/// are neighboring numbers in x and in y. The ray in the middle is the last that
/// hits.
///
/// Source of the idea: the maps of the predicates of Shewchuk in georust/robust.
pub fn failure_map(method: &Method, size: usize) -> FailureMap {
    let precision = method.precision();
    let (tangent, middle) = (tangent(precision), (size / 2) as f64);
    let (hits, wrong) = (0..size * size)
        .map(|n| {
            let (column, row) = ((n % size) as f64, (n / size) as f64);
            let case = beside(&tangent, precision, column - middle, middle - row);
            let right = hits(&Method::EXACT, &case);
            (right, hits(method, &case) != right)
        })
        .unzip();
    FailureMap { size, hits, wrong }
}

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
        if hits(&Method::EXACT, &at(x)) {
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

/// Whether `method` says that the line of the case meets the sphere.
fn hits(method: &Method, case: &Case) -> bool {
    case.put_to(method, f64::NEG_INFINITY, f64::INFINITY)
        .is_some()
}
