//! The witnesses of chapter 6: for each error bound, the case that comes closest to it of
//! all that a search has found. A bound that is made smaller than its witness allows
//! gives a wrong answer here.

use figures::table::reader;
use laws::{Case, IntervalCase};

use crate::methods::promised::is_certified;

#[test]
fn the_certified_methods_answer_each_of_them_rightly() {
    let mut recorded = reader(include_str!("../../../book/notes/measured/tightness.csv"));
    let mut wrong = String::new();
    for row in recorded.records() {
        let row = row.expect("the file is well-formed");
        let asked = asked([&row[3], &row[4], &row[5]]);
        if let Err(failure) = is_certified(&asked) {
            wrong += &format!("{}:\n{failure}\n{asked}\n\n", &row[0]);
        }
    }
    assert!(wrong.is_empty(), "bounds that are too small\n\n{wrong}");
}

/// Reads the witness of a bound, ten numbers, and the range of t.
fn asked([witness, t_min, t_max]: [&str; 3]) -> IntervalCase {
    let number = |text: &str| text.parse().expect("a number");
    let numbers: Vec<f64> = witness.split(' ').map(number).collect();
    IntervalCase {
        case: Case::from_numbers(numbers.try_into().expect("ten numbers")),
        t_min: number(t_min),
        t_max: number(t_max),
    }
}
