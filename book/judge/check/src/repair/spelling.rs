//! Translation, token by token: an expression of Python or C++ as the same in Rust, and Rust in
//! the fewest words.

use std::borrow::Cow;

use super::tree::{Reader, Tree};
use crate::sources::lexed;

/// Longer expressions are left alone, and those with more signs that each may be a level deeper.
const LONGEST: usize = 300;
const DEEPEST: usize = 40;
/// Signs of two letters.
const SIGNS: [&str; 9] = ["->", "**", "&&", "||", "<=", ">=", "==", "!=", "::"];

/// The expression as a tree of Rust, if it can be one.
pub(super) fn in_rust(text: &str, is_python: bool) -> Option<Tree> {
    let rust = (text.len() <= LONGEST).then(|| translated(text, is_python))?;
    let deep = rust.matches(|c: char| "([{-!&*|".contains(c));
    if deep.count() > DEEPEST {
        return None;
    }
    let expression = syn::parse_str(&rust).ok()?;
    let reader = Reader {
        text: &rust,
        start: 0,
    };
    Some(plain(&reader.expression(&expression)))
}

fn translated(text: &str, is_python: bool) -> String {
    let tokens = lexed(text, &SIGNS).into_iter();
    let mut tokens: Vec<Cow<str>> = tokens.map(Cow::Borrowed).collect();
    if !is_python {
        divide(&mut tokens);
    }
    let mut rust = String::new();
    let mut rest = tokens.iter().map(|it| &**it).peekable();
    while let Some(token) = rest.next() {
        match (token, rest.peek().copied().unwrap_or_default()) {
            ("std" | "math" | "np", "::" | ".") => drop(rest.next()),
            ("**", "2" | "2.0") => {
                rest.next();
                rust += ".powi(2)";
            }
            ("and", _) => rust += " && ",
            ("or", _) => rust += " || ",
            ("not", _) => rust += " !",
            ("->", _) => rust += ".",
            ("this", _) => rust += "self",
            ("infinity" | "inf", _) => rust += "f64::INFINITY",
            ("make_shared", "<") => {
                let kind = [rest.next(), rest.next(), rest.next()][1];
                rust += kind.unwrap_or_default();
            }
            (token, _) if token.starts_with(|c: char| c.is_ascii_digit()) => {
                let number = token.trim_end_matches('f');
                rust += number;
                if number.ends_with('.') {
                    rust += "0";
                } else if !number.contains('.') {
                    rust += ".0";
                }
            }
            (token, _) => {
                let is_word = |c: char| c.is_alphanumeric() || c == '_';
                if rust.ends_with(is_word) && token.starts_with(is_word) {
                    rust.push(' ');
                }
                rust += token;
            }
        }
    }
    rust
}

/// Divides whole numbers as C++ does: `1 / 2` becomes `0`.
fn divide(tokens: &mut Vec<Cow<str>>) {
    let mut n = 0;
    while n + 2 < tokens.len() {
        // What stands behind a product is divided as a whole.
        let is_first = n == 0 || !["*", "/", "%"].contains(&&*tokens[n - 1]);
        let whole = |n: usize| tokens[n].parse::<u32>().ok();
        let quotient = whole(n).zip(whole(n + 2));
        match quotient.and_then(|(one, other)| one.checked_div(other)) {
            Some(quotient) if is_first && tokens[n + 1] == "/" => {
                let quotient = Cow::Owned(quotient.to_string());
                tokens.splice(n..n + 3, [quotient]);
            }
            _ => n += 1,
        }
    }
}

/// The same in the fewest words: methods for functions, one name for all vectors, fields for
/// functions that return them.
pub(super) fn plain(tree: &Tree) -> Tree {
    let mut parts: Vec<Tree> = tree.parts.iter().map(plain).collect();
    let name = parts.first().map_or("", |it| &it.op).to_lowercase();
    let mut op = match (&*tree.op, name.trim_end_matches("::new")) {
        ("□(□)", "double" | "float") => return parts.remove(1),
        ("□(□)", "sqrt" | "abs" | "length" | "length_squared" | "normalize") => {
            format!("□.{name}()")
        }
        ("□(□)", "fabs") => "□.abs()".to_owned(),
        ("□(□)", "unit_vector" | "unit" | "normalized") => "□.normalize()".to_owned(),
        ("□(□, □)", "dot") => "□.dot(□)".to_owned(),
        ("□(□, □)", "add") => "□ + □".to_owned(),
        ("□(□, □)", "sub") => "□ - □".to_owned(),
        ("□(□, □)", "scale") => "□ * □".to_owned(),
        ("□(□, □)", "sphere") => {
            parts[0] = Tree::new("Sphere::new", Vec::new());
            tree.op.clone()
        }
        ("□(□, □, □)", "vec3" | "point3" | "color") => {
            parts[0] = Tree::new("Vec3::new", Vec::new());
            tree.op.clone()
        }
        ("□.origin()" | "□.orig" | "□.orig()", _) => "□.origin".to_owned(),
        ("□.direction()" | "□.dir" | "□.dir()", _) => "□.direction".to_owned(),
        ("□.x()" | "□.y()" | "□.z()", _) => tree.op.trim_end_matches("()").to_owned(),
        ("□.unit()" | "□.normalized()", _) => "□.normalize()".to_owned(),
        ("Vec3::ZERO" | "Point3::ZERO", _) => return vector("0.0"),
        ("Vec3::ONE" | "Color::ONE", _) => return vector("1.0"),
        _ => tree.op.clone(),
    };
    // A method has no function before what it is given.
    if op != tree.op && tree.op.starts_with("□(") {
        parts.remove(0);
    }
    if op == "□.dot(□)" && parts[0].is_same(&parts[1]) {
        op = "□.length_squared()".to_owned();
        parts.pop();
    }
    Tree {
        op,
        parts,
        at: tree.at.clone(),
    }
}

fn vector(number: &str) -> Tree {
    let leaves = ["Vec3::new", number, number, number];
    let parts = leaves.map(|op| Tree::new(op, Vec::new()));
    Tree::new("□(□, □, □)", parts.to_vec())
}
