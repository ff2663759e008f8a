//! Expressions: operators, literals and what else is no call.

use std::sync::Arc;

use super::{Lowered, Lowerer};
use crate::names::Named;
use crate::node::Node;
use crate::operators::{Operator, operator};
use crate::refusal::At;
use crate::types::{Head, Int, Type};

impl Lowerer<'_> {
    pub(super) fn expr(&mut self, expr: &syn::Expr) -> Lowered {
        let at = || self.at(expr);
        match expr {
            syn::Expr::Lit(it) => self.literal(&it.lit),
            syn::Expr::Paren(it) => self.expr(&it.expr),
            syn::Expr::Group(it) => self.expr(&it.expr),
            syn::Expr::Path(it) => self.path(it),
            syn::Expr::Unary(it) => self.unary(it),
            syn::Expr::Binary(it) => self.binary(it),
            syn::Expr::Assign(it) => self.assignment(it),
            syn::Expr::Call(it) => self.call(it),
            syn::Expr::MethodCall(it) => self.method_call(it),
            syn::Expr::Field(it) => self.field(it),
            syn::Expr::Index(it) => self.index(it),
            syn::Expr::Block(it) if it.label.is_none() => {
                self.block_given(&it.block, &Type::UNKNOWN)
            }
            syn::Expr::If(it) => self.condition(it, &Type::UNKNOWN),
            syn::Expr::Let(it) => self.test(it),
            syn::Expr::Match(it) => self.matching(it, &Type::UNKNOWN),
            syn::Expr::While(it) => self.while_loop(it),
            syn::Expr::Loop(it) => self.endless_loop(it),
            syn::Expr::ForLoop(it) => self.for_loop(it),
            syn::Expr::Break(it) => self.leave_loop(it),
            syn::Expr::Continue(it) => self.next_turn(it),
            syn::Expr::Return(it) => self.returned(it),
            syn::Expr::Closure(it) => self.closure(it, false),
            syn::Expr::Tuple(it) if it.elems.is_empty() => Ok(Node::Unit),
            syn::Expr::Tuple(it) => {
                let all = it.elems.iter().map(|it| self.expr(it));
                Ok(Node::Tuple(all.collect::<Lowered<_>>()?))
            }
            syn::Expr::Array(it) => self.listed(&it.elems, &Type::UNKNOWN, true, at()),
            syn::Expr::Repeat(it) => {
                let nodes = [self.expr(&it.expr)?, self.expr(&it.len)?];
                Ok(Node::Repeat(Box::new(nodes), true, self.at(expr)))
            }
            syn::Expr::Range(it) => self.range(it),
            syn::Expr::Reference(it) => self.reference(it),
            syn::Expr::Cast(it) => {
                let from = self.expr(&it.expr)?;
                let to = self.names.ty(&self.context, &it.ty)?;
                Ok(Node::Cast(Box::new(from), Box::new(to), self.at_any(it)))
            }
            syn::Expr::Try(it) => self.tried(it),
            syn::Expr::Struct(it) => self.structure(it),
            syn::Expr::Macro(it) => self.macro_call(&it.mac),
            syn::Expr::Unsafe(_) => self.unread(at(), "`unsafe`"),
            _ => self.unread(at(), "this kind of expression"),
        }
    }

    /// `let … = …` as a condition.
    fn test(&mut self, it: &syn::ExprLet) -> Lowered {
        let value = self.expr(&it.expr)?;
        let pattern = self.pattern(&it.pat, false)?;
        Ok(Node::Matches(Box::new(pattern), Box::new(value)))
    }

    fn returned(&mut self, it: &syn::ExprReturn) -> Lowered {
        let result = self.result.clone();
        let value = match &it.expr {
            Some(value) => self.given(value, &result)?,
            None => {
                let at = self.at_span(it.return_token.span);
                self.as_declared(Node::Unit, &result, at)?
            }
        };
        self.leaves += 1;
        Ok(Node::Return(Box::new(value)))
    }

    fn reference(&mut self, it: &syn::ExprReference) -> Lowered {
        if it.mutability.is_none() {
            return Ok(Node::Lend(Box::new(self.expr(&it.expr)?)));
        }
        let Some(target) = self.place(&it.expr)? else {
            let what = "`&mut` of a value without a name";
            return self.unread(self.at(&it.expr), what);
        };
        Ok(Node::Address(Box::new(self.mutable(target))))
    }

    /// Values of one type.
    pub(super) fn listed<'s>(
        &mut self,
        all: impl IntoIterator<Item = &'s syn::Expr>,
        of: &Type,
        is_array: bool,
        at: At,
    ) -> Lowered {
        let all = all.into_iter().map(|it| self.given(it, of));
        Ok(Node::List(all.collect::<Lowered<_>>()?, is_array, at))
    }

    pub(super) fn literal(&mut self, literal: &syn::Lit) -> Lowered {
        let place = self.at_any(literal);
        Ok(match literal {
            syn::Lit::Bool(it) => Node::Bool(it.value),
            syn::Lit::Str(it) => Node::Str(Arc::from(it.value())),
            syn::Lit::Float(it) => {
                let digits = it.base10_digits();
                match self.suffix(it.suffix(), "float", place)? {
                    Some(Head::F32) => Node::Single(digits.parse().unwrap_or(f32::NAN)),
                    _ => Node::Float(digits.parse().unwrap_or(f64::NAN)),
                }
            }
            syn::Lit::Int(it) => {
                let Ok(value) = it.base10_digits().parse::<i128>() else {
                    return self.refused(place, "integer literal is too large");
                };
                match self.suffix(it.suffix(), "number", place)? {
                    Some(Head::F64) => Node::Float(value as f64),
                    Some(Head::F32) => Node::Single(value as f32),
                    Some(Head::Int(int)) => Node::Int(value, int),
                    _ => Node::Int(value, Int::Any),
                }
            }
            _ => return self.unread(place, "this kind of literal"),
        })
    }

    fn suffix(&self, suffix: &str, what: &str, at: At) -> Lowered<Option<Head>> {
        if suffix.is_empty() {
            return Ok(None);
        }
        match self.names.found(self.context.module, &[suffix.to_owned()]) {
            Ok(Named::Type(Type(head @ (Head::Int(_) | Head::F64 | Head::F32), _))) => {
                Ok(Some(head))
            }
            Ok(Named::Standard(_)) => self.unread(at, &format!("`{suffix}`")),
            _ => {
                let message = format!("invalid suffix `{suffix}` for {what} literal");
                let label = format!("invalid suffix `{suffix}`");
                let help = format!("a sign is missing before `{suffix}`, or a blank");
                self.fault(at, &message, &label, &help)
            }
        }
    }

    fn range(&mut self, it: &syn::ExprRange) -> Lowered {
        let at = self.at_any(it);
        let Some(from) = &it.start else {
            return self.unread(at, "ranges without a beginning");
        };
        let from = self.expr(from)?;
        let to = match &it.end {
            Some(to) => self.expr(to)?,
            None => Node::Unit,
        };
        let is_closed = matches!(it.limits, syn::RangeLimits::Closed(_));
        Ok(Node::Range(Box::new([from, to]), is_closed, at))
    }

    fn tried(&mut self, it: &syn::ExprTry) -> Lowered {
        let of = self.expr(&it.expr)?;
        let at = self.at_any(&it.question_token);
        if !self.result.is_unknown() && !self.result.is(Head::Option) {
            let message =
                "the `?` operator can only be used in a function that returns `Result` or `Option`";
            let label = format!("this one returns `{}`", self.result.name(self.names));
            return self.fault(at, message, &label, "");
        }
        self.leaves += 1;
        Ok(Node::Try(Box::new(of), at))
    }

    fn unary(&mut self, it: &syn::ExprUnary) -> Lowered {
        let of = self.expr(&it.expr)?;
        let at = self.at_any(it);
        match it.op {
            syn::UnOp::Deref(_) => Ok(Node::Deref(Box::new(of), at)),
            syn::UnOp::Not(_) => Ok(Node::Not(Box::new(of), at)),
            syn::UnOp::Neg(_) => Ok(match of {
                Node::Int(it, int) => Node::Int(-it, int),
                Node::Float(it) => Node::Float(-it),
                Node::Single(it) => Node::Single(-it),
                node => Node::Negate(Box::new(node), at),
            }),
            _ => self.unread(at, "this operator"),
        }
    }

    fn binary(&mut self, it: &syn::ExprBinary) -> Lowered {
        let (left, right) = (self.at(&it.left), self.at(&it.right));
        let at = At {
            end: right.end,
            ..left
        };
        match operator(&it.op) {
            Some(Operator::Arithmetic(sign, true)) => {
                let value = self.expr(&it.right)?;
                let Some(target) = self.place(&it.left)? else {
                    return self.refused(left, "invalid left-hand side of assignment");
                };
                let target = self.mutable(target);
                Ok(Node::Update(Box::new(target), sign, Box::new(value), at))
            }
            Some(Operator::Arithmetic(sign, false)) => {
                let nodes = [self.expr(&it.left)?, self.expr(&it.right)?];
                Ok(Node::Arithmetic(sign, Box::new(nodes), at))
            }
            Some(Operator::Compare(order)) => {
                let nodes = [self.expr(&it.left)?, self.expr(&it.right)?];
                Ok(Node::Compare(order, Box::new(nodes), at, right))
            }
            Some(operator) => {
                let one = self.given(&it.left, &Type::BOOL)?;
                let mut other = self.given(&it.right, &Type::BOOL)?;
                // Lines of its own may never run.
                let between = left.end as usize..right.start as usize;
                if self.text.get(between).is_some_and(|it| it.contains('\n')) {
                    other = self.marked(other, right);
                }
                let nodes = Box::new([one, other]);
                Ok(match operator {
                    Operator::And => Node::And(nodes),
                    _ => Node::Or(nodes),
                })
            }
            None => {
                let nodes = [self.expr(&it.left)?, self.expr(&it.right)?];
                let sign = self.at_any(&it.op);
                let sign = self.text.get(sign.start as usize..sign.end as usize);
                Ok(Node::Bits(
                    sign.unwrap_or_default().into(),
                    Box::new(nodes),
                    at,
                ))
            }
        }
    }
}
