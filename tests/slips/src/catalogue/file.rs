//! Slips in what a file holds: the order of pixels, and numbers for colors.

use common::rtweekend::*;

use super::chapters::{BUILD_TEST, EVERY, RAYS};
use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::program::Program;
use crate::single;
use crate::slip::{Place, Slip, Words, slip};

const THE_CODE: Place = Place {
    page: "setup#the-code",
    source: "chapters/0_build_test/src/lib.rs",
};
const PIXELS: Place = Place {
    page: "setup#a-picture-is-text",
    source: "common/src/engine/picture.rs",
};
const LEVELS: Place = Place {
    page: "setup#a-picture-is-text",
    source: "common/src/color.rs",
};
const SKY: Place = Place {
    page: "gradient#the-color-of-the-sky",
    source: "chapters/1_gradient/src/lib.rs",
};
const DIGITS: Place = Place {
    page: "cpp_to_rust#small-words",
    source: "tests/suite/methods/stability.rs",
};

/// Why divisors of the build test are none of rays.
const STEPS: &str =
    "Rays of version 4 step by pixel_delta_u, which is the edge divided by image_width.";

pub(super) const SLIPS: &[Slip] = &[
    slip("integer-division", BUILD_TEST, THE_CODE)
        .says(Words {
            wrong: "r = i / (image_width - 1)",
            right: "r = double(i) / (image_width - 1)",
            why: "Two integers divide to an integer: 0 everywhere but in the last column, where it \
                  is 1.",
        })
        .in_rust(BUILD_TEST, "f64::from(i / last)", "f64::from(i) / last")
        .in_python("r = i // (image_width - 1)", "r = i / (image_width - 1)")
        .alters(|p| {
            p.color = |program, camera, i, j| {
                let row = program.row(j, camera);
                let right = program.ramp(camera, i.into(), row);
                Color::new(right.x.floor(), right.y.floor(), right.z)
            }
        }),
    slip("divided-by-size", EVERY, THE_CODE)
        .says(Words {
            wrong: "r = double(i) / image_width",
            right: "r = double(i) / (image_width - 1)",
            why: "The last column is number image_width - 1, so red stops just short of full.",
        })
        .before_4(Words {
            wrong: "double(i) / image_width, double(j) / image_height",
            right: "double(i) / (image_width - 1), double(j) / (image_height - 1)",
            why: "The last column is number image_width - 1. In version 3 it lies on the edge of \
                  the viewport, in versions 1 and 2 a pixel before it.",
        })
        .in_rust(
            BUILD_TEST,
            "last = f64::from(width)",
            "last = f64::from((width - 1).max(1))",
        )
        .in_python("r = i / image_width", "r = i / (image_width - 1)")
        .reported(&["#923"])
        .alters(|p| p.divisors = |width, height| [width, height])
        .equivalent(RAYS, STEPS),
    slip("width-plus-one", EVERY, THE_CODE)
        .says(Words {
            wrong: "r = double(i) / (image_width + 1)",
            right: "r = double(i) / (image_width - 1)",
            why: "The last column is number image_width - 1, so red stops short of full.",
        })
        .before_4(Words {
            wrong: "u = double(i) / (image_width + 1)",
            right: "u = double(i) / (image_width - 1)",
            why: "The last column is number image_width - 1. With a plus all is stretched to the \
                  right, by two columns at the end.",
        })
        .in_rust(
            BUILD_TEST,
            "f64::from(i) / f64::from(width + 1)",
            "f64::from(i) / last",
        )
        .alters(|p| {
            if has_last(p) {
                p.divisors = |width, height| [width + 1.0, height - 1.0];
            }
        })
        .equivalent(RAYS, STEPS),
    slip("height-plus-one", EVERY, THE_CODE)
        .says(Words {
            wrong: "g = double(j) / (image_height + 1)",
            right: "g = double(j) / (image_height - 1)",
            why: "The last row is number image_height - 1, so green stops short of full.",
        })
        .before_4(Words {
            wrong: "v = double(j) / (image_height + 1)",
            right: "v = double(j) / (image_height - 1)",
            why: "The last row is number image_height - 1. With a plus all is stretched upwards, \
                  by two rows at the end.",
        })
        .in_rust(
            BUILD_TEST,
            "f64::from(j) / f64::from(width + 1)",
            "f64::from(j) / last",
        )
        .alters(|p| {
            if has_last(p) {
                p.divisors = |width, height| [width - 1.0, height + 1.0];
            }
        })
        .equivalent(RAYS, STEPS),
    slip("red-and-green-swapped", BUILD_TEST, THE_CODE)
        .says(Words {
            wrong: "r = j / (width - 1), g = i / (height - 1)",
            right: "r = i / (width - 1), g = j / (height - 1)",
            why: "Columns run to the right and carry red; here they carry green. The picture is \
                  transposed.",
        })
        .in_rust(
            BUILD_TEST,
            "Color::new(f64::from(j) / last, f64::from(i) / last, 0.0)",
            "Color::new(f64::from(i) / last, f64::from(j) / last, 0.0)",
        )
        .alters(|p| {
            p.color = |program, camera, i, j| {
                let row = program.row(j, camera);
                program.ramp(camera, row, i.into())
            }
        }),
    slip("column-twice", BUILD_TEST, THE_CODE)
        .says(Words {
            wrong: "g = i / (width - 1)",
            right: "g = j / (height - 1)",
            why: "A copied term keeps its letter: green runs to the right as red does, and every \
                  row is the same.",
        })
        .in_rust(
            BUILD_TEST,
            "Color::new(f64::from(i) / last, f64::from(i) / last, 0.0)",
            "Color::new(f64::from(i) / last, f64::from(j) / last, 0.0)",
        )
        .alters(|p| {
            p.color = |program, camera, i, j| {
                let color = program.ramp(camera, i.into(), j.into());
                color.with_y(color.x)
            }
        }),
    slip("row-twice", BUILD_TEST, THE_CODE)
        .says(Words {
            wrong: "r = j / (height - 1)",
            right: "r = i / (width - 1)",
            why: "A copied term keeps its letter: red runs down as green does, and every column is \
                  the same.",
        })
        .in_rust(
            BUILD_TEST,
            "Color::new(f64::from(j) / last, f64::from(j) / last, 0.0)",
            "Color::new(f64::from(i) / last, f64::from(j) / last, 0.0)",
        )
        .alters(|p| {
            p.color = |program, camera, i, j| {
                let row = program.row(j, camera);
                let color = program.ramp(camera, i.into(), row);
                color.with_x(color.y)
            }
        }),
    slip("green-upwards", BUILD_TEST, THE_CODE)
        .says(Words {
            wrong: "g = 1 - j / (height - 1)",
            right: "g = j / (height - 1)",
            why: "Older editions count rows from below. Here row 0 is at the top, and green grows \
                  downwards.",
        })
        .before_4(Words {
            wrong: "g = 1 - j / (image_height - 1)",
            right: "g = j / (image_height - 1)",
            why: "Green grows with j, which counts rows from below.",
        })
        .in_rust(
            BUILD_TEST,
            "Color::new(f64::from(i) / last, 1.0 - f64::from(j) / last, 0.0)",
            "Color::new(f64::from(i) / last, f64::from(j) / last, 0.0)",
        )
        .reported(&["#879"])
        .alters(|p| {
            p.color = |program, camera, i, j| {
                let row = program.row(j, camera);
                let turned = f64::from(camera.image_height) - 1.0 - row;
                program.ramp(camera, i.into(), turned)
            }
        }),
    slip("quarter-blue", BUILD_TEST, THE_CODE)
        .says(Words {
            wrong: "b = 0.25",
            right: "b = 0",
            why: "Older editions put a quarter of blue into every pixel of this picture.",
        })
        .before_4(Words {
            wrong: "b = 0.25",
            right: "b = 0.2",
            why: "Versions 3.1.0 to 3 put a quarter of blue into this picture, and those before them a \
                  fifth.",
        })
        .in_rust(
            BUILD_TEST,
            "Color::new(f64::from(i) / last, f64::from(j) / last, 0.25)",
            "Color::new(f64::from(i) / last, f64::from(j) / last, 0.0)",
        )
        .reported(&["PR #1184"])
        .alters(|p| p.blue = 0.25),
    slip("columns-first", EVERY, PIXELS)
        .says(Words {
            wrong: "for i … for j … print",
            right: "for j … for i … print",
            why: "A file holds row after row. With the loops the other way round it gets column \
                  after column.",
        })
        .in_rust(
            EVERY,
            "for i in 0..image_width { for j in 0..image_height {",
            "for j in 0..image_height { for i in 0..image_width {",
        )
        .alters(|p| p.order = |n, _, height| (n / height, n % height)),
    slip("rows-from-below", EVERY, PIXELS)
        .says(Words {
            wrong: "for j = image_height - 1 down to 0",
            right: "for j = 0 up to image_height - 1",
            why: "Older editions print from the last row upwards. In this one the picture stands \
                  on its head.",
        })
        .before_4(Words {
            wrong: "for j = 0 up to image_height - 1",
            right: "for j = image_height - 1 down to 0",
            why: "Rows are counted from below, and a file begins with the highest one. Printed \
                  from row 0 on, the picture stands on its head.",
        })
        .in_rust(
            EVERY,
            "for j in (0..image_height).rev()",
            "for j in 0..image_height",
        )
        .in_python(
            "for j in range(image_height - 1, -1, -1)",
            "for j in range(image_height)",
        )
        .reported(&["PR #1051", "#766", "#879"])
        .alters(|p| p.order = |n, width, height| (n % width, height - 1 - n / width)),
    slip("loops-from-one", EVERY, PIXELS)
        .says(Words {
            wrong: "for j = 1 to image_height, for i = 1 to image_width",
            right: "for j = 0 to image_height - 1, for i = 0 to image_width - 1",
            why: "Pixels are counted from 0. Counted from 1, the picture moves by a pixel to the \
                  left and upwards.",
        })
        .before_4(Words {
            wrong: "for j = image_height down to 1, for i = 1 to image_width",
            right: "for j = image_height - 1 down to 0, for i = 0 to image_width - 1",
            why: "Pixels are counted from 0. Counted from 1, the picture moves by a pixel to the \
                  left and downwards.",
        })
        .in_rust(
            EVERY,
            "for j in 1..=image_height { for i in 1..=image_width {",
            "for j in 0..image_height { for i in 0..image_width {",
        )
        .in_python(
            "for j in range(1, image_height + 1), for i in range(1, image_width + 1)",
            "for j in range(image_height), for i in range(image_width)",
        )
        .alters(|p| match p.edition.counts_from_below() {
            true => {
                p.rows_above = 1.0;
                p.order = |n, width, _| (n % width + 1, n / width);
            }
            false => p.order = |n, width, _| (n % width + 1, n / width + 1),
        }),
    slip("rows-from-one", EVERY, PIXELS)
        .says(Words {
            wrong: "for j = 1 to image_height",
            right: "for j = 0 to image_height - 1",
            why: "Rows are counted from 0. Counted from 1, the picture moves up by a pixel.",
        })
        .before_4(Words {
            wrong: "for j = image_height down to 1",
            right: "for j = image_height - 1 down to 0",
            why: "Rows are counted from 0. Counted from 1, the picture moves down by a pixel.",
        })
        .in_rust(
            EVERY,
            "for j in 1..=image_height",
            "for j in 0..image_height",
        )
        .in_python(
            "for j in range(1, image_height + 1)",
            "for j in range(image_height)",
        )
        .alters(|p| match p.edition.counts_from_below() {
            true => p.rows_above = 1.0,
            false => p.order = |n, width, _| (n % width, n / width + 1),
        }),
    slip("header-swapped", EVERY, PIXELS)
        .says(Words {
            wrong: "print image_height, image_width",
            right: "print image_width, image_height",
            why: "The header tells the width first. Swapped, every row breaks at the wrong pixel: \
                  where columns differ the picture shears.",
        })
        .in_rust(
            EVERY,
            "P3\\n{image_height} {image_width}\\n255",
            "P3\\n{image_width} {image_height}\\n255",
        )
        .alters(|p| p.header = |width, height| (height, width))
        .equivalent(
            BUILD_TEST,
            "The picture is a square, so both numbers are the same.",
        ),
    slip("channels-reversed", EVERY, PIXELS)
        .says(Words {
            wrong: "print b, g, r",
            right: "print r, g, b",
            why: "A pixel is red, green, blue. Reversed, red and blue change places, where they are \
                  printed or in every color that is typed.",
        })
        .in_rust(EVERY, "{b} {g} {r}", "{r} {g} {b}")
        .alters(|p| p.channels = [2, 1, 0]),
    slip("green-before-red", EVERY, PIXELS)
        .says(Words {
            wrong: "print g, r, b",
            right: "print r, g, b",
            why: "A pixel is red, green, blue. Here red and green change places, where they are \
                  printed or in every color that is typed: a blue sky turns violet.",
        })
        .in_rust(EVERY, "{g} {r} {b}", "{r} {g} {b}")
        .alters(|p| p.channels = [1, 0, 2]),
    slip("blue-before-green", EVERY, PIXELS)
        .says(Words {
            wrong: "print r, b, g",
            right: "print r, g, b",
            why: "A pixel is red, green, blue. Here green and blue change places, where they are \
                  printed or in every color that is typed: a blue sky turns green.",
        })
        .in_rust(EVERY, "{r} {b} {g}", "{r} {g} {b}")
        .alters(|p| p.channels = [0, 2, 1]),
    slip("green-twice", EVERY, PIXELS)
        .says(Words {
            wrong: "print r, g, g",
            right: "print r, g, b",
            why: "A copied line keeps its old letter: green stands where blue should.",
        })
        .in_rust(EVERY, "{r} {g} {g}", "{r} {g} {b}")
        .alters(|p| p.channels = [0, 1, 1]),
    slip("red-twice", EVERY, PIXELS)
        .says(Words {
            wrong: "print r, g, r",
            right: "print r, g, b",
            why: "A copied line keeps its old letter: red stands where blue should.",
        })
        .in_rust(EVERY, "{r} {g} {r}", "{r} {g} {b}")
        .alters(|p| p.channels = [0, 1, 0]),
    slip("times-255", EVERY, LEVELS)
        .says(Words {
            wrong: "int(255 * r)",
            right: "int(255.999 * r)",
            why: "Cutting off the fraction leaves level 255 to exactly 1.0 alone, so almost all \
                  pixels are a level darker.",
        })
        .in_rust(
            EVERY,
            "(255.0 * component) as u8",
            "(255.999 * component) as u8",
        )
        .reported(&["#1249"])
        .alters(|p| p.level = |component| (255.0 * component) as i32),
    slip("times-255-99", EVERY, LEVELS)
        .says(Words {
            wrong: "int(255.99 * r)",
            right: "int(255.999 * r)",
            why: "The factor of older editions: a few pixels are a level darker.",
        })
        .in_rust(
            EVERY,
            "(255.99 * component) as u8",
            "(255.999 * component) as u8",
        )
        .alters(|p| p.level = |component| (255.99 * component) as i32),
    slip("times-256", EVERY, LEVELS)
        .says(Words {
            wrong: "int(256 * r)",
            right: "int(255.999 * r)",
            why: "A component of 1.0 becomes 256, which is no level; a language that stops at 255 \
                  shows a few pixels a level brighter.",
        })
        .in_rust(
            EVERY,
            "(256.0 * component) as u8",
            "(255.999 * component) as u8",
        )
        .reported(&["RayTracing/TheRestOfYourLife PR #5"])
        .alters(|p| p.level = |component| (256.0 * component) as i32),
    slip("times-255-clamped", EVERY, LEVELS)
        .says(Words {
            wrong: "int(255 * clamp(r, 0.000, 0.999))",
            right: "int(255.999 * r)",
            why: "Either of the two keeps 1.0 from becoming 256. With both it becomes 254, and \
                  there is no white.",
        })
        .in_rust(
            EVERY,
            "(255.0 * component.clamp(0.0, 0.999)) as u8",
            "(255.999 * component) as u8",
        )
        .alters(|p| p.level = |component| (255.0 * component.clamp(0.0, 0.999)) as i32),
    slip("rounded", EVERY, LEVELS)
        .says(Words {
            wrong: "round(255 * r)",
            right: "int(255.999 * r)",
            why: "Rounding to the nearest level is no worse, but it is another picture: half of \
                  the pixels are a level off.",
        })
        .in_rust(
            EVERY,
            "(255.0 * component).round() as u8",
            "(255.999 * component) as u8",
        )
        .alters(|p| p.level = |component| (255.0 * component).round() as i32),
    slip("rounded-255-999", EVERY, LEVELS)
        .says(Words {
            wrong: "round(255.999 * r)",
            right: "int(255.999 * r)",
            why: "The factor is made for cutting off. Rounded, 1.0 becomes 256, which is no level, \
                  and half of the others are a level brighter.",
        })
        .in_rust(
            EVERY,
            "(255.999 * component).round() as u8",
            "(255.999 * component) as u8",
        )
        .alters(|p| p.level = |component| (255.999 * component).round() as i32),
    slip("blended-as-bytes", RAYS, SKY)
        .says(Words {
            wrong: "int((1 - a) * 255) + int(a * 127)",
            right: "int(255.999 * ((1 - a) * 1.0 + a * 0.5))",
            why: "The two colors are bytes, and each term is cut off to an integer before the sum. \
                  So up to three levels are lost.",
        })
        .in_rust(
            RAYS,
            "((1.0 - a) * 255.0) as u8 + (a * 127.0) as u8",
            "(1.0 - a) * white + a * blue",
        )
        .alters(|p| {
            p.lerp = |sky, a| {
                let [below, above] = sky.map(|color| (255.0 * color).floor());
                (((1.0 - a) * below).floor() + (a * above).floor()) / 255.0
            }
        }),
    slip("terms-cut-off", RAYS, SKY)
        .says(Words {
            wrong: "int(255.999 * (1 - a)) + int(255.999 * a * 0.5)",
            right: "int(255.999 * ((1 - a) * 1.0 + a * 0.5))",
            why: "Each term is cut off to an integer before the sum, so many levels are one too \
                  low.",
        })
        .in_rust(
            RAYS,
            "(255.999 * (1.0 - a)) as u8 + (255.999 * a * 0.5) as u8",
            "(1.0 - a) * white + a * blue",
        )
        .alters(|p| {
            p.lerp = |sky, a| {
                let [below, above] = sky.map(|color| 255.999 * color);
                (((1.0 - a) * below).floor() + (a * above).floor()) / 255.0
            }
        }),
    slip("cast-too-early", EVERY, LEVELS)
        .says(Words {
            wrong: "255 * int(r)",
            right: "int(255.999 * r)",
            why: "The conversion cuts off everything below 1 before the factor can spread it: \
                  levels are 0 or 255.",
        })
        .in_rust(
            EVERY,
            "255 * component as u8",
            "(255.999 * component) as u8",
        )
        .alters(|p| p.level = |component| 255_i32.saturating_mul(component as i32)),
    slip("color-not-scaled", EVERY, LEVELS)
        .says(Words {
            wrong: "int(r)",
            right: "int(255.999 * r)",
            why: "A component runs from 0 to 1, a level from 0 to 255. Unscaled, no level is \
                  above 1, and the picture is black.",
        })
        .in_rust(EVERY, "component as u8", "(255.999 * component) as u8")
        .alters(|p| p.level = |component| component as i32),
    slip("gamma-too-early", EVERY, LEVELS)
        .says(Words {
            wrong: "int(255.999 * sqrt(r))",
            right: "int(255.999 * r)",
            why: "The square root is the gamma correction of a later chapter: everything is too \
                  bright.",
        })
        .in_rust(
            EVERY,
            "(255.999 * component.sqrt()) as u8",
            "(255.999 * component) as u8",
        )
        .alters(|p| p.level = |component| (255.999 * component.sqrt()) as i32),
    slip("single-precision", RAYS, DIGITS)
        .says(Words {
            wrong: "float",
            right: "double",
            why: "With 24 bits instead of 53, a few pixels are a level off; small far spheres come \
                  out worse.",
        })
        .in_rust(RAYS, "f32", "f64")
        .in_python("numpy.float32", "float")
        .reported(&["mitsuba-renderer/mitsuba3#512"])
        .alters(|p| {
            p.color = single::color;
            p.level = match p.edition {
                Edition::V1 | Edition::V1InDouble => p.level,
                _ => |component| (255.999_f32 * component as f32) as i32,
            };
        }),
];

/// Whether a program divides by the number of the last column or row.
fn has_last(program: &Program) -> bool {
    match program.edition {
        Edition::V1 | Edition::V1InDouble | Edition::V3_0 => false,
        Edition::V3 => true,
        Edition::V4 => program.chapter == Chapter::BuildTest,
    }
}
