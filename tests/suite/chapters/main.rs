//! The chapters themselves, and what they share: their laws, their colors, their
//! pictures.
//!
//! All other tests stand on right chapters and are other programs. Cargo runs those
//! next, and only if all of these pass: a mistake in a chapter is told once, by the law
//! that it breaks and the picture that it draws.

use std::panic::{catch_unwind, resume_unwind, set_hook};

use slips::Chapter;

mod book_pictures;
mod color;
mod quadratic;

/// One test for each chapter, so that what it says has an order: the last is the law
/// that is broken, with the cause.
mod is_right {
    use super::color::normals_are_colored_by;
    use super::{assert_right, quadratic};

    macro_rules! chapters {
        ($($chapter:ident: $($what:expr),*;)*) => {
            $(
                #[test]
                fn $chapter() {
                    assert_right(stringify!($chapter), &[$($what),*]);
                }
            )*
        };
    }

    chapters! {
        build_test:;
        gradient: quadratic::gradient::obeys_its_laws;
        red_sphere: quadratic::red_sphere::obeys_its_laws;
        normals: || normals_are_colored_by(::normals::ray_color),
            quadratic::normals::obeys_its_laws;
        half_b_sphere: || normals_are_colored_by(::half_b_sphere::ray_color),
            quadratic::half_b_sphere::obeys_its_laws;
        hittable_list:
            || {
                let world = ::hittable_list::world();
                normals_are_colored_by(|ray| ::hittable_list::ray_color(ray, &world));
            },
            quadratic::hittable_list::obeys_its_laws;
    }
}

/// Asks for the picture of the chapter and for all of `further`, each of which says
/// what it finds.
fn assert_right(name: &str, further: &[fn()]) {
    // A backtrace would lead into the laws, which are right, and away from what they say.
    set_hook(Box::new(|panic| eprintln!("{panic}")));
    let chapter = Chapter::find(name).expect("the chapter is in the list");
    let picture = catch_unwind(|| book_pictures::is_drawn_by(chapter));
    let further = further.iter().map(catch_unwind);
    if let Some(last) = std::iter::once(picture)
        .chain(further)
        .filter_map(Result::err)
        .last()
    {
        resume_unwind(last);
    }
}
