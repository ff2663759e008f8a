//! Error-free transformations: sums and products together with what rounding took
//! from them.
//!
//! The rounding error of +, − or × is itself an `f64`, and a few operations find
//! it: + by Knuth, × by fusing. A product needs to be above 1e-290 in size, or zero.

use common::rtweekend::*;

/// Returns a + b as a rounded sum and the error of rounding.
#[inline]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_seen = sum - a;
    let error = (a - (sum - b_seen)) + (b - b_seen);
    (sum, error)
}

/// Returns a + b as [`two_sum`] does, with fewer operations, for |a| ≥ |b| or a = 0.
#[inline]
pub(crate) fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Returns a × b as a rounded product and the error of rounding.
#[inline]
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

/// Returns c = |C − Q|² − r², off by no more than u·|c| + 64u²·(|C − Q|² + r²); the vector C − Q,
/// rounded; and the errors of rounding it.
#[inline(always)]
pub(crate) fn c_and_differences(center: Point3, radius: f64, origin: Point3) -> (f64, Vec3, Vec3) {
    let [mut oc, mut oc_error] = [[0.0; 3]; 2];
    let (r_squared, r_error) = two_product(radius, radius);
    let (mut sum, mut error) = (-r_squared, -r_error);
    for k in 0..3 {
        let (x, x_error) = two_sum(center[k], -origin[k]);
        let (square, square_error) = two_product(x, x);
        let sum_error;
        (sum, sum_error) = two_sum(sum, square);
        error += sum_error + (square_error + 2.0 * x * x_error);
        (oc[k], oc_error[k]) = (x, x_error);
    }
    (sum + error, oc.into(), oc_error.into())
}

/// Computes a·b − c·d, off by no more than 1.5 ulp (Kahan).
#[inline(always)]
pub(crate) fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = c * d;
    a.mul_add(b, -product) + (-c).mul_add(d, product)
}
