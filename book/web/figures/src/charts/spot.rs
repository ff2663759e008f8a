//! Coordinates of difficulty: where a question stands on the map, and which situation it is like.

use speed_vs_accuracy::{Case, Method, Precision};

/// A place on the map of rays and spheres, by exponents of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// n: the ray starts 10⁻ⁿ radii above the surface.
    Above(i32),
    /// n: the ray starts inside, 10⁻ⁿ radii below the surface.
    Inside(i32),
    /// k and n: the ray starts 10ᵏ radii from the surface, and its line passes the center at
    /// (1 ± 10⁻ⁿ) radii.
    Away(i32, i32),
}

/// The methods of the map. It leaves out `half_b`, whose decisions are those of `half_b_q`, and the
/// slowest.
pub const MAPPED: [Method; 7] = [
    Method::HALF_B_Q,
    Method::CROSS_Q,
    Method::COMPENSATED,
    Method::CERTIFIED_HIT,
    Method::CERTIFIED_T,
    Method::HALF_B_F32,
    Method::WIDENED_HALF_B_Q_F32,
];

/// How near to its surface a ray starts that counts as above or inside a sphere, in radii: the map
/// counts others as away.
const NEAR: f64 = 0.3;

impl Spot {
    /// Lists the spots of the map in `precision`: those where its numbers can still tell the rim or
    /// the surface.
    pub fn all(precision: Precision) -> impl Iterator<Item = Self> {
        let last = Self::last(precision);
        let near = (0..=last).flat_map(|n| [Self::Above(n), Self::Inside(n)]);
        let away = move |k| (0..=last.min(last + 1 - k)).map(move |n| Self::Away(k, n));
        near.chain((0..=last).flat_map(away))
    }

    /// Returns the greatest exponent of the map: the digits of a number.
    pub(super) fn last(precision: Precision) -> i32 {
        match precision {
            Precision::Double => 15,
            Precision::Single => 7,
        }
    }

    /// Returns the nearest spot to a question on the map of `f64`: by where its ray starts, and how
    /// near to the rim its line passes.
    pub fn of(case: &Case) -> Self {
        let oc = case.center - case.ray.origin;
        let height = oc.length() / case.radius - 1.0;
        let last = Self::last(Precision::Double);
        let exponent = |value: f64| {
            value
                .log10()
                .round()
                .clamp(f64::from(-last), f64::from(last)) as i32
        };
        match height {
            ..0.0 => Self::Inside(-exponent(-height)),
            ..NEAR => Self::Above(-exponent(height)),
            _ => {
                let passes = case.ray.direction.cross(oc).length() / case.ray.direction.length();
                let (k, rim) = (exponent(height).max(0), (passes / case.radius - 1.0).abs());
                Self::Away(k, (-exponent(rim)).clamp(0, last.min(last + 1 - k)))
            }
        }
    }

    /// Returns the name of the situation whose rays are like those of this spot.
    pub fn situation(self) -> &'static str {
        match self {
            Self::Above(..4) | Self::Away(..2, ..3) => "book",
            Self::Above(_) => "ground",
            Self::Inside(_) => "inside",
            Self::Away(..2, _) => "grazing",
            Self::Away(..) => "telescope",
        }
    }

    /// Returns the name of the spot's column in the file of the map.
    pub fn column(self) -> String {
        match self {
            Self::Above(_) => "above".to_owned(),
            Self::Inside(_) => "inside".to_owned(),
            Self::Away(k, _) => k.to_string(),
        }
    }

    /// Returns the exponent n of the spot's row.
    pub fn row(self) -> i32 {
        match self {
            Self::Above(n) | Self::Inside(n) | Self::Away(_, n) => n,
        }
    }
}
