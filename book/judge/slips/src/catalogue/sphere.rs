//! Slips in the quadratic.

use super::chapters::{RED_SPHERE, SPHERES};
use crate::chapter::Chapter::{HalfBSphere, Normals};
use crate::letters::Letters;
use crate::slip::{SLIP, Slip};

/// Why chapter 2 does not show a slip in the sign of b.
pub(super) const SIGN_OF_B: &str =
    "Only the sign of b changes, and the discriminant has its square.";

const COEFFICIENTS: Slip = Slip {
    page: "red_sphere#the-ray-in-the-equation",
    ..SLIP
};
const A: Slip = Slip {
    rust: "a = ray.direction.dot(ray.direction)",
    ..COEFFICIENTS
};
const B: Slip = Slip {
    rust: "b = -2.0 * ray.direction.dot(oc)",
    older: "b = 2.0 * dot(oc, r.direction())",
    ..COEFFICIENTS
};
const C: Slip = Slip {
    page: "red_sphere#the-equation-of-a-sphere",
    rust: "c = oc.dot(oc) - radius * radius",
    ..COEFFICIENTS
};
const DISCRIMINANT: Slip = Slip {
    page: "red_sphere#what-the-discriminant-says",
    rust: "discriminant = b * b - 4.0 * a * c",
    later: Some((HalfBSphere, "discriminant = h * h - a * c")),
    ..COEFFICIENTS
};
const SIGN: Slip = Slip {
    rust: "discriminant >= 0.0",
    later: Some((Normals, "discriminant < 0.0")),
    ..DISCRIMINANT
};
const DOT: Slip = Slip {
    rust: "self.x * other.x + self.y * other.y + self.z * other.z",
    cpp: "u.x*v.x + u.y*v.y + u.z*v.z",
    ..COEFFICIENTS
};
const ROOT: Slip = Slip {
    page: "normals#where-the-nearer-root",
    rust: "(-b - discriminant.sqrt()) / (2.0 * a)",
    later: Some((HalfBSphere, "(h - discriminant.sqrt()) / a")),
    ..SLIP
};
const HALF: Slip = Slip {
    page: "half_b_sphere#two-observations",
    ..SLIP
};
const H: Slip = Slip {
    rust: "h = ray.direction.dot(oc)",
    ..HALF
};
const ROOT_BY_H: Slip = Slip {
    rust: ROOT.rust,
    later: ROOT.later,
    older: "(-half_b - sqrt(discriminant)) / a",
    ..HALF
};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "oc-reversed",
        page: "editions#every-mixture",
        rust: "oc = center - ray.origin",
        older: "oc = r.origin() - center",
        edits: &[
            "center - ray.origin→ray.origin - center",
            "r.origin() - center→center - r.origin()",
        ],
        why: "Other editions have it the other way round, with another sign in the formula. If you \
              mix the two, every root changes its sign and the sphere is behind the camera.",
        reported: &["#1292", "PR #1304", "#1643"],
        unseen_in: RED_SPHERE,
        equivalent: SIGN_OF_B,
        ..COEFFICIENTS
    },
    Slip {
        name: "b-sign",
        page: "editions#every-mixture",
        edits: &["-2.0→2.0", "2.0→-2.0"],
        why: "The sign belongs to that of oc. With the other one every root changes its sign and \
              the sphere is behind the camera.",
        reported: &["#1292", "#1643"],
        unseen_in: RED_SPHERE,
        equivalent: SIGN_OF_B,
        ..B
    },
    Slip {
        name: "b-not-doubled",
        edits: &["2.0 * →"],
        why: "The formula is the one for the whole of b: the discriminant is far too small.",
        ..B
    },
    Slip {
        name: "h-doubled",
        older: "half_b = dot(oc, r.direction())",
        edits: &["half_b =→half_b = 2.0 *", "h =→h = -2.0 *"],
        why: "That is b, and the formula is the one for half of it: the discriminant is far \
              too large.",
        ..H
    },
    Slip {
        name: "h-sign",
        edits: &["h = →h = -"],
        why: "b is -2h, so the minus of b is in the 2 already. With a second minus every \
              root changes its sign and the sphere is behind the camera.",
        ..H
    },
    Slip {
        name: "discriminant-without-four",
        edits: &["4.0 * →"],
        why: "The 4 goes only if b is halved. The discriminant is too large, and every ray hits.",
        reported: &["#113", "#126", "#146", "RayTracing/InOneWeekend#17"],
        ..DISCRIMINANT
    },
    Slip {
        name: "discriminant-with-four",
        rust: DISCRIMINANT.rust,
        later: DISCRIMINANT.later,
        older: "discriminant = half_b*half_b - a*c",
        edits: &["- a * c→- 4.0 * a * c", "- a*c→- 4*a*c"],
        why: "Halving b cancels the 4. With it the discriminant is too small: the sphere is gone.",
        reported: &["#113", "#126", "#146", "RayTracing/InOneWeekend#17"],
        ..HALF
    },
    Slip {
        name: "discriminant-with-plus",
        edits: &[" - → + "],
        why: "From outside a sphere c is positive, so the sum is too: every line seems to hit.",
        ..DISCRIMINANT
    },
    Slip {
        name: "tangent-missed",
        cpp: "discriminant >= 0",
        edits: &[">=→>", "<→<="],
        why: "A ray that touches has one root: the discriminant is 0. No ray here does so exactly.",
        reported: &["#110", "#1057", "#1058", "PR #1124"],
        unseen_in: SPHERES,
        law: "A tangent is a hit.",
        ..SIGN
    },
    Slip {
        name: "hit-and-miss-swapped",
        cpp: "if (discriminant < 0) miss",
        edits: &[">=→<=", "<→>"],
        why: "Lines that pass through the sphere have two roots, and a positive discriminant.",
        ..SIGN
    },
    Slip {
        name: "radius-not-squared",
        edits: &["radius * radius→radius"],
        why: "A radius of 0.5 acts as its square root, 0.707: the disc is too large.",
        ..C
    },
    Slip {
        name: "a-taken-as-one",
        edits: &["ray.direction.dot(ray.direction)→1.0"],
        why: "That holds for unit directions only. With a too small, every ray here hits.",
        ..A
    },
    Slip {
        name: "a-from-length",
        edits: &["dot(ray.direction)→length()"],
        why: "a is the square of the direction's length, which is 1 only in the middle.",
        ..A
    },
    Slip {
        name: "dot-with-swapped-letter",
        more: &["u.z * v.z→u.z * u.z"],
        edits: &["other.z→self.z", "v.z→u.z"],
        why: "With oc.z and d.z both -1 the last product is right by chance. Any other sphere, \
              and every normal's side, is wrong.",
        reported: &["#1292"],
        ..DOT
    },
    Slip {
        name: "stale-boolean",
        more: &[
            "Some((-b - discriminant.sqrt()) / (2.0 * a))→Some(1.0)",
            "Some((h - discriminant.sqrt()) / a)→Some(1.0)",
        ],
        edits: &["→return discriminant >= 0"],
        why: "Left from chapter 2: true turns into t = 1 for every hit. The disc is right, its \
              colors are a wheel of directions without depth.",
        made_in: |letters| letters != Letters::Rust,
        ..ROOT
    },
    Slip {
        name: "minus-one-is-true",
        more: &[
            "if discriminant < 0.0 { return None; } Some((-b - discriminant.sqrt()) / (2.0 * a))→Some(1.0)",
            "if discriminant < 0.0 { return None; } Some((h - discriminant.sqrt()) / a)→Some(1.0)",
        ],
        cpp: "double hit_sphere(…) { … return -1.0;",
        edits: &["double→bool"],
        why: "As a bool every number but 0 is true: all rays hit at t = 1, also those that miss.",
        reported: &["#157"],
        made_in: |letters| matches!(letters, Letters::Book(_)),
        ..ROOT
    },
    Slip {
        name: "minus-h",
        page: "half_b_sphere#the-sign-that-got-lost",
        edits: &["(h→(-h", "(-half_b→(half_b"],
        why: "h is half of minus b, and half_b is half of b: the root begins with h, or with \
              -half_b. With the other sign it is minus the far root, and the sphere is behind the \
              camera.",
        reported: &["#1292", "PR #1304", "#1643"],
        ..ROOT_BY_H
    },
    Slip {
        name: "plus-b",
        page: "editions#every-mixture",
        edits: &["-b→b"],
        why: "Without the minus it is minus the far root, and the sphere is behind the camera.",
        ..ROOT
    },
    Slip {
        name: "far-root",
        edits: &[" - → + "],
        why: "The plus gives the far side of the sphere, seen from inside.",
        ..ROOT
    },
    Slip {
        name: "square-root-forgotten",
        edits: &["discriminant.sqrt()→discriminant"],
        why: "The discriminant's sign alone makes the disc, but the points are not on it.",
        ..ROOT
    },
    Slip {
        name: "two-a-without-brackets",
        edits: &["(2.0 * a)→2.0 * a"],
        why: "That divides by 2 and multiplies by a. In the middle, where a is 1, it is right.",
        ..ROOT
    },
    Slip {
        name: "numerator-without-brackets",
        older: "(-b - sqrt(discriminant)) / (2*a), or (-half_b - sqrt(discriminant)) / a",
        edits: &[
            "(-b - discriminant.sqrt())→-b - discriminant.sqrt()",
            "(h - discriminant.sqrt())→h - discriminant.sqrt()",
            "→-b - sqrt(discriminant) / (2*a), or -half_b - sqrt(discriminant) / a",
        ],
        why: "Only the square root is divided: right at most in the middle, where a is 1.",
        ..ROOT
    },
    Slip {
        name: "divided-by-a",
        edits: &["(2.0 * a)→a"],
        why: "That is the next chapter's division, where b is halved. Here t is twice as large.",
        ..ROOT
    },
    Slip {
        name: "divided-by-two-a",
        edits: &["/ a→/ (2.0 * a)"],
        why: "Halving b cancels the 2. With it t is half as large.",
        ..ROOT_BY_H
    },
    Slip {
        name: "not-divided",
        more: &[
            "Some((h - discriminant.sqrt()) / a)→Some(h - discriminant.sqrt())",
            "[(h - sqrtd) / a, (h + sqrtd) / a]→[h - sqrtd, h + sqrtd]",
        ],
        edits: &[
            "(h - discriminant.sqrt()) / a→h - discriminant.sqrt()",
            "→-half_b - sqrt(discriminant)",
        ],
        why: "That is right for unit directions only, and most rays here are longer.",
        ..ROOT_BY_H
    },
];
