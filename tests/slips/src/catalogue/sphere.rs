//! Slips in the quadratic.

use super::chapters::{FULL_B, HALF_B, NORMALS, ONE_SPHERE, RED_SPHERE, ROOTS, SPHERES};
use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::program::Program;
use crate::slip::{Slip, Unseen};

/// Why chapter 2 does not show a slip in the sign of b.
pub(super) const SIGN_OF_B: &[(&[Chapter], Unseen)] = &[(
    RED_SPHERE,
    Unseen::Equivalent("Only the sign of b changes, and the discriminant has its square."),
)];

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "oc-reversed",
        chapters: SPHERES,
        wrong: "oc = r.origin() - center",
        right: "oc = center - r.origin()",
        explanation: "Older editions have it this way round, with another sign in the formula. Mixed, every root changes its sign and the sphere is behind the camera.",
        before_4: Some([
            "oc = center - r.origin()",
            "oc = r.origin() - center",
            "Version 4 has it that way round, with another sign in the formula. Mixed, every root changes its sign and the sphere is behind the camera.",
        ]),
        evidence: &["#1292", "PR #1304", "#1643"],
        page: "editions#every-mixture",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            oc: |center, origin| origin - center,
            ..right
        },
        unseen: SIGN_OF_B,
    },
    Slip {
        name: "b-sign",
        chapters: FULL_B,
        wrong: "b = 2 * dot(r.direction(), oc)",
        right: "b = -2 * dot(r.direction(), oc)",
        explanation: "The sign belongs to oc = center - origin. Without it every root changes its sign and the sphere is behind the camera.",
        before_4: Some([
            "b = -2.0 * dot(oc, r.direction())",
            "b = 2.0 * dot(oc, r.direction())",
            "The minus belongs to oc = center - origin, as in version 4. With it every root changes its sign and the sphere is behind the camera.",
        ]),
        evidence: &["#1292", "#1643"],
        page: "editions#every-mixture",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            linear: |d_oc| 2.0 * d_oc,
            ..right
        },
        unseen: SIGN_OF_B,
    },
    Slip {
        name: "b-not-doubled",
        chapters: FULL_B,
        wrong: "b = -dot(r.direction(), oc)",
        right: "b = -2 * dot(r.direction(), oc)",
        explanation: "That is half of b, and the formula is the one for the whole: the discriminant is far too small.",
        before_4: Some([
            "b = dot(oc, r.direction())",
            "b = 2.0 * dot(oc, r.direction())",
            "That is half of b, and the formula is the one for the whole: the discriminant is far too small.",
        ]),
        page: "red_sphere#the-ray-in-the-equation",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            linear: |d_oc| -d_oc,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "h-doubled",
        chapters: HALF_B,
        wrong: "h = -2 * dot(r.direction(), oc)",
        right: "h = dot(r.direction(), oc)",
        explanation: "That is b, and the formula is the one for half of it: the discriminant is far too large, and every root is behind the camera.",
        before_4: Some([
            "half_b = 2.0 * dot(oc, r.direction())",
            "half_b = dot(oc, r.direction())",
            "That is b, and the formula is the one for half of it: the discriminant is far too large.",
        ]),
        page: "half_b_sphere#two-observations",
        source: "chapters/4_half_b_sphere/src/lib.rs",
        alter: |right| Program {
            linear: match right.edition {
                Edition::V4 => |d_oc| -2.0 * d_oc,
                // Half of b is minus h there, and the root begins with a minus.
                _ => |d_oc| 2.0 * d_oc,
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "discriminant-without-four",
        chapters: FULL_B,
        wrong: "discriminant = b*b - a*c",
        right: "discriminant = b*b - 4*a*c",
        explanation: "The 4 goes only if b is halved. Here the discriminant is too large, and every ray hits.",
        evidence: &["#113", "#126", "#146", "RayTracing/InOneWeekend#17"],
        page: "red_sphere#what-the-discriminant-says",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            discriminant: |a, b, c| b * b - a * c,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "discriminant-with-four",
        chapters: HALF_B,
        wrong: "discriminant = h*h - 4*a*c",
        right: "discriminant = h*h - a*c",
        explanation: "Halving b cancels the 4. With it the discriminant is too small, and the small sphere is gone.",
        before_4: Some([
            "discriminant = half_b*half_b - 4*a*c",
            "discriminant = half_b*half_b - a*c",
            "Halving b cancels the 4. With it the discriminant is too small, and the small sphere is gone.",
        ]),
        evidence: &["#113", "#126", "#146", "RayTracing/InOneWeekend#17"],
        page: "half_b_sphere#two-observations",
        source: "chapters/4_half_b_sphere/src/lib.rs",
        alter: |right| Program {
            discriminant: |a, h, c| h * h - 4.0 * a * c,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "discriminant-with-plus",
        chapters: SPHERES,
        wrong: "b*b + 4*a*c, or h*h + a*c",
        right: "b*b - 4*a*c, or h*h - a*c",
        explanation: "From outside a sphere c is positive, so the sum is as well, and every line seems to meet the sphere.",
        page: "red_sphere#what-the-discriminant-says",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            discriminant: match right.chapter {
                Chapter::RedSphere | Chapter::Normals => |a, b, c| b * b + 4.0 * a * c,
                _ => |a, h, c| h * h + a * c,
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "tangent-missed",
        chapters: SPHERES,
        wrong: "discriminant > 0",
        right: "discriminant >= 0",
        explanation: "A ray that only touches the sphere has one root, and the discriminant is 0. No ray of the camera touches exactly.",
        evidence: &["#110", "#1057", "#1058", "PR #1124"],
        page: "red_sphere#what-the-discriminant-says",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            meets: |discriminant| discriminant > 0.0,
            ..right
        },
        unseen: &[(SPHERES, Unseen::OnlyByLaw("A tangent is a hit."))],
        ..Slip::USUAL
    },
    Slip {
        name: "radius-not-squared",
        chapters: SPHERES,
        wrong: "c = dot(oc, oc) - radius",
        right: "c = dot(oc, oc) - radius*radius",
        explanation: "A radius of 0.5 acts as its square root, 0.707: the disc is too large.",
        page: "red_sphere#the-equation-of-a-sphere",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            constant: |oc_squared, radius| oc_squared - radius,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "radius-added",
        chapters: SPHERES,
        wrong: "c = dot(oc, oc) + radius*radius",
        right: "c = dot(oc, oc) - radius*radius",
        explanation: "The square of the radius comes from the right side of the equation. With a plus there is no such sphere.",
        page: "red_sphere#the-equation-of-a-sphere",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            constant: |oc_squared, radius| oc_squared + radius * radius,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "center-not-squared",
        chapters: SPHERES,
        wrong: "c = oc.length() - radius*radius",
        right: "c = dot(oc, oc) - radius*radius",
        explanation: "The equation has the square of the distance. Near 1 the two are alike, so a sphere at -1 hides it.",
        page: "red_sphere#the-equation-of-a-sphere",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            constant: |oc_squared, radius| oc_squared.sqrt() - radius * radius,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "a-taken-as-one",
        chapters: SPHERES,
        wrong: "a = 1",
        right: "a = dot(r.direction(), r.direction())",
        explanation: "That holds for unit directions only. Here it gives every ray the discriminant of the one in the middle, and every ray hits.",
        page: "red_sphere#the-ray-in-the-equation",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            a: |_, _| 1.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "dot-with-swapped-letter",
        chapters: SPHERES,
        wrong: "u.x*v.x + u.y*v.y + u.z*u.z",
        right: "u.x*v.x + u.y*v.y + u.z*v.z",
        explanation: "With oc.z and d.z both -1 the last product is right by chance. Any other sphere, and every normal's side, is wrong.",
        evidence: &["#1292"],
        page: "red_sphere#the-ray-in-the-equation",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            dot: |u, v| u.x * v.x + u.y * v.y + u.z * u.z,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "dot-without-z",
        chapters: SPHERES,
        wrong: "u.x*v.x + u.y*v.y",
        right: "u.x*v.x + u.y*v.y + u.z*v.z",
        explanation: "A dot product has three terms. Without the third, depth is lost.",
        page: "red_sphere#the-ray-in-the-equation",
        source: "chapters/2_red_sphere/src/lib.rs",
        alter: |right| Program {
            dot: |u, v| u.x * v.x + u.y * v.y,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "stale-boolean",
        chapters: ONE_SPHERE,
        wrong: "return discriminant >= 0",
        right: "return (-b - sqrt(discriminant)) / (2*a)",
        explanation: "Left from chapter 2: true turns into t = 1 for every hit. The disc is right, its colors are a wheel of directions without depth.",
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            divide: |_, _| 1.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "minus-one-is-true",
        chapters: ONE_SPHERE,
        wrong: "bool hit_sphere(…) { … return -1.0;",
        right: "double hit_sphere(…) { … return -1.0;",
        explanation: "As a bool every number but 0 is true, and true turns into t = 1. All pixels are colored, also those that miss.",
        evidence: &["#157"],
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            meets: |_| true,
            divide: |_, _| 1.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "miss-is-one",
        chapters: ONE_SPHERE,
        wrong: "if (discriminant < 0) return 1.0",
        right: "if (discriminant < 0) return -1.0",
        explanation: "The caller takes every t > 0 for a hit. The sphere is right, and around it the sky has the colors of a hit at t = 1.",
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            missed: Some(1.0),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "minus-h",
        chapters: HALF_B,
        wrong: "(-h - sqrt(discriminant)) / a",
        right: "(h - sqrt(discriminant)) / a",
        explanation: "b is -2h, so -b is 2h: the minus is used up. With another one the root is minus the far one, and the sphere is behind the camera.",
        before_4: Some([
            "(half_b - sqrt(discriminant)) / a",
            "(-half_b - sqrt(discriminant)) / a",
            "Here half_b is half of b, so the root begins with a minus, as it does with b. Without it the root is minus the far one, and the sphere is behind the camera.",
        ]),
        evidence: &["#1292", "PR #1304", "#1643"],
        page: "half_b_sphere#the-sign-that-got-lost",
        source: "chapters/4_half_b_sphere/src/lib.rs",
        alter: |right| Program {
            first_term: |h| -h,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "plus-b",
        chapters: NORMALS,
        wrong: "(b - sqrt(discriminant)) / (2*a)",
        right: "(-b - sqrt(discriminant)) / (2*a)",
        explanation: "Without the minus the root is minus the far one, and the sphere is behind the camera.",
        page: "editions#every-mixture",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            first_term: |b| b,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "far-root",
        chapters: ROOTS,
        wrong: "(-b + sqrt(discriminant)) / (2*a)",
        right: "(-b - sqrt(discriminant)) / (2*a)",
        explanation: "The plus gives the far side of the sphere, seen from inside.",
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            numerators: |first, sqrtd, _| [first + sqrtd; 2],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "square-root-forgotten",
        chapters: ROOTS,
        wrong: "(-b - discriminant) / (2*a)",
        right: "(-b - sqrt(discriminant)) / (2*a)",
        explanation: "The discriminant's sign alone decides which lines meet the sphere, so the disc stays; but the points are not on it.",
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            sqrt: |discriminant| discriminant,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "two-a-without-brackets",
        chapters: ROOTS,
        wrong: "(-b - sqrt(discriminant)) / 2*a",
        right: "(-b - sqrt(discriminant)) / (2*a)",
        explanation: "That divides by 2 and then multiplies by a. In the middle, where a is 1, it is right.",
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            // Who types the whole of b in later chapters as well has a numerator twice as
            // large.
            divide: match right.chapter {
                Chapter::Normals => |numerator, a| numerator / 2.0 * a,
                _ => |half, a| half * a,
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "numerator-without-brackets",
        chapters: ROOTS,
        wrong: "-b - sqrt(discriminant) / (2*a), or h - sqrt(discriminant) / a",
        right: "(-b - sqrt(discriminant)) / (2*a), or (h - sqrt(discriminant)) / a",
        explanation: "Only the square root is divided. In the middle, where a is 1, half of b gives the right root even so.",
        before_4: Some([
            "-b - sqrt(discriminant) / (2*a), or -half_b - sqrt(discriminant) / a",
            "(-b - sqrt(discriminant)) / (2*a), or (-half_b - sqrt(discriminant)) / a",
            "Only the square root is divided. In the middle, where a is 1, half of b gives the right root even so.",
        ]),
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            numerators: match right.chapter {
                Chapter::Normals => |first, sqrtd, a| [first - sqrtd / (2.0 * a); 2],
                Chapter::HalfBSphere => |first, sqrtd, a| [first - sqrtd / a; 2],
                _ => |first, sqrtd, a| [first - sqrtd / a, first + sqrtd / a],
            },
            divide: |root, _| root,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "divided-by-a",
        chapters: NORMALS,
        wrong: "(-b - sqrt(discriminant)) / a",
        right: "(-b - sqrt(discriminant)) / (2*a)",
        explanation: "That is the division of the next chapter, where b is halved. Here t is twice as large.",
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            divide: |numerator, a| numerator / a,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "divided-by-two-a",
        chapters: HALF_B,
        wrong: "(h - sqrt(discriminant)) / (2*a)",
        right: "(h - sqrt(discriminant)) / a",
        explanation: "Halving b cancels the 2. With it t is half as large.",
        before_4: Some([
            "(-half_b - sqrt(discriminant)) / (2*a)",
            "(-half_b - sqrt(discriminant)) / a",
            "Halving b cancels the 2. With it t is half as large.",
        ]),
        page: "half_b_sphere#two-observations",
        source: "chapters/4_half_b_sphere/src/lib.rs",
        alter: |right| Program {
            divide: |numerator, a| numerator / (2.0 * a),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "not-divided",
        chapters: HALF_B,
        wrong: "h - sqrt(discriminant)",
        right: "(h - sqrt(discriminant)) / a",
        explanation: "That is right for unit directions only. The rays here are longer away from the middle.",
        before_4: Some([
            "-half_b - sqrt(discriminant)",
            "(-half_b - sqrt(discriminant)) / a",
            "That is right for unit directions only. The rays here are longer away from the middle.",
        ]),
        page: "half_b_sphere#two-observations",
        source: "chapters/4_half_b_sphere/src/lib.rs",
        alter: |right| Program {
            divide: |numerator, _| numerator,
            ..right
        },
        ..Slip::USUAL
    },
];
