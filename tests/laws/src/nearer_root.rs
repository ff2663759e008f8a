//! Laws for the nearer root: soundness, completeness and metamorphic relations of a
//! ray-sphere intersection.
//!
//! These laws are for a solver of the kind of `hit_sphere` in chapters 3 and 4, which
//! returns the *nearer root*: the lesser `t` with |P(t) − C|² = r², negative or not, or
//! `None` where the line misses. [`intervals`](crate::intervals) has those for a solver
//! with a range of `t`.
//!
//! # Where the bounds come from
//!
//! u = 2⁻⁵³ bounds the relative error of one operation. With oc = C − Q,
//! a = d·d, h = d·oc, c = oc·oc − r², D = h² − a·c and M = oc·oc + r², counting
//! roundings along the longest path to each number gives, up to terms in u²:
//!
//! * a: a product and two sums, |â − a| ≤ 3u·a.
//! * h: oc, a product and two sums, |ĥ − h| ≤ 4u·|d||oc| ≤ 4u·√(aM).
//! * c: oc twice, a product and two sums make 5u·oc·oc; r² makes 1u·r², and the
//!   difference 1u·M more: |ĉ − c| ≤ 6u·M.
//! * D: h² has 2·4u + 1u of a·oc·oc, and a·c has 6u + 3u + 1u of a·M. The last
//!   difference adds 1u·a·M, since |D| ≤ a·M: |D̂ − D| ≤ 20u·a·M. The terms in
//!   u² are far less than the 4u that round this up to [`BAND`]·a·M = 24u·a·M.
//!
//! Powers of two do not round, so the full formula with b = −2h has the same
//! bounds. They hold for a [`Case::is_well_scaled`].

use common::rtweekend::*;
use proptest::strategy::Strategy;

use crate::case::{Case, ray_from};
use crate::oracle::ExactCase;
use crate::question::{Question, telling_cases};
use crate::strategies::{any_case, in_front, integers, ordinary};
use crate::trial::LawSuite;
use crate::verdict::{BrokenLaw, LawResult};

/// A function like the chapters' `hit_sphere`: takes center, radius and ray, and returns the nearer
/// `t` at which the ray's line meets the sphere, in lengths of the direction, negative behind the
/// origin; `None` for a miss.
pub type Solver<'a> = dyn Fn(Point3, f64, &Ray) -> Option<f64> + 'a;

/// The unit roundoff u of an `f64`, 2⁻⁵³: the largest relative error of one rounded operation.
pub const U: f64 = f64::EPSILON / 2.0;

/// The half width of the band in which rounding may decide between hit and miss, for the
/// discriminant D = h² − a·c of an [`ExactCase`], relative to a·M with M
/// = |oc|² + r²: while |D| is above `BAND`·a·M, the computed D has the right sign.
pub const BAND: f64 = 24.0 * U;

/// All laws for the nearer root, those that teach most first.
const LAWS: [fn(&Solver, &Case) -> LawResult; 6] = [
    t_is_a_number,
    the_line_hits_exactly_when_there_is_a_root,
    the_point_lies_on_the_sphere,
    the_root_is_the_nearer_one_to_the_digits_that_remain,
    a_tangent_is_a_hit_and_its_root_is_exact,
    a_scene_in_another_unit_and_a_mirror_has_the_same_digits,
];

/// Tests all laws for the nearer root on the answer of `solve` for one ray and sphere, those that
/// teach most first. A function that only decides between hit and miss is put under them by
/// [`solver_of_decision`].
pub fn obeys_every_law(solve: &Solver, case: &Case) -> LawResult {
    LAWS.iter().try_for_each(|law| law(solve, case))
}

/// Lists the cases and laws for a nearer root: first spheres in front of the ray, then others, both
/// of whole numbers, which can be checked by hand, then ordinary cases, then those where only
/// rounding or an overflow shows a mistake.
pub(crate) fn suite<'a>(solve: &'a Solver<'a>) -> LawSuite<'a, Case> {
    LawSuite {
        of: "hit_sphere",
        kinds: vec![
            in_front().boxed(),
            integers().boxed(),
            ordinary().boxed(),
            any_case().boxed(),
        ],
        telling: telling_cases(&ordinary()),
        question: Question::Root,
        answer: Box::new(|case| case.solve(solve).into_iter().collect()),
        laws: LAWS
            .map(|law| Box::new(move |case: &Case| law(solve, case)) as _)
            .into(),
        test: &|case| {
            format!(
                "{case}\nlet case = laws::Case::new(center, radius, ray);\n\
                 laws::holds(laws::nearer_root::obeys_every_law(&hit_sphere, &case));"
            )
        },
    }
}

/// Writes the body of a test that asks a function that only decides about this case again.
pub(crate) fn decision_as_test(case: &Case) -> String {
    let is_hit = ExactCase::of(case).nearer_root().is_some();
    format!("{case}\nassert_eq!(hit_sphere(center, radius, &ray), {is_hit});")
}

/// Turns a function that only decides between hit and miss, as that of chapter 2, into a solver.
/// Where `decide` says hit, the solver returns the exact nearer root, rounded to an `f64`, or the
/// `t` closest to the center if the line misses; else `None`. The solver panics if a number of the
/// sphere or the ray is infinite or NaN.
pub fn solver_of_decision(
    decide: impl Fn(Point3, f64, &Ray) -> bool,
) -> impl Fn(Point3, f64, &Ray) -> Option<f64> {
    move |center, radius, ray| {
        let case = Case::new(center, radius, *ray);
        let exact = ExactCase::of(&case);
        let root = exact.nearer_root().map(|root| root.rounded());
        decide(center, radius, ray).then(|| root.unwrap_or(case.h() / case.a()))
    }
}

/// Tests that `t` is not NaN where nothing overflows. No comparison with NaN holds, so a NaN passes
/// every test that refuses a `t` for being too large or too small.
fn t_is_a_number(solve: &Solver, case: &Case) -> LawResult {
    let is_nan = case.solve(solve).is_some_and(f64::is_nan);
    BrokenLaw::unless(!is_nan || !case.is_well_scaled(), || BrokenLaw {
        law: "t is a number".into(),
        found: "t = NaN".into(),
        allowed: "a number, or a miss".into(),
        read: "chapter 2: a negative discriminant has no root".into(),
    })
}

/// Tests that a root is returned exactly where there is one, outside of the band in which rounding
/// may decide. Two-sided: a solver that always or never hits breaks this law.
fn the_line_hits_exactly_when_there_is_a_root(solve: &Solver, case: &Case) -> LawResult {
    let exact = ExactCase::of(case);
    let margin = exact.discriminant_margin();
    let is_silent = !case.is_well_scaled() || margin.abs() <= BAND;
    let found = case.solve(solve);
    if is_silent || found.is_some() == (margin > 0.0) {
        return Ok(());
    }
    let (found, allowed) = match found {
        Some(_) => ("a hit", "a miss: the discriminant is negative"),
        None => ("a miss", "a hit: the discriminant is positive"),
    };
    Err(BrokenLaw {
        law: "the line hits the sphere exactly when the discriminant is not negative".into(),
        found: found.into(),
        allowed: format!("{allowed}, by more than rounding changes"),
        read: "chapter 2, and equations (12) to (15) of the notes".into(),
    })
}

/// Formats a solver's answer for a report.
pub(crate) fn said(root: Option<f64>) -> String {
    root.map_or("a miss".to_owned(), |t| format!("t = {t:?}"))
}

/// Tests that the point P at the returned `t` lies at the distance r from the center C, up to
/// rounding. This law needs no oracle: it puts the root back into the equation.
///
/// The root is the exact root of an equation with slightly other coefficients: the error of D is
/// one of 24u·M in c, those of h and a are 16u·M and 12u·M since |t| ≤ 2√(M/a), the last roundings
/// of t another 24u·M. The check itself rounds by 13u·M. The sum is 89u·M; this law allows 96u·M.
pub fn the_point_lies_on_the_sphere(solve: &Solver, case: &Case) -> LawResult {
    let Some(t) = case.solve(solve) else {
        return Ok(());
    };
    let from_center = t * case.ray.direction - (case.center - case.ray.origin);
    let (squared, r_squared) = (from_center.length_squared(), case.radius * case.radius);
    let bound = 96.0 * U * case.m();
    let holds = (squared - r_squared).abs() <= bound || !case.is_well_scaled();
    BrokenLaw::unless(holds, || BrokenLaw {
        law: "the point at t lies on the sphere".into(),
        found: format!("|P(t) − C|² = {squared:?} at t = {t:?}"),
        allowed: format!("r² = {r_squared:?} ± {bound:.1e}, for rounding"),
        read: "equation (7) of the notes: it defines what a root is".into(),
    })
}

/// Tests that `t` is the nearer root, up to the error that its coefficients bring.
///
/// See [`root_bound`] for the bound. Where D is within twice the band, no digit of √D is certain,
/// and √(72u)·√(M/a) bounds its share of the error. Makes no claim about a miss.
fn the_root_is_the_nearer_one_to_the_digits_that_remain(solve: &Solver, case: &Case) -> LawResult {
    let exact = ExactCase::of(case);
    let (Some(t), Some(root)) = (case.solve(solve), exact.nearer_root()) else {
        return Ok(());
    };
    let bound = root_bound(case, exact.discriminant_margin());
    let holds = (t - root.rounded()).abs() <= bound || !case.is_well_scaled();
    BrokenLaw::unless(holds, || BrokenLaw {
        law: "t is the nearer root".into(),
        found: format!("t = {t:?}"),
        allowed: format!("{:?} ± {bound:.1e}", root.rounded()),
        read: "chapter 3, and equation (12) of the notes: the nearer root takes −√".into(),
    })
}

/// Returns how far rounding may take a computed `t` from the exact root (h ∓ √D)/a, in lengths of
/// the direction. `margin` is [D/(a·M)](crate::oracle::ExactCase::discriminant_margin) with M =
/// |oc|² + r²; at 2·[`BAND`] or below, no digit of √D counts as certain.
///
/// The error of D̂ changes √D by at most 24u·a·M/√D, that of h is 4u·√(aM), and the rounding of √D
/// at most u·√(aM). Divided by a, that is u·√(M/a)·(24/√margin + 5). The difference, the quotient,
/// a and the rounding of the exact root for comparison have 1 + 1 + 3 + 1 roundings of t itself,
/// and |t| ≤ 2√(M/a): 12 more. So u·√(M/a)·(24/√margin + 17), of which 17 becomes 18 here.
pub fn root_bound(case: &Case, margin: f64) -> f64 {
    let sqrt_part = if margin > 2.0 * BAND {
        24.0 * U / margin.sqrt()
    } else {
        (72.0 * U).sqrt()
    };
    case.t_scale() * (sqrt_part + 18.0 * U)
}

/// Tests that a ray which touches the sphere hits it, with the exact root. Makes no claim unless
/// every number is a small integer, so that no operation rounds.
pub(crate) fn a_tangent_is_a_hit_and_its_root_is_exact(solve: &Solver, case: &Case) -> LawResult {
    let Some(root) = exact_tangent(case) else {
        return Ok(());
    };
    let found = case.solve(solve);
    BrokenLaw::unless(found == Some(root), || BrokenLaw {
        law: "a tangent is a hit, and its root is exact where no operation rounds".into(),
        found: said(found),
        allowed: format!("a hit, at t = {root:?}"),
        read: "chapter 2: what happens at a discriminant of zero".into(),
    })
}

/// Returns the root of a case of small integers with D = 0 and a root that is an integer too;
/// `None` for any other case.
pub(crate) fn exact_tangent(case: &Case) -> Option<f64> {
    let is_small_integer = |number: &f64| number.fract() == 0.0 && number.abs() < 4096.0;
    let exact = ExactCase::of(case);
    let root = exact.nearer_root()?.rounded();
    let rounds_nowhere = case.numbers().iter().chain([&root]).all(is_small_integer);
    (rounds_nowhere && exact.discriminant().is_eq()).then_some(root)
}

/// Tests that lengths 8 times and directions 1/16 times as long make t 128 times as large, with
/// equal digits, because a power of two never rounds; and that turning the sign of every x changes
/// no bit of t. Makes no claim where h is 0: a formula may depend on the sign of that zero.
fn a_scene_in_another_unit_and_a_mirror_has_the_same_digits(
    solve: &Solver,
    case: &Case,
) -> LawResult {
    let mirror = Vec3::new(-1.0, 1.0, 1.0);
    let seen = Case {
        center: 8.0 * mirror * case.center,
        radius: 8.0 * case.radius,
        ray: ray_from(
            8.0 * mirror * case.ray.origin,
            mirror * case.ray.direction / 16.0,
        ),
    };
    let (found, expected) = (seen.solve(solve), case.solve(solve).map(|t| 128.0 * t));
    let is_silent = case.h() == 0.0 || !case.is_well_scaled() || !seen.is_well_scaled();
    // −0 and 0 are the same place on a ray, so == is what is meant here.
    BrokenLaw::unless(found == expected || is_silent, || BrokenLaw {
        law: "t scales with the scene, also in a mirror: lengths × 8 and directions ÷ 16 make it \
              t × 128"
            .into(),
        found: said(found),
        allowed: format!("{}, and no other bit", said(expected)),
        read: "chapter 4: multiplying by a power of two never rounds".into(),
    })
}
