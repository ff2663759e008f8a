//! Every picture, in reading order.

use common::rtweekend::Picture;

/// A package that draws one picture.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// The name of the package.
    pub name: &'static str,
    /// How wide the book shows the picture, or would, in pixels.
    pub book_width: u32,
    /// What there is to see, for whoever can't see it.
    pub shows: &'static str,
    /// Draws the picture at any width, in pixels.
    pub picture: fn(u32) -> Picture,
}

/// All stages, the build test first.
pub const STAGES: &[Stage] = &[
    Stage {
        name: "build_test",
        book_width: 256,
        shows: "Red grows to the right, green grows downwards",
        picture: build_test::picture,
    },
    Stage {
        name: "gradient",
        book_width: 400,
        shows: "Pale at the bottom, ever bluer towards the top",
        picture: gradient::picture,
    },
    Stage {
        name: "red_sphere",
        book_width: 400,
        shows: "A flat red disc in front of the gradient",
        picture: red_sphere::picture,
    },
    Stage {
        name: "normals",
        book_width: 400,
        shows: "The disc is now a ball: cyan above, violet below, pink at the right",
        picture: normals::picture,
    },
    Stage {
        name: "half_b_sphere",
        book_width: 400,
        shows: "The same ball: cyan above, violet below, pink at the right",
        picture: half_b_sphere::picture,
    },
    Stage {
        name: "hittable_list",
        book_width: 400,
        shows: "The ball rests on a green ground that curves away",
        picture: hittable_list::picture,
    },
    Stage {
        name: "speed_vs_accuracy",
        book_width: 400,
        shows: "A far star: in the left half its edge frays into specks, in the right half it is round",
        picture: speed_vs_accuracy::picture,
    },
];

/// The stages whose pictures are in *Ray Tracing in One Weekend*: all but the
/// last, which is this project's own.
pub fn of_the_book() -> &'static [Stage] {
    &STAGES[..STAGES.len() - 1]
}

/// The stage of that name.
pub fn find(name: &str) -> Option<Stage> {
    STAGES.iter().copied().find(|stage| stage.name == name)
}
