//! Throughput: many rays at a time, and what the divider allows.

use std::hint::black_box;

use common::rtweekend::*;
use speed_vs_accuracy::batch::{self, BLOCK, Block};
use speed_vs_accuracy::{Case, Precision};

use crate::one_by_one;
use measure::contest::{Group, Runner};

/// `half_b` in both precisions, and the divider.
pub(crate) fn group() -> Group {
    Group(vec![
        one_by_one::reference(),
        limit_one_by_one(),
        limit_packed(),
        limit_packed_f32(),
        in_double(),
        in_single(),
    ])
}

/// A sphere, and blocks of rays that are tried on it.
type Target<R> = ((Point3, f64), Vec<R>);

/// The camera’s rays, first at the ball and then at the ground.
fn targets<R>(precision: Precision, block: impl Fn(&[Case]) -> R) -> Vec<Target<R>> {
    let cases = one_by_one::book_rays(precision, |_| true);
    let [ball, ground] = [0, cases.len() / 2].map(|from| &cases[from..][..cases.len() / 2]);
    [ball, ground]
        .map(|cases| {
            let sphere = (cases[0].center, cases[0].radius);
            // Repeated, because a loop over two blocks is hardly one.
            let blocks = cases.chunks_exact(BLOCK).cycle().take(BLOCKS / 2);
            (sphere, blocks.map(&block).collect())
        })
        .into()
}

/// How many blocks there are: as many as just fit into the fastest cache.
const BLOCKS: usize = 8;

fn in_double() -> Runner {
    let targets = targets(Precision::Double, |cases| {
        Block::from_fn(|k| batch::numbers(&cases[k].ray))
    });
    let mut ts = [[0.0; BLOCK]; BLOCKS / 2];
    let key = ["batch", "half_b", "book"];
    Runner::new(key, Precision::Double, BLOCK, BLOCKS * BLOCK, move || {
        for (sphere, rays) in black_box(&targets) {
            batch::half_b(*sphere, rays, [0.0, f64::INFINITY], &mut ts);
            black_box(&mut ts);
        }
    })
}

fn in_single() -> Runner {
    let targets = targets(Precision::Single, |cases| {
        Block::from_fn(|k| batch::numbers(&cases[k].ray).map(|number| number as f32))
    });
    let mut ts = [[0.0; BLOCK]; BLOCKS / 2];
    let key = ["batch", "half_b_f32", "book"];
    Runner::new(key, Precision::Single, BLOCK, BLOCKS * BLOCK, move || {
        for ((center, radius), rays) in black_box(&targets) {
            let sphere = (center.as_vec3(), *radius as f32);
            batch::half_b_f32(sphere, rays, [0.0, f32::INFINITY], &mut ts);
            black_box(&mut ts);
        }
    })
}

/// Numbers of which roots and reciprocals can be taken for ever: they tend to 1,
/// and take their turns.
fn numbers() -> [f64; BLOCK] {
    std::array::from_fn(|k| 0.5 + k as f64 / BLOCK as f64)
}

fn limit_one_by_one() -> Runner {
    let mut numbers = numbers();
    let key = ["limit", "one_by_one", ""];
    Runner::new(key, Precision::Double, 1, BLOCK, move || {
        for number in &mut numbers {
            let [root, quotient] = black_box([*number; 2]);
            black_box((root.sqrt(), 1.0 / quotient));
        }
    })
}

fn limit_packed() -> Runner {
    let [mut roots, mut quotients] = [numbers(); 2];
    let key = ["limit", "packed", ""];
    Runner::new(key, Precision::Double, BLOCK, BLOCK, move || {
        batch::divider_limit(black_box(&mut roots), black_box(&mut quotients));
    })
}

fn limit_packed_f32() -> Runner {
    let [mut roots, mut quotients] = [numbers().map(|number| number as f32); 2];
    let key = ["limit", "packed", ""];
    Runner::new(key, Precision::Single, BLOCK, BLOCK, move || {
        batch::divider_limit_f32(black_box(&mut roots), black_box(&mut quotients));
    })
}
