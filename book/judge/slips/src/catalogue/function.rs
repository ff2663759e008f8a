//! Mistakes in a function of one's own that have no name: only laws look for them, since
//! a picture of these chapters hides them, or nobody has drawn one yet.

use super::chapters::{ONE_SPHERE, SPHERES};
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
];
