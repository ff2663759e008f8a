//! The lesson's prelude: vectors, rays, camera and sky, as the chapters have them. What no edit
//! touches is computed by a faster double of the table of natives. The compiler reads this text,
//! too: the package `texts` draws right pictures by it.

use super::*;

pub type Vec3 = DVec3;
pub type Point3 = Vec3;
pub type Color = Vec3;

pub struct Ray {
    pub origin: Point3,
    pub direction: Vec3,
}

pub struct Camera {
    pub image_width: u32,
    pub image_height: u32,
    pub center: Point3,
    pub pixel00: Point3,
    pub pixel_delta_u: Vec3,
    pub pixel_delta_v: Vec3,
}

impl Add for DVec3 {
    type Output = Vec3;

    fn add(self, other: Vec3) -> Vec3 {
        Vec3::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for DVec3 {
    type Output = Vec3;

    fn sub(self, other: Vec3) -> Vec3 {
        Vec3::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Neg for DVec3 {
    type Output = Vec3;

    fn neg(self) -> Vec3 {
        Vec3::new(-self.x, -self.y, -self.z)
    }
}

impl Mul for DVec3 {
    type Output = Vec3;

    fn mul(self, other: Vec3) -> Vec3 {
        Vec3::new(self.x * other.x, self.y * other.y, self.z * other.z)
    }
}

// It serves for `Vec3 * f64`, too.
impl Mul<Vec3> for f64 {
    type Output = Vec3;

    fn mul(self, v: Vec3) -> Vec3 {
        Vec3::new(self * v.x, self * v.y, self * v.z)
    }
}

// Beside a vector, another operator takes a number as three components.
impl Div for DVec3 {
    type Output = Vec3;

    fn div(self, other: Vec3) -> Vec3 {
        Vec3::new(self.x / other.x, self.y / other.y, self.z / other.z)
    }
}

impl Rem for DVec3 {
    type Output = Vec3;

    fn rem(self, other: Vec3) -> Vec3 {
        Vec3::new(self.x % other.x, self.y % other.y, self.z % other.z)
    }
}

impl DVec3 {
    pub fn dot(self, other: Vec3) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
    pub fn length_squared(self) -> f64 {
        self.x * self.x + self.y * self.y + self.z * self.z
    }
    pub fn length(self) -> f64 {
        self.length_squared().sqrt()
    }
    pub fn normalize(self) -> Vec3 {
        self * (1.0 / self.length())
    }
}

impl Ray {
    pub fn new(origin: Point3, direction: Vec3) -> Ray {
        Ray { origin, direction }
    }
    pub fn at(&self, t: f64) -> Point3 {
        self.origin + t * self.direction
    }
}

impl Camera {
    pub fn new(image_width: u32) -> Self {
        let aspect_ratio = 16.0 / 9.0;
        let image_height = ((f64::from(image_width) / aspect_ratio) as u32).max(1);
        Self::with_size(image_width, image_height)
    }

    pub fn with_size(image_width: u32, image_height: u32) -> Self {
        let focal_length = 1.0;
        let viewport_height = 2.0;
        let viewport_width = viewport_height * (f64::from(image_width) / f64::from(image_height));
        let center = Point3::ZERO;

        let viewport_u = Vec3::new(viewport_width, 0.0, 0.0);
        let viewport_v = Vec3::new(0.0, -viewport_height, 0.0);
        let pixel_delta_u = viewport_u * (1.0 / f64::from(image_width));
        let pixel_delta_v = viewport_v * (1.0 / f64::from(image_height));

        let viewport_upper_left =
            center - Vec3::new(0.0, 0.0, focal_length) - 0.5 * viewport_u - 0.5 * viewport_v;
        let pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v);

        Self {
            image_width,
            image_height,
            center,
            pixel00,
            pixel_delta_u,
            pixel_delta_v,
        }
    }

    pub fn ray(&self, i: u32, j: u32) -> Ray {
        let pixel_center =
            self.pixel00 + f64::from(i) * self.pixel_delta_u + f64::from(j) * self.pixel_delta_v;
        Ray::new(self.center, pixel_center - self.center)
    }
}

pub fn sky(ray: &Ray) -> Color {
    let unit_direction = ray.direction.normalize();
    let a = 0.5 * (unit_direction.y + 1.0);
    (1.0 - a) * Color::new(1.0, 1.0, 1.0) + a * Color::new(0.5, 0.7, 1.0)
}

pub fn render(width: u32, ray_color: impl Fn(&Ray) -> Color + Send + Sync + 'static) -> Picture {
    let camera = Camera::new(width);
    Picture::paint(camera.image_width, camera.image_height, move |i, j| {
        ray_color(&camera.ray(i, j))
    })
}
