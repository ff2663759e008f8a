//! Where and when something was measured.

use std::time::SystemTime;
use std::{env, fs, thread};

/// The date, the processor and how many of it there are.
pub fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map_or(env::consts::ARCH, |(_, name)| name);
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let days = SystemTime::UNIX_EPOCH
        .elapsed()
        .map_or(0, |since| since.as_secs() / 86_400);
    let [year, month, day] = date(days);
    format!(
        "{year}-{month:02}-{day:02}, {model}, {threads} threads, {}",
        env::consts::OS
    )
}

/// Year, month and day of the Gregorian calendar, from the days since 1970.
///
/// ```
/// assert_eq!(measure::machine::date(365), [1971, 1, 1]);
/// assert_eq!(measure::machine::date(19_782), [2024, 2, 29]);
/// assert_eq!(measure::machine::date(20_778), [2026, 11, 21]);
/// ```
pub fn date(mut days: u64) -> [u64; 3] {
    let leap =
        |year: u64| year.is_multiple_of(4) && !year.is_multiple_of(100) || year.is_multiple_of(400);
    let mut year = 1970;
    while days >= 365 + u64::from(leap(year)) {
        days -= 365 + u64::from(leap(year));
        year += 1;
    }
    let february = 28 + u64::from(leap(year));
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    [year, month, days + 1]
}
