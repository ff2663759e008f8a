//! Formulas: LaTeX becomes MathML, which browsers draw by themselves.

use std::collections::HashSet;

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

use crate::symbols::Symbols;

/// The converter of the book's formulas, which also explains their symbols.
pub(crate) struct Maths {
    converter: LatexToMathML,
    symbols: Symbols,
}

impl Maths {
    /// Makes a converter without macros.
    pub(crate) fn new(symbols: Symbols) -> Self {
        let converter = LatexToMathML::new(MathCoreConfig::default())
            .expect("without macros there is none that can be wrong");
        Self { converter, symbols }
    }

    /// Converts a formula inside a line; a line never breaks between it and the `punctuation`
    /// behind it. The first time that a page shows a symbol, which then is not in `met`, the
    /// formula links to the page of symbols; never, if `met` is `None`.
    ///
    /// # Errors
    /// If the formula is wrong.
    pub(crate) fn inline(
        &self,
        latex: &str,
        punctuation: &str,
        met: Option<&mut HashSet<String>>,
    ) -> Result<String, String> {
        let mathml = self.convert(latex, MathDisplay::Inline)?;
        let mathml = match met {
            Some(met) => self.symbols.explained(latex, mathml, met),
            None => mathml,
        };
        Ok(match punctuation {
            "" => mathml,
            _ => format!("<span class=\"whole\">{mathml}{punctuation}</span>"),
        })
    }

    /// Converts a formula on a line of its own; `\tag{n}` makes it equation n of the book. A line
    /// may break at a wide gap.
    ///
    /// # Errors
    /// If the formula or its tag is wrong.
    pub(crate) fn equation(&self, latex: &str) -> Result<String, String> {
        let (formula, number) = without_tag(latex)?;
        let formula = formula.replace(r"\qquad", r"\quad");
        let parts: Result<String, String> = formula
            .split(r"\quad")
            .map(|part| self.convert(part, MathDisplay::Block))
            .collect();
        let math = format!("<div class=\"formula\">{}</div>", parts?);
        Ok(match number {
            None => format!("<div class=\"equation\">{math}</div>"),
            Some(number) => format!(
                "<div class=\"equation\" id=\"eq-{number}\">{math}\
                 <a class=\"number\" href=\"#eq-{number}\" aria-label=\"Equation {number}\">({number})</a></div>"
            ),
        })
    }

    /// Converts a formula to MathML on one line.
    fn convert(&self, latex: &str, display: MathDisplay) -> Result<String, String> {
        let converted = self.converter.convert_with_local_state(latex, display);
        converted
            .map(|result| untouched_by_markdown(&colored(result.mathml)))
            .map_err(|error| format!("the formula `{latex}` is wrong: {}", error.error_message()))
    }
}

/// The letters that the figures draw in a color, each behind the word that stands for the color in
/// `figures.css`.
const IDEAS: [(&str, &[&str]); 3] = [
    ("ray", &["t", "𝐐", "𝐝", "𝐏"]),
    ("sphere", &["r", "l", "𝐂"]),
    ("normal", &["𝐧"]),
];

/// Gives the letters of the figures a class, which has their color; a root gets a strut, because
/// Chromium lets it sink around a low letter.
fn colored(mathml: String) -> String {
    let mut colored = mathml.replace("<msqrt><mi>", "<msqrt><mspace height=\"0.8em\"/><mi>");
    for (idea, letters) in IDEAS {
        for letter in letters {
            let plain = format!("<mi>{letter}</mi>");
            colored = colored.replace(&plain, &format!("<mi class=\"{idea}\">{letter}</mi>"));
        }
    }
    colored
}

/// Returns the formula without its `\tag{n}`, and n.
fn without_tag(latex: &str) -> Result<(String, Option<&str>), String> {
    let Some((before, rest)) = latex.split_once(r"\tag{") else {
        return Ok((latex.to_owned(), None));
    };
    let is_letter = |letter: char| letter.is_ascii_alphanumeric();
    match rest.split_once('}') {
        Some((number, after)) if number.chars().all(is_letter) => {
            Ok((format!("{before}{after}"), Some(number)))
        }
        _ => Err(format!("\\tag{{{rest} is no number in braces")),
    }
}

/// Protects MathML from Markdown: puts it on one line, and writes the punctuation of its text as
/// numbers of characters.
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
