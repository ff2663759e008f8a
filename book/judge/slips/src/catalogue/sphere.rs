//! Slips in the quadratic.

use super::chapters::{FULL_B, HALF_B, NORMALS, ONE_SPHERE, RED_SPHERE, ROOTS, SPHERES};
use crate::chapter::Chapter::{HalfBSphere, HittableList, Normals};
use crate::edition::Edition;
use crate::letters::Letters;
use crate::slip::{Part, SLIP, Slip};

/// Why chapter 2 does not show a slip in the sign of b.
pub(super) const SIGN_OF_B: &str =
    "Only the sign of b changes, and the discriminant has its square.";

const COEFFICIENTS: Slip = Slip {
    chapters: SPHERES,
    page: "red_sphere#the-ray-in-the-equation",
    source: "chapters/2_red_sphere/src/lib.rs",
    ..SLIP
};
const A: Slip = Slip {
    rust: "a = ray.direction.dot(ray.direction)",
    ..COEFFICIENTS
};
const B: Slip = Slip {
    chapters: FULL_B,
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
    source: "common/src/vec3.rs",
    part: Part::Prelude,
    rust: "self.x * other.x + self.y * other.y + self.z * other.z",
    cpp: "u.x*v.x + u.y*v.y + u.z*v.z",
    ..COEFFICIENTS
};
const ROOT: Slip = Slip {
    chapters: ROOTS,
    page: "normals#where-the-nearer-root",
    source: "chapters/3_normals/src/lib.rs",
    rust: "(-b - discriminant.sqrt()) / (2.0 * a)",
    later: Some((HalfBSphere, "(h - discriminant.sqrt()) / a")),
    ..SLIP
};
const HALF: Slip = Slip {
    chapters: HALF_B,
    page: "half_b_sphere#two-observations",
    source: "chapters/4_half_b_sphere/src/lib.rs",
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
        alter: |p| p.oc = |center, origin| origin - center,
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
        alter: |p| p.linear = |d_oc| 2.0 * d_oc,
        ..B
    },
    Slip {
        name: "b-not-doubled",
        edits: &["2.0 * →"],
        why: "The formula is the one for the whole of b: the discriminant is far too small.",
        alter: |p| p.linear = |d_oc| -d_oc,
        ..B
    },
    Slip {
        name: "h-doubled",
        older: "half_b = dot(oc, r.direction())",
        edits: &["half_b =→half_b = 2.0 *", "h =→h = -2.0 *"],
        why: "That is b, and the formula is the one for half of it: the discriminant is far \
              too large.",
        alter: |p| {
            p.linear = match p.edition {
                Edition::V4 => |d_oc| -2.0 * d_oc,
                // Half of b is minus h there, and the root begins with a minus.
                _ => |d_oc| 2.0 * d_oc,
            }
        },
        ..H
    },
    Slip {
        name: "h-sign",
        edits: &["h = →h = -"],
        why: "b is -2h, so the minus of b is in the 2 already. With a second minus every \
              root changes its sign and the sphere is behind the camera.",
        alter: |p| p.linear = |d_oc| -d_oc,
        ..H
    },
    Slip {
        name: "discriminant-without-four",
        chapters: FULL_B,
        edits: &["4.0 * →"],
        why: "The 4 goes only if b is halved. The discriminant is too large, and every ray hits.",
        reported: &["#113", "#126", "#146", "RayTracing/InOneWeekend#17"],
        alter: |p| p.four = 1.0,
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
        alter: |p| p.four = 4.0,
        ..HALF
    },
    Slip {
        name: "discriminant-with-plus",
        edits: &[" - → + "],
        why: "From outside a sphere c is positive, so the sum is too: every line seems to hit.",
        alter: |p| p.discriminant = |four, a, b, c| b * b + four * a * c,
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
        alter: |p| p.meets = |discriminant| discriminant > 0.0,
        ..SIGN
    },
    Slip {
        name: "hit-and-miss-swapped",
        cpp: "if (discriminant < 0) miss",
        edits: &[">=→<=", "<→>"],
        why: "Lines that pass through the sphere have two roots, and a positive discriminant.",
        alter: |p| p.meets = |discriminant| discriminant <= 0.0,
        ..SIGN
    },
    Slip {
        name: "radius-not-squared",
        edits: &["radius * radius→radius"],
        why: "A radius of 0.5 acts as its square root, 0.707: the disc is too large.",
        alter: |p| p.constant = |oc_squared, radius| oc_squared - radius,
        ..C
    },
    Slip {
        name: "a-taken-as-one",
        edits: &["ray.direction.dot(ray.direction)→1.0"],
        why: "That holds for unit directions only. With a too small, every ray here hits.",
        alter: |p| p.a = |_, _| 1.0,
        ..A
    },
    Slip {
        name: "a-from-length",
        edits: &["dot(ray.direction)→length()"],
        why: "a is the square of the direction's length, which is 1 only in the middle.",
        alter: |p| p.a = |program, direction| (program.squared)(program, direction).sqrt(),
        ..A
    },
    Slip {
        name: "dot-with-swapped-letter",
        edits: &["other.z→self.z", "v.z→u.z"],
        why: "With oc.z and d.z both -1 the last product is right by chance. Any other sphere, \
              and every normal's side, is wrong.",
        reported: &["#1292"],
        alter: |p| p.dot = |u, v| u.x * v.x + u.y * v.y + u.z * u.z,
        ..DOT
    },
    Slip {
        name: "stale-boolean",
        chapters: ONE_SPHERE,
        edits: &["→return discriminant >= 0"],
        why: "Left from chapter 2: true turns into t = 1 for every hit. The disc is right, its \
              colors are a wheel of directions without depth.",
        made_in: |letters| letters != Letters::Rust,
        alter: |p| p.divide = |_, _| 1.0,
        ..ROOT
    },
    Slip {
        name: "minus-one-is-true",
        chapters: ONE_SPHERE,
        cpp: "double hit_sphere(…) { … return -1.0;",
        edits: &["double→bool"],
        why: "As a bool every number but 0 is true: all rays hit at t = 1, also those that miss.",
        reported: &["#157"],
        made_in: |letters| matches!(letters, Letters::Book(_)),
        alter: |p| {
            p.meets = |_| true;
            p.divide = |_, _| 1.0;
        },
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
        alter: |p| p.first_term = |h| -h,
        ..ROOT_BY_H
    },
    Slip {
        name: "plus-b",
        chapters: NORMALS,
        page: "editions#every-mixture",
        edits: &["-b→b"],
        why: "Without the minus it is minus the far root, and the sphere is behind the camera.",
        alter: |p| p.first_term = |b| b,
        ..ROOT
    },
    Slip {
        name: "far-root",
        edits: &[" - → + "],
        why: "The plus gives the far side of the sphere, seen from inside.",
        alter: |p| p.numerators = |first, sqrtd, _| [first + sqrtd; 2],
        ..ROOT
    },
    Slip {
        name: "square-root-forgotten",
        edits: &["discriminant.sqrt()→discriminant"],
        why: "The discriminant's sign alone makes the disc, but the points are not on it.",
        alter: |p| p.sqrt = |discriminant| discriminant,
        ..ROOT
    },
    Slip {
        name: "two-a-without-brackets",
        chapters: NORMALS,
        edits: &["(2.0 * a)→2.0 * a"],
        why: "That divides by 2 and multiplies by a. In the middle, where a is 1, it is right.",
        alter: |p| p.divide = |numerator, a| numerator / 2.0 * a,
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
        alter: |p| {
            p.numerators = match p.chapter {
                Normals => |first, sqrtd, a| [first - sqrtd / (2.0 * a); 2],
                HittableList => |first, sqrtd, a| [first - sqrtd / a, first + sqrtd / a],
                _ => |first, sqrtd, a| [first - sqrtd / a; 2],
            };
            p.divide = |root, _| root;
        },
        ..ROOT
    },
    Slip {
        name: "divided-by-a",
        chapters: NORMALS,
        edits: &["(2.0 * a)→a"],
        why: "That is the next chapter's division, where b is halved. Here t is twice as large.",
        alter: |p| p.divide = |numerator, a| numerator / a,
        ..ROOT
    },
    Slip {
        name: "divided-by-two-a",
        edits: &["/ a→/ (2.0 * a)"],
        why: "Halving b cancels the 2. With it t is half as large.",
        alter: |p| p.divide = |numerator, a| numerator / (2.0 * a),
        ..ROOT_BY_H
    },
    Slip {
        name: "not-divided",
        edits: &[
            "(h - discriminant.sqrt()) / a→h - discriminant.sqrt()",
            "→-half_b - sqrt(discriminant)",
        ],
        why: "That is right for unit directions only, and most rays here are longer.",
        alter: |p| p.divide = |numerator, _| numerator,
        ..ROOT_BY_H
    },
];
