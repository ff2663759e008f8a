//! Slips in which hits count, and in the color of a hit.

use common::rtweekend::*;

use super::chapters::{HITTABLE_LIST, ONE_SPHERE, ROOTS};
use super::sphere::SIGN_OF_B;
use crate::chapter::Chapter;
use crate::program::{Ball, Program};
use crate::slip::{Slip, Unseen};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "behind-drawn",
        chapters: ONE_SPHERE,
        wrong: "if (hit_sphere(…)) without t > 0",
        right: "if (t > 0)",
        explanation: "A negative t is a point behind the camera. The book's sphere is in front, so nothing shows it.",
        evidence: &["#1570"],
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            t_min: f64::NEG_INFINITY,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "range-loosened",
        chapters: ONE_SPHERE,
        wrong: "if (t > -1)",
        right: "if (t > 0)",
        explanation: "Often tried to bring back a sphere that a slip in a sign has lost. It counts points just behind the camera.",
        evidence: &["#1643", "#1558"],
        page: "half_b_sphere#the-sign-that-got-lost",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            t_min: -1.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "only-behind-drawn",
        chapters: ONE_SPHERE,
        wrong: "if (t < 0)",
        right: "if (t > 0)",
        explanation: "What is in front of the camera is left out, and a miss is drawn: its -1.0 is a t like any other.",
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            search: only_behind,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "sphere-at-plus-one",
        chapters: &[Chapter::RedSphere, Chapter::Normals, Chapter::HalfBSphere],
        wrong: "center = (0, 0, 1)",
        right: "center = (0, 0, -1)",
        explanation: "The sphere is behind the camera. Chapter 2 draws it all the same, the later ones must not.",
        evidence: &["#1570"],
        page: "normals#where-the-nearer-root",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            world: const { &[Ball::new(0.0, 0.0, 1.0, 0.5)] },
            ..right
        },
        unseen: SIGN_OF_B,
        ..Slip::USUAL
    },
    Slip {
        name: "normal-from-point",
        chapters: ROOTS,
        wrong: "N = unit_vector(r.at(t))",
        right: "N = unit_vector(r.at(t) - center)",
        explanation: "A normal points away from the center of the sphere, not from the eye.",
        page: "normals#which-way-the-normal",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            outward: |program, point, _| (program.unit)(point),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "center-added",
        chapters: ROOTS,
        wrong: "N = unit_vector(r.at(t) + center)",
        right: "N = unit_vector(r.at(t) - center)",
        explanation: "A normal is the way from the center to the point, a difference.",
        page: "normals#which-way-the-normal",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            outward: |program, point, ball| rescaled(program, point + ball.center, ball),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "center-after-unit",
        chapters: ROOTS,
        wrong: "N = unit_vector(r.at(t)) - center",
        right: "N = unit_vector(r.at(t) - center)",
        explanation: "The bracket closes too early: the center is taken from a vector that is 1 long already, and the difference is not.",
        page: "normals#which-way-the-normal",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            outward: |program, point, ball| (program.unit)(point) - ball.center,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "normal-inward",
        chapters: ROOTS,
        wrong: "N = unit_vector(center - r.at(t))",
        right: "N = unit_vector(r.at(t) - center)",
        explanation: "The way from the point to the center points in.",
        page: "normals#which-way-the-normal",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            outward: |program, point, ball| rescaled(program, ball.center - point, ball),
            ..right
        },
        unseen: &[(
            HITTABLE_LIST,
            Unseen::OnlyByLaw("The front face is hit exactly when the ray comes from outside."),
        )],
        ..Slip::USUAL
    },
    Slip {
        name: "normal-not-unit",
        chapters: ROOTS,
        wrong: "N = r.at(t) - center",
        right: "N = unit_vector(r.at(t) - center)",
        explanation: "Its length is the radius, and colors are made for length 1: a small sphere fades to gray, the ground leaves the range.",
        evidence: &["#1062", "#525"],
        page: "normals#which-way-the-normal",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            outward: |_, point, ball| point - ball.center,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "normal-times-radius",
        chapters: HITTABLE_LIST,
        wrong: "outward_normal = (p - center) * radius",
        right: "outward_normal = (p - center) / radius",
        explanation: "The way from the center to the point is as long as the radius: dividing makes it a unit vector.",
        page: "normals#which-way-the-normal",
        source: "chapters/5_hittable_list/src/sphere.rs",
        alter: |right| Program {
            outward: |_, point, ball| (point - ball.center) * ball.radius,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "unit-vector-for-radius",
        chapters: HITTABLE_LIST,
        wrong: "outward_normal = unit_vector(p - center)",
        right: "outward_normal = (p - center) / radius",
        explanation: "Only slower, since p is on the sphere. It matters for a negative radius, which turns the normal here and was a trick of older editions.",
        evidence: &["#977"],
        page: "normals#which-way-the-normal",
        source: "chapters/5_hittable_list/src/sphere.rs",
        alter: |right| Program {
            outward: |program, point, ball| (program.unit)(point - ball.center),
            ..right
        },
        unseen: &[(
            HITTABLE_LIST,
            Unseen::Equivalent(
                "The point is on the sphere, so its distance from the center is the radius, but for a few roundings.",
            ),
        )],
        ..Slip::USUAL
    },
    Slip {
        name: "point-along-unit-direction",
        chapters: ROOTS,
        wrong: "r.at(t) = origin + t * unit_vector(direction)",
        right: "r.at(t) = origin + t * direction",
        explanation: "t counts lengths of the direction, whatever that length is.",
        page: "gradient#a-ray-is-a-function",
        source: "common/src/ray.rs",
        alter: |right| Program {
            at: |program, ray, t| ray.origin + t * (program.unit)(ray.direction),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "point-without-origin",
        chapters: ROOTS,
        wrong: "r.at(t) = t * direction",
        right: "r.at(t) = origin + t * direction",
        explanation: "It shows as soon as a ray starts anywhere but at the origin.",
        page: "gradient#a-ray-is-a-function",
        source: "common/src/ray.rs",
        alter: |right| Program {
            at: |_, ray, t| t * ray.direction,
            ..right
        },
        unseen: &[(ROOTS, Unseen::OnlyByLaw("A ray is at its origin at t = 0."))],
        ..Slip::USUAL
    },
    Slip {
        name: "normal-not-mapped",
        chapters: ROOTS,
        wrong: "color(N.x(), N.y(), N.z())",
        right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
        explanation: "A normal's components run from -1 to 1, a color's from 0 to 1. Negative ones are printed or cut off.",
        page: "normals#a-color-for-each-direction",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            shade: |_, normal| normal,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "normal-only-halved",
        chapters: ROOTS,
        wrong: "0.5 * color(N.x(), N.y(), N.z())",
        right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
        explanation: "Without the 1 half of the components stay negative.",
        page: "normals#a-color-for-each-direction",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            shade: |_, normal| 0.5 * normal,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "normal-only-shifted",
        chapters: ROOTS,
        wrong: "color(N.x() + 1, N.y() + 1, N.z() + 1)",
        right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
        explanation: "Without the half components run from 0 to 2, and half of them are too bright for a picture.",
        page: "normals#a-color-for-each-direction",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            shade: |_, normal| normal + Vec3::ONE,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "normal-without-brackets",
        chapters: ROOTS,
        wrong: "0.5 * N + color(1, 1, 1)",
        right: "0.5 * (N + color(1, 1, 1))",
        explanation: "The half takes the normal alone, so components run from 0.5 to 1.5, and half of them are too bright for a picture.",
        page: "normals#a-color-for-each-direction",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            shade: |_, normal| 0.5 * normal + Vec3::ONE,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "normal-channels-reversed",
        chapters: ROOTS,
        wrong: "0.5 * color(N.z() + 1, N.y() + 1, N.x() + 1)",
        right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
        explanation: "x is red and z is blue. The sky is right, the sphere's red and blue have changed places.",
        page: "normals#a-color-for-each-direction",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            shade: |_, normal| 0.5 * (Vec3::new(normal.z, normal.y, normal.x) + Vec3::ONE),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "normal-in-gray",
        chapters: ROOTS,
        wrong: "0.5 * color(N.x() + 1, N.x() + 1, N.x() + 1)",
        right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
        explanation: "A copied term keeps its letter: with one component for all three, what is hit is gray.",
        page: "normals#a-color-for-each-direction",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            shade: |_, normal| 0.5 * (Vec3::splat(normal.x) + Vec3::ONE),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "normal-as-absolute",
        chapters: ROOTS,
        wrong: "color(abs(N.x()), abs(N.y()), abs(N.z()))",
        right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
        explanation: "Absolute values fit into a color, but left and right, above and below look the same.",
        page: "normals#a-color-for-each-direction",
        source: "chapters/3_normals/src/lib.rs",
        alter: |right| Program {
            shade: |_, normal| normal.abs(),
            ..right
        },
        ..Slip::USUAL
    },
];

/// A vector as long as the sphere's radius made one of length 1, in the way of
/// the chapter: by its own length, or from chapter 5 on by the radius.
fn rescaled(program: &Program, v: Vec3, ball: Ball) -> Vec3 {
    match program.chapter {
        Chapter::HittableList => v * (1.0 / ball.radius),
        _ => (program.unit)(v),
    }
}

/// A miss is the book's -1.0, which is below 0.
fn only_behind(program: &Program, ray: &Ray) -> Option<(f64, Ball)> {
    let ball = *program.world.first()?;
    let t = program.hit_sphere(ball.center, ball.radius, ray);
    let t = t.unwrap_or(-1.0);
    (t < 0.0).then_some((t, ball))
}
