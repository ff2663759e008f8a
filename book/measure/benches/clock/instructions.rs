//! Instruction counts: what valgrind counts while one loop runs twice, less what it counts
//! while it runs once. Unlike times they are the same again.

use std::env;
use std::process::Command;

use figures::records::Timing;
use measure::contest::Contest;

/// Counts by valgrind the instructions that one question of a row takes. Returns `None` if there is
/// no valgrind.
pub(crate) fn of(row: &Timing) -> Option<f64> {
    let [once, twice] = [1, 2].map(|runs| counted(&key(row), runs));
    Some((twice? - once?) as f64 / row.n as f64)
}

/// Runs the loop whose row has the key `wanted`, `runs` times, for valgrind to watch.
///
/// # Panics
/// If no contest has such a loop.
pub(crate) fn run(contests: impl IntoIterator<Item = Contest>, wanted: &str, runs: usize) {
    let mut contestants = contests.into_iter().flatten();
    let found = contestants.find(|contestant| key(&contestant.row) == wanted);
    let mut contestant = found.unwrap_or_else(|| panic!("no loop is called {wanted}"));
    for _ in 0..runs {
        (contestant.run)();
    }
}

fn key(row: &Timing) -> String {
    format!("{}/{}/{}", row.what, row.name, row.place)
}

fn counted(key: &str, runs: usize) -> Option<i64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(env::current_exe().ok()?)
        .args(["--only", key, "--runs", &runs.to_string()])
        .output()
        .ok()?;
    let said = String::from_utf8_lossy(&output.stderr);
    let count = said.split("Collected : ").nth(1)?.lines().next()?;
    count.trim().parse().ok()
}
