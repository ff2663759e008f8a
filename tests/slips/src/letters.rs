//! Concrete syntax: in which language a slip is said.

use crate::edition::Edition;

/// The language in which a line is shown, so that readers find it in their own code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letters {
    /// The C++ of that edition of the book, or what is near to it.
    Book(Edition),
    /// Rust, as the chapters here are written.
    Rust,
    /// Python, with the names of that edition.
    Python(Edition),
}

/// A line of the book's C++ as it is typed in Python.
pub(super) fn in_python(said: &str) -> String {
    let mut said = said.to_owned();
    for (cpp, python) in PYTHON {
        said = said.replace(cpp, python);
    }
    without_brackets(&said)
}

/// `if (condition) …` as `if condition: …`
fn without_brackets(said: &str) -> String {
    let Some((before, rest)) = said.split_once("if (") else {
        return said.to_owned();
    };
    let mut open = 1;
    let end = rest.find(|sign| {
        open += i32::from(sign == '(') - i32::from(sign == ')');
        open == 0
    });
    let (condition, after) = rest.split_at(end.unwrap_or(rest.len()));
    let after = after.strip_prefix(')').unwrap_or(after);
    format!("{before}if {condition}:{}", without_brackets(after))
}

/// What Python says for words of C++, one after the other.
const PYTHON: &[(&str, &str)] = &[
    (".x()", ".x"),
    (".y()", ".y"),
    (".z()", ".z"),
    (".origin()", ".origin"),
    (".direction()", ".direction"),
    ("&&", "and"),
    ("||", "or"),
    ("(!", "(not "),
    ("true", "True"),
    ("false", "False"),
    ("infinity", "math.inf"),
    ("double(image_width)", "image_width"),
    ("double(image_height)", "image_height"),
];
