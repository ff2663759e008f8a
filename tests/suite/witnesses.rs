//! The witnesses of chapter 6: for each bound of the filter, the case that comes closest
//! to it of all that a search has found. A bound that is made smaller than its witness
//! allows gives a wrong answer here.

use laws::WithInterval;
use laws::intervals::{t_is_within_ulps, the_decision_is_exactly_right};
use laws::verdict::Verdict;
use measure::tightness::{self, Attempt, BOUNDS};
use speed_vs_accuracy::{certified_hit, certified_t};

#[test]
fn each_bound_has_one_that_attains_what_is_recorded() {
    let recorded = tightness::recorded().rows;
    assert_eq!(recorded.len(), BOUNDS.len());
    for (row, bound) in recorded.iter().zip(&BOUNDS) {
        let found = (bound.attempt)(&tightness::witness(row));
        let found = found
            .filter(Attempt::is_witness)
            .unwrap_or_else(|| panic!("{}: with no constant is this answered wrongly", bound.name));
        assert_eq!(&bound.row(&found), row);
    }
}

#[test]
fn no_bound_is_attained() {
    for (row, bound) in tightness::recorded().rows.iter().zip(&BOUNDS) {
        assert!(row.exactly < bound.proved, "{}", bound.name);
        assert!(bound.proved <= bound.constant, "{}", bound.name);
    }
}

#[test]
fn the_certified_methods_answer_each_of_them_rightly() {
    let mut wrong = String::new();
    for (row, bound) in tightness::recorded().rows.iter().zip(&BOUNDS) {
        let found = (bound.attempt)(&tightness::witness(row)).expect("a witness");
        if let Err(broken) = is_certified(&found.asked) {
            wrong += &format!("{}:\n{broken}\n{}\n\n", bound.name, found.asked);
        }
    }
    assert!(wrong.is_empty(), "bounds that are too small\n\n{wrong}");
}

fn is_certified(asked: &WithInterval) -> Verdict {
    the_decision_is_exactly_right(&certified_hit, asked)?;
    the_decision_is_exactly_right(&certified_t, asked)?;
    t_is_within_ulps(&certified_t, asked, 1.0)
}
