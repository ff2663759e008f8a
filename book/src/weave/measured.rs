//! Numbers that were measured, out of the files that hold them.

use std::fs;
use std::path::Path;

/// The value at `key` in the file at `path`.
///
/// In a table (`.csv`, with a line of column names first; lines that start with
/// `#` don't count) the key is `ROW.COLUMN`, where a row goes by its first
/// column. In any other file it is what stands before the `:` or `=` of a line.
pub(super) fn value(path: &Path, key: &str) -> Result<String, String> {
    let shown = path.display();
    let text = fs::read_to_string(path).map_err(|cause| format!("{shown}: {cause}"))?;
    let found = match path.extension() {
        Some(extension) if extension == "csv" => in_table(&text, key),
        _ => in_lines(&text, key),
    };
    match found[..] {
        [value] => Ok(value.to_owned()),
        [] => Err(format!("{shown} has no value `{key}`")),
        _ => Err(format!("{shown} has several values `{key}`")),
    }
}

fn in_table<'a>(text: &'a str, key: &str) -> Vec<&'a str> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let columns: Vec<&str> = lines.next().unwrap_or("").split(',').collect();
    let Some((row, column)) = key.rsplit_once('.') else {
        return Vec::new();
    };
    let Some(at) = columns.iter().position(|name| *name == column) else {
        return Vec::new();
    };
    lines
        .map(|line| line.split(',').collect::<Vec<_>>())
        .filter(|cells| cells[0] == row)
        .filter_map(|cells| cells.get(at).copied())
        .collect()
}

fn in_lines<'a>(text: &'a str, key: &str) -> Vec<&'a str> {
    text.lines()
        .filter_map(|line| line.split_once([':', '=']))
        .filter(|(name, _)| name.trim() == key)
        .map(|(_, value)| value.trim())
        .collect()
}
