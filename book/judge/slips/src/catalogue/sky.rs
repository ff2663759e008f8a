//! Slips in the color of the sky, and in the vectors of which it and all else are made.

use crate::slip::{SLIP, Slip};

const SKY: Slip = Slip {
    page: "gradient#the-color-of-the-sky",
    ..SLIP
};
const BLEND: Slip = Slip {
    rust: "a = 0.5 * (unit_direction.y + 1.0)",
    ..SKY
};
const VECTOR: Slip = Slip { ..SKY };

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "divided-by-length-squared",
        more: &["v * (1.0 / v.length())→v * (1.0 / v.length_squared())"],
        rust: "(1.0 / self.length()) * self",
        cpp: "unit_vector(v) = v / v.length()",
        edits: &["length()→length_squared()"],
        why: "Divided by its length's square, a long vector becomes too short.",
        ..VECTOR
    },
    Slip {
        name: "direction-not-normalized",
        more: &[
            "let unit_direction = ray.direction.normalize(); let a = 0.5 * (unit_direction.y + 1.0)→let a = 0.5 * (ray.direction.y + 1.0)",
        ],
        rust: "unit_direction = ray.direction.normalize(); a = 0.5 * (unit_direction.y + 1.0)",
        cpp: "a = 0.5 * (unit_vector(r.direction()).y() + 1)",
        edits: &[
            "unit_vector(r.direction())→r.direction()",
            "→a = 0.5 * (ray.direction.y + 1.0)",
        ],
        why: "The blend is made for unit directions. Without that every row has one color, and \
              the lowest is almost pure white.",
        reported: &["#306", "PR #308", "#1652"],
        ..SKY
    },
    Slip {
        name: "blend-not-mapped",
        edits: &["0.5 * (unit_direction.y + 1.0)→unit_direction.y"],
        why: "y runs from -1 to 1, a weight from 0 to 1. Below the horizon the weight is \
              negative, and white exceeds 1.",
        ..BLEND
    },
    Slip {
        name: "blend-without-brackets",
        edits: &["(unit_direction.y + 1.0)→unit_direction.y + 1.0"],
        why: "The half takes y alone, so the weight runs from 0.5 to 1.5: the sky is too blue.",
        ..BLEND
    },
    Slip {
        name: "blend-along-x",
        edits: &["direction.y→direction.x"],
        why: "x points to the right, so the gradient runs from left to right.",
        ..BLEND
    },
    Slip {
        name: "white-and-blue-swapped",
        more: &[
            "(1.0 - a) * white + a * blue→(1.0 - a) * blue + a * white",
            "(1.0 - a) * Color::new(1.0, 1.0, 1.0) + a * Color::new(0.5, 0.7, 1.0)→(1.0 - a) * Color::new(0.5, 0.7, 1.0) + a * Color::new(1.0, 1.0, 1.0)",
        ],
        rust: "(1.0 - a) * white + a * blue",
        edits: &["→(1.0 - a) * blue + a * white"],
        why: "a is 1 at the top, where the sky is blue. Swapped, the sky is upside down.",
        reported: &["#879"],
        ..SKY
    },
    Slip {
        name: "background-missing",
        rust: "sky(ray)",
        cpp: "… return (1 - a) * white + a * blue",
        edits: &[
            "sky(ray)→Color::new(0.0, 0.0, 0.0)",
            "→if (…) return color(1, 0, 0); return color(0, 0, 0)",
        ],
        why: "What hits nothing shows the sky. Here it stays black.",
        ..SKY
    },
];
