//! A grid of pixels on the viewport: choose how wide the picture is, and a pixel.

use common::rtweekend::*;
use figures::spoken;
use figures::viewport_grid::{Parameters, draw, triple};
use slips;
use slips::Chapter;

use crate::live::{Action, Answer, Handle, Live, Number};

/// The height that jumps, and the ray of a pixel.
pub(crate) const LIVE: Live = Live {
    name: "viewport_grid",
    question: "At which widths does the picture gain a row? And where does the ray of the marked \
        pixel go, if the half pixel is forgotten?",
    numbers: &[
        Number::whole("Width", 1.0, 40.0, 8.0),
        Number {
            most_beside: Some(|numbers| f64::from(camera(numbers).image_width - 1)),
            ..Number::whole("Column i", 0.0, 39.0, 5.0)
        },
        Number {
            most_beside: Some(|numbers| f64::from(camera(numbers).image_height - 1)),
            downwards: true,
            ..Number::whole("Row j", 0.0, 21.0, 2.0)
        },
        Number::choice("The first P", CHOICES),
    ],
    handles: &[Handle {
        numbers: &[1, 2],
        drag: |numbers, to| {
            let Parameters { camera, .. } = parameters(numbers);
            let way = parameters(numbers).plane().place(to) - camera.pixel00;
            let along = |step: Vec3| way.dot(step) / step.length_squared();
            numbers[1] = along(camera.pixel_delta_u);
            numbers[2] = along(camera.pixel_delta_v);
        },
    }],
    actions: &[
        Action {
            name: "1 wide",
            act: |numbers| widen(numbers, 1.0),
        },
        Action {
            name: "16 wide",
            act: |numbers| widen(numbers, 16.0),
        },
        Action {
            name: "40 wide",
            act: |numbers| widen(numbers, 40.0),
        },
    ],
    answer,
};

/// The name of the slip in the catalogue.
const SLIP: &str = "grid-not-inset";
const CHOICES: &[&str] = &["half a pixel in", "at the corner Q"];

fn answer(numbers: &[f64]) -> Answer {
    let parameters = parameters(numbers);
    let width = parameters.camera.image_width;
    let [i, j] = parameters.pixel;
    let ray = parameters.camera.ray(i, j);
    Answer {
        svg: draw(&parameters),
        sentence: format!("{} {}", way(&parameters), height(width)),
        handles: vec![parameters.plane().point(ray.at(1.0))],
        says: vec![
            ("width", width.to_string()),
            ("rows", rows(width)),
            ("because", because(width)),
            ("pixel", format!("({i}, {j})")),
            ("direction", triple(camera(numbers).ray(i, j).direction)),
        ],
    }
}

fn parameters(numbers: &[f64]) -> Parameters {
    let right = camera(numbers);
    let slip = slips::find(SLIP).filter(|_| numbers[3] >= 1.0);
    Parameters {
        camera: slip.map_or(right, |slip| {
            slip.program(Chapter::Gradient).camera(right.image_width)
        }),
        pixel: [numbers[1], numbers[2]].map(|it| it as u32),
    }
}

/// The camera of the chapter.
fn camera(numbers: &[f64]) -> Camera {
    Camera::new(numbers[0] as u32)
}

/// Where the ray of the pixel goes.
fn way(parameters: &Parameters) -> String {
    let [i, j] = parameters.pixel;
    let [way, right] = [
        parameters.camera,
        Camera::new(parameters.camera.image_width),
    ]
    .map(|camera| camera.ray(i, j).direction);
    let corner = match way == right {
        true => String::new(),
        false => format!(
            ", to its corner: half a pixel up and to the left of {}",
            triple(right)
        ),
    };
    format!(
        "The ray of pixel ({i}, {j}) has the direction {}{corner}.",
        triple(way)
    )
}

/// How many rows there are, and why.
fn height(width: u32) -> String {
    let (rows, because) = (rows(width), because(width));
    format!("A picture {width} wide has {rows}: {because}.")
}

fn because(width: u32) -> String {
    let quotient = f64::from(width) / (16.0 / 9.0);
    let end = match quotient {
        ..1.0 => " would leave none",
        _ if quotient.fract() == 0.0 => ", and nothing is cut",
        _ => " is cut",
    };
    format!("{width} / (16/9) = {}{end}", spoken(quotient))
}

fn rows(width: u32) -> String {
    match Camera::new(width).image_height {
        1 => "1 row".to_owned(),
        rows => format!("{rows} rows"),
    }
}

/// Another width; the pixel stays, where there is one.
fn widen(numbers: &mut [f64], width: f64) {
    numbers[0] = width;
    LIVE.confine(numbers);
}
