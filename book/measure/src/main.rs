//! Measures the methods of chapter 6 with a clock.

mod about;
mod contest;
mod growth;
mod many;
mod one_by_one;

use std::error::Error;
use std::num::NonZeroUsize;
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use common::output;
use tests::accuracy;
use tests::timings::{Timing, Timings};

use contest::{Effort, Heat};

/// How long each method of chapter 6 takes, and each way to keep many spheres.
#[derive(Parser)]
struct Arguments {
    /// A tenth of the rounds: within seconds instead of a minute or two
    #[arg(long)]
    quick: bool,

    /// Keep the result in book/notes/measured/timings.csv
    #[arg(long)]
    record: bool,

    /// Instead of times, how exact each method is: from N questions in each
    /// regime
    #[arg(long, value_name = "N", conflicts_with_all = ["quick", "record"])]
    accuracy: Option<NonZeroUsize>,

    /// Which questions
    #[arg(long, value_name = "N", default_value_t = 1, requires = "accuracy")]
    seed: u64,
}

/// What it takes, because a build for debugging is slow in its own way.
const COMMAND: &str = "cargo run --release -p measure";

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let done = match arguments.accuracy {
        Some(cases) => say(&accuracy::table(cases.get(), arguments.seed)),
        None if cfg!(debug_assertions) => {
            eprintln!("this build is for debugging: its times say nothing. Run\n    {COMMAND}");
            return ExitCode::from(2);
        }
        None => measure(&arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("measure: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Takes all times, and prints or keeps them.
fn measure(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let effort = Effort::new(arguments.quick);
    let mut heats: Vec<Heat> = one_by_one::heats();
    heats.push(many::heat());
    heats.extend(growth::heats(arguments.quick)?);
    let timings = Timings {
        about: about::about(&effort),
        rows: contest::run(heats, &effort),
    };
    let mut said = about::table(&timings);
    said += &headlines(&timings);
    if arguments.record {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../notes/measured/timings.csv");
        output::to_file(&path, |out| out.write_all(timings.text().as_bytes()))?;
        said += &format!("Kept in {}\n", path.display());
    }
    say(&said)
}

/// The numbers that the chapter promises something about.
fn headlines(timings: &Timings) -> String {
    let mut text = "\nTimes half_b, one ray after the other:\n".to_owned();
    for name in ["certified_hit", "certified_t"] {
        let ratio = |place| ratio(timings.find("method", name, place));
        text += &format!(
            "  {name:<14} {} on the book’s camera rays, {} if all hit\n",
            ratio("book"),
            ratio("all_hits")
        );
    }
    let is_limit = |row: &&Timing| row.name == "packed" && row.precision == "f64";
    let limit = timings.rows.iter().find(is_limit);
    if let Some((limit, batch)) = limit.zip(timings.find("batch", "half_b", "book")) {
        text += &format!(
            "half_b in a batch reaches {:.0} % of what the divider allows: {:.2} of {:.2} ns\n",
            100.0 * limit.least / batch.least,
            batch.least,
            limit.least,
        );
    }
    text + &growth::crossovers(&timings.rows)
}

fn ratio(row: Option<&Timing>) -> String {
    row.map_or("not measured".to_owned(), |row| format!("{:.2}", row.ratio))
}

fn say(text: &str) -> Result<(), Box<dyn Error>> {
    Ok(output::to_stdout(|out| out.write_all(text.as_bytes()))?)
}
