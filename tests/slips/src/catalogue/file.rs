//! Slips in what a file holds: the order of pixels, and numbers for colors.

use common::rtweekend::*;

use super::chapters::{BUILD_TEST, EVERY, GRADIENT, RAYS};
use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::program::Program;
use crate::single;
use crate::slip::{Slip, Unseen};

pub(super) const SLIPS: &[Slip] = &[
    Slip {
        name: "integer-division",
        chapters: BUILD_TEST,
        wrong: "r = i / (image_width - 1)",
        right: "r = double(i) / (image_width - 1)",
        explanation: "Two integers divide to an integer: 0 everywhere but in the last column, where it is 1.",
        page: "setup#the-code",
        source: "chapters/0_build_test/src/lib.rs",
        alter: |right| Program {
            color: |program, camera, i, j| {
                let row = program.edition.row(j, camera.image_height);
                let right = program.ramp(camera, i.into(), row);
                Color::new(right.x.floor(), right.y.floor(), right.z)
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "divided-by-size",
        chapters: EVERY,
        wrong: "r = double(i) / image_width",
        right: "r = double(i) / (image_width - 1)",
        explanation: "The last column is number image_width - 1, so red stops just short of full.",
        before_4: Some([
            "double(i) / image_width, double(j) / image_height",
            "double(i) / (image_width - 1), double(j) / (image_height - 1)",
            "The last column is number image_width - 1. In version 3 it lies on the edge of the viewport, in versions 1 and 2 a pixel before it.",
        ]),
        evidence: &["#923"],
        page: "setup#the-code",
        source: "chapters/0_build_test/src/lib.rs",
        alter: |right| Program {
            divisors: |width, height| [width, height],
            ..right
        },
        unseen: &[(
            RAYS,
            Unseen::Equivalent(
                "Rays of version 4 step by pixel_delta_u, which is the edge divided by image_width.",
            ),
        )],
    },
    Slip {
        name: "red-and-green-swapped",
        chapters: BUILD_TEST,
        wrong: "r = j / (height - 1), g = i / (width - 1)",
        right: "r = i / (width - 1), g = j / (height - 1)",
        explanation: "Columns run to the right and carry red; here they carry green. The picture is transposed.",
        page: "setup#the-code",
        source: "chapters/0_build_test/src/lib.rs",
        alter: |right| Program {
            color: |program, camera, i, j| {
                let row = program.edition.row(j, camera.image_height);
                program.ramp(camera, row, i.into())
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "green-upwards",
        chapters: BUILD_TEST,
        wrong: "g = 1 - j / (height - 1)",
        right: "g = j / (height - 1)",
        explanation: "Older editions count rows from below. Here row 0 is at the top, and green grows downwards.",
        before_4: Some([
            "g = 1 - j / (image_height - 1)",
            "g = j / (image_height - 1)",
            "Green grows with j, which counts rows from below.",
        ]),
        evidence: &["#879"],
        page: "setup#the-code",
        source: "chapters/0_build_test/src/lib.rs",
        alter: |right| Program {
            color: |program, camera, i, j| {
                let row = program.edition.row(j, camera.image_height);
                let turned = f64::from(camera.image_height) - 1.0 - row;
                program.ramp(camera, i.into(), turned)
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "quarter-blue",
        chapters: BUILD_TEST,
        wrong: "b = 0.25",
        right: "b = 0",
        explanation: "Older editions put a quarter of blue into every pixel of this picture.",
        evidence: &["PR #1184"],
        page: "setup#the-code",
        source: "chapters/0_build_test/src/lib.rs",
        alter: |right| Program {
            blue: 0.25,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "columns-first",
        chapters: EVERY,
        wrong: "for i … for j … print",
        right: "for j … for i … print",
        explanation: "A file holds row after row. With the loops the other way round it gets column after column.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            order: |n, _, height| (n / height, n % height),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "rows-from-below",
        chapters: EVERY,
        wrong: "for j = image_height - 1 down to 0",
        right: "for j = 0 up to image_height - 1",
        explanation: "Older editions print from the last row upwards. In this one the picture stands on its head.",
        before_4: Some([
            "for j = 0 up to image_height - 1",
            "for j = image_height - 1 down to 0",
            "Rows are counted from below, and a file begins with the highest one. Printed from row 0 on, the picture stands on its head.",
        ]),
        evidence: &["PR #1051", "#766", "#879"],
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            order: |n, width, height| (n % width, height - 1 - n / width),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "columns-backwards",
        chapters: EVERY,
        wrong: "for i = image_width - 1 down to 0",
        right: "for i = 0 to image_width - 1",
        explanation: "A row is printed from left to right. Backwards, the picture is mirrored; where it is symmetric, nobody sees it.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            order: |n, width, _| (width - 1 - n % width, n / width),
            ..right
        },
        unseen: &[(
            GRADIENT,
            Unseen::Equivalent(
                "Each row of the sky is its own mirror image, but for a few roundings.",
            ),
        )],
        ..Slip::USUAL
    },
    Slip {
        name: "loops-from-one",
        chapters: EVERY,
        wrong: "for j = 1 to image_height, for i = 1 to image_width",
        right: "for j = 0 to image_height - 1, for i = 0 to image_width - 1",
        explanation: "Pixels are counted from 0. Counted from 1, the picture moves by a pixel to the left and upwards.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            order: |n, width, _| (n % width + 1, n / width + 1),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "rows-from-one",
        chapters: EVERY,
        wrong: "for j = 1 to image_height",
        right: "for j = 0 to image_height - 1",
        explanation: "Rows are counted from 0. Counted from 1, the picture moves up by a pixel.",
        before_4: Some([
            "for j = image_height down to 1",
            "for j = image_height - 1 down to 0",
            "Rows are counted from 0. Counted from 1, the picture moves down by a pixel.",
        ]),
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| match right.edition.counts_from_below() {
            true => a_row_above(right),
            false => Program {
                order: |n, width, _| (n % width, n / width + 1),
                ..right
            },
        },
        ..Slip::USUAL
    },
    Slip {
        name: "header-swapped",
        chapters: EVERY,
        wrong: "print image_height, image_width",
        right: "print image_width, image_height",
        explanation: "The header tells the width first. Swapped, every row breaks at the wrong pixel: where columns differ the picture shears.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            header: |width, height| (height, width),
            ..right
        },
        unseen: &[(
            BUILD_TEST,
            Unseen::Equivalent("The picture is a square, so both numbers are the same."),
        )],
        ..Slip::USUAL
    },
    Slip {
        name: "channels-reversed",
        chapters: EVERY,
        wrong: "print b, g, r",
        right: "print r, g, b",
        explanation: "A pixel is red, green, blue. Reversed, red and blue change places all over the picture.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            channels: [2, 1, 0],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "green-before-red",
        chapters: EVERY,
        wrong: "print g, r, b",
        right: "print r, g, b",
        explanation: "A pixel is red, green, blue. Here red and green change places: a blue sky turns violet.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            channels: [1, 0, 2],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "blue-before-green",
        chapters: EVERY,
        wrong: "print r, b, g",
        right: "print r, g, b",
        explanation: "A pixel is red, green, blue. Here green and blue change places: a blue sky turns green.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            channels: [0, 2, 1],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "green-twice",
        chapters: EVERY,
        wrong: "print r, g, g",
        right: "print r, g, b",
        explanation: "A copied line keeps its old letter: green stands where blue should.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            channels: [0, 1, 1],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "red-twice",
        chapters: EVERY,
        wrong: "print r, g, r",
        right: "print r, g, b",
        explanation: "A copied line keeps its old letter: red stands where blue should.",
        page: "setup#a-picture-is-text",
        source: "common/src/engine/picture.rs",
        alter: |right| Program {
            channels: [0, 1, 0],
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "times-255",
        chapters: EVERY,
        wrong: "int(255 * r)",
        right: "int(255.999 * r)",
        explanation: "Cutting off the fraction leaves level 255 to exactly 1.0 alone, so almost all pixels are a level darker.",
        evidence: &["#1249"],
        page: "setup#a-picture-is-text",
        source: "common/src/color.rs",
        alter: |right| Program {
            level: |component| (255.0 * component) as i32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "times-255-99",
        chapters: EVERY,
        wrong: "int(255.99 * r)",
        right: "int(255.999 * r)",
        explanation: "The factor of older editions: a few pixels are a level darker.",
        page: "setup#a-picture-is-text",
        source: "common/src/color.rs",
        alter: |right| Program {
            level: |component| (255.99 * component) as i32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "times-256",
        chapters: EVERY,
        wrong: "int(256 * r)",
        right: "int(255.999 * r)",
        explanation: "A component of 1.0 becomes 256, which is no level; a language that stops at 255 shows a few pixels a level brighter.",
        evidence: &["RayTracing/TheRestOfYourLife PR #5"],
        page: "setup#a-picture-is-text",
        source: "common/src/color.rs",
        alter: |right| Program {
            level: |component| (256.0 * component) as i32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "times-256-clamped",
        chapters: EVERY,
        wrong: "int(256 * clamp(r, 0.000, 0.999))",
        right: "int(255.999 * r)",
        explanation: "How a later chapter of the book does it: a few pixels are a level brighter.",
        page: "setup#a-picture-is-text",
        source: "common/src/color.rs",
        alter: |right| Program {
            level: |component| (256.0 * component.clamp(0.0, 0.999)) as i32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "rounded",
        chapters: EVERY,
        wrong: "round(255 * r)",
        right: "int(255.999 * r)",
        explanation: "Rounding to the nearest level is no worse, but it is another picture: half of the pixels are a level off.",
        page: "setup#a-picture-is-text",
        source: "common/src/color.rs",
        alter: |right| Program {
            level: |component| (255.0 * component).round() as i32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "rounded-255-999",
        chapters: EVERY,
        wrong: "round(255.999 * r)",
        right: "int(255.999 * r)",
        explanation: "The factor is made for cutting off. Rounded, 1.0 becomes 256, which is no level, and half of the others are a level brighter.",
        page: "setup#a-picture-is-text",
        source: "common/src/color.rs",
        alter: |right| Program {
            level: |component| (255.999 * component).round() as i32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "blended-as-bytes",
        chapters: RAYS,
        wrong: "int((1 - a) * 255) + int(a * 127)",
        right: "int(255.999 * ((1 - a) * 1.0 + a * 0.5))",
        explanation: "The two colors are bytes, and each term is cut off to an integer before the sum. So up to three levels are lost.",
        page: "gradient#the-color-of-the-sky",
        source: "chapters/1_gradient/src/lib.rs",
        alter: |right| Program {
            lerp: |sky, a| {
                let [below, above] = sky.map(|color| (255.0 * color).floor());
                (((1.0 - a) * below).floor() + (a * above).floor()) / 255.0
            },
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "cast-too-early",
        chapters: EVERY,
        wrong: "255 * int(r)",
        right: "int(255.999 * r)",
        explanation: "The conversion cuts off everything below 1 before the factor can spread it: levels are 0 or 255.",
        page: "setup#a-picture-is-text",
        source: "common/src/color.rs",
        alter: |right| Program {
            level: |component| 255_i32.saturating_mul(component as i32),
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "gamma-too-early",
        chapters: EVERY,
        wrong: "int(255.999 * sqrt(r))",
        right: "int(255.999 * r)",
        explanation: "The square root is the gamma correction of a later chapter: everything is too bright.",
        page: "setup#a-picture-is-text",
        source: "common/src/color.rs",
        alter: |right| Program {
            level: |component| (255.999 * component.sqrt()) as i32,
            ..right
        },
        ..Slip::USUAL
    },
    Slip {
        name: "single-precision",
        chapters: RAYS,
        wrong: "float",
        right: "double",
        explanation: "With 24 bits instead of 53, a few pixels are a level off; small far spheres come out worse.",
        evidence: &["mitsuba-renderer/mitsuba3#512"],
        page: "cpp_to_rust#small-words",
        source: "tests/suite/methods/stability.rs",
        alter: |right| Program {
            color: single::color,
            level: match right.edition {
                Edition::V1 | Edition::V1InDouble => right.level,
                _ => |component| (255.999_f32 * component as f32) as i32,
            },
            ..right
        },
        ..Slip::USUAL
    },
];

/// Rows that are counted from below, each of them a row above its place. The order of
/// pixels is told from above, and has no row above the first one.
fn a_row_above(right: Program) -> Program {
    Program {
        color: match right.chapter {
            Chapter::BuildTest => |program, camera, i, j| {
                let row = program.edition.row(j, camera.image_height);
                program.ramp(camera, i.into(), row + 1.0)
            },
            _ => right.color,
        },
        ray: |program, camera, i, j| {
            let row = program.edition.row(j, camera.image_height);
            program.edition.ray(program, camera, i.into(), row + 1.0)
        },
        ..right
    }
}
