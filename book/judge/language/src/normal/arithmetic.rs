//! Linear algebra on trees: sums and products of numbers and vectors in their normal form.

use super::AXES;
use crate::tree::{Op, Tree};

/// Lists the parts of a sum or another operator, with those of its nested ones in their place.
pub(super) fn flattened(sign: &'static str, parts: Vec<Tree>) -> impl Iterator<Item = Tree> {
    parts.into_iter().flat_map(move |it| match it.op {
        Op::Operator(inner) if inner == sign => it.parts,
        _ => vec![it],
    })
}

/// Multiplies an expression by a number; of a sum or a vector, each part.
pub(super) fn scaled(factor: f64, tree: Tree) -> Tree {
    if factor == 1.0 {
        return tree;
    }
    let at = tree.at.clone();
    if tree.op == Op::Operator("+") || tree.is_call("vec") {
        let parts = tree.parts.into_iter().map(|it| scaled(factor, it));
        return Tree::new(tree.op, parts.collect()).placed_at(at);
    }
    let product = match tree.value() {
        Some(value) => Tree::number(factor * value),
        None => product(vec![Tree::number(factor), tree]),
    };
    product.placed_at(at)
}

/// Makes a sum: its numbers are added up and come last, unless they are 0. No terms make 0, and
/// one makes itself.
pub(super) fn sum(parts: Vec<Tree>) -> Tree {
    let (mut terms, mut number): (Vec<Tree>, Option<Tree>) = (Vec::new(), None);
    for term in flattened("+", parts) {
        match (term.value(), number.as_ref().and_then(Tree::value)) {
            (Some(value), Some(before)) => {
                number = Some(Tree::number(before + value).placed_at(term.at));
            }
            (Some(_), None) => number = Some(term),
            _ => terms.push(term),
        }
    }
    terms.extend(number.filter(|it| it.value() != Some(0.0)));
    match terms.len() {
        0 => Tree::number(0.0),
        1 => terms.swap_remove(0),
        _ => Tree::new(Op::Operator("+"), terms),
    }
}

/// Makes a product. Its numbers are multiplied; what they make goes into the only sum or vector
/// among the factors, or else comes first.
pub(super) fn product(parts: Vec<Tree>) -> Tree {
    let flat = flattened("*", parts);
    let (numbers, mut factors): (Vec<Tree>, Vec<Tree>) = flat.partition(|it| it.value().is_some());
    let number: f64 = numbers.iter().filter_map(Tree::value).product();
    if factors.is_empty() || number == 0.0 {
        return Tree::number(number);
    }
    let takes = |it: &Tree| it.op == Op::Operator("+") || it.is_call("vec");
    let mut sums = (0..factors.len()).filter(|n| takes(&factors[*n]));
    let only = sums.next().filter(|_| sums.next().is_none());
    match only {
        Some(n) => factors[n] = scaled(number, factors[n].clone()),
        None if number != 1.0 => factors.insert(0, Tree::number(number)),
        None => {}
    }
    match factors.len() {
        1 => factors.swap_remove(0),
        _ => Tree::new(Op::Operator("*"), factors),
    }
}

/// Makes one divided by an expression; of a product, by each factor.
pub(super) fn over(tree: Tree) -> Tree {
    match (&tree.op, &tree.parts[..]) {
        (Op::Number(value, _), _) => Tree::number(1.0 / value),
        (Op::Reciprocal, [of]) => of.clone(),
        (Op::Operator("*"), parts) => product(parts.iter().cloned().map(over).collect()),
        _ => Tree::new(Op::Reciprocal, vec![tree]),
    }
}

/// Makes the vector whose three components are this number.
pub(super) fn vector(value: f64) -> Tree {
    Tree::call("vec", vec![Tree::number(value); 3])
}

/// Makes a vector of three components. If these differ in x, y and z only, as `a.x + 1, a.y + 1,
/// a.z + 1` do, it is an expression of whole vectors.
pub(super) fn of_components(parts: Vec<Tree>) -> Tree {
    let whole = (0..3)
        .map(|n| without_axis(&parts[n], AXES[n]))
        .collect::<Option<Vec<_>>>();
    match whole {
        Some(whole) if whole[0].is_same(&whole[1]) && whole[1].is_same(&whole[2]) => {
            whole[0].clone()
        }
        _ => Tree::call("vec", parts),
    }
}

/// Finds the expression of whole vectors of which this one is the component of an axis, if each
/// of its parts says so.
fn without_axis(tree: &Tree, axis: &str) -> Option<Tree> {
    if tree.is_call(axis) && tree.parts.len() == 1 {
        return Some(tree.parts[0].clone());
    }
    let inside = |tree: &Tree| {
        tree.nodes()
            .iter()
            .any(|it| AXES.iter().any(|axis| it.is_call(axis)))
    };
    if !inside(tree) {
        return None;
    }
    let each = |it: &Tree| match (it.value(), without_axis(it, axis)) {
        (_, Some(whole)) => Some(whole),
        (Some(value), None) if tree.op == Op::Operator("+") => Some(vector(value)),
        _ if tree.op == Op::Operator("*") && !inside(it) => Some(it.clone()),
        _ => None,
    };
    let is_linear = matches!(tree.op, Op::Operator("+" | "*"));
    let parts = is_linear.then(|| tree.parts.iter().map(each).collect::<Option<Vec<_>>>())??;
    Some(Tree {
        parts,
        ..tree.clone()
    })
}
