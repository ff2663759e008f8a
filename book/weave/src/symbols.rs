//! A glossary in place: the first time that a symbol stands in a page, it says what it means.

use std::collections::{HashMap, HashSet};
use std::fs;
use std::path::Path;

use figures::escape;

/// The page that has all symbols.
const PAGE: &str = "symbols.md";

/// The symbols of the book, as the tables of their page have them.
#[derive(Default)]
pub(crate) struct Symbols(HashMap<String, Symbol>);

struct Symbol {
    /// How it is typed on a keyboard.
    typed: String,
    meaning: String,
}

impl Symbols {
    /// Those of the page in the folder `notes`; none, if there is no such page.
    pub(crate) fn read(notes: &Path) -> Self {
        let text = fs::read_to_string(notes.join(PAGE)).unwrap_or_default();
        Self(text.lines().flat_map(row).collect())
    }

    /// The `mathml` of a formula. If it is a symbol that is not among those `met` on its page,
    /// it leads to the page of symbols, and has its meaning.
    pub(crate) fn explained(
        &self,
        formula: &str,
        mathml: String,
        met: &mut HashSet<String>,
    ) -> String {
        let Some(Symbol { typed, meaning }) = self.0.get(formula) else {
            return mathml;
        };
        if !met.insert(formula.to_owned()) {
            return mathml;
        }
        let meaning = escape(meaning);
        format!(
            "<a class=\"symbol\" href=\"symbols.html\" aria-label=\"{typed}: {meaning}\" \
             data-meaning=\"{meaning}\">{mathml}</a>"
        )
    }
}

/// The symbols of a row `| $t$ | t | the ray parameter | …`.
fn row(line: &str) -> Vec<(String, Symbol)> {
    let cells: Vec<&str> = line.split('|').map(str::trim).collect();
    let ["", symbols, typed, meaning, ..] = cells[..] else {
        return Vec::new();
    };
    let symbols = symbols.split('$').skip(1).step_by(2);
    let symbol = |(formula, typed): (&str, &str)| {
        let (typed, meaning) = (typed.to_owned(), meaning.replace('$', ""));
        (formula.to_owned(), Symbol { typed, meaning })
    };
    symbols.zip(typed.split(", ")).map(symbol).collect()
}
