//! The expressions that stand for themselves in a function, each with what it is there for.

use super::tree::{RustOp, RustTree};

/// What an expression is there for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum RootRole {
    /// It is given to a new name.
    Let(String),
    /// It is given to a field or to a name that there was.
    Set(String),
    Condition,
    /// It is a part of a condition.
    Part,
    Result,
    Each,
    Called,
}

/// Finds the expressions that stand for themselves, each with its role.
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

/// Splits a condition into the parts of which it is made, itself the first.
fn conjuncts(condition: &RustTree) -> Vec<&RustTree> {
    let mut all = vec![condition];
    if let Some("&&" | "||") = condition.op.sign() {
        all.extend(condition.parts.iter().flat_map(conjuncts));
    }
    all
}
