//! Errors against exact arithmetic: how many decisions of each method are wrong, and
//! how many units in the last place (ulps) its t is off.
//!
//! The questions are those of `speed_vs_accuracy::REGIMES`, with t from 0 to
//! infinity, and exact arithmetic knows the answers. A method in `f32` is asked
//! questions whose numbers are `f32`s, and judged by the exact answer to them:
//! what rounding the scene costs is not its fault.

use common::rtweekend::*;
use figures::records::{Accuracy, Level};
use figures::table::Table;
use laws::oracle::Exact;
use laws::truth::Truth;
use rayon::prelude::*;
use speed_vs_accuracy::{Case, METHODS, Method, Precision, REGIMES, Regime, find_regime};

/// All methods in all regimes, in both precisions, from so many questions to each.
pub fn table(cases: usize, seed: u64) -> Table<Accuracy> {
    let tasks: Vec<(Regime, Precision)> = REGIMES
        .into_iter()
        .flat_map(|regime| PRECISIONS.map(|precision| (regime, precision)))
        .collect();
    let rows = tasks.into_par_iter().flat_map_iter(|(regime, precision)| {
        let questions = regime.questions(precision, seed, cases);
        let row = move |(method, found): (&Method, Errors)| Accuracy {
            regime: regime.name.to_owned(),
            precision,
            method: method.name.to_owned(),
            cases,
            hits: found.hits,
            wrong_per_million: found.wrong_per_million(),
            median_ulps: quantile(&found.ulps, 0.5),
            p999_ulps: quantile(&found.ulps, 0.999),
            largest_ulps: quantile(&found.ulps, 1.0),
            surface_median_radii: quantile(&found.surface, 0.5),
            surface_largest_radii: quantile(&found.surface, 1.0),
            nans: found.nans,
        };
        of_all_methods(precision, questions).map(row)
    });
    rows.collect::<Vec<_>>().into()
}

/// Errors against distance and against closeness to a tangent, level by level.
pub fn sweeps(cases: usize, seed: u64) -> Table<Level> {
    let levels = |regime: Regime, precision| {
        let levels = regime.levels(precision);
        levels.map(move |level| (regime, precision, level))
    };
    let tasks: Vec<(Regime, Precision, i32)> = ["far", "grazing"]
        .map(|name| find_regime(name).expect("it is the name of a regime"))
        .into_iter()
        .flat_map(|regime| PRECISIONS.map(|precision| levels(regime, precision)))
        .flatten()
        .collect();
    let rows = tasks.into_par_iter().flat_map_iter(|task| {
        let (regime, precision, level) = task;
        let questions = regime.questions_at(level, precision, seed, cases);
        let row = move |(method, found): (&Method, Errors)| Level {
            regime: regime.name.to_owned(),
            level,
            precision,
            method: method.name.to_owned(),
            wrong_per_million: found.wrong_per_million(),
            median_ulps: quantile(&found.ulps, 0.5),
            p999_ulps: quantile(&found.ulps, 0.999),
        };
        of_all_methods(precision, questions).map(row)
    });
    rows.collect::<Vec<_>>().into()
}

/// Whether there is a root with t > 0.
pub fn has_root(question: &Case) -> bool {
    truths(&[*question], Precision::Double)[0].is_some()
}

const PRECISIONS: [Precision; 2] = [Precision::Double, Precision::Single];

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
    questions: Vec<Case>,
) -> impl Iterator<Item = (&'static Method, Errors)> {
    let truths = truths(&questions, precision);
    let methods = METHODS.iter();
    methods
        .filter(move |method| Precision::of(method) == precision)
        .map(move |method| (method, judge(method, &questions, &truths)))
}

fn truths(questions: &[Case], precision: Precision) -> Vec<Option<Truth>> {
    let truth = |question: &Case| {
        let exact = Exact::new(question.center, question.radius, &question.ray)
            .expect("regimes make finite questions");
        Truth::of(&exact, precision, 0.0, f64::INFINITY)
    };
    questions.iter().map(truth).collect()
}

fn judge(method: &Method, questions: &[Case], truths: &[Option<Truth>]) -> Errors {
    let precision = Precision::of(method);
    let mut found = Errors {
        cases: questions.len(),
        hits: truths.iter().flatten().count(),
        wrong: 0,
        nans: 0,
        ulps: Vec::new(),
        surface: Vec::new(),
    };
    for (question, truth) in questions.iter().zip(truths) {
        match (question.put_to(method, 0.0, f64::INFINITY), truth) {
            (Some(t), _) if !t.is_finite() => found.nans += 1,
            (Some(t), Some(truth)) => {
                found.ulps.push(truth.error_in_ulps(t));
                found.surface.push(off_the_surface(question, t, precision));
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
fn off_the_surface(question: &Case, t: f64, precision: Precision) -> f64 {
    let point = question.point(t, precision);
    // The direction does not matter here.
    let ray = Ray::new(point, Vec3::NEG_Z);
    let Some(exact) = Exact::new(question.center, question.radius, &ray) else {
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
