//! What the directives stand on: names, files, and HTML.

use std::fs;
use std::path::Path;

pub(crate) use figures::escape as escaped;

/// The one of `all` that has this name.
///
/// # Errors
/// If there is none, with the names that there are.
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

/// The text of a file.
///
/// # Errors
/// With its name, and what keeps it from being read.
pub(crate) fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|cause| format!("{}: {cause}", path.display()))
}

/// The first word of the text, and what follows.
pub(crate) fn split(text: &str) -> (&str, &str) {
    let (first, rest) = text.split_once(' ').unwrap_or((text, ""));
    (first, rest.trim())
}
