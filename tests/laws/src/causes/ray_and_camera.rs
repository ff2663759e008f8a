//! The mistakes in the small functions that everything else rests on.

use common::rtweekend::*;

use super::{Hypothesis, Mistake, Question};
use crate::ray_and_camera::{Arrow, Letters, Pixel, Place, Width};
use crate::shrinker::Simplify;

/// A mistake, and a function that makes it.
type Known<Q, A> = (Mistake, fn(&Q) -> A);

const fn slip<Q, A>(
    name: &'static [&'static str],
    wrong: &'static str,
    right: &'static str,
    answer: fn(&Q) -> A,
) -> Known<Q, A> {
    let mistake = Mistake {
        names: name,
        wrong,
        right,
    };
    (mistake, answer)
}

/// What is asked of a small function, and the mistakes in it: all is simple from the
/// start, so nothing is made simpler.
macro_rules! small_function {
    ($question:ty => $answer:ty, called $name:literal, $right:expr, $same:expr,
     asked $telling:expr, wrong $known:expr, as $test:expr) => {
        impl Question for $question {
            type Answer = $answer;

            const FUNCTION: &'static str = $name;

            fn right(&self) -> $answer {
                let right: fn(&Self) -> $answer = $right;
                right(self)
            }

            fn same(&self, one: &$answer, other: &$answer) -> bool {
                $same(*one, *other)
            }

            fn telling() -> Vec<Self> {
                $telling
            }

            fn hypotheses() -> Vec<Hypothesis<Self>> {
                const KNOWN: &[Known<$question, $answer>] = $known;
                let hypothesis = |&(mistake, answer): &_| Hypothesis::new(mistake, answer);
                KNOWN.iter().map(hypothesis).collect()
            }
        }

        impl Simplify for $question {
            fn simpler(&self) -> Vec<Self> {
                Vec::new()
            }

            fn as_test(&self, function: &str) -> String {
                let as_test: fn(&Self, &str) -> String = $test;
                as_test(self, function)
            }
        }
    };
}

small_function! {
    Letters => f64, called "dot",
    |letters| {
        let [u, v] = letters.vectors();
        u.dot(v)
    },
    |one: f64, other: f64| one == other,
    asked [
        [[1, 2, 3], [5, 7, 11]],
        [[1, 0, 0], [0, 1, 0]],
        [[0, 1, 0], [0, 0, 1]],
        [[0, 0, 1], [1, 0, 0]],
        [[-4, 9, 2], [3, -8, 6]],
    ].map(Letters).into(),
    wrong &[
        slip(&["dot-with-swapped-letter"], "u.x*v.x + u.y*v.y + u.z*u.z", "u.x*v.x + u.y*v.y + u.z*v.z", |letters| {
            let [u, v] = letters.vectors();
            u.x * v.x + u.y * v.y + u.z * u.z
        }),
        slip(&["dot-without-z"], "u.x*v.x + u.y*v.y", "u.x*v.x + u.y*v.y + u.z*v.z", |letters| {
            let [u, v] = letters.vectors();
            u.x * v.x + u.y * v.y
        }),
    ],
    as |letters, dot| {
        let [u, v] = letters.vectors().map(code);
        format!("assert_eq!({dot}({u}, {v}), {:?});", letters.right())
    }
}

small_function! {
    Arrow => Vec3, called "unit_vector",
    |arrow| arrow.0.normalize(),
    near,
    asked [[1.0, 2.0, 2.0], [0.0, -3.0, 4.0], [0.125, 0.0, 0.0], [-20.0, 5.0, 4.0]]
        .map(|v| Arrow(Vec3::from_array(v)))
        .into(),
    wrong &[
        slip(
            &["divided-by-length-squared"],
            "unit_vector(v) = v / v.length_squared()",
            "unit_vector(v) = v / v.length()",
            |&Arrow(v)| v / v.length_squared(),
        ),
        slip(
            &["length-with-swapped-letter"],
            "e[0]*e[0] + e[1]*e[1] + e[1]*e[1]",
            "e[0]*e[0] + e[1]*e[1] + e[2]*e[2]",
            |&Arrow(v)| v / (v.x * v.x + v.y * v.y + v.y * v.y).sqrt(),
        ),
        slip(
            &["divided-with-swapped-letter"],
            "vec3(v.x / t, v.y / t, v.y / t)",
            "vec3(v.x / t, v.y / t, v.z / t)",
            |&Arrow(v)| Vec3::new(v.x, v.y, v.y) / v.length(),
        ),
        slip(&[], "unit_vector(v) = v * v.length()", "unit_vector(v) = v / v.length()", |&Arrow(v)| v * v.length()),
        slip(&[], "unit_vector(v) = v", "unit_vector(v) = v / v.length()", |&Arrow(v)| v),
    ],
    as |arrow, unit| {
        let v = code(arrow.0);
        format!("assert!(({unit}({v}).length() - 1.0).abs() < 1e-9);")
    }
}

small_function! {
    Place => Point3, called "at",
    |&Place { ray, t }| ray.origin + t * ray.direction,
    |one: Point3, other: Point3| one == other,
    asked {
        let ray = Ray::new(Point3::new(1.0, -2.0, 3.0), Vec3::new(5.0, 7.0, -11.0));
        let rounding = Ray::new(Point3::splat(-1.0), Vec3::splat(10.0));
        [(ray, 0.0), (ray, 1.0), (ray, -2.0), (rounding, 0.1)]
            .map(|(ray, t)| Place { ray, t })
            .into()
    },
    wrong &[
        slip(
            &["point-along-unit-direction"],
            "r.at(t) = origin + t * unit_vector(direction)",
            "r.at(t) = origin + t * direction",
            |&Place { ray, t }| ray.origin + t * ray.direction.normalize(),
        ),
        slip(&["point-without-origin"], "r.at(t) = t * direction", "r.at(t) = origin + t * direction", |&Place { ray, t }| {
            t * ray.direction
        }),
        slip(
            &["sum-with-swapped-letter"],
            "vec3(u.x + v.x, u.y + v.y, u.z + u.z)",
            "vec3(u.x + v.x, u.y + v.y, u.z + v.z)",
            |&Place { ray, t }| (ray.origin + t * ray.direction).with_z(ray.origin.z + ray.origin.z),
        ),
        slip(&[], "r.at(t) = origin - t * direction", "r.at(t) = origin + t * direction", |&Place { ray, t }| {
            ray.origin - t * ray.direction
        }),
        slip(&[], "a fused mul_add", "a product, rounded, and then a sum", |&Place { ray, t }| {
            ray.direction.mul_add(Vec3::splat(t), ray.origin)
        }),
    ],
    as |place, at| {
        let Ray { origin, direction } = place.ray;
        let [origin, direction, right] = [origin, direction, place.right()].map(code);
        format!(
            "let ray = Ray::new({origin}, {direction});\nassert_eq!({at}(&ray, {:?}), {right});",
            place.t
        )
    }
}

small_function! {
    Width => u32, called "height",
    |width| (9 * width.0 / 16).max(1),
    |one: u32, other: u32| one == other,
    asked (1..=400).map(Width).collect(),
    wrong &[
        slip(&["integer-aspect-ratio"], "int aspect_ratio = 16 / 9", "double aspect_ratio = 16.0 / 9.0", |width| width.0),
        slip(
            &["inverted-aspect-ratio"],
            "image_height = image_width * aspect_ratio",
            "image_height = image_width / aspect_ratio",
            |width| (f64::from(width.0) * (16.0 / 9.0)) as u32,
        ),
        slip(
            &["height-rounded"],
            "image_height = round(image_width / aspect_ratio)",
            "image_height = int(image_width / aspect_ratio)",
            |width| ((f64::from(width.0) * 9.0 / 16.0).round() as u32).max(1),
        ),
        slip(
            &["height-may-be-zero"],
            "image_height = int(image_width / aspect_ratio)",
            "… and image_height = (image_height < 1) ? 1 : image_height",
            |width| 9 * width.0 / 16,
        ),
        slip(
            &[],
            "the height is rounded, and may be 0",
            "image_height = int(image_width / aspect_ratio), and at least 1",
            |width| (f64::from(width.0) * 9.0 / 16.0).round() as u32,
        ),
    ],
    as |width, height| format!("assert_eq!({height}({}), {});", width.0, width.right())
}

small_function! {
    Pixel => Ray, called "pixel_ray",
    |pixel| pixel.ray(|_| {}),
    |one: Ray, other: Ray| one.origin == other.origin && near(one.direction, other.direction),
    asked pixels(),
    wrong RAYS,
    as |pixel, ray| {
        let Pixel { size, place } = pixel;
        let right = code(pixel.right().direction);
        format!(
            "let ray = {ray}({size:?}, {place:?});\n\
             assert!((ray.at(1.0) - {right}).length() < 1e-9);"
        )
    }
}

/// The pixels that tell most, in pictures of the widths of the book and its probes.
fn pixels() -> Vec<Pixel> {
    let in_picture = |size: [u32; 2]| {
        let [width, height] = size;
        [
            [3 * width / 5, height / 3],
            [0, 0],
            [width - 1, 0],
            [0, height - 1],
        ]
        .map(|place| Pixel { size, place })
    };
    [[100, 56], [227, 127], [400, 225], [16, 9]]
        .into_iter()
        .flat_map(in_picture)
        .collect()
}

const RAYS: &[Known<Pixel, Ray>] = &[
    slip(
        &["viewport-upside-down"],
        "viewport_v = (0, viewport_height, 0)",
        "viewport_v = (0, -viewport_height, 0)",
        |pixel| pixel.ray(|camera| camera.edges[1] *= -1.0),
    ),
    slip(
        &["viewport-mirrored"],
        "viewport_u = (-viewport_width, 0, 0)",
        "viewport_u = (viewport_width, 0, 0)",
        |pixel| pixel.ray(|camera| camera.edges[0] *= -1.0),
    ),
    slip(
        &["grid-not-inset"],
        "pixel00 = viewport_upper_left",
        "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        |pixel| pixel.ray(|camera| camera.inset = [0.0, 0.0]),
    ),
    slip(
        &["inset-upwards"],
        "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u - pixel_delta_v)",
        "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        |pixel| pixel.ray(|camera| camera.inset = [0.5, -0.5]),
    ),
    slip(
        &["inset-to-the-left"],
        "pixel00 = viewport_upper_left - 0.5 * (pixel_delta_u - pixel_delta_v)",
        "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        |pixel| pixel.ray(|camera| camera.inset = [-0.5, 0.5]),
    ),
    slip(
        &["first-pixel-on-axis"],
        "pixel00 = center - (0, 0, focal_length), or … + 0.5 * (viewport_u + viewport_v)",
        "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        |pixel| pixel.ray(first_pixel_on_the_axis),
    ),
    slip(
        &["division-in-place"],
        "vec3& operator/(double t) { e[0] /= t; …; return *this; }",
        "vec3 operator/(vec3 v, double t) { return (1/t) * v; }",
        |pixel| pixel.ray(first_pixel_on_the_axis),
    ),
    slip(
        &["older-camera"],
        "u = i / (image_width - 1), v = j / (image_height - 1)",
        "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
        |pixel| {
            pixel.ray(|camera| {
                camera.inset = [0.0, 0.0];
                camera.steps = camera.steps.map(|steps| steps - 1.0);
            })
        },
    ),
    slip(
        &["viewport-not-centered"],
        "viewport_upper_left = center - (0, 0, focal_length)",
        "… - viewport_u / 2 - viewport_v / 2",
        |pixel| pixel.ray(|camera| camera.corner = 0.0),
    ),
    slip(
        &["corner-not-halved"],
        "… - viewport_u - viewport_v",
        "… - viewport_u / 2 - viewport_v / 2",
        |pixel| pixel.ray(|camera| camera.corner = 1.0),
    ),
    slip(
        &["focal-length-added"],
        "viewport_upper_left = center + (0, 0, focal_length) - …",
        "viewport_upper_left = center - (0, 0, focal_length) - …",
        |pixel| pixel.ray(|camera| camera.focal_length = -1.0),
    ),
    slip(
        &["focal-length-forgotten"],
        "viewport_upper_left = center - viewport_u / 2 - viewport_v / 2",
        "viewport_upper_left = center - (0, 0, focal_length) - …",
        |pixel| pixel.ray(|camera| camera.focal_length = 0.0),
    ),
    slip(
        &["focal-length-two"],
        "focal_length = 2",
        "focal_length = 1",
        |pixel| pixel.ray(|camera| camera.focal_length = 2.0),
    ),
    slip(
        &["viewport-height-one"],
        "viewport_height = 1",
        "viewport_height = 2",
        |pixel| pixel.ray(|camera| camera.edges = camera.edges.map(|edge| 0.5 * edge)),
    ),
    slip(
        &["ideal-viewport-ratio"],
        "viewport_width = viewport_height * aspect_ratio",
        "viewport_width = viewport_height * (double(image_width) / image_height)",
        |pixel| pixel.ray(|camera| camera.edges[0] = 2.0 * (16.0 / 9.0)),
    ),
    slip(
        &["integer-viewport-ratio"],
        "viewport_width = viewport_height * (image_width / image_height)",
        "viewport_width = viewport_height * (double(image_width) / image_height)",
        |pixel| pixel.ray(|camera| camera.edges[0] = 2.0 * (0.5 * camera.edges[0]).floor()),
    ),
    slip(
        &["inverted-viewport-ratio"],
        "viewport_width = viewport_height * (double(image_height) / image_width)",
        "viewport_width = viewport_height * (double(image_width) / image_height)",
        |pixel| pixel.ray(|camera| camera.edges[0] = 4.0 / camera.edges[0]),
    ),
    slip(
        &["integer-viewport-width"],
        "int viewport_width = …",
        "double viewport_width = …",
        |pixel| pixel.ray(|camera| camera.edges[0] = camera.edges[0].trunc()),
    ),
    slip(
        &["viewport-lengths-swapped"],
        "viewport_u = (viewport_height, 0, 0), viewport_v = (0, -viewport_width, 0)",
        "viewport_u = (viewport_width, 0, 0), viewport_v = (0, -viewport_height, 0)",
        |pixel| pixel.ray(|camera| camera.edges.reverse()),
    ),
    slip(
        &["pixel-deltas-swapped"],
        "pixel_delta_u = viewport_u / image_height, pixel_delta_v = viewport_v / image_width",
        "pixel_delta_u = viewport_u / image_width, pixel_delta_v = viewport_v / image_height",
        |pixel| pixel.ray(|camera| camera.steps.reverse()),
    ),
    slip(
        &["columns-by-height"],
        "pixel_delta_u = viewport_u / image_height",
        "pixel_delta_u = viewport_u / image_width",
        |pixel| pixel.ray(|camera| camera.steps[0] = camera.steps[1]),
    ),
    slip(
        &["rows-by-width"],
        "pixel_delta_v = viewport_v / image_width",
        "pixel_delta_v = viewport_v / image_height",
        |pixel| pixel.ray(|camera| camera.steps[1] = camera.steps[0]),
    ),
    slip(
        &["column-and-row-swapped"],
        "pixel00 + j * pixel_delta_u + i * pixel_delta_v",
        "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
        |pixel| pixel.ray(|camera| camera.place.reverse()),
    ),
    slip(
        &["ray-normalized"],
        "ray(center, unit_vector(pixel_center - center))",
        "ray(center, pixel_center - center)",
        |pixel| {
            let ray = pixel.ray(|_| {});
            Ray::new(ray.origin, ray.direction.normalize())
        },
    ),
];

/// The numbers of a camera, to be changed by a mistake. Of each pair the first is for
/// columns, the second for rows.
struct Numbers {
    /// How long the edges of the viewport are, to the right and up.
    edges: [f64; 2],
    /// In how many steps an edge is divided.
    steps: [f64; 2],
    /// How far the first pixel is from the corner, in steps.
    inset: [f64; 2],
    /// Which part of the edges lies left of the axis, and above it.
    corner: f64,
    focal_length: f64,
    place: [f64; 2],
}

/// The grid begins where the middle of the picture should be.
fn first_pixel_on_the_axis(camera: &mut Numbers) {
    camera.corner = 0.0;
    camera.inset = [0.0, 0.0];
}

impl Pixel {
    /// The ray of the pixel, with `mistake` made in the numbers of the camera.
    fn ray(&self, mistake: impl Fn(&mut Numbers)) -> Ray {
        let [width, height] = self.size.map(f64::from);
        let mut camera = Numbers {
            edges: [2.0 * (width / height), 2.0],
            steps: [width, height],
            inset: [0.5, 0.5],
            corner: 0.5,
            focal_length: 1.0,
            place: self.place.map(f64::from),
        };
        mistake(&mut camera);
        let [x, y] = [0, 1].map(|axis| {
            let steps = (camera.place[axis] + camera.inset[axis]) / camera.steps[axis];
            camera.edges[axis] * (steps - camera.corner)
        });
        Ray::new(Point3::ZERO, Vec3::new(x, -y, -camera.focal_length))
    }
}

fn near(one: Vec3, other: Vec3) -> bool {
    (one - other).length() <= 1e-9 * (one.length() + other.length())
}

fn code(v: Vec3) -> String {
    format!("Vec3::new({:?}, {:?}, {:?})", v.x, v.y, v.z)
}
