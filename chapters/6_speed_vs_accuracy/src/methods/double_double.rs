//! Double-double arithmetic: a number as the sum of two `f64`.

use std::ops::{Add, Mul, Neg, Sub};

use common::rtweekend::*;

use super::error_free::{quick_two_sum, two_product, two_sum};

/// Finds the nearest root with `t_min` < `t` < `t_max` as `half_b_q` does, with some 106 binary
/// digits instead of 53; `t` is rounded at the end.
///
/// Cost: 1 √, 2 to 4 ÷, and about 400 + or ×, 15 of them fused. Error: at most 72u²·a·M in
/// D. Fails: by the decision from 10¹³ radii on, once in a million; at |d|·|oc| above 1e154 or
/// below 1e-140. Source: Dekker 1971; the error bounds of its operations: Joldes, Muller and
/// Popescu, *Tight and rigorous error bounds for basic building blocks of double-word arithmetic*,
/// 2017.
/// A radius < 0 counts by its size. NaN, ∞, a direction of 0 or an overflow: `None`.
pub fn double_double(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Option<f64> {
    let roots = DoubleQuadratic::new(center, radius, ray).roots()?;
    let root = roots
        .into_iter()
        .map(|(numerator, denominator)| numerator / denominator)
        .find(|root| root.is_above(t_min) && (-*root).is_above(-t_max))?;
    // A root in range may round to an end, which is not.
    Some(root.high).filter(|t| t_min < *t && *t < t_max)
}

/// The coefficients of a·t² − 2h·t + c = 0 with twice the digits, and D = h² − a·c.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DoubleQuadratic {
    pub(crate) a: DoubleDouble,
    pub(crate) h: DoubleDouble,
    pub(crate) c: DoubleDouble,
    pub(crate) discriminant: DoubleDouble,
}

impl DoubleQuadratic {
    /// Computes the coefficients for a ray and a sphere.
    pub(crate) fn new(center: Point3, radius: f64, ray: &Ray) -> Self {
        let d = ray.direction.to_array().map(DoubleDouble::from);
        let [x, y, z] = center.to_array();
        let [from_x, from_y, from_z] = ray.origin.to_array();
        let oc = [
            DoubleDouble::difference(x, from_x),
            DoubleDouble::difference(y, from_y),
            DoubleDouble::difference(z, from_z),
        ];
        let r = DoubleDouble::from(radius);
        let (a, h, c) = (dot(d, d), dot(d, oc), dot(oc, oc) - r * r);
        Self {
            a,
            h,
            c,
            discriminant: h * h - a * c,
        }
    }

    /// Returns both roots as numerator and denominator, the nearer one first, or `None` if there is
    /// none; each by the division that does not cancel, as in `half_b_q`.
    pub(crate) fn roots(&self) -> Option<[(DoubleDouble, DoubleDouble); 2]> {
        let Self {
            a,
            h,
            c,
            discriminant,
        } = *self;
        if discriminant.high.is_nan() || discriminant.high < 0.0 {
            return None;
        }
        let sqrtd = discriminant.sqrt();
        Some(if h.high > 0.0 {
            let q = h + sqrtd;
            [(c, q), (q, a)]
        } else {
            let q = h - sqrtd;
            // From the point of contact of a tangent both roots are 0.
            let other = if q.high == 0.0 { (q, a) } else { (c, q) };
            [(q, a), other]
        })
    }
}

/// A number as the unrounded sum of two `f64`, `high` + `low`; `high` is the sum, rounded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DoubleDouble {
    /// The sum, rounded.
    pub(crate) high: f64,
    /// The part of the sum that rounding takes away.
    low: f64,
}

impl DoubleDouble {
    /// Computes a − b, exactly.
    fn difference(a: f64, b: f64) -> Self {
        Self::from_pair(two_sum(a, -b))
    }

    /// Computes a + b, exactly, for |a| ≥ |b| or a = 0.
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        Self::from_pair(quick_two_sum(a, b))
    }

    /// Computes `self` × `power`, which has to be a power of two, exactly.
    pub(crate) fn times_power_of_two(self, power: f64) -> Self {
        Self::from_pair((self.high * power, self.low * power))
    }

    /// Returns true if the sum is greater than `x`.
    pub(crate) fn is_above(self, x: f64) -> bool {
        self.high > x || (self.high == x && self.low > 0.0)
    }

    /// Returns `self` − `x`, rounded; `x` may be infinite.
    pub(crate) fn minus(self, x: f64) -> f64 {
        (self.high - x) + self.low
    }

    /// Returns the square root, off by no more than 8u² of it: one step of Newton's method from the
    /// root that the processor finds.
    fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 {
            return Self::from(0.0);
        }
        let rest = self - Self::from_pair(two_product(root, root));
        Self::from_pair(quick_two_sum(root, rest.high / (2.0 * root)))
    }

    fn from_pair((high, low): (f64, f64)) -> Self {
        Self { high, low }
    }
}

impl From<f64> for DoubleDouble {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Adds: off by no more than 3u² of the sum, which may cancel.
    fn add(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let (high, rest) = quick_two_sum(high, high_error + low);
        Self::from_pair(quick_two_sum(high, rest + low_error))
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// Multiplies: off by no more than 7u² of the product.
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        let mixed = self.high * other.low + self.low * other.high;
        Self::from_pair(quick_two_sum(high, error + mixed))
    }
}

impl std::ops::Div for DoubleDouble {
    type Output = Self;

    /// Divides: off by no more than 20u² of the quotient.
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::from(first);
        Self::from_pair(quick_two_sum(first, rest.high / other.high))
    }
}

fn dot(u: [DoubleDouble; 3], v: [DoubleDouble; 3]) -> DoubleDouble {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}
