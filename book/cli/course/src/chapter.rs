//! The chapters, in reading order.

use common::rtweekend::Picture;

/// A package that draws one picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Chapter {
    /// The picture without rays.
    BuildTest,
    /// Rays and a sky.
    Gradient,
    /// A sphere that is hit or not.
    RedSphere,
    /// Where it is hit, and its normal there.
    Normals,
    /// The ball by half of b, with fewer operations.
    HalfBSphere,
    /// The nearest of many.
    HittableList,
    /// Every method, and where it fails.
    SpeedVsAccuracy,
}

/// A source of a chapter, compiled into this program.
#[derive(Clone, Copy, Debug)]
pub struct ChapterFile {
    /// The path in a crate of the reader's own, with `/`, such as `src/lib.rs`.
    pub name: &'static str,
    /// The whole text.
    pub text: &'static str,
}

/// How many spheres a scene has room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereCount {
    /// There is only a background.
    None,
    /// A center and a radius.
    One,
    /// A list.
    Many,
}

impl Chapter {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::BuildTest,
        Self::Gradient,
        Self::RedSphere,
        Self::Normals,
        Self::HalfBSphere,
        Self::HittableList,
        Self::SpeedVsAccuracy,
    ];

    /// Those whose pictures are in *Ray Tracing in One Weekend*: all but the last,
    /// which is this project's own.
    pub const OF_THE_BOOK: [Self; 6] = {
        let [pictures @ .., _] = Self::ALL;
        pictures
    };

    /// Finds the chapter whose package has that name.
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|chapter| chapter.name() == name)
    }

    /// Returns the name of the package.
    pub fn name(self) -> &'static str {
        match self {
            Self::BuildTest => "build_test",
            Self::Gradient => "gradient",
            Self::RedSphere => "red_sphere",
            Self::Normals => "normals",
            Self::HalfBSphere => "half_b_sphere",
            Self::HittableList => "hittable_list",
            Self::SpeedVsAccuracy => "speed_vs_accuracy",
        }
    }

    /// Returns the width of the picture in the book, in pixels.
    pub fn book_width(self) -> u32 {
        match self {
            Self::BuildTest => 256,
            _ => 400,
        }
    }

    /// Describes the picture to a reader who can't see it.
    pub const fn shows(self) -> &'static str {
        match self {
            Self::BuildTest => "Red grows to the right, green grows downwards",
            Self::Gradient => "Pale at the bottom, ever bluer towards the top",
            Self::RedSphere => "A flat red disc in front of the gradient",
            Self::Normals => "The disc is now a ball: cyan above, violet below, pink at the right",
            Self::HalfBSphere => "The same ball: cyan above, violet below, pink at the right",
            Self::HittableList => "The ball rests on a green ground that curves away",
            Self::SpeedVsAccuracy => {
                "A far star: in the left half its edge frays into specks, in the right half it is \
                 round"
            }
        }
    }

    /// Returns how many spheres its scene has room for.
    pub fn sphere_count(self) -> SphereCount {
        match self {
            Self::BuildTest | Self::Gradient => SphereCount::None,
            Self::RedSphere | Self::Normals | Self::HalfBSphere => SphereCount::One,
            Self::HittableList | Self::SpeedVsAccuracy => SphereCount::Many,
        }
    }

    /// Lists the sources that a reader types, by their names from `a` to `z`; none for
    /// [`Chapter::SpeedVsAccuracy`].
    pub fn files(self) -> &'static [ChapterFile] {
        macro_rules! files {
            ($folder:literal: $($name:literal),*) => {
                &[$(ChapterFile {
                    name: $name,
                    text: include_str!(concat!("../../../../chapters/", $folder, "/", $name)),
                }),*]
            };
        }
        match self {
            Self::BuildTest => files!("0_build_test": "src/lib.rs"),
            Self::Gradient => files!("1_gradient": "src/lib.rs"),
            Self::RedSphere => files!("2_red_sphere": "src/lib.rs"),
            Self::Normals => files!("3_normals": "src/lib.rs"),
            Self::HalfBSphere => files!("4_half_b_sphere": "src/lib.rs"),
            Self::HittableList => files!(
                "5_hittable_list": "src/hittable.rs", "src/hittable_list.rs", "src/lib.rs",
                "src/sphere.rs"
            ),
            Self::SpeedVsAccuracy => &[],
        }
    }

    /// Draws the picture at any width, in pixels.
    pub fn picture(self, width: u32) -> Picture {
        let draw = match self {
            Self::BuildTest => build_test::picture,
            Self::Gradient => gradient::picture,
            Self::RedSphere => red_sphere::picture,
            Self::Normals => normals::picture,
            Self::HalfBSphere => half_b_sphere::picture,
            Self::HittableList => hittable_list::picture,
            Self::SpeedVsAccuracy => speed_vs_accuracy::picture,
        };
        draw(width)
    }
}
