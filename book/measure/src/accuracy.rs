//! Error statistics: how exact each method is, in each situation.
//!
//! The range of t is from 0 to infinity, and exact arithmetic knows the answers. A method
//! in `f32` is given cases whose numbers are `f32`s, and judged by the exact answer to
//! them: what rounding the scene costs is not its fault.
//!
//! Of the book all rays can be asked, so that the largest error is that of no lucky sample:
//! each pixel of its picture, 3840 wide, about each of its two spheres. Of the other
//! situations there is no end, and a number of random cases stands for them.

use common::rtweekend::*;
use figures::records::Accuracy;
use figures::table::Table;
use laws::oracle::{ExactCase, ExactRoot};
use rayon::prelude::*;
use speed_vs_accuracy::{Case, Method, Precision, REGIMES, Regime, SPHERES};

/// Measures the errors of `methods` against exact arithmetic, each in its own precision. Asks
/// `cases` random questions, chosen by `seed`, in each [`Regime`], a situation such as a far
/// sphere, and about `pixels` pixels of the book's picture, or about all 3840 × 2160 of them if
/// `pixels` is greater. Returns a row for each regime and method, those of the book first.
pub fn table(methods: &[Method], cases: usize, pixels: usize, seed: u64) -> Table<Accuracy> {
    let mut rows = Vec::new();
    for precision in Precision::ALL {
        rows.extend(of_the_book(methods, precision, pixels));
    }
    for regime in REGIMES.into_iter().skip_while(is_the_book) {
        for precision in Precision::ALL {
            let cases = regime.cases(precision, seed, cases);
            let found = errors_of(methods, precision, cases.len(), &|n| cases[n]);
            rows.extend(found.map(|(method, errors)| row(regime.name, method, errors)));
        }
    }
    rows.into()
}

fn is_the_book(regime: &Regime) -> bool {
    regime.name == Regime::BOOK.name
}

/// Returns three rows for each method of this precision: of both spheres together, of the ball, and
/// of the ground.
fn of_the_book(methods: &[Method], precision: Precision, pixels: usize) -> Vec<Accuracy> {
    let [ball, ground] = SPHERES.map(|(center, radius)| {
        errors_of(methods, precision, pixels.min(PIXELS), &|n| {
            let [column, row] = scattered(n);
            let ray = Camera::new(WIDTH).ray(column, row);
            Case::new(center, radius, ray).rounded(precision)
        })
    });
    let both = ball.zip(ground);
    both.flat_map(|((method, of_ball), (_, of_ground))| {
        let together = Errors::sum((of_ball.clone(), of_ground.clone())).sorted();
        [
            row(Regime::BOOK.name, method, together),
            row("book_ball", method, of_ball),
            row("book_ground", method, of_ground),
        ]
    })
    .collect()
}

/// The width of the book's picture when all its pixels are asked about.
const WIDTH: u32 = 3840;
/// The number of pixels of that picture, which is 3840 wide.
const PIXELS: usize = 3840 * 2160;

/// Returns the column and the row of a pixel of the picture. Each number below [`PIXELS`] gives
/// another one, spread over the picture from the start, so that the first few are as good a sample
/// as any.
fn scattered(number: usize) -> [u32; 2] {
    // It shares no factor with the number of pixels, so it leads to each of them once.
    const STEP: usize = 5_126_203;
    let pixel = (number * STEP % PIXELS) as u32;
    [pixel % WIDTH, pixel / WIDTH]
}

fn row(name: &str, method: &Method, found: Errors) -> Accuracy {
    Accuracy {
        regime: name.to_owned(),
        precision: method.precision(),
        method: method.name.to_owned(),
        cases: found.cases,
        hits: found.hits,
        wrong_per_million: found.wrong_per_million(),
        median_ulps: quantile(&found.ulps, 0.5),
        p999_ulps: quantile(&found.ulps, 0.999),
        largest_ulps: quantile(&found.ulps, 1.0),
        answers: found.answers,
    }
}

/// The errors of a method's answers.
#[derive(Clone, Default)]
struct Errors {
    cases: usize,
    /// The number of cases that have a root.
    hits: usize,
    /// Hits that should be misses, and misses that should be hits.
    wrong: usize,
    /// Errors of t in ulps where both say hit, in order of size.
    ulps: Vec<f64>,
    /// A sum of the first answers, [`FEW`] of them.
    answers: u64,
}

/// The number of answers that are kept as a sum of their bits. A test asks these questions again,
/// and notices when a method no longer answers as it did when it was measured.
const FEW: usize = 400;

impl Errors {
    fn wrong_per_million(&self) -> f64 {
        1e6 * self.wrong as f64 / self.cases as f64
    }

    /// Counts and measures what `method` answers to `case`, whose exact answer is `root`.
    fn note(&mut self, method: &Method, case: &Case, root: Option<ExactRoot>, is_kept: bool) {
        let answer = case.put_to(method, 0.0, f64::INFINITY);
        self.cases += 1;
        self.hits += usize::from(root.is_some());
        if is_kept {
            let bits = answer.map_or(0, f64::to_bits);
            self.answers = self.answers.wrapping_add(bits % 1_000_000_007);
        }
        match (answer, root) {
            (Some(t), Some(root)) => {
                self.ulps.push(ulps_off(root, method.precision(), t));
            }
            (None, None) => {}
            _ => self.wrong += 1,
        }
    }

    /// Joins the errors of two sets of cases; the lists are not in order then.
    fn sum((mut one, other): (Self, Self)) -> Self {
        one.cases += other.cases;
        one.hits += other.hits;
        one.wrong += other.wrong;
        one.ulps.extend(other.ulps);
        one.answers = one.answers.wrapping_add(other.answers);
        one
    }

    fn sorted(mut self) -> Self {
        self.ulps.par_sort_unstable_by(f64::total_cmp);
        self
    }
}

/// Finds the errors of each of `methods` that has this precision at the cases from 0 to `count`, on
/// all threads.
fn errors_of<'a>(
    methods: &'a [Method],
    precision: Precision,
    count: usize,
    case: &(dyn Fn(usize) -> Case + Sync),
) -> impl Iterator<Item = (&'a Method, Errors)> + use<'a> {
    let mut methods: Vec<&Method> = methods.iter().collect();
    methods.retain(|method| method.precision() == precision);
    let none = || vec![Errors::default(); methods.len()];
    let note = |mut found: Vec<Errors>, number| {
        let case = case(number);
        let exact = exact(&case).expect("the cases of a regime are finite");
        let root = exact.nearest_root_in(0.0, f64::INFINITY);
        for (found, method) in found.iter_mut().zip(&methods) {
            found.note(method, &case, root, number < FEW);
        }
        found
    };
    let both = |one: Vec<Errors>, other| one.into_iter().zip(other).map(Errors::sum).collect();
    let found: Vec<Errors> = (0..count)
        .into_par_iter()
        .fold(none, note)
        .reduce(none, both);
    methods
        .into_iter()
        .zip(found.into_iter().map(Errors::sorted))
}

/// Makes the exact equation of a question to the methods; `None` if a number of it is infinite or
/// NaN.
pub fn exact(case: &Case) -> Option<ExactCase> {
    ExactCase::of_finite(&laws::Case::new(case.center, case.radius, case.ray))
}

/// Returns the distance of `t` from the root, without sign, in ulps: units in the last place of a
/// number of this precision near the root. Infinite if `t` is infinite or NaN, or the distance
/// exceeds what an `f64` can hold.
pub fn ulps_off(root: ExactRoot, precision: Precision, t: f64) -> f64 {
    root.error_in_ulps(t) / (precision.epsilon() / f64::EPSILON)
}

/// Returns the number that the share `p` of the `sorted` numbers, from 0 to 1, does not exceed;
/// `None` if there are none.
fn quantile(sorted: &[f64], p: f64) -> Option<f64> {
    let rank = (p * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.saturating_sub(1)).copied()
}
