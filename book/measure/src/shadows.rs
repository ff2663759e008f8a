//! Shadow statistics: how often each way to leave a surface shows a shadow where there
//! is none, and light where there is a shadow.
//!
//! The ground is a sphere, and on it or above it is a ball. Someone looks at the ground
//! near the ball: does the sun shine there? Exact arithmetic knows it, from the point
//! that is looked at and not from a rounded one. A shadow has an edge, and whoever starts
//! a little beside sees it a little beside. So questions that are so near an edge that
//! 2¹⁰ roundings decide them are not asked.

use std::ops::RangeInclusive;

use crate::exact_departure::{Ball, ExactDeparture};
use common::rtweekend::*;
use figures::records::Shadows;
use figures::table::Table;
use rayon::prelude::*;
use speed_vs_accuracy::{Case, LEAVINGS, Leaving, Method, Precision, Random};

/// All ways to leave a ground of each radius, in both precisions: `questions` on each.
pub fn table(questions: usize, seed: u64) -> Table<Shadows> {
    let mut rows = Vec::new();
    for precision in Precision::ALL {
        for level in LEVELS {
            let mut random = Random::new(seed);
            let asked = (0..questions).map(|_| Question::new(&mut random, level, precision));
            let asked: Vec<Question> = asked.collect();
            let clear = asked.into_par_iter().filter_map(Question::answered);
            let clear: Vec<(Question, bool)> = clear.collect();
            let mut leavings = LEAVINGS.to_vec();
            leavings.retain(|leaving| leaving.precisions.contains(&precision));
            rows.extend(leavings.iter().flat_map(|leaving| {
                testers(precision).map(|tester| row(level, &clear, leaving, tester))
            }));
        }
    }
    rows.into()
}

/// The ground has a radius of ten to one of these powers.
const LEVELS: RangeInclusive<i32> = -3..=7;

/// Who says what is in the way of a ray that has left: the test of chapter 5, and one that
/// is never wrong.
fn testers(precision: Precision) -> [Method; 2] {
    match precision {
        Precision::Double => [Method::HALF_B, Method::EXACT],
        Precision::Single => [Method::HALF_B_F32, Method::EXACT],
    }
}

fn row(level: i32, clear: &[(Question, bool)], leaving: &Leaving, tester: Method) -> Shadows {
    let found = clear
        .par_iter()
        .map(|(question, _)| question.put_to(leaving, tester));
    let found: Vec<Seen> = found.collect();
    let per_million = |truth: bool, wrong: bool| {
        let both = clear.iter().zip(&found);
        let count = both.filter(|((_, is_dark), seen)| (*is_dark, seen.is_dark) == (truth, wrong));
        1e6 * count.count() as f64 / clear.len() as f64
    };
    let mut passed_over: Vec<f64> = found.iter().map(|seen| seen.passed_over).collect();
    passed_over.sort_unstable_by(f64::total_cmp);
    let answers = found.iter().take(FEW).zip(1..);
    Shadows {
        leaving: leaving.name.to_owned(),
        precision: clear[0].0.precision,
        level,
        tester: tester.name.to_owned(),
        questions: clear.len(),
        false_shadows_per_million: per_million(false, true),
        light_leaks_per_million: per_million(true, false),
        passed_over_radii: passed_over[passed_over.len() / 2],
        answers: answers.map(|(seen, k)| u64::from(seen.is_dark) * k).sum(),
    }
}

/// So many answers are known again.
const FEW: usize = 500;

/// Does the sun shine there?
#[derive(Clone, Copy, Debug)]
struct Question {
    /// The ground, and the ray of someone who looks at it.
    looked: Case,
    /// The point that is seen, rounded.
    point: Point3,
    /// What may be in the way.
    ball: Ball,
    /// Towards the sun.
    sun: Vec3,
    precision: Precision,
}

/// What a program sees.
struct Seen {
    is_dark: bool,
    /// Between the hit point and the first hit that counts, in radii.
    passed_over: f64,
}

impl Question {
    /// On a ground with a radius of 10 to the power `level`: the origin of coordinates is
    /// some radii away, or near the point that is looked at.
    fn new(random: &mut Random, level: i32, precision: Precision) -> Self {
        let radius = power_of_ten(level);
        let normal = random.direction();
        let point = match random.below(2) {
            0 => random.between(0.0, 4.0) * radius * random.direction(),
            _ => radius.min(1.0) * random.direction(),
        };
        let center = point - radius * normal;
        let eye = point + 2.0 * radius * (normal + 0.5 * random.direction());
        let looked = Case {
            center,
            radius,
            ray: Ray::new(eye, point - eye),
        };
        // Smaller balls are too near an edge, whatever is asked.
        let sizes = match precision {
            Precision::Double => 14,
            Precision::Single => 7,
        };
        let ball = radius * halved(random, sizes);
        let away = 3.0 * ball / radius * halved(random, 8);
        let below_ball = (normal + away * across(random, normal)).normalize();
        let gap = ball * halved(random, 10) * f64::from(random.below(2));
        let height = halved(random, 12);
        let lit = Case {
            center: center + (radius + gap + ball) * below_ball,
            radius: ball,
            ray: Ray::new(point, across(random, normal) + height * normal),
        }
        .rounded(precision);
        let looked = looked.rounded(precision);
        let t = looked.put_to(&Method::EXACT, 0.0, f64::INFINITY);
        Self {
            looked,
            point: looked.point(t.expect("it is looked at"), precision),
            ball: (lit.center, lit.radius),
            sun: lit.ray.direction,
            precision,
        }
    }

    fn ground(&self) -> Ball {
        (self.looked.center, self.looked.radius)
    }

    /// Itself, and whether the ball is in the way; `None` if that is decided so near its
    /// edge, or the sun is so near the horizon, that roundings count.
    fn answered(self) -> Option<(Self, bool)> {
        let (center, radius) = self.ground();
        let near = 512.0 * self.precision.epsilon() * (radius + center.length());
        let height = self.sun.dot(self.point - center) / self.sun.length();
        if height <= near {
            return None;
        }
        let exact = ExactDeparture::new(self.looked, self.sun);
        let (ball, ball_radius) = self.ball;
        let [by_less, by_more] = [-near, near].map(|more| {
            let radius = (ball_radius + more).max(0.0);
            exact.meets((ball, radius))
        });
        (by_less == by_more).then_some((self, by_less))
    }

    fn put_to(&self, leaving: &Leaving, tester: Method) -> Seen {
        let (center, radius) = self.ground();
        let left = (leaving.leave)(center, radius, self.point, self.sun, self.precision);
        let left = left.expect("the sphere is of ordinary size");
        let is_met = |(center, radius)| {
            let case = Case {
                center,
                radius,
                ray: left.ray,
            };
            case.put_to(&tester, left.t_min, f64::INFINITY).is_some()
        };
        let moved = (left.ray.origin - self.point).length();
        Seen {
            is_dark: is_met(self.ground()) || is_met(self.ball),
            passed_over: (moved + left.t_min * self.sun.length()) / radius,
        }
    }
}

fn power_of_ten(exponent: i32) -> f64 {
    let power = (0..exponent.abs()).fold(1.0, |power, _| 10.0 * power);
    if exponent < 0 { 1.0 / power } else { power }
}

/// From ½ to 1, halved up to `times` − 1 times: all sizes are alike.
fn halved(random: &mut Random, times: u32) -> f64 {
    let size = random.between(0.5, 1.0);
    (0..random.below(times)).fold(size, |size, _| size / 2.0)
}

/// A unit vector at a right angle to `normal`.
fn across(random: &mut Random, normal: Vec3) -> Vec3 {
    normal.cross(random.direction()).normalize()
}
