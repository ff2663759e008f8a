//! Microbenchmark: how long each method of chapter 6 takes.

mod about;
mod instructions;
mod one_by_one;

use std::error::Error;

use clap::Parser;
use common::engine::output;
use figures::records::Timing;
use figures::table::Table;

use measure::contest::{Contest, Effort};

/// How long each method of chapter 6 takes.
#[derive(Parser)]
struct Arguments {
    /// A tenth of the rounds: within seconds instead of a minute or two
    #[arg(long)]
    quick: bool,

    /// Keep the result in book/notes/measured/timings.csv
    #[arg(long)]
    record: bool,

    /// Run this loop so often and measure nothing: valgrind watches
    #[arg(long, hide = true, requires = "runs")]
    only: Option<String>,

    /// How often
    #[arg(long, hide = true)]
    runs: Option<usize>,

    /// The word that `cargo bench` says to every benchmark
    #[arg(long, hide = true)]
    bench: bool,
}

/// Takes all times, and prints or saves them.
fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    if let (Some(key), Some(runs)) = (arguments.only, arguments.runs) {
        instructions::run(counted(), &key, runs);
        return Ok(());
    }
    let effort = Effort::new(arguments.quick);
    let mut contests = counted();
    let with_count: usize = contests.iter().map(|contest| contest.0.len()).sum();
    contests.extend(one_by_one::elsewhere());
    let mut timings = Table::<Timing> {
        about: about::about(&effort),
        rows: measure::contest::run_all(contests, &effort),
    };
    for row in &mut timings.rows[..with_count] {
        row.instructions = instructions::of(row);
    }
    output::to_stdout(|out| out.write_all(timings.text().as_bytes()))?;
    if arguments.record {
        measure::save(&timings)?;
    }
    Ok(())
}

/// Returns the contests whose instructions are counted, too.
fn counted() -> Vec<Contest> {
    let contests = one_by_one::in_order().into_iter();
    contests.chain(measure::lanes::contests()).collect()
}
