//! A cone of rays by random sample consensus (Fischler and Bolles, 1981): the sphere whose outline is
//! seen.
//!
//! The rays that touch a sphere make the same angle with the one to its middle, so their
//! directions, as unit vectors, lie in a plane.

use common::rtweekend::{Point3, Vec3};
use glam::DMat3;

use super::Surface;
use crate::explanations::spread;
use crate::reading::Reading;

/// How many points of an outline are looked at, and how many cones are tried.
const LOOK: u32 = 600;
const CONES: usize = 200;
/// What has fewer is bounded by anything.
const FEW: usize = 12;
/// So near a cone a point lies on it, in pixels, and such a part of them has to.
const NEAR: f64 = 1.1;
const MOST: f64 = 0.5;
/// The same of one as wide as a ground's, which much looks like.
const MOST_WIDE: f64 = 0.9;
const WIDE: f64 = 0.7;
/// Of what lies in a cone one pixel in so many may be beside it.
const BESIDE: usize = 30;
/// What is smaller may be anything, in pixels.
const SMALLEST: f64 = 4.0;

/// Directions around one, as unit vectors.
pub(super) struct Cone {
    middle: Vec3,
    /// The cosine of the angle between that and the others.
    cosine: f64,
}

impl Cone {
    /// The cone that a surface is bounded by, if it is.
    pub(super) fn of(surface: &Surface, eye: &Eye) -> Option<Self> {
        let points = spread(LOOK, surface.outline.len() as u32);
        let points = points.map(|n| surface.outline[n as usize]);
        let points: Vec<Vec3> = points.map(|(i, j)| eye.unit(i, j)).collect();
        let count = points.len();
        if count < FEW {
            return None;
        }
        let on = |it: &Self| points.iter().filter(|point| it.has(**point, eye)).count();
        let through = |n: usize| {
            let three = [n, n + count / 3 + n % 7, n + 2 * count / 3 + n % 5];
            Self::through(three.map(|n| points[n % count]))
        };
        let cones = (0..CONES).filter_map(|n| through(n * count / CONES));
        let best = cones.max_by_key(on)?;
        let near: Vec<Vec3> = points
            .iter()
            .filter(|point| best.has(**point, eye))
            .copied()
            .collect();
        let best = Self::nearest_to(&near)?;
        let inner = spread(LOOK, surface.inner.len() as u32);
        let inner = inner.map(|n| surface.inner[n as usize]);
        let beside = inner.filter(|&n| eye.pixel_unit(n).dot(best.middle) < best.cosine);
        let is_inside = BESIDE * beside.count() <= surface.inner.len().min(LOOK as usize);
        let has_a_size = best.cosine.acos() > SMALLEST * eye.angle();
        let is_ahead = best.middle.z < -1e-3;
        let most = if best.cosine < WIDE { MOST_WIDE } else { MOST };
        let is_round = on(&best) as f64 >= most * count as f64;
        (is_round && is_inside && has_a_size && is_ahead).then_some(best)
    }

    /// Whether a direction is on it.
    fn has(&self, point: Vec3, eye: &Eye) -> bool {
        let off = self.middle.dot(point).clamp(-1.0, 1.0).acos() - self.cosine.acos();
        off.abs() <= NEAR * eye.angle() * point.z * point.z
    }

    /// The cone through three directions.
    fn through([one, two, three]: [Vec3; 3]) -> Option<Self> {
        let middle = (two - one).cross(three - one).try_normalize()?;
        let cosine = middle.dot(one);
        Some(Self {
            middle: cosine.signum() * middle,
            cosine: cosine.abs(),
        })
    }

    /// The plane in which directions lie, by least squares.
    fn nearest_to(points: &[Vec3]) -> Option<Self> {
        let squares = points.iter().map(|it| {
            let column = |part: f64| *it * part;
            DMat3::from_cols(column(it.x), column(it.y), column(it.z))
        });
        let squares = squares.fold(DMat3::ZERO, |sum, it| sum + it);
        let sum: Vec3 = points.iter().sum();
        let normal = squares.inverse() * sum;
        Some(Self {
            middle: normal.try_normalize()?,
            cosine: (1.0 / normal.length()).min(1.0),
        })
    }

    /// The sphere at z = -1 that is seen so: what is twice as far and twice as large looks the
    /// same.
    pub(super) fn sphere(&self) -> (Point3, f64) {
        let center = self.middle / -self.middle.z;
        let sine = (1.0 - self.cosine * self.cosine).sqrt();
        (center, center.length() * sine)
    }
}

/// A camera at the origin, whose pixels lie in a plane one unit away.
#[derive(Clone, Copy)]
pub(super) struct Eye {
    width: u32,
    height: u32,
    /// The direction of the first pixel's ray, and what it changes by from column to column, and
    /// from row to row.
    pub(super) first: Vec3,
    across: Vec3,
    down: Vec3,
}

impl Eye {
    /// One that looks straight ahead through a viewport of a width and a height.
    pub(super) fn new(reading: &Reading, [wide, high]: [f64; 2]) -> Self {
        let [columns, rows] = [reading.width, reading.height].map(f64::from);
        let across = Vec3::new(wide / columns, 0.0, 0.0);
        let down = Vec3::new(0.0, -high / rows, 0.0);
        let corner = Vec3::new(-0.5 * wide, 0.5 * high, -1.0);
        Self::of(reading, corner + 0.5 * (across + down), across, down)
    }

    pub(super) fn of(reading: &Reading, first: Vec3, across: Vec3, down: Vec3) -> Self {
        Self {
            width: reading.width,
            height: reading.height,
            first,
            across,
            down,
        }
    }

    /// What directions change by from one side of the picture to the other, and from the top to
    /// the bottom.
    pub(super) fn sides(&self) -> [Vec3; 2] {
        [
            f64::from(self.width) * self.across,
            f64::from(self.height) * self.down,
        ]
    }

    /// By how many columns and rows the picture is to the left of where its middle would be
    /// straight ahead, and above, and which part of its sides that is.
    pub(super) fn middle(&self) -> [(f64, f64); 2] {
        let sizes = [self.width, self.height].map(f64::from);
        let [columns, rows] = sizes.map(|size| 0.5 * (size - 1.0));
        let middle = self.through(columns, rows);
        let off = [middle.x / self.across.x, middle.y / self.down.y];
        [0, 1].map(|n| (off[n], off[n] / sizes[n]))
    }

    /// Of the ray through a pixel.
    pub(super) fn direction(&self, n: u32) -> Vec3 {
        self.through((n % self.width).into(), (n / self.width).into())
    }

    fn pixel_unit(&self, n: u32) -> Vec3 {
        self.direction(n).normalize()
    }

    fn unit(&self, column: f64, row: f64) -> Vec3 {
        self.through(column, row).normalize()
    }

    fn through(&self, column: f64, row: f64) -> Vec3 {
        self.first + column * self.across + row * self.down
    }

    /// About the angle that a pixel takes in the middle.
    fn angle(&self) -> f64 {
        self.across.length().max(self.down.length())
    }
}
