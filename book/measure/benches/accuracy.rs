//! Monte Carlo: how exact each method of chapter 6 is, on as many cases as you like.

use std::error::Error;
use std::io;
use std::num::NonZeroUsize;

use clap::Parser;
use common::engine::output;
use figures::table::{Record, Table};
use measure::accuracy;
use speed_vs_accuracy::METHODS;

/// How exact each method of chapter 6 is.
#[derive(Parser)]
struct Arguments {
    /// How many cases in each regime, and how many pixels of the book
    #[arg(long, value_name = "N", default_value = "10000")]
    cases: NonZeroUsize,

    /// Which cases
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// Ask a million cases, 3840 × 2160 pixels, and 100 000 cases at each level, and
    /// keep the result in book/notes/measured
    #[arg(long, conflicts_with_all = ["cases", "seed"])]
    record: bool,

    /// The word that `cargo bench` says to every benchmark
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments {
        cases,
        seed,
        record,
        ..
    } = Arguments::parse();
    if record {
        keep(accuracy::table(METHODS, 1_000_000, usize::MAX, seed))?;
        return Ok(keep(accuracy::sweeps(100_000, seed))?);
    }
    let table = accuracy::table(METHODS, cases.get(), cases.get(), seed);
    Ok(output::to_stdout(|out| {
        out.write_all(table.text().as_bytes())
    })?)
}

/// Writes the table, with the command that made it, into the file that the book shows.
fn keep<Row: Record>(mut table: Table<Row>) -> Result<(), io::Error> {
    let command = "cargo bench -p measure --bench accuracy -- --record";
    table.about.insert("command".to_owned(), command.to_owned());
    measure::save(&table)
}
