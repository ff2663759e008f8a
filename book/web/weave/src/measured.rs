//! Measured numbers, read from the tables (CSV) that hold them.

use std::path::Path;

use figures::number::as_printed;
use figures::table;

use crate::ground::read;

/// Returns the number at `key` in the table at `path`, as a page prints it.
///
/// The key is `CELL/CELL.COLUMN`, with the first cells of a row, or KEY of a line `# KEY: value`.
///
/// # Errors
/// If the file cannot be read, or does not have exactly one number with this key.
pub(crate) fn value(path: &Path, key: &str) -> Result<String, String> {
    let text = read(path)?;
    let found = match key.rsplit_once('.') {
        Some((cells, column)) => in_table(&text, cells, column)
            .map_err(|cause| format!("{}: {cause}", path.display()))?,
        None => table::about(&text).remove(key).into_iter().collect(),
    };
    match &found[..] {
        [value] => Ok(printed(value)),
        [] => Err(format!("{} has no value `{key}`", path.display())),
        _ => Err(format!("{} has several values `{key}`", path.display())),
    }
}

/// Returns all fields of this column whose row begins with `cells`.
fn in_table(text: &str, cells: &str, column: &str) -> csv::Result<Vec<String>> {
    let mut reader = table::reader(text);
    let place = reader.headers()?.iter().position(|name| name == column);
    let mut found = Vec::new();
    for row in reader.records() {
        let row = row?;
        let is_wanted = cells.split('/').zip(&row).all(|(cell, it)| cell == it);
        let field = place.and_then(|place| row.get(place));
        found.extend(field.filter(|_| is_wanted).map(str::to_owned));
    }
    Ok(found)
}

/// Writes a number as all pages do, an empty field as `none`, and other words as they are.
fn printed(value: &str) -> String {
    match value.parse::<f64>() {
        _ if value.is_empty() => "none".to_owned(),
        Ok(_) => as_printed(value),
        Err(_) => value.to_owned(),
    }
}
