//! What makes a question hard, and for which methods: the reasons behind an
//! error.
//!
//! Each reason is a difference of two numbers that are nearly equal. What is
//! left of it has lost as many digits as the two have in common.

use figures::number::three_digits;
use laws::oracle::Exact;
use speed_vs_accuracy::{Case, Method, Precision};

/// Why `method` may err on `question`: each reason a sentence, the worst first.
///
/// None if no digit is lost that the method has no remedy for.
pub(super) fn reasons(method: &Method, question: &Case) -> Vec<String> {
    let precision = Precision::of(method);
    let question = question.rounded(precision);
    let Some(exact) = Exact::new(question.center, question.radius, &question.ray) else {
        return vec![format!("{} has no such numbers", precision.name())];
    };
    let habits = habits(method.name);
    if let Some(reason) = exponent(habits, precision, &question) {
        return vec![reason];
    }
    let mut found: Vec<(f64, String)> = [
        discriminant(habits, &question, &exact),
        constant(habits, &exact),
        numerator(habits, &question),
    ]
    .into_iter()
    .flatten()
    .filter(|&(lost, _)| lost >= 0.5)
    .collect();
    found.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    let digits = habits.digits;
    let sentence = |(lost, what)| format!("{what}: {} of {digits:.0} digits", shown(lost, digits));
    found.into_iter().map(sentence).collect()
}

/// How a method computes, as far as it matters here.
#[derive(Clone, Copy)]
struct Habits {
    discriminant: Discriminant,
    /// c = oc·oc − r² is the plain difference of two rounded squares.
    plain_constant: bool,
    /// The nearer root is (h − √D)/a, not c/(h + √D).
    plain_root: bool,
    /// Exponents are brought into range first, or nothing is rounded at all.
    any_exponent: bool,
    /// Decimal digits that it computes with.
    digits: f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Discriminant {
    /// h² − a·c
    Difference,
    /// r² − l², with l the distance of the line from the center.
    Distance,
    /// As long as it takes.
    Certain,
}

const F64: f64 = 16.0;
const F32: f64 = 7.0;

fn habits(name: &str) -> Habits {
    use Discriminant::{Certain, Difference, Distance};
    let plain = Habits {
        discriminant: Difference,
        plain_constant: true,
        plain_root: false,
        any_exponent: false,
        digits: if name.ends_with("_f32") { F32 } else { F64 },
    };
    let distance = Habits {
        discriminant: Distance,
        ..plain
    };
    match name.trim_end_matches("_f32") {
        "full_b" | "half_b" => Habits {
            plain_root: true,
            ..plain
        },
        "haines" => Habits {
            plain_root: true,
            ..distance
        },
        "haines_q" | "cross_q" => distance,
        "half_b_q" | "kahan_q" => plain,
        "scaled_q" => Habits {
            any_exponent: true,
            ..plain
        },
        "adaptive_q" => Habits {
            plain_constant: false,
            ..distance
        },
        "double_double" => Habits {
            digits: 2.0 * F64,
            ..plain
        },
        "widened_half_b_q" => Habits {
            digits: F64,
            any_exponent: true,
            ..plain
        },
        // Its decision is certain, its t is that of half_b_q.
        "certified_hit" => Habits {
            discriminant: Certain,
            any_exponent: true,
            ..plain
        },
        "exact" | "certified_t" => Habits {
            discriminant: Certain,
            plain_constant: false,
            any_exponent: true,
            ..plain
        },
        other => panic!("say here how {other} computes"),
    }
}

/// How many digits D loses.
fn discriminant(habits: Habits, question: &Case, exact: &Exact) -> Option<(f64, String)> {
    let margin = exact.discriminant_margin().abs();
    let oc = question.center - question.ray.origin;
    let away = oc.length() / question.radius.abs();
    match habits.discriminant {
        Discriminant::Difference => Some((
            -margin.log10(),
            format!(
                "h² − a·c cancels, {} radii from the center",
                three_digits(away)
            ),
        )),
        Discriminant::Distance => {
            // (r² − l²)/r² is D/(a·M) times M/r², and l has an error that grows
            // with the distance.
            let from_radius = margin * (1.0 + away * away);
            Some((
                away.max(1.0).log10() - from_radius.log10(),
                format!(
                    "r² − l² cancels, {} radii from the center",
                    three_digits(away)
                ),
            ))
        }
        Discriminant::Certain => None,
    }
}

/// How many digits c loses.
fn constant(habits: Habits, exact: &Exact) -> Option<(f64, String)> {
    let lost = -exact.origin_margin().abs().log10();
    habits
        .plain_constant
        .then(|| (lost, "c = oc·oc − r² cancels, near the surface".to_owned()))
}

/// How many digits the numerator of the nearer root loses, in front of a sphere.
fn numerator(habits: Habits, question: &Case) -> Option<(f64, String)> {
    let Case {
        center,
        radius,
        ray,
    } = *question;
    let oc = center - ray.origin;
    let d = ray.direction.normalize();
    let h = d.dot(oc);
    let c = (oc.length() - radius.abs()) * (oc.length() + radius.abs());
    // (h − √D) = c/(h + √D), and h + √D is about 2h where it is small.
    habits.plain_root.then(|| {
        let lost = (2.0 * h * h / c.abs()).log10();
        (lost, "h − √D cancels".to_owned())
    })
}

/// Whether a·M is out of range.
fn exponent(habits: Habits, precision: Precision, question: &Case) -> Option<String> {
    let (least, greatest) = match precision {
        Precision::Double => (f64::MIN_POSITIVE, f64::MAX),
        Precision::Single => (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX)),
    };
    let oc = (question.center - question.ray.origin).length();
    let a = 2.0 * question.ray.direction.length().log2();
    let m = 2.0 * oc.max(question.radius.abs()).log2();
    let what = [("a = d·d", a), ("oc·oc", m), ("a·oc·oc", a + m)];
    let what = what.into_iter().filter(|_| !habits.any_exponent);
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

fn shown(lost: f64, digits: f64) -> String {
    if lost >= digits {
        "all".to_owned()
    } else {
        format!("{lost:.1}")
    }
}
