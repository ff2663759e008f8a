//! SIMD lanes: the time of a question if a block of them is asked at once.
//!
//! The compiler turns a loop over a block into instructions for several questions at the
//! same time: many rays against one sphere, as a camera asks. The numbers of a block lie
//! side by side, as a structure of arrays.

use std::hint::black_box;

use common::rtweekend::*;
use glam::Vec3 as SingleVec3;
use speed_vs_accuracy::{BLOCK, Case, Precision, SPHERES, SingleRay, certified_in_lanes, in_lanes};

use crate::contest::{Contest, Contestant};

/// A block of questions: the x, y and z of origins and of directions, and the sphere's center and
/// radius.
type LaneBlock<T> = ([[T; BLOCK]; 6], [T; 4]);

/// The block's questions with one method: the certified ones have lanes of their own.
macro_rules! ask {
    (certified_hit $answers:ident $number:ident $t_min:ident $center:expr, $radius:expr, $ray:expr) => {
        ask!(@certified false $answers $t_min $center, $radius, $ray)
    };
    (certified_t $answers:ident $number:ident $t_min:ident $center:expr, $radius:expr, $ray:expr) => {
        ask!(@certified true $answers $t_min $center, $radius, $ray)
    };
    (@certified $ulp:literal $answers:ident $t_min:ident $center:expr, $radius:expr, $ray:expr) => {
        certified_in_lanes::<$ulp>(
            &mut $answers,
            #[inline(always)]
            |k| Case::new($center, $radius, $ray(k)),
            $t_min,
            f64::INFINITY,
        )
    };
    ($method:ident $answers:ident $number:ident $t_min:ident $center:expr, $radius:expr, $ray:expr) => {
        in_lanes(
            &mut $answers,
            #[inline(always)]
            |k| {
                let (end, ray) = ($number::INFINITY, $ray(k));
                speed_vs_accuracy::$method($center, $radius, &ray, $t_min, end).unwrap_or(end)
            },
        )
    };
}

/// A loop for each method.
macro_rules! contestants {
    ($blocks:ident, $place:literal, $from:expr, $(in $number:ident $ray:ident $point:ident $precision:ident: $($method:ident)*;)*) => {{
        let mut contestants = Vec::new();
        $(
            let t_min: $number = black_box($from);
            let blocks: Vec<LaneBlock<$number>> = $blocks.iter().map(|(rays, sphere)| (
                rays.map(|row| row.map(|x| x as $number)), sphere.map(|x| x as $number)
            )).collect();
            let count = blocks.len() * BLOCK;
            $({
                let blocks = blocks.clone();
                let run = move || for (rays, [x, y, z, radius]) in &blocks {
                    let mut answers = [0.0; BLOCK];
                    let ray = |k: usize| {
                        let [qx, qy, qz, dx, dy, dz] = rays.each_ref().map(|row| row[k]);
                        $ray::new($point::new(qx, qy, qz), $point::new(dx, dy, dz))
                    };
                    ask!($method answers $number t_min $point::new(*x, *y, *z), *radius, ray);
                    black_box(&answers);
                };
                let key = ["rays", stringify!($method), $place];
                contestants.push(Contestant::new(key, Precision::$precision, count, run));
            })*
        )*
        contestants
    }};
}

/// Returns the contests of methods that answer a block of questions at once: one over the range of
/// t from 0, where signs decide, and one over the range from 0.001. The first ends with two loops
/// that compute less than any method, as limits.
pub fn contests() -> [Contest; 2] {
    let blocks = blocks();
    let in_any_range = contestants! { blocks, "any_range", 0.001,
        in f64 Ray Point3 Double: half_b half_b_q certified_hit certified_t;
    };
    let mut contestants = contestants! { blocks, "book", 0.0,
        in f64 Ray Point3 Double:
            half_b half_b_q cross_q compensated certified_hit certified_t double_double;
        in f32 SingleRay SingleVec3 Single: half_b_f32 widened_half_b_q_f32 certified_f32;
    };
    let divided = |[_, _, _, x, y, z]: [f64; 6]| (1.5 + x * x).sqrt() / (2.0 + y) + x / z;
    contestants.push(limit("divider", blocks.clone(), divided));
    let read = |[x, y, z, dx, dy, dz]: [f64; 6]| ((x + y) + (z + dx)) + (dy + dz);
    contestants.push(limit("memory", blocks, read));
    [Contest(contestants), Contest(in_any_range)]
}

/// Makes a loop over the same blocks with less arithmetic than any method needs: a limit for all of
/// them.
fn limit(
    name: &str,
    blocks: Vec<LaneBlock<f64>>,
    answer: impl Fn([f64; 6]) -> f64 + 'static,
) -> Contestant {
    let count = blocks.len() * BLOCK;
    let run = move || {
        for (rays, _) in &blocks {
            let mut answers = [0.0; BLOCK];
            in_lanes(
                &mut answers,
                #[inline(always)]
                |k| answer(rays.each_ref().map(|row| row[k])),
            );
            black_box(&answers);
        }
    };
    Contestant::new(["limit", name, "book"], Precision::Double, count, run)
}

/// Makes blocks of rays of the book's camera from all over the picture, each twice: with the ball
/// and with the ground.
fn blocks() -> Vec<LaneBlock<f64>> {
    let camera = Camera::new(400);
    let spheres = SPHERES.map(|(center, radius)| [center.x, center.y, center.z, radius]);
    let rows = (0..camera.image_height).step_by(9);
    let starts = rows.flat_map(|j| (0..400 / BLOCK as u32).map(move |n| (n * BLOCK as u32, j)));
    starts
        .flat_map(|(i, j)| {
            spheres.map(|sphere| {
                let mut rays = [[0.0; BLOCK]; 6];
                for k in 0..BLOCK {
                    let Ray { origin, direction } = camera.ray(i + k as u32, j);
                    let numbers = origin.to_array().into_iter().chain(direction.to_array());
                    for (row, number) in rays.iter_mut().zip(numbers) {
                        row[k] = number;
                    }
                }
                (rays, sphere)
            })
        })
        .collect()
}
