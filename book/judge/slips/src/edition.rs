//! Editions of the book: what tells the versions of the same chapters apart.
//!
//! The facts are from the listings in the repositories `RayTracing/InOneWeekend`
//! (versions 1 and 2) and `RayTracing/raytracing.github.io` (the others), as they stand
//! at each tag. An edition is a mutation of the latest one: a few other steps, like a slip,
//! but right from the first line to the last.

use std::fmt;

use crate::chapter::Chapter;
use crate::program::Program;
use crate::single;

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

/// What there is to know of an edition.
struct Facts {
    numbers: &'static [&'static str],
    /// From the first to the last.
    years: [&'static str; 2],
    differs_by: [&'static str; 2],
}

impl Edition {
    /// All of them, the one that this workspace follows first.
    pub const ALL: [Self; 5] = [Self::V4, Self::V3, Self::V3_0, Self::V1, Self::V1InDouble];

    fn facts(self) -> Facts {
        match self {
            Self::V1 | Self::V1InDouble => Facts {
                numbers: &["1", "2"],
                years: ["2016", "2019"],
                differs_by: [
                    "twice as wide as high, a viewport of 4 × 2, u = i / nx, rows from below, int(255.99 * r)",
                    "twice as wide as high, r = i / nx, rows from below, int(255.99 * r), blue 0.2",
                ],
            },
            Self::V3_0 => Facts {
                numbers: &["3.0"],
                years: ["March 2020"; 2],
                differs_by: [
                    "twice as wide as high, a viewport of 4 × 2, u = i / image_width, rows from below",
                    "twice as wide as high, r = i / image_width, rows from below, blue 0.2",
                ],
            },
            Self::V3 => Facts {
                numbers: &["3"],
                years: ["2020", "2023"],
                differs_by: [
                    "u = i / (image_width - 1), rows from below, viewport_width = aspect_ratio * viewport_height",
                    "rows from below, blue 0.25",
                ],
            },
            Self::V4 => Facts {
                numbers: &["4"],
                years: ["2023", "today"],
                differs_by: ["nothing"; 2],
            },
        }
    }

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        self.facts().numbers[0]
    }

    /// What it has otherwise than version 4: in chapters with rays, and in the build test.
    pub fn differs_by(self) -> [&'static str; 2] {
        self.facts().differs_by
    }

    /// After "right" or "wrong": which editions it is judged by, if the one that this
    /// workspace follows is not among them.
    pub fn said(editions: &[Self]) -> String {
        if editions.contains(&Self::V4) {
            return String::new();
        }
        match editions {
            [one] => format!(" by {one}"),
            _ => format!(" by {}", Self::together(editions)),
        }
    }

    /// Editions by their numbers and the years from the first to the last.
    fn together(editions: &[Self]) -> String {
        let mut all: Vec<Facts> = editions.iter().map(|it| it.facts()).collect();
        all.sort_by_key(|it| it.numbers);
        // Version 1 in both precisions has the same numbers.
        all.dedup_by_key(|it| it.numbers);
        let mut numbers: Vec<&str> = all.iter().flat_map(|it| it.numbers).copied().collect();
        let [from, _] = all[0].years;
        let [_, to] = all[all.len() - 1].years;
        let last = numbers.pop().unwrap_or_default();
        let numbers = match numbers.as_slice() {
            [] => last.to_owned(),
            others => format!("{} or {last}", others.join(", ")),
        };
        let years = if from == to {
            from.to_owned()
        } else {
            format!("{from} to {to}")
        };
        format!("version {numbers} of the book ({years})")
    }

    /// The chapter's program in this edition.
    ///
    /// # Panics
    /// If the chapter is not one of [`Chapter::OF_THE_BOOK`].
    pub fn program(self, chapter: Chapter) -> Program {
        let mut program = Program::right(chapter);
        let p = &mut program;
        p.edition = self;
        match self {
            Self::V4 => {}
            Self::V3 => count_from_below(p),
            Self::V3_0 => make_two_to_one(p),
            Self::V1 | Self::V1InDouble => {
                make_two_to_one(p);
                p.level = |component| (255.99 * component) as i32;
                // Front and back are of version 3.
                p.face = |_, _, outward| outward;
            }
        }
        if self == Self::V1 && chapter != Chapter::BuildTest {
            p.color = single::color;
        }
        program
    }

    /// Whether it is that of versions 1 and 2, in whatever precision.
    pub fn is_first(self) -> bool {
        matches!(self, Self::V1 | Self::V1InDouble)
    }

    /// Whether row 0 is the lowest one, and the edge of the viewport points up.
    pub fn counts_from_below(self) -> bool {
        self != Self::V4
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
        match self {
            Self::V4 => f.write_str("version 4 of the book"),
            Self::V1InDouble => {
                let version = Self::together(&[*self]);
                write!(f, "{version}, as with double precision")
            }
            _ => f.write_str(&Self::together(&[*self])),
        }
    }
}

/// 16:9. The viewport's left edge points up from its lower left corner, and a pixel is
/// a fraction of the whole edges.
fn count_from_below(p: &mut Program) {
    if p.chapter != Chapter::BuildTest {
        p.image_height = |width, aspect_ratio| (width / aspect_ratio) as u32;
    }
    p.viewport_ratio = |_, _, aspect_ratio| aspect_ratio;
    p.edges = [1.0, 1.0];
    p.last = 1.0;
    p.divisors = |width, height| [width, height];
    p.inset = [0.0, 0.0];
    p.blue = 0.25;
}

/// Twice as wide as high, in all chapters, and the last column stops short of 1.
fn make_two_to_one(p: &mut Program) {
    count_from_below(p);
    p.aspect_ratio = 2.0;
    p.image_height = |width, aspect_ratio| (width / aspect_ratio) as u32;
    p.viewport_ratio = |_, _, _| 2.0;
    p.last = 0.0;
    p.blue = 0.2;
}
