//! Throughput: one ray against one sphere.

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};
use measure::contest::{Contest, Contestant};
use measure::cost::{
    DoubleQuestion, PixelQuestion, contest_of_methods, loop_over, questions_of_cases,
    questions_of_pixels,
};
use speed_vs_accuracy::{Precision, REGIMES, Regime, SPHERES, certified_hit};

/// The number of questions of a loop: so many that no processor learns their answers by heart.
pub(crate) const CASES: usize = 16_384;

/// The seed of the random questions.
const SEED: u64 = 1;

/// Returns two contests over rays of the book in the picture's order, the second only over rays
/// that hit: all methods, chapter 5's `hit`, which fills a record, and a loop that only makes the
/// rays.
pub(crate) fn in_order() -> [Contest; 2] {
    [("book", false), ("all_hits", true)].map(|(place, only_hits)| {
        let asked = asked(only_hits);
        let mut contestants =
            contest_of_methods(place, &questions_of_pixels(camera(), asked.clone()));
        let record = |((center, radius), ray): DoubleQuestion| {
            Sphere::new(center, radius).hit(&ray, 0.0, f64::INFINITY)
        };
        let nothing = |(_, ray): DoubleQuestion| ray.direction.element_sum();
        contestants.push(contestant(["record", "half_b", place], &asked, record));
        contestants.push(contestant(["ray", "nothing", place], &asked, nothing));
        contestants
    })
}

/// Returns a contest of all methods for each regime but that of the book.
pub(crate) fn elsewhere() -> impl Iterator<Item = Contest> {
    let regimes = REGIMES
        .into_iter()
        .filter(|regime| regime.name != Regime::BOOK.name);
    regimes.map(|regime| {
        let [double, single] = Precision::ALL.map(|it| regime.cases(it, SEED, CASES));
        contest_of_methods(regime.name, &questions_of_cases(&double, &single))
    })
}

/// The camera of the book.
fn camera() -> Camera {
    Camera::new(400)
}

/// Chooses pixels that are spread over the book's picture, in its order, each with both spheres;
/// with `only_hits`, only those whose ray hits the sphere.
fn asked(only_hits: bool) -> Vec<PixelQuestion> {
    let camera = camera();
    let pixels =
        (0..camera.image_height).flat_map(|j| (0..camera.image_width).map(move |i| [i, j]));
    let all = pixels.flat_map(|pixel| SPHERES.map(|sphere| (pixel, sphere)));
    let hits = |&([i, j], (center, radius)): &PixelQuestion| {
        certified_hit(center, radius, &camera.ray(i, j), 0.0, f64::INFINITY).is_some()
    };
    let all: Vec<PixelQuestion> = all.filter(|asked| !only_hits || hits(asked)).collect();
    // Two by two, so that a pixel keeps its second sphere.
    let kept = (0..CASES / 2).map(|k| all.len() / 2 * k / (CASES / 2));
    kept.flat_map(|k| [all[2 * k], all[2 * k + 1]]).collect()
}

/// Makes a loop over these questions, with a function that answers them.
fn contestant<T: 'static>(
    key: [&str; 3],
    asked: &[PixelQuestion],
    answer: impl Fn(DoubleQuestion) -> T + 'static,
) -> Contestant {
    let (camera, asked) = (camera(), asked.to_vec());
    let run = loop_over(CASES, move |n| {
        let ([i, j], sphere) = asked[n];
        answer((sphere, camera.ray(i, j)))
    });
    Contestant::new(key, Precision::Double, CASES, run)
}
