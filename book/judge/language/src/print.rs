//! Pretty-printing: a tree, or a line of Rust, in the spelling of a language.

use crate::Language;
use crate::normal::{REAL, function, is_in};
use crate::parse::Parser;
use crate::tree::{Op, Tree};

/// The spellings of functions in the chapters' Rust and in the book's C++: `.name` is a field,
/// `.name()` a method, `name()` a function. Where only C++ has a method for a field, other
/// languages get the field.
const SPELLINGS: [(&str, [&str; 2]); 22] = [
    ("unit", [".normalize()", "unit_vector()"]),
    ("dot", [".dot()", "dot()"]),
    ("length", [".length()", ".length()"]),
    ("lengthsquared", [".length_squared()", ".length_squared()"]),
    ("sqrt", [".sqrt()", "sqrt()"]),
    ("abs", [".abs()", "abs()"]),
    ("round", [".round()", "round()"]),
    ("max", [".max()", "max()"]),
    ("min", [".min()", "min()"]),
    ("at", [".at()", ".at()"]),
    ("hit", [".hit()", ".hit()"]),
    (
        "setfacenormal",
        [".set_face_normal()", ".set_face_normal()"],
    ),
    ("vec", ["Vec3::new()", "vec3()"]),
    ("sphere", ["Sphere::new()", "sphere()"]),
    ("ray", ["Ray::new()", "ray()"]),
    ("x", [".x", ".x()"]),
    ("y", [".y", ".y()"]),
    ("z", [".z", ".z()"]),
    ("origin", [".origin", ".origin()"]),
    ("direction", [".direction", ".direction()"]),
    ("point", [".point", ".p"]),
    ("frontface", [".front_face", ".front_face"]),
];
/// Variables and constants that have another name in the book than in the chapters' Rust.
const NAMES: [(&str, &str); 4] = [
    ("ray", "r"),
    ("record", "rec"),
    ("f64::INFINITY", "infinity"),
    ("INFINITY", "infinity"),
];

impl Language {
    /// Translates a line of Rust, one or more statements, to this language, on one line and with
    /// the names of the book.
    ///
    /// Returns the line unchanged for Rust, and if a statement is not understood or can't be
    /// expressed in the language.
    pub fn translate_line(self, line: &str) -> String {
        if self == Self::Rust {
            return line.to_owned();
        }
        let parts = line.split_inclusive(';').map(str::trim);
        let printed: Option<Vec<String>> = parts.map(|part| self.statement(part)).collect();
        printed.map_or(line.to_owned(), |parts| parts.join(" "))
    }

    /// Translates a statement: `return`, the head of an `if`, an assignment or an expression.
    fn statement(self, text: &str) -> Option<String> {
        let (text, end) = match text.strip_suffix(';') {
            Some(text) => (text, if self.ends_at_lines() { "" } else { ";" }),
            None => (text, ""),
        };
        let text = text.strip_prefix("let ").unwrap_or(text);
        let text = text.strip_prefix("mut ").unwrap_or(text);
        if let Some(value) = text.strip_prefix("return ") {
            return Some(format!("return {}{end}", self.translated(value)?));
        }
        if let Some(condition) = text
            .strip_prefix("if ")
            .and_then(|it| it.strip_suffix(" {"))
        {
            let condition = self.translated(condition)?;
            return Some(match self {
                Self::Python => format!("if {condition}:"),
                Self::Go | Self::Swift => format!("if {condition} {{"),
                _ => format!("if ({condition}) {{"),
            });
        }
        let is_name = |it: &str| {
            it.chars()
                .all(|c| c.is_alphanumeric() || c == '_' || c == '.')
        };
        match text.split_once(" = ").filter(|(name, _)| is_name(name)) {
            Some((name, value)) => Some(format!(
                "{} = {}{end}",
                self.translated(name)?,
                self.translated(value)?
            )),
            None => Some(self.translated(text)? + end),
        }
    }

    /// Translates an expression of Rust, without the `Some(…)` around it.
    fn translated(self, rust: &str) -> Option<String> {
        let mut parser = Parser::new(rust, Self::Rust);
        let tree = parser.expression()?;
        let is_whole = parser.next == parser.tokens.len() && parser.fields.is_empty();
        let tree = match &tree.parts[..] {
            [value] if tree.is_call("Some") => value,
            _ => &tree,
        };
        is_whole.then(|| self.to_source(tree)).flatten()
    }

    /// Writes an expression as source code of this language. Returns `None` if the expression has a
    /// closure or the reciprocal of the [`normal`](crate::normal()) form, which are not written.
    pub fn to_source(self, tree: &Tree) -> Option<String> {
        self.within(tree, 0)
    }

    /// Prints an expression, in brackets if it binds less firmly than `least`.
    fn within(self, tree: &Tree, least: u8) -> Option<String> {
        // These languages convert whole numbers to real ones by themselves.
        if let (Op::Call(name), [value]) = (&tree.op, &tree.parts[..])
            && matches!(self, Self::Python | Self::JavaScript)
            && is_in(REAL, name)
        {
            return self.within(value, least);
        }
        let level = level(&tree.op);
        let text = self.text(tree, level)?;
        Some(if level < least {
            format!("({text})")
        } else {
            text
        })
    }

    /// Prints an expression without brackets around it; `level` is the [`level`] of its root.
    fn text(self, tree: &Tree, level: u8) -> Option<String> {
        let part = |n: usize, least: u8| self.within(&tree.parts[n], least);
        Some(match &tree.op {
            Op::Name(name) => self.name(name),
            Op::Number(value, true) if self != Self::Rust => format!("{value}"),
            Op::Number(value, _) => format!("{value:?}"),
            Op::Text(text) => text.clone(),
            Op::Negative => format!("-{}", part(0, level)?),
            Op::Not if self == Self::Python => format!("not {}", part(0, level)?),
            Op::Not => format!("!{}", part(0, level)?),
            Op::Operator(sign) => {
                let sign = match (*sign, self) {
                    ("&&", Self::Python) => "and",
                    ("||", Self::Python) => "or",
                    ("//", it) if it != Self::Python => "/",
                    (sign, _) => sign,
                };
                let sides = (part(0, level)?, part(1, level + 1)?);
                format!("{} {sign} {}", sides.0, sides.1)
            }
            Op::Choice => {
                let [asked, then, other] = [part(0, 2)?, part(1, 2)?, part(2, 1)?];
                match self {
                    Self::Python => format!("{then} if {asked} else {other}"),
                    Self::Rust => format!("if {asked} {{ {then} }} else {{ {other} }}"),
                    Self::Kotlin => format!("if ({asked}) {then} else {other}"),
                    _ => format!("{asked} ? {then} : {other}"),
                }
            }
            Op::List => format!("[{}]", self.list(&tree.parts)?),
            Op::Index => format!("{}[{}]", part(0, ATOM)?, part(1, 0)?),
            Op::Call(name) => return self.call(name, &tree.parts),
            Op::Reciprocal => return None,
        })
    }

    /// Prints expressions with commas between them.
    fn list(self, parts: &[Tree]) -> Option<String> {
        let parts = parts.iter().map(|it| self.within(it, 0));
        Some(parts.collect::<Option<Vec<_>>>()?.join(", "))
    }

    /// Prints a variable or a constant.
    fn name(self, name: &str) -> String {
        match (name, self) {
            (it, Self::Rust) if it.eq_ignore_ascii_case("infinity") => "f64::INFINITY".to_owned(),
            ("ONE", _) => self.vector("1.0"),
            ("ZERO", _) => self.vector("0.0"),
            ("true", Self::Python) => "True".to_owned(),
            ("false", Self::Python) => "False".to_owned(),
            ("INFINITY", Self::Python) => "math.inf".to_owned(),
            (it, Self::Rust) => it.to_owned(),
            (it, _) => {
                let other = NAMES.iter().find(|(one, _)| *one == it);
                other.map_or(it, |(_, other)| other).to_owned()
            }
        }
    }

    /// Prints a call, a field, an operator that is spelled as a function, or a cast.
    fn call(self, name: &str, parts: &[Tree]) -> Option<String> {
        let id = function(name, parts.len());
        if let ("+" | "-" | "*" | "/", [one, other]) = (&*id, parts) {
            let sign = Op::Operator(["+", "-", "*", "/"].into_iter().find(|it| *it == id)?);
            return self.to_source(&Tree::new(sign, vec![one.clone(), other.clone()]));
        }
        if let [value] = parts
            && is_in(REAL, name)
        {
            return self.cast(value);
        }
        if id == "lambda" {
            return None;
        }
        let spelling = self.spelling(&id, name, parts.len());
        let Some(method) = spelling.strip_prefix('.') else {
            return Some(format!(
                "{}({})",
                spelling.trim_end_matches("()"),
                self.list(parts)?
            ));
        };
        let (of, given) = parts.split_first()?;
        let of = self.within(of, ATOM)?;
        match method.strip_suffix("()") {
            Some(method) => Some(format!("{of}.{method}({})", self.list(given)?)),
            None => Some(format!("{of}.{method}")),
        }
    }

    /// Returns the spelling of a function in this language, as in [`SPELLINGS`]. A function that is
    /// not listed there keeps its name; with one argument, it may be a [field](is_field).
    fn spelling(self, id: &str, name: &str, arguments: usize) -> String {
        let row = SPELLINGS.iter().find(|(it, _)| *it == id);
        let spelling = match row {
            None if arguments == 1 && is_field(name) => return format!(".{name}"),
            None => return format!("{name}()"),
            Some((_, [rust, _])) if self == Self::Rust => rust,
            Some((_, [rust, book])) if self != Self::Cpp && !rust.ends_with(')') => {
                book.trim_end_matches("()")
            }
            Some((_, [_, book])) => book,
        };
        let spelling = match (spelling, self) {
            ("sqrt()", Self::Python) => "math.sqrt()",
            ("sqrt()", Self::JavaScript | Self::Java) => "Math.sqrt()",
            ("sqrt()", Self::CSharp) => "Math.Sqrt()",
            ("sqrt()", Self::Go) => "math.Sqrt()",
            (it, _) => it,
        };
        spelling.to_owned()
    }

    /// Prints a cast to a real number.
    fn cast(self, value: &Tree) -> Option<String> {
        let text = self.within(value, 0)?;
        Some(match self {
            Self::Rust => format!("f64::from({text})"),
            Self::Go => format!("float64({text})"),
            Self::Swift => format!("Double({text})"),
            Self::Kotlin => format!("({text}).toDouble()"),
            _ => format!("double({text})"),
        })
    }

    /// Prints the vector whose components are this number.
    fn vector(self, number: &str) -> String {
        let name = if self == Self::Rust {
            "Vec3::new"
        } else {
            "vec3"
        };
        format!("{name}({number}, {number}, {number})")
    }
}

/// Returns true if the chapters' records, spheres, cameras or intervals have this field.
fn is_field(name: &str) -> bool {
    matches!(
        name,
        "t" | "normal" | "center" | "radius" | "pixel00" | "objects" | "min" | "max"
    )
}

/// The [`level`] of what never needs brackets.
const ATOM: u8 = 12;

/// Returns how firmly an operation binds its operands, from 1 to [`ATOM`].
fn level(op: &Op) -> u8 {
    match op {
        Op::Choice => 1,
        Op::Operator(sign) => match *sign {
            "=" | "in" => 1,
            "||" => 3,
            "&&" => 4,
            "==" | "!=" | "<" | ">" | "<=" | ">=" => 6,
            "+" | "-" => 9,
            "*" | "/" | "//" | "%" => 10,
            _ => 2,
        },
        Op::Not | Op::Negative => 11,
        _ => ATOM,
    }
}
