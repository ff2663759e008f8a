//! Levenberg–Marquardt: the camera through which the book's sky is seen, whatever it is.
//!
//! A color of the sky tells the y of its unit direction. Directions are those of a plane one
//! unit away, on which pixels lie in a grid; where the grid is and how it leans is fitted.

use common::rtweekend::Vec3;

use super::Surface;
use super::cone::Eye;
use super::uniform;
use crate::explanations::spread;
use crate::reading::Reading;

/// How many pixels tell.
const LOOK: u32 = 500;
/// One of so many may be none of the sky's.
const SOME: usize = 50;
/// The y of unit directions that are a level apart, in red: half of a component, of 256 levels.
const LEVEL: f64 = 2.0 * 2.0 / 256.0;
/// What has fewer lies in a corner.
const FEW: usize = 50;
/// How much longer a pixel may be one way than the other.
const LONG: f64 = 4.0;
/// How often numbers are moved, unless no step is small enough to bring them nearer.
const STEPS: usize = 300;
const MOST_DAMPED: f64 = 1e9;

/// The x and y of a pixel's direction, each a sum of 1, its column and its row.
type Numbers = [f64; 6];

/// A pixel's terms of these sums, and the y of its unit direction.
type Point = ([f64; 3], f64);

/// The eye that sees a surface as the book's sky, if one does.
pub(super) fn of(surface: &Surface, reading: &Reading) -> Option<Eye> {
    let middle = [reading.width, reading.height].map(|size| 0.5 * f64::from(size - 1));
    let points = points(surface, reading, middle)?;
    let ratio = middle[0] / middle[1];
    let starts = [
        [0.0, ratio, 0.0, 0.0, 0.0, 1.0],
        // Upside down, and with rows and columns exchanged.
        [0.0, ratio, 0.0, 0.0, 0.0, -1.0],
        [0.0, 0.0, 1.0, 0.0, ratio, 0.0],
        [0.0, 0.0, 1.0, 0.0, -ratio, 0.0],
    ];
    let found = starts.into_iter().map(|it| fitted(&points, it));
    let found = found.min_by(|one, other| off(&points, one).total_cmp(&off(&points, other)))?;
    let is_far = |it: &&Point| residual(&found, it).abs() > 1.5 * LEVEL;
    let is_near = SOME * points.iter().filter(is_far).count() <= points.len();
    eye(mirrored_back(found), reading, middle).filter(|_| is_near)
}

/// Some pixels of a surface, if almost all of them have colors of the sky.
fn points(surface: &Surface, reading: &Reading, middle: [f64; 2]) -> Option<Vec<Point>> {
    let point = |at: u32| {
        let n = surface.inner[at as usize];
        let [i, j] = [n % reading.width, n / reading.width].map(f64::from);
        let terms = [1.0, i / middle[0] - 1.0, 1.0 - j / middle[1]];
        Some((terms, uniform::height(reading.pixels[n as usize])?))
    };
    let count = surface.inner.len().min(LOOK as usize);
    let points: Vec<Point> = spread(LOOK, surface.inner.len() as u32)
        .filter_map(point)
        .collect();
    let are_most = SOME * (count - points.len()) <= count;
    (are_most && points.len() >= FEW).then_some(points)
}

/// The eye with those numbers, if its pixels lie in a grid: nobody's are much longer one way than
/// the other, nor do rows lead along columns.
fn eye(numbers: Numbers, reading: &Reading, middle: [f64; 2]) -> Option<Eye> {
    let direction = |column: f64, row: f64| {
        let [x, y] = plane(&numbers, &[1.0, column, row]);
        Vec3::new(x, y, -1.0)
    };
    let corner = direction(-1.0, 1.0);
    let across = (direction(1.0, 1.0) - corner) / (2.0 * middle[0]);
    let down = (direction(-1.0, -1.0) - corner) / (2.0 * middle[1]);
    let [one, other] = [across.length(), down.length()];
    let are_alike = one < LONG * other && other < LONG * one;
    let is_a_grid = are_alike && across.cross(down).length() > 0.5 * one * other;
    is_a_grid.then(|| Eye::of(reading, corner, across, down))
}

/// The sky is its own mirror image, and rows that lead to the right are likelier.
fn mirrored_back([x, right, up, y, rising, high]: Numbers) -> Numbers {
    let sign = if right.abs() > up.abs() {
        right.signum()
    } else {
        1.0
    };
    [sign * x, sign * right, sign * up, y, rising, high]
}

/// The numbers near these with which residuals are least.
fn fitted(points: &[Point], start: Numbers) -> Numbers {
    let (mut numbers, mut damping) = (start, 1e-3);
    let mut least = off(points, &numbers);
    for _ in 0..STEPS {
        if damping > MOST_DAMPED {
            break;
        }
        let step = step(points, &numbers, damping);
        let moved = std::array::from_fn(|n| numbers[n] - step[n]);
        match off(points, &moved) {
            off if off < least => (least, numbers, damping) = (off, moved, damping / 4.0),
            _ => damping *= 8.0,
        }
    }
    numbers
}

fn off(points: &[Point], numbers: &Numbers) -> f64 {
    points.iter().map(|it| residual(numbers, it).powi(2)).sum()
}

fn residual(numbers: &Numbers, (terms, height): &Point) -> f64 {
    let [x, y] = plane(numbers, terms);
    y / (x * x + y * y + 1.0).sqrt() - height
}

fn plane(numbers: &Numbers, terms: &[f64; 3]) -> [f64; 2] {
    let sum = |from: usize| (0..3).map(|n| numbers[from + n] * terms[n]).sum();
    [sum(0), sum(3)]
}

/// By which numbers are too large, if residuals were linear and their squares damped.
fn step(points: &[Point], numbers: &Numbers, damping: f64) -> Numbers {
    let (mut matrix, mut vector) = ([[0.0; 6]; 6], [0.0; 6]);
    for point in points {
        let [x, y] = plane(numbers, &point.0);
        let length = (x * x + y * y + 1.0).sqrt();
        let by = [-x * y, 1.0 + x * x].map(|it| it / length.powi(3));
        let slopes: Numbers = std::array::from_fn(|n| by[n / 3] * point.0[n % 3]);
        let off = residual(numbers, point);
        for (n, slope) in slopes.iter().enumerate() {
            vector[n] += slope * off;
            for (m, other) in slopes.iter().enumerate() {
                matrix[n][m] += slope * other;
            }
        }
    }
    for (n, row) in matrix.iter_mut().enumerate() {
        row[n] += damping * (row[n] + 1e-6 * points.len() as f64);
    }
    solved(matrix, vector)
}

/// The solution of a positive definite system, by elimination.
fn solved(mut matrix: [[f64; 6]; 6], mut vector: Numbers) -> Numbers {
    for n in 0..6 {
        for m in n + 1..6 {
            let (above, below) = matrix.split_at_mut(m);
            let times = below[0][n] / above[n][n];
            let row = below[0].iter_mut().zip(&above[n]);
            row.for_each(|(it, pivot)| *it -= times * pivot);
            vector[m] -= times * vector[n];
        }
    }
    for n in (0..6).rev() {
        for m in n + 1..6 {
            vector[n] -= matrix[n][m] * vector[m];
        }
        vector[n] /= matrix[n][n];
    }
    vector
}
