//! Measurements: how exact each method of chapter 6 is, how many pixels it gets
//! wrong, and how long everything takes.

pub mod accuracy;
pub mod contest;
pub mod cost;
pub mod machine;
pub mod map;
pub mod needs;
pub mod rival;
pub mod scene_file;
pub mod spread;
pub mod wrong_pixels;

use std::path::Path;
use std::{fs, io};

use figures::table::{Record, Table};

/// Writes a table into the file of `book/notes` from which the book shows it, in place of an
/// earlier one. The current folder has to be `book/measure`, in which cargo runs a benchmark.
///
/// # Errors
/// If the file can't be written.
pub fn save<Row: Record>(table: &Table<Row>) -> io::Result<()> {
    let file = Path::new("../notes").join(Row::FILE);
    fs::write(file, table.text())
}
