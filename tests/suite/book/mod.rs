//! The book: is it whole, and is what it shows what there is?

mod chapter_program;
mod drawings;
mod editions;
mod errata;
mod folder;
mod live;
mod programs;
mod rooms;
mod small_books;
mod spellings;
mod typed;
mod typing;
mod whole;

/// The answers to the exercises of the book, and the first stair of chapter 5. The pages show them.
mod exercises {
    mod build_test;
    mod gradient;
    mod half_b_sphere;
    mod hittable_list;
    mod normals;
    mod red_sphere;
    mod speed_vs_accuracy;
    mod stairs;
}
