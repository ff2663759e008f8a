//! Numbers that were measured, out of the files that hold them.

use std::fs;
use std::path::Path;

/// The value at `key` in the file at `path`, as it is printed.
///
/// In a table (`.csv`, with a line of column names) the key is
/// `CELL/CELL.COLUMN`, where the cells are those that the row begins with. In any
/// file a `KEY: value` stands for itself, in a table behind a `#`.
pub(super) fn value(path: &Path, key: &str) -> Result<String, String> {
    let shown = path.display();
    let text = fs::read_to_string(path).map_err(|cause| format!("{shown}: {cause}"))?;
    let is_table = path.extension().is_some_and(|extension| extension == "csv");
    let found = match key.rsplit_once('.') {
        Some((cells, column)) if is_table => {
            in_table(&text, cells, column).map_err(|cause| format!("{shown}: {cause}"))?
        }
        _ => in_lines(&text, key),
    };
    match &found[..] {
        [value] => Ok(printed(value)),
        [] => Err(format!("{shown} has no value `{key}`")),
        _ => Err(format!("{shown} has several values `{key}`")),
    }
}

fn in_table(text: &str, cells: &str, column: &str) -> csv::Result<Vec<String>> {
    let mut table = figures::table::reader(text);
    let place = table.headers()?.iter().position(|name| name == column);
    let mut found = Vec::new();
    for row in table.records() {
        let row = row?;
        let is_wanted = cells
            .split('/')
            .zip(&row)
            .all(|(cell, field)| cell == field);
        if is_wanted && let Some(field) = place.and_then(|place| row.get(place)) {
            found.push(field.to_owned());
        }
    }
    Ok(found)
}

fn in_lines(text: &str, key: &str) -> Vec<String> {
    text.lines()
        .filter_map(|line| line.trim_start_matches(['#', ' ']).split_once(": "))
        .filter(|(name, _)| *name == key)
        .map(|(_, value)| value.trim().to_owned())
        .collect()
}

/// A power of ten as people write it: 2.5e-16 is 2.5·10⁻¹⁶.
fn printed(value: &str) -> String {
    match value.split_once('e') {
        Some((digits, power)) if value.parse::<f64>().is_ok() => {
            format!("{digits}·10<sup>{}</sup>", power.replace('-', "−"))
        }
        _ => value.to_owned(),
    }
}
