//! Slips in the list, and in what only chapter 5 has.

use common::rtweekend::*;

use super::chapters::HITTABLE_LIST;
use crate::program::{BALL, Ball, Program};
use crate::slip::{Slip, Unseen};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "closest-ignored",
        chapters: HITTABLE_LIST,
        wrong: "if (object.hit(r, t_min, t_max, rec))",
        right: "if (object.hit(r, t_min, closest_so_far, rec))",
        explanation: "Each hit replaces the one before, however far it is. The ground, added last, covers the sphere's lower part.",
        evidence: &["#671", "#1711"],
        page: "hittable_list#the-nearest-one",
        source: "chapters/5_hittable_list/src/hittable_list.rs",
        alter: |right| Program {
            search: last_hit,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "first-hit-wins",
        chapters: HITTABLE_LIST,
        wrong: "if (object.hit(…)) return true",
        right: "closest_so_far = rec.t; …",
        explanation: "The first object that is hit hides nearer ones that follow. The book adds the near sphere first, so its picture is right.",
        page: "hittable_list#the-nearest-one",
        source: "chapters/5_hittable_list/src/hittable_list.rs",
        alter: |right| Program {
            search: first_hit,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "farthest-wins",
        chapters: HITTABLE_LIST,
        wrong: "if (rec.t > closest_so_far)",
        right: "if (rec.t < closest_so_far)",
        explanation: "The farthest hit covers all nearer ones.",
        page: "hittable_list#the-nearest-one",
        source: "chapters/5_hittable_list/src/hittable_list.rs",
        alter: |right| Program {
            search: farthest_hit,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "near-root-only",
        chapters: HITTABLE_LIST,
        wrong: "root = (h - sqrtd) / a; if (!range.surrounds(root)) return false",
        right: "… root = (h + sqrtd) / a; if (!range.surrounds(root)) return false",
        explanation: "From inside a sphere the nearer root is behind, and the far one is what the eye sees.",
        page: "hittable_list#the-nearest-one",
        source: "chapters/5_hittable_list/src/sphere.rs",
        alter: |right| Program {
            numerators: |first, sqrtd, _| [first - sqrtd; 2],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "range-not-tested",
        chapters: HITTABLE_LIST,
        wrong: "root = (h - sqrtd) / a; rec.t = root",
        right: "if (!ray_t.surrounds(root)) …",
        explanation: "Hits behind the camera count too, and beat those in front: the sky shows the ground's back.",
        page: "hittable_list#anything-that-a-ray-can-hit",
        source: "chapters/5_hittable_list/src/sphere.rs",
        alter: |right| Program {
            in_range: |_, _, _| true,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "range-behind-allowed",
        chapters: HITTABLE_LIST,
        wrong: "world.hit(r, interval(-infinity, infinity), rec)",
        right: "world.hit(r, interval(0, infinity), rec)",
        explanation: "The nearest t of all is the smallest: the ground behind the camera beats what is in front.",
        page: "hittable_list#anything-that-a-ray-can-hit",
        source: "chapters/5_hittable_list/src/lib.rs",
        alter: |right| Program {
            t_min: f64::NEG_INFINITY,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "range-closed",
        chapters: HITTABLE_LIST,
        wrong: "t_min <= t && t <= t_max",
        right: "t_min < t && t < t_max",
        explanation: "A root exactly at an end of the interval does not count: a ray that leaves a surface must not hit it at t = 0.",
        page: "hittable_list#anything-that-a-ray-can-hit",
        source: "chapters/5_hittable_list/src/sphere.rs",
        alter: |right| Program {
            in_range: |t_min, t, t_max| t_min <= t && t <= t_max,
            ..right
        },
        unseen: &[(
            HITTABLE_LIST,
            Unseen::OnlyByLaw("A root at an end of the interval is no hit."),
        )],
        ..Slip::USUAL
    },
    Slip {
        name: "range-too-early",
        chapters: HITTABLE_LIST,
        wrong: "world.hit(r, interval(0.001, infinity), rec)",
        right: "world.hit(r, interval(0, infinity), rec)",
        explanation: "A later chapter needs it, where rays start on surfaces. Here they start at the eye.",
        page: "hittable_list#anything-that-a-ray-can-hit",
        source: "chapters/5_hittable_list/src/lib.rs",
        alter: |right| Program {
            t_min: 0.001,
            ..right
        },
        unseen: &[(
            HITTABLE_LIST,
            Unseen::Equivalent(
                "No surface of any scene here is so near to the eye that t is 0.001 or less.",
            ),
        )],
        ..Slip::USUAL
    },
    Slip {
        name: "face-normal-missing",
        chapters: HITTABLE_LIST,
        wrong: "rec.normal = outward_normal",
        right: "rec.set_face_normal(r, outward_normal)",
        explanation: "From inside a sphere the normal has to turn against the ray. The book's camera is outside of everything.",
        page: "hittable_list#outward-or-against-the-ray",
        source: "chapters/5_hittable_list/src/hittable.rs",
        alter: |right| Program {
            face: |_, _, outward| outward,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "faces-swapped",
        chapters: HITTABLE_LIST,
        wrong: "normal = front_face ? -outward_normal : outward_normal",
        right: "normal = front_face ? outward_normal : -outward_normal",
        explanation: "Every normal points along the ray, into what it belongs to.",
        evidence: &["#720", "#1729"],
        page: "hittable_list#outward-or-against-the-ray",
        source: "chapters/5_hittable_list/src/hittable.rs",
        alter: |right| Program {
            face: |program, direction, outward| {
                if (program.dot)(direction, outward) < 0.0 {
                    -outward
                } else {
                    outward
                }
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "ground-too-high",
        chapters: HITTABLE_LIST,
        wrong: "sphere((0, -100, -1), 100)",
        right: "sphere((0, -100.5, -1), 100)",
        explanation: "The small sphere must stand on the ground, its lowest point at -0.5. Here it is half sunk.",
        page: "hittable_list#the-world",
        source: "chapters/5_hittable_list/src/lib.rs",
        alter: |right| Program {
            world: const { &[BALL, Ball::new(0.0, -100.0, -1.0, 100.0)] },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "ground-too-large",
        chapters: HITTABLE_LIST,
        wrong: "sphere((0, -100.5, -1), 100.5)",
        right: "sphere((0, -100.5, -1), 100)",
        explanation: "The ground reaches up to 0, so the small sphere is half sunk.",
        page: "hittable_list#the-world",
        source: "chapters/5_hittable_list/src/lib.rs",
        alter: |right| Program {
            world: const { &[BALL, Ball::new(0.0, -100.5, -1.0, 100.5)] },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "ground-above",
        chapters: HITTABLE_LIST,
        wrong: "sphere((0, 100.5, -1), 100)",
        right: "sphere((0, -100.5, -1), 100)",
        explanation: "y points up, so the ground's center is far below. Without the minus it hangs in the sky.",
        page: "hittable_list#the-world",
        source: "chapters/5_hittable_list/src/lib.rs",
        alter: |right| Program {
            world: const { &[BALL, Ball::new(0.0, 100.5, -1.0, 100.0)] },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "ceiling-added",
        chapters: HITTABLE_LIST,
        wrong: "… and world.add(sphere((0, 100.5, -1), 100))",
        right: "world.add(sphere((0, 0, -1), 0.5)) and world.add(sphere((0, -100.5, -1), 100))",
        explanation: "A third sphere, as large as the ground, hangs above the scene and hides most of the sky.",
        page: "hittable_list#the-world",
        source: "chapters/5_hittable_list/src/lib.rs",
        alter: |right| Program {
            world: const {
                &[
                    BALL,
                    Ball::new(0.0, -100.5, -1.0, 100.0),
                    Ball::new(0.0, 100.5, -1.0, 100.0),
                ]
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "ground-below-the-eye",
        chapters: HITTABLE_LIST,
        wrong: "sphere((0, -100.5, 0), 100)",
        right: "sphere((0, -100.5, -1), 100)",
        explanation: "The ground's center lies below the sphere. A unit nearer, its colors shift a little.",
        page: "hittable_list#the-world",
        source: "chapters/5_hittable_list/src/lib.rs",
        alter: |right| Program {
            world: const { &[BALL, Ball::new(0.0, -100.5, 0.0, 100.0)] },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "ground-not-added",
        chapters: HITTABLE_LIST,
        wrong: "world.add(sphere((0, 0, -1), 0.5))",
        right: "… and world.add(sphere((0, -100.5, -1), 100))",
        explanation: "Without the ground the picture is that of the chapter before.",
        page: "hittable_list#the-world",
        source: "chapters/5_hittable_list/src/lib.rs",
        alter: |right| Program {
            world: &[BALL],
            ..right
        },
        ..Slip::USUAL
    },
];

/// All hits in the order of the list, each looked for in the whole interval.
fn hits<'a>(program: &'a Program, ray: &'a Ray) -> impl DoubleEndedIterator<Item = (f64, Ball)> {
    program.balls().filter_map(|ball| {
        let t = program.hit(ball, ray, program.t_min, program.t_max)?;
        Some((t, ball))
    })
}

fn first_hit(program: &Program, ray: &Ray) -> Option<(f64, Ball)> {
    hits(program, ray).next()
}

fn last_hit(program: &Program, ray: &Ray) -> Option<(f64, Ball)> {
    hits(program, ray).next_back()
}

fn farthest_hit(program: &Program, ray: &Ray) -> Option<(f64, Ball)> {
    hits(program, ray).max_by(|(t, _), (other, _)| t.total_cmp(other))
}
