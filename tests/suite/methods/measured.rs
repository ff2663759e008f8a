//! Measurements of chapter 6 without a clock: their numbers are equal on every machine.
//!
//! Some are found again in a moment, and are snapshots. The others are of millions of
//! questions: here a few of them are asked again, which notices that they were asked
//! of other methods than there are now.

use std::fs;

use figures::records::Accuracy;
use figures::table::{Record, Table};
use fixtures::drawn::shown_in;
use insta::assert_binary_snapshot;
use measure::spread::Spread;
use measure::{accuracy, wrong_pixels};
use speed_vs_accuracy::METHODS;

use crate::methods::rejected::REJECTED;

/// The folder of the files that the book shows.
const MEASURED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/measured");

/// The width of the pictures: enough to see a difference in every scene that has one.
const WIDTH: u32 = 128;

/// The seed of the questions. Any would do; this one was the first.
const SEED: u64 = 1;

mod the_snapshot_holds {
    use super::*;

    #[test]
    fn scenes() {
        assert_measured("scenes", &wrong_pixels::table(WIDTH));
    }

    #[test]
    #[ignore = "asks each method at each place of the map"]
    fn map() {
        assert_measured("map", &measure::map::table(SEED));
    }

    #[test]
    #[ignore = "asks a million questions"]
    fn rejected() {
        assert_measured("rejected", &accuracy::table(REJECTED, 20_000, 20_000, SEED));
    }
}

mod a_part_of_the_questions_asked_again {
    use super::*;

    /// The number of questions, of a million or of the pixels of a picture.
    const CASES: usize = 2000;

    #[test]
    fn has_the_answers_and_the_errors_that_were_recorded() {
        let again = accuracy::table(METHODS, CASES, CASES, SEED).rows;
        let recorded: Vec<Accuracy> =
            rows(include_str!("../../../book/notes/measured/accuracy.csv"));
        assert_eq!(recorded.len(), again.len(), "rows of {}", Accuracy::FILE);
        for (old, new) in recorded.iter().zip(&again) {
            let row = format!("{}/{}/{}", old.regime, old.precision.name(), old.method);
            assert_same_answers(&row, [old.answers, new.answers]);
            assert_eq!((&old.regime, &old.method), (&new.regime, &new.method));
            // What misses nearly all that it should hit leaves no median of a part.
            if old.wrong_per_million < 4e5 {
                assert_near(&row, [old.median_ulps, new.median_ulps]);
            }
            // A part has no error that all have not. What is written has three digits.
            let [all, part] = [old.largest_ulps, new.largest_ulps];
            assert!(
                part <= all.map(|ulps| 1.01 * ulps),
                "{row}: {part:?} of {all:?}"
            );
            // Three standard deviations, of what is not rarer than one in a thousand.
            let wrong = [old, new].map(|row| row.wrong_per_million / 1e6);
            let allowed = 3.0 * (wrong[0].max(1e-3) / CASES as f64).sqrt();
            assert!((wrong[0] - wrong[1]).abs() < allowed, "{row}: {wrong:?}");
        }
    }

    fn assert_same_answers(row: &str, [recorded, now]: [u64; 2]) {
        assert_eq!(
            recorded, now,
            "{row} answers otherwise than when it was measured. If that was meant:\n\
             cargo bench -p measure --bench accuracy -- --record"
        );
    }

    /// Panics unless the medians of a part and of all questions are within a factor of two.
    fn assert_near(row: &str, medians: [Option<f64>; 2]) {
        let [Some(all), Some(part)] = medians else {
            panic!("{row} has no median: {medians:?}");
        };
        assert!(
            (all / 2.0..=all * 2.0).contains(&part),
            "{row}: {part} of {all}"
        );
    }
}

#[test]
fn noise_takes_all_digits_of_a_median_but_one() {
    let rounded_median = |numbers: [f64; 3]| Spread::of(numbers.to_vec()).rounded_median();
    assert_eq!(rounded_median([5.61, 5.628, 5.63]), 5.63);
    assert_eq!(rounded_median([1.0, 2.628, 90.0]), 3.0);
    assert_eq!(rounded_median([0.0, 0.0312, 7.0]), 0.03);
}

fn rows<Row: Record>(file: &str) -> Vec<Row> {
    Table::read(file).expect("the file is well-formed").rows
}

/// Compares what was measured with the snapshot of that name, and shows the lines that
/// differ.
fn assert_measured<Row: Record>(name: &str, table: &Table<Row>) {
    let text = table.text();
    let before = fs::read_to_string(format!("{MEASURED}/{name}.snap.csv")).unwrap_or_default();
    for (old, new) in before.lines().zip(text.lines()) {
        if old != new {
            println!("- {old}\n+ {new}");
        }
    }
    println!(
        "If a method was meant to change: INSTA_UPDATE=always cargo test the_snapshot_holds::{name} \
         -- --include-ignored"
    );
    shown_in("measured")
        .bind(|| assert_binary_snapshot!(&format!("{name}.csv"), text.into_bytes()));
}
