//! Many questions from a file, one answer a line.

use std::error::Error;
use std::io::{self, Read, Write};
use std::path::Path;
use std::{fmt, fs};

use common::engine::output;
use common::rtweekend::*;
use csv::{ReaderBuilder, StringRecord, Trim};
use speed_vs_accuracy::{Case, Method};

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
    let (name, bytes) = match path.to_str() {
        Some("-") => ("standard input".to_owned(), all_of_stdin()),
        _ => (path.display().to_string(), fs::read(path)),
    };
    let bytes = bytes.map_err(|cause| format!("cannot read {name}: {cause}"))?;
    let text = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&bytes);
    let mut problem = None;
    output::to_open_stdout(|out| {
        problem = answer(text, methods, range, out)?;
        Ok(())
    })?;
    match problem {
        Some(problem) => Err(format!("{name}, {problem}").into()),
        None => Ok(()),
    }
}

/// What some editors put before a text.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

fn all_of_stdin() -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What is wrong with the input, and where.
struct Problem {
    line: usize,
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
    text: &[u8],
    methods: &[Method],
    (t_min, t_max): (f64, f64),
    out: &mut dyn Write,
) -> io::Result<Option<Problem>> {
    let unreadable = |error| unreadable(&error, text);
    let mut rows = ReaderBuilder::new().trim(Trim::All).from_reader(text);
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
            Err(what) => {
                let line = line_of(row.position(), text);
                return Ok(Some(Problem { line, what }));
            }
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

/// The question in a row, or what is wrong with it.
fn parse(row: &StringRecord, columns: &[usize; 10]) -> Result<Case, String> {
    let mut numbers = [0.0; 10];
    for ((number, &column), name) in numbers.iter_mut().zip(columns).zip(NAMES) {
        let text = row.get(column).unwrap_or_default();
        *number = finite(text).map_err(|problem| match text.char_indices().nth(LONGEST) {
            _ if text.is_empty() => format!("{name} is empty"),
            None => format!("{name} is {text:?}, which {problem}"),
            Some((end, _)) => format!("{name} is {:?} and so on, which {problem}", &text[..end]),
        })?;
    }
    let [ox, oy, oz, dx, dy, dz, cx, cy, cz, r] = numbers;
    Ok(Case {
        center: Point3::new(cx, cy, cz),
        radius: r,
        ray: Ray::new(Point3::new(ox, oy, oz), Vec3::new(dx, dy, dz)),
    })
}

/// How many characters of a field a message shows: after a quotation mark that
/// is left open, the field is the rest of the file.
const LONGEST: usize = 40;

fn unreadable(error: &csv::Error, text: &[u8]) -> Problem {
    let line = line_of(error.position(), text);
    let what = match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!("the fields are {len}, but the column names are {expected_len}"),
        csv::ErrorKind::Utf8 { .. } => "this is no text in UTF-8".to_owned(),
        _ => error.to_string(),
    };
    Problem { line, what }
}

/// The line on which the row at `position` begins. A row begins, as its reader
/// counts, where the row before has ended: before empty lines, and between the
/// two characters that end a line on Windows.
fn line_of(position: Option<&csv::Position>, text: &[u8]) -> usize {
    let before = position.map_or(0, |position| position.byte() as usize);
    let empty = text[before..]
        .iter()
        .take_while(|&&byte| byte == b'\r' || byte == b'\n');
    let start = before + empty.count();
    1 + text[..start].iter().filter(|&&byte| byte == b'\n').count()
}
