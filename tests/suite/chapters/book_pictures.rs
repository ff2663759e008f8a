//! Each chapter draws the book's picture, to the last bit.

use std::env;

use sha2::{Digest, Sha256};
use slips::Chapter;

use crate::quadratic::gradient;
use suite::drawn::{assert_picture, more, p3};
use suite::left_out::left_out;

/// Compares the picture of the chapter with its snapshot, and its text at many widths
/// with the sums of the book's own.
pub(crate) fn is_drawn_by(chapter: Chapter) {
    let name = chapter.name();
    // The camera is chapter 1's lesson: a mistake in it is told there.
    if chapter > Chapter::Gradient && !gradient::is_lawful() {
        left_out(&format!(
            "the picture of `{name}` waits until the camera is right"
        ));
        return;
    }
    let own = chapter.book_width();
    if env::var_os("INSTA_UPDATE").is_some() {
        // Of another picture no snapshot is made.
        has_the_sums_of_the_book(chapter, |width| width == own);
    }
    assert_picture(name, &chapter.picture(own));
    has_the_sums_of_the_book(chapter, |width| width < WIDEST);
}

/// The widest picture is 95 MB of text.
const WIDEST: u32 = 3840;

#[test]
#[ignore = "hashes 475 MB of text"]
fn each_chapter_draws_the_books_picture_at_the_size_of_a_screen_too() {
    for chapter in Chapter::OF_THE_BOOK {
        has_the_sums_of_the_book(chapter, |width| width == WIDEST);
    }
}

fn has_the_sums_of_the_book(chapter: Chapter, is_asked: impl Fn(u32) -> bool) {
    let name = chapter.name();
    let of_chapter = sums().filter(|&(_, other, width)| other == name && is_asked(width));
    for (sum, _, width) in of_chapter {
        let actual = sha256(&p3(&chapter.picture(width)));
        let same_as = sums().find(|(sum, ..)| *sum == actual);
        let same_as = same_as.map_or(String::new(), |(_, other, _)| {
            format!(": it is exactly the picture of {other}")
        });
        let advice = match width == chapter.book_width() {
            true => {
                "Only the book's own picture may be its snapshot. If another one is: git checkout \
                     book/notes/pictures"
            }
            false => {
                "Its snapshot is right, so look for another order of operations, a fused \
                      multiply-add, f32 somewhere, v / s for v * (1.0 / s), or the text: P3, width \
                      and height, 255, each on its line, then a pixel a line."
            }
        };
        assert!(
            actual == sum,
            "{name} at {width} wide is not what the book's C++ draws{same_as}.\n{advice}\n\n{}",
            more(chapter)
        );
    }
}

/// Sum, chapter and width.
fn sums() -> impl Iterator<Item = (&'static str, &'static str, u32)> {
    let lines = include_str!("reference_sums.txt").lines();
    lines.filter(|line| !line.starts_with('#')).map(|line| {
        match line.split(' ').collect::<Vec<_>>()[..] {
            [sum, name, width] => (sum, name, width.parse().expect("a width is a number")),
            _ => panic!("reference_sums.txt has a line that is not `sum chapter width`: {line}"),
        }
    })
}

fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}
