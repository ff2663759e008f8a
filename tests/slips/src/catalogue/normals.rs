//! Slips in which hits count, and in the color of a hit.

use common::rtweekend::*;

use super::chapters::{HITTABLE_LIST, LONE_SPHERE, ONE_SPHERE, RED_SPHERE, ROOTS};
use super::sphere::SIGN_OF_B;
use crate::chapter::Chapter;
use crate::letters::Letters;
use crate::program::{Program, coefficients};
use crate::slip::{Place, Slip, Words, slip};
use crate::world::{BALL, Ball, World};

const ROOT: Place = Place {
    page: "normals#where-the-nearer-root",
    source: "chapters/3_normals/src/lib.rs",
};
const RANGE: Place = Place {
    page: "half_b_sphere#the-sign-that-got-lost",
    source: "chapters/3_normals/src/lib.rs",
};
const NORMAL: Place = Place {
    page: "normals#which-way-the-normal",
    source: "chapters/3_normals/src/lib.rs",
};
const NORMAL_BY_RADIUS: Place = Place {
    page: "normals#which-way-the-normal",
    source: "chapters/5_hittable_list/src/sphere.rs",
};
const POINT: Place = Place {
    page: "gradient#a-ray-is-a-function",
    source: "common/src/ray.rs",
};
const POINT_OF_HIT: Place = Place {
    page: NORMAL.page,
    source: "chapters/3_normals/src/lib.rs",
};
const Z: Place = Place {
    page: "gradient#the-camera",
    source: "common/src/camera.rs",
};
const SHADE: Place = Place {
    page: "normals#a-color-for-each-direction",
    source: "chapters/3_normals/src/lib.rs",
};

pub(super) const SLIPS: &[Slip] = &[
    slip("behind-drawn", ONE_SPHERE, ROOT)
        .says(Words {
            wrong: "if (hit_sphere(…)) without t > 0",
            right: "if (t > 0)",
            why: "A negative t is a point behind the camera. The book's sphere is in front, so \
                  nothing shows it.",
        })
        .in_rust(
            ONE_SPHERE,
            "if let Some(t) = hit_sphere(center, 0.5, ray) {",
            "if let Some(t) = hit_sphere(center, 0.5, ray) && t > 0.0 {",
        )
        .in_python("the normal is colored without t > 0", "if t > 0:")
        .reported(&["#1570"])
        .alters(|p| p.t_min = f64::NEG_INFINITY),
    slip("range-loosened", ONE_SPHERE, RANGE)
        .says(Words {
            wrong: "if (t > -1)",
            right: "if (t > 0)",
            why: "Readers try this to bring back a sphere that a wrong sign has lost. It counts \
                  points just behind the camera too.",
        })
        .in_rust(ONE_SPHERE, "t > -1.0", "t > 0.0")
        .reported(&["#1643", "#1558"])
        .alters(|p| p.t_min = -1.0),
    slip("only-behind-drawn", ONE_SPHERE, ROOT)
        .says(Words {
            wrong: "if (t < 0)",
            right: "if (t > 0)",
            why: "What is in front of the camera is left out, and a miss is drawn: its -1.0 is a t \
                  like any other.",
        })
        .made_in(|letters| letters != Letters::Rust)
        .alters(|p| p.search = only_behind),
    slip("sphere-at-plus-one", LONE_SPHERE, ROOT)
        .says(Words {
            wrong: "center = (0, 0, 1)",
            right: "center = (0, 0, -1)",
            why: "The sphere is behind the camera. Chapter 2 draws it all the same, the later ones \
                  must not.",
        })
        .in_rust(
            LONE_SPHERE,
            "Point3::new(0.0, 0.0, 1.0)",
            "Point3::new(0.0, 0.0, -1.0)",
        )
        .reported(&["#1570"])
        .alters(|p| p.world = World::of(&[Ball::new(0.0, 0.0, 1.0, 0.5)]))
        .equivalent(RED_SPHERE, SIGN_OF_B),
    slip("normal-from-point", ROOTS, NORMAL)
        .says(Words {
            wrong: "N = unit_vector(r.at(t))",
            right: "N = unit_vector(r.at(t) - center)",
            why: "A normal points away from the center of the sphere, not from the eye.",
        })
        .in_rust(
            ONE_SPHERE,
            "normal = ray.at(t).normalize()",
            "normal = (ray.at(t) - center).normalize()",
        )
        .in_rust(
            HITTABLE_LIST,
            "outward_normal = record.point.normalize()",
            "outward_normal = (record.point - self.center) * (1.0 / self.radius)",
        )
        .in_book(
            HITTABLE_LIST,
            "outward_normal = unit_vector(p)",
            "outward_normal = (p - center) / radius",
        )
        .alters(|p| p.outward = |program, point, _| (program.unit)(point)),
    slip("normal-from-first-center", HITTABLE_LIST, NORMAL_BY_RADIUS)
        .says(Words {
            wrong: "outward_normal = unit_vector(p - vec3(0, 0, -1))",
            right: "outward_normal = (p - center) / radius",
            why: "With one sphere that was right. Any other has its normals from its own center.",
        })
        .in_rust(
            HITTABLE_LIST,
            "outward_normal = (record.point - Point3::new(0.0, 0.0, -1.0)).normalize()",
            "outward_normal = (record.point - self.center) * (1.0 / self.radius)",
        )
        .alters(|p| p.outward = |program, point, _| (program.unit)(point - BALL.center)),
    slip("center-added", ROOTS, NORMAL)
        .says(Words {
            wrong: "N = unit_vector(r.at(t) + center)",
            right: "N = unit_vector(r.at(t) - center)",
            why: "A normal is the way from the center to the point, a difference.",
        })
        .in_rust(
            ONE_SPHERE,
            "normal = (ray.at(t) + center).normalize()",
            "normal = (ray.at(t) - center).normalize()",
        )
        .in_rust(
            HITTABLE_LIST,
            "outward_normal = (record.point + self.center) * (1.0 / self.radius)",
            "outward_normal = (record.point - self.center) * (1.0 / self.radius)",
        )
        .in_book(
            HITTABLE_LIST,
            "outward_normal = (p + center) / radius",
            "outward_normal = (p - center) / radius",
        )
        .alters(|p| {
            p.outward = |program, point, ball| rescaled(program, point + ball.center, ball);
        }),
    slip("center-after-unit", ROOTS, NORMAL)
        .says(Words {
            wrong: "N = unit_vector(r.at(t)) - center",
            right: "N = unit_vector(r.at(t) - center)",
            why: "The bracket closes too early: the center is taken from a vector that is 1 long \
                  already, and the difference is not.",
        })
        .in_rust(
            ONE_SPHERE,
            "normal = ray.at(t).normalize() - center",
            "normal = (ray.at(t) - center).normalize()",
        )
        .in_rust(
            HITTABLE_LIST,
            "outward_normal = record.point.normalize() - self.center",
            "outward_normal = (record.point - self.center) * (1.0 / self.radius)",
        )
        .in_book(
            HITTABLE_LIST,
            "outward_normal = unit_vector(p) - center",
            "outward_normal = (p - center) / radius",
        )
        .alters(|p| p.outward = |program, point, ball| (program.unit)(point) - ball.center),
    slip("normal-inward", ROOTS, NORMAL)
        .says(Words {
            wrong: "N = unit_vector(center - r.at(t))",
            right: "N = unit_vector(r.at(t) - center)",
            why: "The way from the point to the center points in.",
        })
        .in_rust(
            ONE_SPHERE,
            "normal = (center - ray.at(t)).normalize()",
            "normal = (ray.at(t) - center).normalize()",
        )
        .in_rust(
            HITTABLE_LIST,
            "outward_normal = (self.center - record.point) * (1.0 / self.radius)",
            "outward_normal = (record.point - self.center) * (1.0 / self.radius)",
        )
        .in_book(
            HITTABLE_LIST,
            "outward_normal = (center - p) / radius",
            "outward_normal = (p - center) / radius",
        )
        .alters(|p| p.outward = |program, point, ball| rescaled(program, ball.center - point, ball))
        .only_by_law(
            HITTABLE_LIST,
            "The front face is hit exactly when the ray comes from outside.",
        ),
    slip("normal-not-unit", ROOTS, NORMAL)
        .says(Words {
            wrong: "N = r.at(t) - center",
            right: "N = unit_vector(r.at(t) - center)",
            why: "Its length is the radius, and colors are made for length 1: a small sphere fades \
                  to gray, the ground leaves the range.",
        })
        .in_rust(
            ONE_SPHERE,
            "normal = ray.at(t) - center;",
            "normal = (ray.at(t) - center).normalize();",
        )
        .in_rust(
            HITTABLE_LIST,
            "outward_normal = record.point - self.center;",
            "outward_normal = (record.point - self.center) * (1.0 / self.radius);",
        )
        .in_book(
            HITTABLE_LIST,
            "outward_normal = p - center",
            "outward_normal = (p - center) / radius",
        )
        .reported(&["#1062", "#525"])
        .alters(|p| p.outward = |_, point, ball| point - ball.center),
    slip("normal-times-radius", HITTABLE_LIST, NORMAL_BY_RADIUS)
        .says(Words {
            wrong: "outward_normal = (p - center) * radius",
            right: "outward_normal = (p - center) / radius",
            why: "The way from the center to the point is as long as the radius: dividing makes it \
                  a unit vector.",
        })
        .in_rust(
            HITTABLE_LIST,
            "outward_normal = (record.point - self.center) * self.radius",
            "outward_normal = (record.point - self.center) * (1.0 / self.radius)",
        )
        .alters(|p| p.outward = |_, point, ball| (point - ball.center) * ball.radius),
    slip("unit-vector-for-radius", HITTABLE_LIST, NORMAL_BY_RADIUS)
        .says(Words {
            wrong: "outward_normal = unit_vector(p - center)",
            right: "outward_normal = (p - center) / radius",
            why: "Only slower, since p is on the sphere. It matters for a negative radius, which \
                  turns the normal here and was a trick of older editions.",
        })
        .in_rust(
            HITTABLE_LIST,
            "outward_normal = (record.point - self.center).normalize()",
            "outward_normal = (record.point - self.center) * (1.0 / self.radius)",
        )
        .reported(&["#977"])
        .alters(|p| p.outward = |program, point, ball| (program.unit)(point - ball.center))
        .equivalent(
            HITTABLE_LIST,
            "The point is on the sphere, so its distance from the center is the radius, \
                 but for a few roundings.",
        ),
    slip("point-along-unit-direction", ROOTS, POINT)
        .says(Words {
            wrong: "r.at(t) = origin + t * unit_vector(direction)",
            right: "r.at(t) = origin + t * direction",
            why: "t counts lengths of the direction, whatever that length is.",
        })
        .in_rust(
            ROOTS,
            "self.origin + t * self.direction.normalize()",
            "self.origin + t * self.direction",
        )
        .alters(|p| p.at = |program, ray, t| ray.origin + t * (program.unit)(ray.direction)),
    slip("t-along-unit-direction", ONE_SPHERE, POINT_OF_HIT)
        .says(Words {
            wrong: "hit_sphere(center, radius, ray(r.origin(), unit_vector(r.direction())))",
            right: "hit_sphere(center, radius, r)",
            why: "t counts lengths of the direction by which it was found, and r.at(t) goes along \
                  another one.",
        })
        .in_rust(
            ONE_SPHERE,
            "hit_sphere(center, 0.5, &Ray::new(ray.origin, ray.direction.normalize()))",
            "hit_sphere(center, 0.5, ray)",
        )
        .alters(|p| {
            p.coefficients = |program, ball, ray| {
                let direction = (program.unit)(ray.direction);
                coefficients(program, ball, &Ray::new(ray.origin, direction))
            }
        }),
    slip("point-without-origin", ROOTS, POINT)
        .says(Words {
            wrong: "r.at(t) = t * direction",
            right: "r.at(t) = origin + t * direction",
            why: "It shows as soon as a ray starts anywhere but at the origin.",
        })
        .in_rust(
            ROOTS,
            "t * self.direction",
            "self.origin + t * self.direction",
        )
        .alters(|p| p.at = |_, ray, t| t * ray.direction)
        .only_by_law(ROOTS, "A ray is at its origin at t = 0."),
    slip("point-at-one", ROOTS, POINT_OF_HIT)
        .says(Words {
            wrong: "r.at(1)",
            right: "r.at(t)",
            why: "The point at t = 1 is on the viewport, whatever is hit: the disc is right, its \
                  colors are those of another surface.",
        })
        .in_rust(
            ONE_SPHERE,
            "normal = (ray.at(1.0) - center).normalize()",
            "normal = (ray.at(t) - center).normalize()",
        )
        .in_rust(HITTABLE_LIST, "point: ray.at(1.0)", "point: ray.at(t)")
        .in_book(HITTABLE_LIST, "rec.p = r.at(1)", "rec.p = r.at(rec.t)")
        .alters(|p| p.hit_point = |program, ray, _| (program.at)(program, ray, 1.0)),
    slip("normal-not-mapped", ROOTS, SHADE)
        .says(Words {
            wrong: "color(N.x(), N.y(), N.z())",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "A normal's components run from -1 to 1, a color's from 0 to 1. Negative ones are \
                  printed or cut off.",
        })
        .in_rust(
            ONE_SPHERE,
            "return normal;",
            "return 0.5 * (normal + Vec3::ONE)",
        )
        .in_rust(
            HITTABLE_LIST,
            "return record.normal;",
            "return 0.5 * (record.normal + Vec3::ONE)",
        )
        .in_book(
            HITTABLE_LIST,
            "rec.normal",
            "0.5 * (rec.normal + color(1, 1, 1))",
        )
        .alters(|p| p.shade = |_, normal| normal),
    slip("normal-only-halved", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(N.x(), N.y(), N.z())",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "Without the 1 half of the components stay negative.",
        })
        .in_rust(
            ONE_SPHERE,
            "return 0.5 * normal;",
            "return 0.5 * (normal + Vec3::ONE)",
        )
        .in_rust(
            HITTABLE_LIST,
            "return 0.5 * record.normal;",
            "return 0.5 * (record.normal + Vec3::ONE)",
        )
        .in_book(
            HITTABLE_LIST,
            "0.5 * rec.normal",
            "0.5 * (rec.normal + color(1, 1, 1))",
        )
        .alters(|p| p.shade = |_, normal| 0.5 * normal),
    slip("normal-only-shifted", ROOTS, SHADE)
        .says(Words {
            wrong: "color(N.x() + 1, N.y() + 1, N.z() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "Without the half components run from 0 to 2, and half of them are too bright for \
                  a picture.",
        })
        .in_rust(
            ONE_SPHERE,
            "return normal + Vec3::ONE",
            "return 0.5 * (normal + Vec3::ONE)",
        )
        .in_rust(
            HITTABLE_LIST,
            "return record.normal + Vec3::ONE",
            "return 0.5 * (record.normal + Vec3::ONE)",
        )
        .in_book(
            HITTABLE_LIST,
            "rec.normal + color(1, 1, 1)",
            "0.5 * (rec.normal + color(1, 1, 1))",
        )
        .alters(|p| p.shade = |_, normal| normal + Vec3::ONE),
    slip("normal-without-brackets", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * N + color(1, 1, 1)",
            right: "0.5 * (N + color(1, 1, 1))",
            why: "The half takes the normal alone, so components run from 0.5 to 1.5, and half of \
                  them are too bright for a picture.",
        })
        .in_rust(
            ONE_SPHERE,
            "return 0.5 * normal + Vec3::ONE",
            "return 0.5 * (normal + Vec3::ONE)",
        )
        .in_rust(
            HITTABLE_LIST,
            "return 0.5 * record.normal + Vec3::ONE",
            "return 0.5 * (record.normal + Vec3::ONE)",
        )
        .in_book(
            HITTABLE_LIST,
            "0.5 * rec.normal + color(1, 1, 1)",
            "0.5 * (rec.normal + color(1, 1, 1))",
        )
        .alters(|p| p.shade = |_, normal| 0.5 * normal + Vec3::ONE),
    slip("normal-plus-half", ROOTS, SHADE)
        .says(Words {
            wrong: "N + color(0.5, 0.5, 0.5)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "The normal has to be halved as well, so components run from -0.5 to 1.5: too \
                  dark below, too bright above.",
        })
        .in_rust(
            ONE_SPHERE,
            "return normal + 0.5 * Vec3::ONE",
            "return 0.5 * (normal + Vec3::ONE)",
        )
        .in_rust(
            HITTABLE_LIST,
            "return record.normal + 0.5 * Vec3::ONE",
            "return 0.5 * (record.normal + Vec3::ONE)",
        )
        .in_book(
            HITTABLE_LIST,
            "rec.normal + color(0.5, 0.5, 0.5)",
            "0.5 * (rec.normal + color(1, 1, 1))",
        )
        .alters(|p| p.shade = |_, normal| normal + 0.5 * Vec3::ONE),
    slip("normal-channels-reversed", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(N.z() + 1, N.y() + 1, N.x() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "x is red and z is blue. The sky is right, the sphere's red and blue have changed \
                  places.",
        })
        .in_rust(
            ONE_SPHERE,
            "return 0.5 * (Vec3::new(normal.z, normal.y, normal.x) + Vec3::ONE)",
            "return 0.5 * (normal + Vec3::ONE)",
        )
        .in_rust(
            HITTABLE_LIST,
            "return 0.5 * (Vec3::new(record.normal.z, record.normal.y, record.normal.x) + \
             Vec3::ONE)",
            "return 0.5 * (record.normal + Vec3::ONE)",
        )
        .alters(|p| {
            p.shade = |_, normal| 0.5 * (Vec3::new(normal.z, normal.y, normal.x) + Vec3::ONE);
        }),
    slip("z-forward", ROOTS, Z)
        .says(Words {
            wrong: "center + (0, 0, focal_length) - …, and the spheres at z = 1",
            right: "center - (0, 0, focal_length) - …, and the spheres at z = -1",
            why: "z points away from the eye then, and so does the normals' blue. All else is the \
                  same.",
        })
        .in_rust(
            ROOTS,
            "center + Vec3::new(0.0, 0.0, focal_length), and the spheres at z = 1.0",
            "center - Vec3::new(0.0, 0.0, focal_length), and the spheres at z = -1.0",
        )
        .alters(|p| {
            p.face = match p.chapter {
                Chapter::HittableList => |program, direction, outward| {
                    let is_front = (program.front_face)(program, direction, outward);
                    mirrored(if is_front { outward } else { -outward })
                },
                _ => |_, _, outward| mirrored(outward),
            }
        }),
    slip("normal-x-twice", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(N.x() + 1, N.x() + 1, N.z() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "Red and green are the same everywhere: green is to show the y of the normal.",
        })
        .alters(|p| {
            p.shade = |_, normal| 0.5 * (Vec3::new(normal.x, normal.x, normal.z) + Vec3::ONE);
        }),
    slip("normal-y-twice", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(N.x() + 1, N.y() + 1, N.y() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "Green and blue are the same everywhere: blue is to show the z of the normal.",
        })
        .alters(|p| {
            p.shade = |_, normal| 0.5 * (Vec3::new(normal.x, normal.y, normal.y) + Vec3::ONE);
        }),
    slip("normal-x-and-y-exchanged", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(N.y() + 1, N.x() + 1, N.z() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "Red is to grow to the right, with x, and green upwards, with y.",
        })
        .alters(|p| {
            p.shade = |_, normal| 0.5 * (Vec3::new(normal.y, normal.x, normal.z) + Vec3::ONE);
        }),
    slip("normal-x-negated", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(-N.x() + 1, N.y() + 1, N.z() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "The sphere has its right side's red at the left.",
        })
        .alters(|p| {
            p.shade = |_, normal| 0.5 * (Vec3::new(-normal.x, normal.y, normal.z) + Vec3::ONE);
        }),
    slip("normal-y-negated", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(N.x() + 1, -N.y() + 1, N.z() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "The sphere has its upper side's green below.",
        })
        .alters(|p| {
            p.shade = |_, normal| 0.5 * (Vec3::new(normal.x, -normal.y, normal.z) + Vec3::ONE);
        }),
    slip("normal-z-negated", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(N.x() + 1, N.y() + 1, -N.z() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "What faces the eye has z near 1, and is to be blue.",
        })
        .alters(|p| {
            p.shade = |_, normal| 0.5 * (Vec3::new(normal.x, normal.y, -normal.z) + Vec3::ONE);
        }),
    slip("normal-in-gray", ROOTS, SHADE)
        .says(Words {
            wrong: "0.5 * color(N.x() + 1, N.x() + 1, N.x() + 1)",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "A copied term keeps its letter: with one component for all three, what is hit is \
                  gray.",
        })
        .in_rust(
            ONE_SPHERE,
            "return 0.5 * (Vec3::new(normal.x, normal.x, normal.x) + Vec3::ONE)",
            "return 0.5 * (normal + Vec3::ONE)",
        )
        .in_rust(
            HITTABLE_LIST,
            "return 0.5 * (Vec3::new(record.normal.x, record.normal.x, record.normal.x) + \
             Vec3::ONE)",
            "return 0.5 * (record.normal + Vec3::ONE)",
        )
        .alters(|p| p.shade = |_, normal| 0.5 * (Vec3::splat(normal.x) + Vec3::ONE)),
    slip("normal-as-absolute", ROOTS, SHADE)
        .says(Words {
            wrong: "color(abs(N.x()), abs(N.y()), abs(N.z()))",
            right: "0.5 * color(N.x() + 1, N.y() + 1, N.z() + 1)",
            why: "Absolute values fit into a color, but left and right, above and below look the \
                  same.",
        })
        .in_rust(
            ONE_SPHERE,
            "return normal.abs()",
            "return 0.5 * (normal + Vec3::ONE)",
        )
        .in_rust(
            HITTABLE_LIST,
            "return record.normal.abs()",
            "return 0.5 * (record.normal + Vec3::ONE)",
        )
        .alters(|p| p.shade = |_, normal| normal.abs()),
];

/// The same as seen with z the other way.
fn mirrored(normal: Vec3) -> Vec3 {
    normal.with_z(-normal.z)
}

/// A vector as long as the sphere's radius made one of length 1, in the way of
/// the chapter: by its own length, or from chapter 5 on by the radius.
fn rescaled(program: &Program, v: Vec3, ball: Ball) -> Vec3 {
    match program.chapter {
        Chapter::HittableList => v * (1.0 / ball.radius),
        _ => (program.unit)(v),
    }
}

/// A miss is the book's -1.0, which is below 0.
fn only_behind(program: &Program, balls: &[Ball], ray: &Ray) -> Option<(f64, Ball)> {
    let &ball = balls.first()?;
    let t = program.hit_sphere(ball.center, ball.radius, ray);
    let t = t.unwrap_or(-1.0);
    (t < 0.0).then_some((t, ball))
}
