//! Microbenchmark: how long each method of chapter 6 takes.
//!
//! `--quick` takes a tenth of the rounds: seconds instead of a minute or two. `--record` keeps the
//! result in `book/notes/measured/timings.csv`.

mod about;
mod one_by_one;

use std::error::Error;
use std::io::{self, Write};

use figures::records::Timing;
use figures::table::Table;
use lexopt::Arg::Long;

use measure::contest::Effort;

/// Takes all times, and prints or saves them.
fn main() -> Result<(), Box<dyn Error>> {
    let (mut quick, mut record) = (false, false);
    let mut words = lexopt::Parser::from_env();
    while let Some(word) = words.next()? {
        match word {
            Long("quick") => quick = true,
            Long("record") => record = true,
            // The word that `cargo bench` says to every benchmark.
            Long("bench") => {}
            odd => return Err(odd.unexpected().into()),
        }
    }
    let effort = Effort::new(quick);
    let contests = one_by_one::in_order()
        .into_iter()
        .chain(one_by_one::elsewhere());
    let timings = Table::<Timing> {
        about: about::about(&effort),
        rows: measure::contest::run_all(contests, &effort),
    };
    io::stdout().write_all(timings.text().as_bytes())?;
    if record {
        measure::save(&timings)?;
    }
    Ok(())
}
