//! Slips in the camera and in the sky.

use common::rtweekend::*;

use super::chapters::{GRADIENT, RAYS};
use crate::chapter::Chapter;
use crate::slips::program::Program;
use crate::slips::slip::{Slip, Unseen};

const WHITE: Color = Color::ONE;
const BLUE: Color = Color::new(0.5, 0.7, 1.0);

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "viewport-upside-down",
        chapters: RAYS,
        wrong: "viewport_v = (0, viewport_height, 0)",
        right: "viewport_v = (0, -viewport_height, 0)",
        explanation: "Rows run downwards while y points up, so the edge from top to bottom is negative. The picture stands on its head.",
        evidence: &["#879", "#1076", "#1579"],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_v: |height| Vec3::new(0.0, height, 0.0),
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "viewport-mirrored",
        chapters: RAYS,
        wrong: "viewport_u = (-viewport_width, 0, 0)",
        right: "viewport_u = (viewport_width, 0, 0)",
        explanation: "Left and right change places. The sky and a disc in the middle don't show it, the colors of normals do.",
        evidence: &[],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_u: |width| Vec3::new(-width, 0.0, 0.0),
            ..right
        },
        unseen: &[(
            GRADIENT,
            Unseen::Equivalent(
                "Only the sign of x changes, and the sky depends on y and the length of the direction.",
            ),
        )],
    },
    Slip {
        name: "grid-not-inset",
        chapters: RAYS,
        wrong: "pixel00 = viewport_upper_left",
        right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        explanation: "A pixel is sampled in its middle. At its corner, everything moves by half a pixel.",
        evidence: &["#923", "PR #1158"],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            inset: 0.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "older-camera",
        chapters: RAYS,
        wrong: "u = i / (image_width - 1), v = j / (image_height - 1)",
        right: "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
        explanation: "The camera of older editions puts the first and last pixels on the edges of the viewport: nearly right, but edges differ.",
        evidence: &[],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            pixel_deltas: |u, v, width, height| {
                [u * (1.0 / (width - 1.0)), v * (1.0 / (height - 1.0))]
            },
            inset: 0.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "viewport-not-centered",
        chapters: RAYS,
        wrong: "viewport_upper_left = center - (0, 0, focal_length)",
        right: "… - viewport_u / 2 - viewport_v / 2",
        explanation: "Without the two halves the axis goes through the upper left corner, and only a quarter of the scene is left.",
        evidence: &[],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            corner: 0.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "corner-not-halved",
        chapters: RAYS,
        wrong: "… - viewport_u - viewport_v",
        right: "… - viewport_u / 2 - viewport_v / 2",
        explanation: "With whole edges the axis goes through the lower right corner, and only a quarter of the scene is left.",
        evidence: &[],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            corner: 1.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "focal-length-added",
        chapters: RAYS,
        wrong: "viewport_upper_left = center + (0, 0, focal_length) - …",
        right: "viewport_upper_left = center - (0, 0, focal_length) - …",
        explanation: "The camera looks along the negative z axis. With a plus it looks the other way, where nothing is.",
        evidence: &["#1578"],
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            focal_length: -1.0,
            ..right
        },
        unseen: &[(
            GRADIENT,
            Unseen::Equivalent(
                "Only the sign of z changes, and the sky depends on y and the length of the direction.",
            ),
        )],
    },
    Slip {
        name: "focal-length-forgotten",
        chapters: RAYS,
        wrong: "viewport_upper_left = center - viewport_u / 2 - viewport_v / 2",
        right: "viewport_upper_left = center - (0, 0, focal_length) - …",
        explanation: "The eye lies in the plane of the viewport, and every ray stays in it.",
        evidence: &[],
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            focal_length: 0.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "focal-length-two",
        chapters: RAYS,
        wrong: "focal_length = 2",
        right: "focal_length = 1",
        explanation: "Twice as far from the viewport, the eye sees half of the angle: everything is twice as large.",
        evidence: &[],
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            focal_length: 2.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "viewport-height-one",
        chapters: RAYS,
        wrong: "viewport_height = 1",
        right: "viewport_height = 2",
        explanation: "Through half a viewport everything is twice as large, as with a focal length of 2.",
        evidence: &[],
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_height: 1.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "integer-aspect-ratio",
        chapters: RAYS,
        wrong: "int aspect_ratio = 16 / 9",
        right: "double aspect_ratio = 16.0 / 9.0",
        explanation: "Two integers divide to an integer, 1: the picture is a square.",
        evidence: &["#952"],
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            aspect_ratio: 1.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "inverted-aspect-ratio",
        chapters: RAYS,
        wrong: "image_height = image_width * aspect_ratio",
        right: "image_height = image_width / aspect_ratio",
        explanation: "A ratio of width to height divides the width. Multiplied, the picture is higher than wide.",
        evidence: &[],
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            image_height: |width, aspect_ratio| (width * aspect_ratio) as u32,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "height-rounded",
        chapters: RAYS,
        wrong: "image_height = round(image_width / aspect_ratio)",
        right: "image_height = int(image_width / aspect_ratio)",
        explanation: "The height is cut off, not rounded: at half of all widths the picture has a row too many.",
        evidence: &[],
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            image_height: |width, aspect_ratio| ((width / aspect_ratio).round() as u32).max(1),
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "height-may-be-zero",
        chapters: RAYS,
        wrong: "image_height = int(image_width / aspect_ratio)",
        right: "… and image_height = (image_height < 1) ? 1 : image_height",
        explanation: "A picture one pixel wide is cut off to no row at all.",
        evidence: &[],
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            image_height: |width, aspect_ratio| (width / aspect_ratio) as u32,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "ideal-viewport-ratio",
        chapters: RAYS,
        wrong: "viewport_width = viewport_height * aspect_ratio",
        right: "viewport_width = viewport_height * (double(image_width) / image_height)",
        explanation: "The height was cut off, so the picture's own ratio is not 16:9. At 400 wide it happens to be.",
        evidence: &["#527", "#1246", "#1342", "#1486"],
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_ratio: |_, _, aspect_ratio| aspect_ratio,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "integer-viewport-ratio",
        chapters: RAYS,
        wrong: "viewport_width = viewport_height * (image_width / image_height)",
        right: "viewport_width = viewport_height * (double(image_width) / image_height)",
        explanation: "Two integers divide to an integer, 1: the viewport is a square, and the sphere an ellipse.",
        evidence: &[],
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_ratio: |width, height, _| (width / height).floor(),
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "inverted-viewport-ratio",
        chapters: RAYS,
        wrong: "viewport_width = viewport_height * (double(image_height) / image_width)",
        right: "viewport_width = viewport_height * (double(image_width) / image_height)",
        explanation: "The viewport is higher than wide while the picture is wider than high: the sphere becomes an ellipse.",
        evidence: &["PR #487", "#527", "#536"],
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_ratio: |width, height, _| height / width,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "pixel-deltas-swapped",
        chapters: RAYS,
        wrong: "pixel_delta_u = viewport_u / image_height, pixel_delta_v = viewport_v / image_width",
        right: "pixel_delta_u = viewport_u / image_width, pixel_delta_v = viewport_v / image_height",
        explanation: "Each edge is divided by the pixels along the other one: stretched sideways, squeezed upwards.",
        evidence: &[],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            pixel_deltas: |u, v, width, height| [u * (1.0 / height), v * (1.0 / width)],
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "column-and-row-swapped",
        chapters: RAYS,
        wrong: "pixel00 + j * pixel_delta_u + i * pixel_delta_v",
        right: "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
        explanation: "Column i goes to the right and row j down. Swapped, the picture is transposed and runs out of the viewport.",
        evidence: &[],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            ray: |camera, i, j| camera.ray(j, i),
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "pixel-center-as-direction",
        chapters: RAYS,
        wrong: "ray_direction = pixel_center",
        right: "ray_direction = pixel_center - camera_center",
        explanation: "A direction is a difference of two points. It shows as soon as the camera leaves the origin.",
        evidence: &[],
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            ray: |camera, i, j| {
                let ray = camera.ray(i, j);
                Ray::new(ray.origin, ray.origin + ray.direction)
            },
            ..right
        },
        unseen: &[(
            RAYS,
            Unseen::Equivalent("The camera is at the origin, and x - 0 is x."),
        )],
    },
    Slip {
        name: "ray-normalized",
        chapters: RAYS,
        wrong: "ray(center, unit_vector(pixel_center - center))",
        right: "ray(center, pixel_center - center)",
        explanation: "The same lines, so the same picture; but t is now a distance, and no longer 1 on the viewport.",
        evidence: &[],
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            ray: |camera, i, j| {
                let ray = camera.ray(i, j);
                Ray::new(ray.origin, ray.direction.normalize())
            },
            ..right
        },
        unseen: &[(
            RAYS,
            Unseen::OnlyByLaw("A ray meets the viewport at t = 1."),
        )],
    },
    Slip {
        name: "direction-not-normalized",
        chapters: RAYS,
        wrong: "a = 0.5 * (r.direction().y() + 1)",
        right: "a = 0.5 * (unit_vector(r.direction()).y() + 1)",
        explanation: "The blend is made for unit directions. Without that every row has one color, and the lowest is almost pure white.",
        evidence: &["#306", "PR #308", "#1652"],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |_, direction| 0.5 * (direction.y + 1.0),
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "divided-by-length-squared",
        chapters: RAYS,
        wrong: "unit_vector(v) = v / v.length_squared()",
        right: "unit_vector(v) = v / v.length()",
        explanation: "A unit vector is v divided by its length. Divided by its square, long vectors become too short and short ones too long.",
        evidence: &[],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            unit: |v| v * (1.0 / v.length_squared()),
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "length-with-swapped-letter",
        chapters: RAYS,
        wrong: "e[0]*e[0] + e[1]*e[1] + e[1]*e[1]",
        right: "e[0]*e[0] + e[1]*e[1] + e[2]*e[2]",
        explanation: "One component counts twice, one never: each length is wrong, and with it each unit vector.",
        evidence: &[],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            unit: |v| v * (1.0 / swapped_length_squared(v).sqrt()),
            squared: match right.chapter {
                Chapter::HalfBSphere | Chapter::HittableList => |_, v| swapped_length_squared(v),
                _ => right.squared,
            },
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "blend-not-mapped",
        chapters: RAYS,
        wrong: "a = unit_direction.y()",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "y runs from -1 to 1, a weight from 0 to 1. Below the horizon the weight is negative, and white exceeds 1.",
        evidence: &[],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| (program.unit)(direction).y,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "blend-not-halved",
        chapters: RAYS,
        wrong: "a = unit_direction.y() + 1",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "y + 1 runs from 0 to 2. Above the horizon the weight exceeds 1, and the sky is too blue.",
        evidence: &[],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| (program.unit)(direction).y + 1.0,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "blend-along-x",
        chapters: RAYS,
        wrong: "a = 0.5 * (unit_direction.x() + 1)",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "x points to the right, so the gradient runs from left to right.",
        evidence: &[],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| 0.5 * ((program.unit)(direction).x + 1.0),
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "blend-along-z",
        chapters: RAYS,
        wrong: "a = 0.5 * (unit_direction.z() + 1)",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "z points to the viewer, so the gradient is a ring around the middle.",
        evidence: &[],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| 0.5 * ((program.unit)(direction).z + 1.0),
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "white-and-blue-swapped",
        chapters: RAYS,
        wrong: "(1 - a) * blue + a * white",
        right: "(1 - a) * white + a * blue",
        explanation: "a is 1 at the top, where the sky is blue. Swapped, the sky is upside down and the sphere is not.",
        evidence: &["#879"],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            lerp: |a| a * WHITE + (1.0 - a) * BLUE,
            ..right
        },
        unseen: &[],
    },
    Slip {
        name: "white-in-full",
        chapters: RAYS,
        wrong: "white + a * blue",
        right: "(1 - a) * white + a * blue",
        explanation: "The two weights add up to 1. Without the first one, everything is brighter than white.",
        evidence: &[],
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            lerp: |a| WHITE + a * BLUE,
            ..right
        },
        unseen: &[],
    },
];

fn swapped_length_squared(v: Vec3) -> f64 {
    v.x * v.x + v.y * v.y + v.y * v.y
}
