//! Fault localization: from a wrong answer to the formula that gives it.
//!
//! A wrong root is seldom a random number. It is the right answer to another
//! formula, and the formulas that people write by mistake are known.

use common::rtweekend::*;
use speed_vs_accuracy::Case;

/// What the code probably says if `hit_sphere` returns `t` for `case`.
pub fn of_root(case: &Case, t: f64) -> String {
    if t.is_nan() {
        return "the root of a negative number: the discriminant is not tested, or its sign is \
                turned"
            .to_owned();
    }
    known_mistake(case, t)
        .unwrap_or(
            "no formula that is known here gives this t: compare a, b and c with equations (13) \
             to (15), letter by letter",
        )
        .to_owned()
}

/// The mistake that makes `hit_sphere` return `t` for `case`, if it is known.
pub fn known_mistake(case: &Case, t: f64) -> Option<&'static str> {
    let same = |one: f64, other: f64| (one - other).abs() <= 1e-9 * one.abs();
    let oc = case.center - case.ray.origin;
    let right = Quadratic::of(case, oc).nearer_root();
    wrong_roots(case)
        .into_iter()
        // By chance, as where a is 1, a mistake may lead to the right root.
        .find(|&(wrong, _)| same(wrong, t) && !same(wrong, right))
        .map(|(_, mistake)| mistake)
}

/// What the code probably says if `hit_sphere` decides for a hit, or a miss,
/// and should not.
pub fn of_decision(case: &Case, hit: bool) -> String {
    let right = Quadratic::of(case, case.center - case.ray.origin);
    if !hit && right.nearer_root() < 0.0 {
        return "a test for t > 0 or h > 0 inside hit_sphere, where the nearer root is behind the \
                ray: the line goes both ways, and such a test belongs to the caller"
            .to_owned();
    }
    if hit && (-1e-6..0.0).contains(&right.discriminant()) {
        return "the discriminant is compared with a small number instead of 0".to_owned();
    }
    let found: Vec<&str> = wrong_discriminants(case)
        .into_iter()
        .filter(|(wrong, _)| (*wrong >= 0.0) == hit)
        .map(|(_, mistake)| mistake)
        .collect();
    if found.is_empty() {
        "the sign of the test: a negative discriminant is a miss".to_owned()
    } else {
        format!("one of these: {}", found.join("; "))
    }
}

/// The roots that common mistakes return.
fn wrong_roots(case: &Case) -> Vec<(f64, &'static str)> {
    let right = Quadratic::of(case, case.center - case.ray.origin);
    let added = Quadratic::of(case, case.center + case.ray.origin);
    let left_out = Quadratic::of(case, case.center);
    let Quadratic { a, h, c } = right;
    let (near, far) = (right.nearer_root(), 2.0 * h / a - right.nearer_root());
    let h_is_negative = h < 0.0;
    let inside = near < 0.0 && far > 0.0;
    vec![
        (
            far,
            if inside {
                "the farther root is returned where the nearer one is behind the ray: that choice \
                 comes with t_min, in chapter 5. Or + √discriminant stands where it should be −"
            } else {
                "+ √discriminant where it should be −: this is the farther root"
            },
        ),
        (
            if h_is_negative && near < 0.0 {
                0.0
            } else {
                f64::NAN
            },
            "t is kept from being negative: the line goes both ways, and what lies behind is the \
             caller's business",
        ),
        (
            if h_is_negative { -far } else { f64::NAN },
            "an absolute value hides the sign of h, or of b",
        ),
        (
            -far,
            "the sign of h, or of b: with oc = center − origin it is (h − √discriminant) / a \
             and b = −2 d·oc. This is the farther root, negated",
        ),
        (
            -near,
            "the sign of the whole root, or oc and the root both turned round",
        ),
        (
            added.nearer_root(),
            "oc is center + origin where it should be center − origin",
        ),
        (
            left_out.nearer_root(),
            "the origin of the ray is left out of oc = center − origin",
        ),
        (2.0 * near, "/ a where the full formula divides by 2a"),
        (near / 2.0, "/ (2a) where half-b divides by a"),
        (
            (h - (h * h - a.sqrt() * c).sqrt()) / a.sqrt(),
            "a is the length of the direction where it should be its square",
        ),
        (
            near * a * a,
            "/ 2.0 * a divides by 2 and multiplies by a: it needs / (2.0 * a)",
        ),
        (
            near * a,
            "the division by a is missing, or by 2 instead of 2a",
        ),
        (2.0 * near * a, "the division by 2a is missing"),
        (
            near * a.sqrt(),
            "a distance instead of t: the direction was made a unit vector, or t multiplied by \
             its length",
        ),
        (
            near / a.sqrt(),
            "divided by the length of the direction once too often",
        ),
        (
            h / a,
            "the square root is missing or zero: this is the point nearest the center",
        ),
        (
            (h - (h * h - 4.0 * a * c).sqrt()) / a,
            "h*h − 4ac where half-b has h*h − ac",
        ),
        (
            (2.0 * h - (4.0 * h * h - a * c).sqrt()) / (2.0 * a),
            "b*b − ac where the full formula has b*b − 4ac",
        ),
        (
            (h - (h * h - a * c)) / a,
            "the square root of the discriminant is not taken",
        ),
        (
            (h - (h * h + a * c).sqrt()) / a,
            "h*h + ac where it should be −; or r² is subtracted the wrong way round",
        ),
        (
            (h - (h * h - a * (c + case.radius * case.radius - case.radius)).sqrt()) / a,
            "the radius is not squared in c",
        ),
        (
            (h - (h * h - a * (c + 2.0 * case.radius * case.radius)).sqrt()) / a,
            "r² is added in c where it should be subtracted",
        ),
        (
            (h - (h * h - a * (c + case.radius * case.radius)).sqrt()) / a,
            "r² is missing in c",
        ),
    ]
}

/// The discriminants that common mistakes compute.
fn wrong_discriminants(case: &Case) -> Vec<(f64, &'static str)> {
    let added = Quadratic::of(case, case.center + case.ray.origin);
    let left_out = Quadratic::of(case, case.center);
    let Quadratic { a, h, c } = Quadratic::of(case, case.center - case.ray.origin);
    let r = case.radius;
    let oc_squared = c + r * r;
    vec![
        (a * c - h * h, "the sign of the test is turned round"),
        (
            (h * h - a * c).abs(),
            "an absolute value hides a negative discriminant",
        ),
        (
            h * h - a.sqrt() * c,
            "a is the length of the direction where it should be its square",
        ),
        (h * h - 4.0 * a * c, "h*h − 4ac where half-b has h*h − ac"),
        (
            4.0 * h * h - a * c,
            "b*b − ac where the full formula has b*b − 4ac",
        ),
        (h * h + a * c, "+ ac where it should be −"),
        (h * h - a * (oc_squared - r), "the radius is not squared"),
        (
            h * h - a * (oc_squared + r * r),
            "r² is added in c, not subtracted",
        ),
        (h - a * c, "h is not squared"),
        (
            added.discriminant(),
            "oc is center + origin where it should be center − origin",
        ),
        (
            left_out.discriminant(),
            "the origin of the ray is left out of oc = center − origin",
        ),
    ]
}

/// The coefficients of a·t² − 2h·t + c, rounded: close enough to recognize.
struct Quadratic {
    a: f64,
    h: f64,
    c: f64,
}

impl Quadratic {
    fn of(case: &Case, oc: Vec3) -> Self {
        Self {
            a: case.a(),
            h: case.ray.direction.dot(oc),
            c: oc.length_squared() - case.radius * case.radius,
        }
    }

    fn discriminant(&self) -> f64 {
        self.h * self.h - self.a * self.c
    }

    fn nearer_root(&self) -> f64 {
        (self.h - self.discriminant().sqrt()) / self.a
    }
}
