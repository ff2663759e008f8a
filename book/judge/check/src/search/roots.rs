//! The expressions that stand for themselves in a function, each with what it is there for.

use super::tree::{Op, Tree};

/// What an expression is there for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Role {
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
pub(super) fn roots(tree: &Tree) -> Vec<(Role, &Tree)> {
    let mut roots = Vec::new();
    match (&tree.op, &tree.parts[..]) {
        (Op::Let(pattern, true), [value]) => {
            roots.push((Role::Let(pattern.name.clone()), value));
        }
        (Op::If | Op::While, [condition, ..]) => {
            roots.push((Role::Condition, condition));
            let parts = conjuncts(condition).into_iter().skip(1);
            roots.extend(parts.map(|it| (Role::Part, it)));
        }
        (Op::For(_), [each, _]) => roots.push((Role::Each, each)),
        (Op::Return, [value]) => roots.push((Role::Result, value)),
        (Op::Sign(sign), [name, value]) if sign == "=" => {
            let name = match &name.op {
                Op::Field(field) => field.clone(),
                _ => name.text(),
            };
            roots.push((Role::Set(name), value));
        }
        (Op::Member(name), [value]) => roots.push((Role::Set(name.clone()), value)),
        (Op::Statement, [call]) if matches!(call.op, Op::Call | Op::Method(_)) => {
            roots.push((Role::Called, call));
        }
        _ => {}
    }
    if tree.op == Op::Block
        && let Some(last) = tree.parts.last()
        && !matches!(
            last.op,
            Op::If | Op::For(_) | Op::Return | Op::Statement | Op::Let(..)
        )
    {
        roots.push((Role::Result, last));
    }
    roots.extend(tree.parts.iter().flat_map(|part| self::roots(part)));
    roots
}

/// Splits a condition into the parts of which it is made, itself the first.
fn conjuncts(condition: &Tree) -> Vec<&Tree> {
    let mut all = vec![condition];
    if let Some("&&" | "||") = condition.op.sign() {
        all.extend(condition.parts.iter().flat_map(conjuncts));
    }
    all
}
