//! Provenance: the conditions under which the times were taken.

use std::collections::BTreeMap;
use std::process::Command;

use measure::contest::Effort;
use measure::machine;

use crate::one_by_one;

/// Returns the lines above the table of times, by their keys: machine, compiler, flags, command,
/// how.
pub(crate) fn about(effort: &Effort) -> BTreeMap<String, String> {
    let how = format!(
        "{} rounds in which everyone takes a turn of {} µs or more; one thread; {} questions; each \
         method compiled into its own loop, which makes the book’s rays from column and row and \
         reads the others",
        effort.rounds,
        effort.turn.as_micros(),
        one_by_one::CASES
    );
    [
        ("machine", machine::description()),
        ("compiler", compiler()),
        ("flags", format!("release profile, {}", compiled_for())),
        ("command", "cargo bench -p measure --bench clock".to_owned()),
        ("how", how),
    ]
    .map(|(key, value)| (key.to_owned(), value))
    .into()
}

fn compiler() -> String {
    let said = Command::new("rustc").arg("--version").output();
    let text = said.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    text.unwrap_or_else(|_| "unknown".to_owned())
}

/// Says which instructions of the processor the compiler may use in all code.
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
