//! The outermost expressions of a function, each with its purpose.

use super::tree::{RustOp, RustTree};

/// The purpose of an expression in a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum RootRole {
    /// The expression is the value of a new variable.
    Let(String),
    /// The expression is assigned to a field or to a variable that was declared before.
    Set(String),
    /// The expression is the condition of an `if` or a `while`.
    Condition,
    /// The expression is one side of `&&` or `||` in a condition.
    Part,
    /// The expression is the result of a block or a function.
    Result,
    /// The expression is the list of a loop.
    Each,
    /// The expression is a call whose result is dropped.
    Called,
}

/// Lists the expressions of a tree that are no operand of another one, each with its role, and the
/// sides of conditions.
pub(super) fn roots(tree: &RustTree) -> Vec<(RootRole, &RustTree)> {
    let mut roots = Vec::new();
    match (&tree.op, &tree.parts[..]) {
        (RustOp::Let(pattern, true), [value]) => {
            roots.push((RootRole::Let(pattern.name.clone()), value));
        }
        (RustOp::If | RustOp::While, [condition, ..]) => {
            roots.push((RootRole::Condition, condition));
            let parts = conjuncts(condition).into_iter().skip(1);
            roots.extend(parts.map(|it| (RootRole::Part, it)));
        }
        (RustOp::For(_), [each, _]) => roots.push((RootRole::Each, each)),
        (RustOp::Return, [value]) => roots.push((RootRole::Result, value)),
        (RustOp::Sign(sign), [name, value]) if sign == "=" => {
            let name = match &name.op {
                RustOp::Field(field) => field.clone(),
                _ => name.text(),
            };
            roots.push((RootRole::Set(name), value));
        }
        (RustOp::Member(name), [value]) => roots.push((RootRole::Set(name.clone()), value)),
        (RustOp::Statement, [call]) if matches!(call.op, RustOp::Call | RustOp::Method(_)) => {
            roots.push((RootRole::Called, call));
        }
        _ => {}
    }
    if tree.op == RustOp::Block
        && let Some(last) = tree.parts.last()
        && !matches!(
            last.op,
            RustOp::If | RustOp::For(_) | RustOp::Return | RustOp::Statement | RustOp::Let(..)
        )
    {
        roots.push((RootRole::Result, last));
    }
    roots.extend(tree.parts.iter().flat_map(|part| self::roots(part)));
    roots
}

/// Lists a condition and the sides of `&&` and `||` in it.
fn conjuncts(condition: &RustTree) -> Vec<&RustTree> {
    let mut all = vec![condition];
    if let Some("&&" | "||") = condition.op.sign() {
        all.extend(condition.parts.iter().flat_map(conjuncts));
    }
    all
}
