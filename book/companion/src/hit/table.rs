//! Streaming answers: a line for each case and method.

use std::error::Error;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;

use check::names;
use common::engine::output;
use speed_vs_accuracy::Method;

use super::cases::{Cases, Problem};
use super::number::shortest;

/// Prints `row,method,t` for each row of the file at `path` and each method.
///
/// # Errors
/// The first row that can't be read, by its line; the rows before it are
/// printed.
pub(crate) fn print(
    path: &Path,
    methods: &[Method],
    range: (f64, f64),
) -> Result<(), Box<dyn Error>> {
    let (name, input): (_, io::Result<Box<dyn BufRead>>) = match path.to_str() {
        Some("-") => (
            "standard input".to_owned(),
            Ok(Box::new(io::stdin().lock())),
        ),
        _ => (
            names::spelled(path),
            File::open(path).map(|file| Box::new(BufReader::new(file)) as _),
        ),
    };
    let input = input.map_err(|cause| format!("cannot read {name}: {cause}"))?;
    let mut done = Ok(());
    output::to_stdout(|out| {
        done = answer(input, methods, range, out)?;
        Ok(())
    })?;
    done.map_err(|problem| format!("{name}, {problem}").into())
}

/// Answers row by row until there is a problem with the input, which it returns.
///
/// # Errors
/// Those of `out`.
fn answer(
    input: impl BufRead,
    methods: &[Method],
    (t_min, t_max): (f64, f64),
    out: &mut dyn Write,
) -> io::Result<Result<(), Problem>> {
    let cases = match Cases::of(input) {
        Ok(cases) => cases,
        Err(problem) => return Ok(Err(problem)),
    };
    writeln!(out, "row,method,t")?;
    for (case, row) in cases.zip(1_u64..) {
        let case = match case {
            Ok(case) => case,
            Err(problem) => return Ok(Err(problem)),
        };
        for method in methods {
            let t = case.put_to(method, t_min, t_max);
            let t = t.map_or(String::new(), |t| shortest(method, t));
            writeln!(out, "{row},{},{t}", method.name)?;
        }
        // The next row may be long in coming.
        out.flush()?;
    }
    Ok(Ok(()))
}
