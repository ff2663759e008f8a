//! Slips in the list, and in what only chapter 5 has.

use common::rtweekend::*;

use super::chapters::HITTABLE_LIST;
use crate::program::Program;
use crate::slip::{Place, Slip, Words, slip};
use crate::world::{BALL, Ball, World};

const SEARCH: Place = Place {
    page: "hittable_list#the-nearest-one",
    source: "chapters/5_hittable_list/src/hittable_list.rs",
};
const BOTH_ROOTS: Place = Place {
    page: "hittable_list#a-sphere-from-both-sides",
    source: "chapters/5_hittable_list/src/sphere.rs",
};
const RANGE_OF_A_SPHERE: Place = Place {
    page: "hittable_list#anything-that-a-ray-can-hit",
    source: "chapters/5_hittable_list/src/sphere.rs",
};
const RANGE_OF_THE_EYE: Place = Place {
    page: "hittable_list#anything-that-a-ray-can-hit",
    source: "chapters/5_hittable_list/src/lib.rs",
};
const FACE: Place = Place {
    page: "hittable_list#outward-or-against-the-ray",
    source: "chapters/5_hittable_list/src/hittable.rs",
};
const WORLD: Place = Place {
    page: "hittable_list#the-world",
    source: "chapters/5_hittable_list/src/lib.rs",
};

pub(super) const SLIPS: &[Slip] = &[
    slip("closest-ignored", HITTABLE_LIST, SEARCH)
        .says(Words {
            wrong: "if (object.hit(r, t_min, t_max, rec))",
            right: "if (object.hit(r, t_min, closest_so_far, rec))",
            why: "Each hit replaces the one before, however far it is. The ground, added last, \
                  covers the sphere's lower part.",
        })
        .in_rust(
            HITTABLE_LIST,
            "object.hit(ray, t_min, t_max)",
            "object.hit(ray, t_min, closest_so_far)",
        )
        .reported(&["#671", "#1711"])
        .alters(|p| p.search = last_hit),
    slip("closest-not-updated", HITTABLE_LIST, SEARCH)
        .says(Words {
            wrong: "if (object.hit(…)) rec = temp_rec",
            right: "closest_so_far = temp_rec.t; rec = temp_rec",
            why: "closest_so_far stays where it was, so each hit replaces the one before, \
                  however far it is.",
        })
        .in_rust(
            HITTABLE_LIST,
            "nearest = Some(record)",
            "closest_so_far = record.t; nearest = Some(record)",
        )
        .alters(|p| p.search = last_hit),
    slip("first-hit-wins", HITTABLE_LIST, SEARCH)
        .says(Words {
            wrong: "if (object.hit(…)) return true",
            right: "closest_so_far = rec.t; …",
            why: "The first object that is hit hides nearer ones that follow. The book adds the \
                  near sphere first, so its picture is right.",
        })
        .in_rust(
            HITTABLE_LIST,
            "return Some(record)",
            "closest_so_far = record.t; nearest = Some(record)",
        )
        .alters(|p| p.search = first_hit),
    slip("stops-at-first-miss", HITTABLE_LIST, SEARCH)
        .says(Words {
            wrong: "if (!object.hit(…)) return false",
            right: "an object that is missed is passed over",
            why: "One object that is missed ends the search, so a ray hits only where it meets \
                  all of them.",
        })
        .in_rust(
            HITTABLE_LIST,
            "else { return None",
            "an object that is missed is passed over",
        )
        .in_python(
            "if not object.hit(…): return False",
            "an object that is missed is passed over",
        )
        .alters(|p| p.search = all_or_none),
    slip("farthest-wins", HITTABLE_LIST, SEARCH)
        .says(Words {
            wrong: "if (rec.t > closest_so_far)",
            right: "if (rec.t < closest_so_far)",
            why: "The farthest hit covers all nearer ones.",
        })
        .in_rust(
            HITTABLE_LIST,
            "if record.t > closest_so_far",
            "object.hit(ray, t_min, closest_so_far)",
        )
        .alters(|p| p.search = farthest_hit),
    slip("near-root-only", HITTABLE_LIST, BOTH_ROOTS)
        .says(Words {
            wrong: "root = (h - sqrtd) / a; if (!range.surrounds(root)) return false",
            right: "… root = (h + sqrtd) / a; if (!range.surrounds(root)) return false",
            why: "From inside a sphere the nearer root is behind, and the far one is what the eye \
                  sees.",
        })
        .in_rust(
            HITTABLE_LIST,
            "roots = [(h - sqrtd) / a]",
            "roots = [(h - sqrtd) / a, (h + sqrtd) / a]",
        )
        .alters(|p| p.numerators = |first, sqrtd, _| [first - sqrtd; 2]),
    slip("far-root-not-tested", HITTABLE_LIST, BOTH_ROOTS)
        .says(Words {
            wrong: "if (!range.surrounds(root)) root = (h + sqrtd) / a",
            right: "if (!range.surrounds(root)) { root = (h + sqrtd) / a; if \
                    (!range.surrounds(root)) return false }",
            why: "The second root has to be in the range as well. If it is taken untested, \
                  spheres behind the camera are hit.",
        })
        .in_rust(
            HITTABLE_LIST,
            "t = if t_min < roots[0] && roots[0] < t_max { roots[0] } else { roots[1] }",
            "t = roots.into_iter().find(|&t| t_min < t && t < t_max)?",
        )
        .in_python(
            "if not range.surrounds(root): root = (h + sqrtd) / a",
            "… and again: if not range.surrounds(root): return False",
        )
        .alters(|p| {
            p.choice =
                |program, [near, far], t_min, t_max| match (program.in_range)(t_min, near, t_max) {
                    true => Some(near),
                    false => Some(far),
                }
        }),
    slip("near-root-passed-over", HITTABLE_LIST, BOTH_ROOTS)
        .says(Words {
            wrong: "if (range.surrounds(root)) { root = (h + sqrtd) / a; if \
                    (!range.surrounds(root)) return false }",
            right: "if (!range.surrounds(root)) { root = (h + sqrtd) / a; if \
                    (!range.surrounds(root)) return false }",
            why: "A nearer root that is in the range is passed over, and one that is behind the \
                  camera is taken.",
        })
        .in_rust(
            HITTABLE_LIST,
            "t = if t_min < roots[0] && roots[0] < t_max { Some(roots[1]).filter(|&t| t_min < t && t < t_max)? } else { roots[0] }",
            "t = roots.into_iter().find(|&t| t_min < t && t < t_max)?",
        )
        .alters(|p| {
            p.choice = |program, [near, far], t_min, t_max| {
                let is_in_range = |&t: &f64| (program.in_range)(t_min, t, t_max);
                match is_in_range(&near) {
                    true => Some(far).filter(is_in_range),
                    false => Some(near),
                }
            }
        }),
    slip("range-not-tested", HITTABLE_LIST, RANGE_OF_A_SPHERE)
        .says(Words {
            wrong: "root = (h - sqrtd) / a; rec.t = root",
            right: "if (!ray_t.surrounds(root)) …",
            why: "Hits behind the camera count too, and beat those in front: the sky shows the \
                  ground's back.",
        })
        .in_rust(
            HITTABLE_LIST,
            "t = roots[0]",
            "t = roots.into_iter().find(|&t| t_min < t && t < t_max)?",
        )
        .alters(|p| p.in_range = |_, _, _| true),
    slip("t-max-ignored", HITTABLE_LIST, RANGE_OF_A_SPHERE)
        .says(Words {
            wrong: "t_min < t",
            right: "t_min < t && t < t_max",
            why: "What is farther than the closest so far counts too, so the last hit wins.",
        })
        .in_rust(
            HITTABLE_LIST,
            "|&t| t_min < t)",
            "|&t| t_min < t && t < t_max)",
        )
        .alters(|p| p.in_range = |t_min, t, _| t_min < t),
    slip("range-swapped", HITTABLE_LIST, RANGE_OF_THE_EYE)
        .says(Words {
            wrong: "world.hit(r, interval(infinity, 0), rec)",
            right: "world.hit(r, interval(0, infinity), rec)",
            why: "The range begins at 0 and ends at infinity. Swapped, it holds nothing, and \
                  only the sky is left.",
        })
        .in_rust(
            HITTABLE_LIST,
            "world.hit(ray, f64::INFINITY, 0.0)",
            "world.hit(ray, 0.0, f64::INFINITY)",
        )
        .alters(|p| [p.t_min, p.t_max] = [p.t_max, p.t_min]),
    slip("range-closed", HITTABLE_LIST, RANGE_OF_A_SPHERE)
        .says(Words {
            wrong: "t_min <= t && t <= t_max",
            right: "t_min < t && t < t_max",
            why: "A root exactly at an end of the interval does not count: a ray that leaves a \
                  surface must not hit it at t = 0.",
        })
        .in_rust(
            HITTABLE_LIST,
            "t_min <= t && t <= t_max",
            "t_min < t && t < t_max",
        )
        .alters(|p| p.in_range = |t_min, t, t_max| t_min <= t && t <= t_max)
        .only_by_law(HITTABLE_LIST, "A root at an end of the interval is no hit."),
    slip("range-too-early", HITTABLE_LIST, RANGE_OF_THE_EYE)
        .says(Words {
            wrong: "world.hit(r, interval(0.001, infinity), rec)",
            right: "world.hit(r, interval(0, infinity), rec)",
            why: "A later chapter needs it, where rays start on surfaces. Here they start at the \
                  eye.",
        })
        .in_rust(
            HITTABLE_LIST,
            "world.hit(ray, 0.001, f64::INFINITY)",
            "world.hit(ray, 0.0, f64::INFINITY)",
        )
        .alters(|p| p.t_min = 0.001)
        .equivalent(
            HITTABLE_LIST,
            "No surface of any scene here is so near to the eye that t is 0.001 or \
                 less.",
        ),
    slip("face-normal-missing", HITTABLE_LIST, FACE)
        .says(Words {
            wrong: "rec.normal = outward_normal",
            right: "rec.set_face_normal(r, outward_normal)",
            why: "From inside a sphere the normal has to turn against the ray. The book's camera \
                  is outside of everything.",
        })
        .in_rust(
            HITTABLE_LIST,
            "record.normal = outward_normal",
            "record.set_face_normal(ray, outward_normal)",
        )
        .alters(|p| {
            p.front_face = |_, _, _| false;
            p.face = |_, _, outward| outward;
        }),
    slip("normal-not-turned", HITTABLE_LIST, FACE)
        .says(Words {
            wrong: "normal = outward_normal",
            right: "normal = front_face ? outward_normal : -outward_normal",
            why: "From inside a sphere the normal has to turn against the ray. The book's camera \
                  is outside of everything.",
        })
        .in_rust(
            HITTABLE_LIST,
            "self.normal = outward_normal",
            "if self.front_face { outward_normal } else { -outward_normal }",
        )
        .in_python(
            "normal = outward_normal",
            "normal = outward_normal if front_face else -outward_normal",
        )
        .alters(|p| p.face = |_, _, outward| outward),
    slip("normal-not-set", HITTABLE_LIST, FACE)
        .says(Words {
            wrong: "neither rec.normal nor rec.set_face_normal(…)",
            right: "rec.set_face_normal(r, outward_normal)",
            why: "The normal stays (0, 0, 0), which is drawn as gray.",
        })
        .in_rust(
            HITTABLE_LIST,
            "record.normal = Vec3::ZERO",
            "record.set_face_normal(ray, outward_normal)",
        )
        .alters(|p| {
            p.front_face = |_, _, _| false;
            p.face = |_, _, _| Vec3::ZERO;
        }),
    slip("faces-swapped", HITTABLE_LIST, FACE)
        .says(Words {
            wrong: "normal = front_face ? -outward_normal : outward_normal",
            right: "normal = front_face ? outward_normal : -outward_normal",
            why: "Every normal points along the ray, into what it belongs to.",
        })
        .in_rust(
            HITTABLE_LIST,
            "if self.front_face { -outward_normal } else { outward_normal }",
            "if self.front_face { outward_normal } else { -outward_normal }",
        )
        .in_python(
            "normal = -outward_normal if front_face else outward_normal",
            "normal = outward_normal if front_face else -outward_normal",
        )
        .reported(&["#720", "#1729"])
        .alters(|p| {
            p.face = |program, direction, outward| {
                if (program.front_face)(program, direction, outward) {
                    -outward
                } else {
                    outward
                }
            }
        }),
    slip("ground-too-high", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "sphere((0, -100, -1), 100)",
            right: "sphere((0, -100.5, -1), 100)",
            why: "The small sphere must stand on the ground, its lowest point at -0.5. Here it is \
                  half sunk.",
        })
        .in_rust(
            HITTABLE_LIST,
            "Sphere::new(Point3::new(0.0, -100.0, -1.0), 100.0)",
            "Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)",
        )
        .alters(|p| p.world = World::of(&[BALL, Ball::new(0.0, -100.0, -1.0, 100.0)])),
    slip("ground-too-large", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "sphere((0, -100.5, -1), 100.5)",
            right: "sphere((0, -100.5, -1), 100)",
            why: "The ground reaches up to 0, so the small sphere is half sunk.",
        })
        .in_rust(
            HITTABLE_LIST,
            "Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.5)",
            "Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)",
        )
        .alters(|p| p.world = World::of(&[BALL, Ball::new(0.0, -100.5, -1.0, 100.5)])),
    slip("ground-numbers-swapped", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "sphere((0, -100, -1), 100.5)",
            right: "sphere((0, -100.5, -1), 100)",
            why: "The ground reaches up to 0.5, above the eye: it is seen from inside.",
        })
        .in_rust(
            HITTABLE_LIST,
            "Sphere::new(Point3::new(0.0, -100.0, -1.0), 100.5)",
            "Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)",
        )
        .alters(|p| p.world = World::of(&[BALL, Ball::new(0.0, -100.0, -1.0, 100.5)])),
    slip("ground-ten-times-as-large", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "sphere((0, -100.5, -1), 1000)",
            right: "sphere((0, -100.5, -1), 100)",
            why: "The ground reaches up to 899.5 and holds the whole scene: it is seen from \
                  inside.",
        })
        .in_rust(
            HITTABLE_LIST,
            "Sphere::new(Point3::new(0.0, -100.5, -1.0), 1000.0)",
            "Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)",
        )
        .alters(|p| p.world = World::of(&[BALL, Ball::new(0.0, -100.5, -1.0, 1000.0)])),
    slip("ground-above", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "sphere((0, 100.5, -1), 100)",
            right: "sphere((0, -100.5, -1), 100)",
            why: "y points up, so the ground's center is far below. Without the minus it hangs in \
                  the sky.",
        })
        .in_rust(
            HITTABLE_LIST,
            "Sphere::new(Point3::new(0.0, 100.5, -1.0), 100.0)",
            "Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)",
        )
        .alters(|p| p.world = World::of(&[BALL, Ball::new(0.0, 100.5, -1.0, 100.0)])),
    slip("ceiling-added", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "… and world.add(sphere((0, 100.5, -1), 100))",
            right: "world.add(sphere((0, 0, -1), 0.5)) and world.add(sphere((0, -100.5, -1), 100))",
            why: "A third sphere, as large as the ground, hangs above the scene and hides most of \
                  the sky.",
        })
        .in_rust(
            HITTABLE_LIST,
            "world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)); \
             world.add(Sphere::new(Point3::new(0.0, 100.5, -1.0), 100.0))",
            "world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0))",
        )
        .alters(|p| {
            p.world = World::of(&[
                BALL,
                Ball::new(0.0, -100.5, -1.0, 100.0),
                Ball::new(0.0, 100.5, -1.0, 100.0),
            ]);
        }),
    slip("ground-below-the-eye", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "sphere((0, -100.5, 0), 100)",
            right: "sphere((0, -100.5, -1), 100)",
            why: "The ground's center lies below the sphere. A unit nearer, its colors shift a \
                  little.",
        })
        .in_rust(
            HITTABLE_LIST,
            "Sphere::new(Point3::new(0.0, -100.5, 0.0), 100.0)",
            "Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)",
        )
        .alters(|p| p.world = World::of(&[BALL, Ball::new(0.0, -100.5, 0.0, 100.0)])),
    slip("ground-not-added", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "world.add(sphere((0, 0, -1), 0.5))",
            right: "… and world.add(sphere((0, -100.5, -1), 100))",
            why: "Without the ground the picture is that of the chapter before.",
        })
        .in_rust(
            HITTABLE_LIST,
            "world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5)); world }",
            "world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5)); \
             world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0)); world }",
        )
        .alters(|p| p.world = World::of(&[BALL])),
    slip("ball-not-added", HITTABLE_LIST, WORLD)
        .says(Words {
            wrong: "world.add(sphere((0, -100.5, -1), 100))",
            right: "world.add(sphere((0, 0, -1), 0.5)) and world.add(sphere((0, -100.5, -1), \
                    100))",
            why: "The small sphere is missing: there is only the ground.",
        })
        .in_rust(
            HITTABLE_LIST,
            "HittableList::default(); world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), \
             100.0))",
            "HittableList::default(); world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5)); \
             world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0))",
        )
        .alters(|p| p.world = World::of(&[Ball::new(0.0, -100.5, -1.0, 100.0)])),
];

/// All hits in the order of the list, each looked for in the whole interval.
fn hits<'a>(
    program: &'a Program,
    balls: &'a [Ball],
    ray: &'a Ray,
) -> impl DoubleEndedIterator<Item = (f64, Ball)> {
    balls.iter().filter_map(|&ball| {
        let t = program.hit(ball, ray, program.t_min, program.t_max)?;
        Some((t, ball))
    })
}

fn first_hit(program: &Program, balls: &[Ball], ray: &Ray) -> Option<(f64, Ball)> {
    hits(program, balls, ray).next()
}

fn last_hit(program: &Program, balls: &[Ball], ray: &Ray) -> Option<(f64, Ball)> {
    hits(program, balls, ray).next_back()
}

fn farthest_hit(program: &Program, balls: &[Ball], ray: &Ray) -> Option<(f64, Ball)> {
    hits(program, balls, ray).max_by(|(t, _), (other, _)| t.total_cmp(other))
}

fn all_or_none(program: &Program, balls: &[Ball], ray: &Ray) -> Option<(f64, Ball)> {
    let mut found = None;
    let mut closest_so_far = program.t_max;
    for &ball in balls {
        let t = program.hit(ball, ray, program.t_min, closest_so_far)?;
        closest_so_far = t;
        found = Some((t, ball));
    }
    found
}
