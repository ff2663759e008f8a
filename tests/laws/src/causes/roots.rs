//! The mistakes in the quadratic, for functions that return a root, decide, or
//! look for a root in a range.

use common::rtweekend::*;
use speed_vs_accuracy::Case;

use super::{Hypothesis, Mistake, Question};
use crate::intervals::WithInterval;
use crate::nearer_root::Decided;
use crate::runner::endless;
use crate::strategies;

/// The numbers that lead to the roots.
struct Quadratic {
    center: Point3,
    radius: f64,
    origin: Point3,
    direction: Vec3,
}

/// The nearer and the farther root, if there are any.
type Roots = Option<[f64; 2]>;

impl Quadratic {
    fn of(case: &Case) -> Self {
        Self {
            center: case.center,
            radius: case.radius,
            origin: case.ray.origin,
            direction: case.ray.direction,
        }
    }

    fn oc(&self) -> Vec3 {
        self.center - self.origin
    }

    fn a(&self) -> f64 {
        self.direction.length_squared()
    }

    fn h(&self) -> f64 {
        self.direction.dot(self.oc())
    }

    fn c(&self) -> f64 {
        self.oc().length_squared() - self.radius * self.radius
    }

    fn discriminant(&self) -> f64 {
        self.h() * self.h() - self.a() * self.c()
    }

    fn roots(&self) -> Roots {
        roots(self.a(), self.h(), self.c())
    }

    /// The roots with another vector for oc.
    fn roots_with_oc(&self, oc: Vec3) -> Roots {
        let c = oc.length_squared() - self.radius * self.radius;
        roots(self.a(), self.direction.dot(oc), c)
    }

    /// The roots with another discriminant.
    fn roots_with(&self, discriminant: f64) -> Roots {
        (discriminant >= 0.0).then(|| pair(self.a(), self.h(), discriminant.sqrt()))
    }

    /// The roots if `dot` and `length_squared` were these functions.
    fn roots_by(&self, dot: fn(Vec3, Vec3) -> f64, length_squared: fn(Vec3) -> f64) -> Roots {
        let c = length_squared(self.oc()) - self.radius * self.radius;
        let a = length_squared(self.direction);
        roots(a, dot(self.direction, self.oc()), c)
    }

    /// What takes the place of the roots if the first term is not divided.
    fn around(&self, first_term: f64) -> [f64; 2] {
        let half = self.discriminant().sqrt() / self.a();
        [first_term - half, first_term + half]
    }

    /// The right roots times some number.
    fn roots_times(&self, factor: f64) -> Roots {
        self.roots().map(|roots| roots.map(|t| t * factor))
    }
}

fn roots(a: f64, h: f64, c: f64) -> Roots {
    let discriminant = h * h - a * c;
    (discriminant >= 0.0).then(|| pair(a, h, discriminant.sqrt()))
}

fn pair(a: f64, h: f64, sqrtd: f64) -> [f64; 2] {
    [(h - sqrtd) / a, (h + sqrtd) / a]
}

/// A mistake, and the roots to which it leads.
type Line = (Mistake, fn(&Quadratic) -> Roots);

/// A mistake that is one of the known slips.
const fn slip(
    names: &'static [&'static str],
    wrong: &'static str,
    right: &'static str,
    roots: fn(&Quadratic) -> Roots,
) -> Line {
    (
        Mistake {
            names,
            wrong,
            right,
        },
        roots,
    )
}

/// Any other mistake.
const fn other(wrong: &'static str, right: &'static str, roots: fn(&Quadratic) -> Roots) -> Line {
    slip(&[], wrong, right, roots)
}

const LINES: &[Line] = &[
    slip(
        &["minus-h", "plus-b"],
        "(-h - sqrt(discriminant)) / a, or (b - sqrt(discriminant)) / (2*a)",
        "(h - sqrt(discriminant)) / a, or (-b - sqrt(discriminant)) / (2*a)",
        |q| roots(q.a(), -q.h(), q.c()),
    ),
    slip(
        &["oc-reversed"],
        "oc = r.origin() - center",
        "oc = center - r.origin()",
        |q| q.roots_with_oc(-q.oc()),
    ),
    slip(
        &["b-sign"],
        "b = 2 * dot(r.direction(), oc)",
        "b = -2 * dot(r.direction(), oc)",
        |q| roots(q.a(), -q.h(), q.c()),
    ),
    slip(
        &["far-root"],
        "(-b + sqrt(discriminant)) / (2*a)",
        "(-b - sqrt(discriminant)) / (2*a)",
        |q| q.roots().map(|[_, far]| [far, far]),
    ),
    slip(
        &["b-not-doubled"],
        "b = -dot(r.direction(), oc)",
        "b = -2 * dot(r.direction(), oc)",
        |q| roots(2.0 * q.a(), q.h(), 2.0 * q.c()),
    ),
    slip(
        &["h-doubled"],
        "h = -2 * dot(r.direction(), oc)",
        "h = dot(r.direction(), oc)",
        |q| roots(q.a(), -2.0 * q.h(), q.c()),
    ),
    slip(
        &["discriminant-without-four"],
        "discriminant = b*b - a*c",
        "discriminant = b*b - 4*a*c",
        |q| q.roots_with(q.h() * q.h() - q.a() * q.c() / 4.0),
    ),
    slip(
        &["discriminant-with-four"],
        "discriminant = h*h - 4*a*c",
        "discriminant = h*h - a*c",
        |q| q.roots_with(q.h() * q.h() - 4.0 * q.a() * q.c()),
    ),
    slip(
        &["discriminant-with-plus"],
        "b*b + 4*a*c, or h*h + a*c",
        "b*b - 4*a*c, or h*h - a*c",
        |q| q.roots_with(q.h() * q.h() + q.a() * q.c()),
    ),
    slip(
        &["tangent-missed"],
        "discriminant > 0",
        "discriminant >= 0",
        |q| q.roots().filter(|_| q.discriminant() > 0.0),
    ),
    slip(
        &["radius-not-squared"],
        "c = dot(oc, oc) - radius",
        "c = dot(oc, oc) - radius*radius",
        |q| roots(q.a(), q.h(), q.oc().length_squared() - q.radius),
    ),
    slip(
        &["radius-added"],
        "c = dot(oc, oc) + radius*radius",
        "c = dot(oc, oc) - radius*radius",
        |q| roots(q.a(), q.h(), q.oc().length_squared() + q.radius * q.radius),
    ),
    slip(
        &["center-not-squared"],
        "c = oc.length() - radius*radius",
        "c = dot(oc, oc) - radius*radius",
        |q| roots(q.a(), q.h(), q.oc().length() - q.radius * q.radius),
    ),
    slip(
        &["a-taken-as-one"],
        "a = 1",
        "a = dot(r.direction(), r.direction())",
        |q| roots(1.0, q.h(), q.c()),
    ),
    slip(
        &["dot-with-swapped-letter"],
        "u.x*v.x + u.y*v.y + u.z*u.z",
        "u.x*v.x + u.y*v.y + u.z*v.z",
        |q| {
            q.roots_by(
                |u, v| u.x * v.x + u.y * v.y + u.z * u.z,
                Vec3::length_squared,
            )
        },
    ),
    slip(
        &["dot-without-z"],
        "u.x*v.x + u.y*v.y",
        "u.x*v.x + u.y*v.y + u.z*v.z",
        |q| q.roots_by(flat_dot, |v| flat_dot(v, v)),
    ),
    slip(
        &["dot-without-z"],
        "u.x*v.x + u.y*v.y",
        "u.x*v.x + u.y*v.y + u.z*v.z",
        |q| q.roots_by(flat_dot, Vec3::length_squared),
    ),
    slip(
        &["length-with-swapped-letter"],
        "e[0]*e[0] + e[1]*e[1] + e[1]*e[1]",
        "e[0]*e[0] + e[1]*e[1] + e[2]*e[2]",
        |q| q.roots_by(Vec3::dot, |v| v.x * v.x + v.y * v.y + v.y * v.y),
    ),
    slip(
        &["stale-boolean"],
        "return discriminant >= 0",
        "return (-b - sqrt(discriminant)) / (2*a)",
        |q| q.roots().map(|_| [1.0, 1.0]),
    ),
    slip(
        &["minus-one-is-true"],
        "bool hit_sphere(…) { … return -1.0;",
        "double hit_sphere(…) { … return -1.0;",
        |_| Some([1.0, 1.0]),
    ),
    slip(
        &["miss-is-one"],
        "if (discriminant < 0) return 1.0",
        "if (discriminant < 0) return -1.0",
        |q| q.roots().or(Some([1.0, 1.0])),
    ),
    slip(
        &["square-root-forgotten"],
        "(-b - discriminant) / (2*a)",
        "(-b - sqrt(discriminant)) / (2*a)",
        |q| {
            q.roots()
                .map(|_| pair(q.a(), q.h(), 2.0 * q.discriminant()))
        },
    ),
    slip(
        &["square-root-forgotten"],
        "(-b - discriminant) / (2*a)",
        "(-b - sqrt(discriminant)) / (2*a)",
        |q| q.roots().map(|_| pair(q.a(), q.h(), q.discriminant())),
    ),
    slip(
        &["two-a-without-brackets"],
        "(-b - sqrt(discriminant)) / 2*a",
        "(-b - sqrt(discriminant)) / (2*a)",
        |q| q.roots_times(q.a() * q.a()),
    ),
    slip(
        &["numerator-without-brackets"],
        "-b - sqrt(discriminant) / (2*a), or h - sqrt(discriminant) / a",
        "(-b - sqrt(discriminant)) / (2*a), or (h - sqrt(discriminant)) / a",
        |q| q.roots().map(|_| q.around(2.0 * q.h())),
    ),
    slip(
        &["numerator-without-brackets"],
        "-b - sqrt(discriminant) / (2*a), or h - sqrt(discriminant) / a",
        "(-b - sqrt(discriminant)) / (2*a), or (h - sqrt(discriminant)) / a",
        |q| q.roots().map(|_| q.around(q.h())),
    ),
    slip(
        &["divided-by-a"],
        "(-b - sqrt(discriminant)) / a",
        "(-b - sqrt(discriminant)) / (2*a)",
        |q| q.roots_times(2.0),
    ),
    slip(
        &["divided-by-two-a"],
        "(h - sqrt(discriminant)) / (2*a)",
        "(h - sqrt(discriminant)) / a",
        |q| q.roots_times(0.5),
    ),
    slip(
        &["not-divided"],
        "h - sqrt(discriminant)",
        "(h - sqrt(discriminant)) / a",
        |q| q.roots_times(q.a()),
    ),
    other(
        "(-b - sqrt(discriminant)) / 2",
        "(-b - sqrt(discriminant)) / (2*a)",
        |q| q.roots_times(q.a()),
    ),
    other(
        "-b - sqrt(discriminant)",
        "(-b - sqrt(discriminant)) / (2*a)",
        |q| q.roots_times(2.0 * q.a()),
    ),
    other(
        "t is a distance: the direction was made a unit vector",
        "t counts lengths of the direction",
        |q| q.roots_times(q.a().sqrt()),
    ),
    other(
        "t is divided by the length of the direction once too often",
        "t counts lengths of the direction",
        |q| q.roots_times(1.0 / q.a().sqrt()),
    ),
    other(
        "a = r.direction().length()",
        "a = dot(r.direction(), r.direction())",
        |q| roots(q.a().sqrt(), q.h(), q.c()),
    ),
    other("a and c have changed places", "h*h - a*c, and / a", |q| {
        roots(q.c(), q.h(), q.a())
    }),
    other(
        "oc = center + r.origin()",
        "oc = center - r.origin()",
        |q| q.roots_with_oc(q.center + q.origin),
    ),
    other("oc = center", "oc = center - r.origin()", |q| {
        q.roots_with_oc(q.center)
    }),
    other("oc = r.origin()", "oc = center - r.origin()", |q| {
        q.roots_with_oc(q.origin)
    }),
    other("c = dot(oc, oc)", "c = dot(oc, oc) - radius*radius", |q| {
        roots(q.a(), q.h(), q.oc().length_squared())
    }),
    other("discriminant = h - a*c", "discriminant = h*h - a*c", |q| {
        q.roots_with(q.h() - q.a() * q.c())
    }),
    other(
        "an absolute value hides that the discriminant is negative",
        "a negative discriminant is a miss",
        |q| q.roots_with(q.discriminant().abs()),
    ),
    other(
        "the discriminant is not tested, and its root is not a number",
        "a negative discriminant is a miss",
        |q| Some(pair(q.a(), q.h(), q.discriminant().sqrt())),
    ),
    other(
        "a positive discriminant is a miss",
        "a negative discriminant is a miss",
        |q| (q.discriminant() <= 0.0).then(|| pair(q.a(), q.h(), q.discriminant().sqrt())),
    ),
    other(
        "c = radius*radius - dot(oc, oc)",
        "c = dot(oc, oc) - radius*radius",
        |q| q.roots_with(q.h() * q.h() + q.a() * q.c()),
    ),
    other(
        "(h - sqrt(discriminant)) / 2*a",
        "(h - sqrt(discriminant)) / a",
        |q| q.roots_times(q.a() * q.a() / 2.0),
    ),
    other("every ray misses", "discriminant >= 0 is a hit", |_| None),
    other("every ray hits", "a negative discriminant is a miss", |q| {
        q.roots().or(Some([0.0, 0.0]))
    }),
    other("a miss returns -1", "a miss returns no t at all", |q| {
        q.roots().or(Some([-1.0, -1.0]))
    }),
    other(
        "only t > 0 is returned",
        "the line goes both ways: what lies behind is the caller's business",
        |q| q.roots().filter(|[near, _]| *near > 0.0),
    ),
    other(
        "the farther root is returned where the nearer one is behind",
        "the nearer root, wherever it is: the choice comes with t_min, in chapter 5",
        |q| {
            q.roots()
                .map(|[near, far]| if near > 0.0 { [near, far] } else { [far, far] })
        },
    ),
    other(
        "only rays that come nearer to the center hit",
        "the line goes both ways: what lies behind is the caller's business",
        |q| q.roots().filter(|_| q.h() > 0.0),
    ),
    other(
        "t is kept from being negative",
        "the line goes both ways: what lies behind is the caller's business",
        |q| q.roots().map(|roots| roots.map(|t| t.max(0.0))),
    ),
    other(
        "an absolute value hides the sign of h, or of b",
        "h has a sign",
        |q| roots(q.a(), q.h().abs(), q.c()),
    ),
    other(
        "an absolute value hides the sign of t",
        "t has a sign",
        |q| q.roots().map(|roots| roots.map(f64::abs)),
    ),
    other(
        "the sign of the whole root is turned",
        "(h - sqrt(discriminant)) / a",
        |q| q.roots_times(-1.0),
    ),
    other(
        "h / a: the square root is missing",
        "(h - sqrt(discriminant)) / a",
        |q| q.roots().map(|_| [q.h() / q.a(); 2]),
    ),
];

fn flat_dot(u: Vec3, v: Vec3) -> f64 {
    u.x * v.x + u.y * v.y
}

/// The lines above as hypotheses, with what becomes of the roots.
fn lifted<Q: Question>(
    case: fn(&Q) -> &Case,
    answer: fn(&Q, Roots) -> Q::Answer,
) -> Vec<Hypothesis<Q>> {
    let hypothesis = |&(mistake, roots): &Line| {
        let answer = move |asked: &Q| answer(asked, roots(&Quadratic::of(case(asked))));
        Hypothesis::new(mistake, answer)
    };
    LINES.iter().map(hypothesis).collect()
}

/// Rays and spheres near and far, from inside and behind, with directions of any
/// length. Rounding decides none of them, except that some are exact tangents.
fn telling() -> Vec<Case> {
    endless(strategies::book_rays(), "")
        .take(60)
        .chain(endless(strategies::integers(), "").take(80))
        .chain(endless(strategies::far(0.5..=2.0), "").take(60))
        .chain(endless(strategies::grazing(0.3..=1.5), "").take(40))
        .chain(endless(strategies::inside(), "").take(40))
        .chain(endless(strategies::tangents(), "").take(20))
        .filter(|case| !case.is_degenerate())
        .collect()
}

impl Question for Case {
    type Answer = Option<f64>;

    const FUNCTION: &'static str = "hit_sphere";

    fn right(&self) -> Option<f64> {
        nearer(self, Quadratic::of(self).roots())
    }

    /// Two ways to compute one number differ by roundings: of the number itself, and
    /// of what cancels on the way to a small one, which is √(M/a) large. Both are a
    /// thousand times as much as rounding takes in the cases that are telling.
    fn same(&self, one: &Option<f64>, other: &Option<f64>) -> bool {
        match (one, other) {
            (None, None) => true,
            (Some(one), Some(other)) if one.is_nan() || other.is_nan() => {
                one.is_nan() && other.is_nan()
            }
            (Some(one), Some(other)) => {
                let size = one.abs() + other.abs();
                one == other || (one - other).abs() <= 1e-10 * size + 1e-12 * self.t_scale()
            }
            _ => false,
        }
    }

    fn telling() -> Vec<Self> {
        telling()
    }

    fn hypotheses() -> Vec<Hypothesis<Self>> {
        lifted(|case| case, nearer)
    }

    fn is_degenerate(&self) -> bool {
        let [direction, oc] = [self.ray.direction, self.center - self.ray.origin];
        self.radius <= 0.0 || direction == Vec3::ZERO || oc == Vec3::ZERO
    }
}

fn nearer(_: &Case, roots: Roots) -> Option<f64> {
    roots.map(|[near, _]| near)
}

impl Question for Decided {
    type Answer = bool;

    const FUNCTION: &'static str = "hit_sphere";

    fn right(&self) -> bool {
        self.0.right().is_some()
    }

    fn same(&self, one: &bool, other: &bool) -> bool {
        one == other
    }

    fn telling() -> Vec<Self> {
        telling().into_iter().map(Self).collect()
    }

    fn hypotheses() -> Vec<Hypothesis<Self>> {
        lifted(|decided: &Self| &decided.0, |_, roots| roots.is_some())
    }

    fn is_degenerate(&self) -> bool {
        self.0.is_degenerate()
    }
}

impl Question for WithInterval {
    type Answer = Option<f64>;

    const FUNCTION: &'static str = "hit";

    fn right(&self) -> Option<f64> {
        nearest(self, Quadratic::of(&self.case).roots())
    }

    fn same(&self, one: &Option<f64>, other: &Option<f64>) -> bool {
        self.case.same(one, other)
    }

    /// Every third case with the whole line, with what is in front, with a range that holds
    /// only the farther root, and with one that ends before it.
    fn telling() -> Vec<Self> {
        let with_ranges = |case: Case| {
            let [near, far] = Quadratic::of(&case).roots().unwrap_or([1.0, 2.0]);
            [
                (f64::NEG_INFINITY, f64::INFINITY),
                (0.0, f64::INFINITY),
                (0.5 * (near + far), f64::INFINITY),
                (0.0, 0.25 * near + 0.75 * far),
                (near, 2.0 * far - near),
                (f64::NEG_INFINITY, near - 0.5 * (far - near)),
            ]
            .map(|(t_min, t_max)| Self { case, t_min, t_max })
        };
        telling()
            .into_iter()
            .step_by(3)
            .flat_map(with_ranges)
            .collect()
    }

    fn hypotheses() -> Vec<Hypothesis<Self>> {
        let mut hypotheses = of_the_range();
        hypotheses.extend(lifted(|asked: &Self| &asked.case, nearest));
        hypotheses
    }

    fn is_degenerate(&self) -> bool {
        self.case.is_degenerate()
    }
}

fn nearest(asked: &WithInterval, roots: Roots) -> Option<f64> {
    let in_range = |t: &f64| asked.t_min < *t && *t < asked.t_max;
    roots.into_iter().flatten().find(in_range)
}

/// The mistakes in the range, with the right roots.
fn of_the_range() -> Vec<Hypothesis<WithInterval>> {
    let hypothesis = |(mistake, choose): (Mistake, Choose)| {
        Hypothesis::new(mistake, move |asked: &WithInterval| {
            let roots = Quadratic::of(&asked.case).roots()?;
            choose(roots, asked.t_min, asked.t_max)
        })
    };
    CHOICES.iter().copied().map(hypothesis).collect()
}

/// Chooses from two roots with a range.
type Choose = fn([f64; 2], f64, f64) -> Option<f64>;

const CHOICES: &[(Mistake, Choose)] = &[
    (
        Mistake {
            names: &["near-root-only"],
            wrong: "root = (h - sqrtd) / a; if (!range.surrounds(root)) return false",
            right: "… root = (h + sqrtd) / a; if (!range.surrounds(root)) return false",
        },
        |[near, _], low, high| Some(near).filter(|t| low < *t && *t < high),
    ),
    (
        Mistake {
            names: &["range-not-tested"],
            wrong: "root = (h - sqrtd) / a; rec.t = root",
            right: "if (!ray_t.surrounds(root)) …",
        },
        |[near, _], _, _| Some(near),
    ),
    (
        Mistake {
            names: &["range-closed"],
            wrong: "t_min <= t && t <= t_max",
            right: "t_min < t && t < t_max",
        },
        |roots, low, high| roots.into_iter().find(|t| low <= *t && *t <= high),
    ),
    (
        Mistake {
            names: &[],
            wrong: "only t_min is tested",
            right: "t_min < t && t < t_max",
        },
        |roots, low, _| roots.into_iter().find(|t| low < *t),
    ),
    (
        Mistake {
            names: &[],
            wrong: "only t_max is tested",
            right: "t_min < t && t < t_max",
        },
        |roots, _, high| roots.into_iter().find(|t| *t < high),
    ),
    (
        Mistake {
            names: &[],
            wrong: "the farther root is returned untested",
            right: "both roots are tested, one after the other",
        },
        |[near, far], low, high| Some(if low < near && near < high { near } else { far }),
    ),
    (
        Mistake {
            names: &[],
            wrong: "the farther root is tried first",
            right: "both roots are tried, the nearer one first",
        },
        |[near, far], low, high| [far, near].into_iter().find(|t| low < *t && *t < high),
    ),
    (
        Mistake {
            names: &[],
            wrong: "`t <= t_min || t_max <= t` is a miss, which lets NaN pass",
            right: "`t_min < t && t < t_max` is a hit",
        },
        |roots, low, high| roots.into_iter().find(|t| !(*t <= low || high <= *t)),
    ),
];
