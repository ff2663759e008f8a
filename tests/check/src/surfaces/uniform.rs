//! Of one color: what of the book's has it, where a direction or a normal never changes.

use common::rtweekend::{Color, Vec3};

use super::background::viewports;
use super::said::number;
use crate::bits::Pixel;
use crate::reading::Reading;

/// How many levels there are to a component.
const LEVELS: f64 = 256.0;
/// How far a length may be from another, by colors that have lost their fraction.
const NEAR: f64 = 0.02;
/// The ends of the sky's blend, below and above.
const SKY: [Color; 2] = [Color::ONE, Color::new(0.5, 0.7, 1.0)];
const RED: Pixel = [255, 0, 0];

/// What a whole picture of that color shows.
pub(super) fn everywhere(reading: &Reading) -> Option<String> {
    let pixel = *reading.pixels.first()?;
    if pixel == RED {
        return Some(
            "It is the red of red_sphere: does every ray count as a hit, whatever its discriminant?"
                .to_owned(),
        );
    }
    let Some(y) = height(pixel) else {
        let [red, green, blue] = pixel;
        let normal = of_a_normal(pixel).filter(|_| red != green || green != blue);
        return normal.map(|it| format!("It is {it}.")).or_else(|| {
            (pixel != [0; 3]).then(|| {
                "One color may be that of one ray: is each division, as in i / image_width, one of real numbers?".to_owned()
            })
        });
    };
    let corner = viewports(reading).into_iter().find(|[width, height]| {
        let corner = Vec3::new(0.5 * width, 0.5 * height, 1.0).normalize();
        (corner.y - y.abs()).abs() < 0.5 * NEAR
    });
    let why = match corner {
        _ if y.abs() < NEAR => "as straight ahead, or where a direction is never set.".to_owned(),
        Some([width, height]) => format!(
            "as in a corner of a viewport {} wide and {} high: are u and v 0 everywhere, as by i / image_width in integers?",
            number(width),
            number(height)
        ),
        None => "so all rays have one direction.".to_owned(),
    };
    Some(format!("It is {}, {why}", of_the_sky(pixel)?))
}

/// What lies behind all else, if it is of that color.
pub(super) fn of_the_sky(pixel: Pixel) -> Option<String> {
    let y = height(pixel)?;
    let y = number(if y.abs() < NEAR { 0.0 } else { y });
    Some(format!(
        "the book's sky where the unit direction's y is {y}"
    ))
}

/// What is hit, if it is of that color.
pub(super) fn of_a_thing(pixel: Pixel) -> Option<String> {
    match pixel {
        RED => Some("the red of red_sphere".to_owned()),
        _ => of_a_normal(pixel),
    }
}

/// What is colored by its normal, if that never changes.
pub(super) fn of_a_normal(pixel: Pixel) -> Option<String> {
    let normal = 2.0 * color(pixel) - Vec3::ONE;
    let length = normal.length();
    let is_normal = length < NEAR || (length - 1.0).abs() < NEAR;
    let [x, y, z] = normal.to_array().map(number);
    is_normal.then(|| format!("what a normal of ({x}, {y}, {z}) gives"))
}

/// The y of the unit direction in which the book's sky has a color, but for white.
pub(super) fn height(pixel: Pixel) -> Option<f64> {
    let [white, blue] = SKY;
    let color = color(pixel);
    let along = (color - white).dot(blue - white) / (blue - white).length_squared();
    let off = (white.lerp(blue, along) - color).abs().max_element();
    (off * LEVELS < 1.5 && along > NEAR && along < 1.0 + NEAR).then_some(2.0 * along - 1.0)
}

fn color(pixel: Pixel) -> Color {
    Color::from_array(pixel.map(|level| (f64::from(level) + 0.5) / LEVELS))
}
