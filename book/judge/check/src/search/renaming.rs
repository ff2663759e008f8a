//! Alpha conversion: rewrites the chapter's function in the names of the reader's.
//!
//! Variables are paired by the likeness of their values and uses. A variable that only one of the
//! two functions has is replaced by its value.

use std::collections::{HashMap, HashSet};

use super::functions::RustFn;
use super::tree::{RustOp, RustTree};
use crate::sources::likeness;

/// A variable that a function declares, with its first value.
#[derive(Clone, Copy)]
pub(super) struct LocalName<'a> {
    /// The name of the variable.
    pub(super) name: &'a str,
    /// The value in its declaration; of a loop's variable, the list.
    pub(super) value: &'a RustTree,
    /// True if a `let` without `mut` declares the variable, so that its value can be written in its
    /// place.
    is_fixed: bool,
}

/// Lists the variables that a function declares, in their order.
pub(super) fn locals(body: &RustTree) -> Vec<LocalName<'_>> {
    let local = |node| -> Option<LocalName> {
        let tree: &RustTree = node;
        let pattern = tree.op.pattern()?;
        Some(LocalName {
            name: &pattern.name,
            value: tree.parts.first()?,
            is_fixed: matches!(tree.op, RustOp::Let(_, true)) && pattern.is_whole(),
        })
    };
    body.nodes().into_iter().filter_map(local).collect()
}

/// Lists the uses of a variable: the number of the operand, from 0, and the operation.
fn uses(body: &RustTree, name: &str) -> Vec<(usize, RustOp)> {
    let nodes = body.nodes().into_iter();
    let places = nodes.flat_map(|node| {
        let parts = node.parts.iter().enumerate();
        let here = parts.filter(|(_, it)| it.name() == Some(name));
        here.map(|(n, _)| (n, node.op.clone()))
    });
    places.collect()
}

/// Two variables are the same if they score more, by the likeness of their values and of their
/// uses, from 0 to 1 each.
const ALIKE: f64 = 0.6;
/// The score of two variables of one name.
const SAME: f64 = 4.0;

/// Returns the bodies of a reader's function and of the chapter's with one set of names: those of
/// the reader. Variables that only one of them has are replaced by their values.
pub(super) fn in_common_names(yours: &RustFn, right: &RustFn) -> (RustTree, RustTree) {
    let mut renaming = Renaming::default();
    for (theirs, own) in right.parameters.iter().zip(&yours.parameters) {
        renaming.insert(theirs, RustTree::leaf(own));
    }
    let (mut theirs, mut own) = (locals(&right.body), locals(&yours.body));
    while let Some((n, m)) = likest((&right.body, &theirs), (&yours.body, &own), &renaming) {
        let (theirs, own) = (theirs.remove(n), own.remove(m));
        renaming.insert(theirs.name, RustTree::leaf(own.name));
    }
    renaming.write_out(&theirs);
    let mut own_renaming = Renaming::default();
    own_renaming.write_out(&own);
    (own_renaming.spell(&yours.body), renaming.spell(&right.body))
}

/// Finds the variable of the chapter and that of the reader that are most alike, by their indices;
/// `None` if no two are alike enough.
fn likest(
    (right, theirs): (&RustTree, &[LocalName]),
    (yours, own): (&RustTree, &[LocalName]),
    renaming: &Renaming,
) -> Option<(usize, usize)> {
    let mut best = (ALIKE, None);
    for (n, theirs) in theirs.iter().enumerate() {
        let value = renaming.spell(theirs.value);
        for (m, own) in own.iter().enumerate() {
            let kind = if value.op == own.value.op { 0.2 } else { -0.2 };
            let fixed = if theirs.is_fixed == own.is_fixed {
                0.0
            } else {
                -0.2
            };
            let uses = likeness(&uses(right, theirs.name), &uses(yours, own.name));
            let score = if theirs.name == own.name {
                SAME
            } else {
                value.likeness(own.value) + uses + kind + fixed
            };
            if score > best.0 {
                best = (score, Some((n, m)));
            }
        }
    }
    best.1
}

/// A substitution of trees for names.
#[derive(Default)]
struct Renaming {
    /// The names, each with the tree that replaces it.
    names: HashMap<String, RustTree>,
    /// The variables that are replaced by their values, whose declarations are dropped.
    written_out: HashSet<String>,
}

impl Renaming {
    /// Adds a name and the tree that replaces it.
    fn insert(&mut self, name: &str, other: RustTree) {
        self.names.insert(name.to_owned(), other);
    }

    /// Adds variables, each with its value, as far as a `let` without `mut` declares them.
    fn write_out(&mut self, locals: &[LocalName]) {
        for local in locals.iter().filter(|it| it.is_fixed) {
            self.insert(local.name, self.spell(local.value));
            self.written_out.insert(local.name.to_owned());
        }
    }

    /// Returns a tree with the substitution made.
    fn spell(&self, tree: &RustTree) -> RustTree {
        if let Some(other) = tree.name().and_then(|name| self.names.get(name)) {
            return other.clone();
        }
        let name = |it: &RustTree| it.op.pattern().map(|it| it.name.clone());
        let is_written_out =
            |part: &&RustTree| name(part).is_some_and(|name| self.written_out.contains(&name));
        let parts = tree.parts.iter().filter(|part| !is_written_out(part));
        let parts = parts.map(|part| self.spell(part)).collect();
        let mut op = tree.op.clone();
        if let RustOp::Let(pattern, _) | RustOp::For(pattern) = &mut op
            && let Some(other) = self.names.get(&pattern.name).and_then(RustTree::name)
        {
            other.clone_into(&mut pattern.name);
        }
        RustTree {
            op,
            parts,
            ..tree.clone()
        }
    }
}
