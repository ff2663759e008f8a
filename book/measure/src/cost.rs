//! Throughput: the time of a question by each method, on this computer.
//!
//! Each method is compiled into a loop of its own, as a renderer would have it: the loop
//! makes a ray, asks, and has a t. The processor works at several questions at once, as
//! none needs the answer to another.

use std::hint::black_box;

use common::rtweekend::*;
use glam::Vec3 as SingleVec3;
use speed_vs_accuracy::{Case, METHODS, Precision, SingleRay};

use crate::contest::{Contest, Contestant};

/// Questions to methods for a loop, numbered from 0: a function that makes a question in `f64` from
/// its number, and one that makes it in `f32`.
pub struct Questions<D, S> {
    count: usize,
    double: D,
    single: S,
}

/// A question to a method in `f64`: a center and a radius, and a ray, with t from 0 to infinity.
pub type DoubleQuestion = ((Point3, f64), Ray);

/// A question to a method in `f32`: a center and a radius, and a ray, with t from 0 to infinity.
pub type SingleQuestion = ((SingleVec3, f32), SingleRay);

/// The column and the row of a pixel, counted from 0 at the top left, and the center and the radius
/// of the sphere that its ray is tested against.
pub type PixelQuestion = ([u32; 2], (Point3, f64));

/// Makes questions that lie ready in memory: those for methods in `f64` from `double`, and those for
/// methods in `f32` from `single`, which has to be as long.
pub fn questions_of_cases(
    double: &[Case],
    single: &[Case],
) -> Questions<
    impl Fn(usize) -> DoubleQuestion + Clone + use<>,
    impl Fn(usize) -> SingleQuestion + Clone + use<>,
> {
    let in_single = |case: &Case| {
        let sphere = (case.center.as_vec3(), case.radius as f32);
        (sphere, case.single_ray())
    };
    let single: Vec<SingleQuestion> = single.iter().map(in_single).collect();
    let in_double = |case: &Case| ((case.center, case.radius), case.ray);
    let double: Vec<DoubleQuestion> = double.iter().map(in_double).collect();
    Questions {
        count: double.len(),
        double: move |n: usize| double[n],
        single: move |n: usize| single[n],
    }
}

/// Makes questions from pixels and spheres. The ray of a pixel is computed when its question is
/// asked, as a renderer would. The range of t begins at 0.
pub fn questions_of_pixels(
    camera: Camera,
    asked: Vec<PixelQuestion>,
) -> Questions<impl Fn(usize) -> DoubleQuestion + Clone, impl Fn(usize) -> SingleQuestion + Clone> {
    let [first, right, below] = [(0, 0), (1, 0), (0, 1)].map(|(i, j)| camera.ray(i, j).direction);
    let first_single = first.as_vec3();
    let [right, below] = [right, below].map(|next| (next - first).as_vec3());
    let in_single =
        |([i, j], (center, radius)): &PixelQuestion| ([*i, *j], (center.as_vec3(), *radius as f32));
    let in_single: Vec<_> = asked.iter().map(in_single).collect();
    Questions {
        count: asked.len(),
        double: move |n: usize| {
            let ([i, j], sphere) = asked[n];
            (sphere, camera.ray(i, j))
        },
        single: move |n: usize| {
            let ([i, j], sphere) = in_single[n];
            let ray = SingleRay {
                origin: SingleVec3::ZERO,
                direction: first_single + i as f32 * right + j as f32 * below,
            };
            (sphere, ray)
        },
    }
}

/// A loop for each method: a function that is called by a pointer would be charged for the
/// call, and for the ray that is handed over in memory.
macro_rules! loops {
    ($(in $number:ident $precision:ident: $question:ident, $($method:ident)*;)*) => {
        /// Makes a contest of all methods, the reference first, over the same questions. `place` is
        /// the name of the regime or the scene, for the rows.
        pub fn contest_of_methods<D, S>(place: &str, asked: &Questions<D, S>) -> Contest
        where
            D: Fn(usize) -> DoubleQuestion + Clone + 'static,
            S: Fn(usize) -> SingleQuestion + Clone + 'static,
        {
            vec![$($({
                let (question, count) = (asked.$question.clone(), asked.count);
                let run = loop_over(count, move |n| {
                    let ((center, radius), ray) = question(n);
                    let end = $number::INFINITY;
                    speed_vs_accuracy::$method(center, radius, &ray, 0.0, end)
                });
                let key = ["method", stringify!($method), place];
                Contestant::new(key, Precision::$precision, count, run)
            }),*),*]
        }

        const LOOPS: usize = [$($(stringify!($method)),*),*].len();
        const _: () = assert!(LOOPS == METHODS.len(), "a new method needs a loop");
    };
}

loops! {
    in f64 Double: double, half_b half_b_q cross_q compensated certified_hit certified_t double_double exact;
    in f32 Single: single, half_b_f32 widened_half_b_q_f32;
}

/// Makes a loop that calls `answer` with the numbers 0 to `count` − 1 whenever it is run, so that
/// the processor may work at several questions at once. The compiler has to put each answer into
/// memory before it goes on, and so can't merge questions into vector instructions.
pub fn loop_over<T>(count: usize, answer: impl Fn(usize) -> T) -> impl FnMut() {
    move || {
        for n in 0..count {
            black_box(answer(n));
        }
    }
}
