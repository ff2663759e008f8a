//! Mistakes in a function of one's own that have no name: only laws look for them, since
//! a picture of these chapters hides them, or nobody has drawn one yet.

use common::rtweekend::*;

use super::chapters::{ONE_SPHERE, ROOTS, SPHERES};
use crate::slip::{Slip, Words, unnamed};

pub(super) const SLIPS: &[Slip] = &[
    unnamed(SPHERES)
        .says(Words {
            wrong: "oc = center",
            right: "oc = center - r.origin()",
            why: "The eye of the book is at the origin, where nothing shows it.",
        })
        .alters(|p| p.oc = |center, _| center),
    unnamed(SPHERES)
        .says(Words {
            wrong: "oc = center + r.origin()",
            right: "oc = center - r.origin()",
            why: "The eye of the book is at the origin, where nothing shows it.",
        })
        .alters(|p| p.oc = |center, origin| center + origin),
    unnamed(ONE_SPHERE)
        .says(Words {
            wrong: "the discriminant is not tested, and its root is not a number",
            right: "a negative discriminant is a miss",
            why: "A line that misses the sphere has no root.",
        })
        .alters(|p| p.meets = |_| true),
    unnamed(ONE_SPHERE)
        .says(Words {
            wrong: "a miss returns -1",
            right: "a miss returns no t at all",
            why: "The point at t = -1 lies behind the ray, and only the caller's t > 0 hides it.",
        })
        .alters(|p| p.missed = Some(-1.0)),
    unnamed(ONE_SPHERE)
        .says(Words {
            wrong: "only t > 0 is returned",
            right: "the line goes both ways: what lies behind is the caller's business",
            why: "From inside a sphere the nearer root lies behind, and a later chapter asks for it.",
        })
        .alters(|p| p.kept = |[near, far]| (near > 0.0).then_some([near, far])),
    unnamed(ONE_SPHERE)
        .says(Words {
            wrong: "the farther root is returned where the nearer one is behind",
            right: "the nearer root, wherever it is: the choice comes with t_min, in chapter 5",
            why: "From inside, the other side of the sphere is drawn, which chapters 3 and 4 leave out.",
        })
        .alters(|p| {
            p.numerators = |first, sqrtd, _| [first - sqrtd, first + sqrtd];
            p.kept = |[near, far]| Some([if near > 0.0 { near } else { far }; 2]);
        }),
    unnamed(ROOTS)
        .says(Words {
            wrong: "a fused mul_add",
            right: "a product, rounded, and then a sum",
            why: "The book rounds twice, and pictures are compared to the bit.",
        })
        .alters(|p| p.at = |_, ray, t| ray.direction.mul_add(Vec3::splat(t), ray.origin)),
];
