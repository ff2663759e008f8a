//! Slips in the quadratic.

use super::chapters::{
    FULL_B, HALF_B, HITTABLE_LIST, NORMALS, ONE_SPHERE, RED_SPHERE, ROOTS, SPHERES,
};
use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::letters::Letters;
use crate::program::coefficients;
use crate::slip::{Place, Slip, Words, slip};

/// Why chapter 2 does not show a slip in the sign of b.
pub(super) const SIGN_OF_B: &str =
    "Only the sign of b changes, and the discriminant has its square.";

const SIGN_IN_B: Place = Place {
    page: "editions#every-mixture",
    source: "chapters/2_red_sphere/src/lib.rs",
};
const COEFFICIENTS: Place = Place {
    page: "red_sphere#the-ray-in-the-equation",
    source: "chapters/2_red_sphere/src/lib.rs",
};
const HALF: Place = Place {
    page: "half_b_sphere#two-observations",
    source: "chapters/4_half_b_sphere/src/lib.rs",
};
const DOT: Place = Place {
    page: COEFFICIENTS.page,
    source: "common/src/vec3.rs",
};
const DISCRIMINANT: Place = Place {
    page: "red_sphere#what-the-discriminant-says",
    source: "chapters/2_red_sphere/src/lib.rs",
};
const EQUATION: Place = Place {
    page: "red_sphere#the-equation-of-a-sphere",
    source: "chapters/2_red_sphere/src/lib.rs",
};
const ROOT: Place = Place {
    page: "normals#where-the-nearer-root",
    source: "chapters/3_normals/src/lib.rs",
};
const SIGN_IN_H: Place = Place {
    page: "half_b_sphere#the-sign-that-got-lost",
    source: "chapters/4_half_b_sphere/src/lib.rs",
};
const SIGN_IN_ROOT: Place = Place {
    page: "editions#every-mixture",
    source: "chapters/3_normals/src/lib.rs",
};

pub(super) const SLIPS: &[Slip] = &[
    slip("oc-reversed", SPHERES, SIGN_IN_B)
        .says(Words {
            wrong: "oc = r.origin() - center",
            right: "oc = center - r.origin()",
            why: "Older editions have it this way round, with another sign in the formula. If \
                  you mix the two, every root changes its sign and the sphere is behind the \
                  camera.",
        })
        .before_4(Words {
            wrong: "oc = center - r.origin()",
            right: "oc = r.origin() - center",
            why: "Version 4 has it that way round, with another sign in the formula. If you mix \
                  the two, every root changes its sign and the sphere is behind the camera.",
        })
        .in_rust(
            HITTABLE_LIST,
            "oc = ray.origin - self.center",
            "oc = self.center - ray.origin",
        )
        .in_rust(
            SPHERES,
            "oc = ray.origin - center",
            "oc = center - ray.origin",
        )
        .reported(&["#1292", "PR #1304", "#1643"])
        .alters(|p| p.oc = |center, origin| origin - center)
        .equivalent(RED_SPHERE, SIGN_OF_B),
    slip("b-sign", FULL_B, SIGN_IN_B)
        .says(Words {
            wrong: "b = 2 * dot(r.direction(), oc)",
            right: "b = -2 * dot(r.direction(), oc)",
            why: "The sign belongs to oc = center - origin. Without it every root changes its sign \
                  and the sphere is behind the camera.",
        })
        .before_4(Words {
            wrong: "b = -2.0 * dot(oc, r.direction())",
            right: "b = 2.0 * dot(oc, r.direction())",
            why: "The minus belongs to oc = center - origin, as in version 4. With it every root \
                  changes its sign and the sphere is behind the camera.",
        })
        .in_rust(
            FULL_B,
            "b = 2.0 * ray.direction.dot(oc)",
            "b = -2.0 * ray.direction.dot(oc)",
        )
        .reported(&["#1292", "#1643"])
        .alters(|p| p.linear = |d_oc| 2.0 * d_oc)
        .equivalent(RED_SPHERE, SIGN_OF_B),
    slip("b-not-doubled", FULL_B, COEFFICIENTS)
        .says(Words {
            wrong: "b = -dot(r.direction(), oc)",
            right: "b = -2 * dot(r.direction(), oc)",
            why: "That is half of b, and the formula is the one for the whole: the discriminant is \
                  far too small.",
        })
        .before_4(Words {
            wrong: "b = dot(oc, r.direction())",
            right: "b = 2.0 * dot(oc, r.direction())",
            why: "That is half of b, and the formula is the one for the whole: the discriminant is \
                  far too small.",
        })
        .in_rust(
            FULL_B,
            "b = -ray.direction.dot(oc)",
            "b = -2.0 * ray.direction.dot(oc)",
        )
        .alters(|p| p.linear = |d_oc| -d_oc),
    slip("h-doubled", HALF_B, HALF)
        .says(Words {
            wrong: "h = -2 * dot(r.direction(), oc)",
            right: "h = dot(r.direction(), oc)",
            why: "That is b, and the formula is the one for half of it: the discriminant is far \
                  too large, and every root is behind the camera.",
        })
        .before_4(Words {
            wrong: "half_b = 2.0 * dot(oc, r.direction())",
            right: "half_b = dot(oc, r.direction())",
            why: "That is b, and the formula is the one for half of it: the discriminant is far \
                  too large.",
        })
        .in_rust(
            HALF_B,
            "h = -2.0 * ray.direction.dot(oc)",
            "h = ray.direction.dot(oc)",
        )
        .alters(|p| {
            p.linear = match p.edition {
                Edition::V4 => |d_oc| -2.0 * d_oc,
                // Half of b is minus h there, and the root begins with a minus.
                _ => |d_oc| 2.0 * d_oc,
            }
        }),
    slip("h-sign", HALF_B, HALF)
        .says(Words {
            wrong: "h = -dot(r.direction(), oc)",
            right: "h = dot(r.direction(), oc)",
            why: "b is -2h, so the minus of b is in the 2 already. With a second minus every \
                  root changes its sign and the sphere is behind the camera.",
        })
        .in_rust(
            HALF_B,
            "h = -ray.direction.dot(oc)",
            "h = ray.direction.dot(oc)",
        )
        .alters(|p| p.linear = |d_oc| -d_oc),
    slip("discriminant-without-four", FULL_B, DISCRIMINANT)
        .says(Words {
            wrong: "discriminant = b*b - a*c",
            right: "discriminant = b*b - 4*a*c",
            why: "The 4 goes only if b is halved. Here the discriminant is too large, and every \
                  ray hits.",
        })
        .in_rust(
            FULL_B,
            "discriminant = b * b - a * c",
            "discriminant = b * b - 4.0 * a * c",
        )
        .reported(&["#113", "#126", "#146", "RayTracing/InOneWeekend#17"])
        .alters(|p| p.discriminant = |a, b, c| b * b - a * c),
    slip("discriminant-with-four", HALF_B, HALF)
        .says(Words {
            wrong: "discriminant = h*h - 4*a*c",
            right: "discriminant = h*h - a*c",
            why: "Halving b cancels the 4. With it the discriminant is too small, and the small \
                  sphere is gone.",
        })
        .before_4(Words {
            wrong: "discriminant = half_b*half_b - 4*a*c",
            right: "discriminant = half_b*half_b - a*c",
            why: "Halving b cancels the 4. With it the discriminant is too small, and the small \
                  sphere is gone.",
        })
        .in_rust(
            HALF_B,
            "discriminant = h * h - 4.0 * a * c",
            "discriminant = h * h - a * c",
        )
        .reported(&["#113", "#126", "#146", "RayTracing/InOneWeekend#17"])
        .alters(|p| p.discriminant = |a, h, c| h * h - 4.0 * a * c),
    slip("discriminant-with-plus", SPHERES, DISCRIMINANT)
        .says(Words {
            wrong: "discriminant = b*b + 4*a*c",
            right: "discriminant = b*b - 4*a*c",
            why: "From outside a sphere c is positive, so the sum is as well, and every line seems \
                  to meet the sphere.",
        })
        .in_book(
            HALF_B,
            "discriminant = h*h + a*c",
            "discriminant = h*h - a*c",
        )
        .in_rust(
            FULL_B,
            "discriminant = b * b + 4.0 * a * c",
            "discriminant = b * b - 4.0 * a * c",
        )
        .in_rust(
            HALF_B,
            "discriminant = h * h + a * c",
            "discriminant = h * h - a * c",
        )
        .alters(|p| {
            p.discriminant = match p.chapter {
                Chapter::RedSphere | Chapter::Normals => |a, b, c| b * b + 4.0 * a * c,
                _ => |a, h, c| h * h + a * c,
            }
        }),
    slip("tangent-missed", SPHERES, DISCRIMINANT)
        .says(Words {
            wrong: "discriminant > 0",
            right: "discriminant >= 0",
            why: "A ray that only touches the sphere has one root, and the discriminant is 0. No \
                  ray of the camera touches exactly.",
        })
        .in_rust(RED_SPHERE, "discriminant > 0.0", "discriminant >= 0.0")
        .in_rust(ROOTS, "if discriminant <= 0.0", "if discriminant < 0.0")
        .reported(&["#110", "#1057", "#1058", "PR #1124"])
        .alters(|p| p.meets = |discriminant| discriminant > 0.0)
        .only_by_law(SPHERES, "A tangent is a hit."),
    slip("hit-and-miss-swapped", SPHERES, DISCRIMINANT)
        .says(Words {
            wrong: "if (discriminant > 0) miss",
            right: "if (discriminant < 0) miss",
            why: "Lines that pass through the sphere have two roots, and a positive discriminant.",
        })
        .in_rust(RED_SPHERE, "discriminant <= 0.0", "discriminant >= 0.0")
        .in_rust(ROOTS, "if discriminant > 0.0", "if discriminant < 0.0")
        .alters(|p| p.meets = |discriminant| discriminant <= 0.0),
    slip("radius-not-squared", SPHERES, EQUATION)
        .says(Words {
            wrong: "c = dot(oc, oc) - radius",
            right: "c = dot(oc, oc) - radius*radius",
            why: "A radius of 0.5 acts as its square root, 0.707: the disc is too large.",
        })
        .in_rust(
            FULL_B,
            "c = oc.dot(oc) - radius;",
            "c = oc.dot(oc) - radius * radius;",
        )
        .in_rust(
            HITTABLE_LIST,
            "c = oc.length_squared() - self.radius;",
            "c = oc.length_squared() - self.radius * self.radius;",
        )
        .in_rust(
            HALF_B,
            "c = oc.length_squared() - radius;",
            "c = oc.length_squared() - radius * radius;",
        )
        .alters(|p| p.constant = |oc_squared, radius| oc_squared - radius),
    slip("radius-doubled", SPHERES, EQUATION)
        .says(Words {
            wrong: "c = dot(oc, oc) - 2 * radius",
            right: "c = dot(oc, oc) - radius*radius",
            why: "The square of the radius is radius*radius. Twice 0.5 is 1, the distance of the \
                  center: the eye is on the sphere.",
        })
        .in_rust(
            FULL_B,
            "c = oc.dot(oc) - 2.0 * radius",
            "c = oc.dot(oc) - radius * radius",
        )
        .in_rust(
            HITTABLE_LIST,
            "c = oc.length_squared() - 2.0 * self.radius",
            "c = oc.length_squared() - self.radius * self.radius",
        )
        .in_rust(
            HALF_B,
            "c = oc.length_squared() - 2.0 * radius",
            "c = oc.length_squared() - radius * radius",
        )
        .alters(|p| p.constant = |oc_squared, radius| oc_squared - 2.0 * radius),
    slip("radius-forgotten", SPHERES, EQUATION)
        .says(Words {
            wrong: "c = dot(oc, oc)",
            right: "c = dot(oc, oc) - radius*radius",
            why: "A sphere of radius 0 is a point, and no ray meets it but one.",
        })
        .in_rust(
            FULL_B,
            "c = oc.dot(oc);",
            "c = oc.dot(oc) - radius * radius;",
        )
        .in_rust(
            HITTABLE_LIST,
            "c = oc.length_squared();",
            "c = oc.length_squared() - self.radius * self.radius;",
        )
        .in_rust(
            HALF_B,
            "c = oc.length_squared();",
            "c = oc.length_squared() - radius * radius;",
        )
        .alters(|p| p.constant = |oc_squared, _| oc_squared),
    slip("center-not-squared", SPHERES, EQUATION)
        .says(Words {
            wrong: "c = oc.length() - radius*radius",
            right: "c = dot(oc, oc) - radius*radius",
            why: "The equation has the square of the distance. Near 1 the two are alike, so a \
                  sphere at -1 hides it.",
        })
        .in_rust(
            FULL_B,
            "c = oc.length() - radius * radius",
            "c = oc.dot(oc) - radius * radius",
        )
        .in_rust(
            HITTABLE_LIST,
            "c = oc.length() - self.radius * self.radius",
            "c = oc.length_squared() - self.radius * self.radius",
        )
        .in_rust(
            HALF_B,
            "c = oc.length() - radius * radius",
            "c = oc.length_squared() - radius * radius",
        )
        .alters(|p| p.constant = |oc_squared, radius| oc_squared.sqrt() - radius * radius),
    slip("a-taken-as-one", SPHERES, COEFFICIENTS)
        .says(Words {
            wrong: "a = 1",
            right: "a = dot(r.direction(), r.direction())",
            why: "That holds for unit directions only. Here it gives every ray the discriminant of \
                  the one in the middle, and every ray hits.",
        })
        .in_rust(FULL_B, "a = 1.0", "a = ray.direction.dot(ray.direction)")
        .in_rust(HALF_B, "a = 1.0", "a = ray.direction.length_squared()")
        .alters(|p| p.a = |_, _| 1.0),
    slip("a-from-oc", SPHERES, COEFFICIENTS)
        .says(Words {
            wrong: "a = dot(oc, oc)",
            right: "a = dot(r.direction(), r.direction())",
            why: "a is made of the direction, c of the way to the center. With its length in \
                  place of the other one, the disc is too large or too small.",
        })
        .in_rust(
            FULL_B,
            "a = oc.dot(oc)",
            "a = ray.direction.dot(ray.direction)",
        )
        .in_rust(
            HALF_B,
            "a = oc.length_squared()",
            "a = ray.direction.length_squared()",
        )
        .alters(|p| {
            p.coefficients = |program, ball, ray| {
                let [_, b, c] = coefficients(program, ball, ray);
                let oc = (program.oc)(ball.center, ray.origin);
                [(program.squared)(program, oc), b, c]
            }
        }),
    slip("a-from-length", SPHERES, COEFFICIENTS)
        .says(Words {
            wrong: "a = r.direction().length()",
            right: "a = dot(r.direction(), r.direction())",
            why: "a is the square of the direction's length. Of a direction 1 long both are 1, and \
                  the eye's are longer towards the corners.",
        })
        .in_rust(
            FULL_B,
            "a = ray.direction.length()",
            "a = ray.direction.dot(ray.direction)",
        )
        .in_rust(
            HALF_B,
            "a = ray.direction.length()",
            "a = ray.direction.length_squared()",
        )
        .alters(|p| p.a = |program, direction| (program.squared)(program, direction).sqrt()),
    slip("b-from-oc", SPHERES, COEFFICIENTS)
        .says(Words {
            wrong: "b = -2 * dot(oc, oc)",
            right: "b = -2 * dot(r.direction(), oc)",
            why: "b is made of the direction and of the way to the center: it says how far the ray \
                  turns towards the sphere.",
        })
        .in_book(HALF_B, "h = dot(oc, oc)", "h = dot(r.direction(), oc)")
        .in_rust(
            FULL_B,
            "b = -2.0 * oc.dot(oc)",
            "b = -2.0 * ray.direction.dot(oc)",
        )
        .in_rust(HALF_B, "h = oc.dot(oc)", "h = ray.direction.dot(oc)")
        .alters(|p| {
            p.coefficients = |program, ball, ray| {
                let [a, _, c] = coefficients(program, ball, ray);
                let oc = (program.oc)(ball.center, ray.origin);
                [a, (program.linear)((program.dot)(oc, oc)), c]
            }
        }),
    slip("discriminant-without-a", SPHERES, DISCRIMINANT)
        .says(Words {
            wrong: "discriminant = b*b - 4*c",
            right: "discriminant = b*b - 4*a*c",
            why: "Without a it holds for directions 1 long only, and the disc is too large or torn.",
        })
        .in_book(HALF_B, "discriminant = h*h - c", "discriminant = h*h - a*c")
        .in_rust(
            FULL_B,
            "discriminant = b * b - 4.0 * c",
            "discriminant = b * b - 4.0 * a * c",
        )
        .in_rust(
            HALF_B,
            "discriminant = h * h - c",
            "discriminant = h * h - a * c",
        )
        .alters(|p| {
            p.discriminant = match p.chapter {
                Chapter::RedSphere | Chapter::Normals => |_, b, c| b * b - 4.0 * c,
                _ => |_, h, c| h * h - c,
            }
        }),
    slip("c-from-direction", SPHERES, COEFFICIENTS)
        .says(Words {
            wrong: "c = dot(r.direction(), r.direction()) - radius*radius",
            right: "c = dot(oc, oc) - radius*radius",
            why: "c is made of the way to the center, a of the direction. Only in the middle, \
                  where both are 1 long, they are alike.",
        })
        .in_rust(
            FULL_B,
            "c = ray.direction.dot(ray.direction) - radius * radius",
            "c = oc.dot(oc) - radius * radius",
        )
        .in_rust(
            HITTABLE_LIST,
            "c = ray.direction.length_squared() - self.radius * self.radius",
            "c = oc.length_squared() - self.radius * self.radius",
        )
        .in_rust(
            HALF_B,
            "c = ray.direction.length_squared() - radius * radius",
            "c = oc.length_squared() - radius * radius",
        )
        .alters(|p| {
            p.coefficients = |program, ball, ray| {
                let [a, b, _] = coefficients(program, ball, ray);
                let squared = (program.squared)(program, ray.direction);
                [a, b, (program.constant)(squared, ball.radius)]
            }
        }),
    slip("dot-with-swapped-letter", SPHERES, DOT)
        .says(Words {
            wrong: "u.x*v.x + u.y*v.y + u.z*u.z",
            right: "u.x*v.x + u.y*v.y + u.z*v.z",
            why: "With oc.z and d.z both -1 the last product is right by chance. Any other sphere, \
                  and every normal's side, is wrong.",
        })
        .in_rust(
            SPHERES,
            "self.x * other.x + self.y * other.y + self.z * self.z",
            "self.x * other.x + self.y * other.y + self.z * other.z",
        )
        .reported(&["#1292"])
        .alters(|p| p.dot = |u, v| u.x * v.x + u.y * v.y + u.z * u.z),
    slip("dot-without-z", SPHERES, DOT)
        .says(Words {
            wrong: "u.x*v.x + u.y*v.y",
            right: "u.x*v.x + u.y*v.y + u.z*v.z",
            why: "A dot product has three terms. Without the third, depth is lost.",
        })
        .in_rust(
            SPHERES,
            "self.x * other.x + self.y * other.y",
            "self.x * other.x + self.y * other.y + self.z * other.z",
        )
        .alters(|p| p.dot = |u, v| u.x * v.x + u.y * v.y),
    slip("stale-boolean", ONE_SPHERE, ROOT)
        .says(Words {
            wrong: "return discriminant >= 0",
            right: "return (-b - sqrt(discriminant)) / (2*a)",
            why: "Left from chapter 2: true turns into t = 1 for every hit. The disc is right, its \
                  colors are a wheel of directions without depth.",
        })
        .in_book(
            HALF_B,
            "return discriminant >= 0",
            "return (h - sqrt(discriminant)) / a",
        )
        .made_in(|letters| letters != Letters::Rust)
        .alters(|p| p.divide = |_, _| 1.0),
    slip("minus-one-is-true", ONE_SPHERE, ROOT)
        .says(Words {
            wrong: "bool hit_sphere(…) { … return -1.0;",
            right: "double hit_sphere(…) { … return -1.0;",
            why: "As a bool every number but 0 is true, and true turns into t = 1. All pixels are \
                  colored, also those that miss.",
        })
        .reported(&["#157"])
        .made_in(|letters| matches!(letters, Letters::Book(_)))
        .alters(|p| {
            p.meets = |_| true;
            p.divide = |_, _| 1.0;
        }),
    slip("miss-is-one", ONE_SPHERE, ROOT)
        .says(Words {
            wrong: "if (discriminant < 0) return 1.0",
            right: "if (discriminant < 0) return -1.0",
            why: "The caller takes every t > 0 for a hit. The sphere is right, and around it the \
                  sky has the colors of a hit at t = 1.",
        })
        .made_in(|letters| letters != Letters::Rust)
        .alters(|p| p.missed = Some(1.0)),
    slip("minus-h", HALF_B, SIGN_IN_H)
        .says(Words {
            wrong: "(-h - sqrt(discriminant)) / a",
            right: "(h - sqrt(discriminant)) / a",
            why: "b is -2h, so -b is 2h: the minus is used up. With a second minus the result is \
                  minus the far root, and the sphere is behind the camera.",
        })
        .before_4(Words {
            wrong: "(half_b - sqrt(discriminant)) / a",
            right: "(-half_b - sqrt(discriminant)) / a",
            why: "Here half_b is half of b, so the root begins with a minus, as it does with b. \
                  Without it the result is minus the far root, and the sphere is behind the \
                  camera.",
        })
        .in_rust(
            HITTABLE_LIST,
            "roots = [(-h - sqrtd) / a, (-h + sqrtd) / a]",
            "roots = [(h - sqrtd) / a, (h + sqrtd) / a]",
        )
        .in_rust(
            HALF_B,
            "(-h - discriminant.sqrt()) / a",
            "(h - discriminant.sqrt()) / a",
        )
        .reported(&["#1292", "PR #1304", "#1643"])
        .alters(|p| p.first_term = |h| -h),
    slip("plus-b", NORMALS, SIGN_IN_ROOT)
        .says(Words {
            wrong: "(b - sqrt(discriminant)) / (2*a)",
            right: "(-b - sqrt(discriminant)) / (2*a)",
            why: "Without the minus the result is minus the far root, and the sphere is behind the \
                  camera.",
        })
        .in_rust(
            NORMALS,
            "(b - discriminant.sqrt()) / (2.0 * a)",
            "(-b - discriminant.sqrt()) / (2.0 * a)",
        )
        .alters(|p| p.first_term = |b| b),
    slip("far-root", ROOTS, ROOT)
        .says(Words {
            wrong: "(-b + sqrt(discriminant)) / (2*a)",
            right: "(-b - sqrt(discriminant)) / (2*a)",
            why: "The plus gives the far side of the sphere, seen from inside.",
        })
        .in_book(
            HALF_B,
            "(h + sqrt(discriminant)) / a",
            "(h - sqrt(discriminant)) / a",
        )
        .in_rust(
            NORMALS,
            "(-b + discriminant.sqrt()) / (2.0 * a)",
            "(-b - discriminant.sqrt()) / (2.0 * a)",
        )
        .in_rust(
            HITTABLE_LIST,
            "roots = [(h + sqrtd) / a, (h + sqrtd) / a]",
            "roots = [(h - sqrtd) / a, (h + sqrtd) / a]",
        )
        .in_rust(
            HALF_B,
            "(h + discriminant.sqrt()) / a",
            "(h - discriminant.sqrt()) / a",
        )
        .alters(|p| p.numerators = |first, sqrtd, _| [first + sqrtd; 2]),
    slip("square-root-forgotten", ROOTS, ROOT)
        .says(Words {
            wrong: "(-b - discriminant) / (2*a)",
            right: "(-b - sqrt(discriminant)) / (2*a)",
            why: "The discriminant's sign alone decides which lines meet the sphere, so the disc \
                  stays; but the points are not on it.",
        })
        .in_book(
            HALF_B,
            "(h - discriminant) / a",
            "(h - sqrt(discriminant)) / a",
        )
        .in_rust(
            NORMALS,
            "(-b - discriminant) / (2.0 * a)",
            "(-b - discriminant.sqrt()) / (2.0 * a)",
        )
        .in_rust(
            HITTABLE_LIST,
            "sqrtd = discriminant;",
            "sqrtd = discriminant.sqrt();",
        )
        .in_rust(
            HALF_B,
            "(h - discriminant) / a",
            "(h - discriminant.sqrt()) / a",
        )
        .alters(|p| p.sqrt = |discriminant| discriminant),
    slip("two-a-without-brackets", ROOTS, ROOT)
        .says(Words {
            wrong: "(-b - sqrt(discriminant)) / 2*a",
            right: "(-b - sqrt(discriminant)) / (2*a)",
            why: "That divides by 2 and then multiplies by a. In the middle, where a is 1, it is \
                  right.",
        })
        .in_rust(
            NORMALS,
            "(-b - discriminant.sqrt()) / 2.0 * a",
            "(-b - discriminant.sqrt()) / (2.0 * a)",
        )
        .in_rust(HITTABLE_LIST, "(-b - sqrtd) / 2.0 * a", "(h - sqrtd) / a")
        .in_rust(
            HALF_B,
            "(-b - discriminant.sqrt()) / 2.0 * a",
            "(h - discriminant.sqrt()) / a",
        )
        .alters(
            |p| // Who types the whole of b in later chapters as well has a numerator twice as
            // large.
            p.divide = match p.chapter {
                Chapter::Normals => |numerator, a| numerator / 2.0 * a,
                _ => |half, a| half * a,
            },
        ),
    slip("numerator-without-brackets", ROOTS, ROOT)
        .says(Words {
            wrong: "-b - sqrt(discriminant) / (2*a)",
            right: "(-b - sqrt(discriminant)) / (2*a)",
            why: "Only the square root is divided. With the whole of b that is wrong everywhere; \
                  with half of it the middle is right, where a is 1.",
        })
        .before_4(Words {
            wrong: "-b - sqrt(discriminant) / (2*a), or -half_b - sqrt(discriminant) / a",
            right: "(-b - sqrt(discriminant)) / (2*a), or (-half_b - sqrt(discriminant)) / a",
            why: "Only the square root is divided. With the whole of b that is wrong everywhere; \
                  with half of it the middle is right, where a is 1.",
        })
        .in_book(
            HALF_B,
            "h - sqrt(discriminant) / a",
            "(h - sqrt(discriminant)) / a",
        )
        .in_rust(
            NORMALS,
            "-b - discriminant.sqrt() / (2.0 * a)",
            "(-b - discriminant.sqrt()) / (2.0 * a)",
        )
        .in_rust(
            HITTABLE_LIST,
            "roots = [h - sqrtd / a, h + sqrtd / a]",
            "roots = [(h - sqrtd) / a, (h + sqrtd) / a]",
        )
        .in_rust(
            HALF_B,
            "h - discriminant.sqrt() / a",
            "(h - discriminant.sqrt()) / a",
        )
        .alters(|p| {
            p.numerators = match p.chapter {
                Chapter::Normals => |first, sqrtd, a| [first - sqrtd / (2.0 * a); 2],
                Chapter::HalfBSphere => |first, sqrtd, a| [first - sqrtd / a; 2],
                _ => |first, sqrtd, a| [first - sqrtd / a, first + sqrtd / a],
            };
            p.divide = |root, _| root;
        }),
    slip("divided-by-a", NORMALS, ROOT)
        .says(Words {
            wrong: "(-b - sqrt(discriminant)) / a",
            right: "(-b - sqrt(discriminant)) / (2*a)",
            why: "That is the division of the next chapter, where b is halved. Here t is twice as \
                  large.",
        })
        .in_rust(
            NORMALS,
            "(-b - discriminant.sqrt()) / a",
            "(-b - discriminant.sqrt()) / (2.0 * a)",
        )
        .alters(|p| p.divide = |numerator, a| numerator / a),
    slip("divided-by-two-a", HALF_B, HALF)
        .says(Words {
            wrong: "(h - sqrt(discriminant)) / (2*a)",
            right: "(h - sqrt(discriminant)) / a",
            why: "Halving b cancels the 2. With it t is half as large.",
        })
        .before_4(Words {
            wrong: "(-half_b - sqrt(discriminant)) / (2*a)",
            right: "(-half_b - sqrt(discriminant)) / a",
            why: "Halving b cancels the 2. With it t is half as large.",
        })
        .in_rust(
            HITTABLE_LIST,
            "roots = [(h - sqrtd) / (2.0 * a), (h + sqrtd) / (2.0 * a)]",
            "roots = [(h - sqrtd) / a, (h + sqrtd) / a]",
        )
        .in_rust(
            HALF_B,
            "(h - discriminant.sqrt()) / (2.0 * a)",
            "(h - discriminant.sqrt()) / a",
        )
        .alters(|p| p.divide = |numerator, a| numerator / (2.0 * a)),
    slip("not-divided", HALF_B, HALF)
        .says(Words {
            wrong: "h - sqrt(discriminant)",
            right: "(h - sqrt(discriminant)) / a",
            why: "That is right for unit directions only. The rays here are longer away from the \
                  middle.",
        })
        .before_4(Words {
            wrong: "-half_b - sqrt(discriminant)",
            right: "(-half_b - sqrt(discriminant)) / a",
            why: "That is right for unit directions only. The rays here are longer away from the \
                  middle.",
        })
        .in_rust(
            HITTABLE_LIST,
            "roots = [h - sqrtd, h + sqrtd]",
            "roots = [(h - sqrtd) / a, (h + sqrtd) / a]",
        )
        .in_rust(
            HALF_B,
            "Some(h - discriminant.sqrt())",
            "Some((h - discriminant.sqrt()) / a)",
        )
        .alters(|p| p.divide = |numerator, _| numerator),
];
