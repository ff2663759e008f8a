//! Unification modulo commutativity: finds an expression inside of another, under other names.

use std::rc::Rc;

use crate::normal::normal;
use crate::tree::{Op, Tree};

/// An expression that can be found inside of other expressions, whatever the order of commutative
/// operands and the names of variables there.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// The normal form of the expression.
    tree: Tree,
    /// The names of the program that the expression is from. A variable may have a new name in
    /// another program, but not one of these, which mean other things.
    known: Rc<[String]>,
}

/// An occurrence of a [`Pattern`] in an expression.
#[derive(Clone, Debug)]
pub struct Match<'t> {
    /// The part of the searched expression that equals the pattern.
    pub tree: &'t Tree,
    /// The variables of the pattern, each once, with the names that they have in the searched
    /// expression; empty if the pattern has none.
    pub renames: Vec<Rename>,
}

/// The names that one variable has in two programs, that of a [`Pattern`] and the one that was
/// searched. Both are [`canonical`](crate::canonical).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rename {
    /// The name in the program of the [`Pattern`].
    pub from: String,
    /// The name in the program that was searched; often equal to `from`.
    pub to: String,
}

/// A pattern of fewer leaves and calls is found only as a whole statement or condition.
const SMALL: usize = 3;

impl Pattern {
    /// Makes the pattern that finds an expression. `known` are the [`canonical`](crate::canonical)
    /// names of the whole program that the expression is from: no variable may be renamed to one of
    /// these.
    pub fn new(tree: &Tree, known: Rc<[String]>) -> Self {
        Self {
            tree: normal(tree),
            known,
        }
    }

    /// Returns the expression of the pattern in [`normal()`] form.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Returns true if a [`canonical`](crate::canonical) name is among the `known` ones of
    /// [`new`](Self::new), those of the program that the pattern is from.
    pub fn knows(&self, name: &str) -> bool {
        self.known.iter().any(|it| it == name)
    }

    /// Returns true if the pattern has fewer than three names, numbers, strings and calls: too few
    /// to be recognized inside of a larger expression.
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

    /// Searches an expression in [`normal()`] form for the pattern, and returns its first
    /// occurrence, the whole before its parts; `None` if there is none. A [small](Self::is_small)
    /// pattern is compared only with the whole, and with the operands of `&&`, `||`, `!` and
    /// choices in it.
    pub fn find<'t>(&self, tree: &'t Tree) -> Option<Match<'t>> {
        let nodes = match self.is_small() {
            true => parts_of_a_condition(tree),
            false => tree.nodes(),
        };
        nodes.into_iter().find_map(|tree| self.match_whole(tree))
    }

    /// Matches the pattern with a whole expression in normal form. There is no match if more names
    /// differ than other things agree, since then any sum would match any other.
    fn match_whole<'t>(&self, tree: &'t Tree) -> Option<Match<'t>> {
        let mut renames = Vec::new();
        if !self.unify(&self.tree, tree, &mut renames) {
            return None;
        }
        let others = renames.iter().filter(|it| it.from != it.to).count();
        let nodes = self.tree.nodes();
        let is_said = |it: &&&Tree| matches!(it.op, Op::Number(..) | Op::Call(_) | Op::Text(_));
        let said = nodes.iter().filter(is_said).count() + renames.len() - others;
        (others <= said).then_some(Match { tree, renames })
    }

    /// Compares two trees and adds the renames that make them equal.
    fn unify(&self, one: &Tree, other: &Tree, renames: &mut Vec<Rename>) -> bool {
        match (&one.op, &other.op) {
            (Op::Name(name), Op::Name(own)) => return self.rename(name, own, renames),
            (Op::Number(value, _), Op::Number(own, _)) => return is_near(*value, *own),
            (a, b) if a != b || one.parts.len() != other.parts.len() => return false,
            _ => {}
        }
        let is_unordered = match &one.op {
            Op::Operator(sign) => matches!(*sign, "+" | "*" | "&&" | "||" | "=="),
            Op::Call(name) => name == "dot",
            _ => false,
        };
        if is_unordered {
            return self.unify_in_any_order(
                &one.parts,
                &other.parts.iter().collect::<Vec<_>>(),
                renames,
            );
        }
        let mut pairs = one.parts.iter().zip(&other.parts);
        pairs.all(|(one, other)| self.unify(one, other, renames))
    }

    /// Compares the operands of a commutative operator, trying each order.
    fn unify_in_any_order(
        &self,
        parts: &[Tree],
        others: &[&Tree],
        renames: &mut Vec<Rename>,
    ) -> bool {
        let Some((first, rest)) = parts.split_first() else {
            return true;
        };
        (0..others.len()).any(|n| {
            let mut tried = renames.clone();
            let mut left = others.to_vec();
            let other = left.remove(n);
            let fits = self.unify(first, other, &mut tried)
                && self.unify_in_any_order(rest, &left, &mut tried);
            if fits {
                *renames = tried;
            }
            fits
        })
    }

    /// Adds a rename, if no other one contradicts it.
    fn rename(&self, name: &str, own: &str, renames: &mut Vec<Rename>) -> bool {
        if let Some(it) = renames.iter().find(|it| it.from == name || it.to == own) {
            return it.from == name && it.to == own;
        }
        let is_fixed = |it: &str| matches!(it, "infinity" | "none" | "true" | "false");
        let may = name == own || !self.knows(own) && !is_fixed(name) && !is_fixed(own);
        if may {
            renames.push(Rename {
                from: name.to_owned(),
                to: own.to_owned(),
            });
        }
        may
    }
}

/// Returns true if two numbers are equal but for a few ulps, as `/ 2` and `* 0.5` may make them.
fn is_near(one: f64, other: f64) -> bool {
    one == other || (one - other).abs() <= 4.0 * f64::EPSILON * one.abs()
}

/// Lists an expression, and the conditions and branches of which it is made.
fn parts_of_a_condition(tree: &Tree) -> Vec<&Tree> {
    let mut all = vec![tree];
    if matches!(tree.op, Op::Operator("&&" | "||") | Op::Not | Op::Choice) {
        all.extend(tree.parts.iter().flat_map(parts_of_a_condition));
    }
    all
}
