//! A campaign: random cases without end, shared by all processors.
//!
//! `cargo test` runs a short part of each; `proofs.md` has the commands for the rest.

use std::array;
use std::env;
use std::thread;

use suite::parallel;

/// How many cases were tried, and the sums of what `tries` counted in so many of them.
///
/// `name`_CASES in the environment says how many, 12 000 without, and `name`_SEED
/// which.
///
/// # Panics
/// If one of the two is no number, or a case breaks a law.
pub(crate) fn run<const N: usize>(
    name: &str,
    tries: impl Fn(usize, &str) -> [u64; N] + Sync,
) -> (u64, [u64; N]) {
    let cases = from_environment(&format!("{name}_CASES")).unwrap_or(12_000);
    let seed = from_environment(&format!("{name}_SEED")).unwrap_or(1);
    let threads = thread::available_parallelism().map_or(1, usize::from) as u64;
    let share = cases / threads;
    let workers: Vec<u64> = (0..threads).collect();
    let counts = parallel::map(&workers, |k| tries(share as usize, &format!("{seed}/{k}")));
    (
        share * threads,
        array::from_fn(|k| counts.iter().map(|counts| counts[k]).sum()),
    )
}

fn from_environment(name: &str) -> Option<u64> {
    let number = env::var(name).ok()?;
    Some(
        number
            .parse()
            .unwrap_or_else(|_| panic!("{name} is {number:?}, which is no whole number")),
    )
}
