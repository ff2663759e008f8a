//! A search: how close cases can come to the error bounds of chapter 6.

use std::error::Error;
use std::path::Path;

use clap::Parser;
use common::engine::output;
use figures::records::Tightness;
use figures::table::{Record, Table};
use measure::climb::{Effort, closest};
use measure::tightness::{self, BOUNDS};

/// How close cases can come to the error bounds of chapter 6.
///
/// Begins at what is recorded, among others, so it never finds less.
#[derive(Parser)]
struct Arguments {
    /// How many climbs in each of five rounds
    #[arg(long, value_name = "N", default_value_t = 64)]
    climbs: usize,

    /// How many changes a climb tries
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    steps: u32,

    /// Which search
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// Keep the result in book/notes/measured
    #[arg(long)]
    record: bool,

    /// What `cargo bench` says to every benchmark
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments {
        climbs,
        steps,
        seed,
        record,
        ..
    } = Arguments::parse();
    let effort = Effort {
        climbs,
        steps,
        seed,
    };
    let known: Vec<_> = tightness::recorded()
        .rows
        .iter()
        .map(tightness::witness)
        .collect();
    let mut rows = Vec::new();
    for bound in &BOUNDS {
        let found = closest(bound, &known, effort).ok_or("a search without a witness")?;
        let share = found.attained / bound.proved;
        let row = bound.row(&found);
        let Tightness {
            bound,
            unit,
            constant,
            proved,
            attained,
            ..
        } = &row;
        println!(
            "{bound:10} {unit:4} code {constant:4} proved {proved:5} attained {attained:7.2}, {share:.2} of the proof"
        );
        println!("{}\n", found.asked);
        rows.push(row);
    }
    if record {
        keep(rows.into())?;
    }
    Ok(())
}

/// Writes the witnesses, which a test puts to the methods and the book shows.
fn keep(mut table: Table<Tightness>) -> Result<(), output::OutputError> {
    let command = "cargo bench -p measure --bench tightness -- --record";
    table.about.insert("command".to_owned(), command.to_owned());
    let notes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../notes");
    output::to_file(&notes.join(Tightness::FILE), |out| {
        out.write_all(table.text().as_bytes())
    })
}
