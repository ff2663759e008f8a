//! Cancellation, counted in digits: why a method errs.
//!
//! Each reason is a difference of two numbers that are nearly equal. What is
//! left of it has lost as many digits as the two have in common.

use figures::number::three_digits;
use laws::oracle::Exact;
use speed_vs_accuracy::{Case, Discriminant, Method};

use super::number::ends;

/// Why `method` may err on `case`: each reason a sentence, the worst first.
///
/// None if no digit is lost that the method has no remedy for.
pub(super) fn reasons(method: &Method, case: &Case) -> Vec<String> {
    let precision = method.precision();
    let case = case.rounded(precision);
    let Some(exact) = Exact::of_finite(&case) else {
        return vec![format!(
            "these numbers do not fit into {}",
            precision.name()
        )];
    };
    if let Some(reason) = exponent(method, &case) {
        return vec![reason];
    }
    let mut found: Vec<(f64, String)> = [
        discriminant(method, &case, &exact),
        constant(method, &exact),
        numerator(method, &case),
    ]
    .into_iter()
    .flatten()
    .filter(|&(lost, _)| lost >= 0.5)
    .collect();
    found.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    let digits = method.digits;
    let sentence =
        |(lost, what)| format!("{what}: {} of {digits:.0} digits", in_digits(lost, digits));
    found.into_iter().map(sentence).collect()
}

/// How many digits D loses.
fn discriminant(method: &Method, case: &Case, exact: &Exact) -> Option<(f64, String)> {
    let margin = exact.discriminant_margin().abs();
    let away = away(case);
    let from_where = match away {
        _ if case.radius == 0.0 => "and the sphere is a point".to_owned(),
        f64::INFINITY => "more than 1e308 radii from the center".to_owned(),
        away => format!("{} radii from the center", three_digits(away)),
    };
    match method.discriminant {
        Discriminant::Difference => {
            Some((-margin.log10(), format!("h² − a·c cancels, {from_where}")))
        }
        Discriminant::Distance => {
            // (r² − l²)/r² is D/(a·M) times M/r², and l has an error that grows
            // with the distance.
            let from_radius = margin * (1.0 + away * away);
            Some((
                away.max(1.0).log10() - from_radius.log10(),
                format!("r² − l² cancels, {from_where}"),
            ))
        }
        Discriminant::Certain => None,
    }
}

/// How far the origin is from the center, in radii, without a square that overflows.
fn away(case: &Case) -> f64 {
    let oc = case.center - case.ray.origin;
    oc.x.hypot(oc.y).hypot(oc.z) / case.radius.abs()
}

/// How many digits c loses.
fn constant(method: &Method, exact: &Exact) -> Option<(f64, String)> {
    let lost = -exact.origin_margin().abs().log10();
    method
        .c_cancels
        .then(|| (lost, "c = oc·oc − r² cancels, near the surface".to_owned()))
}

/// How many digits the numerator of the nearer root loses, in front of a sphere.
fn numerator(method: &Method, case: &Case) -> Option<(f64, String)> {
    let Case {
        center,
        radius,
        ray,
    } = *case;
    let oc = center - ray.origin;
    let d = ray.direction.normalize();
    let h = d.dot(oc);
    let c = (oc.length() - radius.abs()) * (oc.length() + radius.abs());
    // (h − √D) = c/(h + √D), and h + √D is about 2h where it is small.
    method.root_cancels.then(|| {
        let lost = (2.0 * h * h / c.abs()).log10();
        (lost, "h − √D cancels".to_owned())
    })
}

/// Whether a·M is out of range.
fn exponent(method: &Method, case: &Case) -> Option<String> {
    let (least, greatest) = ends(method.precision());
    let oc = (case.center - case.ray.origin).length();
    let a = 2.0 * case.ray.direction.length().log2();
    let m = 2.0 * oc.max(case.radius.abs()).log2();
    let what = [("a = d·d", a), ("oc·oc", m), ("a·oc·oc", a + m)];
    let what = what.into_iter().filter(|_| !method.any_exponent);
    what.into_iter().find_map(|(what, exponent)| {
        if exponent >= greatest.log2() {
            Some(format!("{what} overflows"))
        } else if exponent <= least.log2() {
            Some(format!("{what} underflows"))
        } else {
            None
        }
    })
}

fn in_digits(lost: f64, digits: f64) -> String {
    if lost >= digits {
        "all".to_owned()
    } else {
        format!("{lost:.1}")
    }
}
