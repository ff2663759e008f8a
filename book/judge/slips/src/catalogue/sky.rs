//! Slips in the color of the sky, and in the vectors of which it and all else are made.

use common::rtweekend::*;

use super::chapters::{RAYS, SPHERES};
use crate::slip::{Part, SLIP, Slip};

const SKY: Slip = Slip {
    chapters: RAYS,
    page: "gradient#the-color-of-the-sky",
    source: "chapters/1_gradient/src/lib.rs",
    ..SLIP
};
const BLEND: Slip = Slip {
    rust: "a = 0.5 * (unit_direction.y + 1.0)",
    ..SKY
};
const VECTOR: Slip = Slip {
    source: "common/src/vec3.rs",
    part: Part::Prelude,
    ..SKY
};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "divided-by-length-squared",
        rust: "(1.0 / self.length()) * self",
        cpp: "unit_vector(v) = v / v.length()",
        edits: &["length()→length_squared()"],
        why: "Divided by its length's square, a long vector becomes too short.",
        alter: |p| p.unit = |v| v * (1.0 / v.length_squared()),
        ..VECTOR
    },
    Slip {
        name: "direction-not-normalized",
        rust: "unit_direction = ray.direction.normalize(); a = 0.5 * (unit_direction.y + 1.0)",
        cpp: "a = 0.5 * (unit_vector(r.direction()).y() + 1)",
        edits: &[
            "unit_vector(r.direction())→r.direction()",
            "→a = 0.5 * (ray.direction.y + 1.0)",
        ],
        why: "The blend is made for unit directions. Without that every row has one color, and \
              the lowest is almost pure white.",
        reported: &["#306", "PR #308", "#1652"],
        alter: |p| p.sky_direction = |_, direction| direction,
        ..SKY
    },
    Slip {
        name: "blend-not-mapped",
        edits: &["0.5 * (unit_direction.y + 1.0)→unit_direction.y"],
        why: "y runs from -1 to 1, a weight from 0 to 1. Below the horizon the weight is \
              negative, and white exceeds 1.",
        alter: |p| p.blend = |direction| direction.y,
        ..BLEND
    },
    Slip {
        name: "blend-without-brackets",
        edits: &["(unit_direction.y + 1.0)→unit_direction.y + 1.0"],
        why: "The half takes y alone, so the weight runs from 0.5 to 1.5: the sky is too blue.",
        alter: |p| p.blend = |direction| 0.5 * direction.y + 1.0,
        ..BLEND
    },
    Slip {
        name: "blend-along-x",
        edits: &["direction.y→direction.x"],
        why: "x points to the right, so the gradient runs from left to right.",
        alter: |p| p.blend = |direction| 0.5 * (direction.x + 1.0),
        ..BLEND
    },
    Slip {
        name: "white-and-blue-swapped",
        rust: "(1.0 - a) * white + a * blue",
        edits: &["→(1.0 - a) * blue + a * white"],
        why: "a is 1 at the top, where the sky is blue. Swapped, the sky is upside down.",
        reported: &["#879"],
        alter: |p| p.lerp = |[below, above], a| a * below + (1.0 - a) * above,
        ..SKY
    },
    Slip {
        name: "background-missing",
        chapters: SPHERES,
        rust: "sky(ray)",
        cpp: "… return (1 - a) * white + a * blue",
        edits: &[
            "sky(ray)→Color::new(0.0, 0.0, 0.0)",
            "→if (…) return color(1, 0, 0); return color(0, 0, 0)",
        ],
        why: "What hits nothing shows the sky. Here it stays black.",
        alter: |p| p.lerp = |_, _| Color::ZERO,
        ..SKY
    },
];
