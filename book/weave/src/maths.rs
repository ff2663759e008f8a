//! Formulas: LaTeX becomes MathML, which browsers draw without any help.

use std::collections::{HashMap, HashSet};

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

use crate::breaks::with_breaks;
use crate::symbols::Symbols;

/// The formulas of the book, and the numbers that are taken.
pub(crate) struct Maths {
    converter: LatexToMathML,
    /// Where the equation of each number stands.
    numbered: HashMap<String, String>,
    symbols: Symbols,
}

impl Maths {
    /// Maths without macros, and no equation numbered yet.
    pub(crate) fn new(symbols: Symbols) -> Self {
        let converter = LatexToMathML::new(MathCoreConfig::default())
            .expect("without macros there is none that can be wrong");
        Self {
            converter,
            numbered: HashMap::new(),
            symbols,
        }
    }

    /// A formula inside a line, which does not part from the `punctuation` behind it. A symbol
    /// that is not among those `met` is explained; nothing is, where there are none to be met.
    pub(crate) fn inline(
        &self,
        latex: &str,
        punctuation: &str,
        met: Option<&mut HashSet<String>>,
    ) -> Result<String, String> {
        let mathml = self.convert(latex, MathDisplay::Inline)?;
        let mathml = untouched_by_markdown(&mathml);
        let mathml = match met {
            Some(met) => self.symbols.explained(latex, mathml, met),
            None => mathml,
        };
        Ok(match punctuation {
            "" => mathml,
            _ => format!("<span class=\"whole\">{mathml}{punctuation}</span>"),
        })
    }

    /// A formula in a table, which may need to be narrow.
    pub(crate) fn in_table(&self, latex: &str) -> Result<String, String> {
        let mathml = self.convert(latex, MathDisplay::Inline)?;
        Ok(untouched_by_markdown(&with_breaks(&mathml)))
    }

    /// A formula on a line of its own; `\tag{n}` makes it equation n of the book.
    pub(crate) fn equation(
        &mut self,
        latex: &str,
        place: impl Fn() -> String,
    ) -> Result<String, String> {
        let (formula, number) = without_tag(latex)?;
        let math = with_breaks(&self.convert(&formula, MathDisplay::Block)?);
        let math = untouched_by_markdown(&math);
        let Some(number) = number else {
            return Ok(format!(
                "<div class=\"equation\"><div class=\"formula\">{math}</div></div>"
            ));
        };
        if let Some(first) = self.numbered.insert(number.to_owned(), place()) {
            return Err(format!(
                "equation ({number}) is a second one: the first is at {first}"
            ));
        }
        Ok(format!(
            "<div class=\"equation\" id=\"eq-{number}\"><div class=\"formula\">{math}</div>\
             <a class=\"number\" href=\"#eq-{number}\" aria-label=\"Equation {number}\">({number})</a></div>"
        ))
    }

    fn convert(&self, latex: &str, display: MathDisplay) -> Result<String, String> {
        self.converter
            .convert_with_local_state(latex, display)
            .map(|result| result.mathml)
            .map_err(|error| format!("the formula `{latex}` is wrong: {}", error.error_message()))
    }
}

/// The formula without its `\tag{n}`, and n.
fn without_tag(latex: &str) -> Result<(String, Option<&str>), String> {
    let Some((before, rest)) = latex.split_once(r"\tag{") else {
        return Ok((latex.to_owned(), None));
    };
    let Some((number, after)) = rest.split_once('}') else {
        return Err(r"a \tag{ has no }".to_owned());
    };
    if after.contains(r"\tag{") {
        return Err(r"one formula has one \tag".to_owned());
    }
    if number.is_empty() || !number.chars().all(|letter| letter.is_ascii_alphanumeric()) {
        return Err(format!("\\tag{{{number}}} is no number"));
    }
    Ok((format!("{before}{after}"), Some(number)))
}

/// MathML that means the same after Markdown: on one line, and the punctuation
/// of its text as numbers of characters.
fn untouched_by_markdown(mathml: &str) -> String {
    let mut is_tag = false;
    let mut safe = String::new();
    for letter in mathml.chars() {
        match letter {
            '<' => is_tag = true,
            '>' => is_tag = false,
            _ => {}
        }
        match letter {
            '\n' => safe.push(' '),
            _ if !is_tag && r#"*_[]\~$|`'"-."#.contains(letter) => {
                safe += &format!("&#{};", u32::from(letter));
            }
            letter => safe.push(letter),
        }
    }
    safe
}
