//! Loops: what they go over, and how they are left.

use super::{Lowered, Lowerer};
use crate::node::Node;
use crate::refusal::At;
use crate::types::Type;

impl Lowerer<'_> {
    pub(super) fn while_loop(&mut self, it: &syn::ExprWhile) -> Lowered {
        let outside = self.locals.len();
        let condition = self.given(&it.cond, &Type::BOOL)?;
        let (body, _) = self.looped(&it.body, it.label.as_ref())?;
        self.locals.truncate(outside);
        let at = self.at_any(&it.while_token);
        Ok(Node::While(Box::new([condition, body]), at))
    }

    pub(super) fn endless_loop(&mut self, it: &syn::ExprLoop) -> Lowered {
        let (body, is_left) = self.looped(&it.body, it.label.as_ref())?;
        let at = self.at_any(&it.loop_token);
        let node = Node::While(Box::new([Node::Bool(true), body]), at);
        if is_left {
            return Ok(node);
        }
        // Nothing comes after it.
        let end = Node::Panic(String::new(), at);
        Ok(Node::Block(vec![node, end], true))
    }

    pub(super) fn for_loop(&mut self, it: &syn::ExprForLoop) -> Lowered {
        let each = self.expr(&it.expr)?;
        let at = self.at(&it.expr);
        let outside = self.locals.len();
        let pattern = self.irrefutable(&it.pat)?;
        let (body, _) = self.looped(&it.body, it.label.as_ref())?;
        self.locals.truncate(outside);
        Ok(Node::For(Box::new(pattern), Box::new([each, body]), at))
    }

    pub(super) fn leave_loop(&mut self, it: &syn::ExprBreak) -> Lowered {
        self.inside_a_loop(self.at_any(it), "break")?;
        if it.label.is_some() {
            return self.unread(self.at_any(it), "labels of loops");
        }
        let value = match &it.expr {
            Some(value) => self.expr(value)?,
            None => Node::Unit,
        };
        self.leaves += 1;
        if let Some(is_left) = self.loops.last_mut() {
            *is_left = true;
        }
        Ok(Node::Break(Box::new(value)))
    }

    pub(super) fn next_turn(&mut self, it: &syn::ExprContinue) -> Lowered {
        self.inside_a_loop(self.at_any(it), "continue")?;
        if it.label.is_some() {
            return self.unread(self.at_any(it), "labels of loops");
        }
        self.leaves += 1;
        Ok(Node::Continue)
    }

    /// The body of a loop, and whether it ever leaves the loop.
    fn looped(&mut self, body: &syn::Block, label: Option<&syn::Label>) -> Lowered<(Node, bool)> {
        if let Some(label) = label {
            return self.unread(self.at_any(label), "labels of loops");
        }
        self.loops.push(false);
        let node = self.block_given(body, &Type::UNIT)?;
        Ok((node, self.loops.pop().unwrap_or_default()))
    }

    fn inside_a_loop(&self, at: At, word: &str) -> Lowered<()> {
        if self.loops.is_empty() {
            return self.refused(at, format!("`{word}` outside of a loop"));
        }
        Ok(())
    }
}
