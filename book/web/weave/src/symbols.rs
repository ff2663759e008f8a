//! A glossary in place: the first time that a symbol stands in a page, it says what it means.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use crate::ground::{escaped, read};

/// The page that has all symbols.
const PAGE: &str = "symbols.md";

/// How each symbol of the book is typed, and what it means, as the tables of their page have it.
#[derive(Default)]
pub(crate) struct Symbols(HashMap<String, [String; 2]>);

impl Symbols {
    /// Those of the page in the folder `notes`; none, if there is no such page.
    pub(crate) fn read(notes: &Path) -> Self {
        let text = read(&notes.join(PAGE)).unwrap_or_default();
        Self(text.lines().flat_map(row).collect())
    }

    /// The `mathml` of a formula. If it is a symbol that is not among those `met` on its page,
    /// it leads to the page of symbols, and has its meaning. The search knows it as it is typed.
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
            "<a class=\"symbol\" href=\"symbols.html\" title=\"{}\">{mathml}<span hidden> {typed} </span></a>",
            escaped(meaning)
        )
    }
}

/// The symbols of a row `| $t$ | t | the ray parameter | …`, and what they mean.
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
