//! Slips in the camera and in the sky.

use common::rtweekend::*;

use super::chapters::{GRADIENT, RAYS, SPHERES};
use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::letters::Letters;
use crate::program::Program;
use crate::slip::{Place, SIZES, Slip, Words, slip};

const SKY: Place = Place {
    page: "gradient#the-color-of-the-sky",
    source: "chapters/1_gradient/src/lib.rs",
};
const GRID: Place = Place {
    page: "gradient#the-grid-of-pixels",
    source: "common/src/camera.rs",
};
const QUOTIENT: Place = Place {
    page: "gradient#the-grid-of-pixels",
    source: "common/src/vec3.rs",
};
const LENGTH: Place = Place {
    page: SKY.page,
    source: "common/src/vec3.rs",
};
const SUM: Place = Place {
    page: "gradient#a-ray-is-a-function",
    source: "common/src/vec3.rs",
};
const CAMERA: Place = Place {
    page: "gradient#the-camera",
    source: "common/src/camera.rs",
};
const SIZE: Place = Place {
    page: SIZES,
    source: "common/src/camera.rs",
};

pub(super) const SLIPS: &[Slip] = &[
    slip("viewport-upside-down", RAYS, GRID)
        .says(Words {
            wrong: "viewport_v = (0, viewport_height, 0)",
            right: "viewport_v = (0, -viewport_height, 0)",
            why: "Rows run downwards while y points up, so the edge from top to bottom is \
                  negative. The picture stands on its head.",
        })
        .before_4(Words {
            wrong: "vertical = (0, -viewport_height, 0)",
            right: "vertical = (0, viewport_height, 0)",
            why: "Rows are counted from below, so the edge from the lower left corner points up. \
                  The picture stands on its head.",
        })
        .in_rust(
            RAYS,
            "viewport_v = Vec3::new(0.0, viewport_height, 0.0)",
            "viewport_v = Vec3::new(0.0, -viewport_height, 0.0)",
        )
        .reported(&["#879", "#1076", "#1579"])
        .alters(|p| {
            p.viewport_v = match p.edition.counts_from_below() {
                true => |_, height| Vec3::new(0.0, -height, 0.0),
                false => |_, height| Vec3::new(0.0, height, 0.0),
            }
        }),
    slip("viewport-mirrored", RAYS, GRID)
        .says(Words {
            wrong: "viewport_u = (-viewport_width, 0, 0)",
            right: "viewport_u = (viewport_width, 0, 0)",
            why: "Left and right change places. The sky and a disc in the middle don't show it, \
                  the colors of normals do.",
        })
        .before_4(Words {
            wrong: "horizontal = (-viewport_width, 0, 0)",
            right: "horizontal = (viewport_width, 0, 0)",
            why: "Left and right change places. The sky and a disc in the middle don't show it, \
                  the colors of normals do.",
        })
        .in_rust(
            RAYS,
            "viewport_u = Vec3::new(-viewport_width, 0.0, 0.0)",
            "viewport_u = Vec3::new(viewport_width, 0.0, 0.0)",
        )
        .alters(|p| p.viewport_u = |width, _| Vec3::new(-width, 0.0, 0.0))
        .equivalent(
            GRADIENT,
            "Only the sign of x changes, and the sky depends on y and the length of the \
                 direction.",
        ),
    slip("grid-not-inset", RAYS, GRID)
        .says(Words {
            wrong: "pixel00 = viewport_upper_left",
            right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
            why: "A pixel is sampled in its middle. At its corner, everything moves by half a \
                  pixel.",
        })
        .in_rust(
            RAYS,
            "pixel00 = viewport_upper_left;",
            "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v);",
        )
        .reported(&["#923", "PR #1158"])
        .alters(|p| p.inset = [0.0, 0.0]),
    slip("inset-upwards", RAYS, GRID)
        .says(Words {
            wrong: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u - pixel_delta_v)",
            right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
            why: "pixel_delta_v points down already. With a minus the first row lies above the \
                  viewport, and everything is a pixel lower.",
        })
        .in_rust(
            RAYS,
            "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u - pixel_delta_v)",
            "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        )
        .alters(|p| p.inset = [0.5, -0.5]),
    slip("inset-to-the-left", RAYS, GRID)
        .says(Words {
            wrong: "pixel00 = viewport_upper_left - 0.5 * (pixel_delta_u - pixel_delta_v)",
            right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
            why: "The first column lies left of the viewport, and everything is a pixel farther to \
                  the right.",
        })
        .in_rust(
            RAYS,
            "pixel00 = viewport_upper_left - 0.5 * (pixel_delta_u - pixel_delta_v)",
            "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        )
        .alters(|p| p.inset = [-0.5, 0.5]),
    slip("inset-whole-pixel", RAYS, GRID)
        .says(Words {
            wrong: "pixel00 = viewport_upper_left + pixel_delta_u + pixel_delta_v",
            right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
            why: "The middle of the first pixel is half a pixel from the corner, to the right \
                  and down. A whole pixel in, everything moves by half a pixel.",
        })
        .in_rust(
            RAYS,
            "pixel00 = viewport_upper_left + pixel_delta_u + pixel_delta_v",
            "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        )
        .alters(|p| p.inset = [1.0, 1.0]),
    slip("inset-whole-down", RAYS, GRID)
        .says(Words {
            wrong: "pixel00 = viewport_upper_left + 0.5 * pixel_delta_u + pixel_delta_v",
            right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
            why: "Only one of the two is halved, so everything moves by half a pixel up.",
        })
        .in_rust(
            RAYS,
            "pixel00 = viewport_upper_left + 0.5 * pixel_delta_u + pixel_delta_v",
            "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        )
        .alters(|p| p.inset = [0.5, 1.0]),
    slip("inset-whole-to-the-right", RAYS, GRID)
        .says(Words {
            wrong: "pixel00 = viewport_upper_left + pixel_delta_u + 0.5 * pixel_delta_v",
            right: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
            why: "Only one of the two is halved, so everything moves by half a pixel to the left.",
        })
        .in_rust(
            RAYS,
            "pixel00 = viewport_upper_left + pixel_delta_u + 0.5 * pixel_delta_v",
            "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
        )
        .alters(|p| p.inset = [1.0, 0.5]),
    slip("older-camera", RAYS, GRID)
        .says(Words {
            wrong: "u = i / (image_width - 1), v = j / (image_height - 1)",
            right: "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
            why: "The camera of older editions puts the first and last pixels on the edges of the \
                  viewport: nearly right, but edges differ.",
        })
        .in_rust(
            RAYS,
            "u = f64::from(i) / f64::from(image_width - 1)",
            "self.pixel00 + f64::from(i) * self.pixel_delta_u + f64::from(j) * self.pixel_delta_v",
        )
        .alters(|p| {
            p.divisors = |width, height| [width - 1.0, height - 1.0];
            p.inset = [0.0, 0.0];
        }),
    slip("deltas-from-last-pixel", RAYS, GRID)
        .says(Words {
            wrong: "pixel_delta_u = viewport_u / (image_width - 1), pixel_delta_v = viewport_v / \
                    (image_height - 1)",
            right: "pixel_delta_u = viewport_u / image_width, pixel_delta_v = viewport_v / \
                    image_height",
            why: "The viewport holds image_width whole pixels. With one less, each is a little \
                  too wide, and the last one lies half outside.",
        })
        .before_4(Words {
            wrong: "u = (i + 0.5) / …, v = (j + 0.5) / …",
            right: "u = i / …, v = j / …",
            why: "The first ray goes through the viewport's corner, since i and j begin at 0. With \
                  half a pixel more, everything moves by half a pixel to the left and down.",
        })
        .in_rust(
            RAYS,
            "pixel_delta_u = viewport_u * (1.0 / f64::from(image_width - 1)); pixel_delta_v = \
             viewport_v * (1.0 / f64::from(image_height - 1))",
            "pixel_delta_u = viewport_u * (1.0 / f64::from(image_width)); pixel_delta_v = \
             viewport_v * (1.0 / f64::from(image_height))",
        )
        .alters(|p| match p.edition.counts_from_below() {
            true => p.ray = half_a_pixel_in,
            false => p.divisors = |width, height| [width - 1.0, height - 1.0],
        }),
    slip("viewport-not-centered", RAYS, GRID)
        .says(Words {
            wrong: "viewport_upper_left = center - (0, 0, focal_length)",
            right: "… - viewport_u / 2 - viewport_v / 2",
            why: "Without the two halves the axis goes through the upper left corner, and only a \
                  quarter of the scene is left.",
        })
        .before_4(Words {
            wrong: "lower_left_corner = origin - (0, 0, focal_length)",
            right: "lower_left_corner = origin - horizontal / 2 - vertical / 2 - (0, 0, \
                    focal_length)",
            why: "Without the two halves the axis goes through the lower left corner, and only a \
                  quarter of the scene is left.",
        })
        .in_rust(
            RAYS,
            "viewport_upper_left = center - Vec3::new(0.0, 0.0, focal_length);",
            "viewport_upper_left = center - Vec3::new(0.0, 0.0, focal_length) - 0.5 * viewport_u \
             - 0.5 * viewport_v;",
        )
        .alters(|p| p.corner = [0.0; 2]),
    slip("corner-not-halved", RAYS, GRID)
        .says(Words {
            wrong: "… - viewport_u - viewport_v",
            right: "… - viewport_u / 2 - viewport_v / 2",
            why: "With whole edges the axis goes through the lower right corner, and only a \
                  quarter of the scene is left.",
        })
        .before_4(Words {
            wrong: "lower_left_corner = origin - horizontal - vertical - …",
            right: "lower_left_corner = origin - horizontal / 2 - vertical / 2 - …",
            why: "With whole edges the axis goes through the upper right corner, and only a \
                  quarter of the scene is left.",
        })
        .in_rust(
            RAYS,
            "center - Vec3::new(0.0, 0.0, focal_length) - viewport_u - viewport_v",
            "center - Vec3::new(0.0, 0.0, focal_length) - 0.5 * viewport_u - 0.5 * viewport_v",
        )
        .alters(|p| p.corner = [1.0; 2]),
    slip("divided-with-swapped-letter", RAYS, QUOTIENT)
        .says(Words {
            wrong: "vec3(v.x / t, v.y / t, v.y / t)",
            right: "vec3(v.x / t, v.y / t, v.z / t)",
            why: "In operator/ the third component is made of the second. Half of an edge that has \
                  only y has a z as well, and no unit vector keeps its own.",
        })
        .in_rust(
            RAYS,
            "Vec3::new(self.x / t, self.y / t, self.y / t)",
            "Vec3::new(self.x / t, self.y / t, self.z / t)",
        )
        .alters(|p| {
            p.over = swapped_over;
            p.unit = |v| swapped_over(v, v.length());
        }),
    slip("sum-with-swapped-letter", RAYS, SUM)
        .says(Words {
            wrong: "vec3(u.x + v.x, u.y + v.y, u.z + u.z)",
            right: "vec3(u.x + v.x, u.y + v.y, u.z + v.z)",
            why: "In operator+ the third component is that of the first vector, twice. Three sums \
                  on the way to a pixel move the viewport from -1 to -8, and a point on a ray has \
                  no depth.",
        })
        .before_4(Words {
            wrong: "vec3(u.x + v.x, u.y + v.y, u.z + u.z)",
            right: "vec3(u.x + v.x, u.y + v.y, u.z + v.z)",
            why: "In operator+ the third component is that of the first vector, twice. Two sums on \
                  the way to a pixel move the viewport from -1 to -4, and a point on a ray has no \
                  depth.",
        })
        .in_rust(
            RAYS,
            "Vec3::new(self.x + other.x, self.y + other.y, self.z + self.z)",
            "Vec3::new(self.x + other.x, self.y + other.y, self.z + other.z)",
        )
        .alters(|p| {
            p.plus = swapped_plus;
            p.lerp = |[below, above], a| swapped_plus((1.0 - a) * below, a * above);
            p.shade = match p.chapter {
                Chapter::HittableList => |_, normal| 0.5 * swapped_plus(normal, Vec3::ONE),
                _ => p.shade,
            };
        }),
    slip("focal-length-added", RAYS, CAMERA)
        .says(Words {
            wrong: "viewport_upper_left = center + (0, 0, focal_length) - …",
            right: "viewport_upper_left = center - (0, 0, focal_length) - …",
            why: "The camera looks along the negative z axis. With a plus it looks the other way, \
                  where nothing is.",
        })
        .before_4(Words {
            wrong: "lower_left_corner = … + (0, 0, focal_length)",
            right: "lower_left_corner = … - (0, 0, focal_length)",
            why: "The camera looks along the negative z axis. With a plus it looks the other way, \
                  where nothing is.",
        })
        .in_rust(
            RAYS,
            "center + Vec3::new(0.0, 0.0, focal_length)",
            "center - Vec3::new(0.0, 0.0, focal_length)",
        )
        .reported(&["#1578"])
        .alters(|p| p.focal_length = -1.0)
        .equivalent(
            GRADIENT,
            "Only the sign of z changes, and the sky depends on y and the length of the \
                 direction.",
        ),
    slip("focal-length-forgotten", RAYS, CAMERA)
        .says(Words {
            wrong: "viewport_upper_left = center - viewport_u / 2 - viewport_v / 2",
            right: "viewport_upper_left = center - (0, 0, focal_length) - …",
            why: "The eye lies in the plane of the viewport, and every ray stays in it.",
        })
        .before_4(Words {
            wrong: "lower_left_corner = origin - horizontal / 2 - vertical / 2",
            right: "lower_left_corner = … - (0, 0, focal_length)",
            why: "The eye lies in the plane of the viewport, and every ray stays in it.",
        })
        .in_rust(
            RAYS,
            "viewport_upper_left = center - 0.5 * viewport_u - 0.5 * viewport_v",
            "viewport_upper_left = center - Vec3::new(0.0, 0.0, focal_length) - 0.5 * viewport_u \
             - 0.5 * viewport_v",
        )
        .alters(|p| p.focal_length = 0.0),
    slip("focal-length-two", RAYS, CAMERA)
        .says(Words {
            wrong: "focal_length = 2",
            right: "focal_length = 1",
            why: "Twice as far from the viewport, the eye sees less of the world: half as much of \
                  what is ahead, twice as large.",
        })
        .in_rust(RAYS, "focal_length = 2.0", "focal_length = 1.0")
        .alters(|p| p.focal_length = 2.0),
    slip("viewport-height-one", RAYS, CAMERA)
        .says(Words {
            wrong: "viewport_height = 1",
            right: "viewport_height = 2",
            why: "Through half a viewport everything is twice as large, as with a focal length of \
                  2.",
        })
        .in_rust(RAYS, "viewport_height = 1.0", "viewport_height = 2.0")
        .alters(|p| p.viewport_height = 1.0),
    slip("integer-aspect-ratio", RAYS, SIZE)
        .says(Words {
            wrong: "int aspect_ratio = 16 / 9",
            right: "double aspect_ratio = 16.0 / 9.0",
            why: "Two integers divide to an integer, 1: the picture is a square.",
        })
        .in_rust(
            RAYS,
            "aspect_ratio = f64::from(16 / 9)",
            "aspect_ratio = 16.0 / 9.0",
        )
        .in_python("aspect_ratio = 16 // 9", "aspect_ratio = 16 / 9")
        .reported(&["#952"])
        .alters(|p| p.aspect_ratio = 1.0),
    slip("inverted-aspect-ratio", RAYS, SIZE)
        .says(Words {
            wrong: "image_height = image_width * aspect_ratio",
            right: "image_height = image_width / aspect_ratio",
            why: "A ratio of width to height divides the width. Multiplied, the picture is higher \
                  than wide.",
        })
        .in_rust(
            RAYS,
            "(f64::from(image_width) * aspect_ratio) as u32",
            "(f64::from(image_width) / aspect_ratio) as u32",
        )
        .alters(|p| p.image_height = |width, aspect_ratio| (width * aspect_ratio) as u32),
    slip("height-rounded", RAYS, SIZE)
        .says(Words {
            wrong: "image_height = round(image_width / aspect_ratio)",
            right: "image_height = int(image_width / aspect_ratio)",
            why: "The height is cut off, not rounded: at half of all widths the picture has a row \
                  too many.",
        })
        .in_rust(
            RAYS,
            "(f64::from(image_width) / aspect_ratio).round() as u32",
            "(f64::from(image_width) / aspect_ratio) as u32",
        )
        .alters(|p| {
            p.image_height = |width, aspect_ratio| ((width / aspect_ratio).round() as u32).max(1);
        }),
    slip("height-may-be-zero", RAYS, SIZE)
        .says(Words {
            wrong: "image_height = int(image_width / aspect_ratio)",
            right: "… and image_height = (image_height < 1) ? 1 : image_height",
            why: "A picture one pixel wide is cut off to no row at all.",
        })
        .in_rust(
            RAYS,
            "image_height = (f64::from(image_width) / aspect_ratio) as u32",
            "image_height = ((f64::from(image_width) / aspect_ratio) as u32).max(1)",
        )
        .in_python(
            "image_height = int(image_width / aspect_ratio)",
            "image_height = max(1, int(image_width / aspect_ratio))",
        )
        .alters(|p| p.image_height = |width, aspect_ratio| (width / aspect_ratio) as u32),
    slip("ideal-viewport-ratio", RAYS, SIZE)
        .says(Words {
            wrong: "viewport_width = viewport_height * aspect_ratio",
            right: "viewport_width = viewport_height * (double(image_width) / image_height)",
            why: "The height was cut off, so the picture's own ratio is not 16:9. At 400 wide it \
                  happens to be. In a picture of quite another shape the sphere becomes an \
                  ellipse.",
        })
        .before_4(Words {
            wrong: "horizontal = (4, 0, 0), or aspect_ratio = 16.0 / 9.0, whatever the picture's \
                    size",
            right: "horizontal = (viewport_height * image_width / image_height, 0, 0)",
            why: "The picture has got another shape and the viewport has not: the sphere becomes \
                  an ellipse.",
        })
        .in_rust(
            RAYS,
            "viewport_width = viewport_height * aspect_ratio",
            "viewport_width = viewport_height * (f64::from(image_width) / f64::from(image_height))",
        )
        .reported(&["#527", "#1246", "#1342", "#1486"])
        .alters(|p| {
            p.viewport_ratio = match p.edition {
                Edition::V1 | Edition::V1InDouble | Edition::V3_0 => |_, _, _| 2.0,
                _ => |_, _, _| 16.0 / 9.0,
            }
        }),
    slip("integer-viewport-ratio", RAYS, SIZE)
        .says(Words {
            wrong: "viewport_width = viewport_height * (image_width / image_height)",
            right: "viewport_width = viewport_height * (double(image_width) / image_height)",
            why: "Two integers divide to an integer, 1: the viewport is a square, and the sphere \
                  an ellipse.",
        })
        .in_rust(
            RAYS,
            "viewport_width = viewport_height * f64::from(image_width / image_height)",
            "viewport_width = viewport_height * (f64::from(image_width) / f64::from(image_height))",
        )
        .in_python(
            "viewport_width = viewport_height * (image_width // image_height)",
            "viewport_width = viewport_height * (image_width / image_height)",
        )
        .alters(|p| p.viewport_ratio = |width, height, _| (width / height).floor()),
    slip("inverted-viewport-ratio", RAYS, SIZE)
        .says(Words {
            wrong: "viewport_width = viewport_height * (double(image_height) / image_width)",
            right: "viewport_width = viewport_height * (double(image_width) / image_height)",
            why: "The viewport is higher than wide while the picture is wider than high: the \
                  sphere becomes an ellipse.",
        })
        .in_rust(
            RAYS,
            "viewport_width = viewport_height * (f64::from(image_height) / f64::from(image_width))",
            "viewport_width = viewport_height * (f64::from(image_width) / f64::from(image_height))",
        )
        .reported(&["PR #487", "#527", "#536"])
        .alters(|p| p.viewport_ratio = |width, height, _| height / width),
    slip("integer-viewport-width", RAYS, SIZE)
        .says(Words {
            wrong: "int viewport_width = …",
            right: "double viewport_width = …",
            why: "An integer keeps 3 of the 3.56 units: everything is wider by a fifth, and the \
                  sphere is an ellipse.",
        })
        .in_python("viewport_width = int(…)", "viewport_width = …")
        .made_in(|letters| letters != Letters::Rust)
        .alters(|p| p.viewport_u = |width, _| Vec3::new(width.trunc(), 0.0, 0.0)),
    slip("viewport-width-four", RAYS, CAMERA)
        .says(Words {
            wrong: "viewport_width = 4.0",
            right: "viewport_width = viewport_height * (double(image_width)/image_height)",
            why: "Pixels are squares only if width is height × image_width / image_height. 4 × 2 \
                  fits a picture twice as wide as high; in another one a sphere is an egg.",
        })
        .before_4(Words {
            wrong: "horizontal = vec3(4.0, 0, 0)",
            right: "horizontal = vec3(aspect_ratio * viewport_height, 0, 0)",
            why: "Pixels are squares only if width is height × image_width / image_height. 4 × 2 \
                  fits a picture twice as wide as high; in another one a sphere is an egg.",
        })
        .in_rust(
            RAYS,
            "viewport_width = 4.0",
            "viewport_width = viewport_height * (f64::from(image_width) / f64::from(image_height))",
        )
        .alters(|p| p.viewport_ratio = |_, _, _| 2.0),
    slip("viewport-lengths-swapped", RAYS, GRID)
        .says(Words {
            wrong: "viewport_u = (viewport_height, 0, 0), viewport_v = (0, -viewport_width, 0)",
            right: "viewport_u = (viewport_width, 0, 0), viewport_v = (0, -viewport_height, 0)",
            why: "The viewport is higher than wide while the picture is wider than high: the \
                  sphere is a flat ellipse.",
        })
        .before_4(Words {
            wrong: "horizontal = (viewport_height, 0, 0), vertical = (0, viewport_width, 0)",
            right: "horizontal = (viewport_width, 0, 0), vertical = (0, viewport_height, 0)",
            why: "The viewport is higher than wide while the picture is wider than high: the \
                  sphere is a flat ellipse.",
        })
        .in_rust(
            RAYS,
            "viewport_u = Vec3::new(viewport_height, 0.0, 0.0); viewport_v = Vec3::new(0.0, \
             -viewport_width, 0.0)",
            "viewport_u = Vec3::new(viewport_width, 0.0, 0.0); viewport_v = Vec3::new(0.0, \
             -viewport_height, 0.0)",
        )
        .alters(|p| {
            p.viewport_u = |_, height| Vec3::new(height, 0.0, 0.0);
            p.viewport_v = match p.edition.counts_from_below() {
                true => |width, _| Vec3::new(0.0, width, 0.0),
                false => |width, _| Vec3::new(0.0, -width, 0.0),
            };
        }),
    slip("pixel-deltas-swapped", RAYS, GRID)
        .says(Words {
            wrong: "pixel_delta_u = viewport_u / image_height, pixel_delta_v = viewport_v / \
                    image_width",
            right: "pixel_delta_u = viewport_u / image_width, pixel_delta_v = viewport_v / \
                    image_height",
            why: "Each edge is divided by the pixels along the other one: stretched sideways, \
                  squeezed upwards.",
        })
        .before_4(Words {
            wrong: "u = i / (image_height - 1), v = j / (image_width - 1)",
            right: "u = i / (image_width - 1), v = j / (image_height - 1)",
            why: "Each count is divided by the pixels along the other edge: stretched sideways, \
                  squeezed upwards.",
        })
        .in_rust(
            RAYS,
            "pixel_delta_u = viewport_u * (1.0 / f64::from(image_height)); pixel_delta_v = \
             viewport_v * (1.0 / f64::from(image_width))",
            "pixel_delta_u = viewport_u * (1.0 / f64::from(image_width)); pixel_delta_v = \
             viewport_v * (1.0 / f64::from(image_height))",
        )
        .alters(|p| {
            p.divisors = match p.edition {
                Edition::V3 => |width, height| [height - 1.0, width - 1.0],
                _ => |width, height| [height, width],
            }
        }),
    slip("columns-by-height", RAYS, GRID)
        .says(Words {
            wrong: "pixel_delta_u = viewport_u / image_height",
            right: "pixel_delta_u = viewport_u / image_width",
            why: "A step to the right is too long by the ratio of the picture, and the columns run \
                  out of the viewport.",
        })
        .before_4(Words {
            wrong: "u = i / (image_height - 1)",
            right: "u = i / (image_width - 1)",
            why: "u runs from 0 to the ratio of the picture and not to 1, so the columns run out \
                  of the viewport.",
        })
        .in_rust(
            RAYS,
            "pixel_delta_u = viewport_u * (1.0 / f64::from(image_height))",
            "pixel_delta_u = viewport_u * (1.0 / f64::from(image_width))",
        )
        .alters(|p| {
            p.divisors = match p.edition {
                Edition::V3 => |_, height| [height - 1.0; 2],
                _ => |_, height| [height; 2],
            }
        }),
    slip("rows-by-width", RAYS, GRID)
        .says(Words {
            wrong: "pixel_delta_v = viewport_v / image_width",
            right: "pixel_delta_v = viewport_v / image_height",
            why: "A step down is too short, and the rows end in the middle of the viewport.",
        })
        .before_4(Words {
            wrong: "v = j / (image_width - 1)",
            right: "v = j / (image_height - 1)",
            why: "v ends far below 1, so the highest rows are missing.",
        })
        .in_rust(
            RAYS,
            "pixel_delta_v = viewport_v * (1.0 / f64::from(image_width))",
            "pixel_delta_v = viewport_v * (1.0 / f64::from(image_height))",
        )
        .alters(|p| {
            p.divisors = match p.edition {
                Edition::V3 => |width, _| [width - 1.0; 2],
                _ => |width, _| [width; 2],
            }
        }),
    slip("column-and-row-swapped", RAYS, GRID)
        .says(Words {
            wrong: "pixel00 + j * pixel_delta_u + i * pixel_delta_v",
            right: "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
            why: "Column i goes to the right and row j down. Swapped, the picture is transposed \
                  and runs out of the viewport.",
        })
        .before_4(Words {
            wrong: "u = j / (image_width - 1), v = i / (image_height - 1)",
            right: "u = i / (image_width - 1), v = j / (image_height - 1)",
            why: "Column i goes to the right and row j up. Swapped, the picture is transposed and \
                  runs out of the viewport.",
        })
        .in_rust(
            RAYS,
            "self.pixel00 + f64::from(j) * self.pixel_delta_u + f64::from(i) * self.pixel_delta_v",
            "self.pixel00 + f64::from(i) * self.pixel_delta_u + f64::from(j) * self.pixel_delta_v",
        )
        .alters(|p| {
            p.ray = |program, camera, i, j| {
                let row = program.row(j, camera);
                program.ray_of(camera, row, i.into())
            }
        }),
    slip("column-for-row", RAYS, GRID)
        .says(Words {
            wrong: "pixel00 + i * pixel_delta_u + i * pixel_delta_v",
            right: "pixel00 + i * pixel_delta_u + j * pixel_delta_v",
            why: "A copied term keeps its letter: all rows are the same, and run down the viewport as \
                  they run to the right.",
        })
        .before_4(Words {
            wrong: "v = i / (image_height - 1)",
            right: "v = j / (image_height - 1)",
            why: "A copied term keeps its letter: all rows are the same, and run up beyond the viewport \
                  as they run to the right.",
        })
        .in_rust(
            RAYS,
            "self.pixel00 + f64::from(i) * self.pixel_delta_u + f64::from(i) * self.pixel_delta_v",
            "self.pixel00 + f64::from(i) * self.pixel_delta_u + f64::from(j) * self.pixel_delta_v",
        )
        .alters(|p| p.ray = |program, camera, i, _| program.ray_of(camera, i.into(), i.into())),
    slip("pixel-center-as-direction", RAYS, CAMERA)
        .says(Words {
            wrong: "ray_direction = pixel_center",
            right: "ray_direction = pixel_center - camera_center",
            why: "A direction is a difference of two points. It shows as soon as the camera leaves \
                  the origin.",
        })
        .in_rust(
            RAYS,
            "Ray::new(self.center, pixel_center)",
            "Ray::new(self.center, pixel_center - self.center)",
        )
        .alters(|p| {
            p.ray = |program, camera, i, j| {
                let ray = program.right_ray(camera, i, j);
                Ray::new(ray.origin, ray.origin + ray.direction)
            }
        })
        .equivalent(RAYS, "The camera is at the origin, and x - 0 is x."),
    slip("ray-arguments-swapped", RAYS, CAMERA)
        .says(Words {
            wrong: "ray(pixel_center - camera_center, camera_center)",
            right: "ray(camera_center, pixel_center - camera_center)",
            why: "The origin comes first. Swapped, the direction is (0, 0, 0), which has no unit \
                  vector: no color is a number.",
        })
        .in_rust(
            RAYS,
            "Ray::new(pixel_center - self.center, self.center)",
            "Ray::new(self.center, pixel_center - self.center)",
        )
        .alters(|p| {
            p.ray = |program, camera, i, j| {
                let ray = program.right_ray(camera, i, j);
                Ray::new(ray.direction, ray.origin)
            }
        }),
    slip("ray-normalized", RAYS, CAMERA)
        .says(Words {
            wrong: "ray(center, unit_vector(pixel_center - center))",
            right: "ray(center, pixel_center - center)",
            why: "The same lines, so the same picture; but t is now a distance, and no longer 1 on \
                  the viewport.",
        })
        .in_rust(
            RAYS,
            "Ray::new(self.center, (pixel_center - self.center).normalize())",
            "Ray::new(self.center, pixel_center - self.center)",
        )
        .alters(|p| {
            p.ray = |program, camera, i, j| {
                let ray = program.right_ray(camera, i, j);
                Ray::new(ray.origin, (program.unit)(ray.direction))
            }
        })
        .only_by_law(RAYS, "A ray meets the viewport at t = 1."),
    slip("direction-not-normalized", RAYS, SKY)
        .says(Words {
            wrong: "a = 0.5 * (r.direction().y() + 1)",
            right: "a = 0.5 * (unit_vector(r.direction()).y() + 1)",
            why: "The blend is made for unit directions. Without that every row has one color, and \
                  the lowest is almost pure white.",
        })
        .in_rust(
            RAYS,
            "a = 0.5 * (ray.direction.y + 1.0)",
            "unit_direction = ray.direction.normalize(); a = 0.5 * (unit_direction.y + 1.0)",
        )
        .reported(&["#306", "PR #308", "#1652"])
        .alters(|p| p.sky_direction = |_, direction| direction),
    slip("divided-by-length-squared", RAYS, LENGTH)
        .says(Words {
            wrong: "unit_vector(v) = v / v.length_squared()",
            right: "unit_vector(v) = v / v.length()",
            why: "A unit vector is v divided by its length. Divided by its square, long vectors \
                  become too short and short ones too long.",
        })
        .in_rust(
            RAYS,
            "(1.0 / self.length_squared()) * self",
            "(1.0 / self.length()) * self",
        )
        .alters(|p| p.unit = |v| v * (1.0 / v.length_squared())),
    slip("length-with-swapped-letter", RAYS, LENGTH)
        .says(Words {
            wrong: "e[0]*e[0] + e[1]*e[1] + e[1]*e[1]",
            right: "e[0]*e[0] + e[1]*e[1] + e[2]*e[2]",
            why: "One component counts twice, one never: each length is wrong, and with it each \
                  unit vector.",
        })
        .in_rust(
            RAYS,
            "self.x * self.x + self.y * self.y + self.y * self.y",
            "self.x * self.x + self.y * self.y + self.z * self.z",
        )
        .in_python("x*x + y*y + y*y", "x*x + y*y + z*z")
        .alters(|p| {
            p.unit = |v| v * (1.0 / swapped_length_squared(v).sqrt());
            square_lengths_by(p, |_, v| swapped_length_squared(v));
        }),
    slip("length-with-a-product", RAYS, LENGTH)
        .says(Words {
            wrong: "e[0]*e[0] + e[1]*e[1] * e[2]*e[2]",
            right: "e[0]*e[0] + e[1]*e[1] + e[2]*e[2]",
            why: "With a times for the second plus, a ray's z = -1 changes nothing: its length is \
                  that of x and y alone.",
        })
        .in_rust(
            RAYS,
            "self.x * self.x + self.y * self.y * self.z * self.z",
            "self.x * self.x + self.y * self.y + self.z * self.z",
        )
        .in_python("x*x + y*y * z*z", "x*x + y*y + z*z")
        .alters(|p| {
            p.unit = |v| v * (1.0 / length_squared_with_a_product(v).sqrt());
            square_lengths_by(p, |_, v| length_squared_with_a_product(v));
        }),
    slip("blend-not-mapped", RAYS, SKY)
        .says(Words {
            wrong: "a = unit_direction.y()",
            right: "a = 0.5 * (unit_direction.y() + 1)",
            why: "y runs from -1 to 1, a weight from 0 to 1. Below the horizon the weight is \
                  negative, and white exceeds 1.",
        })
        .in_rust(
            RAYS,
            "a = unit_direction.y;",
            "a = 0.5 * (unit_direction.y + 1.0);",
        )
        .alters(|p| p.blend = |program, direction| (program.sky_direction)(program, direction).y),
    slip("blend-not-halved", RAYS, SKY)
        .says(Words {
            wrong: "a = unit_direction.y() + 1",
            right: "a = 0.5 * (unit_direction.y() + 1)",
            why: "y + 1 runs from 0 to 2. Above the horizon the weight exceeds 1, and the sky is \
                  too blue.",
        })
        .in_rust(
            RAYS,
            "a = unit_direction.y + 1.0",
            "a = 0.5 * (unit_direction.y + 1.0)",
        )
        .alters(|p| {
            p.blend = |program, direction| (program.sky_direction)(program, direction).y + 1.0;
        }),
    slip("blend-without-brackets", RAYS, SKY)
        .says(Words {
            wrong: "a = 0.5 * unit_direction.y() + 1",
            right: "a = 0.5 * (unit_direction.y() + 1)",
            why: "The half takes y alone, so the weight runs from 0.5 to 1.5: above the horizon \
                  the sky is too blue, below it as it should be above.",
        })
        .in_rust(
            RAYS,
            "a = 0.5 * unit_direction.y + 1.0",
            "a = 0.5 * (unit_direction.y + 1.0)",
        )
        .alters(|p| {
            p.blend =
                |program, direction| 0.5 * (program.sky_direction)(program, direction).y + 1.0;
        }),
    slip("blend-squared", RAYS, SKY)
        .says(Words {
            wrong: "a * a in place of a",
            right: "a = 0.5 * (unit_direction.y() + 1)",
            why: "A weight and the rest of it add up to 1 in any case, but its square is \
                  smaller: the sky turns blue too late.",
        })
        .in_rust(RAYS, "a * a", "a = 0.5 * (unit_direction.y + 1.0)")
        .alters(|p| {
            p.blend = |program, direction| {
                let y = (program.sky_direction)(program, direction).y;
                let a = 0.5 * (y + 1.0);
                a * a
            }
        }),
    slip("blend-along-x", RAYS, SKY)
        .says(Words {
            wrong: "a = 0.5 * (unit_direction.x() + 1)",
            right: "a = 0.5 * (unit_direction.y() + 1)",
            why: "x points to the right, so the gradient runs from left to right.",
        })
        .in_rust(
            RAYS,
            "a = 0.5 * (unit_direction.x + 1.0)",
            "a = 0.5 * (unit_direction.y + 1.0)",
        )
        .alters(|p| {
            p.blend =
                |program, direction| 0.5 * ((program.sky_direction)(program, direction).x + 1.0);
        }),
    slip("blend-along-z", RAYS, SKY)
        .says(Words {
            wrong: "a = 0.5 * (unit_direction.z() + 1)",
            right: "a = 0.5 * (unit_direction.y() + 1)",
            why: "z points to the viewer, so the sky is white in the middle of the picture and \
                  bluer all around.",
        })
        .in_rust(
            RAYS,
            "a = 0.5 * (unit_direction.z + 1.0)",
            "a = 0.5 * (unit_direction.y + 1.0)",
        )
        .alters(|p| {
            p.blend =
                |program, direction| 0.5 * ((program.sky_direction)(program, direction).z + 1.0);
        }),
    slip("blend-along-diagonal", RAYS, SKY)
        .says(Words {
            wrong: "a = 0.25 * (unit_direction.x() + unit_direction.y() + 2)",
            right: "a = 0.5 * (unit_direction.y() + 1)",
            why: "The sky grows bluer to the right as well as upwards.",
        })
        .in_rust(
            RAYS,
            "a = 0.25 * (unit_direction.x + unit_direction.y + 2.0)",
            "a = 0.5 * (unit_direction.y + 1.0)",
        )
        .alters(|p| {
            p.blend = |program, direction| {
                let direction = (program.sky_direction)(program, direction);
                0.25 * (direction.x + direction.y + 2.0)
            };
        }),
    slip("white-and-blue-swapped", RAYS, SKY)
        .says(Words {
            wrong: "(1 - a) * blue + a * white",
            right: "(1 - a) * white + a * blue",
            why: "a is 1 at the top, where the sky is blue. Swapped, the sky is upside down and \
                  the sphere is not.",
        })
        .in_rust(
            RAYS,
            "(1.0 - a) * blue + a * white",
            "(1.0 - a) * white + a * blue",
        )
        .reported(&["#879"])
        .alters(|p| p.lerp = |[below, above], a| a * below + (1.0 - a) * above),
    slip("white-by-the-same-weight", RAYS, SKY)
        .says(Words {
            wrong: "a * white + a * blue",
            right: "(1 - a) * white + a * blue",
            why: "The two weights add up to 1. With the same one for both, the sky is dark below \
                  and far too bright above.",
        })
        .in_rust(RAYS, "a * white + a * blue", "(1.0 - a) * white + a * blue")
        .alters(|p| p.lerp = |[below, above], a| a * below + a * above),
    slip("blue-with-exchanged-numbers", RAYS, SKY)
        .says(Words {
            wrong: "blue = (0.7, 0.5, 1)",
            right: "blue = (0.5, 0.7, 1)",
            why: "Red has less of it than green. Exchanged, the sky is violet.",
        })
        .in_rust(
            RAYS,
            "blue = Color::new(0.7, 0.5, 1.0)",
            "blue = Color::new(0.5, 0.7, 1.0)",
        )
        .alters(|p| p.sky = [Color::ONE, Color::new(0.7, 0.5, 1.0)]),
    slip("background-missing", SPHERES, SKY)
        .says(Words {
            wrong: "if (…) return color(1, 0, 0); return color(0, 0, 0)",
            right: "… return (1 - a) * white + a * blue",
            why: "What hits nothing shows the sky. Here it stays black.",
        })
        .in_rust(SPHERES, "Color::new(0.0, 0.0, 0.0)", "sky(ray)")
        .alters(|p| p.lerp = |_, _| Color::ZERO),
];

/// Chapters 4 and 5 take the square of a length by the function that is wrong.
fn square_lengths_by(p: &mut Program, squared: fn(&Program, Vec3) -> f64) {
    if matches!(p.chapter, Chapter::HalfBSphere | Chapter::HittableList) {
        p.squared = squared;
    }
}

fn swapped_length_squared(v: Vec3) -> f64 {
    v.x * v.x + v.y * v.y + v.y * v.y
}

fn length_squared_with_a_product(v: Vec3) -> f64 {
    v.x * v.x + v.y * v.y * v.z * v.z
}

fn half_a_pixel_in(p: &Program, camera: &Camera, i: u32, j: u32) -> Ray {
    p.ray_of(camera, f64::from(i) + 0.5, p.row(j, camera) + 0.5)
}

fn swapped_plus(u: Vec3, v: Vec3) -> Vec3 {
    Vec3::new(u.x + v.x, u.y + v.y, u.z + u.z)
}

fn swapped_over(v: Vec3, t: f64) -> Vec3 {
    Vec3::new(v.x, v.y, v.y) * (1.0 / t)
}
