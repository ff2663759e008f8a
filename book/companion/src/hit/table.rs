//! CSV: a row for each case, answered as it comes.

use std::error::Error;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use check::names;
use common::engine::output;
use csv::{ReaderBuilder, StringRecord, Trim};
use speed_vs_accuracy::{Case, Method};

use super::number::{finite, shortest};

/// The columns that a case is made of, in this order.
const NAMES: [&str; 10] = ["ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"];

/// Prints `row,method,t` for each row of the file at `path` and each method.
///
/// # Errors
/// The first row that can't be read, by its line; the rows before it are
/// printed.
pub(crate) fn print(
    path: &Path,
    methods: &[Method],
    (t_min, t_max): (f64, f64),
) -> Result<(), Box<dyn Error>> {
    let (name, input): (_, io::Result<Box<dyn Read>>) = match path.to_str() {
        Some("-") => ("standard input".to_owned(), Ok(Box::new(io::stdin()))),
        _ => (
            names::spelled(path),
            File::open(path).map(|file| Box::new(file) as _),
        ),
    };
    let input = input.map_err(|cause| format!("cannot read {name}: {cause}"))?;
    let mut read = Ok(());
    output::to_stdout(|out| {
        writeln!(out, "row,method,t")?;
        let print = |row: u64, case: &Case| {
            for method in methods {
                let t = case.put_to(method, t_min, t_max);
                let t = t.map_or(String::new(), |t| shortest(method, t));
                writeln!(out, "{row},{},{t}", method.name)?;
            }
            // The next row may be long in coming.
            out.flush()
        };
        read = each_case(input, print);
        Ok(())
    })?;
    read.map_err(|problem| format!("{name}, {problem}").into())
}

/// Hands on the number of each row, from 1, and the case in it.
fn each_case(
    input: impl Read,
    mut print: impl FnMut(u64, &Case) -> io::Result<()>,
) -> Result<(), Box<dyn Error>> {
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(input);
    let head = reader.headers()?;
    let place = |name: &str| head.iter().position(|it| it == name);
    let needed = |name: &str| format!("there is no column {name}; {} are needed", NAMES.join(","));
    let columns: Vec<usize> = NAMES
        .iter()
        .map(|name| place(name).ok_or_else(|| needed(name)))
        .collect::<Result<_, _>>()?;
    for (row, number) in reader.records().zip(1..) {
        let row = row?;
        let line = row.position().map_or(0, csv::Position::line);
        let case = case(&row, &columns).map_err(|problem| format!("line {line}: {problem}"))?;
        print(number, &case)?;
    }
    Ok(())
}

/// The case in a row, or what is wrong with it.
fn case(row: &StringRecord, columns: &[usize]) -> Result<Case, String> {
    let mut numbers = [0.0; 10];
    for ((number, &column), name) in numbers.iter_mut().zip(columns).zip(NAMES) {
        let text = &row[column];
        *number = finite(text).map_err(|problem| format!("{name} is {text:?}, which {problem}"))?;
    }
    let [ox, oy, oz, dx, dy, dz, cx, cy, cz, r] = numbers;
    Ok(Case::from_numbers([cx, cy, cz, r, ox, oy, oz, dx, dy, dz]))
}
