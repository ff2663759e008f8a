//! All methods, each with what sets it apart from `half_b_q`.

use crate::method::{Discriminant, Method};
use crate::precision::Precision;
use crate::{certified, double_double, exact, interval, plain, single};

/// All methods, those in `f64` first.
pub const METHODS: &[Method] = &[
    Method::FULL_B,
    Method::HALF_B,
    Method::HALF_B_Q,
    Method::HAINES,
    Method::HAINES_Q,
    Method::KAHAN_Q,
    Method::CROSS_Q,
    Method::ADAPTIVE_Q,
    Method::SCALED_Q,
    Method::HERBIE,
    Method::INTERVAL_Q,
    Method::CERTIFIED_HIT,
    Method::CERTIFIED_T,
    Method::DOUBLE_DOUBLE,
    Method::EXACT,
    Method::HALF_B_F32,
    Method::HALF_B_Q_F32,
    Method::CROSS_Q_F32,
    Method::WIDENED_HALF_B_Q_F32,
    Method::CERTIFIED_F32,
];

/// The method of that name.
pub fn find(name: &str) -> Option<Method> {
    METHODS.iter().copied().find(|method| method.name == name)
}

impl Method {
    /// The method by which the others are measured: that of the chapters.
    pub const REFERENCE: Self = Self::HALF_B;

    /// The full formula of chapter 3.
    pub const FULL_B: Self = Self {
        root_cancels: true,
        ..Self::double("full_b", plain::full_b)
    };

    /// Half of b, as in chapter 5.
    pub const HALF_B: Self = Self {
        root_cancels: true,
        ..Self::double("half_b", plain::half_b)
    };

    /// The same discriminant, and roots that do not cancel.
    pub const HALF_B_Q: Self = Self::double("half_b_q", plain::half_b_q);

    /// The discriminant from the point that is nearest to the center.
    pub const HAINES: Self = Self {
        discriminant: Discriminant::Distance,
        root_cancels: true,
        ..Self::double("haines", plain::haines)
    };

    /// The same, and roots that do not cancel.
    pub const HAINES_Q: Self = Self {
        discriminant: Discriminant::Distance,
        ..Self::double("haines_q", plain::haines_q)
    };

    /// The difference h² − a·c, rounded once or twice only.
    pub const KAHAN_Q: Self = Self::double("kahan_q", plain::kahan_q);

    /// The distance of the line by a cross product.
    pub const CROSS_Q: Self = Self {
        discriminant: Discriminant::Distance,
        ..Self::double("cross_q", plain::cross_q)
    };

    /// The cross product far away, and near the surface a c with all its digits.
    pub const ADAPTIVE_Q: Self = Self {
        discriminant: Discriminant::Distance,
        c_cancels: false,
        ..Self::double("adaptive_q", plain::adaptive_q)
    };

    /// Exponents near 0 before anything else.
    pub const SCALED_Q: Self = Self {
        any_exponent: true,
        ..Self::double("scaled_q", plain::scaled_q)
    };

    /// What a program found that rewrites formulas.
    pub const HERBIE: Self = Self::double("herbie", plain::herbie);

    /// Bounds for each number; a hit only where they leave no doubt.
    pub const INTERVAL_Q: Self = Self {
        discriminant: Discriminant::Enclosed,
        ..Self::double("interval_q", interval::interval_q)
    };

    /// The decision is certain, the digits of t are those of `half_b_q`.
    pub const CERTIFIED_HIT: Self = Self {
        discriminant: Discriminant::Certain,
        any_exponent: true,
        is_certified: true,
        ..Self::double("certified_hit", certified::certified_hit)
    };

    /// The decision is certain, and so are the digits of t.
    pub const CERTIFIED_T: Self = Self {
        discriminant: Discriminant::Certain,
        c_cancels: false,
        any_exponent: true,
        is_certified: true,
        ..Self::double("certified_t", certified::certified_t)
    };

    /// Twice the digits.
    pub const DOUBLE_DOUBLE: Self = Self {
        digits: 2.0 * Precision::Double.digits(),
        ..Self::double("double_double", double_double::double_double)
    };

    /// Integers.
    pub const EXACT: Self = Self {
        discriminant: Discriminant::Certain,
        c_cancels: false,
        any_exponent: true,
        ..Self::double("exact", exact::exact)
    };

    /// Half of b in `f32`.
    pub const HALF_B_F32: Self = Self {
        root_cancels: true,
        ..Self::single("half_b_f32", single::half_b_f32)
    };

    /// The same discriminant, and roots that do not cancel, in `f32`.
    pub const HALF_B_Q_F32: Self = Self::single("half_b_q_f32", single::half_b_q_f32);

    /// The cross product in `f32`.
    pub const CROSS_Q_F32: Self = Self {
        discriminant: Discriminant::Distance,
        ..Self::single("cross_q_f32", single::cross_q_f32)
    };

    /// Input in `f32`, and all between in `f64`.
    pub const WIDENED_HALF_B_Q_F32: Self = Self {
        any_exponent: true,
        digits: Precision::Double.digits(),
        ..Self::single("widened_half_b_q_f32", single::widened_half_b_q_f32)
    };

    /// Input in `f32`; the decision is certain, and so is the last digit of t.
    pub const CERTIFIED_F32: Self = Self {
        discriminant: Discriminant::Certain,
        c_cancels: false,
        any_exponent: true,
        digits: Precision::Double.digits(),
        is_certified: true,
        ..Self::single("certified_f32", single::certified_f32)
    };
}
