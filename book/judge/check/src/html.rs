//! HTML: the rows of an answer, in the elements of a page of the book.

use std::fmt::Display;

use slips::Slip;

use crate::answer::Part;
use crate::report::escaped;

/// What is code in an answer is the second in a row with one of these labels.
const CODE: [&str; 6] = ["probably", "perhaps", "should be", "or", "yours", "missing"];

/// A part of an answer but for the next picture.
pub fn part(part: &Part) -> String {
    match part {
        Part::Title(said) => format!("<h3>{}</h3>", escaped(said)),
        Part::Name(name) => format!("<p><code>{}</code></p>", escaped(name)),
        Part::Rows(rows) => list(rows),
        Part::Read(slip) => read(slip),
        Part::Next(_) => String::new(),
    }
}

/// Labeled rows; nothing, if there are none.
pub fn list(rows: &[(&str, impl Display)]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let row = |(label, said): &(&str, _)| {
        let said = if CODE.contains(label) {
            format!("<code>{}</code>", escaped(said))
        } else {
            escaped(said)
        };
        format!("<dt>{}</dt><dd>{said}</dd>", escaped(label))
    };
    let rows: String = rows.iter().map(row).collect();
    format!("<dl>{rows}</dl>")
}

/// Where to read how it is right.
pub fn read(slip: &Slip) -> String {
    if slip.page.is_empty() {
        return String::new();
    }
    format!(
        "<p><a href=\"{}\">How it is right</a></p>",
        escaped(slip.address())
    )
}
