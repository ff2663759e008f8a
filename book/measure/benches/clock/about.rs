//! Provenance: under what conditions was measured, and a table for people.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::process::Command;

use figures::records::Timing;
use figures::table::Table;
use measure::machine;

use measure::contest::Effort;

use crate::one_by_one;

/// The lines at the top of the file.
pub(crate) fn about(effort: &Effort) -> BTreeMap<String, String> {
    let rounds = effort.rounds;
    [
        ("machine", machine::machine()),
        ("compiler", compiler()),
        ("flags", format!("release profile, {}", compiled_for())),
        ("command", "cargo bench -p measure --bench clock".to_owned()),
        (
            "how",
            format!(
                "{rounds} rounds in which everyone takes a turn of {} µs or more; one thread; \
                 {} questions; each method compiled into its own loop, which makes the book’s \
                 rays from column and row and reads the others",
                effort.turn.as_micros(),
                one_by_one::CASES
            ),
        ),
    ]
    .map(|(key, value)| (key.to_owned(), value))
    .into()
}

/// A table for people.
pub(crate) fn table(timings: &Table<Timing>) -> String {
    let mut text = String::new();
    for (key, value) in &timings.about {
        let _ = writeln!(text, "{key}: {value}");
    }
    let _ = writeln!(
        text,
        "\n{:<8}{:<22}{:<18}{:>6}{:>12}{:>12}{:>8}{:>14}",
        "what", "name", "where", "n", "median, ns", "least", "ratio", "instructions"
    );
    for row in &timings.rows {
        let instructions = row.instructions.map(|count| format!("{count:.0}"));
        let instructions = instructions.unwrap_or_default();
        let _ = writeln!(
            text,
            "{:<8}{:<22}{:<18}{:>6}{:>12}{:>12.2}{:>8}{instructions:>14}",
            row.what, row.name, row.place, row.n, row.median_ns, row.least_ns, row.ratio
        );
    }
    text
}

fn compiler() -> String {
    let said = Command::new("rustc").arg("--version").output();
    let text = said.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    text.unwrap_or_else(|_| "unknown".to_owned())
}

/// What the compiler was allowed to use in all code.
fn compiled_for() -> &'static str {
    if cfg!(target_feature = "avx512f") {
        "for processors with AVX-512"
    } else if cfg!(target_feature = "fma") {
        "for processors with AVX2 and FMA"
    } else if cfg!(target_arch = "x86_64") {
        "for any x86-64 processor"
    } else {
        std::env::consts::ARCH
    }
}
