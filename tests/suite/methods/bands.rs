//! A strategy for the edges of bands, where a filter may just answer or just not: random cases
//! never come there.
//!
//! Of an ordinary question one number is changed, until what the filter compares is equal to a
//! band: up to the last digit that makes a difference, and then up to three more.

use common::rtweekend::*;
use laws::strategies::{any_case, far, integers, near_the_surface, number, whole_vector};
use laws::{Case, IntervalCase};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use speed_vs_accuracy::bounds::{self, Bound, T_UNDIVIDED, U};

use crate::methods::hostile::{in_units, ulps_away};
use crate::methods::question;

/// A number that is compared with a band, in units of u = 2⁻⁵³ and of M = |oc|² + r².
#[derive(Clone, Copy, Debug)]
enum Compared {
    /// c, with u·M.
    C,
    /// D, with u·a·M.
    D,
    /// The distance of a root above `t_min`, times √D: with u·M.
    Above { is_nearer: bool },
    /// The distance of a root below `t_max`, times √D: with u·M.
    Below { is_nearer: bool },
}

use Compared::{Above, Below, C, D};

/// Makes questions at the edge of a band. One in eight is asked in units so small or so large that
/// it is at the edge of what is ordinary, too.
pub(crate) fn at_a_band() -> impl Strategy<Value = IntervalCase> {
    let is_nearer = any::<bool>();
    let at_an_end = prop_oneof![
        3 => is_nearer.prop_map(|is_nearer| Above { is_nearer }),
        2 => is_nearer.prop_map(|is_nearer| Below { is_nearer }),
    ];
    // A band, what is proven of it, any other; and the two for the last digits of t, which are
    // 2⁻¹⁶ and 2⁻¹⁵.
    let bands = |of: &[Bound], more: &[f64]| {
        let of = of.iter();
        let of = of.flat_map(|of| [of.by_hand, of.stated, of.band]);
        let tight: Vec<f64> = of.chain(more.iter().copied()).collect();
        let size = prop_oneof![4 => select(tight), 1 => number(0.0..=130.0)];
        (size, any::<bool>()).prop_map(|(size, is_below)| if is_below { -size } else { size })
    };
    let digits = f64::exp2(37.0);
    let band = prop_oneof![
        1 => (Just(C), bands(&[bounds::C], &[0.0])),
        1 => (Just(D), bands(&[bounds::D], &[0.0, 48.0, digits])),
        2 => (at_an_end, bands(&[bounds::T, T_UNDIVIDED], &[0.0, 8.0, 2.0 * digits])),
    ];
    let change = (0..12_usize, few_digits_or_many(), band, -3..=3);
    let any = (asked(), vec(change, 1..=2)).prop_map(|(asked, changes)| {
        changes
            .into_iter()
            .fold(asked, |asked, (place, to, compared, ulps)| {
                moved(asked, place, to, compared, ulps)
            })
    });
    let at_a_band = prop_oneof![3 => any, 1 => across_from_below()];
    (at_a_band, units()).prop_map(|(asked, units)| {
        let [length, direction] = units.map(f64::exp2);
        IntervalCase {
            case: in_units(&asked.case, length, direction),
            t_min: length / direction * asked.t_min,
            t_max: length / direction * asked.t_max,
        }
    })
}

/// From a little below the surface, and so nearly across that the nearer root is a band before
/// 0. The direction has a tiny component there, of which each last digit counts. A `t_min` that is
/// nearly 0 asks the same of the filter for any range.
fn across_from_below() -> impl Strategy<Value = IntervalCase> {
    let near = [bounds::T.stated, T_UNDIVIDED.stated, T_UNDIVIDED.band];
    let near = select(near.map(|band| -band).to_vec());
    let band = prop_oneof![1 => Just(-bounds::T.band), 1 => near];
    let radius = prop_oneof![number(0.5..=2.0), (2..=8).prop_map(|n| f64::from(n) / 4.0)];
    let t_min = select(vec![0.0, -0.0, 1e-300]);
    (radius, number(1.0..=2.0), t_min, band, -3..=3).prop_map(
        |(radius, times, t_min, band, ulps)| {
            let origin = radius * (1.0 + times * band * U) * Vec3::Y;
            let case = Case::new(Point3::ZERO, radius, Ray::new(origin, Vec3::X));
            let t_max = f64::INFINITY;
            let asked = IntervalCase { case, t_min, t_max };
            moved(asked, 8, -1e-6, (Above { is_nearer: true }, band), ulps)
        },
    )
}

/// Moves one number of the question towards another, until what is compared is equal to the band,
/// and then by so many ulps. Returns the question as it is if that cannot be.
fn moved(
    asked: IntervalCase,
    place: usize,
    to: f64,
    (what, band): (Compared, f64),
    ulps: i32,
) -> IntervalCase {
    let is_above = |x| compared(&with(asked, place, x), what) > band;
    let found = edge([get(&asked, place), to], is_above);
    found.map_or(asked, |x| with(asked, place, ulps_away(x, ulps)))
}

/// Most often from 0 on, and half of them to ∞.
fn asked() -> impl Strategy<Value = IntervalCase> {
    let cases = prop_oneof![
        any_case(),
        far(0.5..=4.0),
        near_the_surface(1.0..=8.0),
        integers(),
        along_axes(),
    ];
    let t_min = prop_oneof![3 => Just(0.0), 1 => number(-3.0..=3.0)];
    let t_max = prop_oneof![1 => Just(f64::INFINITY), 1 => number(0.5..=9.0)];
    (cases, t_min, t_max).prop_map(|(case, t_min, t_max)| IntervalCase { case, t_min, t_max })
}

/// Along one axis from the center, and in the direction of the same or another: most numbers are
/// 0, and may become tiny.
fn along_axes() -> impl Strategy<Value = Case> {
    let axis = || select(vec![Vec3::X, Vec3::NEG_Y, Vec3::Z]);
    (
        whole_vector(1),
        number(0.5..=2.0),
        axis(),
        number(-3.0..=3.0),
        axis(),
    )
        .prop_map(|(center, radius, way, away, direction)| {
            Case::new(center, radius, Ray::new(center + away * way, direction))
        })
}

fn few_digits_or_many() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-12..=12).prop_map(|x| f64::from(x) / 4.0),
        number(-3.0..=3.0),
        number(-1.0..=1.0).prop_map(|x| 1e-6 * x),
    ]
}

/// Makes powers of two for lengths and for directions.
fn units() -> impl Strategy<Value = [f64; 2]> {
    let exponent = || {
        select(vec![
            -530.0, -225.0, -129.0, -128.0, -127.0, 0.0, 127.0, 128.0, 129.0,
        ])
    };
    prop_oneof![7 => Just([0.0; 2]), 1 => [exponent(), exponent()]]
}

/// Returns the last number before the answer changes on the way from one number to the other;
/// `None` if the answer is the same at both.
fn edge([mut from, mut to]: [f64; 2], answer: impl Fn(f64) -> bool) -> Option<f64> {
    let first = answer(from);
    if !from.is_finite() || answer(to) == first {
        return None;
    }
    // A number that becomes 0 has a thousand exponents on its way.
    for _ in 0..128 {
        let middle = from + (to - from) / 2.0;
        if answer(middle) == first {
            from = middle;
        } else {
            to = middle;
        }
    }
    Some(from)
}

fn compared(asked: &IntervalCase, what: Compared) -> f64 {
    let IntervalCase { case, t_min, t_max } = asked;
    let (m, case) = (case.m(), question(case));
    let gap = |is_nearer, end: f64| {
        let sqrtd = case.discriminant().max(0.0).sqrt();
        let q = case.h() + sqrtd.copysign(case.h());
        let t = if is_nearer == (q > 0.0) {
            case.c() / q
        } else {
            q / case.a()
        };
        (t - end) * sqrtd / (U * m)
    };
    match what {
        C => case.c() / (U * m),
        D => case.discriminant() / (U * case.a() * m),
        Above { is_nearer } => gap(is_nearer, *t_min),
        Below { is_nearer } => -gap(is_nearer, *t_max),
    }
}

/// Returns the number at that place: ten of the case, and the ends of the range.
fn get(asked: &IntervalCase, place: usize) -> f64 {
    match place {
        10 => asked.t_min,
        11 => asked.t_max,
        _ => asked.case.numbers()[place],
    }
}

fn with(mut asked: IntervalCase, place: usize, number: f64) -> IntervalCase {
    match place {
        10 => asked.t_min = number,
        11 => asked.t_max = number,
        _ => {
            let mut numbers = asked.case.numbers();
            numbers[place] = number;
            asked.case = Case::from_numbers(numbers);
        }
    }
    asked
}
