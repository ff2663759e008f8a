//! Habits from C++, Python and similar languages: what people type out of habit, and what Rust
//! writes instead.

use interpreter::{Fault, Span};

use crate::typed::Draft;
use crate::words::{replaced, words};

/// Pairs of words that readers type out of habit, and the Rust for them. In the first text, `x` and
/// `y` stand for names, `…` for any words, words with `|` between them for one of these, and `$` for
/// the end of the line. In the second, `x`, `y`, and `X` for the one of several words are replaced by
/// what was typed.
const HABITS: &[(&str, &str)] = &[
    ("for ( int …", "`for n in 0..count { … }`"),
    ("for ( … :", "`for object in &objects { … }`"),
    ("for ( … in", "`for … in … { … }`, without brackets"),
    ("for x :", "`for x in …`"),
    ("? … :", "`if … { … } else { … }`"),
    ("if|while|for … : $", "`X … { … }`, with braces"),
    ("elif …", "`else if … { … }`"),
    ("else :", "`else { … }`"),
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
    ("double|f64 x )|,", "`x: f64`, the name first"),
    ("double x (", "`fn x(…) -> f64`"),
    ("x y =", "`let y = …`, and finds the type by itself"),
    ("x y ;", "`let y;`, or better `let y = …;` with its value"),
    ("double|float", "`f64`"),
    ("null|nullptr|NULL|none", "`None`"),
    (") : x", "`-> x`"),
    ("std :: x (", "`a.x()`, a method of the number"),
    ("Math|math|np . x (", "`a.x()`, a method of the number"),
    ("return false", "`None` where nothing is hit"),
    ("return true", "`Some(…)` with what was hit"),
    ("f64 :: infinity", "`f64::INFINITY`"),
    ("infinity|INFINITY", "`f64::INFINITY`"),
    ("new Vec3|Point3|Color|Ray|Sphere", "`X::new(…)`"),
    ("Vec3|Point3|Color|Ray|Sphere (", "`X::new(…)`"),
    ("Vec3|Point3|Color|Ray|Sphere . new", "`X::new(…)`"),
    ("make_shared < x >", "`Box::new(…)`"),
    ("vec3", "`Vec3::new(…)`"),
    ("point3", "`Point3::new(…)`"),
    ("color", "`Color::new(…)`"),
    ("sqrt (", "`x.sqrt()`"),
    ("fabs|abs (", "`x.abs()`"),
    ("fmax (", "`x.max(y)`"),
    ("fmin (", "`x.min(y)`"),
    ("pow (", "`x * x`, or `x.powi(2)`"),
    ("dot (", "`u.dot(v)`"),
    ("cross (", "`u.cross(v)`"),
    ("unit_vector|normalized", "`v.normalize()`"),
    ("x ^", "`x * x`, or `x.powi(2)`"),
    ("* *", "`x * x`, or `x.powi(2)`"),
    ("x + +", "`x += 1`"),
    ("and …", "`&&`"),
    ("or …", "`||`"),
    ("not …", "`!(…)`"),
    ("# …", "`// …` for a comment"),
    ("=>", "`>=`"),
    ("−|–", "`-`"),
    ("×|·", "`*`"),
    ("÷", "`/`"),
    ("≤", "`<=`"),
    ("≥", "`>=`"),
    ("½", "`0.5`"),
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
            .or_else(|| with_point(line, place, fault));
        Some(format!("Rust writes {}", rust?))
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

/// Returns the whole number that is nearest to `place` as an `f64`, if a fault of types lies there.
fn with_point(line: &str, place: Span, fault: &Fault) -> Option<String> {
    let is_of_types = fault.message.contains("f64") && fault.message.contains("integer");
    let (at, _) = line.char_indices().nth(place.start as usize)?;
    let words = words(line).into_iter().filter(|_| is_of_types);
    let numbers = words.filter(|(_, it)| it.bytes().all(|it| it.is_ascii_digit()));
    let (_, number) = numbers.min_by_key(|(start, _)| start.abs_diff(at))?;
    Some(format!("`{number}.0`"))
}

/// Returns the Rust for the habit that a line shows where `place` begins, or `None` if there is
/// none.
fn in_rust(line: &str, place: Span) -> Option<String> {
    let (at, _) = line.char_indices().nth(place.start as usize)?;
    let words = words(line);
    HABITS.iter().find_map(|(typed, rust)| {
        let pattern: Vec<&str> = typed.split_whitespace().collect();
        (0..words.len()).find_map(|start| {
            let typed = matched(&pattern, &words[start..])?;
            let &(_, (last, word)) = typed.last()?;
            let is_there = (words[start].0..last + word.len()).contains(&at);
            let is_method = start > 0 && words[start - 1].1 == ".";
            let is_there = is_there && (!is_method || typed[0].1.1 == "normalized");
            let stands_for = |wanted: &str, word: &str| match word {
                "X" => wanted.contains('|'),
                "x" | "y" => wanted == word,
                _ => false,
            };
            is_there.then(|| {
                replaced(rust, |_, word| {
                    let mut typed = typed.iter();
                    let found = typed.find(|(wanted, _)| stands_for(wanted, word));
                    found.map(|(_, (_, typed))| *typed)
                })
            })
        })
    })
}

/// A word of a pattern of [`HABITS`], and the word that it took, with the byte where that begins.
type Taken<'a> = (&'static str, (usize, &'a str));

/// Matches a pattern of [`HABITS`] with the first words. Returns a pair for each word that it takes,
/// or `None` if it does not fit.
fn matched<'a>(pattern: &[&'static str], words: &[(usize, &'a str)]) -> Option<Vec<Taken<'a>>> {
    let Some((&wanted, rest)) = pattern.split_first() else {
        return Some(Vec::new());
    };
    if wanted == "$" {
        return words.is_empty().then(Vec::new);
    }
    let (&first, others) = words.split_first()?;
    let is_name = first.1.starts_with(char::is_alphabetic) && !KEYWORDS.contains(&first.1);
    let fits = match wanted {
        "…" => true,
        "x" | "y" => is_name,
        wanted => wanted.split('|').any(|it| it == first.1),
    };
    let behind = fits.then(|| matched(rest, others)).flatten();
    let goes_on = || (wanted == "…").then(|| matched(pattern, others)).flatten();
    let behind = behind.or_else(goes_on)?;
    Some([vec![(wanted, first)], behind].concat())
}
