//! Comma-separated values (CSV): a file of numbers as rows of one type, read and
//! written.
//!
//! First there may be lines `# key: value` that say how it was measured, then a
//! line of column names, which are the names of the fields, then the rows.

use std::collections::BTreeMap;

use csv::{Error, ErrorKind, Reader, ReaderBuilder, StringRecord, Writer};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A type of row, of which one file is made.
pub trait Record: Serialize + DeserializeOwned {
    /// The file, as a path from the folder `book/notes`.
    const FILE: &str;
}

/// A file of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Table<Row> {
    /// The lines `# key: value` at the top.
    pub about: BTreeMap<String, String>,
    /// The rows, from the top.
    pub rows: Vec<Row>,
}

impl<Row> From<Vec<Row>> for Table<Row> {
    fn from(rows: Vec<Row>) -> Self {
        let about = BTreeMap::new();
        Self { about, rows }
    }
}

impl<Row: Record> Table<Row> {
    /// The table in `text`.
    ///
    /// # Errors
    /// What is wrong in which line and column of the file.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut reader = reader(text);
        let columns = reader.headers().expect("memory can be read").clone();
        let rows: Result<Vec<Row>, Error> = reader.deserialize().collect();
        match rows {
            Ok(rows) if rows.is_empty() => Err(format!("{} has no rows", Row::FILE)),
            Ok(rows) => Ok(Self {
                about: about(text),
                rows,
            }),
            Err(error) => Err(format!("{}, {}", Row::FILE, told(&error, &columns))),
        }
    }

    /// The file, which [`Table::read`] reads.
    pub fn text(&self) -> String {
        let about = self.about.iter();
        let about: String = about
            .map(|(key, value)| format!("# {key}: {value}\n"))
            .collect();
        let mut writer = Writer::from_writer(about.into_bytes());
        for row in &self.rows {
            writer.serialize(row).expect("no field of a row is a list");
        }
        let text = writer.into_inner().expect("memory takes it");
        String::from_utf8(text).expect("it is made of texts")
    }
}

/// A reader of `text`, for whom lines that begin with `#` are remarks.
pub fn reader(text: &str) -> Reader<&[u8]> {
    ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_reader(text.as_bytes())
}

/// The lines `# key: value` of `text`.
pub fn about(text: &str) -> BTreeMap<String, String> {
    let remarks = text.lines().filter_map(|line| line.strip_prefix("# "));
    remarks
        .filter_map(|remark| remark.split_once(": "))
        .map(|(key, value)| (key.to_owned(), value.to_owned()))
        .collect()
}

/// Line, column and cause: csv itself counts columns from 0.
fn told(error: &Error, columns: &StringRecord) -> String {
    let line = error.position().map_or(0, |position| position.line());
    match error.kind() {
        ErrorKind::Deserialize { err, .. } => {
            let column = err.field().and_then(|n| columns.get(n as usize));
            match column {
                Some(column) => format!("line {line}, column `{column}`: {}", err.kind()),
                None => format!("line {line}: {err}"),
            }
        }
        ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!("line {line}: {len} fields under {expected_len} columns"),
        _ => error.to_string(),
    }
}
