//! Golden images: each chapter draws the book's picture, to the last bit.
//!
//! The book shows the snapshots: what is compared is what a reader sees.

use std::path::Path;

use common::rtweekend::*;
use difference::{png, snapshot};
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

/// Compares the picture with its snapshot, and its text at many widths with the sums of
/// what the book's program prints.
fn assert_drawn(chapter: &str, draw: fn(u32) -> Picture, width: u32) {
    // The camera is chapter 1's lesson: a mistake in it is told there.
    let rays = rays_are_lawful(&Trial::default());
    if !["build_test", "gradient"].contains(&chapter) && rays.is_err() {
        println!("The picture of `{chapter}` waits until the camera is right.");
        return;
    }
    let drawn = draw(width);
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let difference = snapshot::leave_panels(root, chapter, &drawn);
    if let Some(difference) = difference.expect("panels can be written beside a snapshot") {
        println!("{difference}{}", more(chapter));
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root.join(snapshot::FOLDER));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| assert_binary_snapshot!(&format!("{chapter}.png"), png::encode(&drawn)));
    assert_sums(chapter, draw, |width| width < WIDEST);
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

/// Two pictures of 2 × 1 pixels, which differ in the second one.
#[test]
fn a_wrong_picture_is_shown_beside_the_right_one_and_their_difference() {
    let [black, white] = [[0; 3], [255; 3]];
    let picture = |pixels: &[[u8; 3]]| {
        Picture::from_rgb(pixels.len() as u32, 1, pixels.concat()).expect("three bytes a pixel")
    };
    let (right, wrong) = (picture(&[white, black]), picture(&[white, white]));
    let gap = [white; 8];
    let difference = [[255; 3], [220, 0, 0]];
    let row = [
        &[white, black][..],
        &gap,
        &[white, white],
        &gap,
        &difference,
    ];
    assert_eq!(difference::panels(&right, &wrong), picture(&row.concat()));
}
