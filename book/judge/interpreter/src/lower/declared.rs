//! Expected types: what is declared reaches down to where a value is made, as the compiler's
//! places have it.

use super::{Lowered, Lowerer};
use crate::names::names;
use crate::node::Node;
use crate::refusal::At;
use crate::types::{Head, Int, Type};

impl Lowerer<'_> {
    /// Lowers an expression whose value is to have that type.
    pub(super) fn given(&mut self, value: &syn::Expr, ty: &Type) -> Lowered {
        match value {
            syn::Expr::Paren(it) => self.given(&it.expr, ty),
            syn::Expr::Group(it) => self.given(&it.expr, ty),
            syn::Expr::If(it) => self.condition(it, ty),
            syn::Expr::Match(it) => self.matching(it, ty),
            syn::Expr::Block(it) if it.label.is_none() => self.block_given(&it.block, ty),
            value => {
                let node = self.argument(value, ty)?;
                Ok(self.checked(node, ty, self.at(value)))
            }
        }
    }

    /// The same of an argument, which is checked where it arrives.
    pub(super) fn argument(&mut self, value: &syn::Expr, ty: &Type) -> Lowered {
        let node = match value {
            syn::Expr::If(_) | syn::Expr::Match(_) | syn::Expr::Block(_) => {
                return self.given(value, ty);
            }
            syn::Expr::Paren(it) => return self.argument(&it.expr, ty),
            syn::Expr::Closure(it) => self.closure(it, true)?,
            syn::Expr::Call(it) if is_default(it) && !ty.is_unknown() => {
                let at = self.at(value);
                self.default_of(ty, at)?
            }
            syn::Expr::Call(it) if ty.is(Head::Option) && is_some(it) => {
                let of = self.given(&it.args[0], ty.inner())?;
                Node::Some(Box::new(of))
            }
            syn::Expr::Tuple(it) if ty.is(Head::Tuple) && it.elems.len() == ty.1.len() => {
                let all = it.elems.iter().zip(&ty.1);
                let all = all.map(|(it, ty)| self.given(it, ty));
                match all.collect::<Lowered<Vec<_>>>()? {
                    all if all.is_empty() => Node::Unit,
                    all => Node::Tuple(all),
                }
            }
            syn::Expr::Array(it) if matches!(ty.0, Head::Array(_)) => {
                self.listed(&it.elems, ty.inner(), true, self.at(value))?
            }
            value => self.expr(value)?,
        };
        self.as_declared(node, ty, self.at(value))
    }

    /// A number as the type that it is to have; refuses what shows another type.
    pub(super) fn as_declared(&self, node: Node, ty: &Type, at: At) -> Lowered {
        match (&node, ty.0) {
            (Node::Int(it, Int::Any), Head::Int(int)) if int.has(*it) => {
                return Ok(Node::Int(*it, int));
            }
            (Node::Int(_, Int::Any), Head::Int(int)) => {
                let message = format!("literal out of range for `{}`", int.name());
                return self.refused(at, message);
            }
            (Node::Float(it), Head::F32) => return Ok(Node::Single(*it as f32)),
            _ => {}
        }
        let Some(shown) = literal(&node) else {
            return Ok(node);
        };
        let is_it = match (shown.0, ty.0) {
            (_, Head::Unknown) => true,
            (Head::Int(one), Head::Int(other)) => one.joined(other).is_some(),
            (one, other) => one == other,
        };
        if is_it {
            return Ok(node);
        }
        let said = match node {
            Node::Float(_) => "floating-point number".to_owned(),
            _ => shown.said(self.names),
        };
        Err(self.names.mismatch(ty, &shown, &said, at))
    }

    /// A value that is checked when it runs, unless it shows what it is.
    pub(super) fn checked(&self, node: Node, ty: &Type, at: At) -> Node {
        let is_certain = matches!(
            node,
            Node::Float(_)
                | Node::Bool(_)
                | Node::None
                | Node::Compare(..)
                | Node::And(..)
                | Node::Or(..)
                | Node::Not(..)
                | Node::Matches(..)
        );
        if is_certain || ty.is_unknown() || diverges(&node) {
            return node;
        }
        Node::Declared(Box::new(node), Box::new(ty.clone()), at)
    }
}

/// The type of what is written there as it is.
fn literal(node: &Node) -> Option<Type> {
    Some(match node {
        Node::Unit => Type::UNIT,
        Node::Bool(_) => Type::BOOL,
        Node::Int(_, int) => Head::Int(*int).into(),
        Node::Float(_) => Head::F64.into(),
        Node::Single(_) => Head::F32.into(),
        Node::Str(_) => Type::of(Head::Ref, Head::Str.into()),
        Node::None => Type::of(Head::Option, Type::UNKNOWN),
        Node::Some(of) => Type::of(Head::Option, literal(of).unwrap_or_default()),
        _ => return None,
    })
}

/// Whether nothing comes after it.
pub(super) fn diverges(node: &Node) -> bool {
    match node {
        Node::Break(_) | Node::Continue | Node::Return(_) | Node::Panic(..) => true,
        Node::If(nodes) => diverges(&nodes[1]) && diverges(&nodes[2]),
        Node::Match(_, arms, _) => !arms.is_empty() && arms.iter().all(|it| diverges(&it.body)),
        Node::Block(nodes, _) => nodes.iter().any(diverges),
        Node::Declared(of, ..) => diverges(of),
        _ => false,
    }
}

/// `Default::default()`, whose type is that of its place.
fn is_default(it: &syn::ExprCall) -> bool {
    matches!(&*it.func, syn::Expr::Path(it) if names(&it.path) == ["Default", "default"])
}

fn is_some(it: &syn::ExprCall) -> bool {
    matches!(&*it.func, syn::Expr::Path(path) if path.path.is_ident("Some")) && it.args.len() == 1
}
