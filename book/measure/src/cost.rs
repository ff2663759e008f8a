//! Latency: what one question after the other takes by each method, here and now.
//!
//! Each method is compiled into a loop of its own, as a renderer would have it. The
//! loop hides each question from the compiler, which therefore cannot take several at
//! once.

use std::hint::black_box;

use common::rtweekend::*;
use speed_vs_accuracy::{
    Case, Eye, METHODS, Method, Precision, Scene, SingleRay, T_MIN_OF_SHADOWS,
};

use crate::contest::{Effort, Group, Runner};

/// The times of each method, the reference first, in nanoseconds for a question of
/// `scene`: as many as there are rounds. Each `round` is told when it is over.
pub fn times(scene: &Scene, effort: &Effort, round: impl Fn()) -> Vec<(Method, Vec<f64>)> {
    let asked = questions(scene);
    let mut methods: Vec<Method> = METHODS.to_vec();
    methods.sort_by_key(|method| method.name != Method::REFERENCE.name);
    let runner = |method: &Method| {
        let key = ["method", method.name, &scene.name];
        let count = asked.len();
        Runner::new(key, method.precision(), count, count, run(method, &asked))
    };
    let mut group = Group(methods.iter().map(runner).collect());
    let times = group.times(effort, round);
    methods.into_iter().zip(times).collect()
}

/// So many cases fit into the fastest cache, as in the benchmark.
const CASES: usize = 256;

/// A ray and a sphere, and where the range of t begins.
pub type Question = (Case, f64);

/// Camera rays and spheres, spread over the picture and in its order; where there is
/// a sun, so many rays to it again.
fn questions(scene: &Scene) -> Vec<Question> {
    let camera = Camera::new(scene.width);
    let spheres = scene.spheres.len();
    let pixels = camera.image_width as usize * camera.image_height as usize;
    let all = (0..CASES).map(|k| k * pixels * spheres / CASES);
    let asked = all.flat_map(|n| {
        let width = scene.width as usize;
        let (i, j) = (n / spheres % width, n / spheres / width);
        let seen = camera.ray(i as u32, j as u32);
        let (center, radius) = scene.spheres[n % spheres];
        let case = |ray| Case {
            center,
            radius,
            ray,
        };
        let to_sun = scene.sun.and_then(|sun| {
            let hit = scene.look(Eye::Exact(Precision::Double), &seen).hit?;
            Some((case(Ray::new(hit.point, sun)), T_MIN_OF_SHADOWS))
        });
        [Some((case(scene.ray(&seen)), 0.0)), to_sun]
    });
    asked.flatten().collect()
}

/// A loop for each method: a function that is called by a pointer would be
/// charged for the call.
macro_rules! loops {
    (in f64: $($double:ident)*; in f32: $($single:ident)*;) => {
        /// Puts all questions to the method, one after the other.
        ///
        /// # Panics
        /// If it is none of [`METHODS`].
        pub fn run(method: &Method, asked: &[Question]) -> Box<dyn FnMut()> {
            match method.name {
                $(stringify!($double) => Box::new(double(asked, speed_vs_accuracy::$double)),)*
                $(stringify!($single) => Box::new(single(asked, speed_vs_accuracy::$single)),)*
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
    asked: &[Question],
    solve: impl Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> + 'static,
) -> impl FnMut() + 'static {
    let asked = asked.to_vec();
    let mut answers = vec![None; asked.len()];
    move || {
        for (question, answer) in asked.iter().zip(&mut answers) {
            let (case, t_min) = black_box(question);
            *answer = solve(case.center, case.radius, &case.ray, *t_min, f64::INFINITY);
        }
        black_box(&mut answers);
    }
}

fn single(
    asked: &[Question],
    solve: impl Fn(glam::Vec3, f32, &SingleRay, f32, f32) -> Option<f32> + 'static,
) -> impl FnMut() + 'static {
    let in_single = |(case, t_min): &Question| {
        let sphere = (case.center.as_vec3(), case.radius as f32);
        (sphere, case.single_ray(), *t_min as f32)
    };
    let asked: Vec<_> = asked.iter().map(in_single).collect();
    let mut answers = vec![None; asked.len()];
    move || {
        for (question, answer) in asked.iter().zip(&mut answers) {
            let ((center, radius), ray, t_min) = black_box(question);
            *answer = solve(*center, *radius, ray, *t_min, f32::INFINITY);
        }
        black_box(&mut answers);
    }
}
