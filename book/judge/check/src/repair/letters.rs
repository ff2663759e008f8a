//! Alpha conversion: the chapter's function in the reader's letters.
//!
//! Names that mean the same are found by what they are given and where they are used. What has
//! a name in one of the two functions only is written out.

use std::collections::{HashMap, HashSet};

use super::functions::Function;
use super::tree::{Tree, likeness};

/// A name that a function gives to something.
#[derive(Clone, Copy)]
pub(super) struct Local<'a> {
    pub(super) name: &'a str,
    pub(super) value: &'a Tree,
    /// Whether it always stands for the value itself.
    is_fixed: bool,
}

/// The names that a function gives, in their order.
pub(super) fn locals(body: &Tree) -> Vec<Local<'_>> {
    let local = |node| -> Option<Local> {
        let tree: &Tree = node;
        let (name, _, is_fixed) = name_of(&tree.op)?;
        let value = tree.parts.first()?;
        Some(Local {
            name,
            value,
            is_fixed,
        })
    };
    body.nodes().into_iter().filter_map(local).collect()
}

/// The name that a node gives, where it stands there, and whether it never changes.
pub(super) fn name_of(op: &str) -> Option<(&str, usize, bool)> {
    let pattern = op
        .strip_prefix("let ")
        .or_else(|| op.strip_prefix("for "))?;
    let marked = pattern
        .strip_prefix("mut ")
        .or_else(|| pattern.strip_prefix("Some("));
    let rest = marked.unwrap_or(pattern);
    let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_')?;
    let is_fixed = marked.is_none() && op.starts_with("let ") && op.ends_with("= □;");
    (end > 0).then_some((&rest[..end], op.len() - rest.len(), is_fixed))
}

/// In which places of which nodes the name stands.
fn uses(body: &Tree, name: &str) -> Vec<String> {
    let nodes = body.nodes().into_iter();
    let places = nodes.flat_map(|node| {
        let parts = node.parts.iter().enumerate();
        parts
            .filter(|(_, it)| it.op == name)
            .map(|(n, _)| format!("{n} {}", node.op))
    });
    places.collect()
}

/// Names are the same thing if their values and uses have more than this in common; those that
/// are spelled alike always are.
const ALIKE: f64 = 0.6;
const SAME: f64 = 4.0;

/// The reader's body and the chapter's, both in the reader's letters.
pub(super) fn in_common_letters(yours: &Function, right: &Function) -> (Tree, Tree) {
    let mut letters = Letters::default();
    for (theirs, own) in right.parameters.iter().zip(&yours.parameters) {
        letters.insert(theirs, Tree::new(own, Vec::new()));
    }
    let (mut theirs, mut own) = (locals(&right.body), locals(&yours.body));
    while let Some((n, m)) = likest((&right.body, &theirs), (&yours.body, &own), &letters) {
        let (theirs, own) = (theirs.remove(n), own.remove(m));
        letters.insert(theirs.name, Tree::new(own.name, Vec::new()));
    }
    letters.write_out(&theirs);
    let mut own_letters = Letters::default();
    own_letters.write_out(&own);
    (own_letters.spell(&yours.body), letters.spell(&right.body))
}

/// The two names that are most alike, if any are.
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

    /// The tree in these letters.
    fn spell(&self, tree: &Tree) -> Tree {
        if tree.parts.is_empty()
            && let Some(other) = self.names.get(&tree.op)
        {
            return other.clone();
        }
        let is_written_out = |part: &&Tree| {
            name_of(&part.op).is_some_and(|(name, ..)| self.written_out.contains(name))
        };
        let parts = tree.parts.iter().filter(|part| !is_written_out(part));
        let parts = parts.map(|part| self.spell(part)).collect();
        let mut op = tree.op.clone();
        if let Some((name, at, _)) = name_of(&tree.op)
            && let Some(other) = self.names.get(name)
        {
            op.replace_range(at..at + name.len(), &other.op);
        }
        Tree {
            op,
            parts,
            ..tree.clone()
        }
    }
}
