//! What chapter 6 measures without a clock: the same numbers on every machine.

use figures::records::{Race, Timing};
use figures::table::{Record, Table};
use insta::internals::SnapshotContents;
use insta::{Comparator, Snapshot, assert_binary_snapshot};
use measure::{accuracy, scenes};

/// The book shows these files, so they stand where the book finds them.
const MEASURED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/measured");

/// How many cases each method is given in each regime, and at each level. Of
/// more, `cargo bench -p measure --bench accuracy -- --cases 1000000` tells.
const CASES: usize = 2000;
const CASES_OF_A_LEVEL: usize = 400;

/// Pixels in a row: enough to see a difference in every scene that has one.
const WIDTH: u32 = 128;

/// Any seed would do; this one was the first.
const SEED: u64 = 1;

mod the_snapshot_holds {
    use super::*;

    #[test]
    fn accuracy() {
        assert_measured("accuracy", &accuracy::table(CASES, SEED));
    }

    /// Where the times are recorded anew, this follows.
    #[test]
    fn scenes_and_least() {
        let table = scenes::table(WIDTH);
        let timings = include_str!("../../book/notes/measured/timings.csv");
        let timings = Table::<Timing>::read(timings).expect("the file is well-formed");
        assert_measured("least", &scenes::least(&table, &timings));
        assert_measured("scenes", &table);
    }

    #[test]
    fn sweeps() {
        assert_measured("sweeps", &accuracy::sweeps(CASES_OF_A_LEVEL, SEED));
    }
}

/// What the pages say in words of numbers that were measured.
mod the_words {
    use super::*;

    /// `speed.md`: most of the C++ program's time is printing, and in tracing alone the
    /// two are near to each other.
    #[test]
    fn most_of_the_time_of_the_rival_is_printing() {
        let file = include_str!("../../book/notes/speed/heats.csv");
        let rows = Table::<Race>::read(file)
            .expect("the file is well-formed")
            .rows;
        let of = |to: &str, chapter: &str| {
            let mut rows = rows
                .iter()
                .filter(|row| (row.width, &*row.to) == (3840, to));
            let row = rows.find(|row| row.chapter == chapter);
            row.cloned().expect("it was measured")
        };
        for chapter in [
            "gradient",
            "red_sphere",
            "normals",
            "half_b_sphere",
            "hittable_list",
        ] {
            let [all, traced] = ["nowhere", "traced"].map(|to| of(to, chapter));
            let printing = 1.0 - traced.cpp_median_ms / all.cpp_median_ms;
            assert!(printing > 0.6, "{chapter}: {printing}");
            assert!(
                (0.5..2.0).contains(&traced.ratio()),
                "{chapter}: {}",
                traced.ratio()
            );
        }
        let [list, ball] = ["hittable_list", "half_b_sphere"].map(|of_it| of("traced", of_it));
        let factor = list.rust_median_ms / ball.rust_median_ms;
        assert!((1.6..2.5).contains(&factor), "about twice: {factor}");
    }
}

/// Compares what was measured with the snapshot of that name.
fn assert_measured<Row: Record>(name: &str, table: &Table<Row>) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(MEASURED);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(SameLines));
    settings.bind(|| assert_binary_snapshot!(&format!("{name}.csv"), table.text().into_bytes()));
}

/// Compares two tables line by line, and shows the lines that differ.
#[derive(Clone)]
struct SameLines;

impl Comparator for SameLines {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let (Some(expected), Some(actual)) = (text_of(reference), text_of(test)) else {
            println!("The .csv file of a snapshot is missing: restore it, or accept a new one.");
            return false;
        };
        if expected == actual {
            return true;
        }
        let name = test.snapshot_name().unwrap_or("table");
        println!(
            "\n`{name}` is not its snapshot. These lines differ, as they were and as they are:"
        );
        for (old, new) in expected.lines().zip(actual.lines()) {
            if old != new {
                println!("- {old}\n+ {new}");
            }
        }
        let [old, new] = [&expected, &actual].map(|text| text.lines().count());
        if old != new {
            println!("{old} lines before, {new} lines now");
        }
        println!(
            "If a method was meant to change: INSTA_UPDATE=always cargo test the_snapshot_holds::{name}\n\
             (in PowerShell, first $env:INSTA_UPDATE = 'always')\n"
        );
        false
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

fn text_of(snapshot: &Snapshot) -> Option<String> {
    match snapshot.contents() {
        // Git may write the lines of a text in the manner of the system.
        SnapshotContents::Binary(Some(file)) => {
            Some(String::from_utf8_lossy(file).replace("\r\n", "\n"))
        }
        _ => None,
    }
}
