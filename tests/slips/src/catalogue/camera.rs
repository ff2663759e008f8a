//! Slips in the camera and in the sky.

use common::rtweekend::*;

use super::chapters::{GRADIENT, RAYS, SPHERES};
use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::program::Program;
use crate::slip::{Slip, Unseen};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "viewport-upside-down",
        chapters: RAYS,
        wrong: "viewport_v = (0, viewport_height, 0)",
        right: "viewport_v = (0, -viewport_height, 0)",
        explanation: "Rows run downwards while y points up, so the edge from top to bottom is negative. The picture stands on its head.",
        before_4: Some([
            "vertical = (0, -viewport_height, 0)",
            "vertical = (0, viewport_height, 0)",
            "Rows are counted from below, so the edge from the lower left corner points up. The picture stands on its head.",
        ]),
        evidence: &["#879", "#1076", "#1579"],
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_v: match right.edition.counts_from_below() {
                true => |_, height| Vec3::new(0.0, -height, 0.0),
                false => |_, height| Vec3::new(0.0, height, 0.0),
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "viewport-mirrored",
        chapters: RAYS,
        wrong: "viewport_u = (-viewport_width, 0, 0)",
        right: "viewport_u = (viewport_width, 0, 0)",
        explanation: "Left and right change places. The sky and a disc in the middle don't show it, the colors of normals do.",
        before_4: Some([
            "horizontal = (-viewport_width, 0, 0)",
            "horizontal = (viewport_width, 0, 0)",
            "Left and right change places. The sky and a disc in the middle don't show it, the colors of normals do.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_u: |width, _| Vec3::new(-width, 0.0, 0.0),
            ..right
        },
        unseen: &[(
            GRADIENT,
            Unseen::Equivalent(
                "Only the sign of x changes, and the sky depends on y and the length of the direction.",
            ),
        )],
        ..Slip::USUAL
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
            inset: [0.0, 0.0],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "inset-upwards",
        chapters: RAYS,
        wrong: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u - pixel_delta_v)",
        right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        explanation: "pixel_delta_v points down already. With a minus the first row lies above the viewport, and everything is a pixel lower.",
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            inset: [0.5, -0.5],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "inset-to-the-left",
        chapters: RAYS,
        wrong: "pixel00 = viewport_upper_left - 0.5 * (pixel_delta_u - pixel_delta_v)",
        right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        explanation: "The first column lies left of the viewport, and everything is a pixel farther to the right.",
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            inset: [-0.5, 0.5],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "first-pixel-on-axis",
        chapters: RAYS,
        wrong: "pixel00 = center - (0, 0, focal_length), or … + 0.5 * (viewport_u + viewport_v)",
        right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        explanation: "Half of both edges leads to the middle of the viewport, as does leaving them out. The first pixel lies on the axis, and only a quarter of the scene is left.",
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| match right.edition {
            Edition::V4 => first_pixel_on_the_axis(right),
            _ => right,
        },
        ..Slip::USUAL
    },
    Slip {
        name: "older-camera",
        chapters: RAYS,
        wrong: "u = i / (image_width - 1), v = j / (image_height - 1)",
        right: "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
        explanation: "The camera of older editions puts the first and last pixels on the edges of the viewport: nearly right, but edges differ.",
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            divisors: |width, height| [width - 1.0, height - 1.0],
            inset: [0.0, 0.0],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "viewport-not-centered",
        chapters: RAYS,
        wrong: "viewport_upper_left = center - (0, 0, focal_length)",
        right: "… - viewport_u / 2 - viewport_v / 2",
        explanation: "Without the two halves the axis goes through the upper left corner, and only a quarter of the scene is left.",
        before_4: Some([
            "lower_left_corner = origin - (0, 0, focal_length)",
            "lower_left_corner = origin - horizontal / 2 - vertical / 2 - (0, 0, focal_length)",
            "Without the two halves the axis goes through the lower left corner, and only a quarter of the scene is left.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            corner: 0.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "corner-not-halved",
        chapters: RAYS,
        wrong: "… - viewport_u - viewport_v",
        right: "… - viewport_u / 2 - viewport_v / 2",
        explanation: "With whole edges the axis goes through the lower right corner, and only a quarter of the scene is left.",
        before_4: Some([
            "lower_left_corner = origin - horizontal - vertical - …",
            "lower_left_corner = origin - horizontal / 2 - vertical / 2 - …",
            "With whole edges the axis goes through the upper right corner, and only a quarter of the scene is left.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            corner: 1.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "division-in-place",
        chapters: RAYS,
        wrong: "vec3& operator/(double t) { e[0] /= t; …; return *this; }",
        right: "vec3 operator/(vec3 v, double t) { return (1/t) * v; }",
        explanation: "The quotient is right, but the operand is changed with it. viewport_u / image_width leaves viewport_u one pixel long, its half is half a pixel, and the first pixel lies on the axis.",
        before_4: Some([
            "vec3& operator/(double t) { e[0] /= t; …; return *this; }",
            "vec3 operator/(vec3 v, double t) { return (1/t) * v; }",
            "The quotient is right, but the operand is changed with it. horizontal / 2 halves horizontal itself: the corner is right, and the picture is the lower left quarter.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/vec3.rs",
        alter: |right| match right.edition {
            Edition::V4 => first_pixel_on_the_axis(right),
            edition if edition.divides_the_viewport() => Program {
                pixel_deltas: |_, u, v, _| [0.5 * u, 0.5 * v],
                ..right
            },
            _ => right,
        },
        ..Slip::USUAL
    },
    Slip {
        name: "divided-with-swapped-letter",
        chapters: RAYS,
        wrong: "vec3(v.x / t, v.y / t, v.y / t)",
        right: "vec3(v.x / t, v.y / t, v.z / t)",
        explanation: "In operator/ the third component is made of the second. Half of an edge that has only y has a z as well, and no unit vector keeps its own.",
        page: "gradient#the-grid-of-pixels",
        source: "common/src/vec3.rs",
        alter: |right| Program {
            over: swapped_over,
            unit: |v| swapped_over(v, v.length()),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "sum-with-swapped-letter",
        chapters: RAYS,
        wrong: "vec3(u.x + v.x, u.y + v.y, u.z + u.z)",
        right: "vec3(u.x + v.x, u.y + v.y, u.z + v.z)",
        explanation: "In operator+ the third component is that of the first vector, twice. Three sums on the way to a pixel move the viewport from -1 to -8, and a point on a ray has no depth.",
        before_4: Some([
            "vec3(u.x + v.x, u.y + v.y, u.z + u.z)",
            "vec3(u.x + v.x, u.y + v.y, u.z + v.z)",
            "In operator+ the third component is that of the first vector, twice. Two sums on the way to a pixel move the viewport from -1 to -4, and a point on a ray has no depth.",
        ]),
        page: "gradient#a-ray-is-a-function",
        source: "common/src/vec3.rs",
        alter: |right| Program {
            plus: swapped_plus,
            lerp: |[below, above], a| swapped_plus((1.0 - a) * below, a * above),
            shade: match right.chapter {
                Chapter::HittableList => |_, normal| 0.5 * swapped_plus(normal, Vec3::ONE),
                _ => right.shade,
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "focal-length-added",
        chapters: RAYS,
        wrong: "viewport_upper_left = center + (0, 0, focal_length) - …",
        right: "viewport_upper_left = center - (0, 0, focal_length) - …",
        explanation: "The camera looks along the negative z axis. With a plus it looks the other way, where nothing is.",
        before_4: Some([
            "lower_left_corner = … + (0, 0, focal_length)",
            "lower_left_corner = … - (0, 0, focal_length)",
            "The camera looks along the negative z axis. With a plus it looks the other way, where nothing is.",
        ]),
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
        before_4: Some([
            "lower_left_corner = origin - horizontal / 2 - vertical / 2",
            "lower_left_corner = … - (0, 0, focal_length)",
            "The eye lies in the plane of the viewport, and every ray stays in it.",
        ]),
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            focal_length: 0.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "focal-length-two",
        chapters: RAYS,
        wrong: "focal_length = 2",
        right: "focal_length = 1",
        explanation: "Twice as far from the viewport, the eye sees less of the world: half as much of what is ahead, twice as large.",
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            focal_length: 2.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "viewport-height-one",
        chapters: RAYS,
        wrong: "viewport_height = 1",
        right: "viewport_height = 2",
        explanation: "Through half a viewport everything is twice as large, as with a focal length of 2.",
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_height: 1.0,
            ..right
        },
        ..Slip::USUAL
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
        ..Slip::USUAL
    },
    Slip {
        name: "inverted-aspect-ratio",
        chapters: RAYS,
        wrong: "image_height = image_width * aspect_ratio",
        right: "image_height = image_width / aspect_ratio",
        explanation: "A ratio of width to height divides the width. Multiplied, the picture is higher than wide.",
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            image_height: |width, aspect_ratio| (width * aspect_ratio) as u32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "height-rounded",
        chapters: RAYS,
        wrong: "image_height = round(image_width / aspect_ratio)",
        right: "image_height = int(image_width / aspect_ratio)",
        explanation: "The height is cut off, not rounded: at half of all widths the picture has a row too many.",
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            image_height: |width, aspect_ratio| ((width / aspect_ratio).round() as u32).max(1),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "height-may-be-zero",
        chapters: RAYS,
        wrong: "image_height = int(image_width / aspect_ratio)",
        right: "… and image_height = (image_height < 1) ? 1 : image_height",
        explanation: "A picture one pixel wide is cut off to no row at all.",
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            image_height: |width, aspect_ratio| (width / aspect_ratio) as u32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "ideal-viewport-ratio",
        chapters: RAYS,
        wrong: "viewport_width = viewport_height * aspect_ratio",
        right: "viewport_width = viewport_height * (double(image_width) / image_height)",
        explanation: "The height was cut off, so the picture's own ratio is not 16:9. At 400 wide it happens to be. In a picture of quite another shape the sphere becomes an ellipse.",
        before_4: Some([
            "horizontal = (4, 0, 0), or aspect_ratio = 16.0 / 9.0, whatever the picture's size",
            "horizontal = (viewport_height * image_width / image_height, 0, 0)",
            "The picture has got another shape and the viewport has not: the sphere becomes an ellipse.",
        ]),
        evidence: &["#527", "#1246", "#1342", "#1486"],
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_ratio: match right.edition {
                Edition::V1 | Edition::V1InDouble | Edition::V3_0 => |_, _, _| 2.0,
                _ => |_, _, _| 16.0 / 9.0,
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "integer-viewport-ratio",
        chapters: RAYS,
        wrong: "viewport_width = viewport_height * (image_width / image_height)",
        right: "viewport_width = viewport_height * (double(image_width) / image_height)",
        explanation: "Two integers divide to an integer, 1: the viewport is a square, and the sphere an ellipse.",
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_ratio: |width, height, _| (width / height).floor(),
            ..right
        },
        ..Slip::USUAL
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
        ..Slip::USUAL
    },
    Slip {
        name: "integer-viewport-width",
        chapters: RAYS,
        wrong: "int viewport_width = …",
        right: "double viewport_width = …",
        explanation: "An integer keeps 3 of the 3.56 units: everything is wider by a fifth, and the sphere is an ellipse.",
        page: "gradient#how-large-is-the-picture",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_u: |width, _| Vec3::new(width.trunc(), 0.0, 0.0),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "viewport-lengths-swapped",
        chapters: RAYS,
        wrong: "viewport_u = (viewport_height, 0, 0), viewport_v = (0, -viewport_width, 0)",
        right: "viewport_u = (viewport_width, 0, 0), viewport_v = (0, -viewport_height, 0)",
        explanation: "The viewport is higher than wide while the picture is wider than high: the sphere is a flat ellipse.",
        before_4: Some([
            "horizontal = (viewport_height, 0, 0), vertical = (0, viewport_width, 0)",
            "horizontal = (viewport_width, 0, 0), vertical = (0, viewport_height, 0)",
            "The viewport is higher than wide while the picture is wider than high: the sphere is a flat ellipse.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            viewport_u: |_, height| Vec3::new(height, 0.0, 0.0),
            viewport_v: match right.edition.counts_from_below() {
                true => |width, _| Vec3::new(0.0, width, 0.0),
                false => |width, _| Vec3::new(0.0, -width, 0.0),
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "pixel-deltas-swapped",
        chapters: RAYS,
        wrong: "pixel_delta_u = viewport_u / image_height, pixel_delta_v = viewport_v / image_width",
        right: "pixel_delta_u = viewport_u / image_width, pixel_delta_v = viewport_v / image_height",
        explanation: "Each edge is divided by the pixels along the other one: stretched sideways, squeezed upwards.",
        before_4: Some([
            "u = i / (image_height - 1), v = j / (image_width - 1)",
            "u = i / (image_width - 1), v = j / (image_height - 1)",
            "Each count is divided by the pixels along the other edge: stretched sideways, squeezed upwards.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            divisors: match right.edition {
                Edition::V3 | Edition::V3_1_0 => |width, height| [height - 1.0, width - 1.0],
                _ => |width, height| [height, width],
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "columns-by-height",
        chapters: RAYS,
        wrong: "pixel_delta_u = viewport_u / image_height",
        right: "pixel_delta_u = viewport_u / image_width",
        explanation: "A step to the right is too long by the ratio of the picture, and the columns run out of the viewport.",
        before_4: Some([
            "u = i / (image_height - 1)",
            "u = i / (image_width - 1)",
            "u runs from 0 to the ratio of the picture and not to 1, so the columns run out of the viewport.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            divisors: match right.edition {
                Edition::V3 | Edition::V3_1_0 => |_, height| [height - 1.0; 2],
                _ => |_, height| [height; 2],
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "rows-by-width",
        chapters: RAYS,
        wrong: "pixel_delta_v = viewport_v / image_width",
        right: "pixel_delta_v = viewport_v / image_height",
        explanation: "A step down is too short, and the rows end in the middle of the viewport.",
        before_4: Some([
            "v = j / (image_width - 1)",
            "v = j / (image_height - 1)",
            "v ends far below 1, so the highest rows are missing.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            divisors: match right.edition {
                Edition::V3 | Edition::V3_1_0 => |width, _| [width - 1.0; 2],
                _ => |width, _| [width; 2],
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "column-and-row-swapped",
        chapters: RAYS,
        wrong: "pixel00 + j * pixel_delta_u + i * pixel_delta_v",
        right: "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
        explanation: "Column i goes to the right and row j down. Swapped, the picture is transposed and runs out of the viewport.",
        before_4: Some([
            "u = j / (image_width - 1), v = i / (image_height - 1)",
            "u = i / (image_width - 1), v = j / (image_height - 1)",
            "Column i goes to the right and row j up. Swapped, the picture is transposed and runs out of the viewport.",
        ]),
        page: "gradient#the-grid-of-pixels",
        source: "common/src/camera.rs",
        alter: |right| Program {
            ray: |program, camera, i, j| {
                let row = program.edition.row(j, camera.image_height);
                program.edition.ray(program, camera, row, i.into())
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "pixel-center-as-direction",
        chapters: RAYS,
        wrong: "ray_direction = pixel_center",
        right: "ray_direction = pixel_center - camera_center",
        explanation: "A direction is a difference of two points. It shows as soon as the camera leaves the origin.",
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            ray: |program, camera, i, j| {
                let ray = program.right_ray(camera, i, j);
                Ray::new(ray.origin, ray.origin + ray.direction)
            },
            ..right
        },
        unseen: &[(
            RAYS,
            Unseen::Equivalent("The camera is at the origin, and x - 0 is x."),
        )],
        ..Slip::USUAL
    },
    Slip {
        name: "ray-normalized",
        chapters: RAYS,
        wrong: "ray(center, unit_vector(pixel_center - center))",
        right: "ray(center, pixel_center - center)",
        explanation: "The same lines, so the same picture; but t is now a distance, and no longer 1 on the viewport.",
        page: "gradient#the-camera",
        source: "common/src/camera.rs",
        alter: |right| Program {
            ray: |program, camera, i, j| {
                let ray = program.right_ray(camera, i, j);
                Ray::new(ray.origin, (program.unit)(ray.direction))
            },
            ..right
        },
        unseen: &[(
            RAYS,
            Unseen::OnlyByLaw("A ray meets the viewport at t = 1."),
        )],
        ..Slip::USUAL
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
            sky_direction: |_, direction| direction,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "divided-by-length-squared",
        chapters: RAYS,
        wrong: "unit_vector(v) = v / v.length_squared()",
        right: "unit_vector(v) = v / v.length()",
        explanation: "A unit vector is v divided by its length. Divided by its square, long vectors become too short and short ones too long.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            unit: |v| v * (1.0 / v.length_squared()),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "length-with-swapped-letter",
        chapters: RAYS,
        wrong: "e[0]*e[0] + e[1]*e[1] + e[1]*e[1]",
        right: "e[0]*e[0] + e[1]*e[1] + e[2]*e[2]",
        explanation: "One component counts twice, one never: each length is wrong, and with it each unit vector.",
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
        ..Slip::USUAL
    },
    Slip {
        name: "blend-not-mapped",
        chapters: RAYS,
        wrong: "a = unit_direction.y()",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "y runs from -1 to 1, a weight from 0 to 1. Below the horizon the weight is negative, and white exceeds 1.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| (program.sky_direction)(program, direction).y,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "blend-not-halved",
        chapters: RAYS,
        wrong: "a = unit_direction.y() + 1",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "y + 1 runs from 0 to 2. Above the horizon the weight exceeds 1, and the sky is too blue.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| (program.sky_direction)(program, direction).y + 1.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "blend-without-brackets",
        chapters: RAYS,
        wrong: "a = 0.5 * unit_direction.y() + 1",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "The half takes y alone, so the weight runs from 0.5 to 1.5: above the horizon the sky is too blue, below it as it should be above.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| 0.5 * (program.sky_direction)(program, direction).y + 1.0,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "blend-along-x",
        chapters: RAYS,
        wrong: "a = 0.5 * (unit_direction.x() + 1)",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "x points to the right, so the gradient runs from left to right.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| 0.5 * ((program.sky_direction)(program, direction).x + 1.0),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "blend-along-z",
        chapters: RAYS,
        wrong: "a = 0.5 * (unit_direction.z() + 1)",
        right: "a = 0.5 * (unit_direction.y() + 1)",
        explanation: "z points to the viewer, so the sky is white in the middle of the picture and bluer all around.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            blend: |program, direction| 0.5 * ((program.sky_direction)(program, direction).z + 1.0),
            ..right
        },
        ..Slip::USUAL
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
            lerp: |[below, above], a| a * below + (1.0 - a) * above,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "white-in-full",
        chapters: RAYS,
        wrong: "white + a * blue",
        right: "(1 - a) * white + a * blue",
        explanation: "The two weights add up to 1. Without the first one, everything is brighter than white.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            lerp: |[below, above], a| below + a * above,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "white-by-the-same-weight",
        chapters: RAYS,
        wrong: "a * white + a * blue",
        right: "(1 - a) * white + a * blue",
        explanation: "The two weights add up to 1. With the same one for both, the sky is dark below and far too bright above.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            lerp: |[below, above], a| a * below + a * above,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "background-missing",
        chapters: SPHERES,
        wrong: "if (…) return color(1, 0, 0); return color(0, 0, 0)",
        right: "… return (1 - a) * white + a * blue",
        explanation: "What hits nothing shows the sky. Here it stays black.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            lerp: |_, _| Color::ZERO,
            ..right
        },
        ..Slip::USUAL
    },
];

fn swapped_length_squared(v: Vec3) -> f64 {
    v.x * v.x + v.y * v.y + v.y * v.y
}

fn swapped_plus(u: Vec3, v: Vec3) -> Vec3 {
    Vec3::new(u.x + v.x, u.y + v.y, u.z + u.z)
}

fn swapped_over(v: Vec3, t: f64) -> Vec3 {
    Vec3::new(v.x, v.y, v.y) * (1.0 / t)
}

/// The grid begins where the middle of the picture should be.
fn first_pixel_on_the_axis(right: Program) -> Program {
    Program {
        corner: 0.0,
        inset: [0.0, 0.0],
        ..right
    }
}
