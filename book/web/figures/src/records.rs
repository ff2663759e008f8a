//! Records: the rows of the files with measured numbers, from which the charts are drawn.
//!
//! A test keeps the numbers that take a few thousand questions, and fails if they change. Numbers
//! that take millions of questions or a clock are recorded by the benchmarks of the package
//! `measure`.

use serde::{Deserialize, Serialize};
use speed_vs_accuracy::{METHODS, Method, Precision};

use crate::table::{Record, Table};

/// The accuracy of one method on all questions of a [regime](speed_vs_accuracy::Regime), a kind of
/// rays and spheres, with t from 0 to infinity. The regime `book` has each pixel of the book's
/// picture, `book_ball` and `book_ground` only its rays against one of its two spheres.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Accuracy {
    /// The name of the regime.
    pub regime: String,
    /// The number format of what the method takes and returns: `f64` or `f32`.
    #[serde(with = "PrecisionName")]
    pub precision: Precision,
    /// The name of the method, a way to compute t (see [`METHODS`](speed_vs_accuracy::METHODS)).
    pub method: String,
    /// The number of questions, each a ray against a sphere.
    pub cases: usize,
    /// The number of questions whose exact answer is a hit.
    pub hits: usize,
    /// The number of wrong decisions in a million questions: hits where there is no root, and
    /// misses where there is one.
    pub wrong_per_million: f64,
    /// The error of t that half of the hits do not exceed, in ulps of the exact root in this
    /// precision; `None`, like the two fields below, if no hit of the method was right.
    pub median_ulps: Option<f64>,
    /// The error of t that 999 of 1000 hits do not exceed, in ulps; `None` if no hit
    /// was right.
    pub p999_ulps: Option<f64>,
    /// The largest error of t, in ulps; `None` if no hit was right.
    pub largest_ulps: Option<f64>,
    /// A checksum of the method's first answers, by which a test knows that they have not changed.
    pub answers: u64,
}

/// The answers of one method to rays of one [`Spot`](crate::Spot) of the map, each against one
/// sphere, with t from 0 to infinity.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct MapCell {
    /// The column of the map: `above` or `inside` the sphere, or else the exponent k of the number
    /// of radii, 10ᵏ, from the ray's origin to the surface.
    pub column: String,
    /// The row n of the map: the ray starts 10⁻ⁿ radii from the surface, or its line passes the
    /// center at (1 ± 10⁻ⁿ) radii.
    pub row: i32,
    /// The number format of what the method takes and returns: `f64` or `f32`.
    #[serde(with = "PrecisionName")]
    pub precision: Precision,
    /// The name of the method.
    pub method: String,
    /// The number of wrong decisions of a thousand.
    pub wrong: usize,
    /// The largest error of t: above and inside a sphere as a part of t, elsewhere the distance
    /// from the right hit point, in radii. 0 if no hit was right.
    pub off: f64,
}

/// The number of pixels that one method gets wrong in the picture of a scene, compared with the
/// picture that exact arithmetic draws.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct WrongPixels {
    /// The name of the scene.
    pub scene: String,
    /// The number format of what the method takes and returns: `f64` or `f32`. The exact picture is
    /// the same for both.
    #[serde(with = "PrecisionName")]
    pub precision: Precision,
    /// The name of the method.
    pub method: String,
    /// The number of pixels of the picture.
    pub pixels: usize,
    /// The number of pixels that differ from the exact picture by more than one level (of 0–255) in
    /// some color.
    pub wrong: usize,
}

/// The time of one ray against one sphere, as the benchmark `clock` of the package `measure`
/// measured it.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Timing {
    /// The kind of loop that was timed, which says what `name` is:
    ///
    /// | `what` | `name` | |
    /// |---|---|---|
    /// | `method` | a method | one ray against one sphere: the throughput |
    /// | `record` | `half_b` | chapter 5's own function, with its record of the hit |
    /// | `ray` | `nothing` | the ray is made, and no sphere is tried |
    pub what: String,
    /// The method, or another name from the table above.
    pub name: String,
    /// The number format of the rays and spheres: `f64` or `f32`.
    #[serde(with = "PrecisionName")]
    pub precision: Precision,
    /// The name of the regime of the rays; `all_hits` for those rays of `book` that hit.
    #[serde(rename = "where")]
    pub place: String,
    /// The number of rays in one run of the loop, which is repeated until it fills a round.
    pub n: usize,
    /// The time of a ray in nanoseconds: the median over rounds, rounded no finer than half
    /// the distance of their quartiles.
    pub median_ns: f64,
    /// The time divided by that of `half_b` on the same rays in the same round: the median over
    /// rounds, rounded no finer than half the distance of their quartiles.
    pub ratio: f64,
}

impl Table<Timing> {
    /// Returns the first row, from the top, whose `what`, `name` and `place` are these, or `None`
    /// if there is none.
    pub fn find(&self, what: &str, name: &str, place: &str) -> Option<&Timing> {
        let same = |row: &&Timing| row.what == what && row.name == name && row.place == place;
        self.rows.iter().find(same)
    }

    /// Returns the quickest of the methods of this precision that `suffices` accepts, on the rays
    /// of `place`; of those that take a twentieth longer or less, which the next measurement may
    /// turn around, the first of [`METHODS`], which begin with the simplest. `None` if it accepts
    /// none, or those rays were not timed.
    pub fn quickest(
        &self,
        precision: Precision,
        place: &str,
        suffices: impl Fn(&Method) -> bool,
    ) -> Option<Method> {
        let right = METHODS
            .iter()
            .filter(|it| it.precision() == precision && suffices(it));
        let timed = right.filter_map(|it| Some((it, self.find("method", it.name, place)?.ratio)));
        let timed: Vec<(&Method, f64)> = timed.collect();
        let least = timed
            .iter()
            .map(|(_, ratio)| *ratio)
            .fold(f64::INFINITY, f64::min);
        let first = timed.into_iter().find(|(_, ratio)| *ratio <= 1.05 * least);
        first.map(|(method, _)| *method)
    }
}

/// Names the file of each type of row.
macro_rules! files {
    ($($row:ident: $file:literal,)*) => {
        $(impl Record for $row {
            const FILE: &str = $file;
        })*
    };
}

files! {
    Accuracy: "measured/accuracy.csv",
    MapCell: "measured/map.snap.csv",
    WrongPixels: "measured/scenes.snap.csv",
    Timing: "measured/timings.csv",
}

/// The names of precisions in files, for `Precision` of chapter 6, which has none.
#[derive(Deserialize, Serialize)]
#[serde(remote = "Precision")]
enum PrecisionName {
    #[serde(rename = "f64")]
    Double,
    #[serde(rename = "f32")]
    Single,
}
