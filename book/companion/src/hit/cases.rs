//! CSV: a row for each case, read as it comes.

use std::fmt;
use std::io::{BufRead, Read};

use csv::{ReaderBuilder, StringRecord, Terminator, Trim};
use speed_vs_accuracy::Case;

use super::number::finite;

/// The most lines that are read. All methods together take seconds for them.
const MOST_LINES: u64 = 1_000_000;

/// The longest line, in bytes. Ten numbers take less than 11 000, even if each is as long
/// as an `f64` can be in decimal digits.
const MOST_BYTES_OF_A_LINE: u64 = 1 << 16;

/// The largest file, in bytes. A million rows of ten numbers with all their digits fit.
const MOST_BYTES: usize = 1 << 28;

/// The columns that a case is made of, in this order.
const NAMES: [&str; 10] = ["ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"];

/// The cases in a text, line by line, until there is a problem.
///
/// Takes no more memory than the longest line.
pub(super) struct Cases<R> {
    input: R,
    /// How many fields a row has.
    width: usize,
    /// Where each of [`NAMES`] stands.
    columns: [usize; 10],
    lines: u64,
    bytes: usize,
}

/// What is wrong, and in which line.
pub(super) struct Problem {
    line: u64,
    what: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, what } = self;
        write!(f, "line {line}: {what}")
    }
}

impl<R: BufRead> Cases<R> {
    /// Reads the names of the columns.
    pub(super) fn of(input: R) -> Result<Self, Problem> {
        let mut cases = Self {
            input,
            width: 0,
            columns: [0; 10],
            lines: 0,
            bytes: 0,
        };
        let head = cases.row().and_then(|head| {
            let head = head.unwrap_or_default();
            Ok((head.len(), find_columns(&head)?))
        });
        (cases.width, cases.columns) = head.map_err(|what| cases.problem(what))?;
        Ok(cases)
    }

    /// The next case, `None` at the end, or what is wrong.
    fn read(&mut self) -> Result<Option<Case>, String> {
        let Some(row) = self.row()? else {
            return Ok(None);
        };
        if row.len() != self.width {
            let (fields, names) = (row.len(), self.width);
            return Err(format!(
                "this row has {fields} fields, but there are {names} column names"
            ));
        }
        parse(&row, &self.columns).map(Some)
    }

    /// The fields of the next line that has any.
    fn row(&mut self) -> Result<Option<StringRecord>, String> {
        loop {
            let mut line = Vec::new();
            let mut limited = self.input.by_ref().take(MOST_BYTES_OF_A_LINE + 1);
            let length = limited.read_until(b'\n', &mut line);
            let length = length.map_err(|cause| format!("cannot read on: {cause}"))?;
            if length == 0 {
                return Ok(None);
            }
            self.lines += 1;
            self.bytes += length;
            if length as u64 > MOST_BYTES_OF_A_LINE {
                return Err(format!(
                    "it has more than {MOST_BYTES_OF_A_LINE} bytes: is this a CSV file?"
                ));
            }
            if self.lines > MOST_LINES || self.bytes > MOST_BYTES {
                return Err(format!(
                    "the file has more than {MOST_LINES} lines or {MOST_BYTES} bytes: split it"
                ));
            }
            // Some editors put a mark before a text.
            let text = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&line);
            if text.trim_ascii().is_empty() {
                continue;
            }
            let mut rows = ReaderBuilder::new()
                .has_headers(false)
                .terminator(Terminator::Any(b'\n'))
                .trim(Trim::All)
                .from_reader(text);
            let row = rows.records().next().transpose();
            return row.map_err(|_| "this is no text in UTF-8".to_owned());
        }
    }

    fn problem(&self, what: String) -> Problem {
        let line = self.lines.max(1);
        Problem { line, what }
    }
}

impl<R: BufRead> Iterator for Cases<R> {
    type Item = Result<Case, Problem>;

    fn next(&mut self) -> Option<Self::Item> {
        self.read().map_err(|what| self.problem(what)).transpose()
    }
}

fn find_columns(head: &StringRecord) -> Result<[usize; 10], String> {
    let mut columns = [0; 10];
    for (column, name) in columns.iter_mut().zip(NAMES) {
        let mut places = head.iter().zip(0..).filter(|(found, _)| *found == name);
        *column = match (places.next(), places.next()) {
            (Some((_, place)), None) => place,
            (None, _) => return Err(needed(&format!("there is no column {name}"))),
            _ => return Err(needed(&format!("there are two columns {name}"))),
        };
    }
    Ok(columns)
}

fn needed(what: &str) -> String {
    format!("{what}; the columns {} are needed", NAMES.join(","))
}

/// The case in a row, or what is wrong with it.
fn parse(row: &StringRecord, columns: &[usize; 10]) -> Result<Case, String> {
    let mut numbers = [0.0; 10];
    for ((number, &column), name) in numbers.iter_mut().zip(columns).zip(NAMES) {
        let text = &row[column];
        *number = finite(text).map_err(|problem| {
            let start: String = text.chars().take(LONGEST).collect();
            format!("{name} is {start:?}, which {problem}")
        })?;
    }
    let [ox, oy, oz, dx, dy, dz, cx, cy, cz, r] = numbers;
    Ok(Case::from_numbers([cx, cy, cz, r, ox, oy, oz, dx, dy, dz]))
}

/// How many characters of a field a message shows: after a quotation mark that is left
/// open, it may be as long as a line.
const LONGEST: usize = 40;
