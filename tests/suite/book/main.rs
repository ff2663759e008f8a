//! The book: is it whole, and is what it shows what there is?

mod book;
mod chapter_program;
mod compiler;
mod drawings;
mod editions;
mod errata;
mod live;
mod programs;
mod rooms;
mod spellings;
mod typed;
mod typing;

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
