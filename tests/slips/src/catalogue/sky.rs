//! Slips in the color of the sky, and in the vectors of which it and all else are made.

use common::rtweekend::*;

use super::chapters::{RAYS, SPHERES};
use crate::chapter::Chapter;
use crate::program::Program;
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
        name: "divided-with-swapped-letter",
        page: "gradient#the-grid-of-pixels",
        rust: "Vec3::new(self.x / t, self.y / t, self.z / t)",
        cpp: "vec3(v.x / t, v.y / t, v.z / t)",
        edits: &["self.z→self.y", "v.z→v.y"],
        why: "In operator/ the third component is made of the second. Half of an edge that has \
              only y has a z as well, and no unit vector keeps its own.",
        alter: |p| {
            p.over = swapped_over;
            p.unit = |v| swapped_over(v, v.length());
        },
        ..VECTOR
    },
    Slip {
        name: "sum-with-swapped-letter",
        page: "gradient#a-ray-is-a-function",
        rust: "Vec3::new(self.x + other.x, self.y + other.y, self.z + other.z)",
        cpp: "vec3(u.x + v.x, u.y + v.y, u.z + v.z)",
        edits: &["other.z→self.z", "v.z→u.z"],
        why: "In operator+ the third component is that of the first vector, twice. Each sum on the \
              way to a pixel doubles the viewport's distance, and a point on a ray has no depth.",
        alter: |p| {
            p.plus = swapped_plus;
            p.lerp = |[below, above], a| swapped_plus((1.0 - a) * below, a * above);
            if p.chapter == Chapter::HittableList {
                p.shade = |_, normal| 0.5 * swapped_plus(normal, Vec3::ONE);
            }
        },
        ..VECTOR
    },
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
        name: "length-with-swapped-letter",
        rust: "self.x * self.x + self.y * self.y + self.z * self.z",
        cpp: "e[0]*e[0] + e[1]*e[1] + e[2]*e[2]",
        python: "x*x + y*y + z*z",
        edits: &[
            "self.z * self.z→self.y * self.y",
            "e[2]*e[2]→e[1]*e[1]",
            "z*z→y*y",
        ],
        why: "One component counts twice, one never: each length and unit vector is wrong.",
        alter: |p| {
            p.unit = |v| v * (1.0 / swapped_length_squared(v).sqrt());
            // Chapters 4 and 5 take the square of a length by the same function.
            if p.chapter >= Chapter::HalfBSphere {
                p.squared = |_: &Program, v| swapped_length_squared(v);
            }
        },
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
        name: "blend-not-halved",
        edits: &["0.5 * (unit_direction.y + 1.0)→unit_direction.y + 1.0"],
        why: "y + 1 runs from 0 to 2. Above the horizon that exceeds 1, and the sky is too blue.",
        alter: |p| p.blend = |direction| direction.y + 1.0,
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
        name: "blue-with-exchanged-numbers",
        rust: "blue = Color::new(0.5, 0.7, 1.0)",
        edits: &["0.5, 0.7→0.7, 0.5"],
        why: "Red has less of it than green. Exchanged, the sky is violet.",
        alter: |p| p.sky = [Color::ONE, Color::new(0.7, 0.5, 1.0)],
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

fn swapped_length_squared(v: Vec3) -> f64 {
    v.x * v.x + v.y * v.y + v.y * v.y
}

fn swapped_plus(u: Vec3, v: Vec3) -> Vec3 {
    Vec3::new(u.x + v.x, u.y + v.y, u.z + u.z)
}

fn swapped_over(v: Vec3, t: f64) -> Vec3 {
    Vec3::new(v.x, v.y, v.y) * (1.0 / t)
}
