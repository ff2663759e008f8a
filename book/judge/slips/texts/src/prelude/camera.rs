use common::rtweekend::*;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub image_width: u32,
    pub image_height: u32,
    pub center: Point3,
    pub pixel00: Point3,
    pub pixel_delta_u: Vec3,
    pub pixel_delta_v: Vec3,
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
