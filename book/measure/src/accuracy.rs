//! How exact each method is, in each situation.
//!
//! The cases are those of `speed_vs_accuracy::REGIMES`, with t from 0 to
//! infinity, and exact arithmetic knows the answers. A method in `f32` is given
//! cases whose numbers are `f32`s, and judged by the exact answer to them:
//! what rounding the scene costs is not its fault.
//!
//! What is found stands in two files in book/notes/measured, which a test keeps
//! as they are. They are comma-separated: a line of column names, then a row for
//! each method; no field is quoted. Numbers are rounded to three digits.
//!
//! `accuracy.snap.csv`: all levels of a regime together.
//!
//! | column | |
//! |---|---|
//! | `regime` | the name of the regime |
//! | `precision` | `f64` or `f32` |
//! | `method` | the name of the method |
//! | `cases` | how many there are |
//! | `hits` | how many of them have a root |
//! | `wrong_per_million` | hit where there is no root, or miss where there is one |
//! | `median_ulps` | error of t where both say hit, in units of the last place that the root has in this precision |
//! | `p999_ulps` | the error that 999 of 1000 do not exceed |
//! | `largest_ulps` | the largest error |
//! | `surface_median_radii` | how far the point at t is from the sphere, in radii |
//! | `surface_largest_radii` | the same at most |
//! | `nans` | answers that are NaN or infinite |
//!
//! `sweeps.snap.csv`: level by level, for the regimes `far` (10ᵏ radii away) and
//! `grazing` (passing at (1 ± 10⁻ᵏ) radii): `regime`, `level` (the k),
//! `precision`, `method`, `wrong_per_million`, `median_ulps`, `p999_ulps`.

use std::fmt::Write;
use std::thread;

use common::rtweekend::*;
use speed_vs_accuracy::{Case, METHODS, Method, Precision, REGIMES, Regime};

use laws::oracle::Exact;
use laws::truth::{Truth, three_digits};

/// How exact a method is.
#[derive(Clone, Debug, PartialEq)]
pub struct Accuracy {
    /// How many there were.
    pub cases: usize,
    /// How many of them have a root.
    pub hits: usize,
    /// Hits that should be misses, and misses that should be hits.
    pub wrong: usize,
    /// Answers that are NaN or infinite.
    pub nans: usize,
    /// Errors of t in ulps where both say hit, in order of size.
    pub ulps: Vec<f64>,
    /// How far the point at t is from the sphere, in radii, in order of size.
    pub surface: Vec<f64>,
}

/// The table of all methods in all regimes, in both precisions, from so many
/// cases in each.
pub fn table(count: usize, seed: u64) -> String {
    let head = "regime,precision,method,cases,hits,wrong_per_million,median_ulps,p999_ulps,\
                largest_ulps,surface_median_radii,surface_largest_radii,nans\n";
    let tasks = REGIMES
        .iter()
        .flat_map(|regime| Precision::ALL.map(|precision| (regime, precision)));
    head.to_owned()
        + &in_parallel(tasks, |(regime, precision)| {
            let cases = regime.cases(precision, seed, count);
            rows(precision, &cases, |text, method, found| {
                let [median, p999, largest] = [0.5, 0.999, 1.0].map(|p| quantile(&found.ulps, p));
                let [on, off] = [0.5, 1.0].map(|p| quantile(&found.surface, p));
                let _ = writeln!(
                    text,
                    "{},{},{},{},{},{},{median},{p999},{largest},{on},{off},{}",
                    regime.name,
                    precision.name(),
                    method.name,
                    found.cases,
                    found.hits,
                    found.wrong_per_million(),
                    found.nans,
                );
            })
        })
}

/// The table of errors against distance and against closeness to a tangent,
/// level by level.
pub fn sweeps(count: usize, seed: u64) -> String {
    let head = "regime,level,precision,method,wrong_per_million,median_ulps,p999_ulps\n";
    let levels = |regime: Regime, precision| {
        regime
            .levels(precision)
            .map(move |level| (regime, precision, level))
    };
    let tasks = [Regime::FAR, Regime::GRAZING]
        .into_iter()
        .flat_map(|regime| Precision::ALL.map(|precision| levels(regime, precision)))
        .flatten();
    head.to_owned()
        + &in_parallel(tasks, |(regime, precision, level)| {
            let cases = regime.cases_at(level, precision, seed, count);
            rows(precision, &cases, |text, method, found| {
                let [median, p999] = [0.5, 0.999].map(|p| quantile(&found.ulps, p));
                let _ = writeln!(
                    text,
                    "{},{level},{},{},{},{median},{p999}",
                    regime.name,
                    precision.name(),
                    method.name,
                    found.wrong_per_million(),
                );
            })
        })
}

/// Whether there is a root with t > 0.
pub fn has_root(case: &Case) -> bool {
    truths(&[*case], Precision::Double)[0].is_some()
}

impl Accuracy {
    fn wrong_per_million(&self) -> String {
        three_digits(1e6 * self.wrong as f64 / self.cases as f64)
    }
}

/// One text from many tasks, in their order, on as many threads as there are
/// processors.
pub(crate) fn in_parallel<T: Send>(
    tasks: impl Iterator<Item = T>,
    work: impl Fn(T) -> String + Sync,
) -> String {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let mut shares: Vec<Vec<(usize, T)>> = (0..threads).map(|_| Vec::new()).collect();
    for (number, task) in tasks.enumerate() {
        shares[number % threads].push((number, task));
    }
    let mut texts: Vec<(usize, String)> = thread::scope(|scope| {
        let work = &work;
        let workers: Vec<_> = shares
            .into_iter()
            .map(|share| {
                scope.spawn(move || {
                    let done = share.into_iter().map(|(number, task)| (number, work(task)));
                    done.collect::<Vec<_>>()
                })
            })
            .collect();
        let done = workers.into_iter().map(|worker| worker.join());
        done.flat_map(|share| share.expect("a task does not panic"))
            .collect()
    });
    texts.sort();
    texts.into_iter().map(|(_, text)| text).collect()
}

/// A row for each method of that precision.
fn rows(
    precision: Precision,
    cases: &[Case],
    write_row: impl Fn(&mut String, &Method, &Accuracy),
) -> String {
    let truths = truths(cases, precision);
    let mut text = String::new();
    for method in METHODS {
        if method.precision() == precision {
            write_row(&mut text, method, &judge(method, cases, &truths));
        }
    }
    text
}

fn truths(cases: &[Case], precision: Precision) -> Vec<Option<Truth>> {
    let truth = |case: &Case| Truth::of(&Exact::of(case), precision, 0.0, f64::INFINITY);
    cases.iter().map(truth).collect()
}

fn judge(method: &Method, cases: &[Case], truths: &[Option<Truth>]) -> Accuracy {
    let precision = method.precision();
    let mut found = Accuracy {
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

/// The value that the share `p` of `sorted` does not exceed, in three digits;
/// nothing if there is none.
fn quantile(sorted: &[f64], p: f64) -> String {
    let rank = (p * sorted.len() as f64).ceil() as usize;
    sorted
        .get(rank.saturating_sub(1))
        .map_or(String::new(), |&value| three_digits(value))
}
