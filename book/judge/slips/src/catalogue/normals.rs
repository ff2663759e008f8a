//! Slips in which hits count, and in the color of a hit.

use super::chapters::{HITTABLE_LIST, RED_SPHERE};
use super::sphere::SIGN_OF_B;
use crate::chapter::Chapter::HittableList;
use crate::slip::{SLIP, Slip};

const CHAPTER: Slip = Slip {
    page: "normals#which-way-the-normal",
    ..SLIP
};
const RANGE: Slip = Slip {
    page: "normals#where-the-nearer-root",
    ..CHAPTER
};
const NORMAL: Slip = Slip {
    rust: "normal = (ray.at(t) - center).normalize()",
    later: Some((
        HittableList,
        "outward_normal = (point - center) * (1.0 / radius)",
    )),
    ..CHAPTER
};
const SHADE: Slip = Slip {
    page: "normals#a-color-for-each-direction",
    rust: "return 0.5 * (normal + Vec3::ONE)",
    later: Some((HittableList, "return 0.5 * (normal + Vec3::ONE)")),
    cpp: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
    ..CHAPTER
};
pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "behind-drawn",
        more: &["&& t > 0.0→"],
        rust: "if let Some(t) = hit_sphere(center, 0.5, ray) && t > 0.0 {",
        cpp: "if (t > 0)",
        python: "if t > 0:",
        edits: &[
            " && t > 0.0→",
            "if (t > 0)→if (hit_sphere(…)) without t > 0",
            "→the normal is colored without t > 0",
        ],
        why: "A negative t is a point behind the camera, where the book has no sphere to show it.",
        reported: &["#1570"],
        ..RANGE
    },
    Slip {
        name: "range-loosened",
        page: "half_b_sphere#the-sign-that-got-lost",
        rust: "t > 0.0",
        cpp: "if (t > 0)",
        edits: &["> 0→> -1"],
        why: "Readers try this to bring back a sphere that a wrong sign has lost.",
        reported: &["#1643", "#1558"],
        ..RANGE
    },
    Slip {
        name: "sphere-at-plus-one",
        rust: "Point3::new(0.0, 0.0, -1.0)",
        cpp: "center = (0, 0, -1)",
        edits: &["-1→1"],
        why: "The sphere is behind the camera. Only chapter 2 draws it all the same.",
        reported: &["#1570"],
        unseen_in: RED_SPHERE,
        equivalent: SIGN_OF_B,
        ..RANGE
    },
    Slip {
        name: "normal-from-point",
        edits: &[
            "(ray.at(t) - center)→ray.at(t)",
            "(point - center) * (1.0 / radius)→point.normalize()",
        ],
        why: "A normal points away from the center of the sphere, not from the eye.",
        ..NORMAL
    },
    Slip {
        name: "normal-from-first-center",
        edits: &[
            "(point - center) * (1.0 / radius)→(point - Point3::new(0.0, 0.0, -1.0)).normalize()",
        ],
        why: "With one sphere that was right. Any other has its normals from its own center.",
        ..NORMAL
    },
    Slip {
        name: "center-added",
        edits: &["- center→+ center"],
        why: "A normal is the way from the center to the point, a difference.",
        ..NORMAL
    },
    Slip {
        name: "normal-inward",
        edits: &[
            "ray.at(t) - center→center - ray.at(t)",
            "point - center→center - point",
        ],
        why: "The way from the point to the center points in.",
        unseen_in: HITTABLE_LIST,
        law: "The front face is hit exactly when the ray comes from outside.",
        ..NORMAL
    },
    Slip {
        name: "normal-not-unit",
        edits: &[
            "(ray.at(t) - center).normalize()→ray.at(t) - center",
            "(point - center) * (1.0 / radius)→point - center",
        ],
        why: "Its length is the radius, not 1: a small sphere fades to gray, a large one glares.",
        reported: &["#1062", "#525"],
        ..NORMAL
    },
    Slip {
        name: "normal-not-mapped",
        edits: &[
            "0.5 * (normal + Vec3::ONE)→normal",
            "→color(N.x(), N.y(), N.z())",
        ],
        why: "A normal's components run from -1 to 1, a color's from 0 to 1.",
        ..SHADE
    },
    Slip {
        name: "normal-only-halved",
        edits: &[
            "(normal + Vec3::ONE)→normal",
            "→0.5 * color(N.x(), N.y(), N.z())",
        ],
        why: "Without the 1 half of the components stay negative.",
        ..SHADE
    },
    Slip {
        name: "normal-only-shifted",
        edits: &[
            "0.5 * (normal + Vec3::ONE)→normal + Vec3::ONE",
            "0.5 * color→color",
        ],
        why: "Without the half components run from 0 to 2, and half of them are too bright.",
        ..SHADE
    },
    Slip {
        name: "normal-without-brackets",
        cpp: "",
        edits: &["(normal + Vec3::ONE)→normal + Vec3::ONE"],
        why: "The half takes the normal alone, so components run from 0.5 to 1.5: too bright.",
        ..SHADE
    },
    Slip {
        name: "normal-channels-reversed",
        later: None,
        edits: &[
            "normal→Vec3::new(normal.z, normal.y, normal.x)",
            "→0.5 * color(N.z() + 1, N.y() + 1, N.x() + 1)",
        ],
        why: "x is red and z is blue. Here the sphere's red and blue have changed places.",
        ..SHADE
    },
    Slip {
        name: "z-forward",
        more: &[
            "0.5 * (normal + Vec3::ONE)→0.5 * (Vec3::new(normal.x, normal.y, -normal.z) + Vec3::ONE)",
            "0.5 * (record.normal + Vec3::ONE)→0.5 * (Vec3::new(record.normal.x, record.normal.y, -record.normal.z) + Vec3::ONE)",
        ],
        page: "gradient#the-camera",
        rust: "center - Vec3::new(0.0, 0.0, focal_length), and the spheres at z = -1.0",
        edits: &["→center + Vec3::new(0.0, 0.0, focal_length), and the spheres at z = 1.0"],
        why: "z points away from the eye then, and the normals' blue too. All else is the same.",
        ..CHAPTER
    },
];
