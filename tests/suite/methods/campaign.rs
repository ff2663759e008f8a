//! A campaign: random cases without end, shared by all processors.
//!
//! `cargo test` runs a short part of each; `proofs.md` has the commands for the rest.

use std::array;
use std::cell::Cell;
use std::env;
use std::thread;

use laws::config;
use proptest::strategy::BoxedStrategy;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};
use suite::parallel;

/// How many cases were tried, and the sums of what `tries` counts in each.
///
/// `name`_CASES in the environment says how many, 12 000 without, and `name`_SEED
/// which.
///
/// # Panics
/// If one of the two is no number, or a case fails.
pub(crate) fn run<T: std::fmt::Debug, const N: usize>(
    name: &str,
    strategy: fn() -> BoxedStrategy<T>,
    tries: impl Fn(T) -> Result<[u64; N], TestCaseError> + Sync,
) -> (u64, [u64; N]) {
    let cases = from_environment(&format!("{name}_CASES")).unwrap_or(12_000);
    let seed = from_environment(&format!("{name}_SEED")).unwrap_or(1);
    let threads = thread::available_parallelism().map_or(1, usize::from) as u64;
    let share = u32::try_from(cases / threads).expect("a processor tries 4 billion cases at most");
    let workers: Vec<u64> = (0..threads).collect();
    let counts = parallel::map(&workers, |worker| {
        let mut runner = TestRunner::new(Config {
            cases: share,
            // Each of them has its own cases.
            rng_seed: RngSeed::Fixed(seed * threads + worker),
            ..config()
        });
        let counts = Cell::new([0; N]);
        let tried = runner.run(&strategy(), |case| {
            let more = tries(case)?;
            counts.set(array::from_fn(|k| counts.get()[k] + more[k]));
            Ok(())
        });
        tried.unwrap_or_else(|failure| panic!("{failure}"));
        counts.get()
    });
    (
        u64::from(share) * threads,
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
