//! Figure 8 of the notes: normals as colors. A point moves over the ball.

use normals::{hit_sphere, ray_color};

use crate::prelude::*;

parameters! {
    point: Point3 =
        Parameter::new("The point, to the right", -1.5, 1.5, 0.15),
        Parameter::new("The point, upwards", -0.9, 0.9, 0.3);
}

/// The live figure: a point of the picture of chapter 3 to be moved, with its normal and its color.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("normal_colors"),
    handles: &[point!(viewport(), point)],
    actions: &[
        ("Near the top", |it| it.point = xy(0.0, 0.55)),
        ("Near the right edge", |it| it.point = xy(0.55, 0.0)),
        ("Sky", |it| it.point = xy(-1.0, 0.6)),
    ],
    answer,
};

/// The width of the picture in pixels, and its place on the sheet.
const WIDTH: u32 = 32;
const FRAME: PixelGrid = PixelGrid::new(8.0, 8.0, 12.0);

fn viewport() -> Plane {
    FRAME.viewport(&Camera::new(WIDTH))
}

/// The center of the sphere of chapter 3, whose radius is ½.
const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);

/// Returns the color of the ray through a point of the viewport, and the normal if the ray hits the
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

fn answer(&Parameters { point }: &Parameters) -> DrawnFigure {
    let (color, normal) = seen(point);
    let [red, green, blue] = levels(color);
    let levels = format!("red {red}, green {green} and blue {blue}");
    let sentence = match normal {
        Some(_) => format!("Of 255 levels that is {levels}."),
        None => format!("The ray misses the ball, so there is no normal: {levels} are the sky."),
    };
    DrawnFigure::new(draw(point, color, normal), sentence, [("levels", levels)])
}

/// Draws the picture, the normal at the chosen point, and below them both in numbers.
fn draw(point: Point3, color: Color, normal: Option<Vec3>) -> Svg {
    let mut svg = LIVE.figure.sheet(264.0);
    FRAME.draw(&mut svg, &normals::picture(WIDTH));
    let from = viewport().point(point);
    let towards = normal.map_or(DVec2::ZERO, |it| 46.0 * spot(it.x, -it.y));
    if towards.length() > 12.0 {
        svg.arrow("black bold", from, from + towards);
    }
    svg.circle("disc", from, 4.5);
    let words = match normal {
        Some(normal) => format!("**n** = {}", triple(normal)),
        None => "no normal: it is sky".to_owned(),
    };
    let at = spot(36.0, 252.0);
    svg.label("ink", at, Start, &words);
    svg.pixel(at + spot(178.0, -14.0), spot(26.0, 18.0), levels(color));
    svg.label("ink", at.right(214.0), Start, &triple(color));
    svg
}
