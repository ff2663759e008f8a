//! Records: the rows of the files that hold what was measured. Charts are drawn
//! from them.
//!
//! What was asked a few thousand times, a test keeps as it is; what was asked millions
//! of times, or measured by a clock, the benchmarks of the package `measure` record
//! anew.

use serde::{Deserialize, Serialize};
use speed_vs_accuracy::Precision;

use crate::table::{Record, Table};

/// The accuracy of a method in a regime, all levels together, with t from 0 to
/// infinity. The regime `book` is each pixel of the book's picture, `book_ball` and
/// `book_ground` are its two spheres by themselves.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Accuracy {
    /// The name of the regime.
    pub regime: String,
    /// The numbers that the method computes with: `f64` or `f32`.
    #[serde(with = "PrecisionName")]
    pub precision: Precision,
    /// The name of the method.
    pub method: String,
    /// The number of questions.
    pub cases: usize,
    /// The number of questions that have a root.
    pub hits: usize,
    /// Hits where there is no root, and misses where there is one.
    pub wrong_per_million: f64,
    /// The error of t where both say hit, in units of the last place that the
    /// root has in this precision. None where nothing was hit, as with those below.
    pub median_ulps: Option<f64>,
    /// The error that 999 of 1000 do not exceed.
    pub p999_ulps: Option<f64>,
    /// The largest error.
    pub largest_ulps: Option<f64>,
    /// The distance of the point at t from the sphere, in radii: the median.
    pub surface_median_radii: Option<f64>,
    /// The greatest such distance.
    pub surface_largest_radii: Option<f64>,
    /// A sum of the first few answers, by which a test knows them again.
    pub answers: u64,
}

/// The case that comes closest to an error bound of chapter 6, of all that a search has
/// found: its witness. A smaller constant in the code answers it wrongly.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Tightness {
    /// The letter of the proof, and which side of it.
    pub bound: String,
    /// The unit of the three numbers that follow: `u` = 2⁻⁵³, `u2` = u², the `bound` that
    /// is computed with the numbers; `log2` if they are exponents of two.
    pub unit: String,
    /// The constant in the code.
    pub constant: f64,
    /// The least for which there is a proof.
    pub proved: f64,
    /// Below this, the witness is answered wrongly.
    pub attained: f64,
    /// Center, radius, origin and direction, with all their digits.
    pub witness: String,
    /// The lower end of the range of t, excluded.
    pub t_min: f64,
    /// The upper end of the range of t, excluded.
    pub t_max: f64,
}

/// The accuracy of a method at one level of a regime.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Level {
    /// `far`.
    pub regime: String,
    /// The k of 10ᵏ radii away.
    pub level: i32,
    /// As in [`Accuracy`], like all that follow.
    #[serde(with = "PrecisionName")]
    pub precision: Precision,
    /// The name of the method.
    pub method: String,
    /// Hits where there is no root, and misses where there is one.
    pub wrong_per_million: f64,
    /// The error of t that half of the hits do not exceed.
    pub median_ulps: Option<f64>,
    /// The error of t that 999 of 1000 hits do not exceed.
    pub p999_ulps: Option<f64>,
    /// A sum of the first few answers, by which a test knows them again.
    pub answers: u64,
}

/// The number of pixels of a scene that a method gets wrong.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct WrongPixels {
    /// The name of the scene.
    pub scene: String,
    /// The precision of the method, and of the exact picture.
    #[serde(with = "PrecisionName")]
    pub precision: Precision,
    /// The name of the method.
    pub method: String,
    /// The number of pixels.
    pub pixels: usize,
    /// The number of those that are more than one level off, in some component, from the exact
    /// picture.
    pub wrong: usize,
}

/// The time of one test, or of one ray, as the benchmark `clock` measured it.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Timing {
    /// The kind of loop that was timed.
    ///
    /// | `what` | `name` | |
    /// |---|---|---|
    /// | `method` | a method | one ray against one sphere: the throughput |
    /// | `rays` | a method | a block of rays against one sphere, in SIMD lanes |
    /// | `limit` | `divider`, `memory` | in lanes, a root and two divisions; or only the numbers of a ray |
    /// | `record` | `half_b` | chapter 5's own function, with its record of the hit |
    /// | `ray` | `nothing` | the ray is made, and nothing is asked |
    pub what: String,
    /// A method.
    pub name: String,
    /// The numbers that it computes with.
    #[serde(with = "PrecisionName")]
    pub precision: Precision,
    /// A regime, or `all_hits`: the rays of `book` that hit.
    #[serde(rename = "where")]
    pub place: String,
    /// The number of questions.
    pub n: usize,
    /// Nanoseconds: half of the rounds took less, half more. It has the digits on which
    /// half of the rounds agree, as `ratio` has.
    pub median_ns: f64,
    /// The median, over rounds, of the time divided by that of `half_b` on the same rays in
    /// the same round.
    pub ratio: f64,
    /// Instructions, as valgrind counts them. Only of `book` and `all_hits`.
    pub instructions: Option<f64>,
}

impl Table<Timing> {
    /// Returns the row of that kind, name and place.
    pub fn find(&self, what: &str, name: &str, place: &str) -> Option<&Timing> {
        let same = |row: &&Timing| row.what == what && row.name == name && row.place == place;
        self.rows.iter().find(same)
    }
}

/// The times of our program and of the C++ program for one picture, as the benchmark
/// `race` measured them. Whole programs are timed from the start of each
/// process to its end.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Race {
    /// The picture.
    pub chapter: String,
    /// Its width in pixels.
    pub width: u32,
    /// The place of the text, `nowhere`; or `traced`, if there was none: then each kept the
    /// bytes of the picture in memory, on one thread.
    pub to: String,
    /// Milliseconds of our program: half of the runs took less, half more.
    pub rust_median_ms: f64,
    /// Milliseconds of our quickest run.
    pub rust_least_ms: f64,
    /// Milliseconds of our slowest run.
    pub rust_greatest_ms: f64,
    /// Milliseconds of the C++ program.
    pub cpp_median_ms: f64,
    /// Milliseconds of its quickest run.
    pub cpp_least_ms: f64,
    /// Milliseconds of its slowest run.
    pub cpp_greatest_ms: f64,
    /// The time of the C++ program divided by ours, by the medians.
    pub ratio: f64,
}

/// Says in which file the rows of a type are.
macro_rules! files {
    ($($row:ident: $file:literal,)*) => {
        $(impl Record for $row {
            const FILE: &str = $file;
        })*
    };
}

files! {
    Accuracy: "measured/accuracy.csv",
    Tightness: "measured/tightness.csv",
    Level: "measured/sweeps.csv",
    WrongPixels: "measured/scenes.snap.csv",
    Timing: "measured/timings.csv",
    Race: "speed/heats.csv",
}

/// A precision as it is written: chapter 6, whose type it is, writes no files.
#[derive(Deserialize, Serialize)]
#[serde(remote = "Precision")]
enum PrecisionName {
    #[serde(rename = "f64")]
    Double,
    #[serde(rename = "f32")]
    Single,
}
