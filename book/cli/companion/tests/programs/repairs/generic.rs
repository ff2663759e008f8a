//! Everything in one file, with vectors of its own over any number.

pub type Color = V3<f64>;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct V3<T>(pub [T; 3]);

pub trait Number: Copy + std::ops::Add<Output = Self> + std::ops::Mul<Output = Self> + std::ops::Sub<Output = Self> {}
impl Number for f64 {}

impl<T: Number> V3<T> {
    pub fn zip(self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([f(a, x), f(b, y), f(c, z)])
    }
    pub fn times(self, s: T) -> Self {
        Self(self.0.map(|c| s * c))
    }
    pub fn dot(self, other: Self) -> T {
        let [x, y, z] = self.zip(other, |a, b| a * b).0;
        x + y + z
    }
}

impl<T: Number> std::ops::Add for V3<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<T: Number> std::ops::Sub for V3<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

pub fn unit(v: V3<f64>) -> V3<f64> {
    v.times(1.0 / v.dot(v).sqrt())
}

pub struct Ray {
    pub origin: V3<f64>,
    pub dir: V3<f64>,
}

impl Ray {
    pub fn at(&self, t: f64) -> V3<f64> {
        self.origin + self.dir.times(t)
    }
}

pub mod scene {
    use super::*;

    const CENTER: V3<f64> = V3([0.0, 0.0, -1.0]);
    const WHITE: Color = V3([1.0, 1.0, 1.0]);
    const BLUE: Color = V3([0.5, 0.7, 1.0]);

    pub fn nearest_root(ray: &Ray, radius: f64) -> Option<f64> {
        let oc = CENTER - ray.origin;
        let (a, h) = (ray.dir.dot(ray.dir), ray.dir.dot(oc));
        let c = oc.dot(oc) - radius.powi(2);
        let disc = h * h - a * c;
        (disc >= 0.0).then(|| (h - disc.sqrt()) / a).filter(|t| *t > 0.0)
    }

    pub fn color(ray: &Ray) -> Color {
        nearest_root(ray, 0.5).map(|t| unit(ray.at(t) - CENTER)).map_or_else(
            || {
                let share = 0.5 * (unit(ray.dir).0[1] + 1.0);
                WHITE.times(1.0 - share) + BLUE.times(share)
            },
            |n| (n + WHITE).times(0.5),
        )
    }
}

pub fn picture(width: u32) -> String {
    let height = (width as f64 / (16.0 / 9.0)) as u32;
    let wide = 2.0 * (width as f64 / height as f64);
    let (u, v) = (V3([wide, 0.0, 0.0]), V3([0.0, -2.0, 0.0]));
    let (du, dv) = (u.times(1.0 / width as f64), v.times(1.0 / height as f64));
    let eye = V3([0.0; 3]);
    let corner = eye - V3([0.0, 0.0, 1.0]) - u.times(0.5) - v.times(0.5);
    let first = corner + (du + dv).times(0.5);
    let rows = (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
    let pixels = rows.map(|(i, j)| {
        let at = first + du.times(i as f64) + dv.times(j as f64);
        let levels = scene::color(&Ray { origin: eye, dir: at - eye }).0;
        let [r, g, b] = levels.map(|level| (255.999 * level) as u8);
        format!("{r} {g} {b}\n")
    });
    format!("P3\n{width} {height}\n255\n") + &pixels.collect::<String>()
}
