//! Macrobenchmark: the chapters' programs against the book's own in C++, in turns.

use std::error::Error;
use std::fs::File;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;
use std::{env, io};

use clap::Parser;
use common::engine::output;
use figures::records::Race;
use figures::table::{Record, Table};
use measure::spread::Spread;
use measure::{machine, rival};
use slips::Chapter;

/// Draws each picture in turns with the C++ program, and says how long it took.
#[derive(Parser)]
struct Arguments {
    /// How often each picture is drawn; an odd number has a median
    #[arg(long, value_name = "N", default_value_t = 9, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,

    /// Keep the numbers in book/notes/speed; a chart is drawn from them
    #[arg(long)]
    record: bool,

    /// What `cargo bench` says to every benchmark
    #[arg(long, hide = true)]
    bench: bool,
}

/// In pixels, what shows best where the time goes.
const WIDEST: u32 = 3840;

/// Width in pixels, and whether the text goes into a file.
const COURSES: [(u32, bool); 3] = [(WIDEST, false), (WIDEST, true), (400, false)];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    let programs = build_chapters()?;
    let rival = rival::build(&programs.join("race"));
    if let Err(cause) = &rival {
        say(&format!(
            "THE C++ PROGRAM IS LEFT OUT, it can't be built: {cause}\n"
        ))?;
    }
    let machine = machine::machine();
    say(&format!("{machine}\n"))?;
    let mut races = Vec::new();
    for (width, to_file) in COURSES {
        for chapter in &Chapter::OF_THE_BOOK[1..] {
            let race = run_race(
                chapter.name(),
                width,
                to_file,
                arguments.rounds,
                rival.as_deref().ok(),
                &programs,
            )?;
            say(&format!("{}\n", shown(&race, rival.is_ok())))?;
            races.push(race);
        }
    }
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        let race = trace_race(*chapter, arguments.rounds, rival.as_deref().ok())?;
        say(&format!("{}\n", shown(&race, rival.is_ok())))?;
        races.push(race);
    }
    if arguments.record && rival.is_ok() {
        record(machine, races)?;
    }
    Ok(())
}

/// Builds the programs of the chapters as a reader would, and says in which folder
/// they are.
fn build_chapters() -> Result<PathBuf, Box<dyn Error>> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["build", "--release"]);
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        command.args(["--package", chapter.name()]);
    }
    if !command.status()?.success() {
        return Err("the chapters cannot be built".into());
    }
    // A benchmark is in `deps`, beside the programs.
    let folder = env::current_exe()?.ancestors().nth(2).map(Path::to_owned);
    Ok(folder.ok_or("this benchmark is not where cargo puts it")?)
}

fn run_race(
    chapter: &str,
    width: u32,
    to_file: bool,
    rounds: u32,
    rival: Option<&Path>,
    programs: &Path,
) -> io::Result<Race> {
    let width_text = width.to_string();
    let destination = || match to_file {
        true => File::create(programs.join("race").join("picture.ppm")).map(Stdio::from),
        false => Ok(Stdio::null()),
    };
    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        let mut command = Command::new(programs.join(chapter));
        command.args(["--width", &width_text, "-"]);
        ours.push(milliseconds(command.stdout(destination()?))?);
        if let Some(rival) = rival {
            let mut command = Command::new(rival);
            command.args([chapter, &width_text]);
            theirs.push(milliseconds(command.stdout(destination()?))?);
        }
    }
    let to = if to_file { "file" } else { "nowhere" };
    Ok(result(chapter, width, to, ours, theirs))
}

/// Without text, on one thread: the bytes of the picture in memory. The C++ program
/// prints nothing but their sum. Its process takes a millisecond or two to start.
fn trace_race(chapter: Chapter, rounds: u32, rival: Option<&Path>) -> io::Result<Race> {
    let picture = chapter.picture(WIDEST);
    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        let start = Instant::now();
        black_box(picture.rgb_with_threads(1));
        ours.push(1e3 * start.elapsed().as_secs_f64());
        if let Some(rival) = rival {
            let mut command = Command::new(rival);
            command.args([chapter.name(), &WIDEST.to_string(), "sum"]);
            theirs.push(milliseconds(command.stdout(Stdio::null()))?);
        }
    }
    Ok(result(chapter.name(), WIDEST, "traced", ours, theirs))
}

fn result(chapter: &str, width: u32, to: &str, ours: Vec<f64>, mut theirs: Vec<f64>) -> Race {
    if theirs.is_empty() {
        theirs.push(f64::NAN);
    }
    let [rust, cpp] = [ours, theirs].map(Spread::of);
    Race {
        chapter: chapter.to_owned(),
        width,
        to: to.to_owned(),
        rust_median_ms: rust.median,
        rust_least_ms: rust.least,
        rust_greatest_ms: rust.greatest,
        cpp_median_ms: cpp.median,
        cpp_least_ms: cpp.least,
        cpp_greatest_ms: cpp.greatest,
    }
}

/// How long the command takes from start to end.
fn milliseconds(command: &mut Command) -> io::Result<f64> {
    let start = Instant::now();
    let status = command.status()?;
    let took = 1e3 * start.elapsed().as_secs_f64();
    match status.success() {
        true => Ok(took),
        false => Err(io::Error::other(format!("{command:?} failed"))),
    }
}

fn shown(race: &Race, with_rival: bool) -> String {
    let mut line = format!(
        "{:<14} {:>4} wide to {:<8} {:8.2} ms ({:.2} to {:.2})",
        race.chapter,
        race.width,
        race.to,
        race.rust_median_ms,
        race.rust_least_ms,
        race.rust_greatest_ms
    );
    if with_rival {
        line += &format!(
            "  C++ {:8.2} ms ({:.2} to {:.2})  ratio {:5.1}",
            race.cpp_median_ms,
            race.cpp_least_ms,
            race.cpp_greatest_ms,
            race.ratio()
        );
    }
    line
}

/// Writes the numbers, from which the book draws its chart.
fn record(machine: String, rows: Vec<Race>) -> Result<(), io::Error> {
    let about = [("machine".to_owned(), machine)].into();
    let text = Table { about, rows }.text();
    // Cargo runs this in the folder of its package.
    let notes = Path::new("../notes");
    output::to_file(&notes.join(Race::FILE), |out| {
        out.write_all(text.as_bytes())
    })
}

fn say(what: &str) -> Result<(), io::Error> {
    output::to_stdout(|out| out.write_all(what.as_bytes()))
}
