//! Chapter 6: is each method as right, as exact and as it is said to be?

mod bands;
mod contract;
mod happened;
mod hostile;
mod measured;
mod neighbors;
mod pictures;
mod promised;
mod proofs;
mod rejected;
mod several_spheres;
mod speed_vs_accuracy;
mod thresholds;
mod witnesses;

/// Turns a case of the laws into a question to the methods of chapter 6: the same ten numbers.
fn question(case: &laws::Case) -> ::speed_vs_accuracy::Case {
    ::speed_vs_accuracy::Case::new(case.center, case.radius, case.ray)
}
