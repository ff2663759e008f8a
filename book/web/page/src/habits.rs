//! Habits from C++ and similar languages: what people type out of habit, and what Rust writes
//! instead.

use std::ops::Range;

use crate::words::words;

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
    ("return false", "`None` where nothing is hit"),
    ("return true", "`Some(…)` with what was hit"),
    ("f64 :: infinity", "`f64::INFINITY`"),
    ("infinity", "`f64::INFINITY`"),
    ("INFINITY", "`f64::INFINITY`"),
    ("new X", "`X::new(…)`"),
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
    ("not x", "`!x`"),
    ("=>", "`>=`"),
];

/// Keywords of Rust that may stand beside a name, and so are no names themselves.
const KEYWORDS: [&str; 24] = [
    "as", "break", "const", "continue", "dyn", "else", "enum", "fn", "for", "if", "impl", "in",
    "let", "loop", "match", "mod", "mut", "pub", "return", "self", "struct", "trait", "use",
    "while",
];

/// Returns the Rust for the habit that a line shows where `columns` begin, or `None` if there is
/// none.
pub(crate) fn in_rust(line: &str, columns: &Range<usize>) -> Option<String> {
    let (at, _) = line.char_indices().nth(columns.start)?;
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
            (is_there && !is_method).then(|| with_names(rust, &names))
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

/// Puts the matched names in the place of `x`, `y` and `X`.
fn with_names(rust: &str, names: &[(&str, &str)]) -> String {
    let name = |word: &str| {
        let found = names.iter().rev().find(|(it, _)| *it == word);
        found.map_or(word, |(_, name)| name).to_owned()
    };
    let (mut text, mut end) = (String::new(), 0);
    for (at, word) in words(rust) {
        text += &rust[end..at];
        text += &name(word);
        end = at + word.len();
    }
    text + &rust[end..]
}
