//! Many questions from a file, one answer a line.

use std::error::Error;
use std::fmt;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

use common::output;
use common::rtweekend::*;
use csv::{ReaderBuilder, StringRecord, Trim};
use speed_vs_accuracy::{Method, Question};

use super::{finite, shortest};

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
    let (name, input): (_, Box<dyn Read>) = match path.to_str() {
        Some("-") => ("standard input".to_owned(), Box::new(io::stdin().lock())),
        _ => {
            let name = path.display().to_string();
            let file = File::open(path).map_err(|cause| format!("cannot read {name}: {cause}"))?;
            (name, Box::new(file))
        }
    };
    let mut problem = None;
    output::to_stdout(|out| {
        problem = answer(input, methods, range, out)?;
        Ok(())
    })?;
    match problem {
        Some(problem) => Err(format!("{name}, {problem}").into()),
        None => Ok(()),
    }
}

/// What is wrong with the input, and where.
struct Problem {
    line: u64,
    what: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, what } = self;
        write!(f, "line {line}: {what}")
    }
}

/// Answers row by row until there is a problem, which it returns.
///
/// # Errors
/// Those of `out`.
fn answer(
    input: Box<dyn Read>,
    methods: &[Method],
    (t_min, t_max): (f64, f64),
    out: &mut dyn Write,
) -> io::Result<Option<Problem>> {
    let mut rows = ReaderBuilder::new()
        .trim(Trim::All)
        .buffer_capacity(1 << 16)
        .from_reader(input);
    let columns = match rows.headers().map_err(unreadable).and_then(find_columns) {
        Ok(columns) => columns,
        Err(problem) => return Ok(Some(problem)),
    };
    writeln!(out, "row,method,t")?;
    let mut row = StringRecord::new();
    let mut number = 0_u64;
    loop {
        match rows.read_record(&mut row).map_err(unreadable) {
            Ok(false) => return Ok(None),
            Ok(true) => {}
            Err(problem) => return Ok(Some(problem)),
        }
        let question = match parse(&row, &columns) {
            Ok(question) => question,
            Err(problem) => return Ok(Some(problem)),
        };
        number += 1;
        for method in methods {
            let t = question.put_to(method, t_min, t_max);
            let t = t.map_or(String::new(), |t| shortest(method, t));
            writeln!(out, "{number},{},{t}", method.name)?;
        }
    }
}

/// The columns that a question is made of, in this order.
const NAMES: [&str; 10] = ["ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"];

/// Where each of [`NAMES`] stands.
fn find_columns(head: &StringRecord) -> Result<[usize; 10], Problem> {
    let mut columns = [0; 10];
    for (column, name) in columns.iter_mut().zip(NAMES) {
        let mut places = head.iter().zip(0..).filter(|(found, _)| *found == name);
        *column = match (places.next(), places.next()) {
            (Some((_, place)), None) => place,
            (None, _) => return Err(in_head(format!("there is no column {name}"))),
            _ => return Err(in_head(format!("there are two columns {name}"))),
        };
    }
    Ok(columns)
}

fn in_head(what: String) -> Problem {
    let what = format!("{what}; the columns {} are needed", NAMES.join(","));
    Problem { line: 1, what }
}

fn parse(row: &StringRecord, columns: &[usize; 10]) -> Result<Question, Problem> {
    let mut numbers = [0.0; 10];
    for ((number, &column), name) in numbers.iter_mut().zip(columns).zip(NAMES) {
        let text = row.get(column).unwrap_or_default();
        *number = finite(text).map_err(|problem| Problem {
            line: row.position().map_or(0, csv::Position::line),
            what: match text {
                "" => format!("{name} is empty"),
                _ => format!("{name} is {text:?}, which {problem}"),
            },
        })?;
    }
    let [ox, oy, oz, dx, dy, dz, cx, cy, cz, r] = numbers;
    Ok(Question {
        center: Point3::new(cx, cy, cz),
        radius: r,
        ray: Ray::new(Point3::new(ox, oy, oz), Vec3::new(dx, dy, dz)),
    })
}

fn unreadable(error: csv::Error) -> Problem {
    let line = error.position().map_or(1, csv::Position::line);
    let what = match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!("there are {len} fields, but {expected_len} column names"),
        csv::ErrorKind::Utf8 { .. } => "this is no text in UTF-8".to_owned(),
        csv::ErrorKind::Io(cause) => format!("it can't be read: {cause}"),
        _ => error.to_string(),
    };
    Problem { line, what }
}
