//! Many at once: the plain loop over arrays, which the compiler vectorizes.
//!
//! A loop over numbers that lie side by side becomes a loop over four, eight or
//! sixteen of them at a time, if each turn does the same. So a turn here has one
//! √ and one ÷ whatever comes out: it divides for the root that can be in range,
//! which signs tell beforehand. The rare block in which they do not tell
//! is done again by the method itself. So every answer is the method's, to the
//! bit.

use common::rtweekend::Ray;
use glam::{DVec3, Vec3};
use multiversion::multiversion;

use crate::single::SingleRay;

/// How many there are in a block.
pub const BLOCK: usize = 64;

/// Makes the batch of one precision: the same text, other numbers.
macro_rules! batch {
    ($module:ident, $float:ident, $bits:ident, $Vec:ident, $Ray:ident, $half_b:path, $half_b_q:path, $cross_q:path) => {
        /// Methods in this precision, sixty-four at a time.
        pub mod $module {
            use super::*;

            /// So many rays, spheres, or both, side by side.
            #[derive(Clone, Debug)]
            pub struct Block<const COLUMNS: usize>(pub [[$float; BLOCK]; COLUMNS]);

            /// Rays: the columns are origin and direction.
            pub type Rays = Block<6>;

            /// Spheres: the columns are center and radius.
            pub type Spheres = Block<4>;

            impl Rays {
                /// The rays `ray(0)`, `ray(1)` and so on.
                pub fn from_fn(ray: impl Fn(usize) -> $Ray) -> Self {
                    let mut block = Self([[0.0; BLOCK]; 6]);
                    for k in 0..BLOCK {
                        let ray = ray(k);
                        let (origin, direction) = (ray.origin, ray.direction);
                        let numbers = [
                            origin.x,
                            origin.y,
                            origin.z,
                            direction.x,
                            direction.y,
                            direction.z,
                        ];
                        for (column, number) in block.0.iter_mut().zip(numbers) {
                            column[k] = number;
                        }
                    }
                    block
                }

                #[inline(always)]
                fn get(&self, k: usize) -> $Ray {
                    let [ox, oy, oz, dx, dy, dz] = &self.0;
                    $Ray {
                        origin: $Vec::new(ox[k], oy[k], oz[k]),
                        direction: $Vec::new(dx[k], dy[k], dz[k]),
                    }
                }
            }

            impl Spheres {
                /// The spheres `sphere(0)`, `sphere(1)` and so on.
                pub fn from_fn(sphere: impl Fn(usize) -> ($Vec, $float)) -> Self {
                    let mut block = Self([[0.0; BLOCK]; 4]);
                    for k in 0..BLOCK {
                        let (center, radius) = sphere(k);
                        let numbers = [center.x, center.y, center.z, radius];
                        for (column, number) in block.0.iter_mut().zip(numbers) {
                            column[k] = number;
                        }
                    }
                    block
                }

                #[inline(always)]
                fn get(&self, k: usize) -> ($Vec, $float) {
                    let [x, y, z, radius] = &self.0;
                    ($Vec::new(x[k], y[k], z[k]), radius[k])
                }
            }

            /// Sets `ts` to the nearest root of each ray on one sphere, by
            /// `half_b`; ∞ for a miss.
            pub fn half_b(
                (center, radius): ($Vec, $float),
                rays: &[Rays],
                range: [$float; 2],
                ts: &mut [[$float; BLOCK]],
            ) {
                answer(
                    #[inline(always)]
                    |block, k| (center, radius, rays[block].get(k)),
                    half_b_fraction,
                    $half_b,
                    range,
                    ts,
                );
            }

            /// As [`half_b`], by `half_b_q`.
            pub fn half_b_q(
                (center, radius): ($Vec, $float),
                rays: &[Rays],
                range: [$float; 2],
                ts: &mut [[$float; BLOCK]],
            ) {
                answer(
                    #[inline(always)]
                    |block, k| (center, radius, rays[block].get(k)),
                    half_b_q_fraction,
                    $half_b_q,
                    range,
                    ts,
                );
            }

            /// As [`half_b`], by `cross_q`.
            pub fn cross_q(
                (center, radius): ($Vec, $float),
                rays: &[Rays],
                range: [$float; 2],
                ts: &mut [[$float; BLOCK]],
            ) {
                answer(
                    #[inline(always)]
                    |block, k| (center, radius, rays[block].get(k)),
                    cross_q_fraction,
                    $cross_q,
                    range,
                    ts,
                );
            }

            /// The nearest root of one ray on all spheres, by `half_b`; ∞ if it
            /// misses them.
            pub fn nearest(spheres: &[Spheres], ray: &$Ray, [t_min, t_max]: [$float; 2]) -> $float {
                let fraction = |block: usize, k| {
                    let (center, radius) = spheres[block].get(k);
                    half_b_fraction(center, radius, ray)
                };
                let sure = if t_min < 0.0 {
                    None
                } else {
                    least_root(fraction, spheres.len(), t_min, t_max)
                };
                sure.unwrap_or_else(|| {
                    let roots = spheres.iter().flat_map(|block| {
                        (0..BLOCK).filter_map(|k| {
                            let (center, radius) = block.get(k);
                            $half_b(center, radius, ray, t_min, t_max)
                        })
                    });
                    roots.fold($float::INFINITY, $float::min)
                })
            }

            /// What `method` answers to each question, found by `fraction`
            /// where that is sure to be the same.
            #[inline(always)]
            fn answer(
                question: impl Fn(usize, usize) -> ($Vec, $float, $Ray),
                fraction: impl Fn($Vec, $float, &$Ray) -> Fraction,
                method: impl Fn($Vec, $float, &$Ray, $float, $float) -> Option<$float>,
                [t_min, t_max]: [$float; 2],
                ts: &mut [[$float; BLOCK]],
            ) {
                if t_min < 0.0 {
                    // Signs say nothing about a range that begins behind the ray.
                    ts.iter_mut().for_each(|ts| ts[0] = OPEN);
                } else {
                    let fraction = |block, k| {
                        let (center, radius, ray) = question(block, k);
                        fraction(center, radius, &ray)
                    };
                    roots(fraction, t_min, t_max, ts);
                }
                for (block, ts) in ts.iter_mut().enumerate() {
                    if ts[0].is_nan() {
                        for (k, t) in ts.iter_mut().enumerate() {
                            let (center, radius, ray) = question(block, k);
                            *t = method(center, radius, &ray, t_min, t_max)
                                .unwrap_or($float::INFINITY);
                        }
                    }
                }
            }

            /// Stands first in a block that `method` has to do again.
            const OPEN: $float = $float::NAN;

            /// The root that comes first among those that can be positive.
            #[derive(Clone, Copy)]
            struct Fraction {
                numerator: $float,
                denominator: $float,
                /// There is a farther root, which is the answer if this one is
                /// not in range.
                nearer: bool,
            }

            #[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))]
            fn roots<F: Fn(usize, usize) -> Fraction>(
                fraction: F,
                t_min: $float,
                t_max: $float,
                ts: &mut [[$float; BLOCK]],
            ) {
                for (block, ts) in ts.iter_mut().enumerate() {
                    // As wide as the other numbers, so that they are compared together.
                    let mut open: $bits = 0;
                    for k in 0..BLOCK {
                        let Fraction {
                            numerator,
                            denominator,
                            nearer,
                        } = fraction(block, k);
                        let t = numerator / denominator;
                        // NaN, where there is no root, is not in range either.
                        let in_range = (t_min < t) & (t < t_max);
                        ts[k] = if in_range { t } else { $float::INFINITY };
                        open |= <$bits>::from(nearer & !in_range);
                    }
                    if open != 0 {
                        ts[0] = OPEN;
                    }
                }
            }

            /// The least root of all, or `None` if signs do not tell.
            #[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))]
            fn least_root<F: Fn(usize, usize) -> Fraction>(
                fraction: F,
                blocks: usize,
                t_min: $float,
                t_max: $float,
            ) -> Option<$float> {
                let mut least = [$float::INFINITY; BLOCK];
                let mut open: $bits = 0;
                for block in 0..blocks {
                    for k in 0..BLOCK {
                        let Fraction {
                            numerator,
                            denominator,
                            nearer,
                        } = fraction(block, k);
                        let t = numerator / denominator;
                        let in_range = (t_min < t) & (t < t_max);
                        least[k] = if in_range & (t < least[k]) {
                            t
                        } else {
                            least[k]
                        };
                        open |= <$bits>::from(nearer & !in_range);
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

            #[inline(always)]
            fn half_b_fraction(center: $Vec, radius: $float, ray: &$Ray) -> Fraction {
                let oc = center - ray.origin;
                let a = ray.direction.length_squared();
                let h = ray.direction.dot(oc);
                let c = oc.length_squared() - radius * radius;
                let sqrtd = (h * h - a * c).sqrt();
                let nearer = h - sqrtd > 0.0;
                Fraction {
                    numerator: if nearer { h - sqrtd } else { h + sqrtd },
                    denominator: a,
                    nearer,
                }
            }

            #[inline(always)]
            fn half_b_q_fraction(center: $Vec, radius: $float, ray: &$Ray) -> Fraction {
                let oc = center - ray.origin;
                let a = ray.direction.length_squared();
                let h = ray.direction.dot(oc);
                let c = oc.length_squared() - radius * radius;
                by_q(a, h, c, h * h - a * c)
            }

            #[inline(always)]
            fn cross_q_fraction(center: $Vec, radius: $float, ray: &$Ray) -> Fraction {
                let oc = center - ray.origin;
                let a = ray.direction.length_squared();
                let h = ray.direction.dot(oc);
                let r_squared = radius * radius;
                let discriminant = a * r_squared - ray.direction.cross(oc).length_squared();
                by_q(a, h, oc.length_squared() - r_squared, discriminant)
            }

            /// From outside, the nearer root is c/q; from inside, the farther
            /// one is q/a or c/q, whichever is positive.
            #[inline(always)]
            fn by_q(a: $float, h: $float, c: $float, discriminant: $float) -> Fraction {
                let q = h + discriminant.sqrt().copysign(h);
                let ahead = (q > 0.0) & (c <= 0.0);
                Fraction {
                    numerator: if ahead { q } else { c },
                    denominator: if ahead { a } else { q },
                    nearer: (q > 0.0) & (c > 0.0),
                }
            }
        }
    };
}

batch!(
    double,
    f64,
    u64,
    DVec3,
    Ray,
    crate::half_b,
    crate::half_b_q,
    crate::cross_q
);
batch!(
    single,
    f32,
    u32,
    Vec3,
    SingleRay,
    crate::half_b_f32,
    crate::half_b_q_f32,
    crate::cross_q_f32
);

macro_rules! divider_limit {
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
divider_limit!(in_double, f64);
divider_limit!(in_single, f32);

/// Takes √ of each of `roots` and 1 ÷ each of `quotients`, in place. None waits
/// for another: nothing with a √ and a ÷ can be faster on this processor.
pub fn divider_limit(roots: &mut [f64; BLOCK], quotients: &mut [f64; BLOCK]) {
    in_double(roots, quotients);
}

/// As [`divider_limit`], in `f32`.
pub fn divider_limit_f32(roots: &mut [f32; BLOCK], quotients: &mut [f32; BLOCK]) {
    in_single(roots, quotients);
}
