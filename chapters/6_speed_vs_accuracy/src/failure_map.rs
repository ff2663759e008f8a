//! A map of right and wrong decisions among rays that are as close to a tangent,
//! and to each other, as numbers can be.

use common::rtweekend::*;

use crate::case::{Case, Precision};
use crate::exact;
use crate::method::Method;

/// What a method decides about a square of neighboring rays.
#[derive(Clone, Debug, PartialEq)]
pub struct FailureMap {
    /// Rays in a row, and rows.
    pub size: usize,
    /// Row by row from above, whether the method says that the ray hits.
    pub hits: Vec<bool>,
    /// In the same order, whether that is wrong.
    pub wrong: Vec<bool>,
}

/// The decisions of `method` about `size` × `size` parallel rays, whose origins
/// are neighboring numbers in x and in y.
///
/// The ray from the middle touches the sphere exactly: its sides are those of a
/// triangle 3, 4, 5. Above the line through it, in the direction (4, 3), rays
/// hit, and below it they miss. Source of the idea: the maps of the predicates
/// of Shewchuk in georust/robust.
pub fn failure_map(method: &Method, size: usize) -> FailureMap {
    let middle = (size / 2) as f64;
    let (hits, wrong) = (0..size * size)
        .map(|n| {
            let (column, row) = ((n % size) as f64, (n / size) as f64);
            let question = near_tangent(Precision::of(method), column - middle, middle - row);
            let Case {
                center,
                radius,
                ray,
            } = question;
            let hit = question.put_to(method, 0.0, f64::INFINITY).is_some();
            let right = exact(center, radius, &ray, 0.0, f64::INFINITY).is_some();
            (hit, hit != right)
        })
        .unzip();
    FailureMap { size, hits, wrong }
}

/// A ray that starts so many numbers right of, and above, one that touches.
fn near_tangent(precision: Precision, right: f64, up: f64) -> Case {
    // Between 1 and 2 all numbers have the same distance.
    let step = match precision {
        Precision::Double => f64::EPSILON,
        Precision::Single => f64::from(f32::EPSILON),
    };
    let touching = Point3::new(1.5, 1.5, 1.5);
    let (along, across) = (Vec3::new(4.0, 3.0, 0.0), Vec3::new(-3.0, 4.0, 0.0));
    Case {
        center: touching + 3.0 * along + 2.0 * across,
        radius: 10.0,
        ray: Ray::new(touching + step * Vec3::new(right, up, 0.0), along),
    }
}
