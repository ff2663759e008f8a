//! Forward error analysis: how far rounding can take each number, in one table.
//!
//! The page of the proofs derives these bounds, and shows this table. The filter has its bands from
//! here, and tests compare the table with the page, with the scripts for Gappa, and with the laws
//! of the chapters.

/// The unit roundoff u, 2⁻⁵³: the largest relative error of one operation in `f64`.
pub const U: f64 = f64::EPSILON / 2.0;

/// A bound for the error of a computed number, and the band in which the code trusts no sign.
///
/// All four numbers count the same unit. A hand counts the roundings on the longest way to the
/// number. Gappa proves the same anew, and finds more: it does not see that oc·oc and r² add up
/// to M. The bound that is stated is a whole number above both, so it does not hang on how one
/// counts. The band is wider, for one constant is to hold C, D and T.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// The letter of the proof.
    pub letter: &'static str,
    /// What is bounded and the unit of the bound, as formulas of the page.
    pub formulas: [&'static str; 2],
    /// The count by hand.
    pub by_hand: f64,
    /// What Gappa proves, or `None` where it was not asked.
    pub by_gappa: Option<f64>,
    /// The bound.
    pub stated: f64,
    /// The width of the band around zero in which the code says that it does not know.
    pub band: f64,
}

/// Bound C: c tells on which side of the surface the ray starts.
pub const C: Bound = Bound {
    letter: "C",
    formulas: [r"\lvert\hat c - c\rvert", r"u\,M"],
    by_hand: 6.0,
    by_gappa: Some(7.5),
    stated: 8.0,
    band: 64.0,
};

/// Bound D: the discriminant tells hit from miss.
pub const D: Bound = Bound {
    letter: "D",
    formulas: [r"\lvert\hat D - D\rvert", r"u\,aM"],
    by_hand: 20.1,
    by_gappa: Some(23.5),
    stated: 24.0,
    band: 64.0,
};

/// Bound T: a root tells on which side of an end of the range it lies. D̂ is twice bound D or more.
pub const T: Bound = Bound {
    letter: "T",
    formulas: [r"\lvert\hat t - t\rvert\,w", r"u\,M"],
    by_hand: 28.3,
    by_gappa: Some(34.0),
    stated: 34.0,
    band: 64.0,
};

/// Bound T for a root that is not divided yet: `t_min` is multiplied instead. A root that is not
/// found out by this band is found, once divided, at most 55u·M before the range: so the two tests
/// never contradict each other.
pub const T_UNDIVIDED: Bound = Bound {
    letter: "T, undivided",
    formulas: [r"\lvert\hat t - t\rvert\,w", r"u\,M"],
    by_hand: 32.3,
    by_gappa: None,
    stated: 38.0,
    band: 48.0,
};

/// Bound W: a root that was computed with twice the digits, from integers.
pub const W: Bound = Bound {
    letter: "W",
    formulas: [r"\lvert\hat t - t\rvert", r"u^2\,t"],
    by_hand: 34.0,
    by_gappa: None,
    stated: 34.0,
    band: 64.0,
};

/// All bounds, in the order of their proofs.
pub const BOUNDS: [Bound; 5] = [C, D, T, T_UNDIVIDED, W];
