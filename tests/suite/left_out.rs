//! Skipped checks: what to say when a check can't be made.

use std::io::{self, Write};

/// Says on the terminal what is left out, past the test harness, which hides what
/// `println!` says in a test that passes.
pub(crate) fn left_out(what: &str) {
    // If even this can't be written, there is nobody to read it.
    let _ = io::stderr().write_all(format!("\nLEFT OUT: {what}\n\n").as_bytes());
}
