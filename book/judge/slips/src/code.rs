//! The right code of the chapters: the judge's own texts, embedded in this program, and the pictures
//! that they draw, compiled.

use common::rtweekend::Picture;
use texts::rtweekend::{Camera, Color};

use crate::chapter::Chapter;

/// A source file of a chapter, embedded in this program, that a reader types.
#[derive(Clone, Copy, Debug)]
pub struct ChapterFile {
    /// The path in a crate of the reader's own, with `/`, such as `src/lib.rs`.
    pub name: &'static str,
    /// The whole text of the file, without comments.
    pub text: &'static str,
}

/// The right code of a chapter, as text and compiled. Neither is the chapter's package, which a
/// reader may change.
pub trait ChapterCode {
    /// Lists the sources that a reader types in this chapter, by their names from `a` to `z`. Empty
    /// for [`Chapter::SpeedVsAccuracy`].
    fn files(self) -> &'static [ChapterFile];

    /// Makes the chapter's right picture, `width` pixels wide (not 0) and as high as its aspect
    /// ratio asks. Its pixels are traced when they are first read.
    ///
    /// # Panics
    /// For [`Chapter::SpeedVsAccuracy`], of which no reader makes mistakes.
    fn picture(self, width: u32) -> Picture;

    /// Makes the chapter's right picture in any shape, of `width` × `height` pixels (neither 0), with
    /// a viewport of that shape. Its pixels are traced when they are first read.
    ///
    /// # Panics
    /// For [`Chapter::SpeedVsAccuracy`].
    fn picture_of_size(self, width: u32, height: u32) -> Picture;
}

/// Embeds files: the name that each has for a reader, and its path from the folder of the texts.
macro_rules! files {
    ($($name:literal: $path:literal),*) => {
        &[$(ChapterFile {
            name: $name,
            text: include_str!(concat!("../texts/src/", $path)),
        }),*]
    };
}

impl ChapterCode for Chapter {
    fn files(self) -> &'static [ChapterFile] {
        match self {
            Self::BuildTest => files!("src/lib.rs": "build_test.rs"),
            Self::Gradient => files!("src/lib.rs": "gradient.rs"),
            Self::RedSphere => files!("src/lib.rs": "red_sphere.rs"),
            Self::Normals => files!("src/lib.rs": "normals.rs"),
            Self::HalfBSphere => files!("src/lib.rs": "half_b_sphere.rs"),
            Self::HittableList => files!(
                "src/hittable.rs": "hittable_list/hittable.rs",
                "src/hittable_list.rs": "hittable_list/hittable_list.rs",
                "src/lib.rs": "hittable_list.rs",
                "src/sphere.rs": "hittable_list/sphere.rs"
            ),
            Self::SpeedVsAccuracy => &[],
        }
    }

    fn picture(self, width: u32) -> Picture {
        let picture = match self {
            Self::BuildTest => texts::build_test::picture(width),
            Self::Gradient => texts::gradient::picture(width),
            Self::RedSphere => texts::red_sphere::picture(width),
            Self::Normals => texts::normals::picture(width),
            Self::HalfBSphere => texts::half_b_sphere::picture(width),
            Self::HittableList => texts::hittable_list::picture(width),
            Self::SpeedVsAccuracy => unimplemented!("no mistake of a reader is in chapter 6"),
        };
        of_text(picture)
    }

    fn picture_of_size(self, width: u32, height: u32) -> Picture {
        let camera = Camera::with_size(width, height);
        let world = texts::hittable_list::world();
        let last = [width, height].map(|side| f64::from((side - 1).max(1)));
        of_text(texts::rtweekend::Picture::paint(
            width,
            height,
            move |i, j| {
                let ray = &camera.ray(i, j);
                match self {
                    Self::BuildTest => {
                        Color::new(f64::from(i) / last[0], f64::from(j) / last[1], 0.0)
                    }
                    Self::Gradient => texts::gradient::ray_color(ray),
                    Self::RedSphere => texts::red_sphere::ray_color(ray),
                    Self::Normals => texts::normals::ray_color(ray),
                    Self::HalfBSphere => texts::half_b_sphere::ray_color(ray),
                    Self::HittableList => texts::hittable_list::ray_color(ray, &world),
                    Self::SpeedVsAccuracy => unimplemented!("no reader draws chapter 6"),
                }
            },
        ))
    }
}

/// Makes a picture whose pixels those of a text are.
fn of_text(picture: texts::rtweekend::Picture) -> Picture {
    let (width, height) = (picture.width, picture.height);
    Picture::from_levels(width, height, move |i, j| picture.levels(i, j).map(stored))
}

/// Returns a printed level as a picture stores it, from 0 to 255.
pub(crate) fn stored(level: i32) -> u8 {
    level.clamp(0, 255) as u8
}
