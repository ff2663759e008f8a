//! Loops: what they go over, and how they are left.

use super::{Lowered, Lowerer, Typed};
use crate::node::{At, Node};
use crate::read::{Refusal, at_span};
use crate::types::{Head, Type};

impl Lowerer<'_> {
    pub(super) fn while_loop(&mut self, it: &syn::ExprWhile) -> Lowered {
        let outside = self.locals.len();
        let condition = self.given(&it.cond, &Head::Bool.into())?;
        let (body, _) = self.looped(&it.body, it.label.as_ref())?;
        self.locals.truncate(outside);
        let at = self.at_any(&it.while_token);
        let node = Node::While(Box::new([condition, body]), at);
        Ok(Typed::new(node, Type::UNIT))
    }

    pub(super) fn endless_loop(&mut self, it: &syn::ExprLoop) -> Lowered {
        let (body, is_left) = self.looped(&it.body, it.label.as_ref())?;
        let at = self.at_any(&it.loop_token);
        let node = Node::While(Box::new([Node::Bool(true), body]), at);
        let head = if is_left { Head::Unknown } else { Head::Never };
        Ok(Typed::new(node, head))
    }

    pub(super) fn for_loop(&mut self, it: &syn::ExprForLoop) -> Lowered {
        let each = self.expr(&it.expr)?;
        let (each, of) = self.iterated(each, &it.expr)?;
        let outside = self.locals.len();
        let pattern = self.pattern(&it.pat, &of, false)?;
        let (body, _) = self.looped(&it.body, it.label.as_ref())?;
        self.locals.truncate(outside);
        let at = self.at_any(&it.for_token);
        let node = Node::For(Box::new(pattern), Box::new([each, body]), at);
        Ok(Typed::new(node, Type::UNIT))
    }

    pub(super) fn leave_loop(&mut self, it: &syn::ExprBreak) -> Lowered {
        self.inside_a_loop(self.at_any(it), "break")?;
        let value = match &it.expr {
            Some(value) => self.expr(value)?.node,
            None => Node::Unit,
        };
        if let Some(is_left) = self.loops.last_mut() {
            *is_left = true;
        }
        Ok(Typed::new(Node::Break(Box::new(value)), Head::Never))
    }

    /// The body of a loop, and whether it ever leaves the loop.
    fn looped(&mut self, body: &syn::Block, label: Option<&syn::Label>) -> Lowered<(Node, bool)> {
        if let Some(label) = label {
            return Err(Refusal::unknown(self.at_any(label), "labels of loops"));
        }
        self.loops.push(false);
        let typed = self.block(body)?;
        let place = at_span(self.file, body.brace_token.span.close());
        let node = self.declared(typed, &Type::UNIT, place)?;
        Ok((node, self.loops.pop().unwrap_or_default()))
    }

    pub(super) fn inside_a_loop(&self, at: At, word: &str) -> Lowered<()> {
        if self.loops.is_empty() {
            return self.refused(at, format!("`{word}` outside of a loop"));
        }
        Ok(())
    }

    /// What a loop goes over, and the type of each.
    fn iterated(&mut self, each: Typed, at: &syn::Expr) -> Lowered<(Node, Type)> {
        let ty = &each.ty;
        let on = ty.stripped();
        match (ty.0, on.0) {
            (Head::RefMut, _) => Err(Refusal::unknown(
                self.at(at),
                "loops that change what they go over",
            )),
            (_, Head::Unknown | Head::Never) => Ok((each.node, Type::UNKNOWN)),
            (Head::Range, _) if !on.inner().is_float() => Ok((each.node, on.inner().settled())),
            (
                Head::Vec | Head::Array(_) | Head::Iterator | Head::Ref,
                Head::Vec | Head::Array(_) | Head::Slice | Head::Iterator,
            ) => {
                let of = on.inner().behind(ty);
                Ok((each.node, of))
            }
            _ => Err(self.names.no_iterator(ty, self.at(at))),
        }
    }
}
