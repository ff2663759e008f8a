//! Helpers of the directives: names, files, and HTML.

use std::fs;
use std::path::Path;

pub(crate) use figures::escape as escaped;

/// Returns the one of `all` whose name is `name`. `kind` says in the error what was looked for.
///
/// # Errors
/// If there is none; the message lists the names that there are.
pub(crate) fn named<T>(
    kind: &str,
    name: &str,
    all: impl IntoIterator<Item = T>,
    name_of: impl Fn(&T) -> &'static str,
) -> Result<T, String> {
    let mut names = Vec::new();
    for one in all {
        if name_of(&one) == name {
            return Ok(one);
        }
        names.push(name_of(&one));
    }
    let names = names.join(", ");
    Err(format!("there is no {kind} `{name}`: there are {names}"))
}

/// Reads the text of a file.
///
/// # Errors
/// A message with the path, and why the file cannot be read.
pub(crate) fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|cause| format!("{}: {cause}", path.display()))
}

/// Returns the first word of the text, and the rest; either may be empty.
pub(crate) fn split(text: &str) -> (&str, &str) {
    let (first, rest) = text.split_once(' ').unwrap_or((text, ""));
    (first, rest.trim())
}
