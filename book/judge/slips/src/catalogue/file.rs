//! Slips in what a file holds: the order of pixels, and numbers for colors.

use super::chapters::{BUILD_TEST, RAYS};
use crate::slip::{SLIP, Slip};

const THE_CODE: Slip = Slip {
    page: "setup#the-code",
    ..SLIP
};
const COLOR: Slip = Slip {
    rust: "Color::new(f64::from(i) / last, f64::from(j) / last, 0.0)",
    ..THE_CODE
};
const PIXELS: Slip = Slip {
    page: "setup#a-picture-is-text",
    ..SLIP
};
const LOOPS: Slip = Slip {
    rust: "for j in 0..image_height { for i in 0..image_width {",
    ..PIXELS
};
const CHANNELS: Slip = Slip {
    rust: "{r} {g} {b}",
    cpp: "print r, g, b",
    ..PIXELS
};
const LEVELS: Slip = Slip {
    rust: "(255.999 * component) as u8",
    ..PIXELS
};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "integer-division",
        more: &[
            "last = f64::from((width - 1).max(1))→last = (width - 1).max(1)",
            "f64::from(i) / last→f64::from(i / last)",
            "f64::from(j) / last→f64::from(j / last)",
            "f64::from(i) / f64::from(width - 1)→f64::from(i / (width - 1))",
            "f64::from(width - 1 - j) / f64::from(width - 1)→f64::from((width - 1 - j) / (width - 1))",
        ],
        rust: "f64::from(i) / last",
        cpp: "r = double(i) / (image_width - 1)",
        python: "r = i / (image_width - 1)",
        edits: &[
            "f64::from(i) / last→f64::from(i / last)",
            "double(i)→i",
            "i /→i //",
        ],
        why: "Two integers divide to an integer: 0 but in the last column, where it is 1.",
        ..THE_CODE
    },
    Slip {
        name: "divided-by-size",
        more: &[
            "(width - 1).max(1)→width",
            "f64::from(self.image_width - 1)→f64::from(self.image_width)",
            "f64::from(self.image_height - 1)→f64::from(self.image_height)",
        ],
        rust: "last = f64::from((width - 1).max(1))",
        cpp: "r = double(i) / (image_width - 1)",
        python: "r = i / (image_width - 1)",
        older: "double(i) / (image_width - 1), double(j) / (image_height - 1)",
        edits: &[
            "(width - 1).max(1)→width",
            "(image_width - 1), double(j) / (image_height - 1)→\
             image_width, double(j) / image_height",
            "(image_width - 1)→image_width",
        ],
        why: "The last column is number image_width - 1, so nothing quite reaches its end.",
        reported: &["#923"],
        unseen_in: RAYS,
        equivalent: "Rays of version 4 step by pixel_delta_u, the edge divided by image_width.",
        ..THE_CODE
    },
    Slip {
        name: "red-and-green-swapped",
        more: &[
            "f64::from(i) / last, f64::from(j)→f64::from(j) / last, f64::from(i)",
            "f64::from(i) / f64::from(width - 1), f64::from(width - 1 - j)→f64::from(width - 1 - j) / f64::from(width - 1), f64::from(i)",
        ],
        cpp: "r = i / (width - 1), g = j / (height - 1)",
        edits: &[
            "f64::from(i) / last, f64::from(j)→f64::from(j) / last, f64::from(i)",
            "i / (width - 1), g = j→j / (width - 1), g = i",
        ],
        why: "Columns run to the right and carry red; here the picture is transposed.",
        ..COLOR
    },
    Slip {
        name: "green-upwards",
        more: &[
            "f64::from(j) / last→1.0 - f64::from(j) / last",
            "f64::from(width - 1 - j)→f64::from(j)",
        ],
        cpp: "g = j / (height - 1)",
        older: "g = j / (image_height - 1)",
        edits: &["f64::from(j)→1.0 - f64::from(j)", "j /→1 - j /"],
        why: "Green is to grow with j, whether rows are counted from above or from below.",
        reported: &["#879"],
        ..COLOR
    },
    Slip {
        name: "quarter-blue",
        cpp: "b = 0",
        older: "b = 0.2",
        edits: &["0.0)→0.25)", "0.2→0.25", "0→0.25"],
        why: "Versions 3.1 to 3 have a quarter of blue here, and those before them a fifth.",
        reported: &["PR #1184"],
        ..COLOR
    },
    Slip {
        name: "columns-first",
        more: &["[i, j]→[n / image_height, n - n / image_height * image_height]"],
        cpp: "for j … for i … print",
        edits: &[
            "for j … for i→for i … for j",
            "→for i in 0..image_width { for j in 0..image_height {",
        ],
        why: "A file holds row after row. With the loops exchanged it gets column after column.",
        ..LOOPS
    },
    Slip {
        name: "rows-from-below",
        more: &["[i, j]→[i, image_height - 1 - j]"],
        rust: "for j in 0..image_height",
        cpp: "for j = 0 up to image_height - 1",
        python: "for j in range(image_height)",
        older: "for j = image_height - 1 down to 0",
        edits: &[
            "0..image_height→(0..image_height).rev()",
            "0 up to image_height - 1→image_height - 1 down to 0",
            "(image_height)→(image_height - 1, -1, -1)",
            "image_height - 1 down to 0→0 up to image_height - 1",
        ],
        why: "A file begins with the highest row, and editions count rows from either end. From \
              the other one, the picture stands on its head.",
        reported: &["PR #1051", "#766", "#879"],
        ..PIXELS
    },
    Slip {
        name: "header-swapped",
        more: &["[image_width, image_height]→[image_height, image_width]"],
        rust: "P3\\n{image_width} {image_height}\\n255",
        cpp: "print image_width, image_height",
        edits: &[
            "{image_width} {image_height}→{image_height} {image_width}",
            "image_width, image_height→image_height, image_width",
        ],
        why: "The width comes first. Swapped, every row breaks at the wrong pixel.",
        unseen_in: BUILD_TEST,
        equivalent: "The picture is a square, so both numbers are the same.",
        ..PIXELS
    },
    Slip {
        name: "channels-reversed",
        more: &[
            "[level(color.x), level(color.y), level(color.z)]→[level(color.z), level(color.y), level(color.x)]",
        ],
        edits: &["{r} {g} {b}→{b} {g} {r}", "r, g, b→b, g, r"],
        why: "A pixel is red, green, blue. Reversed, red and blue change places, where they are \
              printed or in every color that is typed.",
        ..CHANNELS
    },
    Slip {
        name: "green-before-red",
        more: &[
            "[level(color.x), level(color.y), level(color.z)]→[level(color.y), level(color.x), level(color.z)]",
        ],
        edits: &["{r} {g}→{g} {r}", "r, g→g, r"],
        why: "A pixel is red, green, blue. Here red and green change places, where they are \
              printed or in every color that is typed: a blue sky turns violet.",
        ..CHANNELS
    },
    Slip {
        name: "times-255",
        edits: &["255.999→255.0"],
        why: "Only 1.0 itself gets level 255 then, and almost all pixels are a level darker.",
        reported: &["#1249"],
        ..LEVELS
    },
    Slip {
        name: "times-255-99",
        edits: &["255.999→255.99"],
        why: "The factor of older editions: a few pixels are a level darker.",
        ..LEVELS
    },
    Slip {
        name: "times-256",
        edits: &["255.999→256.0"],
        why: "1.0 becomes 256, which is no level. Cut off at 255, a few pixels are brighter.",
        reported: &["RayTracing/TheRestOfYourLife PR #5"],
        ..LEVELS
    },
    Slip {
        name: "rounded",
        edits: &["(255.999 * component)→(255.0 * component).round()"],
        why: "Rounding is no worse, but it is another picture: half of it is a level off.",
        ..LEVELS
    },
    Slip {
        name: "cast-too-early",
        edits: &["(255.999 * component)→255 * component"],
        why: "All below 1 is cut off before the factor can spread it: levels are 0 or 255.",
        ..LEVELS
    },
    Slip {
        name: "color-not-scaled",
        edits: &["(255.999 * component)→component"],
        why: "A component runs from 0 to 1, a level from 0 to 255. Unscaled, all is black.",
        ..LEVELS
    },
    Slip {
        name: "gamma-too-early",
        edits: &["component→component.sqrt()"],
        why: "The square root is the gamma correction of a later chapter: all is too bright.",
        ..LEVELS
    },
    Slip {
        name: "single-precision",
        page: "cpp_to_rust#small-words",
        rust: "f64",
        cpp: "double",
        python: "float",
        edits: &["f64→f32", "double→float", "float→numpy.float32"],
        why: "With 24 bits instead of 53, a few pixels are a level off, small far spheres more.",
        reported: &["mitsuba-renderer/mitsuba3#512"],
        ..SLIP
    },
];
