//! Lints: lines that are wrong in any program, in languages whose compilers don't tell.

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
    /// Lines that are wrong in any program, and why.
    pub(crate) fn lints(&self) -> Vec<(Line, &'static str)> {
        let is_told = |file: &&File| !file.name.ends_with(".rs");
        let files = self.yours.iter().filter(is_told);
        files.flat_map(File::lints).collect()
    }
}

impl File {
    fn lints(&self) -> Vec<(Line, &'static str)> {
        let is_python = self.name.ends_with(".py");
        let (mut depth, mut before, mut is_text) = (0, "", false);
        let mut lints = Vec::new();
        for (n, line) in self.text.lines().enumerate() {
            let was_text = is_text;
            is_text ^= is_python && line.matches("\"\"\"").count() % 2 == 1;
            let comment = if is_python { "#" } else { "//" };
            let code = line.split(comment).next().unwrap_or_default().trim();
            if was_text || is_text || code.is_empty() {
                continue;
            }
            let last = before.chars().next_back().unwrap_or(';');
            let begins = depth == 0 && (is_python && last != '\\' || ";{}:".contains(last));
            let ends = is_python || code.ends_with(';');
            depth += outside(code, is_python).1;
            let is_whole = begins && ends && depth == 0;
            if is_whole && is_idle(code.trim_end_matches(';'), is_python) {
                lints.push((self.line(n), "nothing takes this value"));
            }
            if is_whole && is_repeated(before, code) {
                lints.push((self.line(n), "the level of the line above"));
            }
            if ends && !is_python && is_cut_off(code) {
                lints.push((self.line(n), "of whole numbers the rest is cut off"));
            }
            before = code;
        }
        lints
    }
}

/// Whether it works out a value and does nothing with it.
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
    let mut signs = COMPARED.iter().chain(&SIGNS);
    !WORDS.contains(&first)
        && !is_declared
        && BUSY.iter().all(|sign| !code.contains(sign))
        && !bare.contains('=')
        && (signs.any(|sign| outside.contains(sign)) || is_vector(first, rest))
}

/// Whether it makes a vector of three numbers.
fn is_vector(name: &str, rest: &str) -> bool {
    let is_named = ["color", "point3", "vec3"].contains(&name.to_lowercase().as_str());
    let inside = rest.strip_prefix('(').and_then(|it| it.strip_suffix(')'));
    let is_number = |it: &str| it.trim().parse::<f64>().is_ok();
    is_named && inside.is_some_and(|it| it.split(',').all(is_number))
}

/// Whether two levels are those of one component.
fn is_repeated(before: &str, code: &str) -> bool {
    match (before.split_once(" = "), code.split_once(" = ")) {
        (Some((one, first)), Some((other, second))) => {
            one.trim() != other.trim() && first == second && second.contains("255")
        }
        _ => false,
    }
}

/// Whether one whole number is divided by another, and the rest is not zero.
fn is_cut_off(code: &str) -> bool {
    let goes_on = |c: char| c.is_alphanumeric() || "._".contains(c);
    code.match_indices('/').any(|(at, _)| {
        let (left, right) = (code[..at].trim_end(), code[at + 1..].trim_start());
        let (before, left) = left.split_at(left.rfind(|c| !goes_on(c)).map_or(0, |n| n + 1));
        let right = &right[..right.find(|c| !goes_on(c)).unwrap_or(right.len())];
        match (left.parse::<u32>(), right.parse::<u32>()) {
            // A product before it is divided as a whole.
            (Ok(left), Ok(right)) => {
                let is_product = before.trim_end().ends_with(['*', '/', '%']);
                right > 0 && !left.is_multiple_of(right) && !is_product
            }
            _ => false,
        }
    })
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
