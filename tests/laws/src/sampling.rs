//! Sampling: values of a strategy, the same ones in every run.

use std::env;
use std::fmt::Debug;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// The first `count` values of `strategy`.
pub fn samples<T: Debug>(strategy: &impl Strategy<Value = T>, count: u32) -> Vec<T> {
    endless(strategy, &chosen_seed())
        .take(count as usize)
        .collect()
}

/// Values of `strategy` without end, the same whenever the seed is.
pub fn endless<T: Debug, S: Strategy<Value = T>>(
    strategy: S,
    seed: &str,
) -> impl Iterator<Item = T> + use<T, S> {
    let mut bytes = [0; 32];
    for (byte, letter) in bytes.iter_mut().zip(seed.bytes()) {
        *byte = letter;
    }
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    std::iter::repeat_with(move || {
        let tree = strategy.new_tree(&mut runner);
        tree.expect("no strategy here filters anything out")
            .current()
    })
}

/// How many cases a law is tried on: 1000, or what the environment variable
/// `PROPTEST_CASES` says.
pub fn cases() -> u32 {
    env::var("PROPTEST_CASES")
        .ok()
        .and_then(|number| number.parse().ok())
        .unwrap_or(1000)
}

/// The seed of every run is empty, so that a failure is never luck; another one is in
/// the environment variable `PROPTEST_SEED`.
pub(crate) fn chosen_seed() -> String {
    env::var("PROPTEST_SEED").unwrap_or_default()
}
