//! Translation, token by token: an expression of Python or C++ as the same in Rust, and Rust in
//! the fewest words.

use std::borrow::Cow;

use super::parsed::Reader;
use super::tree::{Op, Tree};
use crate::sources::lexed;

/// Longer expressions are left alone, and those with more signs that each may be a level deeper.
const LONGEST: usize = 300;
const DEEPEST: usize = 40;
/// Signs of two letters.
const SIGNS: [&str; 9] = ["->", "**", "&&", "||", "<=", ">=", "==", "!=", "::"];

/// Reads an expression as a tree of Rust, if it can be one.
pub(super) fn in_rust(text: &str, is_python: bool) -> Option<Tree> {
    let rust = (text.len() <= LONGEST).then(|| translated(text, is_python))?;
    let deep = rust.matches(|c: char| "([{-!&*|".contains(c));
    if deep.count() > DEEPEST {
        return None;
    }
    let expression = syn::parse_str(&rust).ok()?;
    Some(plain(&Reader { text: &rust }.expression(&expression)))
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
    let parts: Vec<Tree> = tree.parts.iter().map(plain).collect();
    let node = |op, parts: &[Tree]| Tree {
        op,
        parts: parts.to_vec(),
        at: tree.at.clone(),
    };
    let method = |name: &str, parts: &[Tree]| node(Op::Method(name.to_owned()), parts);
    let plain = match (&tree.op, &parts[..]) {
        (Op::Call, [function, given @ ..]) => {
            let name = function.name().unwrap_or_default().to_lowercase();
            match (name.trim_end_matches("::new"), given) {
                ("double" | "float", [one]) => return one.clone(),
                (name @ ("sqrt" | "abs" | "length" | "length_squared" | "normalize"), [_]) => {
                    method(name, given)
                }
                ("fabs", [_]) => method("abs", given),
                ("unit_vector" | "unit" | "normalized", [_]) => method("normalize", given),
                ("dot", [_, _]) => method("dot", given),
                ("add", [_, _]) => node(Op::Sign("+".to_owned()), given),
                ("sub", [_, _]) => node(Op::Sign("-".to_owned()), given),
                ("scale", [_, _]) => node(Op::Sign("*".to_owned()), given),
                ("sphere", [_, _]) => with_function("Sphere::new", tree, given),
                ("vec3" | "point3" | "color", [_, _, _]) => with_function("Vec3::new", tree, given),
                _ => node(Op::Call, &parts),
            }
        }
        (Op::Method(name) | Op::Field(name), [of]) => match &**name {
            "origin" | "orig" => node(Op::Field("origin".to_owned()), &parts),
            "direction" | "dir" => node(Op::Field("direction".to_owned()), &parts),
            "x" | "y" | "z" => node(Op::Field(name.clone()), &parts),
            "unit" | "normalized" => method("normalize", &parts),
            _ => node(tree.op.clone(), std::slice::from_ref(of)),
        },
        (Op::Leaf(name), []) => match &**name {
            "Vec3::ZERO" | "Point3::ZERO" => vector("0.0"),
            "Vec3::ONE" | "Color::ONE" => vector("1.0"),
            _ => tree.clone(),
        },
        _ => node(tree.op.clone(), &parts),
    };
    match (&plain.op, &plain.parts[..]) {
        (Op::Method(name), [one, other]) if name == "dot" && one.is_same(other) => {
            method("length_squared", &plain.parts[..1])
        }
        _ => plain,
    }
}

fn with_function(name: &str, tree: &Tree, given: &[Tree]) -> Tree {
    let parts = [Tree::leaf(name)].into_iter().chain(given.iter().cloned());
    Tree {
        parts: parts.collect(),
        ..tree.clone()
    }
}

fn vector(number: &str) -> Tree {
    let parts = ["Vec3::new", number, number, number].map(Tree::leaf);
    Tree::new(Op::Call, parts.to_vec())
}
