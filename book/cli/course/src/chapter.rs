//! The chapters, in reading order.

use common::rtweekend::Picture;

/// A chapter of the course: a package of this workspace that draws one picture. The order is the
/// reading order, and `chapter as usize` is the number in its folder, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Chapter {
    /// `build_test`: the square picture before chapter 1, without rays, whose red grows to the
    /// right and whose green grows downwards.
    BuildTest,
    /// `gradient`: rays of a camera, each colored as the sky in its direction.
    Gradient,
    /// `red_sphere`: a sphere, red where a ray hits it.
    RedSphere,
    /// `normals`: the sphere colored by its normal at the nearest point that a ray hits.
    Normals,
    /// `half_b_sphere`: the picture of [`Chapter::Normals`] with half of the coefficient b, which
    /// takes fewer operations.
    HalfBSphere,
    /// `hittable_list`: a list of spheres, of which the nearest hit is seen.
    HittableList,
    /// `speed_vs_accuracy`: many ways to find where a ray hits a sphere, compared in time and in
    /// error.
    SpeedVsAccuracy,
}

/// A source file of a chapter, embedded in this program, that a reader types.
#[derive(Clone, Copy, Debug)]
pub struct ChapterFile {
    /// The path in a crate of the reader's own, with `/`, such as `src/lib.rs`.
    pub name: &'static str,
    /// The whole text of the file, as the chapter has it.
    pub text: &'static str,
}

/// The number of spheres that the scene of a chapter can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereCount {
    /// No sphere: the scene is only a background.
    None,
    /// One sphere, given by a center and a radius.
    One,
    /// A list of spheres, of any length.
    Many,
}

impl Chapter {
    /// All seven chapters, in reading order.
    pub const ALL: [Self; 7] = [
        Self::BuildTest,
        Self::Gradient,
        Self::RedSphere,
        Self::Normals,
        Self::HalfBSphere,
        Self::HittableList,
        Self::SpeedVsAccuracy,
    ];

    /// The chapters whose pictures are in *Ray Tracing in One Weekend*, in reading order: all but
    /// [`Chapter::SpeedVsAccuracy`], which is this project's own.
    pub const OF_THE_BOOK: [Self; 6] = {
        let [pictures @ .., _] = Self::ALL;
        pictures
    };

    /// Finds the chapter whose package has exactly this name, such as `normals`. Returns `None` if
    /// no package of a chapter is called so.
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|chapter| chapter.name() == name)
    }

    /// Returns the name of the chapter's package, such as `normals`, which [`Chapter::find`] takes.
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

    /// Returns the width in pixels at which the book shows the chapter's picture: 256 or 400.
    pub fn book_width(self) -> u32 {
        match self {
            Self::BuildTest => 256,
            _ => 400,
        }
    }

    /// Describes the chapter's picture to a reader who can't see it: one line of plain text, a
    /// sentence without a full stop.
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

    /// Returns how many spheres the chapter's scene can have: none before [`Chapter::RedSphere`],
    /// then one, and many from [`Chapter::HittableList`] on.
    pub fn sphere_count(self) -> SphereCount {
        match self {
            Self::BuildTest | Self::Gradient => SphereCount::None,
            Self::RedSphere | Self::Normals | Self::HalfBSphere => SphereCount::One,
            Self::HittableList | Self::SpeedVsAccuracy => SphereCount::Many,
        }
    }

    /// Lists the sources that a reader types in this chapter, by their names from `a` to `z`. Empty
    /// for [`Chapter::SpeedVsAccuracy`].
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

    /// Makes the chapter's picture, `width` pixels wide (not 0) and as high as its aspect ratio
    /// asks. Its pixels are traced when they are first read.
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
