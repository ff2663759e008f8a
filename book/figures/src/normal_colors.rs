//! Figure 8 of the notes: normals as colors. The first of five points moves over the ball.

use normals::{hit_sphere, ray_color};

use crate::vocabulary::*;

parameters! {
    first: Point3 =
        Number::new("Point 1, to the right", -1.5, 1.5, 0.0),
        Number::new("Point 1, upwards", -0.9, 0.9, 0.0);
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: Figure {
        name: "normal_colors",
        title: "Normals and their colors",
        description: "The sphere colored by its normals, in large pixels. At five points an arrow \
            shows where the normal points, as far as the eye can see it from the front. Below, each \
            point has its normal, its color in numbers, and a square of that color: up is green, \
            right is pink, left is teal, down is purple, and towards the eye is blue.",
        caption: "A color for each direction: red for *x*, green for *y*, blue for *z*, each from −1…1 to \
            0…1. So red grows to the right, green grows upwards, and where the surface faces the eye \
            there is most blue.",
        question: "Where on the ball is red strongest? And where is green weakest? Guess, and drag point 1 there.",
        solution: "Red at the right edge, where *x* is greatest; green at the lowest place that is seen, where *y* \
        is least.",
    },
    handles: &[point!(viewport(), first)],
    actions: &[
        ("Near the top", |it| it.first = xy(0.0, 0.55)),
        ("Near the right edge", |it| it.first = xy(0.55, 0.0)),
        ("Sky", |it| it.first = xy(-1.0, 0.6)),
    ],
    answer,
};

/// The points of the viewport that stay.
const OTHERS: [Point3; 4] = [xy(0.0, 0.5), xy(0.5, 0.0), xy(0.0, -0.5), xy(-0.5, 0.0)];

/// The width of the picture in pixels, and where it is on the sheet.
const WIDTH: u32 = 32;
const FRAME: Frame = Frame::new(8.0, 8.0, 12.0);

fn viewport() -> Plane {
    FRAME.viewport(&Camera::new(WIDTH))
}

/// The sphere of chapter 3; its radius is ½.
const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);

/// The color of the ray through a point of the viewport, and the normal where it hits the
/// sphere.
fn seen(point: Point3) -> (Color, Option<Vec3>) {
    let ray = Ray::new(Point3::ZERO, point - Vec3::Z);
    let hit = hit_sphere(CENTER, 0.5, &ray);
    let normal = hit.map(|t| (ray.at(t) - CENTER).normalize());
    (ray_color(&ray), normal)
}

fn levels(color: Color) -> [u8; 3] {
    let mut levels = [0; 3];
    write_color(&mut levels, color);
    levels
}

fn answer(&Parameters { first }: &Parameters) -> Answer {
    let (color, normal) = seen(first);
    let [red, green, blue] = levels(color);
    let levels = format!("red {red}, green {green} and blue {blue}");
    let sentence = match normal {
        Some(normal) => {
            let normal = triple(normal);
            format!("**n** = {normal} becomes the levels {levels} of 255.")
        }
        None => format!("The ray misses the ball, so there is no normal: {levels} are the sky."),
    };
    Answer::new(draw(first), sentence, vec![("levels", levels)])
}

/// Draws the picture with its normals, and the table of their colors.
fn draw(first: Point3) -> Svg {
    let mut svg = LIVE.figure.sheet(360.0);
    FRAME.draw(&mut svg, &normals::picture(WIDTH));
    let points = [first].into_iter().chain(OTHERS);
    for ((point, name), row) in points.zip(["1", "2", "3", "4", "5"]).zip(0..) {
        let (color, normal) = seen(point);
        let from = viewport().point(point);
        let towards = normal.map_or(DVec2::ZERO, |it| 46.0 * spot(it.x, -it.y));
        if towards.length() > 12.0 {
            svg.arrow("black bold", from, from + towards);
        }
        disc(&mut svg, from, name);
        let at = spot(18.0, 252.0).down(23.0 * f64::from(row));
        disc(&mut svg, at.down(-4.5), name);
        entry(&mut svg, at, normal, color);
    }
    svg
}

fn disc(svg: &mut Svg, middle: DVec2, name: &str) {
    svg.circle("disc", middle, 9.0);
    svg.small_label("on-disc", middle.down(4.5), Middle, name);
}

/// A line of the table: the normal of a point, and its color.
fn entry(svg: &mut Svg, at: DVec2, normal: Option<Vec3>, color: Color) {
    let words = match normal {
        Some(normal) => format!("**n** = {}", triple(normal)),
        None => "no normal: it is sky".to_owned(),
    };
    svg.label("ink", at.right(18.0), Start, &words);
    svg.pixel(at + spot(196.0, -14.0), spot(26.0, 18.0), levels(color));
    svg.label("ink", at.right(232.0), Start, &triple(color));
}
