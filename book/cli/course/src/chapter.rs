//! The chapters, in reading order.

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

    /// The chapters that readers type in crates of their own, in reading order: 1 to 5.
    pub const TYPED: [Self; 5] = {
        let [_, typed @ ..] = Self::OF_THE_BOOK;
        typed
    };

    /// The chapters of the book in which a ray meets a sphere, in reading order: 2 to 5.
    pub const WITH_SPHERES: [Self; 4] = {
        let [_, with_spheres @ ..] = Self::TYPED;
        with_spheres
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
}
