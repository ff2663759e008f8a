//! CSV: a row for each case, read as it comes.

use std::fmt;
use std::io::{self, BufRead, Cursor, Read};

use csv::{Reader, ReaderBuilder, StringRecord, Trim};
use speed_vs_accuracy::Case;

use super::lines::Lines;
use super::number::finite;

/// The most rows that are read. All methods together take seconds for them.
const MOST_ROWS: u64 = 1_000_000;

/// The columns that a case is made of, in this order.
const NAMES: [&str; 10] = ["ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"];

/// The cases in a text, row by row, until there is a problem.
///
/// Takes no more memory than the longest row.
pub(super) struct Cases<R> {
    rows: Reader<Lines<R>>,
    /// Where each of [`NAMES`] stands.
    columns: [usize; 10],
    row: StringRecord,
    count: u64,
}

/// What is wrong with a row, and at which line it begins.
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
        let mut rows = ReaderBuilder::new()
            .trim(Trim::All)
            .from_reader(Lines::of(input));
        let columns = rows.headers().map_err(unreadable).and_then(find_columns);
        match columns {
            Ok(columns) => Ok(Self {
                rows,
                columns,
                row: StringRecord::new(),
                count: 0,
            }),
            Err(what) => Err(problem(&rows, what)),
        }
    }

    /// The next case, `None` at the end, or what is wrong.
    fn read(&mut self) -> Result<Option<Case>, String> {
        self.rows.get_mut().begin_row();
        if !self.rows.read_record(&mut self.row).map_err(unreadable)? {
            return Ok(None);
        }
        if self.count == MOST_ROWS {
            return Err(format!("the file has more than {MOST_ROWS} rows: split it"));
        }
        self.count += 1;
        parse(&self.row, &self.columns).map(Some)
    }
}

impl<R: BufRead> Iterator for Cases<R> {
    type Item = Result<Case, Problem>;

    fn next(&mut self) -> Option<Self::Item> {
        self.read()
            .map_err(|what| problem(&self.rows, what))
            .transpose()
    }
}

/// `input` without the mark that some editors put before a text.
pub(super) fn without_byte_order_mark(mut input: impl BufRead) -> io::Result<impl BufRead> {
    let mut start = Vec::new();
    input.by_ref().take(3).read_to_end(&mut start)?;
    if start == b"\xef\xbb\xbf" {
        start.clear();
    }
    Ok(Cursor::new(start).chain(input))
}

fn problem<R: BufRead>(rows: &Reader<Lines<R>>, what: String) -> Problem {
    let line = rows.get_ref().line_of_row();
    Problem { line, what }
}

fn unreadable(error: csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!("the fields are {len}, but the column names are {expected_len}"),
        csv::ErrorKind::Utf8 { .. } => "this is no text in UTF-8".to_owned(),
        _ => error.to_string(),
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
        let text = row.get(column).unwrap_or_default();
        *number = finite(text).map_err(|problem| match text.char_indices().nth(LONGEST) {
            _ if text.is_empty() => format!("{name} is empty"),
            None => format!("{name} is {text:?}, which {problem}"),
            Some((end, _)) => format!("{name} is {:?} and so on, which {problem}", &text[..end]),
        })?;
    }
    let [ox, oy, oz, dx, dy, dz, cx, cy, cz, r] = numbers;
    Ok(Case::from_numbers([cx, cy, cz, r, ox, oy, oz, dx, dy, dz]))
}

/// How many characters of a field a message shows: after a quotation mark that
/// is left open, the field may be as long as a row.
const LONGEST: usize = 40;
