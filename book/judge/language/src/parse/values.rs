//! Recursive descent: values without an operator, and what stands behind them.

use super::numbers::number;
use super::{Parser, is_keyword};
use crate::Language;
use crate::normal::{REAL, WHOLE, is_in};
use crate::tokens::TokenKind;
use crate::tree::{Op, Tree};

/// Modules and objects before `.` or `::` that a call does not need to be recognized.
const SPACES: &str = "std math Math MathF np numpy self this glm rtweekend";

impl Parser<'_> {
    /// Reads a value and the calls, fields, indices and casts behind it.
    pub(super) fn postfix(&mut self) -> Option<Tree> {
        let start = self.start();
        let mut tree = self.atom()?;
        loop {
            if self.is_on_a_new_line() && !self.is(".") && !self.is("?.") {
                return Some(tree);
            }
            match self.ahead(0) {
                "." | "->" | "?." | "::" => {
                    self.next += 1;
                    self.eat("::");
                    tree = self.member(tree)?;
                }
                "(" => {
                    let given = self.list("(", ")")?;
                    tree = called(tree, given)?;
                }
                "[" => {
                    let given = self.list("[", "]")?;
                    tree = Tree::new(Op::Index, [vec![tree], given].concat());
                }
                "?" | "!" | "!!" if self.ends_here() => self.next += 1,
                "as" => {
                    self.next += 1;
                    self.eat("?");
                    let name = self.ahead(0);
                    self.next += 1;
                    tree = Tree::call(name, vec![tree]);
                }
                "<" if self.type_arguments().is_some() => self.next += self.type_arguments()?,
                "{" if self.begins_record(&tree) => {
                    let given = self.list("{", "}")?;
                    tree = called(tree, given)?;
                }
                _ => return Some(tree),
            }
            tree = tree.placed_at(start..self.end());
        }
    }

    /// Returns true if `?` or `!` behind a value only unwraps it, and begins no choice.
    fn ends_here(&self) -> bool {
        let is_rust_or_later = matches!(
            self.language,
            Language::Rust
                | Language::Kotlin
                | Language::Swift
                | Language::JavaScript
                | Language::CSharp
        );
        let goes_on = self.is_word(1)
            || self.is_kind(1, TokenKind::Number)
            || matches!(self.ahead(1), "(" | "-");
        is_rust_or_later && (self.language == Language::Rust || !goes_on)
    }

    /// Returns true if a brace behind this name opens the fields of a new record.
    fn begins_record(&self, tree: &Tree) -> bool {
        use Language::{C, CSharp, Cpp, Go, Rust};
        let is_type = tree.parts.is_empty() && tree.at.end == self.end() && tree.name().is_some();
        is_type && !self.is_in_condition && matches!(self.language, Rust | Cpp | C | Go | CSharp)
    }

    /// Counts the tokens of type arguments, `<T, U>`, if these come next and are followed by a call.
    fn type_arguments(&self) -> Option<usize> {
        let mut depth = 0;
        for n in 0..if self.is("<") { 16 } else { 0 } {
            match self.ahead(n) {
                "<" => depth += 1,
                ">" => depth -= 1,
                ">>" => depth -= 2,
                "," | "::" | "*" | "&" | "." => {}
                _ if self.is_word(n) => {}
                _ => return None,
            }
            if depth == 0 {
                return matches!(self.ahead(n + 1), "(" | "::" | "{").then_some(n + 1);
            }
        }
        None
    }

    /// Reads the field, the method or the function of a module behind a dot or `::`.
    fn member(&mut self, of: Tree) -> Option<Tree> {
        if self.type_arguments().is_some() {
            self.next += self.type_arguments()?;
            return Some(of);
        }
        let name = self.ahead(0);
        self.next += 1;
        let is_space = |it| is_in(SPACES, it) || is_in(REAL, it);
        let is_own = matches!(name, "x" | "y" | "z" | "e");
        if name == "new" || name == "from" || name == "init" {
            return Some(of);
        }
        let is_of_self = matches!(of.name(), Some("self" | "this"));
        if of.name().is_some_and(is_space) && !(is_of_self && is_own) {
            return Some(Tree::name_of(name).placed_at(self.end() - name.len()..self.end()));
        }
        // A constant or a function of a type.
        let is_type = of
            .name()
            .is_some_and(|it| it.starts_with(char::is_uppercase) && it.len() > 1);
        if is_type && (name.starts_with(char::is_uppercase) || self.is("(")) {
            return Some(Tree::name_of(name));
        }
        Some(Tree::call(name, vec![of]))
    }

    /// Reads a value that no other is a part of: a number, a name, or what brackets enclose.
    fn atom(&mut self) -> Option<Tree> {
        let start = self.start();
        let token = *self.tokens.get(self.next)?;
        let tree = match (token.kind, token.text) {
            (TokenKind::Number, text) => {
                self.next += 1;
                Tree::new(number(text)?, Vec::new())
            }
            (TokenKind::Text, text) => {
                self.next += 1;
                Tree::new(Op::Text(text.to_owned()), Vec::new())
            }
            (_, "(") => self.in_brackets()?,
            (_, "[") => Tree::new(Op::List, self.list("[", "]")?),
            (_, "{") if !self.is_in_condition => Tree::new(Op::List, self.list("{", "}")?),
            (_, "let") => self.bound()?,
            (_, "lambda") => {
                while !self.is(":") && self.next < self.tokens.len() {
                    self.next += 1;
                }
                self.next += 1;
                let value = self.expression()?;
                Tree::call("lambda", vec![value])
            }
            (TokenKind::Word, text) if !is_keyword(text) => {
                self.next += 1;
                if self.eat("=>") {
                    let value = self.expression()?;
                    Tree::call("lambda", vec![value])
                } else {
                    Tree::name_of(text)
                }
            }
            _ => return None,
        };
        Some(tree.placed_at(start..self.end()))
    }

    /// Reads `let pattern = value` in a condition; the last name of the pattern gets the value.
    fn bound(&mut self) -> Option<Tree> {
        let mut name = "";
        while !self.is("=") {
            if self.is_word(0) {
                name = self.ahead(0);
            }
            self.next += 1;
            self.tokens.get(self.next)?;
        }
        self.next += 1;
        let value = self.binary(5)?;
        self.fields.push((name.to_owned(), value.clone()));
        Some(value)
    }

    /// Reads a value in brackets, a tuple, a cast like `(int) x`, or a function `(x) => value`.
    fn in_brackets(&mut self) -> Option<Tree> {
        if let Some(end) = self.closing()
            && self.ahead(end + 1) == "=>"
        {
            self.next += end + 2;
            let value = self.expression()?;
            return Some(Tree::call("lambda", vec![value]));
        }
        let start = self.start();
        let cast = self.ahead(1);
        if (is_in(WHOLE, cast) || is_in(REAL, cast)) && self.ahead(2) == ")" {
            self.next += 3;
            let value = self.prefix()?;
            return Some(Tree::call(cast, vec![value]));
        }
        let mut all = self.list("(", ")")?;
        match all.len() {
            // The brackets are a part of its place.
            1 => Some(all.pop()?.placed_at(start..self.end())),
            _ => Some(Tree::new(Op::List, all)),
        }
    }

    /// Counts the tokens from the bracket that comes next to the one that closes it, if that is near.
    fn closing(&self) -> Option<usize> {
        let mut depth = 0;
        let rest = self.tokens[self.next..].iter();
        rest.take(40).position(|it| {
            depth += i32::from(it.text == "(") - i32::from(it.text == ")");
            depth == 0
        })
    }
}

/// Makes a call with these arguments; `None` if no name or method stands before the brackets.
fn called(of: Tree, given: Vec<Tree>) -> Option<Tree> {
    match of.op {
        Op::Name(name) => {
            // A cast of a quotient divides whole numbers.
            let is_real = is_in(REAL, &name);
            let given = match &given[..] {
                [one] if is_real && one.op == Op::Operator("/") && !has_cast(one) => {
                    vec![Tree {
                        op: Op::Operator("//"),
                        ..one.clone()
                    }]
                }
                _ => given,
            };
            Some(Tree::call(&name, given))
        }
        // A method: its object is the first part.
        Op::Call(name) => Some(Tree::call(&name, [of.parts, given].concat())),
        _ => None,
    }
}

/// Returns true if a part of a quotient is a real number or cast to one.
fn has_cast(tree: &Tree) -> bool {
    let nodes = tree.nodes().into_iter();
    let mut all = nodes.map(|it| &it.op);
    all.any(|op| match op {
        Op::Call(name) => is_in(REAL, name),
        Op::Number(_, is_whole) => !is_whole,
        _ => false,
    })
}
