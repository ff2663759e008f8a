//! Mistakes in a function of one's own that have no name: only laws look for them, since
//! a picture of these chapters hides them, or nobody has drawn one yet.

use common::rtweekend::*;

use super::chapters::{ONE_SPHERE, ROOTS, SPHERES};
use crate::slip::{SLIP, Slip};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        chapters: SPHERES,
        cpp: "oc = center - r.origin()",
        edits: &[" - r.origin()→"],
        why: "The eye of the book is at the origin, where nothing shows it.",
        alter: |p| p.oc = |center, _| center,
        ..SLIP
    },
    Slip {
        chapters: SPHERES,
        cpp: "oc = center - r.origin()",
        edits: &["-→+"],
        why: "The eye of the book is at the origin, where nothing shows it.",
        alter: |p| p.oc = |center, origin| center + origin,
        ..SLIP
    },
    Slip {
        chapters: ONE_SPHERE,
        cpp: "a negative discriminant is a miss",
        edits: &["→the discriminant is not tested, and its root is not a number"],
        why: "A line that misses the sphere has no root.",
        alter: |p| p.meets = |_| true,
        ..SLIP
    },
    Slip {
        chapters: ONE_SPHERE,
        cpp: "a miss returns no t at all",
        edits: &["no t at all→-1"],
        why: "The point at t = -1 lies behind the ray, and only the caller's t > 0 hides it.",
        alter: |p| p.kept = |roots| roots.or(Some([-1.0; 2])),
        ..SLIP
    },
    Slip {
        chapters: ONE_SPHERE,
        cpp: "the line goes both ways: what lies behind is the caller's business",
        edits: &["→only t > 0 is returned"],
        why: "From inside a sphere the nearer root lies behind, and a later chapter asks for it.",
        alter: |p| p.kept = |roots| roots.filter(|[near, _]| *near > 0.0),
        ..SLIP
    },
    Slip {
        chapters: ONE_SPHERE,
        cpp: "the nearer root, wherever it is: the choice comes with t_min, in chapter 5",
        edits: &["→the farther root is returned where the nearer one is behind"],
        why: "From inside, the sphere's other side is drawn, which chapters 3 and 4 leave out.",
        alter: |p| {
            p.numerators = |first, sqrtd, _| [first - sqrtd, first + sqrtd];
            p.kept = |roots| roots.map(|[near, far]| [if near > 0.0 { near } else { far }; 2]);
        },
        ..SLIP
    },
    Slip {
        chapters: ROOTS,
        cpp: "a product, rounded, and then a sum",
        edits: &["→a fused mul_add"],
        why: "The book rounds twice, and pictures are compared to the bit.",
        alter: |p| p.at = |_, ray, t| ray.direction.mul_add(Vec3::splat(t), ray.origin),
        ..SLIP
    },
];
