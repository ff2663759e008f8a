//! What is known of each method: how fast, how exact.

use std::collections::BTreeMap;

use glam::DVec2;
use speed_vs_accuracy::{Method, find};

use super::data::Table;
use crate::svg::Svg;

/// What was measured of a method in a regime.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Measured {
    /// The regime.
    pub(super) regime: String,
    /// The method.
    pub(super) method: String,
    /// Whether it computes in `f32`.
    pub(super) single: bool,
    /// Nanoseconds for one test, the median.
    pub(super) nanoseconds: f64,
    /// How many times as long as `half_b`.
    pub(super) ratio: f64,
    /// The error that 999 of 1000 hits do not exceed, in ulps of its precision.
    pub(super) ulps: f64,
    /// Wrong decisions among a million.
    pub(super) wrong: f64,
}

/// Joins the file of errors and the file of times. Methods without a time are
/// left out.
pub(super) fn read(accuracy: &str, timings: &str) -> Result<Vec<Measured>, String> {
    let times = times(timings)?;
    let accuracy = Table::read("accuracy.snap.csv", accuracy)?;
    let mut all = Vec::new();
    for row in accuracy.rows() {
        let (regime, method) = (row.text("regime")?, row.text("method")?);
        let Some(&(nanoseconds, ratio)) = times.get(&(regime.to_owned(), method.to_owned())) else {
            continue;
        };
        all.push(Measured {
            regime: regime.to_owned(),
            method: method.to_owned(),
            single: row.text("precision")? == "f32",
            nanoseconds,
            ratio,
            ulps: row.number("p999_ulps")?,
            wrong: row.number("wrong_per_million")?,
        });
    }
    Ok(all)
}

/// Nanoseconds for one test and the ratio to `half_b`, by regime and method.
pub(super) type Times = BTreeMap<(String, String), (f64, f64)>;

/// The times of all methods that were measured one ray after the other.
pub(super) fn times(timings: &str) -> Result<Times, String> {
    let timings = Table::read("timings.csv", timings)?;
    let mut times = Times::new();
    for row in timings.rows() {
        if row.text("what")? == "method" {
            let key = (row.text("where")?.to_owned(), row.text("name")?.to_owned());
            times.insert(key, (row.number("median_ns")?, row.number("ratio")?));
        }
    }
    Ok(times)
}

impl Measured {
    /// How many decimal digits of t are right, but for one hit in a thousand.
    pub(super) fn digits(&self) -> f64 {
        digits(self.ulps, self.single)
    }

    /// What color and mark it has.
    pub(super) fn idea(&self) -> &'static str {
        idea(&self.method)
    }

    /// Draws its mark.
    pub(super) fn mark(&self, svg: &mut Svg, at: DVec2) {
        mark(svg, self.idea(), self.single, at);
        if self.wrong > 0.0 {
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

/// How many decimal digits an error of so many ulps leaves.
///
/// An ulp is at most 2⁻⁵² of a number in `f64`, and 2⁻²³ in `f32`. Nothing has
/// fewer than no digits.
pub(super) fn digits(ulps: f64, single: bool) -> f64 {
    let ulp = if single { -23.0 } else { -52.0 } * 2_f64.log10();
    (-ulp - ulps.max(0.5).log10()).max(0.0)
}

/// A method's mark: a square for the reference, a diamond for a certified one,
/// a disc for others, hollow for `f32`.
pub(super) fn mark(svg: &mut Svg, idea: &str, single: bool, at: DVec2) {
    let filling = if single { "hollow" } else { "solid" };
    let class = format!("{idea} {filling}");
    match idea {
        "reference" => svg.rect(&class, at - 5.0, DVec2::splat(10.0)),
        "certain" => {
            let corner = |x, y| at + DVec2::new(x, y);
            svg.path(
                &class,
                &[
                    corner(0.0, -7.0),
                    corner(7.0, 0.0),
                    corner(0.0, 7.0),
                    corner(-7.0, 0.0),
                ],
            );
        }
        _ => svg.circle(&class, at, if single { 4.0 } else { 4.5 }),
    }
}

/// The mark of a wrong decision.
pub(super) fn cross(svg: &mut Svg, at: DVec2) {
    for (x, y) in [(7.0, 7.0), (7.0, -7.0)] {
        svg.line("wrong line", at - DVec2::new(x, y), at + DVec2::new(x, y));
    }
}

/// A number of ulps, or of wrong decisions, in few characters.
pub(super) fn short(value: f64) -> String {
    match value {
        _ if value.is_nan() => "none".to_owned(),
        100_000.0.. => {
            let exponent = value.log10().floor() as i32;
            let digits = super::sweep::raised(exponent);
            format!("{:.1}·10{digits}", value / 10_f64.powi(exponent))
        }
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        _ => crate::svg::number(value),
    }
}
