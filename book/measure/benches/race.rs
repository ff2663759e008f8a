//! Macrobenchmark: the chapters' programs against the book's own in C++, in turns.
//!
//! `--rounds N` says how often each picture is drawn (9 times without it; an odd number has a
//! median). `--record` keeps the numbers in `book/notes/speed`, which a page shows.

use std::error::Error;
use std::hint::black_box;
use std::io::{self, Write};
use std::num::NonZeroU32;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;
use std::{env, fmt};

use figures::table::{Record, Table};
use lexopt::{Arg::Long, ValueExt};
use measure::spread::Spread;
use measure::{machine, rival};
use serde::{Deserialize, Serialize};
use slips::{Chapter, ChapterCode};

/// The width of the pictures in pixels, at which tracing takes most of the time.
const WIDEST: u32 = 3840;

/// The kinds of races: whole programs, whose text is thrown away, and tracing alone, without text.
const COURSES: [&str; 2] = ["nowhere", "traced"];

fn main() -> Result<(), Box<dyn Error>> {
    let (mut rounds, mut record) = (9, false);
    let mut words = lexopt::Parser::from_env();
    while let Some(word) = words.next()? {
        match word {
            Long("rounds") => rounds = words.value()?.parse::<NonZeroU32>()?.get(),
            Long("record") => record = true,
            // The word that `cargo bench` says to every benchmark.
            Long("bench") => {}
            odd => return Err(odd.unexpected().into()),
        }
    }
    let programs = build_chapters()?;
    // Cargo runs a benchmark in the folder of its package.
    let rival = rival::compile(Path::new("rival/book.cc"), &programs.join("race"));
    if let Err(cause) = &rival {
        say(&format!(
            "THE C++ PROGRAM IS LEFT OUT, it can't be built: {cause}\n"
        ))?;
    }
    let rival = rival.ok();
    let machine = machine::description();
    say(&format!("{machine}\n"))?;
    let mut races = Vec::new();
    for to in COURSES {
        for chapter in &Chapter::OF_THE_BOOK[1..] {
            let times = run_race(
                *chapter,
                to == "traced",
                rounds,
                rival.as_deref(),
                &programs,
            )?;
            let race = Race::new(chapter.name(), to, times);
            say(&format!("{race}\n"))?;
            races.push(race);
        }
    }
    if record && rival.is_some() {
        let about = [("machine".to_owned(), machine)].into();
        measure::save(&Table { about, rows: races })?;
    }
    Ok(())
}

/// Builds the programs of the chapters as a reader would, and returns the folder that they are in.
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

/// Returns the milliseconds of each run of our program and of the C++ program.
///
/// A traced picture is kept as bytes in memory, on one thread. The C++ program prints nothing but
/// their sum then. Its process takes a millisecond or two to start.
fn run_race(
    chapter: Chapter,
    is_traced: bool,
    rounds: u32,
    rival: Option<&Path>,
    programs: &Path,
) -> io::Result<[Vec<f64>; 2]> {
    let (picture, width) = (chapter.picture(WIDEST), WIDEST.to_string());
    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        ours.push(if is_traced {
            let start = Instant::now();
            black_box(picture.rgb_with_threads(1));
            1e3 * start.elapsed().as_secs_f64()
        } else {
            let mut command = Command::new(programs.join(chapter.name()));
            milliseconds(command.args(["--width", &width, "-"]))?
        });
        if let Some(rival) = rival {
            let mut command = Command::new(rival);
            command.args([chapter.name(), &width]);
            command.args(is_traced.then_some("sum"));
            theirs.push(milliseconds(&mut command)?);
        }
    }
    Ok([ours, theirs])
}

/// The times of our program and of the C++ program for the same picture: of whole processes, from
/// start to end.
#[derive(Deserialize, Serialize)]
struct Race {
    /// The name of the chapter whose picture it is.
    chapter: String,
    /// The width of the picture in pixels.
    width: u32,
    /// One of [`COURSES`].
    to: String,
    /// The median time of our program's runs, in milliseconds.
    rust_median_ms: f64,
    /// The median time of the C++ program's runs, in milliseconds; NaN without one.
    cpp_median_ms: f64,
    /// The median time of the C++ program divided by ours.
    ratio: f64,
}

impl Record for Race {
    const FILE: &str = "speed/heats.csv";
}

impl Race {
    fn new(chapter: &str, to: &str, times: [Vec<f64>; 2]) -> Self {
        let median = |times: Vec<f64>| match times[..] {
            [] => f64::NAN,
            _ => Spread::of(times).median,
        };
        let [rust, cpp] = times.map(median);
        Self {
            chapter: chapter.to_owned(),
            width: WIDEST,
            to: to.to_owned(),
            rust_median_ms: rust,
            cpp_median_ms: cpp,
            ratio: cpp / rust,
        }
    }
}

impl fmt::Display for Race {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            chapter,
            to,
            rust_median_ms: rust,
            cpp_median_ms: cpp,
            ratio,
            ..
        } = self;
        write!(
            f,
            "{chapter:<14}{to:<8} {rust:8.2} ms  C++ {cpp:8.2} ms  ratio {ratio:5.1}"
        )
    }
}

/// Measures the milliseconds that the command takes from start to end.
fn milliseconds(command: &mut Command) -> io::Result<f64> {
    let start = Instant::now();
    let status = command.stdout(Stdio::null()).status()?;
    let took = 1e3 * start.elapsed().as_secs_f64();
    if status.success() {
        Ok(took)
    } else {
        Err(io::Error::other(format!("{command:?} failed")))
    }
}

fn say(what: &str) -> Result<(), io::Error> {
    io::stdout().write_all(what.as_bytes())
}
