//! Syntax trees of functions: what two programs are compared by, and what edits are made of.
//!
//! A node is what it does and its parts. Brackets are no nodes: the text of a tree has them where
//! the place of a part wants them.

use std::ops::Range;

use crate::sources::likeness;

/// What a node does with its parts.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum RustOp {
    /// Statements in braces.
    Block,
    /// A name, a number, or what else has no parts.
    Leaf(String),
    /// A sign between two parts.
    Sign(String),
    /// A sign before its part.
    Prefix(String),
    /// A function and what it is given.
    Call,
    /// A method of the first part and what it is given.
    Method(String),
    /// A field of its part.
    Field(String),
    /// A field of a new struct and its value.
    Member(String),
    /// A name for its part; whether it is a statement, and not a condition.
    Let(BoundName, bool),
    /// A name for each of the first part, and what is done with it.
    For(BoundName),
    /// A condition, what follows from it, and what else.
    If,
    While,
    Return,
    /// Its part with a semicolon.
    Statement,
    /// The texts around its parts.
    Other(Vec<String>),
}

/// A name that is given, and what stands around it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BoundName {
    /// `mut ` or `Some(`; or the whole, if it has no such name.
    pub(super) before: String,
    pub(super) name: String,
    after: String,
}

/// A part of a function.
#[derive(Clone, Debug)]
pub(super) struct RustTree {
    pub(super) op: RustOp,
    pub(super) parts: Vec<RustTree>,
    /// Where it stands in the text of its function.
    pub(super) at: Range<usize>,
}

impl RustOp {
    /// Returns the sign, if it stands between two parts.
    pub(super) fn sign(&self) -> Option<&str> {
        match self {
            Self::Sign(sign) => Some(sign),
            _ => None,
        }
    }

    /// Returns the name that it gives.
    pub(super) fn pattern(&self) -> Option<&BoundName> {
        match self {
            Self::Let(pattern, _) | Self::For(pattern) => Some(pattern),
            _ => None,
        }
        .filter(|it| !it.name.is_empty())
    }

    /// How firmly it holds together: a part needs brackets if it holds less firmly than its
    /// place wants.
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

    /// Returns true if the first part stands before a dot or a bracket of its own.
    fn has_object(&self) -> bool {
        match self {
            Self::Method(_) | Self::Field(_) => true,
            Self::Other(texts) => texts[0].is_empty() && texts[1].starts_with(['?', '[']),
            _ => false,
        }
    }
}

impl RustTree {
    /// Makes a tree that stands nowhere yet.
    pub(super) fn new(op: RustOp, parts: Vec<Self>) -> Self {
        Self {
            op,
            parts,
            at: 0..0,
        }
    }

    /// Makes a name or a number that stands nowhere yet.
    pub(super) fn leaf(text: &str) -> Self {
        Self::new(RustOp::Leaf(text.to_owned()), Vec::new())
    }

    /// A sign between two parts.
    pub(super) fn binary(sign: &str, one: &Self, other: &Self) -> Self {
        Self::new(
            RustOp::Sign(sign.to_owned()),
            vec![one.clone(), other.clone()],
        )
    }

    /// Its text, if it has no parts.
    pub(super) fn name(&self) -> Option<&str> {
        match &self.op {
            RustOp::Leaf(name) => Some(name),
            _ => None,
        }
    }

    /// Lists all nodes, each before its parts.
    pub(super) fn nodes(&self) -> Vec<&Self> {
        let parts = self.parts.iter().flat_map(Self::nodes);
        [self].into_iter().chain(parts).collect()
    }

    pub(super) fn is_same(&self, other: &Self) -> bool {
        let mut parts = self.parts.iter().zip(&other.parts);
        self.op == other.op
            && self.parts.len() == other.parts.len()
            && parts.all(|(one, other)| one.is_same(other))
    }

    /// Measures how much two trees have in common, from 0 to 1.
    pub(super) fn likeness(&self, other: &Self) -> f64 {
        let ops =
            |tree: &Self| -> Vec<RustOp> { tree.nodes().iter().map(|it| it.op.clone()).collect() };
        likeness(&ops(self), &ops(other))
    }

    /// Replaces each node for which there is something else, from the root on.
    pub(super) fn mapped(&self, other: &dyn Fn(&Self) -> Option<Self>) -> Self {
        other(self).unwrap_or_else(|| Self {
            op: self.op.clone(),
            parts: self.parts.iter().map(|it| it.mapped(other)).collect(),
            at: self.at.clone(),
        })
    }

    /// Puts another tree in one place.
    pub(super) fn with(&self, at: &Range<usize>, new: &Self) -> Self {
        self.mapped(&|it| (it.at == *at).then(|| new.clone()))
    }

    /// Returns how firm its nth part has to be.
    pub(super) fn least(&self, n: usize) -> u8 {
        match self.op.level() {
            ATOM if n == 0 && self.op.has_object() => ATOM,
            0 | ATOM => 0,
            level if self.op.sign().is_some() => level + n.min(1) as u8,
            level => level,
        }
    }

    /// Its text, in brackets where the place wants a firmer one.
    pub(super) fn within(&self, least: u8) -> String {
        let text = self.text();
        if self.op.level() < least {
            format!("({text})")
        } else {
            text
        }
    }

    pub(super) fn text(&self) -> String {
        self.text_of(&|part, least| part.within(least))
    }

    /// Its text with these texts of its parts, each for how firm it has to be.
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

    /// Returns true if the name stands alone.
    pub(super) fn is_whole(&self) -> bool {
        self.before.is_empty() && self.after.is_empty()
    }

    fn text(&self) -> String {
        [&*self.before, &self.name, &self.after].concat()
    }
}

/// What needs no brackets anywhere.
pub(super) const ATOM: u8 = 9;

/// On one line, without comments, and with blanks where rustfmt has them.
pub(super) fn squeezed(text: &str) -> String {
    let code = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or(line));
    let words: Vec<&str> = code.flat_map(str::split_whitespace).collect();
    let mut text = words.join(" ");
    for (loose, tight) in [
        ("( ", "("),
        (", )", ")"),
        (",)", ")"),
        (" )", ")"),
        (", }", " }"),
        (" .", "."),
        (",..", ", .."),
        (" ,", ","),
        (",\0", ", \0"),
    ] {
        text = text.replace(loose, tight);
    }
    text
}
