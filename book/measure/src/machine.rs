//! Provenance: on what processor something was measured. It is kept beside every time
//! that a clock took, which says nothing without it.

use std::{env, fs, thread};

/// Describes this computer in a line of plain text: the processor, or its architecture where its
/// name is unknown; the number of its threads; and the system.
pub fn description() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map_or(env::consts::ARCH, |(_, name)| name);
    let threads = thread::available_parallelism().map_or(1, usize::from);
    format!("{model}, {threads} threads, {}", env::consts::OS)
}
