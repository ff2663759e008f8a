//! The chapters' own code: their sources, embedded in this program, and the pictures that their
//! compiled functions draw.

use common::rtweekend::Picture;

use crate::chapter::Chapter;

/// A source file of a chapter, embedded in this program, that a reader types.
#[derive(Clone, Copy, Debug)]
pub struct ChapterFile {
    /// The path in a crate of the reader's own, with `/`, such as `src/lib.rs`.
    pub name: &'static str,
    /// The whole text of the file, as the chapter has it.
    pub text: &'static str,
}

/// The code of a chapter, as text and compiled.
pub trait ChapterCode {
    /// Lists the sources that a reader types in this chapter, by their names from `a` to `z`. Empty
    /// for [`Chapter::SpeedVsAccuracy`].
    fn files(self) -> &'static [ChapterFile];

    /// Makes the chapter's picture, `width` pixels wide (not 0) and as high as its aspect ratio
    /// asks. Its pixels are traced when they are first read.
    ///
    /// # Panics
    /// For [`Chapter::SpeedVsAccuracy`], of which no reader makes mistakes.
    fn picture(self, width: u32) -> Picture;
}

impl ChapterCode for Chapter {
    fn files(self) -> &'static [ChapterFile] {
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

    fn picture(self, width: u32) -> Picture {
        let draw = match self {
            Self::BuildTest => build_test::picture,
            Self::Gradient => gradient::picture,
            Self::RedSphere => red_sphere::picture,
            Self::Normals => normals::picture,
            Self::HalfBSphere => half_b_sphere::picture,
            Self::HittableList => hittable_list::picture,
            Self::SpeedVsAccuracy => unimplemented!("no mistake of a reader is in chapter 6"),
        };
        draw(width)
    }
}
