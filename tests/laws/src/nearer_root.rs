//! Laws for the nearer root: soundness, completeness and metamorphic relations of a
//! ray-sphere intersection.
//!
//! A law is a plain function: it takes a solver and a [`Case`], and says
//! whether the law holds. Most laws here are for a solver of the kind of
//! `hit_sphere` in chapters 3 and 4, which returns the *nearer root*: the
//! lesser `t` with |P(t) − C|² = r², negative or not, or `None` where the line
//! misses. [`intervals`](crate::intervals) has those for a solver with a range
//! of `t`.
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
use speed_vs_accuracy::Case;

use crate::oracle::Exact;
use crate::verdict::{Broken, Verdict};

/// A function of the kind of `hit_sphere`: center, radius and ray to nearer root.
pub type Solver<'a> = dyn Fn(Point3, f64, &Ray) -> Option<f64> + 'a;

/// A law for a nearer root.
pub type Law = fn(&Solver, &Case) -> Verdict;

/// A case of which only hit or miss matters, as in chapter 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decided(pub Case);

/// Half the distance from 1 to the next `f64`: the largest relative error of
/// one rounded operation.
pub const U: f64 = f64::EPSILON / 2.0;

/// As long as |D| is above this many times a·M, rounding can't change its sign.
pub const BAND: f64 = 24.0 * U;

/// What to do where no known mistake explains the answers.
pub(crate) const EQUATION: &str =
    "compare a, b and c with equations (13) to (15), letter by letter";

/// The laws for a function that only decides, as that of chapter 2.
pub const DECISION: [Law; 3] = [
    a_ray_aimed_at_the_sphere_hits_and_one_aimed_past_it_misses,
    the_line_hits_exactly_when_there_is_a_root,
    a_tangent_is_a_hit,
];

/// Every law for a nearer root, in the order in which they teach most.
pub const NEARER_ROOT: [Law; 11] = [
    a_ray_aimed_at_the_sphere_hits_and_one_aimed_past_it_misses,
    the_line_hits_exactly_when_there_is_a_root,
    the_point_lies_on_the_sphere,
    the_root_is_the_nearer_one_to_the_digits_that_remain,
    a_tangent_is_a_hit,
    the_root_of_a_tangent_is_exact,
    the_two_roots_add_and_multiply_to_the_coefficients,
    a_scene_in_another_unit_has_the_same_digits,
    a_scene_in_a_mirror_has_the_same_bits,
    a_scene_that_is_moved_has_almost_the_same_root,
    finite_input_never_gives_nan,
];

/// A ray built to hit hits, and one built to miss misses. This law needs no
/// oracle: it aims from the origin of the case.
///
/// With n at a right angle to oc, the line to C + k·r·n passes C at a distance
/// of k·r·|oc|/√(oc·oc + k²r²). At k = 0.9 that is less than r. At k = 1.2 and
/// from two radii away or more it is at least 1.03·r. Silent from nearer, and
/// from a million radii away, where rounding begins to see a part of that.
pub fn a_ray_aimed_at_the_sphere_hits_and_one_aimed_past_it_misses(
    solve: &Solver,
    case: &Case,
) -> Verdict {
    let oc = case.center - case.ray.origin;
    let radii_away = oc.length() / case.radius;
    if !case.is_well_scaled() || !(2.0..=1e6).contains(&radii_away) {
        return Ok(());
    }
    let sideways = case.radius * oc.normalize().any_orthonormal_vector();
    for (k, should_hit) in [(0.9, true), (1.2, false)] {
        let aimed = case.with_ray(case.ray.origin, oc + k * sideways);
        let found = aimed.solve(solve);
        if found.is_some() != should_hit {
            return Err(Broken {
                law: "a ray aimed at the sphere hits it, and one aimed past it misses",
                found: format!(
                    "{} for a ray in the direction {:?}",
                    named(!should_hit),
                    aimed.ray.direction
                ),
                allowed: format!(
                    "{}: it passes the center at {k} radii or a little less",
                    named(should_hit)
                ),
                usually: EQUATION,
                page: "chapter 2: what the discriminant says",
            });
        }
    }
    Ok(())
}

/// Outside the band where rounding may decide, `solve` returns a root exactly
/// where there is one. Two-sided: a solver that always or never hits breaks it.
pub fn the_line_hits_exactly_when_there_is_a_root(solve: &Solver, case: &Case) -> Verdict {
    let exact = Exact::of(case);
    let margin = exact.discriminant_margin();
    if !case.is_well_scaled() || margin.abs() <= BAND {
        return Ok(());
    }
    let found = case.solve(solve);
    if found.is_some() == (margin > 0.0) {
        return Ok(());
    }
    Err(Broken {
        law: "the line hits the sphere exactly when the discriminant is not negative",
        found: named(found.is_some()).to_owned(),
        allowed: format!(
            "{}: the exact discriminant is {margin:.3e} of a·M, rounding reaches {BAND:.1e}",
            named(margin > 0.0)
        ),
        usually: EQUATION,
        page: "chapter 2, and equations (12) to (15) of the notes",
    })
}

/// |P(t) − C| is r, up to rounding. This law needs no oracle: it puts the root
/// back into the equation.
///
/// The root is the exact root of an equation with slightly other coefficients:
/// the error of D is one of 24u·M in c, those of h and a are 16u·M and 12u·M
/// since |t| ≤ 2√(M/a), the last roundings of t another 24u·M. The check itself
/// rounds by 13u·M. Together 89, of which this law makes 96.
pub fn the_point_lies_on_the_sphere(solve: &Solver, case: &Case) -> Verdict {
    let Some(t) = case.solve(solve) else {
        return Ok(());
    };
    if !case.is_well_scaled() {
        return Ok(());
    }
    let from_center = t * case.ray.direction - (case.center - case.ray.origin);
    let (squared, r_squared) = (from_center.length_squared(), case.radius * case.radius);
    let bound = 96.0 * U * case.m();
    if (squared - r_squared).abs() <= bound {
        return Ok(());
    }
    Err(Broken {
        law: "the point at t lies on the sphere",
        found: format!("|P(t) − C|² = {squared:?} at t = {t:?}"),
        allowed: format!("r² = {r_squared:?} ± {bound:.1e}, which is 96u·M"),
        usually: EQUATION,
        page: "equation (7) of the notes: it defines what a root is",
    })
}

/// `t` is the nearer root, up to the error that its coefficients bring.
///
/// See [`root_bound`] for the bound. Where D is within twice the band, no digit
/// of √D is certain, and then √(72u)·√(M/a) bounds what it may be.
pub fn the_root_is_the_nearer_one_to_the_digits_that_remain(
    solve: &Solver,
    case: &Case,
) -> Verdict {
    let exact = Exact::of(case);
    let (Some(t), Some(root)) = (case.solve(solve), exact.nearer_root()) else {
        return Ok(());
    };
    if !case.is_well_scaled() {
        return Ok(());
    }
    let bound = root_bound(case, exact.discriminant_margin());
    if (t - root.rounded()).abs() <= bound {
        return Ok(());
    }
    Err(Broken {
        law: "t is the nearer root",
        found: format!("t = {t:?}, {:.1e} ulps away", root.error_in_ulps(t)),
        allowed: format!("{:?} ± {bound:.1e}", root.rounded()),
        usually: EQUATION,
        page: "chapter 3, and equation (12) of the notes: the nearer root takes −√",
    })
}

/// How far from the exact root (h ∓ √D)/a rounding may take `t`, where
/// `margin` is D/(a·M).
///
/// The error of D̂ changes √D by at most 24u·a·M/√D, that of h is 4u·√(aM), and
/// the rounding of √D at most u·√(aM). Divided by a, that is
/// u·√(M/a)·(24/√margin + 5). The difference, the quotient, a and the rounding
/// of the exact root for comparison have 1 + 1 + 3 + 1 roundings of t itself,
/// and |t| ≤ 2√(M/a): 12 more. So u·√(M/a)·(24/√margin + 17).
pub fn root_bound(case: &Case, margin: f64) -> f64 {
    let sqrt_part = if margin > 2.0 * BAND {
        24.0 * U / margin.sqrt()
    } else {
        (72.0 * U).sqrt()
    };
    case.t_scale() * (sqrt_part + 18.0 * U)
}

/// A ray that touches the sphere hits it. Says nothing unless every number is a
/// small integer, so that no operation rounds.
pub fn a_tangent_is_a_hit(solve: &Solver, case: &Case) -> Verdict {
    match (exact_tangent(case), case.solve(solve)) {
        (Some(root), None) => Err(Broken {
            law: "a tangent is a hit",
            found: "a miss".to_owned(),
            allowed: format!("a hit, at t = {root:?}"),
            usually: "`discriminant <= 0.0` where it should say `discriminant < 0.0`",
            page: "chapter 2: what happens at a discriminant of zero",
        }),
        _ => Ok(()),
    }
}

/// Where a ray touches the sphere and no operation rounds, the root is exact.
pub fn the_root_of_a_tangent_is_exact(solve: &Solver, case: &Case) -> Verdict {
    match (exact_tangent(case), case.solve(solve)) {
        (Some(root), Some(t)) if t != root => Err(Broken {
            law: "the root of a tangent is exact where no operation rounds",
            found: format!("t = {t:?}"),
            allowed: format!("t = {root:?}"),
            usually: EQUATION,
            page: "equation (12) of the notes: with D = 0 both roots are the same",
        }),
        _ => Ok(()),
    }
}

/// With the farther root from the ray turned round, t₁ + t₂ = 2h/a and
/// t₁·t₂ = c/a (Vieta).
///
/// The sum is off by twice [`root_bound`], the product by that times
/// |t₁| + |t₂| ≤ 4√(M/a). The check adds the few roundings of 2h/a and c/a.
pub fn the_two_roots_add_and_multiply_to_the_coefficients(solve: &Solver, case: &Case) -> Verdict {
    let margin = Exact::of(case).discriminant_margin();
    if !case.is_well_scaled() || margin <= 2.0 * BAND {
        return Ok(());
    }
    let (Some(nearer), Some(turned)) = (case.solve(solve), case.turned_round().solve(solve)) else {
        return Err(Broken {
            law: "the line of a ray has two roots, whichever way the ray points",
            found: "a hit one way and a miss the other".to_owned(),
            allowed: "two hits".to_owned(),
            usually: "the direction of the ray decides: the sign of h or of t is tested inside \
                      hit_sphere",
            page: "chapter 2: a line goes both ways",
        });
    };
    let farther = -turned;
    let oc = case.center - case.ray.origin;
    let sum = 2.0 * case.ray.direction.dot(oc) / case.a();
    let product = (oc.length_squared() - case.radius * case.radius) / case.a();

    let (scale, root) = (case.t_scale(), root_bound(case, margin));
    let sum_bound = 2.0 * root + 16.0 * U * scale;
    let product_bound = (4.0 * scale + root) * root + 16.0 * U * scale * scale;
    if (nearer + farther - sum).abs() <= sum_bound
        && (nearer * farther - product).abs() <= product_bound
    {
        return Ok(());
    }
    Err(Broken {
        law: "the two roots add up to 2h/a and multiply to c/a",
        found: format!(
            "t₁ = {nearer:?}, t₂ = {farther:?}: sum {:?}, product {:?}",
            nearer + farther,
            nearer * farther
        ),
        allowed: format!(
            "sum {sum:?} ± {sum_bound:.1e}, product {product:?} ± {product_bound:.1e}"
        ),
        usually: EQUATION,
        page: "equation (12) of the notes, with both signs",
    })
}

/// Lengths 8 times, and directions 1/16 times as long: t is 128 times as large,
/// with the same digits, because a power of two never rounds.
pub fn a_scene_in_another_unit_has_the_same_digits(solve: &Solver, case: &Case) -> Verdict {
    let scaled = Case {
        center: 8.0 * case.center,
        radius: 8.0 * case.radius,
        ray: Ray::new(8.0 * case.ray.origin, case.ray.direction / 16.0),
    };
    if !case.is_well_scaled() || !scaled.is_well_scaled() {
        return Ok(());
    }
    let (found, expected) = (scaled.solve(solve), case.solve(solve).map(|t| 128.0 * t));
    same_bits(
        found,
        expected,
        "t scales with the scene: lengths × 8 and directions ÷ 16 make it t × 128",
        "a number with a unit, such as 0.001, is compared with one without; or the radius is not \
         squared, or the direction is made a unit vector",
    )
}

/// Turning the sign of every x changes no bit of t.
pub fn a_scene_in_a_mirror_has_the_same_bits(solve: &Solver, case: &Case) -> Verdict {
    let mirror = |v: Vec3| Vec3::new(-v.x, v.y, v.z);
    let mirrored = Case {
        center: mirror(case.center),
        ..case.with_ray(mirror(case.ray.origin), mirror(case.ray.direction))
    };
    if !case.is_well_scaled() {
        return Ok(());
    }
    same_bits(
        mirrored.solve(solve),
        case.solve(solve),
        "a scene in a mirror has the same t",
        "a letter is swapped in a dot product, or an absolute value hides a sign",
    )
}

/// Moving ray and sphere together changes t only because C − Q rounds again.
///
/// Coordinates round to u·(|C + v| + |Q + v|), which moves the root by at most
/// r/√D times as much; the error of both roots comes on top. Near a tangent,
/// where even the square of that movement counts, this law is silent.
pub fn a_scene_that_is_moved_has_almost_the_same_root(solve: &Solver, case: &Case) -> Verdict {
    let by = case.m().sqrt() * Vec3::new(0.5, -0.75, 0.625);
    let moved = Case {
        center: case.center + by,
        ..case.with_ray(case.ray.origin + by, case.ray.direction)
    };
    let margin = Exact::of(case).discriminant_margin();
    let coordinates = [case.center, case.ray.origin, moved.center, moved.ray.origin];
    let shift = U * coordinates.iter().map(|point| point.length()).sum::<f64>();
    let relative_shift = shift / case.m().sqrt();
    if !case.is_well_scaled() || margin <= 1e-9 || relative_shift > 1e-3 * margin {
        return Ok(());
    }
    let (found, expected) = (moved.solve(solve), case.solve(solve));
    let bound =
        2.5 * root_bound(case, margin) + 2.0 * relative_shift / margin.sqrt() * case.t_scale();
    match (found, expected) {
        (Some(found), Some(expected)) if (found - expected).abs() <= bound => Ok(()),
        (None, None) => Ok(()),
        _ => Err(Broken {
            law: "only the way from the ray to the sphere counts, not where they are",
            found: format!("{found:?} after moving both by {by:?}"),
            allowed: format!("{expected:?} ± {bound:.1e}"),
            usually: "center and origin are not subtracted but added, or one of them is left out",
            page: "equation (9) of the notes: only C − Q occurs",
        }),
    }
}

/// Nothing that `solve` returns for finite and well-scaled input is NaN or
/// infinite.
pub fn finite_input_never_gives_nan(solve: &Solver, case: &Case) -> Verdict {
    match case.solve(solve) {
        Some(t) if case.is_well_scaled() && !t.is_finite() => Err(Broken {
            law: "finite numbers lead to a finite root",
            found: format!("t = {t:?}"),
            allowed: "a finite number".to_owned(),
            usually: "the root of a negative discriminant, or a division by zero",
            page: "chapter 2: no root without a test of the discriminant",
        }),
        _ => Ok(()),
    }
}

/// Chapters 3, 4 and 5 return the same root to the last bit. The factors 2 and 4
/// that half-b leaves out are powers of two: they never round.
pub fn two_chapters_agree_to_the_last_bit(
    later: &Solver,
    earlier: &Solver,
    case: &Case,
) -> Verdict {
    if !case.is_well_scaled() {
        return Ok(());
    }
    let (found, expected) = (case.solve(later), case.solve(earlier));
    same_bits(
        found,
        expected,
        "the full formula, half-b and the sphere of the list return the same t, to the last bit",
        "one of the two breaks other laws as well: start there. If not, both are right, but one \
         has another order of operations or a fused mul_add",
    )
}

/// `solve` and `other` decide alike: the same discriminant has the same sign.
pub fn it_hits_exactly_when_the_other_does(solve: &Solver, other: &Solver, case: &Case) -> Verdict {
    let (found, expected) = (case.solve(solve).is_some(), case.solve(other).is_some());
    if found == expected {
        return Ok(());
    }
    Err(Broken {
        law: "there is a hit exactly when there is a root",
        found: format!("hit: {found}"),
        allowed: format!("root: {expected}"),
        usually: EQUATION,
        page: "chapter 3: the same discriminant, with its roots",
    })
}

fn named(hit: bool) -> &'static str {
    if hit { "a hit" } else { "a miss" }
}

/// The root of a case of small integers with D = 0 and a root that is an
/// integer too; `None` for any other case.
fn exact_tangent(case: &Case) -> Option<f64> {
    let is_small_integer = |number: &f64| number.fract() == 0.0 && number.abs() < 4096.0;
    let exact = Exact::of(case);
    let root = exact.nearer_root()?.rounded();
    let rounds_nowhere = case.numbers().iter().chain([&root]).all(is_small_integer);
    (rounds_nowhere && exact.discriminant().is_eq()).then_some(root)
}

fn same_bits(
    found: Option<f64>,
    expected: Option<f64>,
    law: &'static str,
    usually: &'static str,
) -> Verdict {
    // −0 and 0 are the same place on a ray, so == is what is meant here.
    if found == expected {
        return Ok(());
    }
    Err(Broken {
        law,
        found: format!("{found:?}"),
        allowed: format!("{expected:?}, and no other bit"),
        usually,
        page: "chapter 4: multiplying by a power of two never rounds",
    })
}
