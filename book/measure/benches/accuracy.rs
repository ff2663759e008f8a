//! A long trial: how exact each method of chapter 6 is, on as many cases as you like.

use std::error::Error;
use std::num::NonZeroUsize;

use clap::Parser;
use common::engine::output;
use measure::accuracy;

/// How exact each method of chapter 6 is.
#[derive(Parser)]
struct Arguments {
    /// How many cases in each regime
    #[arg(long, value_name = "N", default_value = "10000")]
    cases: NonZeroUsize,

    /// Which cases
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// What `cargo bench` says to every benchmark
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments { cases, seed, .. } = Arguments::parse();
    let table = accuracy::table(cases.get(), seed);
    Ok(output::to_stdout(|out| {
        out.write_all(table.text().as_bytes())
    })?)
}
