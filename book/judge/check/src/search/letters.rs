//! Alpha conversion: the chapter's function in the reader's letters.
//!
//! Names that mean the same are found by what they are given and where they are used. What has
//! a name in one of the two functions only is written out.

use std::collections::{HashMap, HashSet};

use super::functions::Function;
use super::tree::{Op, Tree, likeness};

/// A name that a function gives to something.
#[derive(Clone, Copy)]
pub(super) struct Local<'a> {
    pub(super) name: &'a str,
    pub(super) value: &'a Tree,
    /// True if it always stands for the value itself.
    is_fixed: bool,
}

/// Lists the names that a function gives, in their order.
pub(super) fn locals(body: &Tree) -> Vec<Local<'_>> {
    let local = |node| -> Option<Local> {
        let tree: &Tree = node;
        let pattern = tree.op.pattern()?;
        Some(Local {
            name: &pattern.name,
            value: tree.parts.first()?,
            is_fixed: matches!(tree.op, Op::Let(_, true)) && pattern.is_whole(),
        })
    };
    body.nodes().into_iter().filter_map(local).collect()
}

/// In which places of which nodes the name stands.
fn uses(body: &Tree, name: &str) -> Vec<(usize, Op)> {
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
pub(super) fn in_common_letters(yours: &Function, right: &Function) -> (Tree, Tree) {
    let mut letters = Letters::default();
    for (theirs, own) in right.parameters.iter().zip(&yours.parameters) {
        letters.insert(theirs, Tree::leaf(own));
    }
    let (mut theirs, mut own) = (locals(&right.body), locals(&yours.body));
    while let Some((n, m)) = likest((&right.body, &theirs), (&yours.body, &own), &letters) {
        let (theirs, own) = (theirs.remove(n), own.remove(m));
        letters.insert(theirs.name, Tree::leaf(own.name));
    }
    letters.write_out(&theirs);
    let mut own_letters = Letters::default();
    own_letters.write_out(&own);
    (own_letters.spell(&yours.body), letters.spell(&right.body))
}

/// Finds the two names that are most alike, if any are.
fn likest(
    (right, theirs): (&Tree, &[Local]),
    (yours, own): (&Tree, &[Local]),
    letters: &Letters,
) -> Option<(usize, usize)> {
    let mut best = (ALIKE, None);
    for (n, theirs) in theirs.iter().enumerate() {
        let value = letters.spell(theirs.value);
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
struct Letters {
    names: HashMap<String, Tree>,
    /// Those whose values stand for them, so that they need not be given.
    written_out: HashSet<String>,
}

impl Letters {
    fn insert(&mut self, name: &str, other: Tree) {
        self.names.insert(name.to_owned(), other);
    }

    fn write_out(&mut self, locals: &[Local]) {
        for local in locals.iter().filter(|it| it.is_fixed) {
            self.insert(local.name, self.spell(local.value));
            self.written_out.insert(local.name.to_owned());
        }
    }

    /// Spells a tree in these letters.
    fn spell(&self, tree: &Tree) -> Tree {
        if let Some(other) = tree.name().and_then(|name| self.names.get(name)) {
            return other.clone();
        }
        let name = |it: &Tree| it.op.pattern().map(|it| it.name.clone());
        let is_written_out =
            |part: &&Tree| name(part).is_some_and(|name| self.written_out.contains(&name));
        let parts = tree.parts.iter().filter(|part| !is_written_out(part));
        let parts = parts.map(|part| self.spell(part)).collect();
        let mut op = tree.op.clone();
        if let Op::Let(pattern, _) | Op::For(pattern) = &mut op
            && let Some(other) = self.names.get(&pattern.name).and_then(Tree::name)
        {
            other.clone_into(&mut pattern.name);
        }
        Tree {
            op,
            parts,
            ..tree.clone()
        }
    }
}
