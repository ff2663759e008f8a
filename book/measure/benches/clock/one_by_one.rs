//! Latency: one ray against one sphere, one after the other.
//!
//! Each method is compiled into a loop of its own, as a renderer would have it.
//! The loop hides each case from the compiler, which therefore cannot take
//! several at once: that is what many.rs measures.

use std::hint::black_box;

use common::rtweekend::*;
use measure::accuracy::has_root;
use speed_vs_accuracy::{Case, METHODS, Method, Precision, REGIMES, SingleRay};

use crate::contest::{Group, Runner};

/// So many cases fit into the fastest cache.
pub(crate) const CASES: usize = 256;

/// All methods, in each regime and where all rays hit.
pub(crate) fn groups() -> Vec<Group> {
    let regimes = REGIMES.iter().skip(1);
    let mut groups = vec![
        group("book", |precision| book_rays(precision, |_| true)),
        group("all_hits", |precision| book_rays(precision, has_root)),
    ];
    groups.extend(regimes.map(|regime| {
        group(regime.name, |precision| {
            regime.cases(precision, SEED, CASES)
        })
    }));
    groups
}

/// `half_b` on the book’s camera rays, to compare others with.
pub(crate) fn reference() -> Runner {
    Runner {
        is_wanted: false,
        ..runner(
            &Method::REFERENCE,
            "book",
            &book_rays(Precision::Double, |_| true),
        )
    }
}

/// Rays of the book’s camera from left to right and from top to bottom, first at
/// the ball and then at the ground: those that are `wanted`.
pub(crate) fn book_rays(precision: Precision, wanted: impl Fn(&Case) -> bool) -> Vec<Case> {
    let camera = Camera::new(400);
    let ball = (Point3::new(0.0, 0.0, -1.0), 0.5);
    let ground = (Point3::new(0.0, -100.5, -1.0), 100.0);
    let all: Vec<Case> = [ball, ground]
        .into_iter()
        .flat_map(|(center, radius)| {
            let pixels =
                (0..camera.image_height).flat_map(|j| (0..camera.image_width).map(move |i| (i, j)));
            pixels.map(move |(i, j)| Case {
                center,
                radius,
                ray: camera.ray(i, j),
            })
        })
        .map(|case| case.rounded(precision))
        .filter(wanted)
        .collect();
    // Spread over the picture, and in its order.
    (0..CASES).map(|k| all[k * all.len() / CASES]).collect()
}

/// Which cases.
pub(crate) const SEED: u64 = 1;

fn group(place: &str, cases: impl Fn(Precision) -> Vec<Case>) -> Group {
    let runners = METHODS
        .iter()
        .map(|method| runner(method, place, &cases(method.precision())));
    let (half_b, others): (Vec<Runner>, Vec<Runner>) =
        runners.partition(|runner| runner.row.name == Method::REFERENCE.name);
    Group(half_b.into_iter().chain(others).collect())
}

fn runner(method: &Method, place: &str, cases: &[Case]) -> Runner {
    let key = ["method", method.name, place];
    let count = cases.len();
    let run = run(method.name, cases);
    Runner::new(key, method.precision(), count, count, run)
}

/// A loop for each method: a function that is called by a pointer would be
/// charged for the call.
macro_rules! loops {
    (in f64: $($double:ident)*; in f32: $($single:ident)*;) => {
        fn run(name: &str, cases: &[Case]) -> Box<dyn FnMut()> {
            match name {
                $(stringify!($double) => Box::new(double(cases, speed_vs_accuracy::$double)),)*
                $(stringify!($single) => Box::new(single(cases, speed_vs_accuracy::$single)),)*
                other => panic!("name {other} in the list of loops"),
            }
        }

        const LOOPS: usize = [$(stringify!($double),)* $(stringify!($single)),*].len();
        const _: () = assert!(LOOPS == METHODS.len(), "a new method needs a loop");
    };
}

loops! {
    in f64: full_b half_b half_b_q haines haines_q kahan_q cross_q adaptive_q scaled_q herbie interval_q
        certified_hit certified_t double_double exact;
    in f32: half_b_f32 half_b_q_f32 cross_q_f32 widened_half_b_q_f32 certified_f32;
}

fn double(
    cases: &[Case],
    solve: impl Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> + 'static,
) -> impl FnMut() + 'static {
    let cases = cases.to_vec();
    let mut answers = vec![None; cases.len()];
    move || {
        for (case, answer) in cases.iter().zip(&mut answers) {
            let Case {
                center,
                radius,
                ray,
            } = black_box(case);
            *answer = solve(*center, *radius, ray, 0.0, f64::INFINITY);
        }
        black_box(&mut answers);
    }
}

fn single(
    cases: &[Case],
    solve: impl Fn(glam::Vec3, f32, &SingleRay, f32, f32) -> Option<f32> + 'static,
) -> impl FnMut() + 'static {
    let in_single = |case: &Case| {
        let Case { center, radius, .. } = case;
        (center.as_vec3(), *radius as f32, case.single_ray())
    };
    let cases: Vec<(glam::Vec3, f32, SingleRay)> = cases.iter().map(in_single).collect();
    let mut answers = vec![None; cases.len()];
    move || {
        for (case, answer) in cases.iter().zip(&mut answers) {
            let (center, radius, ray) = black_box(case);
            *answer = solve(*center, *radius, ray, 0.0, f32::INFINITY);
        }
        black_box(&mut answers);
    }
}
