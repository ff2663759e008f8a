//! Error statistics: how exact each method is, in each situation.
//!
//! The cases are those of `speed_vs_accuracy::REGIMES`, with t from 0 to
//! infinity, and exact arithmetic knows the answers. A method in `f32` is given
//! cases whose numbers are `f32`s, and judged by the exact answer to them:
//! what rounding the scene costs is not its fault.

use common::rtweekend::*;
use figures::records::{Accuracy, Level};
use figures::table::Table;
use laws::oracle::Exact;
use laws::truth::Truth;
use rayon::prelude::*;
use speed_vs_accuracy::{Case, METHODS, Method, Precision, REGIMES, Regime};

/// All methods in all regimes, in both precisions, from so many cases each.
pub fn table(count: usize, seed: u64) -> Table<Accuracy> {
    let tasks: Vec<(Regime, Precision)> = REGIMES
        .into_iter()
        .flat_map(|regime| Precision::ALL.map(|precision| (regime, precision)))
        .collect();
    let rows = tasks.into_par_iter().flat_map_iter(|(regime, precision)| {
        let cases = regime.cases(precision, seed, count);
        let row = move |(method, found): (&Method, Errors)| Accuracy {
            regime: regime.name.to_owned(),
            precision,
            method: method.name.to_owned(),
            cases: count,
            hits: found.hits,
            wrong_per_million: found.wrong_per_million(),
            median_ulps: quantile(&found.ulps, 0.5),
            p999_ulps: quantile(&found.ulps, 0.999),
            largest_ulps: quantile(&found.ulps, 1.0),
            surface_median_radii: quantile(&found.surface, 0.5),
            surface_largest_radii: quantile(&found.surface, 1.0),
            nans: found.nans,
        };
        of_all_methods(precision, cases).map(row)
    });
    rows.collect::<Vec<_>>().into()
}

/// Errors against distance and against closeness to a tangent, level by level.
pub fn sweeps(count: usize, seed: u64) -> Table<Level> {
    let levels = |regime: Regime, precision| {
        let levels = regime.levels(precision);
        levels.map(move |level| (regime, precision, level))
    };
    let tasks: Vec<(Regime, Precision, i32)> = [Regime::FAR, Regime::GRAZING]
        .into_iter()
        .flat_map(|regime| Precision::ALL.map(|precision| levels(regime, precision)))
        .flatten()
        .collect();
    let rows = tasks.into_par_iter().flat_map_iter(|task| {
        let (regime, precision, level) = task;
        let cases = regime.cases_at(level, precision, seed, count);
        let row = move |(method, found): (&Method, Errors)| Level {
            regime: regime.name.to_owned(),
            level,
            precision,
            method: method.name.to_owned(),
            wrong_per_million: found.wrong_per_million(),
            median_ulps: quantile(&found.ulps, 0.5),
            p999_ulps: quantile(&found.ulps, 0.999),
        };
        of_all_methods(precision, cases).map(row)
    });
    rows.collect::<Vec<_>>().into()
}

/// Whether there is a root with t > 0.
pub fn has_root(case: &Case) -> bool {
    truths(&[*case], Precision::Double)[0].is_some()
}

/// What is wrong with the answers of a method.
struct Errors {
    cases: usize,
    /// How many cases have a root.
    hits: usize,
    /// Hits that should be misses, and misses that should be hits.
    wrong: usize,
    /// Answers that are NaN or infinite.
    nans: usize,
    /// Errors of t in ulps where both say hit, in order of size.
    ulps: Vec<f64>,
    /// How far the point at t is from the sphere, in radii, in order of size.
    surface: Vec<f64>,
}

impl Errors {
    fn wrong_per_million(&self) -> f64 {
        1e6 * self.wrong as f64 / self.cases as f64
    }
}

/// The errors of each method of that precision.
fn of_all_methods(
    precision: Precision,
    cases: Vec<Case>,
) -> impl Iterator<Item = (&'static Method, Errors)> {
    let truths = truths(&cases, precision);
    let methods = METHODS.iter();
    methods
        .filter(move |method| method.precision() == precision)
        .map(move |method| (method, judge(method, &cases, &truths)))
}

fn truths(cases: &[Case], precision: Precision) -> Vec<Option<Truth>> {
    let truth = |case: &Case| Truth::of(&Exact::of(case), precision, 0.0, f64::INFINITY);
    cases.iter().map(truth).collect()
}

fn judge(method: &Method, cases: &[Case], truths: &[Option<Truth>]) -> Errors {
    let precision = method.precision();
    let mut found = Errors {
        cases: cases.len(),
        hits: truths.iter().flatten().count(),
        wrong: 0,
        nans: 0,
        ulps: Vec::new(),
        surface: Vec::new(),
    };
    for (case, truth) in cases.iter().zip(truths) {
        match (case.put_to(method, 0.0, f64::INFINITY), truth) {
            (Some(t), _) if !t.is_finite() => found.nans += 1,
            (Some(t), Some(truth)) => {
                found.ulps.push(truth.error_in_ulps(t));
                found.surface.push(off_the_surface(case, t, precision));
            }
            (None, None) => {}
            _ => found.wrong += 1,
        }
    }
    found.ulps.sort_by(f64::total_cmp);
    found.surface.sort_by(f64::total_cmp);
    found
}

/// How far the point at `t`, computed as a program would, is from the sphere, in
/// radii.
fn off_the_surface(case: &Case, t: f64, precision: Precision) -> f64 {
    let point = case.point(t, precision);
    // The direction does not matter here.
    let Some(exact) = Exact::of_finite(&case.with_ray(point, Vec3::NEG_Z)) else {
        return f64::INFINITY;
    };
    // With x = |P − C|/r, the margin is (x² − 1) / (x² + 1).
    let margin = exact.origin_margin();
    let above_one = 2.0 * margin / (1.0 - margin);
    (above_one / ((1.0 + above_one).sqrt() + 1.0)).abs()
}

/// The value that the share `p` of `sorted` does not exceed, if there is one.
fn quantile(sorted: &[f64], p: f64) -> Option<f64> {
    let rank = (p * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.saturating_sub(1)).copied()
}
