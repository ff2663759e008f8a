//! Slips in the camera.

use super::chapters::{GRADIENT, RAYS};
use crate::slip::{SLIP, Slip};

const GRID: Slip = Slip {
    page: "gradient#the-grid-of-pixels",
    ..SLIP
};
const CAMERA: Slip = Slip {
    page: "gradient#the-camera",
    ..GRID
};
const SIZE: Slip = Slip {
    page: "gradient#how-large-is-the-picture",
    ..GRID
};
const PIXEL00: Slip = Slip {
    rust: "pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)",
    ..GRID
};
const CORNER: Slip = Slip {
    rust: "viewport_upper_left = center - Vec3::new(0.0, 0.0, focal_length) - 0.5 * viewport_u \
         - 0.5 * viewport_v",
    older: "lower_left_corner = origin - horizontal / 2 - vertical / 2 - (0, 0, focal_length)",
    ..GRID
};
const PIXEL: Slip = Slip {
    rust: "self.pixel00 + f64::from(i) * self.pixel_delta_u + f64::from(j) * self.pixel_delta_v",
    ..GRID
};
const RAY: Slip = Slip {
    rust: "Ray::new(self.center, pixel_center - self.center)",
    ..CAMERA
};
const HEIGHT: Slip = Slip {
    rust: "(f64::from(image_width) / aspect_ratio) as u32",
    cpp: "image_height = int(image_width / aspect_ratio)",
    ..SIZE
};
const RATIO: Slip = Slip {
    rust: "viewport_width = viewport_height * (f64::from(image_width) / f64::from(image_height))",
    ..SIZE
};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "viewport-upside-down",
        more: &[
            "Vec3::new(0.0, -viewport_height, 0.0)→Vec3::new(0.0, viewport_height, 0.0)",
            "Vec3::new(0.0, viewport_height, 0.0)→Vec3::new(0.0, -viewport_height, 0.0)",
        ],
        rust: "viewport_v = Vec3::new(0.0, -viewport_height, 0.0)",
        older: "vertical = (0, viewport_height, 0)",
        edits: &[
            "-viewport_height→viewport_height",
            "viewport_height→-viewport_height",
        ],
        why: "y points up, and rows are counted from above in version 4 and from below in others. \
              With the other sign the picture stands on its head.",
        reported: &["#879", "#1076", "#1579"],
        ..GRID
    },
    Slip {
        name: "viewport-mirrored",
        rust: "viewport_u = Vec3::new(viewport_width, 0.0, 0.0)",
        older: "horizontal = (viewport_width, 0, 0)",
        edits: &["(viewport_width→(-viewport_width"],
        why: "Left and right change places, which only the colors of normals show.",
        unseen_in: GRADIENT,
        equivalent: "Only the sign of x changes, and the sky has none of it.",
        ..GRID
    },
    Slip {
        name: "grid-not-inset",
        edits: &[" + 0.5 * (pixel_delta_u + pixel_delta_v)→"],
        why: "A pixel is sampled in its middle. At its corner, everything moves by half a \
              pixel.",
        reported: &["#923", "PR #1158"],
        ..PIXEL00
    },
    Slip {
        name: "inset-whole-down",
        edits: &["(pixel_delta_u + pixel_delta_v)→pixel_delta_u + pixel_delta_v"],
        why: "Only one of the two is halved, so everything moves by half a pixel up.",
        ..PIXEL00
    },
    Slip {
        name: "older-camera",
        more: &[
            "viewport_u * (1.0 / f64::from(image_width))→viewport_u * (1.0 / f64::from(image_width - 1))",
            "viewport_v * (1.0 / f64::from(image_height))→viewport_v * (1.0 / f64::from(image_height - 1))",
            " + 0.5 * (pixel_delta_u + pixel_delta_v)→",
        ],
        edits: &["→u = f64::from(i) / f64::from(image_width - 1), \
             v = f64::from(j) / f64::from(image_height - 1)"],
        why: "Older editions put the first and last pixels on the viewport's edges.",
        ..PIXEL
    },
    Slip {
        name: "deltas-from-last-pixel",
        more: &[
            "viewport_u * (1.0 / f64::from(image_width))→viewport_u * (1.0 / f64::from(image_width - 1))",
            "viewport_v * (1.0 / f64::from(image_height))→viewport_v * (1.0 / f64::from(image_height - 1))",
            "f64::from(i) / f64::from(self.image_width - 1)→(f64::from(i) + 0.5) / f64::from(self.image_width - 1)",
            "f64::from(self.image_height - 1 - j) /→(f64::from(self.image_height - 1 - j) + 0.5) /",
        ],
        rust: "pixel_delta_u = viewport_u * (1.0 / f64::from(image_width))",
        older: "u = i / …, v = j / …",
        edits: &[
            "i / …, v = j→(i + 0.5) / …, v = (j + 0.5)",
            "image_width→image_width - 1",
        ],
        why: "Then the pixels are not where they should be, by half of one at most.",
        ..GRID
    },
    Slip {
        name: "viewport-not-centered",
        edits: &[
            " - 0.5 * viewport_u - 0.5 * viewport_v→",
            " - horizontal / 2 - vertical / 2→",
        ],
        why: "Without the two halves the axis goes through a corner: a quarter is left.",
        ..CORNER
    },
    Slip {
        name: "corner-not-halved",
        edits: &[
            "0.5 * viewport_u - 0.5 * viewport_v→viewport_u - viewport_v",
            "horizontal / 2 - vertical / 2→horizontal - vertical",
        ],
        why: "With whole edges the axis goes through a corner: a quarter is left.",
        ..CORNER
    },
    Slip {
        name: "focal-length-added",
        page: CAMERA.page,
        edits: &[
            "center -→center +",
            "- (0, 0, focal_length)→+ (0, 0, focal_length)",
        ],
        why: "The camera looks along the negative z axis, and with a plus where nothing is.",
        reported: &["#1578"],
        unseen_in: GRADIENT,
        equivalent: "Only the sign of z changes, and the sky has none of it.",
        ..CORNER
    },
    Slip {
        name: "focal-length-forgotten",
        page: CAMERA.page,
        edits: &[
            " - Vec3::new(0.0, 0.0, focal_length)→",
            " - (0, 0, focal_length)→",
        ],
        why: "The eye lies in the plane of the viewport, and every ray stays in it.",
        ..CORNER
    },
    Slip {
        name: "focal-length-two",
        rust: "focal_length = 1.0",
        edits: &["1.0→2.0"],
        why: "Twice as far from the viewport, the eye sees half as much, twice as large.",
        ..CAMERA
    },
    Slip {
        name: "viewport-height-one",
        rust: "viewport_height = 2.0",
        edits: &["2.0→1.0"],
        why: "Through half a viewport everything is twice as large, as with a focal length of \
              2.",
        ..CAMERA
    },
    Slip {
        name: "integer-aspect-ratio",
        more: &["16.0 / 9.0→f64::from(16 / 9)"],
        rust: "aspect_ratio = 16.0 / 9.0",
        cpp: "double aspect_ratio = 16.0 / 9.0",
        python: "aspect_ratio = 16 / 9",
        edits: &[
            "double aspect_ratio = 16.0 / 9.0→int aspect_ratio = 16 / 9",
            "16.0 / 9.0→f64::from(16 / 9)",
            "16 / 9→16 // 9",
        ],
        why: "Two integers divide to an integer, 1: the picture is a square.",
        reported: &["#952"],
        ..SIZE
    },
    Slip {
        name: "inverted-aspect-ratio",
        edits: &["/ aspect_ratio→* aspect_ratio"],
        why: "The height is the width divided by the ratio. Multiplied, it exceeds the width.",
        ..HEIGHT
    },
    Slip {
        name: "height-rounded",
        edits: &["int(→round(", "ratio)→ratio).round()"],
        why: "The height is cut off, not rounded: at half of all widths there is a row too many.",
        ..HEIGHT
    },
    Slip {
        name: "height-may-be-zero",
        rust: "image_height = ((f64::from(image_width) / aspect_ratio) as u32).max(1)",
        cpp: "… and image_height = (image_height < 1) ? 1 : image_height",
        python: "image_height = max(1, int(image_width / aspect_ratio))",
        edits: &[
            "((f64::from(image_width) / aspect_ratio) as u32).max(1)→\
             (f64::from(image_width) / aspect_ratio) as u32",
            "→image_height = int(image_width / aspect_ratio)",
        ],
        why: "A picture one pixel wide is cut off to no row at all.",
        ..SIZE
    },
    Slip {
        name: "ideal-viewport-ratio",
        more: &["(f64::from(image_width) / f64::from(image_height))→(16.0 / 9.0)"],
        older: "horizontal = (viewport_height * image_width / image_height, 0, 0)",
        edits: &[
            "(f64::from(image_width) / f64::from(image_height))→aspect_ratio",
            "→horizontal = (4, 0, 0), or aspect_ratio = 16.0 / 9.0, whatever the picture's size",
        ],
        why: "The picture's own ratio is another one, even where its height was only cut off. At \
              400 wide it happens to be 16:9. In quite another shape the sphere becomes an ellipse.",
        reported: &["#527", "#1246", "#1342", "#1486"],
        ..RATIO
    },
    Slip {
        name: "integer-viewport-ratio",
        cpp: "viewport_width = viewport_height * (double(image_width) / image_height)",
        python: "viewport_width = viewport_height * (image_width / image_height)",
        edits: &[
            "(f64::from(image_width) / f64::from(image_height))→\
             f64::from(image_width / image_height)",
            "double(image_width)→image_width",
            "image_width /→image_width //",
        ],
        why: "Two integers divide to 1: the viewport is a square, and the sphere an ellipse.",
        ..RATIO
    },
    Slip {
        name: "inverted-viewport-ratio",
        more: &[
            "f64::from(image_width) / f64::from(image_height)→f64::from(image_height) / f64::from(image_width)",
            "viewport_height * aspect_ratio→viewport_height / aspect_ratio",
        ],
        edits: &["f64::from(image_width) / f64::from(image_height)→\
             f64::from(image_height) / f64::from(image_width)"],
        why: "The viewport is higher than wide and the picture is not: the sphere is an ellipse.",
        reported: &["PR #487", "#527", "#536"],
        ..RATIO
    },
    Slip {
        name: "viewport-width-four",
        more: &[
            "viewport_height * (f64::from(image_width) / f64::from(image_height))→4.0",
            "viewport_height * aspect_ratio→4.0",
        ],
        page: CAMERA.page,
        older: "horizontal = vec3(aspect_ratio * viewport_height, 0, 0)",
        edits: &[
            "viewport_height * (f64::from(image_width) / f64::from(image_height))→4.0",
            "aspect_ratio * viewport_height→4.0",
        ],
        why: "Pixels are squares only if width is height × image_width / image_height. 4 × 2 \
              fits a picture twice as wide as high; in another one a sphere is an egg.",
        ..RATIO
    },
    Slip {
        name: "rows-by-width",
        more: &[
            "viewport_v * (1.0 / f64::from(image_height))→viewport_v * (1.0 / f64::from(image_width))",
            "/ f64::from(self.image_height - 1)→/ f64::from(self.image_width - 1)",
        ],
        rust: "pixel_delta_v = viewport_v * (1.0 / f64::from(image_height))",
        older: "v = j / (image_height - 1)",
        edits: &["image_height→image_width"],
        why: "A step is too short, and the rows end in the middle of the viewport.",
        ..GRID
    },
    Slip {
        name: "column-and-row-swapped",
        more: &[
            "f64::from(i) * self.pixel_delta_u + f64::from(j)→f64::from(j) * self.pixel_delta_u + f64::from(i)",
            "(f64::from(i) / f64::from(self.image_width - 1)) * self.pixel_delta_u + (f64::from(self.image_height - 1 - j)→(f64::from(self.image_height - 1 - j) / f64::from(self.image_width - 1)) * self.pixel_delta_u + (f64::from(i)",
        ],
        older: "u = i / (image_width - 1), v = j / (image_height - 1)",
        edits: &[
            "f64::from(i) * self.pixel_delta_u + f64::from(j)→\
             f64::from(j) * self.pixel_delta_u + f64::from(i)",
            "i / (image_width - 1), v = j→j / (image_width - 1), v = i",
        ],
        why: "i counts to the right and j along a column. Swapped, all is transposed.",
        ..PIXEL
    },
    Slip {
        name: "ray-arguments-swapped",
        edits: &["self.center, pixel_center - self.center→\
                  pixel_center - self.center, self.center"],
        why: "Swapped, the direction is (0, 0, 0), which has no unit vector and no color.",
        ..RAY
    },
    Slip {
        name: "direction-reversed",
        cpp: "ray_direction = pixel_center - camera_center",
        edits: &[
            "pixel_center - camera_center→camera_center - pixel_center",
            "pixel_center - self.center→self.center - pixel_center",
        ],
        why: "It points from the pixel to the eye: all is seen that lies behind.",
        ..RAY
    },
    Slip {
        name: "ray-normalized",
        edits: &["pixel_center - self.center→(pixel_center - self.center).normalize()"],
        why: "The same lines, so the same picture; but t is no longer 1 on the viewport.",
        unseen_in: RAYS,
        law: "A ray meets the viewport at t = 1.",
        ..RAY
    },
];
