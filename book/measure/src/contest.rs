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

/// Loops whose times are taken in turns, round by round; one at least. The first of them is the
/// reference that the others are compared with.
pub type Contest = Vec<Contestant>;

/// A loop whose time is taken in a [`Contest`].
pub struct Contestant {
    /// The row of the table of times that the loop fills; its times are NaN until they are taken.
    pub row: Timing,
    /// The loop: asks each of the row's `n` questions once.
    pub run: Box<dyn FnMut()>,
}

/// The length of a measurement: how many turns a loop has, and how long each is.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// The number of turns of each contestant, 1 or more.
    pub rounds: usize,
    /// The time that a turn takes at least.
    pub turn: Duration,
}

impl Effort {
    /// Returns 101 turns of a millisecond, or 11 of half a millisecond if the measurement has to be
    /// `quick`. The benchmark `clock` takes a minute or two then, or some seconds.
    pub fn new(quick: bool) -> Self {
        let (rounds, microseconds) = if quick { (11, 500) } else { (101, 1000) };
        let turn = Duration::from_micros(microseconds);
        Self { rounds, turn }
    }
}

impl Contestant {
    /// Makes a contestant from a loop `run`, which asks `n` questions in each call. The three texts
    /// become the columns `what`, `name` and `place` of its row: the kind of question, the method,
    /// and the regime or the scene.
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
        };
        let run = Box::new(run);
        Self { row, run }
    }

    /// Runs the loop `runs` times, and returns the nanoseconds of one question.
    fn take_turn(&mut self, runs: usize) -> f64 {
        let start = Instant::now();
        for _ in 0..runs {
            (self.run)();
        }
        1e9 * start.elapsed().as_secs_f64() / (runs * self.row.n) as f64
    }

    /// Returns how many runs of the loop fill a turn: the least power of two. The first runs also
    /// warm up.
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

/// Lets one contest after the other run. In each round every contestant has a turn. Returns the
/// rows of all contestants, in order, with the median of their times, and of their ratios to the
/// first of their contest in the same round.
///
/// # Panics
/// If a contest has no contestant, or `effort` no rounds.
pub fn run_all(contests: impl Iterator<Item = Contest>, effort: &Effort) -> Vec<Timing> {
    let run = |mut contest: Contest| {
        let fill = |it: &mut Contestant| it.runs_in(effort.turn);
        let runs: Vec<usize> = contest.iter_mut().map(fill).collect();
        let mut times = vec![Vec::new(); contest.len()];
        for _ in 0..effort.rounds {
            for ((contestant, &runs), times) in contest.iter_mut().zip(&runs).zip(&mut times) {
                times.push(contestant.take_turn(runs));
            }
        }
        let first = times[0].clone();
        let rows = contest.into_iter().zip(times);
        rows.map(move |(contestant, times)| {
            let ratios = times.iter().zip(&first).map(|(time, first)| time / first);
            Timing {
                ratio: Spread::of(ratios.collect()).rounded_median(),
                median_ns: Spread::of(times).rounded_median(),
                ..contestant.row
            }
        })
    };
    contests.flat_map(run).collect()
}
