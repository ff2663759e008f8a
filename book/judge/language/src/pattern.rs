//! Unification modulo commutativity: an expression found in another one, under other names.

use std::rc::Rc;

use crate::normal::normal;
use crate::tree::{Op, Tree};

/// An expression that is looked for.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// Its normal form.
    tree: Tree,
    /// The names that mean what they mean in the program that it comes from: another program may
    /// have other ones for them, but not one of these for another.
    known: Rc<[String]>,
}

/// Where an expression was found.
#[derive(Clone, Debug)]
pub struct Match<'t> {
    /// The part that it is.
    pub tree: &'t Tree,
    /// Names of the pattern, each with the one that stands for it there.
    pub names: Vec<(String, String)>,
}

/// So many leaves and calls may stand anywhere; fewer have to be all of a statement.
const SMALL: usize = 3;

impl Pattern {
    /// Makes a pattern of an expression; `known` are canonical names.
    pub fn new(tree: &Tree, known: Rc<[String]>) -> Self {
        Self {
            tree: normal(tree),
            known,
        }
    }

    /// Returns its normal form.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Returns true if the name means something in the program that it comes from.
    pub fn knows(&self, name: &str) -> bool {
        self.known.iter().any(|it| it == name)
    }

    /// Returns true if it says too little to be recognized within another expression.
    pub fn is_small(&self) -> bool {
        let nodes = self.tree.nodes();
        let counts = |it: &&&Tree| {
            matches!(
                it.op,
                Op::Name(_) | Op::Number(..) | Op::Call(_) | Op::Text(_)
            )
        };
        nodes.iter().filter(counts).count() < SMALL
    }

    /// Finds it in an expression in its normal form: the whole, or a part of it.
    pub fn find<'t>(&self, tree: &'t Tree) -> Option<Match<'t>> {
        let nodes = match self.is_small() {
            true => parts_of_a_condition(tree),
            false => tree.nodes(),
        };
        nodes.into_iter().find_map(|tree| self.matched(tree))
    }

    /// Matches it with a whole expression in its normal form.
    pub fn matched<'t>(&self, tree: &'t Tree) -> Option<Match<'t>> {
        let mut names = Vec::new();
        if !self.unify(&self.tree, tree, &mut names) {
            return None;
        }
        let is_other = |(one, other): &&(String, String)| one != other;
        let others = names.iter().filter(is_other).count();
        let nodes = self.tree.nodes();
        let is_said = |it: &&&Tree| matches!(it.op, Op::Number(..) | Op::Call(_) | Op::Text(_));
        let said = nodes.iter().filter(is_said).count() + names.len() - others;
        // Else any sum looks like any other.
        (others <= said).then_some(Match { tree, names })
    }

    fn unify(&self, one: &Tree, other: &Tree, names: &mut Vec<(String, String)>) -> bool {
        match (&one.op, &other.op) {
            (Op::Name(name), Op::Name(own)) => return self.rename(name, own, names),
            (Op::Number(value, _), Op::Number(own, _)) => return is_near(*value, *own),
            (a, b) if a != b || one.parts.len() != other.parts.len() => return false,
            _ => {}
        }
        let is_unordered = match &one.op {
            Op::Sign(sign) => matches!(*sign, "+" | "*" | "&&" | "||" | "=="),
            Op::Call(name) => name == "dot",
            _ => false,
        };
        if is_unordered {
            return self.unify_in_any_order(
                &one.parts,
                &other.parts.iter().collect::<Vec<_>>(),
                names,
            );
        }
        let mut pairs = one.parts.iter().zip(&other.parts);
        pairs.all(|(one, other)| self.unify(one, other, names))
    }

    fn unify_in_any_order(
        &self,
        parts: &[Tree],
        others: &[&Tree],
        names: &mut Vec<(String, String)>,
    ) -> bool {
        let Some((first, rest)) = parts.split_first() else {
            return true;
        };
        (0..others.len()).any(|n| {
            let mut tried = names.clone();
            let mut left = others.to_vec();
            let other = left.remove(n);
            let fits = self.unify(first, other, &mut tried)
                && self.unify_in_any_order(rest, &left, &mut tried);
            if fits {
                *names = tried;
            }
            fits
        })
    }

    /// Takes one name for another, if that is consistent.
    fn rename(&self, name: &str, own: &str, names: &mut Vec<(String, String)>) -> bool {
        if let Some((one, other)) = names
            .iter()
            .find(|(one, other)| one == name || other == own)
        {
            return one == name && other == own;
        }
        let is_fixed = |it: &str| matches!(it, "infinity" | "none" | "true" | "false");
        let may = name == own || !self.knows(own) && !is_fixed(name) && !is_fixed(own);
        if may {
            names.push((name.to_owned(), own.to_owned()));
        }
        may
    }
}

/// Numbers are the same whichever of two spellings divides.
fn is_near(one: f64, other: f64) -> bool {
    one == other || (one - other).abs() <= 4.0 * f64::EPSILON * one.abs()
}

/// Lists the whole, and the parts of which it is made as a condition.
fn parts_of_a_condition(tree: &Tree) -> Vec<&Tree> {
    let mut all = vec![tree];
    if matches!(tree.op, Op::Sign("&&" | "||") | Op::Not | Op::Choice) {
        all.extend(tree.parts.iter().flat_map(parts_of_a_condition));
    }
    all
}
