//! Abstract syntax trees of expressions, one kind for all languages.

use std::ops::Range;

/// The operation of a tree's root on its parts.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// The value of a variable or a constant; no parts.
    Name(String),
    /// A number; true if it is written without a point, as a whole one. No parts.
    Number(f64, bool),
    /// A string literal with its quotes; no parts.
    Text(String),
    /// A call by this name: of a function with the parts as arguments, of a method or a field of
    /// the first part, or of a type that is made of the parts.
    Call(String),
    /// An operator between two parts; `//` divides whole numbers, `=` assigns.
    Sign(&'static str),
    /// The negative of the only part.
    Minus,
    /// The contrary of the only part, a condition.
    Not,
    /// A choice: the first part is the condition, the second the value if it holds, the third
    /// the value if not.
    Choice,
    /// A list or a tuple of its parts.
    List,
    /// An element: the first part is a list, the second the index.
    Index,
    /// One divided by the only part; only in the [normal form](crate::normal).
    Over,
}

/// The syntax tree of an expression.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The operation of the root.
    pub op: Op,
    /// The operands, in the order of the text.
    pub parts: Vec<Tree>,
    /// The bytes of the expression in its text; empty if it was made, not read.
    pub at: Range<usize>,
}

impl Tree {
    /// Makes a tree that has no place in a text.
    pub fn new(op: Op, parts: Vec<Self>) -> Self {
        Self {
            op,
            parts,
            at: 0..0,
        }
    }

    /// Makes a call that has no place in a text.
    pub(crate) fn call(name: &str, parts: Vec<Self>) -> Self {
        Self::new(Op::Call(name.to_owned()), parts)
    }

    /// Makes a variable or a constant that has no place in a text.
    pub fn name_of(name: &str) -> Self {
        Self::new(Op::Name(name.to_owned()), Vec::new())
    }

    /// Makes a real number that has no place in a text.
    pub(crate) fn number(value: f64) -> Self {
        Self::new(Op::Number(value, false), Vec::new())
    }

    /// Returns the tree with another place in the text; that of its parts stays.
    pub fn at(self, at: Range<usize>) -> Self {
        Self { at, ..self }
    }

    /// Returns the name of a variable or a constant; `None` for other trees.
    pub fn name(&self) -> Option<&str> {
        match &self.op {
            Op::Name(name) => Some(name),
            _ => None,
        }
    }

    /// Returns the value of a number; `None` for other trees.
    pub(crate) fn value(&self) -> Option<f64> {
        match self.op {
            Op::Number(value, _) => Some(value),
            _ => None,
        }
    }

    /// Returns true if the root is a call by this name.
    pub fn is_call(&self, name: &str) -> bool {
        matches!(&self.op, Op::Call(it) if it == name)
    }

    /// Lists the tree and all trees inside of it, each before its parts.
    pub fn nodes(&self) -> Vec<&Self> {
        let parts = self.parts.iter().flat_map(Self::nodes);
        [self].into_iter().chain(parts).collect()
    }

    /// Returns the tree with other trees in the place of those for which `other` returns one. The
    /// parts of such a tree are not asked for.
    pub fn mapped(&self, other: &dyn Fn(&Self) -> Option<Self>) -> Self {
        other(self).unwrap_or_else(|| Self {
            op: self.op.clone(),
            parts: self.parts.iter().map(|it| it.mapped(other)).collect(),
            at: self.at.clone(),
        })
    }

    /// Returns true if two trees are equal but for their places in the text.
    pub fn is_same(&self, other: &Self) -> bool {
        let mut parts = self.parts.iter().zip(&other.parts);
        self.op == other.op
            && self.parts.len() == other.parts.len()
            && parts.all(|(one, other)| one.is_same(other))
    }
}
