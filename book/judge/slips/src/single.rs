//! Single precision: the chapters in `f32`, as in version 1 of the book.
//!
//! It replaces every step from camera to color, so other slips in those steps have no
//! effect.

use common::rtweekend::{Camera, Color};

use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::program::{Ball, Program};

type Vector = [f32; 3];

/// The color of a pixel, with every operation rounded to 24 bits.
pub(super) fn color(program: &Program, camera: &Camera, i: u32, j: u32) -> Color {
    let [x, y] = on_viewport(program, camera, i, j);
    let direction = [x, y, -(program.focal_length as f32)];
    let color = nearest(program, direction)
        .map(|(t, ball)| shade(program, t, ball, direction))
        .unwrap_or_else(|| sky(program, direction));
    Color::from_array(color.map(f64::from))
}

fn on_viewport(program: &Program, camera: &Camera, i: u32, j: u32) -> [f32; 2] {
    let [width, height] = [camera.image_width, camera.image_height].map(f64::from);
    let ratio = (program.viewport_ratio)(width, height, program.aspect_ratio) as f32;
    let divisors = program.divided(camera.image_width, camera.image_height);
    let divisors = divisors.map(|divisor| divisor as f32);
    let at = program.seen(camera, i, j).map(|place| place as f32);
    let is_from_below = program.edition.counts_from_below();
    let axis = |n: usize, viewport: f32| {
        if is_from_below {
            return -0.5 * viewport + at[n] / divisors[n] * viewport;
        }
        let delta = viewport * (1.0 / divisors[n]);
        (-0.5 * viewport + 0.5 * delta) + at[n] * delta
    };
    let high = program.viewport_height as f32;
    let down = if is_from_below { high } else { -high };
    [axis(0, high * ratio), axis(1, down)]
}

fn nearest(program: &Program, direction: Vector) -> Option<(f32, Ball)> {
    let mut found = None;
    let mut closest_so_far = f32::INFINITY;
    for &ball in program.world.iter() {
        let root = roots(ball, direction).and_then(|[near, far]| {
            let in_range = |t: f32| program.t_min < f64::from(t) && t < closest_so_far;
            match program.chapter {
                Chapter::HittableList if !in_range(near) => Some(far).filter(|&t| in_range(t)),
                _ => Some(near).filter(|&t| in_range(t)),
            }
        });
        if let Some(t) = root {
            closest_so_far = t;
            found = Some((t, ball));
        }
    }
    found
}

/// Both roots from half of b: the full formula has the same ones to the bit.
fn roots(ball: Ball, direction: Vector) -> Option<[f32; 2]> {
    let oc = ball.center.to_array().map(|x| x as f32);
    let radius = ball.radius as f32;
    let a = dot(direction, direction);
    let h = dot(direction, oc);
    let c = dot(oc, oc) - radius * radius;
    let discriminant = h * h - a * c;
    (discriminant >= 0.0).then(|| {
        let sqrtd = discriminant.sqrt();
        [(h - sqrtd) / a, (h + sqrtd) / a]
    })
}

fn shade(program: &Program, t: f32, ball: Ball, direction: Vector) -> Vector {
    let chapter = program.chapter;
    if chapter == Chapter::RedSphere {
        return program.paint.to_array().map(|component| component as f32);
    }
    let center = ball.center.to_array().map(|x| x as f32);
    let outward = [0, 1, 2].map(|axis| t * direction[axis] - center[axis]);
    let normal = match chapter {
        Chapter::HittableList => {
            let outward = outward.map(|x| x * (1.0 / ball.radius as f32));
            let against = dot(direction, outward) < 0.0;
            outward.map(|x| if against { x } else { -x })
        }
        _ => unit(program, outward),
    };
    normal.map(|x| 0.5 * (x + 1.0))
}

fn sky(program: &Program, direction: Vector) -> Vector {
    let a = 0.5 * (unit(program, direction)[1] + 1.0);
    let [below, above] = program.sky.map(|color| color.to_array());
    [0, 1, 2].map(|n| (1.0 - a) * below[n] as f32 + a * above[n] as f32)
}

fn unit(program: &Program, v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    match program.edition {
        Edition::V1 | Edition::V1InDouble => v.map(|x| x / length),
        _ => v.map(|x| x * (1.0 / length)),
    }
}

fn dot(u: Vector, v: Vector) -> f32 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}
