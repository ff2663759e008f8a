//! Slips in the list, and in what only chapter 5 has.

use super::chapters::HITTABLE_LIST;
use crate::slip::{SLIP, Slip};

const SEARCH: Slip = Slip {
    page: "hittable_list#the-nearest-one",
    rust: "object.hit(ray, t_min, closest_so_far)",
    ..SLIP
};
const BOTH_ROOTS: Slip = Slip {
    page: "hittable_list#a-sphere-from-both-sides",
    ..SEARCH
};
const RANGE: Slip = Slip {
    page: "hittable_list#anything-that-a-ray-can-hit",
    rust: "t = roots.into_iter().find(|&t| t_min < t && t < t_max)?",
    cpp: "t_min < t && t < t_max",
    ..BOTH_ROOTS
};
const FACE: Slip = Slip {
    page: "hittable_list#outward-or-against-the-ray",
    rust: "record.set_face_normal(ray, outward_normal)",
    ..SEARCH
};
const GROUND: Slip = Slip {
    page: "hittable_list#the-world",
    rust: "Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)",
    ..SEARCH
};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "closest-ignored",
        cpp: "if (object.hit(r, t_min, closest_so_far, rec))",
        edits: &["closest_so_far→t_max"],
        why: "Each hit replaces the one before, however far it is. The ground, added last, \
              covers the sphere's lower part.",
        reported: &["#671", "#1711"],
        ..SEARCH
    },
    Slip {
        name: "closest-not-updated",
        rust: "closest_so_far = record.t; nearest = Some(record)",
        cpp: "closest_so_far = temp_rec.t; rec = temp_rec",
        python: "closest_so_far = rec.t, or closest_so_far = temp_rec.t",
        edits: &[
            "closest_so_far = record.t; →",
            "closest_so_far = rec.t, or closest_so_far = temp_rec.t→if object.hit(…): rec = temp_rec",
            "closest_so_far = temp_rec.t;→if (object.hit(…))",
        ],
        why: "closest_so_far stays, so each hit replaces the one before, however far it is.",
        ..SEARCH
    },
    Slip {
        name: "first-hit-wins",
        rust: "closest_so_far = record.t; nearest = Some(record)",
        cpp: "closest_so_far = rec.t; …",
        edits: &[
            "closest_so_far = rec.t; …→if (object.hit(…)) return true",
            "→return Some(record)",
        ],
        why: "The first object that is hit hides nearer ones, and the book adds the nearest first.",
        ..SEARCH
    },
    Slip {
        name: "farthest-wins",
        more: &[
            "object.hit(ray, t_min, closest_so_far)→object.hit(ray, t_min, t_max)",
            "closest_so_far = t_max→closest_so_far = t_min",
            "closest_so_far = record.t; nearest = Some(record);→if record.t > closest_so_far { closest_so_far = record.t; nearest = Some(record); }",
        ],
        cpp: "if (rec.t < closest_so_far)",
        edits: &["<→>", "→if record.t > closest_so_far"],
        why: "The farthest hit covers all nearer ones.",
        ..SEARCH
    },
    Slip {
        name: "near-root-only",
        rust: "roots = [(h - sqrtd) / a, (h + sqrtd) / a]",
        cpp: "… root = (h + sqrtd) / a; if (!range.surrounds(root)) return false",
        edits: &[
            ", (h + sqrtd) / a→",
            "… root = (h + sqrtd)→root = (h - sqrtd)",
        ],
        why: "From inside a sphere the nearer root is behind, and the eye sees the far one.",
        ..BOTH_ROOTS
    },
    Slip {
        name: "far-root-not-tested",
        page: BOTH_ROOTS.page,
        cpp: "if (!range.surrounds(root)) { root = (h + sqrtd) / a; \
             if (!range.surrounds(root)) return false }",
        python: "… and again: if not range.surrounds(root): return False",
        edits: &[
            "roots.into_iter().find(|&t| t_min < t && t < t_max)?→\
             if t_min < roots[0] && roots[0] < t_max { roots[0] } else { roots[1] }",
            "{ root = (h + sqrtd) / a; if (!range.surrounds(root)) return false }→\
             root = (h + sqrtd) / a",
            "→if not range.surrounds(root): root = (h + sqrtd) / a",
        ],
        why: "The second root has to be in the range too, or spheres behind the camera are hit.",
        ..RANGE
    },
    Slip {
        name: "range-not-tested",
        cpp: "if (!ray_t.surrounds(root)) …",
        edits: &[
            "if (!ray_t.surrounds(root)) …→root = (h - sqrtd) / a; rec.t = root",
            "→t = roots[0]",
        ],
        why: "Hits behind the camera count too, and beat others: the sky shows the ground's back.",
        ..RANGE
    },
    Slip {
        name: "range-closed",
        edits: &["t_min < t && t < t_max→t_min <= t && t <= t_max"],
        why: "A ray that leaves a surface must not hit it at t = 0, the end of the interval.",
        unseen_in: HITTABLE_LIST,
        law: "A root at an end of the interval is no hit.",
        ..RANGE
    },
    Slip {
        name: "face-normal-missing",
        edits: &["set_face_normal(ray, outward_normal)→normal = outward_normal"],
        why: "From inside a sphere, where no camera here is, the normal turns against the ray.",
        ..FACE
    },
    Slip {
        name: "normal-not-set",
        cpp: "rec.set_face_normal(r, outward_normal)",
        edits: &[
            "record.set_face_normal(ray, outward_normal)→record.normal = Vec3::ZERO",
            "→neither rec.normal nor rec.set_face_normal(…)",
        ],
        why: "The normal stays (0, 0, 0), which is drawn as gray.",
        ..FACE
    },
    Slip {
        name: "faces-swapped",
        rust: "if self.front_face { outward_normal } else { -outward_normal }",
        cpp: "normal = front_face ? outward_normal : -outward_normal",
        python: "normal = outward_normal if front_face else -outward_normal",
        edits: &[
            "{ outward_normal } else { -outward_normal }→\
             { -outward_normal } else { outward_normal }",
            "? outward_normal : -outward_normal→? -outward_normal : outward_normal",
            "outward_normal if front_face else -outward_normal→\
             -outward_normal if front_face else outward_normal",
        ],
        why: "Every normal points along the ray, into what it belongs to.",
        reported: &["#720", "#1729"],
        ..FACE
    },
    Slip {
        name: "ground-too-high",
        edits: &["-100.5→-100.0"],
        why: "The sphere must stand on the ground, its lowest point at -0.5. Here it is half sunk.",
        ..GROUND
    },
    Slip {
        name: "ground-not-added",
        rust: "world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5)); \
             world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)); world }",
        cpp: "world.add(sphere((0, 0, -1), 0.5)) and world.add(sphere((0, -100.5, -1), 100))",
        edits: &[
            " world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));→",
            " and world.add(sphere((0, -100.5, -1), 100))→",
        ],
        why: "Without the ground the picture is that of the chapter before.",
        ..GROUND
    },
];
