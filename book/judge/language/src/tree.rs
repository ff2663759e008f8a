//! The tree: what an expression does, and its parts.

use std::ops::Range;

/// What a node does with its parts.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// A variable or a constant.
    Name(String),
    /// A number, and whether it is typed as a whole one.
    Number(f64, bool),
    /// A text in its quotes.
    Text(String),
    /// A function of its parts: one that is called, a method of the first part, its field, or a
    /// type that is made of them.
    Call(String),
    /// A sign between two parts; `//` divides whole numbers, `=` gives a name to what follows.
    Sign(&'static str),
    /// The negative of its part.
    Minus,
    /// The contrary of its part.
    Not,
    /// A condition, what comes of it, and what else.
    Choice,
    /// A list or tuple.
    List,
    /// A list, and the number of its part.
    Index,
    /// In the normal form: one divided by its part.
    Over,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Tree {
    /// What it does.
    pub op: Op,
    /// With what.
    pub parts: Vec<Tree>,
    /// Where it stands in its text.
    pub at: Range<usize>,
}

impl Tree {
    /// Makes a node that stands nowhere.
    pub fn new(op: Op, parts: Vec<Self>) -> Self {
        Self {
            op,
            parts,
            at: 0..0,
        }
    }

    /// Makes a call that stands nowhere.
    pub(crate) fn call(name: &str, parts: Vec<Self>) -> Self {
        Self::new(Op::Call(name.to_owned()), parts)
    }

    /// Makes a variable or a constant at no place.
    pub fn name_of(name: &str) -> Self {
        Self::new(Op::Name(name.to_owned()), Vec::new())
    }

    /// Makes a real number at no place.
    pub(crate) fn number(value: f64) -> Self {
        Self::new(Op::Number(value, false), Vec::new())
    }

    /// Puts it at a place.
    pub fn at(self, at: Range<usize>) -> Self {
        Self { at, ..self }
    }

    /// Returns its name, if it is one.
    pub fn name(&self) -> Option<&str> {
        match &self.op {
            Op::Name(name) => Some(name),
            _ => None,
        }
    }

    /// Returns its value, if it is a number.
    pub(crate) fn value(&self) -> Option<f64> {
        match self.op {
            Op::Number(value, _) => Some(value),
            _ => None,
        }
    }

    /// Returns true if it is a call of that function.
    pub fn is_call(&self, name: &str) -> bool {
        matches!(&self.op, Op::Call(it) if it == name)
    }

    /// Lists all nodes, each before its parts.
    pub fn nodes(&self) -> Vec<&Self> {
        let parts = self.parts.iter().flat_map(Self::nodes);
        [self].into_iter().chain(parts).collect()
    }

    /// Replaces each node for which there is something else, from the root on.
    pub fn mapped(&self, other: &dyn Fn(&Self) -> Option<Self>) -> Self {
        other(self).unwrap_or_else(|| Self {
            op: self.op.clone(),
            parts: self.parts.iter().map(|it| it.mapped(other)).collect(),
            at: self.at.clone(),
        })
    }

    /// Returns true if both are the same, wherever they stand.
    pub fn is_same(&self, other: &Self) -> bool {
        let mut parts = self.parts.iter().zip(&other.parts);
        self.op == other.op
            && self.parts.len() == other.parts.len()
            && parts.all(|(one, other)| one.is_same(other))
    }
}
