//! Editions of the book: what tells the versions of the same chapters apart.
//!
//! The facts are from the listings in the repositories `RayTracing/InOneWeekend`
//! (versions 1 and 2) and `RayTracing/raytracing.github.io` (the others), as they stand
//! at each tag. [`older`](crate::older) makes programs of them.

use std::fmt;

/// The versions of *Ray Tracing in One Weekend* whose pictures of these chapters
/// differ. A version that is not named here draws what the one before it draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Edition {
    /// Versions 1 and 2, 2016 to 2019: twice as wide as high, rows from below, and all of
    /// it in `float`.
    V1,
    /// The same in `double`, as many have typed it.
    V1InDouble,
    /// Version 3.0, March 2020: the same with other factors.
    V3_0,
    /// Versions 3.1 and later, 2020 to 2023: 16:9, rows from below. (3.1.0 had another
    /// viewport for two weeks.)
    V3,
    /// Version 4, 2023 and after, which this workspace follows: rows from above, and each
    /// ray through the middle of its pixel.
    V4,
}

impl Edition {
    /// All of them, the one that this workspace follows first.
    pub const ALL: [Self; 5] = [Self::V4, Self::V3, Self::V3_0, Self::V1, Self::V1InDouble];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::V1 | Self::V1InDouble => "1",
            Self::V3_0 => "3.0",
            Self::V3 => "3",
            Self::V4 => "4",
        }
    }

    /// What it has otherwise than version 4: in chapters with rays, and in the build test.
    pub fn differs_by(self) -> [&'static str; 2] {
        match self {
            Self::V1 | Self::V1InDouble => [
                "twice as wide as high, a viewport of 4 × 2, u = i / nx, rows from below, int(255.99 * r)",
                "twice as wide as high, r = i / nx, rows from below, int(255.99 * r), blue 0.2",
            ],
            Self::V3_0 => [
                "twice as wide as high, a viewport of 4 × 2, u = i / image_width, rows from below",
                "twice as wide as high, r = i / image_width, rows from below, blue 0.2",
            ],
            Self::V3 => [
                "u = i / (image_width - 1), rows from below, viewport_width = aspect_ratio * viewport_height",
                "rows from below, blue 0.25",
            ],
            Self::V4 => ["nothing"; 2],
        }
    }

    /// After "right" or "wrong": which editions it is judged by, if the one that this
    /// workspace follows is not among them.
    pub fn said(editions: &[Self]) -> String {
        if editions.contains(&Self::V4) {
            String::new()
        } else {
            format!(" by {}", Self::together(editions))
        }
    }

    /// Editions that draw the same, by their numbers and the years from the first to the
    /// last.
    fn together(editions: &[Self]) -> String {
        let mut editions = editions.to_vec();
        editions.sort();
        let (Some(first), Some(last)) = (editions.first(), editions.last()) else {
            return String::new();
        };
        if first == last {
            return first.to_string();
        }
        let ([from, _], [_, to]) = (first.years(), last.years());
        let mut numbers: Vec<&str> = editions
            .iter()
            .flat_map(|it| it.numbers())
            .copied()
            .collect();
        // Version 1 in both precisions has the same numbers.
        numbers.sort_unstable();
        numbers.dedup();
        let last = numbers.pop().unwrap_or_default();
        format!(
            "version {} or {last} of the book ({from} to {to})",
            numbers.join(", ")
        )
    }

    fn numbers(self) -> &'static [&'static str] {
        match self {
            Self::V1 | Self::V1InDouble => &["1", "2"],
            Self::V3_0 => &["3.0"],
            Self::V3 => &["3"],
            Self::V4 => &["4"],
        }
    }

    fn years(self) -> [&'static str; 2] {
        match self {
            Self::V1 | Self::V1InDouble => ["2016", "2019"],
            Self::V3_0 => ["March 2020"; 2],
            Self::V3 => ["2020", "2023"],
            Self::V4 => ["2023", "today"],
        }
    }

    /// Whether it is that of versions 1 and 2, in whatever precision.
    pub fn is_first(self) -> bool {
        matches!(self, Self::V1 | Self::V1InDouble)
    }

    /// Whether row 0 is the lowest one, and the edge of the viewport points up.
    pub fn counts_from_below(self) -> bool {
        self != Self::V4
    }

    /// Whether its camera divides the edges of the viewport. The oldest ones write out
    /// what comes of it, as `lower_left_corner(-2.0, -1.0, -1.0)`.
    pub(super) fn divides_the_viewport(self) -> bool {
        matches!(self, Self::V3 | Self::V4)
    }

    /// The row that the right loop counts as it draws the `j`th row from above.
    pub(super) fn row(self, j: u32, image_height: u32) -> f64 {
        if self.counts_from_below() {
            f64::from(image_height) - 1.0 - f64::from(j)
        } else {
            f64::from(j)
        }
    }
}

impl fmt::Display for Edition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::V1 => "version 1 or 2 of the book (2016 to 2019)",
            Self::V1InDouble => {
                "version 1 or 2 of the book (2016 to 2019), as with double precision"
            }
            Self::V3_0 => "version 3.0 of the book (March 2020)",
            Self::V3 => "version 3 of the book (2020 to 2023)",
            Self::V4 => "version 4 of the book",
        })
    }
}
