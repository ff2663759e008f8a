//! The methods of chapter 6: what each one promises, and where it fails.
//!
//! Laws and bounds are those of the chapters; the judge is `src/oracle.rs`,
//! which shares no line with the method `exact`.

use proptest::prelude::*;
use speed_vs_accuracy::{METHODS, Solve, exact};
use tests::case::WithInterval;
use tests::intervals::{self, RangeSolver};
use tests::strategies;
use tests::trial::{self, holds};

mod every_method_in_f64 {
    use super::*;

    /// The bounds are those of `half_b`, with the worst of discriminants.
    #[test]
    fn returns_the_nearest_root_in_the_interval() {
        for_each(|_, solve| {
            let asked = strategies::with_interval(strategies::anywhere());
            holds(&asked, |asked| {
                intervals::the_nearest_root_in_the_interval_is_returned(solve, asked)
            });
        });
    }

    #[test]
    fn returns_no_t_outside_the_interval() {
        for_each(|_, solve| {
            let cases = prop_oneof![strategies::anywhere(), strategies::specks()];
            holds(&strategies::with_interval(cases), |asked| {
                intervals::no_t_outside_the_interval_is_returned(solve, asked)
            });
        });
    }

    fn for_each(test: impl Fn(&str, &RangeSolver)) {
        for method in METHODS {
            if let Solve::Double(solve) = method.solve {
                println!("{}", method.name);
                test(method.name, &solve);
            }
        }
    }
}

mod the_exact_method {
    use super::*;

    #[test]
    fn is_the_oracle_to_the_last_bit() {
        let cases = prop_oneof![strategies::anywhere(), strategies::specks()];
        for asked in trial::samples(&strategies::with_interval(cases), 10_000) {
            let WithInterval { case, t_min, t_max } = asked;
            let oracle = case.exact();
            let expected = oracle
                .nearest_root_in(t_min, t_max)
                .map(|root| root.rounded().max(t_min.next_up()).min(t_max.next_down()));
            assert_eq!(asked.solve(&exact), expected, "{asked}");
        }
    }
}
