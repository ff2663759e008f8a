//! Alpha conversion: the chapter's function in the reader's letters.
//!
//! Names that mean the same are found by what they are given and where they are used. What has
//! a name in one of the two functions only is written out.

use std::collections::{HashMap, HashSet};

use super::functions::ParsedFunction;
use super::tree::{RustOp, RustTree};
use crate::sources::likeness;

/// A name that a function gives to something.
#[derive(Clone, Copy)]
pub(super) struct LocalName<'a> {
    pub(super) name: &'a str,
    pub(super) value: &'a RustTree,
    /// True if it always stands for the value itself.
    is_fixed: bool,
}

/// Lists the names that a function gives, in their order.
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

/// In which places of which nodes the name stands.
fn uses(body: &RustTree, name: &str) -> Vec<(usize, RustOp)> {
    let nodes = body.nodes().into_iter();
    let places = nodes.flat_map(|node| {
        let parts = node.parts.iter().enumerate();
        let here = parts.filter(|(_, it)| it.name() == Some(name));
        here.map(|(n, _)| (n, node.op.clone()))
    });
    places.collect()
}

/// Names are the same thing if their values and uses have more than this in common; those that
/// are spelled alike always are.
const ALIKE: f64 = 0.6;
const SAME: f64 = 4.0;

/// Spells the reader's body and the chapter's, both in the reader's letters.
pub(super) fn in_common_names(
    yours: &ParsedFunction,
    right: &ParsedFunction,
) -> (RustTree, RustTree) {
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

/// Finds the two names that are most alike, if any are.
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

/// Names, and what stands for each.
#[derive(Default)]
struct Renaming {
    names: HashMap<String, RustTree>,
    /// Those whose values stand for them, so that they need not be given.
    written_out: HashSet<String>,
}

impl Renaming {
    fn insert(&mut self, name: &str, other: RustTree) {
        self.names.insert(name.to_owned(), other);
    }

    fn write_out(&mut self, locals: &[LocalName]) {
        for local in locals.iter().filter(|it| it.is_fixed) {
            self.insert(local.name, self.spell(local.value));
            self.written_out.insert(local.name.to_owned());
        }
    }

    /// Spells a tree in these letters.
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
