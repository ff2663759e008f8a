//! Blocks: statements one after the other, and the value at their end.

use super::declared::diverges;
use super::{Lowered, Lowerer};
use crate::node::{Node, Pattern};
use crate::read::at_statement;
use crate::refusal::At;
use crate::types::Type;

impl Lowerer<'_> {
    /// Lowers a block that is to come to a value of that type.
    pub(super) fn block_given(&mut self, block: &syn::Block, ty: &Type) -> Lowered {
        let outside = self.locals.len();
        let lowered = self.statements(block, ty);
        self.locals.truncate(outside);
        let (nodes, has_value) = lowered?;
        let is_left = nodes.iter().any(diverges);
        if !has_value && !is_left && !ty.is_unknown() && *ty != Type::UNIT {
            return self.no_value(block, ty);
        }
        Ok(Node::Block(nodes, has_value))
    }

    /// A block without a value where one is declared.
    fn no_value<T>(&self, block: &syn::Block, ty: &Type) -> Lowered<T> {
        let refusal = |at| self.names.mismatch(ty, &Type::UNIT, "`()`", at);
        Err(match block.stmts.last() {
            Some(syn::Stmt::Expr(last, Some(_))) => {
                let help = "remove this semicolon to return this value";
                refusal(self.at(last)).or_help(help)
            }
            _ => {
                let refusal = refusal(self.at_span(block.brace_token.span.close()));
                if !self.top.is_some_and(|top| std::ptr::eq(top, block)) {
                    return Err(refusal);
                }
                let help = format!("`{}` has no result so far", self.name);
                refusal.or_help(&help).unfinished()
            }
        })
    }

    /// The statements of a block, with a mark before all that may be left out when it runs.
    fn statements(&mut self, block: &syn::Block, ty: &Type) -> Lowered<(Vec<Node>, bool)> {
        let all = &block.stmts;
        let (mut nodes, mut marked) = (Vec::new(), Vec::new());
        let (mut has_value, mut leaves) = (false, None);
        for (n, statement) in all.iter().enumerate() {
            let is_last = n + 1 == all.len();
            if leaves != Some(self.leaves) && !matches!(statement, syn::Stmt::Item(_)) {
                marked.push((nodes.len(), n));
            }
            leaves = Some(self.leaves);
            match statement {
                syn::Stmt::Local(it) => nodes.push(self.declaration(it)?),
                syn::Stmt::Item(it) => {
                    let is_top = self.top.is_some_and(|top| std::ptr::eq(top, block));
                    if !is_top {
                        return self.unread(self.at_any(it), "declarations in an inner block");
                    }
                }
                syn::Stmt::Macro(it) => {
                    has_value = is_last && it.semi_token.is_none();
                    let node = self.macro_call(&it.mac)?;
                    nodes.push(if has_value {
                        self.as_value(node, ty, self.at_any(&it.mac.path))?
                    } else {
                        node
                    });
                }
                syn::Stmt::Expr(it, semicolon) => {
                    has_value = is_last && semicolon.is_none();
                    let is_block = matches!(
                        it,
                        syn::Expr::If(_) | syn::Expr::Match(_) | syn::Expr::Block(_)
                    );
                    nodes.push(match semicolon {
                        None if is_last => self.given(it, ty)?,
                        None if is_block => self.given(it, &Type::UNIT)?,
                        _ => self.expr(it)?,
                    });
                }
            }
        }
        self.add_marks(&mut nodes, &marked, all);
        Ok((nodes, has_value))
    }

    /// Puts a mark before each of these nodes, for the statements up to the next one.
    fn add_marks(&mut self, nodes: &mut Vec<Node>, marked: &[(usize, usize)], all: &[syn::Stmt]) {
        for (k, &(node, statement)) in marked.iter().enumerate() {
            let next = marked.get(k + 1).map_or(all.len(), |it| it.1);
            let at = At {
                end: at_statement(self.file, &all[next - 1]).end,
                ..at_statement(self.file, &all[statement])
            };
            let mark = self.mark(at);
            nodes.insert(node + k, mark);
        }
    }

    fn as_value(&self, node: Node, ty: &Type, at: At) -> Lowered {
        let node = self.as_declared(node, ty, at)?;
        Ok(self.checked(node, ty, at))
    }

    fn declaration(&mut self, it: &syn::Local) -> Lowered {
        let (pattern, written) = match &it.pat {
            syn::Pat::Type(it) => (&*it.pat, Some(self.names.ty(&self.context, &it.ty)?)),
            pattern => (pattern, None),
        };
        let Some(init) = &it.init else {
            // It gets its value later, once.
            self.pattern(pattern, true)?;
            return Ok(Node::Unit);
        };
        let node = match written {
            Some(ty) => self.given(&init.expr, &ty)?,
            None => self.expr(&init.expr)?,
        };
        let other = match &init.diverge {
            None => None,
            Some((_, other)) => {
                self.leaves += 1;
                Some(Box::new(self.given(other, &Type::NEVER)?))
            }
        };
        let pattern = if other.is_some() {
            self.pattern(pattern, false)?
        } else {
            self.irrefutable(pattern)?
        };
        Ok(match pattern {
            Pattern::Any if diverges(&node) => node,
            pattern => Node::Let(Box::new(pattern), Box::new(node), other),
        })
    }

    /// `if`, whose ways come to a value of that type.
    pub(super) fn condition(&mut self, it: &syn::ExprIf, ty: &Type) -> Lowered {
        let outside = self.locals.len();
        let condition = self.given(&it.cond, &Type::BOOL)?;
        let Some((_, other)) = &it.else_branch else {
            let then = self.block_given(&it.then_branch, &Type::UNIT);
            self.locals.truncate(outside);
            let help = "`return …;`, or an `else` that gives the other value";
            let then = then.map_err(|it| it.or_help(help))?;
            if !ty.is_unknown() && *ty != Type::UNIT {
                let at = self.at_span(it.if_token.span);
                return self.fault(at, "`if` may be missing an `else` clause", "", help);
            }
            return Ok(Node::If(Box::new([condition, then, Node::Unit])));
        };
        let then = self.block_given(&it.then_branch, ty)?;
        self.locals.truncate(outside);
        let other = self.given(other, ty)?;
        Ok(Node::If(Box::new([condition, then, other])))
    }
}
