//! A static filter: plain `f64` with an error bound that holds for all questions alike.
//!
//! The first stage. Each comparison is a step of the proof, whose letter stands beside it. Only
//! one thing is asked twice, whether the nearer root lies before `t_min`: `T_UNDIVIDED` says why
//! the two answers agree.

use super::refined::refined;
use crate::bounds::{T, T_UNDIVIDED, U};
use crate::workload::Case;

/// The width of the band around zero in which a sign is uncertain, in units of M: one for bounds
/// C, D and T.
const BAND: f64 = T.band * U;

/// The band for a root that is not divided yet.
const BEFORE_BAND: f64 = T_UNDIVIDED.band * U;

/// Bound R: where D̂ > 2⁻¹⁶·a·M and |t̂|·√D̂ > 2⁻¹⁵·M, the refined t is less than
/// 0.8 ulp off.
const R_BANDS: [f64; 2] = [1.0 / 65_536.0, 1.0 / 32_768.0];

/// The answer of a stage whose digits are too few to be certain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unclear;

/// Decides a case by the first stage: returns `t`, infinity for a certain miss, or NaN if it is not
/// certain. With `ULP`, `t` is within one ulp.
#[inline(always)]
pub(super) fn filter<const ULP: bool>(case: &Case, t_min: f64, t_max: f64) -> f64 {
    let has_numbers = t_min < t_max;
    let rounded = Rounded::of(case);
    if !has_numbers || rounded.is_missed(t_min) {
        return f64::INFINITY;
    }
    let root = if t_min == 0.0 {
        rounded.by_signs((t_max < f64::INFINITY).then_some(t_max))
    } else {
        rounded.by_gaps(t_min, t_max)
    };
    rounded.answer::<ULP>(case, root)
}

/// The coefficients of a·t² − 2h·t + c = 0, rounded, with M and D: all that the filter knows of a
/// case.
#[derive(Clone, Copy)]
struct Rounded {
    a: f64,
    h: f64,
    c: f64,
    m: f64,
    discriminant: f64,
    /// True if no number is so large or small that it could overflow or underflow (bound E).
    is_ordinary: bool,
}

/// The root that the filter chose for a range of t, or its decision for a miss.
#[derive(Clone, Copy)]
struct FilteredRoot {
    /// The root, or infinity for a miss.
    t: f64,
    /// True for the farther root, false for the nearer one.
    is_farther: bool,
    /// False if the choice may be wrong, so that a later stage has to decide.
    is_certain: bool,
}

impl Rounded {
    /// Computes the coefficients of a case.
    #[inline(always)]
    fn of(case: &Case) -> Self {
        let oc = case.center - case.ray.origin;
        let a = case.ray.direction.length_squared();
        let h = case.ray.direction.dot(oc);
        let (oc_squared, r_squared) = (oc.length_squared(), case.radius * case.radius);
        let (c, m) = (oc_squared - r_squared, oc_squared + r_squared);
        Self {
            a,
            h,
            c,
            m,
            discriminant: h * h - a * c,
            is_ordinary: are_ordinary(a, m),
        }
    }

    /// Returns true for a certain miss that needs no root: by bound D the line meets nothing, or by
    /// bound C the ray starts outside and does not turn towards the center.
    #[inline(always)]
    fn is_missed(&self, t_min: f64) -> bool {
        let band = BAND * self.m;
        let meets_nothing = self.discriminant < -(self.a * band);
        let turns_away = (self.h <= 0.0) & (self.c > band) & (t_min >= 0.0);
        self.is_ordinary & (meets_nothing | turns_away)
    }

    /// Chooses the root of a range from 0 on by signs alone: from inside the sphere it is the
    /// farther one, from outside the nearer one, or a miss if both are behind. `end` is the end of
    /// the range, if it has one. Step S of the proof, and step T for an end.
    #[inline(always)]
    fn by_signs(&self, end: Option<f64>) -> FilteredRoot {
        let Self { a, h, c, m, .. } = *self;
        let sqrtd = self.discriminant.sqrt();
        let q = h + sqrtd.copysign(h);
        let is_inside = c < 0.0;
        let by_q = is_inside & h.is_sign_positive();
        let (numerator, denominator) = if by_q { (q, a) } else { (c, q) };
        let t = numerator / denominator;
        let band = BAND * m;
        let (is_below, is_end_clear) = match end.map(|t_max| (t_max - t) * sqrtd) {
            Some(gap) => (gap > 0.0, is_far(gap, band)),
            None => (true, true),
        };
        FilteredRoot {
            t: if (t > 0.0) & is_below {
                t
            } else {
                f64::INFINITY
            },
            is_farther: is_inside,
            is_certain: self.is_clear() & (c.abs() > band) & is_end_clear,
        }
    }

    /// Chooses the root of any range: the nearer one, unless it lies before `t_min`. Both sides of
    /// that comparison are multiplied by its denominator, so that one division is enough. Step T of
    /// the proof.
    #[inline(always)]
    fn by_gaps(&self, t_min: f64, t_max: f64) -> FilteredRoot {
        let Self { a, h, c, m, .. } = *self;
        let sqrtd = self.discriminant.sqrt();
        let q = h + sqrtd.copysign(h);
        let c_is_nearer = h.is_sign_positive();
        let (numerator, denominator) = if c_is_nearer { (c, q) } else { (q, a) };
        let before = BEFORE_BAND * m * denominator;
        let is_farther = (numerator - t_min * denominator) * sqrtd <= -before;
        let takes_c = c_is_nearer ^ is_farther;
        let (numerator, denominator) = if takes_c { (c, q) } else { (q, a) };
        let t = numerator / denominator;
        let gap = lesser(t - t_min, t_max - t) * sqrtd;
        FilteredRoot {
            t: if gap > 0.0 { t } else { f64::INFINITY },
            is_farther,
            is_certain: self.is_clear() & is_far(gap, BAND * m),
        }
    }

    /// Returns true if there certainly are two roots, or certainly none. Step D of the proof.
    #[inline(always)]
    fn is_clear(&self) -> bool {
        (self.discriminant.abs() > self.a * (BAND * self.m)) & self.is_ordinary
    }

    /// Returns the t of a chosen root, refined if its last digit counts: infinity for a miss, NaN
    /// if the choice is not certain.
    #[inline(always)]
    fn answer<const ULP: bool>(&self, case: &Case, root: FilteredRoot) -> f64 {
        let (Self { a, h, m, .. }, t) = (*self, root.t);
        if !root.is_certain {
            return f64::NAN;
        }
        if !ULP | (t == f64::INFINITY) {
            return t;
        }
        let sqrtd = self.discriminant.sqrt();
        let has_digits =
            (self.discriminant > R_BANDS[0] * (a * m)) & ((t * sqrtd).abs() > R_BANDS[1] * m);
        if !has_digits {
            return f64::NAN;
        }
        let slope = if root.is_farther { sqrtd } else { -sqrtd };
        refined(case, m, t, |t| (a * t - h) + slope)
    }
}

/// Returns true if the `gap` between a root and an end of the range is certainly not zero. The gap
/// is NaN if there is no root, which is certain, too.
#[inline(always)]
fn is_far(gap: f64, band: f64) -> bool {
    let is_near = gap.abs() <= band;
    !is_near
}

/// Returns the lesser of two numbers, the first if one is NaN: a single instruction.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// Returns true if both are at least 2⁻²⁵⁶ and less than 2²⁵⁶. If a and M are, nothing overflows on
/// the way, and what underflow takes away is far below every bound here (bound E).
#[inline(always)]
fn are_ordinary(a: f64, m: f64) -> bool {
    const LEAST: u64 = (1023 - 256) << 52;
    // Both ends and NaN in one test: less LEAST, an exponent has 9 digits, and none above.
    const TOO_MANY: u64 = 7 << 61;
    let [a, m] = [a, m].map(|x| x.to_bits().wrapping_sub(LEAST));
    (a | m) & TOO_MANY == 0
}
