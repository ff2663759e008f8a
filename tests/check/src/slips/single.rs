//! Single precision: the chapters in `f32`, a slip in all steps at once.
//!
//! So it stands in for the steps from camera to color, and a second slip shows
//! beside it only if it is in the scene or in the file.

use common::rtweekend::{Camera, Color};

use super::program::{Ball, Program};
use crate::chapter::Chapter;

type Vector = [f32; 3];

/// The color of a pixel, with every operation rounded to 24 bits.
pub(super) fn color(program: &Program, camera: &Camera, i: u32, j: u32) -> Color {
    let [x, y] = on_viewport(camera, i as f32, j as f32);
    let direction = [x, y, -(program.focal_length as f32)];
    let color = nearest(program, direction)
        .map(|(t, ball)| shade(program.chapter, t, ball, direction))
        .unwrap_or_else(|| sky(direction));
    Color::from_array(color.map(f64::from))
}

fn on_viewport(camera: &Camera, i: f32, j: f32) -> [f32; 2] {
    let [width, height] = [camera.image_width, camera.image_height].map(|size| size as f32);
    let viewport = [2.0 * (width / height), -2.0];
    let delta = [viewport[0] * (1.0 / width), viewport[1] * (1.0 / height)];
    let pixel00 = [0, 1].map(|axis| -0.5 * viewport[axis] + 0.5 * delta[axis]);
    [pixel00[0] + i * delta[0], pixel00[1] + j * delta[1]]
}

fn nearest(program: &Program, direction: Vector) -> Option<(f32, Ball)> {
    let mut found = None;
    let mut closest_so_far = f32::INFINITY;
    for &ball in program.world {
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

fn shade(chapter: Chapter, t: f32, ball: Ball, direction: Vector) -> Vector {
    if chapter == Chapter::RedSphere {
        return [1.0, 0.0, 0.0];
    }
    let center = ball.center.to_array().map(|x| x as f32);
    let outward = [0, 1, 2].map(|axis| t * direction[axis] - center[axis]);
    let normal = match chapter {
        Chapter::HittableList => {
            let outward = outward.map(|x| x * (1.0 / ball.radius as f32));
            let against = dot(direction, outward) < 0.0;
            outward.map(|x| if against { x } else { -x })
        }
        _ => unit(outward),
    };
    normal.map(|x| 0.5 * (x + 1.0))
}

fn sky(direction: Vector) -> Vector {
    let a = 0.5 * (unit(direction)[1] + 1.0);
    [0.5, 0.7, 1.0].map(|blue| (1.0 - a) + a * blue)
}

fn unit(v: Vector) -> Vector {
    let scale = 1.0 / dot(v, v).sqrt();
    v.map(|x| x * scale)
}

fn dot(u: Vector, v: Vector) -> f32 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}
