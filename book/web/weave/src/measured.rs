//! Numbers that were measured, out of the tables (CSV) that hold them.

use std::path::Path;

use figures::table;

use crate::ground::read;

/// The value at `key` in the table at `path`, as it is printed.
///
/// The key is `CELL/CELL.COLUMN`, where the cells are those that the row begins
/// with, or that of a line `# KEY: value`.
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

/// A power of ten as people write it: 2.5e-16 is 2.5·10⁻¹⁶. An empty field is `none`.
fn printed(value: &str) -> String {
    match value.split_once('e') {
        None if value.is_empty() => "none".to_owned(),
        Some((digits, power)) if value.parse::<f64>().is_ok() => {
            format!("{digits}·10<sup>{}</sup>", power.replace('-', "−"))
        }
        _ => value.to_owned(),
    }
}
