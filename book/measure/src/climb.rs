//! Simulated annealing: a search for the case that comes closest to a bound.
//!
//! A random change of a good case is kept if it is better, or at first if it is only a
//! little worse. The kind with a threshold in place of a probability: Dueck and Scheuer,
//! *Threshold Accepting*, 1990.

use laws::{Case, runner, strategies};
use rayon::prelude::*;
use speed_vs_accuracy::Random;

use crate::tightness::{Attempt, Bound};

/// How long a search takes, and which one it is.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// How many climbs there are in a round.
    pub climbs: usize,
    /// How many changes a climb tries.
    pub steps: u32,
    /// Another search for each.
    pub seed: u64,
}

/// How many rounds follow the first; in these, half of the climbs begin at what is best.
const ROUNDS: u64 = 4;

/// The witness that comes closest to the bound, of those found and those `known`.
pub fn closest(bound: &Bound, known: &[Case], effort: Effort) -> Option<Attempt> {
    let Effort {
        climbs,
        steps,
        seed,
    } = effort;
    let known = known.iter().filter_map(|case| (bound.attempt)(case));
    let mut best: Vec<Attempt> = known.filter(Attempt::is_witness).collect();
    for round in 0..=ROUNDS {
        let seed = seed.wrapping_mul(1 + ROUNDS).wrapping_add(round);
        let fresh = runner::endless(strategies::hostile(), &format!("{}/{seed}", bound.name));
        let from_best = best.iter().map(|attempt| attempt.asked.case).cycle();
        let starts = from_best.take(climbs / 2).chain(fresh).take(climbs);
        let starts: Vec<Case> = starts.collect();
        let found = starts.par_iter().enumerate().filter_map(|(number, start)| {
            let mut random = Random::new(seed << 32 | number as u64);
            climb(bound, start, steps, &mut random)
        });
        best.extend(found.collect::<Vec<_>>());
        best.sort_by(|a, b| b.attained.total_cmp(&a.attained));
        best.truncate((climbs / 8).max(1));
    }
    best.first().copied()
}

/// The closest witness on the way up from `start`.
fn climb(bound: &Bound, start: &Case, steps: u32, random: &mut Random) -> Option<Attempt> {
    let attempt = |case: &Case| {
        let is_finite = case.numbers().iter().all(|number| number.is_finite());
        is_finite.then(|| (bound.attempt)(case)).flatten()
    };
    let mut here = attempt(start).or_else(|| attempt(&(bound.aim)(start)));
    let mut case = here.map_or(*start, |attempt| attempt.asked.case);
    let mut best = here.filter(Attempt::is_witness);
    for step in 0..steps {
        let mut next = changed(&case, random);
        if random.below(3) == 0 {
            next = (bound.aim)(&next);
        }
        let Some(found) = attempt(&next) else {
            continue;
        };
        // One step may be a tenth worse at first, and at last none.
        let left = 1.0 - f64::from(step) / f64::from(steps);
        let allowed = 1.0 - 0.1 * left * random.between(0.0, 1.0);
        if here.is_none_or(|here| found.score() >= allowed * here.score()) {
            here = Some(found);
            case = found.asked.case;
        }
        if found.is_witness() && best.is_none_or(|best| found.attained > best.attained) {
            best = Some(found);
        }
    }
    best
}

/// The case with one, two or three of its numbers changed.
fn changed(case: &Case, random: &mut Random) -> Case {
    let mut numbers = case.numbers();
    for _ in 0..=random.below(3) {
        let (which, other) = (random.below(10) as usize, random.below(10) as usize);
        numbers[which] = match random.below(12) {
            0 => 0.0,
            1 => -numbers[which],
            2 => numbers[other],
            3 => numbers[which] * f64::exp2(random.between(-3.0, 3.0).round()),
            4 => shortened(numbers[which], random),
            _ => numbers[which] * (1.0 + random.sign() * f64::exp2(-random.between(0.0, 53.0))),
        };
    }
    Case::from_numbers(numbers)
}

/// `x` with the lower of its digits cut off: what is short does not round.
fn shortened(x: f64, random: &mut Random) -> f64 {
    let cut = random.below(53);
    f64::from_bits(x.to_bits() >> cut << cut)
}
