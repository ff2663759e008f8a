//! Syntax trees of functions in Rust, by which programs are compared and edits are made.
//!
//! A node is an operation and its parts. Round brackets are no nodes: they are written where a part
//! binds less firmly than its place wants.

use std::ops::Range;

/// The operation of a node on its parts.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum RustOp {
    /// Statements in braces.
    Block,
    /// A name, a number, or other code without parts.
    Leaf(String),
    /// An operator between two parts.
    Sign(String),
    /// An operator before its part.
    Prefix(String),
    /// A call of the function that the first part is, with the others as arguments.
    Call,
    /// A call of this method of the first part, with the others as arguments.
    Method(String),
    /// The field of this name of its part.
    Field(String),
    /// A field of this name in a new struct, with its part as the value.
    Member(String),
    /// A declaration of a variable with its part as the value; true for a statement, false for a
    /// condition.
    Let(BoundName, bool),
    /// A loop over the first part with this variable; the second part is its block.
    For(BoundName),
    /// An `if`: the condition, the block, and maybe the block of `else`.
    If,
    /// A `while`: the condition and the block.
    While,
    /// A `return` of its part.
    Return,
    /// A statement: its part with a semicolon behind it.
    Statement,
    /// Other code: the texts before, between and behind its parts.
    Other(Vec<String>),
}

/// A pattern with one name, as in `let mut t` or `if let Some(t)`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BoundName {
    /// The text before the name, as `mut ` or `Some(`; the whole pattern if it has not just one
    /// name.
    pub(super) before: String,
    /// The name; empty if the pattern has not just one.
    pub(super) name: String,
    /// The text behind the name.
    after: String,
}

/// A syntax tree of a part of a function in Rust.
#[derive(Clone, Debug)]
pub(super) struct RustTree {
    /// The operation of the root.
    pub(super) op: RustOp,
    /// The operands, in the order of the text.
    pub(super) parts: Vec<RustTree>,
    /// The bytes of the tree in the text of its function; empty if the tree was made, not read.
    pub(super) at: Range<usize>,
}

impl RustOp {
    /// Returns the operator between two parts; `None` for other operations.
    pub(super) fn sign(&self) -> Option<&str> {
        match self {
            Self::Sign(sign) => Some(sign),
            _ => None,
        }
    }

    /// Returns the pattern of a declaration or a loop, if it has a name.
    pub(super) fn pattern(&self) -> Option<&BoundName> {
        match self {
            Self::Let(pattern, _) | Self::For(pattern) => Some(pattern),
            _ => None,
        }
        .filter(|it| !it.name.is_empty())
    }

    /// Returns how firmly the operation binds its parts, from 0 to [`ATOM`]. A tree needs brackets
    /// where its place wants a greater level.
    pub(super) fn level(&self) -> u8 {
        match self {
            Self::Sign(sign) => match &**sign {
                "||" => 1,
                "&&" => 2,
                "<" | ">" | "<=" | ">=" | "==" | "!=" => 3,
                "+" | "-" => 5,
                "*" | "/" | "%" => 6,
                _ => 0,
            },
            Self::Let(..) => 3,
            Self::Prefix(_) => 8,
            Self::If | Self::Return => 0,
            Self::Other(texts) if texts[0].starts_with('|') => 0,
            Self::Other(texts) if texts[1].starts_with(" as ") => 7,
            _ => ATOM,
        }
    }

    /// Returns true if the first part stands before a dot, `?` or an index.
    fn has_object(&self) -> bool {
        match self {
            Self::Method(_) | Self::Field(_) => true,
            Self::Other(texts) => texts[0].is_empty() && texts[1].starts_with(['?', '[']),
            _ => false,
        }
    }
}

impl RustTree {
    /// Makes a tree that has no place in a text.
    pub(super) fn new(op: RustOp, parts: Vec<Self>) -> Self {
        Self {
            op,
            parts,
            at: 0..0,
        }
    }

    /// Makes a name or a number that has no place in a text.
    pub(super) fn leaf(text: &str) -> Self {
        Self::new(RustOp::Leaf(text.to_owned()), Vec::new())
    }

    /// Makes the tree of an operator between two parts.
    pub(super) fn binary(sign: &str, one: &Self, other: &Self) -> Self {
        Self::new(
            RustOp::Sign(sign.to_owned()),
            vec![one.clone(), other.clone()],
        )
    }

    /// Returns the text of a leaf; `None` for a tree with parts.
    pub(super) fn name(&self) -> Option<&str> {
        match &self.op {
            RustOp::Leaf(name) => Some(name),
            _ => None,
        }
    }

    /// Lists the tree and all trees inside of it, each before its parts.
    pub(super) fn nodes(&self) -> Vec<&Self> {
        let parts = self.parts.iter().flat_map(Self::nodes);
        [self].into_iter().chain(parts).collect()
    }

    /// Returns true if two trees are equal but for their places.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let mut parts = self.parts.iter().zip(&other.parts);
        self.op == other.op
            && self.parts.len() == other.parts.len()
            && parts.all(|(one, other)| one.is_same(other))
    }

    /// Returns the tree with other trees in the place of those for which `other` returns one. The
    /// parts of such a tree are not asked for.
    pub(super) fn mapped(&self, other: &dyn Fn(&Self) -> Option<Self>) -> Self {
        other(self).unwrap_or_else(|| Self {
            op: self.op.clone(),
            parts: self.parts.iter().map(|it| it.mapped(other)).collect(),
            at: self.at.clone(),
        })
    }

    /// Returns the tree with another one at the place `at`.
    pub(super) fn with(&self, at: &Range<usize>, new: &Self) -> Self {
        self.mapped(&|it| (it.at == *at).then(|| new.clone()))
    }

    /// Returns the least level of the `n`th part that needs no brackets.
    pub(super) fn least(&self, n: usize) -> u8 {
        match self.op.level() {
            ATOM if n == 0 && self.op.has_object() => ATOM,
            0 | ATOM => 0,
            level if self.op.sign().is_some() => level + n.min(1) as u8,
            level => level,
        }
    }

    /// Writes the tree as code, in brackets if its level is less than `least`.
    pub(super) fn within(&self, least: u8) -> String {
        let text = self.text();
        if self.op.level() < least {
            format!("({text})")
        } else {
            text
        }
    }

    /// Writes the tree as code.
    pub(super) fn text(&self) -> String {
        self.text_of(&|part, least| part.within(least))
    }

    /// Writes the tree as code; `part` writes each part for the least level of its place.
    pub(super) fn text_of(&self, part: &dyn Fn(&Self, u8) -> String) -> String {
        let parts = self.parts.iter().enumerate();
        let parts: Vec<String> = parts.map(|(n, it)| part(it, self.least(n))).collect();
        let given = || parts[1..].join(", ");
        match &self.op {
            RustOp::Block => format!("{{ {} }}", parts.join(" ")),
            RustOp::Leaf(text) => text.clone(),
            RustOp::Sign(sign) if sign.starts_with("..") => parts.join(sign),
            RustOp::Sign(sign) => parts.join(&format!(" {sign} ")),
            RustOp::Prefix(sign) => format!("{sign}{}", parts[0]),
            RustOp::Call => format!("{}({})", parts[0], given()),
            RustOp::Method(name) => format!("{}.{name}({})", parts[0], given()),
            RustOp::Field(name) => format!("{}.{name}", parts[0]),
            RustOp::Member(name) => format!("{name}: {}", parts[0]),
            RustOp::Let(pattern, true) => format!("let {} = {};", pattern.text(), parts[0]),
            RustOp::Let(pattern, false) => format!("let {} = {}", pattern.text(), parts[0]),
            RustOp::For(pattern) => format!("for {} in {}", pattern.text(), parts.join(" ")),
            RustOp::If => match &parts[..] {
                [condition, then, other] => format!("if {condition} {then} else {other}"),
                _ => format!("if {}", parts.join(" ")),
            },
            RustOp::While => format!("while {}", parts.join(" ")),
            RustOp::Return => format!("return {}", parts[0]),
            RustOp::Statement => format!("{};", parts[0]),
            RustOp::Other(texts) => {
                let parts = parts.iter().map(String::as_str).chain([""]);
                texts
                    .iter()
                    .zip(parts)
                    .map(|(one, it)| format!("{one}{it}"))
                    .collect()
            }
        }
    }
}

impl BoundName {
    /// Reads a pattern.
    pub(super) fn of(text: &str) -> Self {
        let mark = ["mut ", "Some("]
            .into_iter()
            .find(|it| text.starts_with(it));
        let (before, rest) = text.split_at(mark.map_or(0, str::len));
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        match rest.split_at(end.unwrap_or(rest.len())) {
            ("", _) => Self {
                before: text.to_owned(),
                name: String::new(),
                after: String::new(),
            },
            (name, after) => Self {
                before: before.to_owned(),
                name: name.to_owned(),
                after: after.to_owned(),
            },
        }
    }

    /// Writes the pattern as code.
    fn text(&self) -> String {
        [&*self.before, &self.name, &self.after].concat()
    }
}

/// The level of a tree that needs no brackets anywhere.
pub(super) const ATOM: u8 = 9;
