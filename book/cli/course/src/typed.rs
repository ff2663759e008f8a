//! What a reader types: which functions are given, and the two stairs of chapter 5: spheres first,
//! and then anything that a ray can hit.

use crate::chapter::Chapter;

/// Lists the functions of a chapter that the reader need not type. (Of that of the build test, one
/// line is typed.)
pub fn given(chapter: Chapter) -> &'static [&'static str] {
    match chapter {
        Chapter::RedSphere => &["picture", "ray_color"],
        _ => &["picture", "world", "new", "add"],
    }
}

/// Returns a source of chapter 5 as it is on the first stair: a list of spheres, without a trait. A
/// text that has none of the lines that the second stair changes is returned as it is.
pub fn on_the_first_stair(text: &str) -> String {
    let mut text = text.to_owned();
    if let Some(start) = text.find(TRAIT)
        && let Some(length) = text[start..].find("\n}\n\n")
    {
        let end = start + length + "\n}\n\n".len();
        // Its comment goes, too.
        let start = text[..start].rfind("\n\n").map_or(start, |at| at + 2);
        text.replace_range(start..end, "");
    }
    for (second, first) in CHANGES {
        text = text.replace(second, first);
    }
    text
}

/// The beginning of the trait, which the second stair adds.
const TRAIT: &str = "pub trait Hittable {";

/// What the second stair changes: the text of the chapter, and that of the first stair.
const CHANGES: [(&str, &str); 11] = [
    (
        "//! The trait of anything that a ray can hit, and the record of a hit.",
        "//! The record of a hit.",
    ),
    (
        "//! A list of things to hit, which can be hit itself.",
        "//! A list of spheres.",
    ),
    (
        "use crate::hittable::{HitRecord, Hittable};\n\n/// A list of hittable things, other lists among them.",
        "use crate::hittable::HitRecord;\nuse crate::sphere::Sphere;\n\n/// A list of spheres.",
    ),
    // A text without comments.
    (
        "use crate::hittable::{HitRecord, Hittable};\n\n#[derive(Default)]",
        "use crate::hittable::HitRecord;\nuse crate::sphere::Sphere;\n\n#[derive(Default)]",
    ),
    ("{HitRecord, Hittable}", "HitRecord"),
    ("Vec<Box<dyn Hittable + Send + Sync>>", "Vec<Sphere>"),
    ("impl Hittable + Send + Sync + 'static", "Sphere"),
    ("Box::new(object)", "object"),
    ("impl Hittable for ", "impl "),
    ("    fn hit(", "    pub fn hit("),
    ("&dyn Hittable", "&HittableList"),
];
