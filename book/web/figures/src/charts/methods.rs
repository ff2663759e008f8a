//! Scatter points: how fast each method is, and how exact; and what their marks mean.

use glam::DVec2;
use speed_vs_accuracy::Precision::{Double, Single};
use speed_vs_accuracy::{Method, Precision, find};

use crate::records::{Accuracy, Timing};
use crate::svg::{Anchor, Svg, spot};
use crate::table::Table;

/// How exact a method is in a regime, and how long it takes.
pub(super) type Measured = (Accuracy, Timing);

/// Joins the file of errors and the file of times. Methods without a time are
/// left out.
pub(super) fn read(accuracy: &str, timings: &str) -> Result<Vec<Measured>, String> {
    let times = Table::<Timing>::read(timings)?;
    let rows = Table::<Accuracy>::read(accuracy)?.rows.into_iter();
    let join = |row: Accuracy| {
        let time = times.find("method", &row.method, &row.regime)?.clone();
        Some((row, time))
    };
    Ok(rows.filter_map(join).collect())
}

/// The same methods in lanes: many rays against one sphere.
pub(super) fn in_lanes(shown: &[Measured], timings: &str) -> Result<Vec<Measured>, String> {
    let times = Table::<Timing>::read(timings)?;
    let join = |(row, _): &Measured| {
        let time = times.find("rays", &row.method, &row.regime)?.clone();
        Some((row.clone(), time))
    };
    Ok(shown.iter().filter_map(join).collect())
}

/// A method on a chart of speed against accuracy.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Point {
    /// Its name.
    pub(super) method: String,
    /// What it computes with.
    pub(super) precision: Precision,
    /// How many nanoseconds a test takes.
    pub(super) ns: f64,
    /// How many decimal digits are right.
    pub(super) digits: f64,
    /// Whether it gets a cross.
    pub(super) is_wrong: bool,
    /// Whether a block of questions was asked at once, in SIMD lanes.
    pub(super) in_lanes: bool,
}

impl Point {
    /// What was measured: with so many digits right, but for one hit in a thousand.
    pub(super) fn of((row, time): &Measured) -> Self {
        Self {
            method: row.method.clone(),
            precision: row.precision,
            ns: time.median_ns,
            digits: digits(row.p999_ulps, row.precision),
            is_wrong: row.wrong_per_million > 0.0,
            in_lanes: time.what == "rays",
        }
    }

    /// What color and mark it has.
    pub(super) fn idea(&self) -> &'static str {
        idea(&self.method)
    }

    /// Draws its mark.
    pub(super) fn mark(&self, svg: &mut Svg, at: DVec2) {
        if self.in_lanes {
            lanes(svg, self.idea(), at);
        }
        mark(svg, self.idea(), self.precision, at);
        if self.is_wrong {
            cross(svg, at);
        }
    }
}

/// What color and mark the method of that name has.
pub(super) fn idea(method: &str) -> &'static str {
    match find(method) {
        Some(method) if method.name == Method::REFERENCE.name => "reference",
        Some(method) if method.is_certified => "certain",
        _ => "ink",
    }
}

/// How many decimal digits an error of so many ulps leaves, of which one is at most the
/// epsilon of a number. Nothing has fewer than no digits, and what never hit has none.
pub(super) fn digits(ulps: Option<f64>, precision: Precision) -> f64 {
    let left = |ulps: f64| -(precision.epsilon() * ulps.max(0.5)).log10();
    ulps.map_or(0.0, left).max(0.0)
}

/// A method's mark: a square for the reference, a diamond for a certified one,
/// a disc for others, hollow for `f32`.
pub(super) fn mark(svg: &mut Svg, idea: &str, precision: Precision, at: DVec2) {
    let (filling, radius) = match precision {
        Double => ("solid", 4.5),
        Single => ("hollow", 4.0),
    };
    let class = format!("{idea} {filling}");
    match idea {
        "reference" => svg.rect(&class, at - 5.0, DVec2::splat(10.0)),
        "certain" => {
            // The top twice: a hollow one has four sides as well.
            let corners = [DVec2::NEG_Y, DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
            svg.path(&class, &corners.map(|corner| at + 7.0 * corner));
        }
        _ => svg.circle(&class, at, radius),
    }
}

/// The mark of a wrong decision.
pub(super) fn cross(svg: &mut Svg, at: DVec2) {
    for way in [spot(7.0, 7.0), spot(7.0, -7.0)] {
        svg.line("wrong line", at - way, at + way);
    }
}

/// What a mark has beside it if questions were asked in lanes: a line to either side.
pub(super) fn lanes(svg: &mut Svg, idea: &str, at: DVec2) {
    svg.line(
        &format!("{idea} line"),
        at - spot(12.0, 0.0),
        at + spot(12.0, 0.0),
    );
}

/// Explains the marks at the top of a chart, on two lines.
pub(super) fn legend(svg: &mut Svg) {
    for (x, idea, precision, words) in [
        (4.0, "ink", Double, "f64"),
        (58.0, "ink", Single, "f32"),
        (112.0, "reference", Double, "half_b, as in the chapters"),
        (309.0, "certain", Double, "certified"),
    ] {
        mark(svg, idea, precision, spot(x + 8.0, 13.5));
        svg.small_label("ink", spot(x + 20.0, 18.0), Anchor::Start, words);
    }
    cross(svg, spot(12.0, 33.5));
    let words = "confuses some hits and misses";
    svg.small_label("ink", spot(24.0, 38.0), Anchor::Start, words);
}
