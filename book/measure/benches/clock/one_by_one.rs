//! Latency: one ray against one sphere, one after the other.

use common::rtweekend::*;
use measure::accuracy::has_root;
use measure::contest::{Group, Runner};
use measure::cost::{Question, run};
use speed_vs_accuracy::{Case, METHODS, Method, Precision, REGIMES};

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
    let questions: Vec<Question> = cases.iter().map(|case| (*case, 0.0)).collect();
    let run = run(method, &questions);
    Runner::new(key, method.precision(), count, count, run)
}
