//! Mistakes in a function of one's own that have no name: only laws look for them, since
//! a picture of these chapters hides them, or nobody has drawn one yet.

use crate::slip::{SLIP, Slip};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        rust: "oc = center - ray.origin",
        edits: &[" - ray.origin→"],
        why: "The eye of the book is at the origin, where nothing shows it.",
        ..SLIP
    },
    Slip {
        cpp: "a negative discriminant is a miss",
        edits: &["→the discriminant is not tested, and its root is not a number"],
        more: &["if discriminant < 0.0 { return None; } Some(→Some("],
        why: "A line that misses the sphere has no root.",
        ..SLIP
    },
    Slip {
        cpp: "a miss returns no t at all",
        edits: &["no t at all→-1"],
        more: &["return None; } Some((→return Some(-1.0); } Some(("],
        why: "The point at t = -1 lies behind the ray, and only the caller's t > 0 hides it.",
        ..SLIP
    },
    Slip {
        cpp: "the line goes both ways: what lies behind is the caller's business",
        edits: &["→only t > 0 is returned"],
        more: &[
            "Some((-b - discriminant.sqrt()) / (2.0 * a))→Some((-b - discriminant.sqrt()) / (2.0 * a)).filter(|t| *t > 0.0)",
            "Some((h - discriminant.sqrt()) / a)→Some((h - discriminant.sqrt()) / a).filter(|t| *t > 0.0)",
        ],
        why: "From inside a sphere the nearer root lies behind, and a later chapter asks for it.",
        ..SLIP
    },
];
