//! Habits from C++, Python and similar languages: what people type out of habit, and what Rust
//! writes instead.

use interpreter::{Fault, FaultKind, Span};

use crate::typed::Draft;
use crate::words::{replaced, words};

/// Pairs of words that readers type out of habit, and the Rust for them. In the first text, `x` and
/// `y` stand for names, `X` for a name with a capital, and `…` for any words; in the second, they
/// are replaced by the names that were typed.
const HABITS: &[(&str, &str)] = &[
    ("for ( int …", "`for n in 0..count { … }`"),
    ("for ( … :", "`for object in &objects { … }`"),
    ("for ( … in", "`for … in … { … }`, without brackets"),
    ("for x :", "`for x in …`"),
    ("? … :", "`if … { … } else { … }`"),
    ("if ( … ) x", "`if … { … }`, always with braces"),
    (
        "if ( … ) return",
        "`if … { return …; }`, always with braces",
    ),
    ("this -> x", "`self.x`"),
    ("x -> y", "`x.y`, also behind a reference"),
    ("x : =", "`let x = …`"),
    ("let x ==", "`let x = …`"),
    ("let x y =", "`let y = …`, and finds the type by itself"),
    ("const x y =", "`let y = …`, and finds the type by itself"),
    ("const x =", "`let x = …`"),
    ("const x &", "`&` before the type, and nothing else"),
    ("f64 x", "`x: f64`, the name first"),
    ("double x )", "`x: f64`, the name first"),
    ("double x ,", "`x: f64`, the name first"),
    ("double x (", "`fn x(…) -> f64`"),
    ("x y =", "`let y = …`, and finds the type by itself"),
    ("x y ;", "`let y;`, or better `let y = …;` with its value"),
    ("double", "`f64`"),
    ("float", "`f64`"),
    ("null", "`None`"),
    ("nullptr", "`None`"),
    ("NULL", "`None`"),
    ("none", "`None`"),
    (") : x", "`-> x`"),
    ("std :: x (", "`a.x()`, a method of the number"),
    ("Math . x (", "`a.x()`, a method of the number"),
    ("math . x (", "`a.x()`, a method of the number"),
    ("np . x (", "`a.x()`, a method of the number"),
    ("return false", "`None` where nothing is hit"),
    ("return true", "`Some(…)` with what was hit"),
    ("f64 :: infinity", "`f64::INFINITY`"),
    ("infinity", "`f64::INFINITY`"),
    ("INFINITY", "`f64::INFINITY`"),
    ("new X", "`X::new(…)`"),
    ("X . new", "`X::new(…)`"),
    ("make_shared < x >", "`Box::new(…)`"),
    ("vec3", "`Vec3::new(…)`"),
    ("point3", "`Point3::new(…)`"),
    ("color", "`Color::new(…)`"),
    ("Vec3 (", "`Vec3::new(…)`"),
    ("Point3 (", "`Point3::new(…)`"),
    ("Color (", "`Color::new(…)`"),
    ("Ray (", "`Ray::new(…)`"),
    ("Sphere (", "`Sphere::new(…)`"),
    ("sqrt (", "`x.sqrt()`"),
    ("fabs (", "`x.abs()`"),
    ("abs (", "`x.abs()`"),
    ("fmax (", "`x.max(y)`"),
    ("fmin (", "`x.min(y)`"),
    ("pow (", "`x * x`, or `x.powi(2)`"),
    ("dot (", "`u.dot(v)`"),
    ("cross (", "`u.cross(v)`"),
    ("unit_vector (", "`v.normalize()`"),
    ("normalized", "`v.normalize()`"),
    ("* *", "`x * x`, or `x.powi(2)`"),
    ("x + +", "`x += 1`"),
    ("and x", "`&&`"),
    ("or x", "`||`"),
    ("not x", "`!(…)`"),
    ("not (", "`!(…)`"),
    ("# …", "`// …` for a comment"),
    ("=>", "`>=`"),
    ("−", "`-`"),
    ("–", "`-`"),
    ("×", "`*`"),
    ("·", "`*`"),
    ("÷", "`/`"),
    ("≤", "`<=`"),
    ("≥", "`>=`"),
    ("½", "`0.5`"),
    ("x ^", "`x * x`, or `x.powi(2)`"),
];

/// The first words of a line that ends with a colon in Python, and the Rust for them.
const BLOCKS: [(&str, &str); 5] = [
    ("if", "`if … { … }`"),
    ("elif", "`else if … { … }`"),
    ("else", "`else { … }`"),
    ("for", "`for … in … { … }`"),
    ("while", "`while … { … }`"),
];

/// Keywords of Rust that may stand beside a name, and so are no names themselves.
const KEYWORDS: [&str; 24] = [
    "as", "break", "const", "continue", "dyn", "else", "enum", "fn", "for", "if", "impl", "in",
    "let", "loop", "match", "mod", "mut", "pub", "return", "self", "struct", "trait", "use",
    "while",
];

impl Draft {
    /// Returns what Rust writes for a habit of another language in the place of a fault, if it comes
    /// from one.
    pub(crate) fn habit(&self, fault: &Fault) -> Option<String> {
        let place = fault.place()?;
        let text = &self.files[usize::from(place.file)].text;
        let line = text.lines().nth(place.line as usize - 1)?;
        let rust = without_let(line, fault, text)
            .or_else(|| in_rust(line, place))
            .or_else(|| three_numbers(fault))
            .or_else(|| with_point(line, fault));
        Some(format!("Rust writes {}", rust?))
    }

    /// Returns the fault of the first block of Python, if there is one: a line such as `if a < b:`,
    /// which spoils the text up to its end.
    pub(crate) fn block_of_python(&self) -> Option<Fault> {
        let lines = self.files.iter().zip(0..).flat_map(|(it, file)| {
            let lines = it.text.lines().zip(1..);
            lines.map(move |(line, n)| (file, n, line.trim_end()))
        });
        let mut found = lines.filter_map(|(file, n, line)| {
            let words = words(line);
            let first = words.iter().map(|(_, it)| *it).find(|it| *it != "}")?;
            let &(end, last) = words.last()?;
            let (_, rust) = BLOCKS.iter().find(|(it, _)| *it == first && last == ":")?;
            let column = line[..end].chars().count() as u32;
            let at = Span {
                file,
                line: n,
                start: column,
                end: column + 1,
            };
            let message = format!("expected `{{`, found `:`: Rust writes {rust}, with braces");
            Some(Fault::new(FaultKind::Unparsed, at, message))
        });
        found.next()
    }
}

/// Returns the `let` that a line lacks which gives a value to a new name. A name like another one
/// that may change is a slip of the pen.
fn without_let(line: &str, fault: &Fault, text: &str) -> Option<String> {
    let message = &fault.message;
    let rest = message.strip_prefix("there is no variable or function `")?;
    let mut quoted = rest.split('`').step_by(2);
    let (name, other) = (quoted.next()?, quoted.next());
    let may_change = other.is_some_and(|it| text.contains(&format!("let mut {it} ")));
    let begins = matches!(words(line)[..], [(_, it), (_, "="), ..] if it == name);
    (begins && !may_change).then(|| format!("`let {name} = …`"))
}

/// Returns the words for three numbers where a vector is meant: a tuple or a list.
fn three_numbers(fault: &Fault) -> Option<String> {
    let named: Vec<&str> = fault.message.split([' ', '`']).collect();
    let is_three = named.contains(&"Vec3") && ["tuple", "Vec"].iter().any(|it| named.contains(it));
    let one_type = "`Color::new(…)`, `Point3::new(…)` or `Vec3::new(…)`, which are one type";
    is_three.then(|| one_type.to_owned())
}

/// Returns the line's only whole number as an `f64`, if a fault of types lies in that line.
fn with_point(line: &str, fault: &Fault) -> Option<String> {
    let is_of_types = fault.message.contains("f64") && fault.message.contains("integer");
    let is_whole = |number: &str| number.bytes().all(|it| it.is_ascii_digit());
    let words = words(line);
    let numbers: Vec<&str> = words
        .iter()
        .filter_map(|(_, it)| is_whole(it).then_some(*it))
        .collect();
    match numbers[..] {
        [number] if is_of_types => Some(format!("`{number}.0`")),
        _ => None,
    }
}

/// Returns the Rust for the habit that a line shows where `place` begins, or `None` if there is
/// none.
fn in_rust(line: &str, place: Span) -> Option<String> {
    let (at, _) = line.char_indices().nth(place.start as usize)?;
    let words = words(line);
    HABITS.iter().find_map(|(typed, rust)| {
        let pattern: Vec<&str> = typed.split_whitespace().collect();
        let mut starts = 0..words.len();
        starts.find_map(|start| {
            let mut names = Vec::new();
            let length = matched(&pattern, &words[start..], &mut names)?;
            let (first, last) = (words[start].0, &words[start + length - 1]);
            let is_there = (first..last.0 + last.1.len()).contains(&at);
            let is_method = start > 0 && words[start - 1].1 == "." && pattern[0] != "normalized";
            (is_there && !is_method).then(|| {
                // Puts the matched names in the place of `x`, `y` and `X`.
                replaced(rust, |_, word| {
                    let found = names.iter().rev().find(|(it, _)| *it == word);
                    found.map(|(_, name)| *name)
                })
            })
        })
    })
}

/// Matches a pattern of [`HABITS`] with the first words. Returns the number of words that it takes,
/// and appends the names that stand for `x`, `y` and `X`; returns `None` if it does not fit.
fn matched<'a>(
    pattern: &[&'static str],
    words: &[(usize, &'a str)],
    names: &mut Vec<(&'static str, &'a str)>,
) -> Option<usize> {
    let Some((wanted, rest)) = pattern.split_first() else {
        return Some(0);
    };
    let (_, word) = words.first()?;
    if *wanted == "…" {
        return (1..=words.len()).find_map(|n| Some(n + matched(rest, &words[n..], names)?));
    }
    let is_name = word.starts_with(|it: char| it.is_alphabetic()) && !KEYWORDS.contains(word);
    let fits = match *wanted {
        "x" | "y" => is_name,
        "X" => is_name && word.starts_with(char::is_uppercase),
        wanted => *word == wanted,
    };
    if !fits {
        return None;
    }
    if ["x", "y", "X"].contains(wanted) {
        names.push((wanted, word));
    }
    Some(1 + matched(rest, &words[1..], names)?)
}
