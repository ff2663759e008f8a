//! Interval arithmetic: two bounds in place of each number, between which it lies.
//!
//! Each operation finds the bounds of its result and moves both of them outwards, to the
//! next `f64`. So no rounding leaves the exact number outside. That is a filter without
//! an answer: it knows when it does not know.

use std::ops::{Add, Div, Mul, Sub};

use common::rtweekend::*;

use crate::method::{Discriminant, Method};

impl Method {
    /// Bounds for each number; a hit only where they leave no doubt.
    pub const INTERVAL_Q: Self = Self {
        discriminant: Discriminant::Enclosed,
        ..Self::double("interval_q", interval_q)
    };
}

/// D and both roots between bounds, as pbrt intersects a sphere: a hit needs a D that
/// cannot be negative, and a root that cannot lie outside the range.
///
/// Returns the middle of the bounds of that root. Where the nearer one may lie outside
/// the range and may not, it is the farther one.
///
/// Cost: 4 √, 12 ÷, of which misses pay 2 and 4, and two bounds to move after each
/// operation. Error: that of [`haines_q`](crate::haines_q), of which it has the
/// discriminant and the roots. Fails: by the decision, but never by a hit: spheres
/// shrink. It misses what it should hit 70 times in a million at 10¹¹ radii, and ten
/// times as often with each factor of ten; and nearly always where a ray leaves a surface
/// and should meet it again at once.
/// Source: Pharr, Jakob and Humphreys, *Physically Based Rendering*, 2023, §6.2.2 and
/// §6.8. Theirs is in `f32`, moves exact zeros too, and tries the farther root only if
/// the nearer one begins before the range.
#[inline]
pub fn interval_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let d = ray.direction.to_array();
    let (to, from) = (center.to_array(), ray.origin.to_array());
    let oc = [0, 1, 2].map(|k| Interval::from(to[k]) - Interval::from(from[k]));
    let r = Interval::from(radius);

    let a = length_squared(d.map(Interval::from));
    let h = oc[0].times(d[0]) + oc[1].times(d[1]) + oc[2].times(d[2]);
    let c = length_squared(oc) - r.squared();
    let middle = h / a;
    let across = [0, 1, 2].map(|k| oc[k] - middle.times(d[k]));
    let distance = length_squared(across).sqrt();
    let discriminant = a * (r + distance) * (r - distance);
    if discriminant.low < 0.0 {
        return None;
    }
    let is_inside = |t: &Interval| t_min < t.low && t.high < t_max;
    let mut roots = roots_by_q(a, h, c, discriminant).into_iter();
    roots.find(is_inside).map(Interval::middle)
}

/// As in [`half_b_q`](crate::half_b_q): the sum q cancels nothing, and the roots are c/q and q/a. In order
/// of their lower bounds.
#[inline]
fn roots_by_q(a: Interval, h: Interval, c: Interval, discriminant: Interval) -> [Interval; 2] {
    let sqrtd = discriminant.sqrt();
    let q = if h.middle() < 0.0 {
        h - sqrtd
    } else {
        h + sqrtd
    };
    let (one, other) = (q / a, c / q);
    if one.low <= other.low {
        [one, other]
    } else {
        [other, one]
    }
}

/// All numbers from `low` to `high`.
#[derive(Clone, Copy)]
struct Interval {
    low: f64,
    high: f64,
}

impl From<f64> for Interval {
    fn from(number: f64) -> Self {
        Self {
            low: number,
            high: number,
        }
    }
}

impl Interval {
    /// Where nothing is known.
    const ANYTHING: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };

    /// Between these two, which were rounded: the next number outwards is as far as that
    /// can have taken them. Nothing is known if one is NaN.
    #[inline]
    fn outwards(low: f64, high: f64) -> Self {
        if low <= high {
            Self {
                low: low.next_down(),
                high: high.next_up(),
            }
        } else {
            Self::ANYTHING
        }
    }

    /// The same for a sum, which never rounds to 0.
    #[inline]
    fn sum(low: f64, high: f64) -> Self {
        let moved = Self::outwards(low, high);
        Self {
            low: if low == 0.0 { 0.0 } else { moved.low },
            high: if high == 0.0 { 0.0 } else { moved.high },
        }
    }

    #[inline]
    fn times(self, number: f64) -> Self {
        let (one, other) = (self.low * number, self.high * number);
        if number > 0.0 {
            Self::outwards(one, other)
        } else {
            Self::outwards(other, one)
        }
    }

    /// The least and the largest of four.
    #[inline]
    fn around([a, b, c, d]: [f64; 4]) -> Self {
        Self::outwards(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }

    /// Tighter than a product with itself, because both factors are the same number.
    #[inline]
    fn squared(self) -> Self {
        let (low, high) = (self.low.abs(), self.high.abs());
        let least = if self.low < 0.0 && 0.0 < self.high {
            0.0
        } else {
            low.min(high)
        };
        let most = low.max(high);
        Self::outwards(least * least, most * most).not_below_zero()
    }

    /// Of what cannot be negative, although its lower bound may be.
    #[inline]
    fn sqrt(self) -> Self {
        Self::outwards(self.low.max(0.0).sqrt(), self.high.sqrt()).not_below_zero()
    }

    #[inline]
    fn not_below_zero(self) -> Self {
        Self {
            low: self.low.max(0.0),
            ..self
        }
    }

    #[inline]
    fn middle(self) -> f64 {
        self.low.midpoint(self.high)
    }
}

impl Add for Interval {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::sum(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::sum(self.low - other.high, self.high - other.low)
    }
}

impl Mul for Interval {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::around([
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ])
    }
}

impl Div for Interval {
    type Output = Self;

    /// By an interval with 0 in it, anything.
    #[inline]
    fn div(self, other: Self) -> Self {
        if other.low <= 0.0 && 0.0 <= other.high {
            return Self::ANYTHING;
        }
        Self::around([
            self.low / other.low,
            self.low / other.high,
            self.high / other.low,
            self.high / other.high,
        ])
    }
}

#[inline]
fn length_squared([x, y, z]: [Interval; 3]) -> Interval {
    x.squared() + y.squared() + z.squared()
}
