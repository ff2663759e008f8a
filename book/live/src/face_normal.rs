//! From which side a ray comes: drag its origin through the surface.

use common::rtweekend::*;
use figures::face_normal::{PLANES, Parameters, draw, hit, outward};
use figures::number::printed;
use figures::spoken;

use crate::live::{Action, Answer, Handle, Live, Number};

/// The lower ray moves, in both drawings.
pub(crate) const LIVE: Live = Live {
    name: "face_normal",
    question: "When does the normal at the right turn round? Drag the origin of the lower ray out of \
        the sphere, and then to where the ray only grazes it.",
    numbers: &[
        Number::new("Origin, to the right", -1.4, 1.0, -0.55),
        Number::new("Origin, upwards", -1.3, 1.4, -0.65),
    ],
    handles: &[
        Handle {
            numbers: &[0, 1],
            drag: |numbers, to| {
                let place = PLANES[0].place(to);
                (numbers[0], numbers[1]) = (place.x, place.y);
            },
        },
        Handle {
            numbers: &[0, 1],
            drag: |numbers, to| {
                let place = PLANES[1].place(to);
                (numbers[0], numbers[1]) = (place.x, place.y);
            },
        },
    ],
    actions: &[
        Action {
            name: "From inside",
            act: |numbers| numbers.copy_from_slice(&[-0.55, -0.65]),
        },
        Action {
            name: "From outside",
            act: |numbers| numbers.copy_from_slice(&[-1.4, -0.65]),
        },
        Action {
            name: "A graze",
            act: |numbers| numbers.copy_from_slice(&[-1.2, -1.0]),
        },
    ],
    answer,
};

fn answer(numbers: &[f64]) -> Answer {
    let default = Parameters::default();
    let ray = Ray::new(
        Point3::new(numbers[0], numbers[1], 0.0),
        default.from_inside.direction,
    );
    let parameters = Parameters {
        from_inside: ray,
        ..default
    };
    let found = hit(&ray).map(|record| (ray.direction.dot(outward(&record)), record.front_face));
    let sentence = match found {
        None if (ray.origin.length() - 1.0).abs() < 1e-9 => {
            "This ray starts on the sphere and leaves it. There *t* is 0, and only more than that counts: \
            a surface does not meet what comes from it."
                .to_owned()
        }
        None if numbers[0] < 0.0 && numbers[1].abs() == 1.0 => {
            "This ray only touches the sphere, and rounding makes a miss of it.".to_owned()
        }
        None => "This ray does not meet the sphere: there is no normal to turn.".to_owned(),
        Some((0.0, _)) => {
            "**d**·**n** is exactly 0: the ray grazes. The code asks for < 0, so front_face is \
            false."
                .to_owned()
        }
        Some((product, front_face)) if product.abs() < 1e-6 => format!(
            "**d**·**n** should be 0, as the ray grazes. Rounding makes {} of it, so front_face is \
            {front_face}.",
            printed(product)
        ),
        Some((product, true)) => format!(
            "**d**·**n** = {} with the outward normal: the ray comes from outside, front_face is true, and \
            the normal stays.",
            spoken(product)
        ),
        Some((product, false)) => format!(
            "**d**·**n** = {} with the outward normal: the ray comes from inside, front_face is false, and \
            the normal is turned round.",
            spoken(product)
        ),
    };
    Answer {
        svg: draw(&parameters),
        sentence,
        handles: PLANES.map(|plane| plane.point(ray.origin)).into(),
        says: vec![],
    }
}
