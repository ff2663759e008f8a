//! Mistakes in a function of one's own that have no name: only laws look for them, since
//! a picture of these chapters hides them, or nobody has drawn one yet.

use common::rtweekend::*;

use super::chapters::{HITTABLE_LIST, ONE_SPHERE, ROOTS, SPHERES};
use crate::chapter::Chapter;
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
    unnamed(SPHERES)
        .says(Words {
            wrong: "a = r.direction().length()",
            right: "a = dot(r.direction(), r.direction())",
            why: "The equation has the square of the length.",
        })
        .alters(|p| p.a = |program, direction| (program.squared)(program, direction).sqrt()),
    unnamed(SPHERES)
        .says(Words {
            wrong: "c = dot(oc, oc)",
            right: "c = dot(oc, oc) - radius*radius",
            why: "A sphere of radius 0 is a point.",
        })
        .alters(|p| p.constant = |oc_squared, _| oc_squared),
    unnamed(SPHERES)
        .says(Words {
            wrong: "a positive discriminant is a miss",
            right: "a negative discriminant is a miss",
            why: "Lines that pass through the sphere have two roots, and a positive discriminant.",
        })
        .alters(|p| p.meets = |discriminant| discriminant <= 0.0),
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
            wrong: "t is a distance: the direction was made a unit vector",
            right: "t counts lengths of the direction",
            why: "The caller looks for the point at t with the direction as it is.",
        })
        .alters(|p| {
            p.divide = match p.chapter {
                Chapter::Normals => |numerator, a| numerator / (2.0 * a.sqrt()),
                _ => |numerator, a| numerator / a.sqrt(),
            }
        }),
    unnamed(HITTABLE_LIST)
        .says(Words {
            wrong: "only t_min is tested",
            right: "t_min < t && t < t_max",
            why: "What is farther than the closest so far counts too.",
        })
        .alters(|p| p.in_range = |t_min, t, _| t_min < t),
    unnamed(HITTABLE_LIST)
        .says(Words {
            wrong: "only t_max is tested",
            right: "t_min < t && t < t_max",
            why: "What lies behind the ray counts too.",
        })
        .alters(|p| p.in_range = |_, t, t_max| t < t_max),
    unnamed(HITTABLE_LIST)
        .says(Words {
            wrong: "the farther root is tried first",
            right: "both roots are tried, the nearer one first",
            why: "The far side of a sphere covers the near one.",
        })
        .alters(|p| p.numerators = |first, sqrtd, _| [first + sqrtd, first - sqrtd]),
    unnamed(ROOTS)
        .says(Words {
            wrong: "a fused mul_add",
            right: "a product, rounded, and then a sum",
            why: "The book rounds twice, and pictures are compared to the bit.",
        })
        .alters(|p| p.at = |_, ray, t| ray.direction.mul_add(Vec3::splat(t), ray.origin)),
];
