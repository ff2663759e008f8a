//! Auto-vectorization over arrays: `half_b` for many rays, or many spheres, at once.
//!
//! A loop over numbers that lie side by side becomes a loop over four, eight or
//! sixteen of them at a time, if each turn does the same. So a turn here has one
//! √ and one ÷ whatever comes out: it divides for the root that can be in range,
//! which signs tell beforehand. The rare block in which they do not tell
//! is done again by `half_b` itself. So every answer is that of `half_b`, to the
//! bit.

use std::array;

use common::rtweekend::*;
use glam::Vec3 as SingleVec3;
use multiversion::multiversion;

use crate::plain;
use crate::single::{self, SingleRay};

/// How many there are in a block.
pub const BLOCK: usize = 64;

/// So many rays or spheres side by side: each column has one coordinate of all.
#[derive(Clone, Debug)]
// So that no eight of them lie across two lines of the cache.
#[repr(align(64))]
pub struct Block<Number, const COLUMNS: usize>([[Number; BLOCK]; COLUMNS]);

impl<Number: Copy, const COLUMNS: usize> Block<Number, COLUMNS> {
    /// The rows `row(0)`, `row(1)` and so on: the [`numbers`] of a ray, or center
    /// and radius of a sphere.
    pub fn from_fn(row: impl Fn(usize) -> [Number; COLUMNS]) -> Self {
        let rows: [_; BLOCK] = array::from_fn(row);
        Self(array::from_fn(|column| array::from_fn(|k| rows[k][column])))
    }

    #[inline(always)]
    fn row(&self, k: usize) -> [Number; COLUMNS] {
        array::from_fn(
            #[inline(always)]
            |column| self.0[column][k],
        )
    }
}

/// Origin and direction of a ray, as a row of a block.
pub fn numbers(ray: &Ray) -> [f64; 6] {
    let ([x, y, z], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
    [x, y, z, dx, dy, dz]
}

/// Makes `half_b` for many rays in one precision: the same text, other numbers.
macro_rules! half_b {
    ($half_b:ident, $one_by_one:path, $roots:ident, $first_ahead:ident, $float:ident, $bits:ident, $Vec:ident, $Ray:ident) => {
        /// Sets `ts` to the nearest root of each ray on one sphere; ∞ for a miss.
        pub fn $half_b(
            (center, radius): ($Vec, $float),
            rays: &[Block<$float, 6>],
            [t_min, t_max]: [$float; 2],
            ts: &mut [[$float; BLOCK]],
        ) {
            $roots((center, radius), rays, [t_min, t_max], ts);
            for (rays, ts) in rays.iter().zip(ts) {
                if ts[0].is_nan() {
                    *ts = array::from_fn(|k| {
                        let [x, y, z, dx, dy, dz] = rays.row(k);
                        let ray = $Ray {
                            origin: $Vec::new(x, y, z),
                            direction: $Vec::new(dx, dy, dz),
                        };
                        let root = $one_by_one(center, radius, &ray, t_min, t_max);
                        root.unwrap_or($float::INFINITY)
                    });
                }
            }
        }

        /// The same, save that NaN stands first in a block that is open: signs
        /// do not tell all of its roots.
        #[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))]
        fn $roots(
            (center, radius): ($Vec, $float),
            rays: &[Block<$float, 6>],
            [t_min, t_max]: [$float; 2],
            ts: &mut [[$float; BLOCK]],
        ) {
            for (rays, ts) in rays.iter().zip(ts) {
                // As wide as the other numbers, so that they are compared together.
                let mut open = <$bits>::from(t_min < 0.0);
                for k in 0..BLOCK {
                    let [x, y, z, dx, dy, dz] = rays.row(k);
                    let (origin, direction) = ($Vec::new(x, y, z), $Vec::new(dx, dy, dz));
                    let (t, is_nearer) = $first_ahead(center - origin, radius, direction);
                    // NaN, where there is no root, is not in range either.
                    let in_range = (t_min < t) & (t < t_max);
                    ts[k] = if in_range { t } else { $float::INFINITY };
                    open |= <$bits>::from(is_nearer & !in_range);
                }
                if open != 0 {
                    ts[0] = $float::NAN;
                }
            }
        }
    };
}

/// Makes what both need of one ray: all lanes of a processor do it at once.
macro_rules! first_ahead {
    ($first_ahead:ident, $float:ident, $Vec:ident) => {
        /// The root that comes first among those that can be positive, and
        /// whether it is the nearer one: if that is not in range, the farther
        /// one may be.
        #[inline(always)]
        fn $first_ahead(oc: $Vec, radius: $float, direction: $Vec) -> ($float, bool) {
            let a = direction.length_squared();
            let h = direction.dot(oc);
            let c = oc.length_squared() - radius * radius;
            let sqrtd = (h * h - a * c).sqrt();
            let is_nearer = h - sqrtd > 0.0;
            let numerator = if is_nearer { h - sqrtd } else { h + sqrtd };
            (numerator / a, is_nearer)
        }
    };
}

half_b!(
    half_b,
    plain::half_b,
    roots,
    first_ahead,
    f64,
    u64,
    Vec3,
    Ray
);
half_b!(
    half_b_f32,
    single::half_b_f32,
    roots_f32,
    first_ahead_f32,
    f32,
    u32,
    SingleVec3,
    SingleRay
);
first_ahead!(first_ahead, f64, Vec3);
first_ahead!(first_ahead_f32, f32, SingleVec3);

/// The nearest root of one ray on all spheres, by `half_b`; ∞ if it misses them.
pub fn nearest(spheres: &[Block<f64, 4>], ray: &Ray, [t_min, t_max]: [f64; 2]) -> f64 {
    least_root(spheres, ray, [t_min, t_max]).unwrap_or_else(|| {
        let rows = spheres
            .iter()
            .flat_map(|block| (0..BLOCK).map(|k| block.row(k)));
        let roots = rows.filter_map(|[x, y, z, radius]| {
            plain::half_b(Point3::new(x, y, z), radius, ray, t_min, t_max)
        });
        roots.fold(f64::INFINITY, f64::min)
    })
}

/// The least root of all, or `None` if signs do not tell.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))]
fn least_root(spheres: &[Block<f64, 4>], ray: &Ray, [t_min, t_max]: [f64; 2]) -> Option<f64> {
    let mut least = [f64::INFINITY; BLOCK];
    let mut open = u64::from(t_min < 0.0);
    for block in spheres {
        for (k, least) in least.iter_mut().enumerate() {
            let [x, y, z, radius] = block.row(k);
            let oc = Point3::new(x, y, z) - ray.origin;
            let (t, is_nearer) = first_ahead(oc, radius, ray.direction);
            let in_range = (t_min < t) & (t < t_max);
            let is_less = in_range & (t < *least);
            *least = if is_less { t } else { *least };
            open |= u64::from(is_nearer & !in_range);
        }
    }
    // The lesser of each pair, until one is left.
    let mut half = BLOCK / 2;
    while half > 0 {
        for k in 0..half {
            let (one, other) = (least[k], least[k + half]);
            least[k] = if other < one { other } else { one };
        }
        half /= 2;
    }
    (open == 0).then_some(least[0])
}

/// Takes √ of each of `roots` and 1 ÷ each of `quotients`, in place. None waits
/// for another: nothing with a √ and a ÷ can be faster on this processor.
pub fn divider_limit(roots: &mut [f64; BLOCK], quotients: &mut [f64; BLOCK]) {
    in_double(roots, quotients);
}

/// As [`divider_limit`], in `f32`.
pub fn divider_limit_f32(roots: &mut [f32; BLOCK], quotients: &mut [f32; BLOCK]) {
    in_single(roots, quotients);
}

macro_rules! in_all_lanes {
    ($name:ident, $float:ident) => {
        #[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))]
        fn $name(roots: &mut [$float; BLOCK], quotients: &mut [$float; BLOCK]) {
            for k in 0..BLOCK {
                roots[k] = roots[k].sqrt();
                quotients[k] = 1.0 / quotients[k];
            }
        }
    };
}
in_all_lanes!(in_double, f64);
in_all_lanes!(in_single, f32);
