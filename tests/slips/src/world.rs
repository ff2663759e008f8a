//! What there is to hit, as plain data that is copied with its program.

use std::ops::Deref;

use common::rtweekend::Point3;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its center.
    pub center: Point3,
    /// Its radius.
    pub radius: f64,
}

impl Ball {
    /// The sphere at (`x`, `y`, `z`).
    pub const fn new(x: f64, y: f64, z: f64, radius: f64) -> Self {
        Self {
            center: Point3::new(x, y, z),
            radius,
        }
    }
}

/// The sphere of chapters 2 to 4.
pub(super) const BALL: Ball = Ball::new(0.0, 0.0, -1.0, 0.5);

/// No scene here has more spheres.
const MOST: usize = 4;

/// Spheres in the order in which they are tried.
#[derive(Clone, Copy, Debug)]
pub struct World {
    balls: [Ball; MOST],
    count: usize,
}

impl World {
    /// These spheres.
    ///
    /// # Panics
    /// If they are more than four.
    pub const fn of(balls: &[Ball]) -> Self {
        let mut world = Self {
            balls: [BALL; MOST],
            count: balls.len(),
        };
        let mut n = 0;
        while n < balls.len() {
            world.balls[n] = balls[n];
            n += 1;
        }
        world
    }
}

impl Deref for World {
    type Target = [Ball];

    fn deref(&self) -> &[Ball] {
        &self.balls[..self.count]
    }
}
