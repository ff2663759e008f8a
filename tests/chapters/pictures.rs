//! Golden images: each chapter draws the book's picture, to the last bit.
//!
//! The book shows the snapshots: what is compared is what a reader sees.

use common::rtweekend::*;
use image::{ImageFormat, RgbImage};
use insta::assert_binary_snapshot;
use laws::Trial;
use sha2::{Digest, Sha256};

use crate::more;
use crate::quadratic::rays_are_lawful;

mod the_books_picture_is_drawn_by {
    use super::{Picture, assert_drawn};

    macro_rules! chapters {
        ($($chapter:ident at $width:literal;)*) => {
            pub(super) const ALL: &[(&str, fn(u32) -> Picture)] =
                &[$((stringify!($chapter), ::$chapter::picture)),*];

            $(
                #[test]
                fn $chapter() {
                    assert_drawn(stringify!($chapter), ::$chapter::picture, $width);
                }
            )*
        };
    }

    chapters! {
        build_test at 256;
        gradient at 400;
        red_sphere at 400;
        normals at 400;
        half_b_sphere at 400;
        hittable_list at 400;
    }
}

/// The folder of the snapshots, relative to this file.
const SNAPSHOTS: &str = "../../book/notes/pictures";

/// Compares the picture with its snapshot, and its text at many widths with the sums of
/// what the book's program prints.
fn assert_drawn(chapter: &str, draw: fn(u32) -> Picture, width: u32) {
    // The camera is chapter 1's lesson: a mistake in it is told there.
    let rays = rays_are_lawful(&Trial::default());
    if !["build_test", "gradient"].contains(&chapter) && rays.is_err() {
        println!("The picture of `{chapter}` waits until the camera is right.");
        return;
    }
    let drawn = as_image(&draw(width));
    if let Some(difference) = difference(chapter, &drawn) {
        println!(
            "The picture of `{chapter}` is another one: {difference}.\n{}",
            more(chapter)
        );
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(SNAPSHOTS);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| assert_binary_snapshot!(&format!("{chapter}.png"), png(&drawn)));
    assert_sums(chapter, draw, |width| width < WIDEST);
}

fn as_image(picture: &Picture) -> RgbImage {
    let rgb = picture.rgb().to_vec();
    RgbImage::from_raw(picture.width(), picture.height(), rgb).expect("three bytes a pixel")
}

fn png(image: &RgbImage) -> Vec<u8> {
    let mut file = std::io::Cursor::new(Vec::new());
    image
        .write_to(&mut file, ImageFormat::Png)
        .expect("memory takes it");
    file.into_inner()
}

/// Describes how the picture differs from its snapshot; `None` if there is no snapshot.
fn difference(chapter: &str, drawn: &RgbImage) -> Option<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/pictures");
    let right = image::open(format!("{folder}/{chapter}.snap.png")).ok()?;
    let right = right.into_rgb8();
    if right.dimensions() != drawn.dimensions() {
        return Some("it has another size".to_owned());
    }
    let pairs = right.enumerate_pixels().zip(drawn.pixels());
    let mut differing = pairs.filter(|((_, _, right), drawn)| right != drawn);
    let ((i, j, right), drawn) = differing.next()?;
    Some(format!(
        "{} pixels differ; the first, in column {i} and row {j}, should be {:?} and is {:?}",
        1 + differing.count(),
        right.0,
        drawn.0
    ))
}

/// The widest picture is 95 MB of text.
const WIDEST: u32 = 3840;

#[test]
#[ignore = "hashes 475 MB of text"]
fn each_chapter_draws_the_books_picture_at_the_size_of_a_screen_too() {
    for &(chapter, draw) in the_books_picture_is_drawn_by::ALL {
        assert_sums(chapter, draw, |width| width == WIDEST);
    }
}

fn assert_sums(chapter: &str, draw: fn(u32) -> Picture, is_asked: impl Fn(u32) -> bool) {
    for (sum, of, width) in sums() {
        if of != chapter || !is_asked(width) {
            continue;
        }
        let mut text = Vec::new();
        draw(width).write_p3(&mut text).expect("memory takes it");
        let actual: String = Sha256::digest(&text)
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        assert!(
            actual == sum,
            "{chapter} at {width} wide is not what the book's C++ draws.\n\
             Only the book's own picture may be its snapshot. If another one was accepted: git \
             checkout book/notes/pictures\n\
             If its snapshot is right, look for another order of operations, a fused \
             multiply-add, f32 somewhere, v / s for v * (1.0 / s), or the text: P3, width and \
             height, 255, each on its line, then a pixel a line.\n\n{}",
            more(chapter)
        );
    }
}

/// Lists the rows of the table: checksum, chapter and width in pixels.
fn sums() -> impl Iterator<Item = (&'static str, &'static str, u32)> {
    let lines = include_str!("reference_sums.txt").lines();
    lines.filter(|line| !line.starts_with('#')).map(|line| {
        match line.split(' ').collect::<Vec<_>>()[..] {
            [sum, chapter, width] => (sum, chapter, width.parse().expect("a width is a number")),
            _ => panic!("reference_sums.txt has a line that is not `sum chapter width`: {line}"),
        }
    })
}
