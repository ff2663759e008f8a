//! Interleaved timing: all candidates in turns, with median and spread.
//!
//! Other programs disturb a clock, and a processor changes its pace. So nothing
//! is measured at a stretch: in each round everyone of a group has a short turn,
//! and is compared with the first one in the same round: what is disturbed is a round,
//! and the median of all does not change.

use std::time::{Duration, Instant};

use figures::records::Timing;
use speed_vs_accuracy::Precision;

use crate::spread::Spread;

/// Those that take turns. The first is what the others are compared with.
pub struct Group(pub Vec<Runner>);

/// Something whose time is taken.
pub struct Runner {
    /// The row without its times.
    pub row: Timing,
    /// Asks all questions of the row once.
    pub run: Box<dyn FnMut()>,
}

/// How long to take.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// How many turns everyone has.
    pub rounds: usize,
    /// How long a turn should be at least.
    pub turn: Duration,
}

impl Effort {
    /// A minute or two for all that the benchmark `clock` measures, or if it must be
    /// `quick`, seconds.
    pub fn new(quick: bool) -> Self {
        let (rounds, microseconds) = if quick { (11, 500) } else { (101, 1000) };
        let turn = Duration::from_micros(microseconds);
        Self { rounds, turn }
    }
}

impl Runner {
    /// Someone whose times are not yet taken.
    pub fn new(
        [what, name, place]: [&str; 3],
        precision: Precision,
        n: usize,
        run: impl FnMut() + 'static,
    ) -> Self {
        let row = Timing {
            what: what.to_owned(),
            name: name.to_owned(),
            precision,
            place: place.to_owned(),
            n,
            median_ns: f64::NAN,
            ratio: f64::NAN,
            instructions: None,
        };
        let run = Box::new(run);
        Self { row, run }
    }

    /// Nanoseconds for one test, from so many runs.
    fn take_turn(&mut self, runs: usize) -> f64 {
        let start = Instant::now();
        for _ in 0..runs {
            (self.run)();
        }
        1e9 * start.elapsed().as_secs_f64() / (runs * self.row.n) as f64
    }

    /// How many runs make a turn. The first of them also warm up.
    fn runs_in(&mut self, turn: Duration) -> usize {
        let mut runs = 1;
        loop {
            let start = Instant::now();
            self.take_turn(runs);
            if start.elapsed() >= turn {
                return runs;
            }
            runs *= 2;
        }
    }
}

impl Group {
    /// The times of each in each round, in nanoseconds for one test: a list for
    /// everyone, in order.
    pub fn times(&mut self, effort: &Effort) -> Vec<Vec<f64>> {
        let Self(runners) = self;
        let runs: Vec<usize> = runners
            .iter_mut()
            .map(|runner| runner.runs_in(effort.turn))
            .collect();
        let mut times = vec![Vec::new(); runners.len()];
        for _ in 0..effort.rounds {
            for ((runner, &runs), times) in runners.iter_mut().zip(&runs).zip(&mut times) {
                times.push(runner.take_turn(runs));
            }
        }
        times
    }
}

/// The rows of all runners, in order.
pub fn run(groups: Vec<Group>, effort: &Effort) -> Vec<Timing> {
    let rows = groups.into_iter().flat_map(|mut group| {
        let times = group.times(effort);
        let first = times[0].clone();
        let rows = group.0.into_iter().zip(times);
        rows.map(move |(runner, times)| filled_in(runner.row, times, &first))
    });
    rows.collect()
}

fn filled_in(row: Timing, times: Vec<f64>, first: &[f64]) -> Timing {
    let ratio = ratio(&times, first).agreed();
    Timing {
        median_ns: Spread::of(times).agreed(),
        ratio,
        ..row
    }
}

/// How many times as long as the `other` it took in the same round.
pub fn ratio(times: &[f64], other: &[f64]) -> Spread {
    let ratios = times.iter().zip(other).map(|(time, other)| time / other);
    Spread::of(ratios.collect())
}
