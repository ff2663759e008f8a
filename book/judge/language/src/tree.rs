//! Abstract syntax trees of expressions, one kind for all languages.

use std::ops::Range;

/// The operation at the root of a [`Tree`], a name, a literal, a call or an operator, whose
/// operands are the [`parts`](Tree::parts) of the tree.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// A variable or a constant, by name. Without parts.
    Name(String),
    /// A number, and true if it is written as a whole one, without a point, an exponent or the
    /// suffix `f`. Without parts.
    Number(f64, bool),
    /// A string literal, with its quotes. Without parts.
    Text(String),
    /// A call of the function or constructor of this name with the parts as arguments, or of the
    /// method or field of this name of the first part.
    Call(String),
    /// A binary operator between two parts, spelled as in Rust if Rust has it; `//` is the division
    /// of whole numbers. In [`normal`](crate::normal()) form `+`, `*`, `&&` and `||` have two parts
    /// or more, and `<` and `<=` have one that is compared with 0.
    Operator(&'static str),
    /// The arithmetic negation of the only part.
    Negative,
    /// The logical negation of the only part.
    Not,
    /// A conditional expression, `c ? a : b`. The parts are the condition, the value if it holds,
    /// and the value if not.
    Choice,
    /// A list or a tuple, whose elements are the parts.
    List,
    /// An element of a list, `a[i]`. The parts are the list and the index.
    Index,
    /// 1 divided by the only part; only in [`normal`](crate::normal()) form.
    Reciprocal,
}

/// The syntax tree of an expression in any of the ten [languages](crate::Language).
#[derive(Clone, Debug)]
pub struct Tree {
    /// The operation at the root.
    pub op: Op,
    /// The operands of the operation, in the order and number that [`Op`] tells; for an operator or
    /// a call, in the order in which they are written.
    pub parts: Vec<Tree>,
    /// The range of bytes of the expression in the source text; `0..0` for a tree that no text has.
    pub at: Range<usize>,
}

impl Tree {
    /// Makes a tree from an operation and its operands, with `0..0` as its range of bytes.
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

    /// Makes the tree of a variable or a constant, with `0..0` as its range of bytes.
    pub fn name_of(name: &str) -> Self {
        Self::new(Op::Name(name.to_owned()), Vec::new())
    }

    /// Makes a real number that has no place in a text.
    pub(crate) fn number(value: f64) -> Self {
        Self::new(Op::Number(value, false), Vec::new())
    }

    /// Returns the tree with this range of bytes in the source text in place of its own; the ranges
    /// of its parts stay.
    pub fn placed_at(self, at: Range<usize>) -> Self {
        Self { at, ..self }
    }

    /// Returns the name if the tree is a variable or a constant, else `None`.
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

    /// Returns true if the root is an [`Op::Call`] of exactly this name, however many parts it has.
    pub fn is_call(&self, name: &str) -> bool {
        matches!(&self.op, Op::Call(it) if it == name)
    }

    /// Lists the tree itself and all trees inside of it, each before its parts.
    pub fn nodes(&self) -> Vec<&Self> {
        let parts = self.parts.iter().flat_map(Self::nodes);
        [self].into_iter().chain(parts).collect()
    }

    /// Returns a copy of the tree in which each subtree for which `other` returns a tree is
    /// replaced by that one. Subtrees of a replaced one are not visited.
    pub fn map_nodes(&self, other: &dyn Fn(&Self) -> Option<Self>) -> Self {
        other(self).unwrap_or_else(|| Self {
            op: self.op.clone(),
            parts: self.parts.iter().map(|it| it.map_nodes(other)).collect(),
            at: self.at.clone(),
        })
    }

    /// Returns true if two trees have equal operations and parts, wherever they stand in a text.
    pub fn is_same(&self, other: &Self) -> bool {
        let mut parts = self.parts.iter().zip(&other.parts);
        self.op == other.op
            && self.parts.len() == other.parts.len()
            && parts.all(|(one, other)| one.is_same(other))
    }
}
