//! A color for each direction: drag a point over the ball.

use common::rtweekend::*;
use figures::normal_colors::{Parameters, draw, normal};
use figures::spoken;
use normals::ray_color;

use crate::live::{Action, Answer, Handle, Live, Number};

/// The first of the five points moves.
pub(crate) const LIVE: Live = Live {
    name: "normal_colors",
    question: "Where on the ball is there most red and least green? Guess, and drag point 1 there.",
    numbers: &[
        Number::new("Point 1, to the right", -1.5, 1.5, 0.0),
        Number::new("Point 1, upwards", -0.9, 0.9, 0.0),
    ],
    handles: &[Handle {
        numbers: &[0, 1],
        drag: |numbers, to| (numbers[0], numbers[1]) = Parameters::default().on_viewport(to),
    }],
    actions: &[
        Action {
            name: "Near the top",
            act: |numbers| numbers.copy_from_slice(&[0.0, 0.55]),
        },
        Action {
            name: "Near the right edge",
            act: |numbers| numbers.copy_from_slice(&[0.55, 0.0]),
        },
        Action {
            name: "Sky",
            act: |numbers| numbers.copy_from_slice(&[-1.0, 0.6]),
        },
    ],
    answer,
};

fn answer(numbers: &[f64]) -> Answer {
    let place = (numbers[0], numbers[1]);
    let mut parameters = Parameters::default();
    parameters.through[0] = place;
    let ray = Ray::new(Point3::ZERO, Vec3::new(place.0, place.1, -1.0));
    let color = ray_color(&ray);
    let mut levels = [0; 3];
    write_color(&mut levels, color);
    let [red, green, blue] = levels;
    let levels = format!("red {red}, green {green} and blue {blue}");
    Answer {
        svg: draw(&parameters),
        sentence: match normal(&ray) {
            Some(normal) => {
                let [x, y, z] = normal.to_array().map(spoken);
                format!("**n** = ({x}, {y}, {z}) becomes the levels {levels} of 255.")
            }
            None => {
                format!("The ray misses the ball, so there is no normal: {levels} are the sky.")
            }
        },
        handles: vec![parameters.on_sheet(place)],
        says: vec![("levels", levels)],
    }
}
