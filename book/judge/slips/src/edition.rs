//! Editions of the book, as edits of the latest one.
//!
//! The facts are from the listings in the repositories `RayTracing/InOneWeekend` (versions 1 and 2)
//! and `RayTracing/raytracing.github.io` (the others), as they stand at each tag.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::{LazyLock, Mutex, PoisonError};

use crate::chapter::Chapter;
use crate::edit::Edit;
use crate::program::ChapterProgram;

/// An edition of *Ray Tracing in One Weekend*: all versions of the book whose programs draw the
/// same pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Edition {
    /// Versions 1 and 2, 2016 to 2019: a picture twice as wide as high, rows counted from below, and
    /// all numbers in single precision.
    V1,
    /// Versions 1 and 2 with all numbers in double precision, as many have typed them.
    V1InDouble,
    /// Version 3.0, March 2020: as [`V1InDouble`](Self::V1InDouble), but with the factor 255.999
    /// for levels, and normals that point against the ray.
    V3_0,
    /// Versions 3.1 and 3.2, 2020 to 2023: a picture of 16:9, and rows counted from below. (3.1.0
    /// had another viewport for two weeks.)
    V3,
    /// Version 4, since 2023, which this workspace follows: a picture of 16:9, rows counted from
    /// above, and each ray through the middle of its pixel.
    V4,
}

/// The facts about an edition.
struct Facts {
    /// The numbers of its versions.
    numbers: &'static [&'static str],
    /// The year of the first version, and that of the last.
    years: [&'static str; 2],
    /// The differences from version 4, as code: with rays, and in the build test.
    differs_by: [&'static str; 2],
}

impl Edition {
    /// All editions, from version 4, which this workspace follows, back to versions 1 and 2, which
    /// come last in double precision.
    pub const ALL: [Self; 5] = [Self::V4, Self::V3, Self::V3_0, Self::V1, Self::V1InDouble];

    /// Returns the facts about the edition.
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

    /// Returns the name on the command line: `4`, `3`, `3.0` or `1`. Both [`V1`](Self::V1) and
    /// [`V1InDouble`](Self::V1InDouble) are `1`.
    pub fn name(self) -> &'static str {
        self.facts().numbers[0]
    }

    /// Describes the differences from version 4 in a line of words and code, first for the chapters
    /// with rays, then for the build test, the first picture of the book. Version 4 has `nothing`
    /// for both.
    pub fn differs_by(self) -> [&'static str; 2] {
        self.facts().differs_by
    }

    /// Returns the words that tell by which editions a picture is right or wrong, to be put after
    /// the word `right` or `wrong`: ` by version 3 of the book (2020 to 2023)`, with a blank first.
    /// Empty if version 4 is among the editions.
    ///
    /// # Panics
    /// If there are no editions.
    pub fn judged_by(editions: &[Self]) -> String {
        if editions.contains(&Self::V4) {
            return String::new();
        }
        match editions {
            [one] => format!(" by {one}"),
            _ => format!(" by {}", Self::together(editions)),
        }
    }

    /// Names editions by their numbers and the years from the first to the last.
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

    /// Returns the right program of a chapter in this edition. It is made at the first call and
    /// kept.
    ///
    /// # Panics
    /// If the chapter is not one of [`Chapter::OF_THE_BOOK`].
    pub fn program(self, chapter: Chapter) -> ChapterProgram {
        type Known = BTreeMap<(Edition, Chapter), ChapterProgram>;
        static KNOWN: LazyLock<Mutex<Known>> = LazyLock::new(Mutex::default);
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let program = known.entry((self, chapter));
        program
            .or_insert_with(|| self.program_of_shape(chapter, None))
            .clone()
    }

    /// Returns the right program of a chapter in this edition, for pictures of another shape.
    ///
    /// `size` is the width and the height of a picture in pixels: the program draws pictures with
    /// this ratio, and the build test (the picture before there are rays) with this height. `None`
    /// keeps the shape of the edition.
    ///
    /// # Panics
    /// If the chapter is not one of [`Chapter::OF_THE_BOOK`].
    pub fn program_of_shape(self, chapter: Chapter, size: Option<(u32, u32)>) -> ChapterProgram {
        let edits = match chapter {
            Chapter::BuildTest => self.edits_of_the_build_test(size.map(|it| it.1)),
            _ => self.edits_of_the_camera(size),
        };
        let program = ChapterProgram::right(chapter).with_any(&edits);
        program.expect("an edition is a program")
    }

    /// Returns the edits of a chapter with rays.
    fn edits_of_the_camera(self, size: Option<(u32, u32)>) -> Vec<Edit> {
        let edit = |right: &'static str, wrong: &str| Edit::new(right, wrong.to_owned());
        let real = "let viewport_width = viewport_height \
                    * (f64::from(image_width) / f64::from(image_height));";
        let own = match self {
            Self::V4 | Self::V3 => "16.0 / 9.0".to_owned(),
            _ => "2.0".to_owned(),
        };
        let wished = size.map(|size| (ratio(size), usual_ratio(size)));
        let aspect = wished.map_or(own, |(ratio, usual)| {
            format!("{:?}", usual.unwrap_or(ratio))
        });
        let is_real = self == Self::V4 || wished.is_some_and(|it| it.1.is_none());
        let mut edits = Vec::new();
        if !is_real {
            let wished = "let aspect_ratio = 16.0 / 9.0; \
                          let viewport_width = viewport_height * aspect_ratio;";
            edits.push(edit(real, wished));
        }
        edits.push(edit("16.0 / 9.0", &aspect));
        if self == Self::V4 {
            return edits;
        }
        if size.is_none() {
            let height = "((f64::from(image_width) / aspect_ratio) as u32).max(1)";
            edits.push(edit(
                height,
                "(f64::from(image_width) / aspect_ratio) as u32",
            ));
        }
        let last = if self == Self::V3 { " - 1" } else { "" };
        edits.extend([
            edit("Vec3::new(0.0, -viewport_height, 0.0)", "Vec3::new(0.0, viewport_height, 0.0)"),
            edit("viewport_u * (1.0 / f64::from(image_width))", "viewport_u"),
            edit("viewport_v * (1.0 / f64::from(image_height))", "viewport_v"),
            edit("viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)", "viewport_upper_left"),
            edit(
                "self.pixel00 + f64::from(i) * self.pixel_delta_u + f64::from(j) * self.pixel_delta_v",
                &format!(
                    "self.pixel00 + (f64::from(i) / f64::from(self.image_width{last})) * self.pixel_delta_u \
                     + (f64::from(self.image_height - 1 - j) / f64::from(self.image_height{last})) \
                     * self.pixel_delta_v"
                ),
            ),
        ]);
        edits.extend(FORMULA_BEFORE_4.map(Edit::parse));
        edits.extend(self.edits_of_the_first());
        edits
    }

    /// Returns the edits of the build test, with a number of rows in place of the edition's.
    fn edits_of_the_build_test(self, rows: Option<u32>) -> Vec<Edit> {
        let edit = |right: &'static str, wrong: &str| Edit::new(right, wrong.to_owned());
        let rows = match (rows, self) {
            (Some(rows), _) => format!("{rows}_u32"),
            (None, Self::V4 | Self::V3) => "width".to_owned(),
            _ => "(width / 2)".to_owned(),
        };
        let mut edits = Vec::new();
        if rows != "width" {
            edits.push(edit(
                "Picture::paint(width, width",
                &format!("Picture::paint(width, {rows}"),
            ));
        }
        if self == Self::V4 {
            if rows != "width" {
                let green = format!("f64::from(j) / f64::from(({rows} - 1).max(1))");
                edits.push(edit("f64::from(j) / last", &green));
            }
            return edits;
        }
        let (last, blue) = match self {
            Self::V3 => (" - 1", "0.25)"),
            _ => ("", "0.2)"),
        };
        let green = format!("f64::from({rows} - 1 - j) / f64::from({rows}{last})");
        edits.extend([
            edit(
                "f64::from(i) / last",
                &format!("f64::from(i) / f64::from(width{last})"),
            ),
            edit("f64::from(j) / last", &green),
            edit("0.0)", blue),
        ]);
        edits.extend(self.edits_of_the_first());
        edits
    }

    /// Returns the edits that only versions 1 and 2 need.
    fn edits_of_the_first(self) -> Vec<Edit> {
        let mut edits = Vec::new();
        if self.is_version_1_or_2() {
            edits.push(Edit::new("255.999", "255.99"));
            // Front and back are of version 3.
            let face = "if self.front_face { outward_normal } else { -outward_normal }";
            edits.push(Edit::new(face, "outward_normal"));
        }
        if self == Self::V1 {
            edits.push(Edit::new("v * (1.0 / v.length())", "v / v.length()"));
            edits.push(Edit::new("double", "float"));
        }
        edits
    }

    /// Returns true for the edition of versions 1 and 2, in single or double precision.
    pub fn is_version_1_or_2(self) -> bool {
        matches!(self, Self::V1 | Self::V1InDouble)
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

/// The edits that make the quadratic that of the versions before 4: `oc` points from the center to
/// the eye, and `b` has the other sign. The roots are equal bit for bit.
const FORMULA_BEFORE_4: [&str; 8] = [
    "oc = center - ray.origin → oc = ray.origin - center",
    "oc = self.center - ray.origin → oc = ray.origin - self.center",
    "b = -2.0 * ray.direction.dot(oc) → b = 2.0 * oc.dot(ray.direction)",
    "h = ray.direction.dot(oc) → half_b = oc.dot(ray.direction)",
    "h * h - a * c → half_b * half_b - a * c",
    "(h - discriminant.sqrt()) / a → (-half_b - discriminant.sqrt()) / a",
    "[(h - sqrtd) / a, (h + sqrtd) / a] → [(-half_b - sqrtd) / a, (-half_b + sqrtd) / a]",
    // In chapter 2 a tangent ray was a miss until version 3.2.3.
    "discriminant >= 0.0 → discriminant > 0.0",
];

/// The ratios of width to height that people choose.
const USUAL_RATIOS: [f64; 7] = [
    1.0,
    4.0 / 3.0,
    3.0 / 2.0,
    16.0 / 10.0,
    16.0 / 9.0,
    2.0,
    21.0 / 9.0,
];

/// Finds a usual ratio from which this height follows when it is rounded down. Before version 4 the
/// viewport has the ratio, not that of the picture's whole pixels.
fn usual_ratio((width, height): (u32, u32)) -> Option<f64> {
    let is_wished = |ratio: &f64| (f64::from(width) / ratio) as u32 == height;
    USUAL_RATIOS.into_iter().find(is_wished)
}

/// Returns width over height, made smaller by an ulp if the width divided by it, rounded down,
/// would not be the height.
fn ratio((width, height): (u32, u32)) -> f64 {
    let [width, height] = [width, height].map(f64::from);
    let ratio = width / height;
    if width / ratio < height {
        ratio.next_down()
    } else {
        ratio
    }
}
