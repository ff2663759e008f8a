//! Concrete syntax: a line of the chapters' Rust in C++ and in Python.

use crate::chapter::Chapter;
use crate::edition::Edition;

/// The programming language in which lines of code are shown to a reader: C++, Rust or Python.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReaderLanguage {
    /// The C++ of an edition of the book, also for readers of languages with a similar syntax.
    Cpp(Edition),
    /// Rust, as the chapters of this workspace are written.
    Rust,
    /// Python, with the names of an edition of the book.
    Python(Edition),
}

impl ReaderLanguage {
    /// Returns the edition whose names the lines have; version 4 for Rust.
    pub(super) fn edition(self) -> Edition {
        match self {
            Self::Cpp(edition) | Self::Python(edition) => edition,
            Self::Rust => Edition::V4,
        }
    }

    /// Translates a line of Rust, which `chapter` has, to this language, without `Some(…)` around
    /// it. Rust stays as it is but for that.
    ///
    /// The line is rewritten phrase by phrase: Rust that no chapter has may stay as it is.
    pub fn translate_line(self, line: &str, chapter: Chapter) -> String {
        let some = line
            .strip_prefix("Some(")
            .and_then(|it| it.strip_suffix(')'));
        let line = some.unwrap_or(line);
        match self {
            Self::Rust => line.to_owned(),
            Self::Cpp(_) => in_cpp(line, chapter),
            Self::Python(_) => in_python(&in_cpp(line, chapter)),
        }
    }
}

/// Translates a line of a chapter's Rust to the book's C++.
pub(super) fn in_cpp(line: &str, chapter: Chapter) -> String {
    let mut line = line.to_owned();
    if chapter == Chapter::HittableList {
        line = with_words(&line, &[("normal", "rec.normal")]);
    }
    // The book tries one root after the other.
    if let Some(roots) = line.strip_prefix("roots = [") {
        let nearer = roots.split_once(", ").map_or(roots, |it| it.0);
        line = nearer
            .trim_end_matches(']')
            .replace("sqrtd", "discriminant.sqrt()");
    }
    line = replaced(&with_words(&line, NAMES), CPP);
    for (method, function) in FUNCTIONS {
        while let Some(place) = line.find(method) {
            line = with_function(&line, place, method, function);
        }
    }
    line.strip_suffix(".0").unwrap_or(&line).to_owned()
}

/// Translates a line of the book's C++ to Python.
pub(super) fn in_python(line: &str) -> String {
    without_brackets(&replaced(line, PYTHON))
}

/// Texts and their replacements, in the order in which they are made.
type Phrases = &'static [(&'static str, &'static str)];

/// Rust, once names are translated, and the book's C++.
const CPP: Phrases = &[
    ("self.", ""),
    ("record.point", "rec.p"),
    ("record.", "rec."),
    ("r.direction", "r.direction()"),
    ("r.origin", "r.origin()"),
    ("unit_direction.x", "unit_direction.x()"),
    ("unit_direction.y", "unit_direction.y()"),
    ("f64::from(i)", "i"),
    ("f64::from(j)", "j"),
    (" * (1.0 / f64::from(image_width))", " / image_width"),
    (" * (1.0 / f64::from(image_height))", " / image_height"),
    (
        " * (1.0 / f64::from(image_width - 1))",
        " / (image_width - 1)",
    ),
    (" * (1.0 / radius)", " / radius"),
    ("f64::from(image_width - 1)", "(image_width - 1)"),
    ("f64::from(image_height - 1)", "(image_height - 1)"),
    (" / f64::from(", " / ("),
    (" / (image_width)", " / image_width"),
    (" / (image_height)", " / image_height"),
    ("f64::from(", "double("),
    ("f64::INFINITY", "infinity"),
    ("(N + Vec3::ONE)", "color(N.x() + 1, N.y() + 1, N.z() + 1)"),
    ("Vec3::ONE", "color(1, 1, 1)"),
    ("Vec3::new", ""),
    ("Point3::new", ""),
    ("Color::new", ""),
    ("Sphere::new", "sphere"),
    ("Ray::new", "ray"),
    ("0.5 * viewport_u", "viewport_u / 2"),
    ("0.5 * viewport_v", "viewport_v / 2"),
    ("(2.0 * a)", "(2*a)"),
    ("/ 2.0 * a", "/ 2*a"),
    ("4.0 * ", "4*"),
    ("a * c", "a*c"),
    ("b * b", "b*b"),
    ("h * h", "h*h"),
    ("radius * radius", "radius*radius"),
    (".round() as u8", ".round()"),
    (".0 ", " "),
    (".0,", ","),
    (".0)", ")"),
    ("; ", ", "),
];

/// Methods of Rust, and the functions that C++ has for them.
const FUNCTIONS: [(&str, &str); 5] = [
    (".dot(", "dot("),
    (".normalize()", "unit_vector("),
    (".sqrt()", "sqrt("),
    (".round()", "round("),
    (" as u8", "int("),
];

/// Variables of the chapters, and of the book.
const NAMES: Phrases = &[
    ("ray", "r"),
    ("normal", "N"),
    ("point", "p"),
    ("component", "r"),
];

/// The book's C++, and Python.
const PYTHON: Phrases = &[
    (".x()", ".x"),
    (".y()", ".y"),
    (".z()", ".z"),
    (".origin()", ".origin"),
    (".direction()", ".direction"),
    ("&&", "and"),
    ("(!", "(not "),
    ("true", "True"),
    ("false", "False"),
    ("infinity", "math.inf"),
    ("double(image_width)", "image_width"),
    ("double(image_height)", "image_height"),
];

/// Replaces each phrase, one after the other.
fn replaced(line: &str, phrases: Phrases) -> String {
    let replace = |line: String, (from, to): &(&str, &str)| line.replace(from, to);
    phrases.iter().fold(line.to_owned(), replace)
}

/// Returns true if a name can have this character.
fn is_of_a_word(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// Replaces whole words, but for fields.
fn with_words(line: &str, names: Phrases) -> String {
    let mut written = String::new();
    let mut rest = line;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|letter| !is_of_a_word(letter));
        let end = end.unwrap_or(rest.len()).max(first.len_utf8());
        let (word, after) = rest.split_at(end);
        let is_it = |(name, _): &&(&str, &str)| *name == word && !written.ends_with('.');
        let other = names.iter().find(is_it);
        written += other.map_or(word, |(_, other)| other);
        rest = after;
    }
    written
}

/// Rewrites `x.method()`, whose point is at byte `place`, as `function(x)`, and `x.method(y)` as
/// `function(x, y)`.
fn with_function(line: &str, place: usize, method: &str, function: &str) -> String {
    let (before, rest) = (&line[..place], &line[place + method.len()..]);
    let (before, operand) = before.split_at(start_of_operand(before));
    let is_in_brackets = operand.starts_with('(');
    let operand = if is_in_brackets {
        &operand[1..operand.len() - 1]
    } else {
        operand
    };
    let separator = if method.ends_with('(') { ", " } else { ")" };
    format!("{before}{function}{operand}{separator}{rest}")
}

/// Finds the first byte of the path, call or brackets with which a text ends.
fn start_of_operand(text: &str) -> usize {
    let mut open = 0;
    let ends = |letter: char| {
        open += i32::from(letter == ')') - i32::from(letter == '(');
        open < 0 || open == 0 && !is_of_a_word(letter) && !".:(".contains(letter)
    };
    text.rfind(ends).map_or(0, |place| place + 1)
}

/// Rewrites `if (condition) …` as `if condition: …`.
fn without_brackets(line: &str) -> String {
    let Some((before, rest)) = line.split_once("if (") else {
        return line.to_owned();
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
