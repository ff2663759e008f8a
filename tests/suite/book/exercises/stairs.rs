//! Chapter 5 on its first stair, before it has a trait: the page lists it, and the editor and `start`
//! begin with it.

#![expect(unreachable_pub, reason = "the page lists files of a library")]

mod hittable_list;
mod lib;
mod sphere;

use ::hittable_list::HitRecord;
use course::typed::on_the_first_stair;
use slips::{Chapter, ChapterCode};

#[test]
fn a_list_of_spheres_draws_the_picture_of_the_chapter() {
    assert_eq!(lib::picture(400), ::hittable_list::picture(400));
}

#[test]
fn the_page_lists_what_the_editor_asks_for() {
    let listed = [
        ("src/sphere.rs", include_str!("stairs/sphere.rs")),
        (
            "src/hittable_list.rs",
            include_str!("stairs/hittable_list.rs"),
        ),
        ("src/lib.rs", include_str!("stairs/lib.rs")),
    ];
    for (name, listed) in listed {
        let mut files = Chapter::HittableList.files().iter();
        let file = files.find(|file| file.name == name).expect("its file");
        assert_eq!(code(listed), code(&on_the_first_stair(file.text)), "{name}");
    }
}

/// Returns the lines of code, without comments, imports and names of other files.
fn code(text: &str) -> Vec<&str> {
    let others = ["//", "use ", "pub use ", "mod "];
    let is_code = |line: &&str| !others.iter().any(|it| line.trim_start().starts_with(it));
    text.lines()
        .filter(is_code)
        .filter(|it| !it.is_empty())
        .collect()
}
