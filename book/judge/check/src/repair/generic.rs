//! Mutation operators, backwards: edits that undo what is often mistyped, at each expression of
//! a function.

use super::edit::{Edit, Proposal, ranked, roots};
use super::functions::Function;
use super::letters::locals;
use super::tree::Tree;

/// Each is less likely than an edit that brings the chapter nearer.
const UNLIKELY: u32 = 5;
/// What a function is given is often in the wrong order.
const EXCHANGED: u32 = 3;
/// Signs and fields, each of which is mistaken for the others of its group.
const MISTAKEN: [&[&str]; 5] = [
    &["+", "-"],
    &["*", "/"],
    &["<", ">", "<=", ">="],
    &["&&", "||"],
    &["x", "y", "z"],
];
/// Of so many names in an expression each is swapped with each other.
const SWAPPED: usize = 8;

/// The edits of a function.
pub(super) fn edits(yours: &Function) -> Vec<Edit> {
    let mut names: Vec<String> = yours.parameters.clone();
    names.extend(locals(&yours.body).iter().map(|it| it.name.to_owned()));
    names.sort();
    names.dedup();
    let mut known = Known {
        names,
        proposals: Vec::new(),
    };
    known.walk(&yours.body, 0);
    for (_, root) in roots(&yours.body) {
        known.swapped(root);
    }
    ranked(yours, known.proposals)
}

/// What can take the place of something else.
struct Known {
    names: Vec<String>,
    proposals: Vec<Proposal>,
}

impl Known {
    fn walk(&mut self, node: &Tree, least: u8) {
        self.mistaken(node, least);
        self.negated(node, least);
        self.exchanged(node);
        for (n, part) in node.parts.iter().enumerate() {
            // A function is called by its name.
            if !(n == 0 && node.op.starts_with("□(")) {
                self.walk(part, node.least(n));
            }
        }
    }

    fn propose(&mut self, node: &Tree, new: String, penalty: u32) {
        let penalty = UNLIKELY + penalty;
        self.proposals
            .push(Proposal::new(node.at.clone(), new, penalty));
    }

    /// One sign or field for another of its group.
    fn mistaken(&mut self, node: &Tree, least: u8) {
        let Some(name) = node.sign().or(node.member()) else {
            return;
        };
        for group in MISTAKEN.iter().filter(|group| group.contains(&name)) {
            for other in group.iter().filter(|other| **other != name) {
                let op = node.op.replacen(name, other, 1);
                let new = Tree { op, ..node.clone() };
                self.propose(node, new.within(least), 2);
            }
        }
    }

    /// A sign that may have been forgotten.
    fn negated(&mut self, node: &Tree, least: u8) {
        let is_value = self.names.contains(&node.text()) || node.member().is_some();
        if is_value && node.op != "self" {
            let negated = Tree::new("-□", vec![node.clone()]);
            self.propose(node, negated.within(least), 3);
        }
    }

    /// Two names, wherever they stand in an expression, the one for the other.
    fn swapped(&mut self, root: &Tree) {
        let stands = |name: &&String| root.nodes().iter().any(|it| it.op == **name);
        let here = self.names.iter().filter(stands).take(SWAPPED);
        let here: Vec<String> = here.cloned().collect();
        for (n, one) in here.iter().enumerate() {
            for other in &here[..n] {
                self.propose(root, renamed(root, [one, other]).text(), 0);
            }
        }
    }

    /// Two values that a function is given, in the other order.
    fn exchanged(&mut self, node: &Tree) {
        let is_call = node.op.starts_with("□(");
        for n in (2..node.parts.len()).filter(|_| is_call) {
            let mut other = node.clone();
            other.parts.swap(n - 1, n);
            let at = node.at.clone();
            self.proposals
                .push(Proposal::new(at, other.text(), EXCHANGED));
        }
    }
}

/// The tree with two names exchanged.
fn renamed(tree: &Tree, [one, other]: [&str; 2]) -> Tree {
    let op = match &*tree.op {
        op if op == one => other,
        op if op == other => one,
        op => op,
    };
    let parts = tree.parts.iter().map(|it| renamed(it, [one, other]));
    Tree {
        op: op.to_owned(),
        parts: parts.collect(),
        ..tree.clone()
    }
}
