//! Monte Carlo: how exact each method of chapter 6 is, on as many cases as you like.
//!
//! `--cases N` says how many cases in each regime and how many pixels of the book (10,000 without
//! it), `--seed N` which. `--record` asks a million cases and 3840 × 2160 pixels, and keeps the
//! result in `book/notes/measured`.

use std::error::Error;
use std::io::{self, Write};
use std::num::NonZeroUsize;

use figures::records::Accuracy;
use figures::table::Table;
use lexopt::{Arg::Long, ValueExt};
use measure::accuracy;
use speed_vs_accuracy::METHODS;

fn main() -> Result<(), Box<dyn Error>> {
    let (mut cases, mut seed, mut record) = (10_000, 1, false);
    let mut words = lexopt::Parser::from_env();
    while let Some(word) = words.next()? {
        match word {
            Long("cases") => cases = words.value()?.parse::<NonZeroUsize>()?.get(),
            Long("seed") => seed = words.value()?.parse()?,
            Long("record") => record = true,
            // The word that `cargo bench` says to every benchmark.
            Long("bench") => {}
            odd => return Err(odd.unexpected().into()),
        }
    }
    if record {
        return Ok(keep(accuracy::table(METHODS, 1_000_000, usize::MAX, seed))?);
    }
    let table = accuracy::table(METHODS, cases, cases, seed);
    Ok(io::stdout().write_all(table.text().as_bytes())?)
}

/// Writes the table, with the command that made it, into the file that the book shows.
fn keep(mut table: Table<Accuracy>) -> Result<(), io::Error> {
    let command = "cargo bench -p measure --bench accuracy -- --record";
    table.about.insert("command".to_owned(), command.to_owned());
    measure::save(&table)
}
