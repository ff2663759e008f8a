//! Dead statements: values that nobody takes, in languages whose compilers don't tell.

use super::{File, Line, Sources};

/// Words before something else than a value.
const WORDS: [&str; 16] = [
    "return", "if", "elif", "else", "while", "for", "assert", "raise", "yield", "throw", "case",
    "template", "typedef", "using", "import", "from",
];
/// Signs between two values. A star may be a pointer's, and an angle a template's.
const COMPARED: [&str; 4] = ["==", "!=", ">=", "<="];
const SIGNS: [&str; 3] = ["+", "-", "/"];
/// What no idle line has: a text, or a sign that does something, as a single `=` does.
const BUSY: [&str; 8] = ["<<", ">>", "\"", "'", "->", "++", "--", "operator"];

impl Sources {
    /// Lines that work out a value and do nothing with it.
    pub(crate) fn idle(&self) -> Vec<Line> {
        let is_told = |file: &&File| !file.name.ends_with(".rs");
        let files = self.yours.iter().filter(is_told);
        files.flat_map(File::idle).collect()
    }
}

impl File {
    fn idle(&self) -> Vec<Line> {
        let is_python = self.name.ends_with(".py");
        let (mut depth, mut before, mut is_text) = (0, ';', false);
        let mut idle = Vec::new();
        for (n, line) in self.text.lines().enumerate() {
            let was_text = is_text;
            is_text ^= is_python && line.matches("\"\"\"").count() % 2 == 1;
            let comment = if is_python { "#" } else { "//" };
            let code = line.split(comment).next().unwrap_or_default().trim();
            if was_text || is_text || code.is_empty() {
                continue;
            }
            let begins = depth == 0 && (is_python && before != '\\' || ";{}:".contains(before));
            let ends = is_python || code.ends_with(';');
            depth += outside(code, is_python).1;
            if begins && ends && depth == 0 && is_idle(code.trim_end_matches(';'), is_python) {
                idle.push(self.line(n));
            }
            before = code.chars().next_back().unwrap_or(';');
        }
        idle
    }
}

fn is_idle(code: &str, is_python: bool) -> bool {
    let word = |c: char| c.is_alphanumeric() || c == '_';
    let (first, rest) = code.split_at(code.find(|c| !word(c)).unwrap_or(code.len()));
    // After its type a name is declared.
    let is_declared = rest.trim_start_matches([' ', '&', '*']).starts_with(word);
    let is_declared = is_declared || rest.starts_with('<');
    let bare = COMPARED
        .iter()
        .fold(code.to_owned(), |code, sign| code.replace(sign, " "));
    let outside = outside(code, is_python).0;
    !WORDS.contains(&first)
        && !is_declared
        && BUSY.iter().all(|sign| !code.contains(sign))
        && !bare.contains('=')
        && COMPARED
            .iter()
            .chain(&SIGNS)
            .any(|sign| outside.contains(sign))
}

/// What is in no brackets, and how many of them remain open.
fn outside(code: &str, has_braces: bool) -> (String, i32) {
    let (mut outside, mut depth) = (String::new(), 0);
    for letter in code.chars() {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            '{' if has_braces => depth += 1,
            '}' if has_braces => depth -= 1,
            _ if depth == 0 => outside.push(letter),
            _ => {}
        }
    }
    (outside, depth)
}
