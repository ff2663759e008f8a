//! Figure 8 of the notes: normals as colors. The first of five points moves over the ball.

use common::rtweekend::*;
use glam::DVec2;
use normals::{hit_sphere, ray_color};

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::spoken;
use crate::pixels::Frame;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "normal_colors",
    title: "Normals and their colors",
    description: "The sphere colored by its normals, in large pixels. At five points an arrow \
        shows where the normal points, as far as the eye can see it from the front. Below, each \
        point has its normal, its color in numbers, and a square of that color: up is green, \
        right is pink, left is teal, down is purple, and towards the eye is blue.",
    caption: "A color for each direction: red for *x*, green for *y*, blue for *z*, each from −1…1 to \
        0…1. So red grows to the right, green grows upwards, and where the surface faces the eye \
        there is most blue.",
    draw: || LIVE.on_page(),
};

parameters! {
    x: Number::new("Point 1, to the right", -1.5, 1.5, 0.0),
    y: Number::new("Point 1, upwards", -0.9, 0.9, 0.0),
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "Where on the ball is red strongest? And where is green weakest? Guess, and drag point 1 there.",
    solution: "Red at the right edge, where *x* is greatest; green at the lowest place that is seen, where *y* \
        is least.",
    handles: &[Handle::new(&["x", "y"], |it, to| *it = on_viewport(to))],
    actions: &[
        Action::new("Near the top", |it| *it = Parameters { x: 0.0, y: 0.55 }),
        Action::new("Near the right edge", |it| {
            *it = Parameters { x: 0.55, y: 0.0 }
        }),
        Action::new("Sky", |it| *it = Parameters { x: -1.0, y: 0.6 }),
    ],
    answer,
};

/// The points that stay.
const OTHERS: [Parameters; 4] = [
    Parameters { x: 0.0, y: 0.5 },
    Parameters { x: 0.5, y: 0.0 },
    Parameters { x: 0.0, y: -0.5 },
    Parameters { x: -0.5, y: 0.0 },
];

/// The width of the picture in pixels.
const WIDTH: u32 = 32;

impl Parameters {
    /// The ray through the point of the viewport.
    fn ray(&self) -> Ray {
        Ray::new(Point3::ZERO, Vec3::new(self.x, self.y, -1.0))
    }
}

fn answer(first: &Parameters) -> Answer {
    let ray = first.ray();
    let color = ray_color(&ray);
    let mut levels = [0; 3];
    write_color(&mut levels, color);
    let [red, green, blue] = levels;
    let levels = format!("red {red}, green {green} and blue {blue}");
    Answer {
        drawing: draw(first),
        sentence: match normal(&ray) {
            Some(normal) => {
                let [x, y, z] = normal.to_array().map(spoken);
                format!("**n** = ({x}, {y}, {z}) becomes the levels {levels} of 255.")
            }
            None => {
                format!("The ray misses the ball, so there is no normal: {levels} are the sky.")
            }
        },
        handles: vec![on_sheet(&ray)],
        says: vec![("levels", levels)],
    }
}

/// Draws the picture with its normals, and the table of their colors.
fn draw(first: &Parameters) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 360.0);
    let (camera, frame) = seen_by();
    frame.draw(&mut svg, &normals::picture(WIDTH));

    let below = 8.0 + frame.side * f64::from(camera.image_height);
    for ((point, name), row) in [first].into_iter().chain(&OTHERS).zip('1'..).zip(0..) {
        let ray = point.ray();
        let normal = normal(&ray);
        let from = on_sheet(&ray);
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
    svg
}

/// The normal where a ray hits the sphere.
fn normal(ray: &Ray) -> Option<Vec3> {
    let t = hit_sphere(CENTER, 0.5, ray)?;
    Some((ray.at(t) - CENTER).normalize())
}

/// Where on the sheet the eye sees a ray go through the viewport.
fn on_sheet(ray: &Ray) -> DVec2 {
    let (camera, frame) = seen_by();
    frame.seen(&camera, ray.at(1.0))
}

/// Which place of the viewport is there on the sheet.
fn on_viewport(at: DVec2) -> Parameters {
    let (camera, frame) = seen_by();
    let pixel = (at - frame.corner) / frame.side - DVec2::splat(0.5);
    Parameters {
        x: camera.pixel00.x + pixel.x * camera.pixel_delta_u.x,
        y: camera.pixel00.y + pixel.y * camera.pixel_delta_v.y,
    }
}

fn seen_by() -> (Camera, Frame) {
    let frame = Frame {
        corner: DVec2::new(8.0, 8.0),
        side: 384.0 / f64::from(WIDTH),
    };
    (Camera::new(WIDTH), frame)
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
