//! Figure 8 of the notes: normals as colors.

use common::rtweekend::*;
use glam::DVec2;
use normals::{hit_sphere, ray_color};

use crate::figure::Figure;
use crate::pixels::Frame;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "normal_colors",
    title: "Normals and their colors",
    description: "The sphere colored by its normals, in large pixels. At five points an arrow \
        shows where the normal points, as far as the eye can see it from the front. Below, each \
        point has its normal, its color in numbers, and a square of that color: up is green, \
        right is pink, left is teal, down is purple, and towards the eye is blue.",
    caption: "A color for each direction: red for *x*, green for *y*, blue for *z*, each from −1…1 to \
        0…1. So red grows to the right, green grows upwards, and what is turned to the eye \
        is blue.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Debug)]
pub struct Parameters {
    /// The width of the picture in pixels.
    pub width: u32,
    /// Where rays go through the viewport, as x and y; those that hit are shown.
    pub through: Vec<(f64, f64)>,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            width: 32,
            through: vec![(0.0, 0.0), (0.0, 0.5), (0.5, 0.0), (0.0, -0.5), (-0.5, 0.0)],
        }
    }
}

/// Draws the picture with its normals, and the table of their colors.
pub fn draw(parameters: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 360.0);
    let (camera, frame) = parameters.seen_by();
    frame.draw(&mut svg, &normals::picture(parameters.width));

    let below = 8.0 + frame.side * f64::from(camera.image_height);
    for ((&(x, y), name), row) in parameters.through.iter().zip('1'..).zip(0..) {
        let ray = Ray::new(camera.center, Vec3::new(x, y, -1.0));
        let normal = normal(&ray);
        let from = frame.seen(&camera, ray.at(1.0));
        let towards = normal.map_or(DVec2::ZERO, |it| 46.0 * DVec2::new(it.x, -it.y));
        if towards.length() > 12.0 {
            svg.arrow("black bold", from, from + towards);
        }
        let words = from + DVec2::new(0.0, 4.5);
        svg.circle("disc", from, 9.0);
        svg.small_label("on-disc", words, Anchor::Middle, &name.to_string());
        let at = below + 28.0 + 23.0 * f64::from(row);
        entry(&mut svg, at, name, normal, ray_color(&ray));
    }
    svg.finish()
}

/// The normal where a ray hits the sphere.
pub fn normal(ray: &Ray) -> Option<Vec3> {
    let t = hit_sphere(CENTER, 0.5, ray)?;
    Some((ray.at(t) - CENTER).normalize())
}

impl Parameters {
    /// Where on the sheet the eye sees the place (`x`, `y`) of the viewport.
    pub fn on_sheet(&self, (x, y): (f64, f64)) -> DVec2 {
        let (camera, frame) = self.seen_by();
        frame.seen(&camera, Point3::new(x, y, -1.0))
    }

    /// Which place of the viewport that is.
    pub fn on_viewport(&self, at: DVec2) -> (f64, f64) {
        let (camera, frame) = self.seen_by();
        let pixel = (at - frame.corner) / frame.side - DVec2::splat(0.5);
        let x = camera.pixel00.x + pixel.x * camera.pixel_delta_u.x;
        let y = camera.pixel00.y + pixel.y * camera.pixel_delta_v.y;
        (x, y)
    }

    fn seen_by(&self) -> (Camera, Frame) {
        let frame = Frame {
            corner: DVec2::new(8.0, 8.0),
            side: 384.0 / f64::from(self.width),
        };
        (Camera::new(self.width), frame)
    }
}

/// A line of the table: which point, its normal, its color.
fn entry(svg: &mut Svg, y: f64, name: char, normal: Option<Vec3>, color: Color) {
    let mut rgb = [0; 3];
    write_color(&mut rgb, color);
    svg.circle("disc", DVec2::new(18.0, y - 4.5), 9.0);
    svg.small_label(
        "on-disc",
        DVec2::new(18.0, y),
        Anchor::Middle,
        &name.to_string(),
    );
    let words = match normal.map(|it| it.to_array().map(signed)) {
        Some([x, y, z]) => format!("**n** = ({x}, {y}, {z})"),
        None => "no normal: it is sky".to_owned(),
    };
    svg.label("ink", DVec2::new(36.0, y), Anchor::Start, &words);
    let [red, green, blue] = color.to_array();
    svg.pixel(DVec2::new(214.0, y - 14.0), DVec2::new(26.0, 18.0), rgb);
    let words = format!("({red:.2}, {green:.2}, {blue:.2})");
    svg.label("ink", DVec2::new(250.0, y), Anchor::Start, &words);
}

/// A component with two decimals and a real minus.
fn signed(value: f64) -> String {
    format!("{:.2}", value + 0.0).replace('-', "−")
}

/// The sphere of chapter 3; its radius is ½.
const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);
