//! Microbenchmark: how long each method of chapter 6 takes.
//!
//! `--quick` takes a tenth of the rounds: seconds instead of a minute or two. `--record` keeps the
//! result in `book/notes/measured/timings.csv`. `--only KEY --runs N` runs one loop so often and
//! measures nothing: valgrind watches.

mod about;
mod instructions;
mod one_by_one;

use std::error::Error;
use std::io::{self, Write};

use figures::records::Timing;
use figures::table::Table;
use lexopt::{Arg::Long, ValueExt};

use measure::contest::Effort;

/// Takes all times, and prints or saves them.
fn main() -> Result<(), Box<dyn Error>> {
    let (mut quick, mut record, mut only, mut runs) = (false, false, None, 1);
    let mut words = lexopt::Parser::from_env();
    while let Some(word) = words.next()? {
        match word {
            Long("quick") => quick = true,
            Long("record") => record = true,
            Long("only") => only = Some(words.value()?.string()?),
            Long("runs") => runs = words.value()?.parse()?,
            // The word that `cargo bench` says to every benchmark.
            Long("bench") => {}
            odd => return Err(odd.unexpected().into()),
        }
    }
    if let Some(key) = only {
        instructions::run(one_by_one::in_order(), &key, runs);
        return Ok(());
    }
    let effort = Effort::new(quick);
    let mut contests = Vec::from(one_by_one::in_order());
    let with_count: usize = contests.iter().map(|contest| contest.len()).sum();
    contests.extend(one_by_one::elsewhere());
    let mut timings = Table::<Timing> {
        about: about::about(&effort),
        rows: measure::contest::run_all(contests, &effort),
    };
    for row in &mut timings.rows[..with_count] {
        row.instructions = instructions::of(row);
    }
    io::stdout().write_all(timings.text().as_bytes())?;
    if record {
        measure::save(&timings)?;
    }
    Ok(())
}
