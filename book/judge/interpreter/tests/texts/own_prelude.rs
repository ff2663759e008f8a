//! A prelude that a reader typed: the book's, in Rust.

use std::fmt::Write;
use std::ops::{Add, AddAssign, Mul, Neg, Sub};

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

pub type Point3 = Vec3;
pub type Color = Vec3;
pub type Picture = String;

impl Vec3 {
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    pub const ONE: Self = Self::new(1.0, 1.0, 1.0);

    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }

    pub fn normalize(self) -> Self {
        self * (1.0 / self.length_squared().sqrt())
    }
}

impl Add for Vec3 {
    type Output = Self;

    fn add(self, other: Self) -> Self::Output {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl AddAssign for Vec3 {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Vec3 {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Vec3 {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl Mul<Vec3> for f64 {
    type Output = Vec3;

    fn mul(self, v: Vec3) -> Vec3 {
        Vec3::new(self * v.x, self * v.y, self * v.z)
    }
}

impl Mul<f64> for Vec3 {
    type Output = Self;

    fn mul(self, number: f64) -> Self {
        number * self
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub origin: Point3,
    pub direction: Vec3,
}

impl Ray {
    pub fn at(&self, t: f64) -> Point3 {
        self.origin + t * self.direction
    }
}

pub fn sky(ray: &Ray) -> Color {
    let a = 0.5 * (ray.direction.normalize().y + 1.0);
    (1.0 - a) * Color::ONE + a * Color::new(0.5, 0.7, 1.0)
}

pub fn render(width: u32, ray_color: impl Fn(&Ray) -> Color) -> Picture {
    let height = ((width as f64 / (16.0 / 9.0)) as u32).max(1);
    let viewport_width = 2.0 * (f64::from(width) / f64::from(height));
    let right = Vec3::new(viewport_width, 0.0, 0.0) * (1.0 / f64::from(width));
    let down = Vec3::new(0.0, -2.0, 0.0) * (1.0 / f64::from(height));
    let corner = Vec3::ZERO
        - Vec3::new(0.0, 0.0, 1.0)
        - 0.5 * Vec3::new(viewport_width, 0.0, 0.0)
        - 0.5 * Vec3::new(0.0, -2.0, 0.0);
    let first = corner + 0.5 * (right + down);
    let mut picture = format!("P3\n{width} {height}\n255\n");
    for j in 0..height {
        for i in 0..width {
            let direction = first + f64::from(i) * right + f64::from(j) * down;
            let color = ray_color(&Ray { origin: Vec3::ZERO, direction });
            let [r, g, b] = [color.x, color.y, color.z].map(|it| (255.999 * it) as u8);
            writeln!(picture, "{r} {g} {b}").unwrap();
        }
    }
    picture
}
