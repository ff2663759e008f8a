//! What the program says where nothing has to be timed.

use std::process::{Command, Output};

/// In a release build it would measure.
#[cfg(debug_assertions)]
#[test]
fn a_build_for_debugging_is_refused() {
    assert_refused(&measure(&[]), "cargo run --release -p measure");
}

#[test]
fn the_accuracy_of_no_sample_is_refused() {
    assert_refused(&measure(&["--accuracy", "0"]), "--accuracy");
}

/// A larger sample than the book's, for whoever has the time.
#[test]
fn the_accuracy_of_any_sample_is_printed_on_demand() {
    let output = measure(&["--accuracy", "50", "--seed", "9"]);
    let printed = String::from_utf8_lossy(&output.stdout);
    assert_eq!(printed, tests::accuracy::table(50, 9));
    assert_eq!(output.status.code(), Some(0));
}

fn measure(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_measure"));
    command.args(arguments).output().expect("it starts")
}

fn assert_refused(output: &Output, word: &str) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains(word), "{said}");
}
