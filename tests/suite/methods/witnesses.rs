//! The witnesses of chapter 6: for each error bound, the case that comes closest to it of
//! all that a search has found. A bound that is made smaller than its witness allows
//! gives a wrong answer here.

use figures::records::Tightness;
use figures::table::Table;
use laws::{Case, IntervalCase};

use crate::methods::is_certified;

#[test]
fn the_certified_methods_answer_each_of_them_rightly() {
    let recorded = include_str!("../../../book/notes/measured/tightness.csv");
    let recorded = Table::<Tightness>::read(recorded).expect("the file is well-formed");
    let mut wrong = String::new();
    for row in &recorded.rows {
        let asked = asked(row);
        if let Err(failure) = is_certified(&asked) {
            wrong += &format!("{}:\n{failure}\n{asked}\n\n", row.bound);
        }
    }
    assert!(wrong.is_empty(), "bounds that are too small\n\n{wrong}");
}

fn asked(row: &Tightness) -> IntervalCase {
    let numbers = row.witness.split(' ').map(|number| number.parse());
    let numbers: Result<Vec<f64>, _> = numbers.collect();
    let numbers = numbers.ok().and_then(|numbers| numbers.try_into().ok());
    IntervalCase {
        case: Case::from_numbers(numbers.expect("ten numbers")),
        t_min: row.t_min,
        t_max: row.t_max,
    }
}
