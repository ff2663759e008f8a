//! The coefficient of Dice (1945): how much two lists have in common.

/// Returns how many members two lists share, in whatever order: 0 if none, 1 if all. A member that
/// comes twice is shared twice only if it comes twice in both. Two empty lists share 0.
pub(crate) fn likeness<T: PartialEq + Clone>(one: &[T], other: &[T]) -> f64 {
    let mut left = other.to_vec();
    let is_taken = |it: &&T| {
        let at = left.iter().position(|other| other == *it);
        at.map(|at| left.swap_remove(at)).is_some()
    };
    let same = one.iter().filter(is_taken).count();
    2.0 * same as f64 / (one.len() + other.len()).max(1) as f64
}
