//! Strategies: numbers, vectors and spheres, of which rays and cases are made.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use common::rtweekend::*;
use proptest::prelude::*;

/// Makes numbers in the range, with all their digits. They shrink towards 0 if that is in the
/// range, and to whole eighths, which are short to write.
pub fn number(range: RangeInclusive<f64>) -> impl Strategy<Value = f64> {
    const DIGITS: f64 = (1_u64 << 50) as f64;
    let (low, high) = range.into_inner();
    let first = (8.0 * low).floor() as i32;
    let last = ((8.0 * high).ceil() as i32 - 1).max(first);
    (first..=last, 0..1_u64 << 50).prop_map(move |(eighths, digits)| {
        let number = (f64::from(eighths) + digits as f64 / DIGITS) / 8.0;
        number.clamp(low, high)
    })
}

/// Returns the direction, or (0, 0, −1) if it is zero and points nowhere.
pub fn ahead_if_zero(direction: Vec3) -> Vec3 {
    if direction == Vec3::ZERO {
        Vec3::NEG_Z
    } else {
        direction
    }
}

/// Makes vectors whose components are integers from −`max` to `max`, which must not be negative.
pub fn whole_vector(max: i32) -> impl Strategy<Value = Vec3> {
    let number = move || -max..=max;
    (number(), number(), number())
        .prop_map(|(x, y, z)| Vec3::new(f64::from(x), f64::from(y), f64::from(z)))
}

/// Makes spheres as pairs: a center with components from −9 to 9, and a radius from 0.01 to 100.
pub fn ordinary_sphere() -> impl Strategy<Value = (Point3, f64)> {
    let place = || number(-9.0..=9.0);
    (place(), place(), place(), number(-2.0..=2.0))
        .prop_map(|(x, y, z, exponent)| (Point3::new(x, y, z), 10f64.powf(exponent)))
}

/// Makes unit vectors in any direction, all equally likely.
pub fn unit() -> impl Strategy<Value = Vec3> {
    (number(-1.0..=1.0), number(0.0..=2.0)).prop_map(|(z, turn)| {
        let (sin, cos) = (turn * PI).sin_cos();
        let ring = (1.0 - z * z).sqrt();
        Vec3::new(ring * cos, ring * sin, z)
    })
}
