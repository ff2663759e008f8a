//! Comma-separated values (CSV): a file of numbers as rows of one type, read and written.
//!
//! A file may begin with lines `# key: value` that say how its numbers were measured. Then come a
//! line of column names, which are the names of the fields, and the rows.

use std::collections::BTreeMap;

use csv::{Error, Reader, ReaderBuilder, Writer};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::number::three_digits;

/// A struct whose values are the rows of one CSV file of the book, with a column for each field.
pub trait Record: Serialize + DeserializeOwned {
    /// The path of the file from the folder `book/notes`.
    const FILE: &str;
}

/// The content of a CSV file of numbers: rows of one type, and facts about them.
#[derive(Clone, Debug, PartialEq)]
pub struct Table<Row> {
    /// The facts from the lines `# key: value` of the file, by key, such as how its numbers were
    /// measured; empty if it has none.
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
    /// Reads a table from `text`, the whole text of its file.
    ///
    /// # Errors
    /// A message that names the file and the line that is wrong, or says that there are no rows.
    pub fn read(text: &str) -> Result<Self, String> {
        let rows: Result<Vec<Row>, Error> = reader(text).deserialize().collect();
        let rows = rows.map_err(|error| format!("{}: {error}", Row::FILE))?;
        if rows.is_empty() {
            return Err(format!("{} has no rows", Row::FILE));
        }
        let about = about(text);
        Ok(Self { about, rows })
    }

    /// Returns the text of a file that [`Table::read`] can read: facts, column names and rows.
    /// Numbers with a fraction have three significant digits.
    ///
    /// # Panics
    /// If a field of a row is a list.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for (key, value) in &self.about {
            text += &format!("# {key}: {value}\n");
        }
        let mut writer = Writer::from_writer(Vec::new());
        for row in &self.rows {
            writer.serialize(row).expect("no field of a row is a list");
        }
        let rows = writer.into_inner().expect("memory takes it");
        let rows = String::from_utf8(rows).expect("it is made of texts");
        for row in rows.lines() {
            let fields: Vec<String> = row.split(',').map(in_few_digits).collect();
            text += &(fields.join(",") + "\n");
        }
        text
    }
}

fn in_few_digits(field: &str) -> String {
    match field.parse() {
        Ok(value) if field.contains(['.', 'e']) => three_digits(value),
        _ => field.to_owned(),
    }
}

/// Makes a CSV reader of `text`, whose first row names the columns. It skips lines that begin with
/// `#`.
pub fn reader(text: &str) -> Reader<&[u8]> {
    ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_reader(text.as_bytes())
}

/// Returns the facts from the lines `# key: value` of `text`, by key; of two with one key, the
/// later counts. Other lines count for nothing.
pub fn about(text: &str) -> BTreeMap<String, String> {
    let remarks = text.lines().filter_map(|line| line.strip_prefix("# "));
    remarks
        .filter_map(|remark| remark.split_once(": "))
        .map(|(key, value)| (key.to_owned(), value.to_owned()))
        .collect()
}
