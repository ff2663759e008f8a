//! Tightness: how close a case comes to an error bound of chapter 6.
//!
//! A large error alone proves nothing: what counts is a wrong answer. So each bound has
//! a function that asks of a case the question about which a method would be wrong,
//! and says how small the constant in the code would have to be for that.

use std::cmp::Ordering;

use common::rtweekend::*;
use figures::records::Tightness;
use figures::table::Table;
use laws::oracle::{Exact, Root};
use laws::{Case, WithInterval};
use speed_vs_accuracy::{
    C_BAND, D_BAND, E_EXPONENT, R_BANDS, S_C_BAND, S_D_BAND, Sharper, Stage, T_BAND, W_BAND,
};
use speed_vs_accuracy::{pairs, refined, stage_of_hit};

/// A constant that a certified method relies on, and how to come close to it.
pub struct Bound {
    /// The letter of its proof, and what is wrong where it is too small.
    pub name: &'static str,
    /// What the code has.
    pub constant: f64,
    /// The least constant for which there is a proof.
    pub proved: f64,
    /// What the constants are counted in.
    pub unit: Unit,
    /// A case like this one, near the place where the bound matters.
    pub aim: fn(&Case) -> Case,
    /// How close the case comes; `None` where the bound is not asked.
    pub attempt: fn(&Case) -> Option<Attempt>,
}

/// What the constant of a bound is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// u = 2⁻⁵³, the largest relative error of one operation.
    Rounding,
    /// u²
    RoundingSquared,
    /// The bound that the code computes beside each number.
    OwnBound,
    /// It is a power of two.
    PowerOfTwo,
}

/// A question, and how close it comes to a wrong answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attempt {
    /// The case, and the range in which its answer could be wrong.
    pub asked: WithInterval,
    /// The answer would be wrong if the constant of the bound were below this…
    pub attained: f64,
    /// …and this is 0. Otherwise it says how far the exact answer is from another one.
    pub short: f64,
}

/// The bounds of all stages that round.
pub const BOUNDS: [Bound; 16] = [
    Bound {
        name: "C",
        constant: C_BAND,
        proved: 6.0 * U,
        unit: Unit::Rounding,
        aim: |case| near_the_surface(case, 0.0),
        attempt: turned_away_from_inside,
    },
    Bound {
        name: "D_miss",
        constant: D_BAND,
        proved: 20.1 * U,
        unit: Unit::Rounding,
        aim: |case| near_a_tangent(case, 0.0),
        attempt: false_miss,
    },
    Bound {
        name: "D_hit",
        constant: 2.0 * D_BAND,
        proved: 20.1 * U,
        unit: Unit::Rounding,
        aim: |case| near_a_tangent(case, 0.0),
        attempt: false_hit,
    },
    Bound {
        name: "T_q_over_a",
        constant: T_BAND,
        proved: 34.0 * U,
        unit: Unit::Rounding,
        aim: |case| near_a_tangent(case, 50.0 * U),
        attempt: |case| root_beyond_the_end(case, Quotient::QOverA),
    },
    Bound {
        name: "T_c_over_q",
        constant: T_BAND,
        proved: 34.0 * U,
        unit: Unit::Rounding,
        aim: |case| near_a_tangent(case, 50.0 * U),
        attempt: |case| root_beyond_the_end(case, Quotient::COverQ),
    },
    Bound {
        name: "R_D",
        constant: R_BANDS[0],
        proved: R_BANDS[0],
        unit: Unit::PowerOfTwo,
        aim: |case| near_a_tangent(case, 8e-8),
        attempt: |case| an_ulp_off(case, 0),
    },
    Bound {
        name: "R_t",
        constant: R_BANDS[1],
        proved: R_BANDS[1],
        unit: Unit::PowerOfTwo,
        aim: |case| near_the_surface(case, 8e-8),
        attempt: |case| an_ulp_off(case, 1),
    },
    Bound {
        name: "E_small",
        constant: LEAST,
        proved: LEAST,
        unit: Unit::PowerOfTwo,
        aim: |case| near_a_tangent(&scaled(case, -515), 0.0),
        attempt: underflow,
    },
    Bound {
        name: "E_large",
        constant: LEAST,
        proved: LEAST,
        unit: Unit::PowerOfTwo,
        aim: along_a_line_of_largest_numbers,
        attempt: overflow,
    },
    Bound {
        name: "S_c",
        constant: S_C_BAND,
        proved: 0.51,
        unit: Unit::OwnBound,
        aim: within_a_rounding_of_the_surface,
        attempt: sharply_turned_away_from_inside,
    },
    Bound {
        name: "S_D_miss",
        constant: 1.0,
        proved: 0.82,
        unit: Unit::OwnBound,
        aim: |case| near_a_tangent(case, 0.0),
        attempt: sharp_false_miss,
    },
    Bound {
        name: "S_D_hit",
        constant: S_D_BAND,
        proved: 0.82,
        unit: Unit::OwnBound,
        aim: |case| near_a_tangent(case, 0.0),
        attempt: sharp_false_hit,
    },
    Bound {
        name: "S_D_far",
        constant: S_D_BAND,
        proved: 0.82,
        unit: Unit::OwnBound,
        aim: near_a_tangent_of_a_far_dot,
        attempt: sharp_false_hit_of_a_far_dot,
    },
    Bound {
        name: "S_q_over_a",
        constant: 1.0,
        proved: 0.95,
        unit: Unit::OwnBound,
        aim: |case| near_a_tangent(case, 200.0 * U),
        attempt: |case| sharp_root_beyond_the_end(case, Quotient::QOverA),
    },
    Bound {
        name: "S_c_over_q",
        constant: 1.0,
        proved: 0.95,
        unit: Unit::OwnBound,
        aim: |case| near_a_tangent(case, 200.0 * U),
        attempt: |case| sharp_root_beyond_the_end(case, Quotient::COverQ),
    },
    Bound {
        name: "W",
        constant: W_BAND,
        proved: 34.0 * U * U,
        unit: Unit::RoundingSquared,
        aim: through_a_root_that_is_a_number,
        attempt: pair_beyond_the_end,
    },
];

const U: f64 = f64::EPSILON / 2.0;

/// The least a and M of ordinary size, 2⁻⁴⁵⁰; the largest are one over it.
const LEAST: f64 = f64::from_bits((1023 - E_EXPONENT) << 52);

/// The witnesses that were found, in the order of [`BOUNDS`].
pub fn recorded() -> Table<Tightness> {
    let file = include_str!("../../notes/measured/tightness.csv");
    Table::read(file).expect("the file is well-formed")
}

/// The case that is the witness of a row.
///
/// # Panics
/// If the row has not ten numbers.
pub fn witness(row: &Tightness) -> Case {
    let numbers = row.witness.split_whitespace();
    let numbers: Vec<f64> = numbers.flat_map(str::parse).collect();
    let numbers = numbers.try_into().expect("ten numbers are a case");
    Case::from_numbers(numbers)
}

impl Bound {
    /// What is recorded of the closest witness.
    pub fn row(&self, found: &Attempt) -> Tightness {
        let numbers = found.asked.case.numbers();
        Tightness {
            bound: self.name.to_owned(),
            unit: self.unit.name().to_owned(),
            constant: self.unit.counted(self.constant),
            proved: self.unit.counted(self.proved),
            attained: self.unit.counted(found.attained),
            exactly: found.attained,
            witness: numbers.map(|number| format!("{number:?}")).join(" "),
        }
    }
}

impl Unit {
    fn name(self) -> &'static str {
        match self {
            Self::Rounding => "u",
            Self::RoundingSquared => "u2",
            Self::OwnBound => "bound",
            Self::PowerOfTwo => "log2",
        }
    }

    /// The constant in this unit, with two decimals.
    fn counted(self, constant: f64) -> f64 {
        let counted = match self {
            Self::Rounding => constant / U,
            Self::RoundingSquared => constant / (U * U),
            Self::OwnBound => constant,
            Self::PowerOfTwo => constant.log2(),
        };
        (100.0 * counted).round() / 100.0
    }
}

impl Attempt {
    /// Whether the answer would be wrong with a smaller constant.
    pub fn is_witness(&self) -> bool {
        self.short == 0.0
    }

    /// What a search makes as large as it can.
    pub fn score(&self) -> f64 {
        // More than in proportion: it must not pay to be far from another answer.
        self.attained / (1.0 + self.short).powi(2)
    }
}

/// c < 0 though ĉ > 0: the ray does not turn towards the center, yet it hits.
fn turned_away_from_inside(case: &Case) -> Option<Attempt> {
    let case = match Rounded::of(case)? {
        rounded if rounded.h <= 0.0 => *case,
        _ => case.turned_round(),
    };
    let rounded = Rounded::of(&case)?;
    let exact = Exact::of(&case);
    Some(Attempt {
        asked: in_range(case, 0.0, f64::INFINITY),
        attained: rounded.c / rounded.m,
        short: beyond_zero(exact.origin_margin() / U, exact.origin_side().is_lt()),
    })
}

/// D ≥ 0 though D̂ < 0.
fn false_miss(case: &Case) -> Option<Attempt> {
    let rounded = Rounded::of(case)?;
    let exact = Exact::of(case);
    Some(Attempt {
        asked: anywhere_on(*case),
        attained: -rounded.discriminant / rounded.am,
        short: beyond_zero(
            exact.discriminant_margin() / U,
            exact.discriminant().is_ge(),
        ),
    })
}

/// D < 0 though D̂ > 0.
fn false_hit(case: &Case) -> Option<Attempt> {
    let rounded = Rounded::of(case)?;
    let exact = Exact::of(case);
    Some(Attempt {
        asked: anywhere_on(*case),
        attained: rounded.discriminant / rounded.am,
        short: beyond_zero(
            exact.discriminant_margin() / U,
            exact.discriminant().is_lt(),
        ),
    })
}

/// The root is not in the range that begins at `t_min`, but the rounded one is.
fn root_beyond_the_end(case: &Case, quotient: Quotient) -> Option<Attempt> {
    let gap = |case: &Case| {
        let rounded = Rounded::of(case).filter(Rounded::is_hit)?;
        let exact = Exact::of(case);
        let t = rounded.root(quotient);
        let t_min = not_below(rounded.exact_root(&exact, quotient)?);
        let attained = (t - t_min) * rounded.discriminant.sqrt() / rounded.m;
        (attained > 0.0).then_some(Attempt {
            asked: in_range(*case, t_min, f64::INFINITY),
            attained,
            short: 0.0,
        })
    };
    gap(case).or_else(|| gap(&case.turned_round()))
}

/// The refined root is more than one ulp off, where only band `which` forbids it.
fn an_ulp_off(case: &Case, which: usize) -> Option<Attempt> {
    let rounded = Rounded::of(case).filter(Rounded::is_hit)?;
    let exact = Exact::of(case);
    let sqrtd = rounded.discriminant.sqrt();
    let t = rounded.nearer_root();
    let bands = [
        rounded.discriminant / rounded.am,
        (t * sqrtd).abs() / rounded.m,
    ];
    if bands[1 - which] <= R_BANDS[1 - which] {
        return None;
    }
    let divisor = |t: f64| (rounded.a * t - rounded.h) - sqrtd;
    let Case {
        center,
        radius,
        ray,
    } = case;
    let t = refined(*center, *radius, ray, rounded.m, t, divisor);
    // Half an ulp is for the last rounding: only what is above it grows with the error.
    // It must be as much again; what it lacks is at least 0.1, so that 0 means a witness.
    let ulps = exact.nearer_root()?.error_in_ulps(t);
    let share = 2.0 * (ulps - 0.5);
    (share > 0.0).then(|| Attempt {
        asked: anywhere_on(*case),
        attained: bands[which],
        short: if ulps > 1.0 { 0.0 } else { 1.0 / share - 0.9 },
    })
}

/// D ≥ 0, but underflow makes D̂ so small that bound D takes it for a miss.
fn underflow(case: &Case) -> Option<Attempt> {
    let rounded = Rounded::of_any_size(case);
    let exact = Exact::of(case);
    let off = -rounded.discriminant / rounded.am;
    // At least 0.1, so that 0 means a witness.
    let too_little = (D_BAND / off - 1.0).max(0.0) + 0.1;
    let is_out = rounded.discriminant < -D_BAND * rounded.am;
    (off > 0.0).then(|| Attempt {
        asked: anywhere_on(*case),
        attained: rounded.size(),
        short: if is_out { 0.0 } else { too_little }
            + beyond_zero(
                exact.discriminant_margin() / U,
                exact.discriminant().is_ge(),
            ),
    })
}

/// h² is beyond the largest number and a·M is not: a root seems to be at 0.
fn overflow(case: &Case) -> Option<Attempt> {
    let rounded = Rounded::of_any_size(case);
    let is_wrong = rounded.discriminant == f64::INFINITY && rounded.am < f64::INFINITY;
    is_wrong.then(|| Attempt {
        asked: in_range(*case, f64::NEG_INFINITY, rounded.h / rounded.a / 2.0),
        attained: rounded.size(),
        short: 0.0,
    })
}

/// c < 0 though ĉ > 0 where c has 70 digits.
fn sharply_turned_away_from_inside(case: &Case) -> Option<Attempt> {
    let case = match Rounded::of(case)? {
        rounded if rounded.h <= 0.0 => *case,
        _ => case.turned_round(),
    };
    let (c, exact) = (sharper(&case).c, Exact::of(&case));
    let margin = exact.origin_margin() / f64::exp2(-73.0);
    left_by(Stage::Sharper, in_range(case, 0.0, f64::INFINITY)).map(|asked| Attempt {
        asked,
        attained: c.value / c.error,
        short: beyond_zero(margin, exact.origin_side().is_lt()),
    })
}

/// D ≥ 0 though D̂ < 0 where it comes from the cross product.
fn sharp_false_miss(case: &Case) -> Option<Attempt> {
    sharp_discriminant(case, -1.0, Ordering::is_ge)
}

/// D < 0 though D̂ > 0 where it comes from the cross product.
fn sharp_false_hit(case: &Case) -> Option<Attempt> {
    sharp_discriminant(case, 1.0, Ordering::is_lt)
}

/// The same, where d × oc is lost to rounding: then all that is left of the bound is the term
/// in u², and that in D̂ itself.
fn sharp_false_hit_of_a_far_dot(case: &Case) -> Option<Attempt> {
    let across = case.ray.direction.cross(case.center - case.ray.origin);
    sharp_false_hit(case).filter(|_| across == Vec3::ZERO)
}

fn sharp_discriminant(case: &Case, sign: f64, is_other: fn(Ordering) -> bool) -> Option<Attempt> {
    Rounded::of(case)?;
    let (discriminant, exact) = (sharper(case).discriminant, Exact::of(case));
    // In its own bounds: those of far spheres are much smaller than u·a·M.
    let bound = discriminant.error / (case.a() * case.m());
    let margin = exact.discriminant_margin() / bound;
    left_by(Stage::Sharper, anywhere_on(*case)).map(|asked| Attempt {
        asked,
        attained: sign * discriminant.value / discriminant.error,
        short: beyond_zero(margin, is_other(exact.discriminant())),
    })
}

/// As [`root_beyond_the_end`], for the root of the sharper stage.
fn sharp_root_beyond_the_end(case: &Case, quotient: Quotient) -> Option<Attempt> {
    let gap = |case: &Case| {
        let rounded = Rounded::of(case)?;
        let (numbers, exact) = (sharper(case), Exact::of(case));
        if numbers.discriminant.value <= S_D_BAND * numbers.discriminant.error {
            return None;
        }
        let which = usize::from(rounded.h.is_sign_positive() != (quotient == Quotient::COverQ));
        let root = numbers.roots().nth(which)?;
        let t_min = not_below([exact.nearer_root()?, exact.farther_root()?][which]);
        let attained = (root.t - t_min) * root.scale / root.error;
        let asked = left_by(Stage::Sharper, in_range(*case, t_min, f64::INFINITY))?;
        (attained > 0.0).then_some(Attempt {
            asked,
            attained,
            short: 0.0,
        })
    };
    gap(case).or_else(|| gap(&case.turned_round()))
}

/// As [`root_beyond_the_end`], for a root as a pair of numbers.
fn pair_beyond_the_end(case: &Case) -> Option<Attempt> {
    let gap = |case: Case, which: usize| {
        let exact = Exact::of(&case);
        let t_min = not_below([exact.nearer_root()?, exact.farther_root()?][which]);
        let root = pairs(case.center, case.radius, &case.ray)?.nth(which)?;
        let asked = left_by(Stage::FixedWidth, in_range(case, t_min, f64::INFINITY))?;
        let attained = root.minus(t_min) / root.high.abs();
        (attained > 0.0).then_some(Attempt {
            asked,
            attained,
            short: 0.0,
        })
    };
    [*case, case.turned_round()]
        .into_iter()
        .flat_map(|case| [gap(case, 0), gap(case, 1)])
        .flatten()
        .max_by(|a, b| a.attained.total_cmp(&b.attained))
}

/// The question, if this stage and those before it do not answer it.
fn left_by(stage: Stage, asked: WithInterval) -> Option<WithInterval> {
    let WithInterval { case, t_min, t_max } = asked;
    let answered = stage_of_hit(case.center, case.radius, &case.ray, t_min, t_max);
    (answered > stage).then_some(asked)
}

fn sharper(case: &Case) -> Sharper {
    Sharper::of(case.center, case.radius, &case.ray)
}

/// What the filter computes, rounded as it rounds.
struct Rounded {
    a: f64,
    h: f64,
    c: f64,
    m: f64,
    am: f64,
    discriminant: f64,
    q: f64,
}

/// How a root is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quotient {
    QOverA,
    COverQ,
}

impl Rounded {
    /// `None` if the filter leaves the case to later stages because of its exponents.
    fn of(case: &Case) -> Option<Self> {
        let rounded = Self::of_any_size(case);
        (rounded.size() >= LEAST).then_some(rounded)
    }

    fn of_any_size(case: &Case) -> Self {
        let oc = case.center - case.ray.origin;
        let (a, h) = (case.a(), case.ray.direction.dot(oc));
        let c = oc.length_squared() - case.radius * case.radius;
        let discriminant = h * h - a * c;
        Self {
            a,
            h,
            c,
            m: case.m(),
            am: a * case.m(),
            discriminant,
            q: h + discriminant.sqrt().copysign(h),
        }
    }

    /// The least of a, M, 1/a and 1/M.
    fn size(&self) -> f64 {
        let (a, m) = (self.a, self.m);
        a.min(m).min(1.0 / a).min(1.0 / m)
    }

    fn is_hit(&self) -> bool {
        self.discriminant > 2.0 * D_BAND * self.am
    }

    fn root(&self, quotient: Quotient) -> f64 {
        match quotient {
            Quotient::QOverA => self.q / self.a,
            Quotient::COverQ => self.c / self.q,
        }
    }

    fn nearer_root(&self) -> f64 {
        let is_positive = self.q > 0.0;
        self.root(if is_positive {
            Quotient::COverQ
        } else {
            Quotient::QOverA
        })
    }

    fn exact_root<'a>(&self, exact: &'a Exact, quotient: Quotient) -> Option<Root<'a>> {
        if (self.q > 0.0) == (quotient == Quotient::COverQ) {
            exact.nearer_root()
        } else {
            exact.farther_root()
        }
    }
}

/// 0 where the exact answer `is_other` than that of the filter, else how far it is from
/// that, where `margin` is 0.
fn beyond_zero(margin: f64, is_other: bool) -> f64 {
    if is_other {
        0.0
    } else {
        margin.abs().max(f64::MIN_POSITIVE)
    }
}

/// The least `f64` that is not below the root.
fn not_below(root: Root) -> f64 {
    let rounded = root.rounded();
    if root > rounded {
        rounded.next_up()
    } else {
        rounded
    }
}

fn in_range(case: Case, t_min: f64, t_max: f64) -> WithInterval {
    WithInterval { case, t_min, t_max }
}

fn anywhere_on(case: Case) -> WithInterval {
    in_range(case, f64::NEG_INFINITY, f64::INFINITY)
}

/// The radius such that c is this `share` of M, but for rounding.
fn near_the_surface(case: &Case, share: f64) -> Case {
    let distance = (case.center - case.ray.origin).length();
    let radius = distance * ((1.0 - share) / (1.0 + share)).sqrt();
    Case { radius, ..*case }
}

/// The ray aimed at the center, but for rounding, and the radius such that it is a tangent.
fn near_a_tangent_of_a_far_dot(case: &Case) -> Case {
    let Case { center, ray, .. } = *case;
    let mut dot = case.with_ray(ray.origin, center - ray.origin);
    dot.radius = 0.0;
    let margin = Exact::of_finite(&dot).map_or(0.0, |exact| exact.discriminant_margin());
    dot.radius = (-margin * dot.m()).sqrt();
    dot
}

/// The origin such that c is some u² of M: a short way to the side makes good for what
/// rounding took from the radius.
fn within_a_rounding_of_the_surface(case: &Case) -> Case {
    let mut case = *case;
    (case.center.y, case.ray.origin.y) = (0.0, 0.0);
    case = near_the_surface(&case, 0.0);
    case.radius *= 1.0 + 4.0 * U;
    let margin = Exact::of_finite(&case).map_or(0.0, |exact| exact.origin_margin());
    case.ray.origin.y = (-margin * case.m()).sqrt();
    case
}

/// A case with an `f64` for a root: C = t·d and Q = −k·(1, 2, 2) for r = 3k, all so short
/// that nothing rounds.
fn through_a_root_that_is_a_number(case: &Case) -> Case {
    let d = case.ray.direction.map(|x| first_digits(x, 27));
    let t = first_digits(case.center.x / d.x, 26);
    let k = first_digits(case.radius / 3.0, 51);
    Case {
        center: t * d,
        radius: 3.0 * k,
        ray: Ray::new(-k * Vec3::new(1.0, 2.0, 2.0), d),
    }
}

fn first_digits(x: f64, digits: u32) -> f64 {
    let cut = 53 - digits;
    f64::from_bits(x.to_bits() >> cut << cut)
}

/// The radius such that D is this `share` of a·M, but for rounding.
fn near_a_tangent(case: &Case, share: f64) -> Case {
    let (d, oc) = (case.ray.direction, case.center - case.ray.origin);
    let passes_at = d.cross(oc).length_squared() / d.length_squared();
    let r_squared = (passes_at + share * oc.length_squared()) / (1.0 - share);
    Case {
        radius: r_squared.sqrt(),
        ..*case
    }
}

/// The case with a and M from 2^`exponent` to four times that.
fn scaled(case: &Case, exponent: i32) -> Case {
    let factor = |square: f64| {
        let wanted = (f64::from(exponent) - square.log2()) / 2.0;
        f64::exp2(wanted.ceil())
    };
    let (length, direction) = (factor(case.m()), factor(case.a()));
    Case {
        center: length * case.center,
        radius: length * case.radius,
        ray: Ray::new(length * case.ray.origin, direction * case.ray.direction),
    }
}

/// All on one line, with h = 2⁵¹² or next to it.
fn along_a_line_of_largest_numbers(case: &Case) -> Case {
    let mantissa = 1.0 + case.ray.direction.x.abs() % 1.0 / 1024.0;
    let d = f64::exp2(256.0) * mantissa;
    Case {
        center: Point3::new(f64::exp2(512.0) / d, 0.0, 0.0),
        radius: 1.0,
        ray: Ray::new(Point3::ZERO, Vec3::new(d, 0.0, 0.0)),
    }
}
