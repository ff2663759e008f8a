//! Term rewriting: the normal form, in which most expressions that mean the same differ in the
//! order of their parts at most.
//!
//! A difference is a sum with a product by −1, a quotient a product with [`Op::Reciprocal`], a
//! comparison a sum that is below zero. Casts are dropped, and an operation on all three components
//! becomes one on the vector.

mod arithmetic;
mod vocabulary;

use crate::tree::{Op, Tree};
use arithmetic::{flattened, of_components, over, product, scaled, sum, vector};
use vocabulary::{is_identity, is_infinity, rounds_down};

pub use vocabulary::canonical;
pub(crate) use vocabulary::{REAL, WHOLE, function, is_in};

/// The extent to which an expression is rewritten.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Rewriting {
    /// Only spelling, as [`simplified`] does.
    Plain,
    /// Also arithmetic and logic, as [`normal()`] does.
    Normal,
}

/// Rewrites an expression in normal form: most expressions that are equal in mathematics, as `(a -
/// b) / 2` and `-0.5 * (b - a)`, become the same tree but for the order of operands; a product of
/// two sums is not multiplied out. Each node that stays keeps its place in the text.
pub fn normal(tree: &Tree) -> Tree {
    rewritten(tree, Rewriting::Normal)
}

/// Rewrites an expression with one spelling for all languages: operators for functions like `add`,
/// fields for functions like `x()`, [`canonical`] names, no casts. The arithmetic stays as it is,
/// unlike in [`normal()`].
pub fn simplified(tree: &Tree) -> Tree {
    rewritten(tree, Rewriting::Plain)
}

impl Rewriting {
    /// Makes the node of an operator between rewritten parts.
    fn operator(self, sign: &'static str, parts: Vec<Tree>) -> Tree {
        if self == Self::Normal || matches!(sign, "//" | "|" | "=") {
            return of_operator(sign, parts);
        }
        let op = match sign {
            "neg" => Op::Negative,
            "!" => Op::Not,
            "?" => Op::Choice,
            "vec" => Op::Call(sign.to_owned()),
            _ => Op::Operator(sign),
        };
        Tree::new(op, parts)
    }
}

/// Rewrites an expression from its leaves to its root.
fn rewritten(tree: &Tree, rewriting: Rewriting) -> Tree {
    let parts = tree.parts.iter().map(|it| rewritten(it, rewriting));
    of_parts(&tree.op, parts.collect(), rewriting).placed_at(tree.at.clone())
}

/// Rewrites a node whose parts are rewritten.
fn of_parts(op: &Op, parts: Vec<Tree>, rewriting: Rewriting) -> Tree {
    match op {
        Op::Name(name) => of_name(name),
        Op::Negative => rewriting.operator("neg", parts),
        Op::Not => rewriting.operator("!", parts),
        Op::Choice => rewriting.operator("?", parts),
        Op::Operator(sign) => rewriting.operator(sign, parts),
        Op::Call(name) => of_call(name, parts, rewriting),
        Op::List if parts.len() == 3 => rewriting.operator("vec", parts),
        Op::Index => of_index(parts),
        _ => Tree::new(op.clone(), parts),
    }
}

/// The fields of a vector.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Makes `v[1]` and the book's `v.e[1]` the field `y` of `v`.
fn of_index(mut parts: Vec<Tree>) -> Tree {
    let Some(axis @ (0.0 | 1.0 | 2.0)) = parts[1].value() else {
        return Tree::new(Op::Index, parts);
    };
    let of = parts.swap_remove(0);
    let of = match (&of.op, &of.parts[..]) {
        (Op::Call(name), [of]) if name == "e" => of.clone(),
        (Op::Name(name), _) if name == "e" => Tree::name_of("self").placed_at(of.at),
        _ => of,
    };
    Tree::call(AXES[axis as usize], vec![of])
}

/// Rewrites a variable or a constant.
fn of_name(name: &str) -> Tree {
    let name = canonical(name);
    match &*name {
        it if is_infinity(it) => Tree::name_of("infinity"),
        "none" | "null" | "nullptr" | "nil" | "nullopt" => Tree::name_of("none"),
        "zero" => vector(0.0),
        "one" => vector(1.0),
        "raytmin" => Tree::name_of("tmin"),
        "raytmax" => Tree::name_of("tmax"),
        _ => Tree::name_of(&name),
    }
}

/// Makes the normal form of an operator between parts that are in it.
fn of_operator(sign: &'static str, mut parts: Vec<Tree>) -> Tree {
    match sign {
        "neg" => scaled(-1.0, parts.swap_remove(0)),
        "!" => negated(parts.swap_remove(0)),
        "?" => of_choice(parts),
        "vec" => of_components(parts),
        "+" => sum(parts),
        "-" => difference(parts),
        "*" => product(parts),
        "/" => {
            let divisor = over(parts.remove(1));
            product(vec![parts.remove(0), divisor])
        }
        "<" | "<=" => below_zero(sign, difference(parts)),
        ">" => below_zero("<", difference(parts.into_iter().rev().collect())),
        ">=" => below_zero("<=", difference(parts.into_iter().rev().collect())),
        "!=" => negated(Tree::new(Op::Operator("=="), parts)),
        "&&" | "||" => flat(sign, parts),
        "//" => match (parts[0].value(), parts[1].value()) {
            (Some(one), Some(other)) if other != 0.0 => Tree::number((one / other).floor()),
            _ => Tree::call("//", parts),
        },
        // In JavaScript `| 0` drops the digits behind the point.
        "|" if parts[1].value() == Some(0.0) => Tree::call("int", vec![parts.swap_remove(0)]),
        "=" => parts.swap_remove(1),
        _ => Tree::new(Op::Operator(sign), parts),
    }
}

/// Makes a sum of the first part and the negative of the second.
fn difference(mut parts: Vec<Tree>) -> Tree {
    let last = parts.pop().map(|it| scaled(-1.0, it));
    parts.extend(last);
    sum(parts)
}

/// Makes `sum < 0` or `sum <= 0`.
fn below_zero(less: &'static str, sum: Tree) -> Tree {
    Tree::new(Op::Operator(less), vec![sum])
}

/// Joins all sides of nested `&&` or `||` in one node.
fn flat(sign: &'static str, parts: Vec<Tree>) -> Tree {
    Tree::new(Op::Operator(sign), flattened(sign, parts).collect())
}

/// Makes the contrary of a condition.
fn negated(tree: Tree) -> Tree {
    let all = |parts: Vec<Tree>| parts.into_iter().map(negated).collect();
    match (&tree.op, &tree.parts[..]) {
        (Op::Not, [of]) => of.clone(),
        (Op::Operator("<"), [sum]) => below_zero("<=", scaled(-1.0, sum.clone())),
        (Op::Operator("<="), [sum]) => below_zero("<", scaled(-1.0, sum.clone())),
        (Op::Operator("&&"), _) => flat("||", all(tree.parts)),
        (Op::Operator("||"), _) => flat("&&", all(tree.parts)),
        _ => Tree::new(Op::Not, vec![tree]),
    }
}

/// Makes a choice whose condition is neither negated nor `<=`, by exchanging its branches.
fn of_choice(parts: Vec<Tree>) -> Tree {
    match &parts[..] {
        [condition, then, other] if matches!(condition.op, Op::Not | Op::Operator("<=")) => {
            let parts = vec![negated(condition.clone()), other.clone(), then.clone()];
            Tree::new(Op::Choice, parts)
        }
        _ => Tree::new(Op::Choice, parts),
    }
}

/// Rewrites a call.
fn of_call(name: &str, parts: Vec<Tree>, rewriting: Rewriting) -> Tree {
    let is_cast = is_in(REAL, name) && parts.len() == 1;
    let name = function(name, parts.len());
    match (&*name, &parts[..]) {
        (it, [of]) if is_cast || is_identity(it) => of.clone(),
        (it, [_]) if rounds_down(it) => Tree::call("int", parts),
        ("+", [_, to]) if !to.is_call("sphere") => rewriting.operator("+", parts),
        ("-", [_, _]) => rewriting.operator("-", parts),
        ("*", [_, _]) => rewriting.operator("*", parts),
        ("/", [_, _]) => rewriting.operator("/", parts),
        ("neg", [_]) => rewriting.operator("neg", parts),
        ("square" | "sqr" | "sq", [of]) => squared(of, rewriting),
        ("pow" | "powi" | "powf", [of, to]) if to.value() == Some(2.0) => squared(of, rewriting),
        ("pow" | "powi" | "powf", [of, to]) if to.value() == Some(0.5) => {
            Tree::call("sqrt", vec![of.clone()])
        }
        ("dot", [one, other]) if one.is_same(other) => {
            Tree::call("lengthsquared", vec![one.clone()])
        }
        ("vec", [_, _, _]) => rewriting.operator("vec", parts),
        ("vec" | "splat", [of]) => of.value().map_or_else(|| of.clone(), vector),
        ("zero", [] | [_]) => vector(0.0),
        ("one", [] | [_]) => vector(1.0),
        ("infinity", _) => of_name("infinity"),
        ("min", [of]) if is_interval(of) => of_name("tmin"),
        ("max", [of]) if is_interval(of) => of_name("tmax"),
        ("surrounds", [_, at]) => {
            let low = rewriting.operator("<", vec![of_name("tmin"), at.clone()]);
            let high = rewriting.operator("<", vec![at.clone(), of_name("tmax")]);
            rewriting.operator("&&", vec![low, high])
        }
        _ => Tree::call(&name, arguments(parts)),
    }
}

/// Makes the product of an expression with itself.
fn squared(of: &Tree, rewriting: Rewriting) -> Tree {
    rewriting.operator("*", vec![of.clone(); 2])
}

/// Writes the two ends of an interval for it, and drops the record that C++ has filled by the
/// function, which others return.
fn arguments(parts: Vec<Tree>) -> Vec<Tree> {
    let ends = |it: Tree| match it.is_call("interval") {
        true => it.parts,
        false => vec![it],
    };
    let mut parts: Vec<Tree> = parts.into_iter().flat_map(ends).collect();
    let is_record = |it: &Tree| {
        let name = it.name();
        name.is_some_and(|it| is_in("rec temprec record temp hitrecord", it))
    };
    if parts.len() > 2 && parts.last().is_some_and(is_record) {
        parts.pop();
    }
    parts
}

/// Returns true if a variable is named as the book names an interval of `t`.
fn is_interval(tree: &Tree) -> bool {
    matches!(tree.name(), Some("rayt" | "interval" | "range"))
}
