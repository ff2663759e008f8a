//! Interleaved timing: all candidates in turns, with median and spread.
//!
//! Other programs disturb a clock, and a processor changes its pace. So nothing
//! is measured at a stretch: in each round everyone of a contest has a short turn,
//! and is compared with the first one in the same round: what is disturbed is a round,
//! and the median of all does not change.

use std::time::{Duration, Instant};

use figures::records::Timing;
use speed_vs_accuracy::Precision;

use crate::spread::Spread;

/// Runners that take turns. The others are compared with the first.
pub struct Contest(pub Vec<Contestant>);

/// Something whose time is taken.
pub struct Contestant {
    /// The row without its times.
    pub row: Timing,
    /// Asks all questions of the row once.
    pub run: Box<dyn FnMut()>,
}

/// The length of a measurement.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// The number of turns that each contestant has.
    pub rounds: usize,
    /// The least length of a turn.
    pub turn: Duration,
}

impl Effort {
    /// Chooses a minute or two for all that the benchmark `clock` measures, or seconds if it must
    /// be `quick`.
    pub fn new(quick: bool) -> Self {
        let (rounds, microseconds) = if quick { (11, 500) } else { (101, 1000) };
        let turn = Duration::from_micros(microseconds);
        Self { rounds, turn }
    }
}

impl Contestant {
    /// Makes a contestant whose times are not yet taken. `key` says what, by which
    /// method and where.
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

    /// Runs the loop so often, and returns the nanoseconds of one test.
    fn take_turn(&mut self, runs: usize) -> f64 {
        let start = Instant::now();
        for _ in 0..runs {
            (self.run)();
        }
        1e9 * start.elapsed().as_secs_f64() / (runs * self.row.n) as f64
    }

    /// Counts the runs that make a turn. The first of them also warm up.
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

impl Contest {
    /// Takes all times, in turns: for each contestant, in order, the nanoseconds of
    /// one test in each round.
    pub fn times(&mut self, effort: &Effort) -> Vec<Vec<f64>> {
        let Self(contestants) = self;
        let runs: Vec<usize> = contestants
            .iter_mut()
            .map(|contestant| contestant.runs_in(effort.turn))
            .collect();
        let mut times = vec![Vec::new(); contestants.len()];
        for _ in 0..effort.rounds {
            for ((contestant, &runs), times) in contestants.iter_mut().zip(&runs).zip(&mut times) {
                times.push(contestant.take_turn(runs));
            }
        }
        times
    }
}

/// Lets all contests run, and returns the rows of all contestants, in order.
pub fn run_all(contests: Vec<Contest>, effort: &Effort) -> Vec<Timing> {
    let rows = contests.into_iter().flat_map(|mut contest| {
        let times = contest.times(effort);
        let first = times[0].clone();
        let rows = contest.0.into_iter().zip(times);
        rows.map(move |(contestant, times)| filled_in(contestant.row, times, &first))
    });
    rows.collect()
}

fn filled_in(row: Timing, times: Vec<f64>, first: &[f64]) -> Timing {
    let ratio = spread_of_ratios(&times, first).rounded_median();
    Timing {
        median_ns: Spread::of(times).rounded_median(),
        ratio,
        ..row
    }
}

/// Returns the spread of `times` divided by the times of the `other` in the same
/// round.
pub fn spread_of_ratios(times: &[f64], other: &[f64]) -> Spread {
    let ratios = times.iter().zip(other).map(|(time, other)| time / other);
    Spread::of(ratios.collect())
}
