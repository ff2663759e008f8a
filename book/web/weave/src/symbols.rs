//! A glossary in place: the first time that a page shows a symbol, the symbol links to its meaning.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use crate::ground::{escaped, read};

/// The page that explains all symbols.
const PAGE: &str = "symbols.md";

/// The symbols of the book by their LaTeX: how each is typed in the code, and its meaning.
#[derive(Default)]
pub(crate) struct Symbols(HashMap<String, [String; 2]>);

impl Symbols {
    /// Reads the symbols from the tables of their page in the folder `notes`; there are none
    /// without that page.
    pub(crate) fn read(notes: &Path) -> Self {
        let text = read(&notes.join(PAGE)).unwrap_or_default();
        Self(text.lines().flat_map(row).collect())
    }

    /// Returns the `mathml` of a formula. If the formula is a symbol that is not yet in `met`, it
    /// becomes a link to its row on the page of symbols with its meaning, which a script shows in
    /// place, and the search finds it as it is typed.
    pub(crate) fn explained(
        &self,
        formula: &str,
        mathml: String,
        met: &mut HashSet<String>,
    ) -> String {
        let Some([typed, meaning]) = self.0.get(formula) else {
            return mathml;
        };
        if !met.insert(formula.to_owned()) {
            return mathml;
        }
        format!(
            "<a class=\"symbol\" href=\"symbols.html#{}\" title=\"{}\">{mathml}<span hidden> {typed} </span></a>",
            id(formula),
            escaped(meaning)
        )
    }
}

/// Returns the id of a symbol's row: `t`, and for a bold letter `bold-d`.
fn id(formula: &str) -> String {
    let plain = formula.replace("\\mathbf{", "bold-");
    plain.replace(
        |letter: char| !letter.is_alphanumeric() && letter != '-',
        "",
    )
}

/// Reads the symbols of a row `| $t$ | t | the ray parameter | …`, each with its name and meaning.
fn row(line: &str) -> Vec<(String, [String; 2])> {
    let cells: Vec<&str> = line.split('|').map(str::trim).collect();
    let ["", symbols, typed, meaning, ..] = cells[..] else {
        return Vec::new();
    };
    let symbols = symbols.split('$').skip(1).step_by(2);
    symbols
        .zip(typed.split(", "))
        .map(|(it, typed)| (it.to_owned(), [typed, meaning].map(str::to_owned)))
        .collect()
}
