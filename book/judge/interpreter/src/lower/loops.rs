//! Loops: `while`, `loop` and `for`, with `break` and `continue`.

use super::declared::tuple;
use super::expressions::leave_with;
use super::{Expr, Lowered, Lowerer};
use crate::library::iterator;
use crate::machine::value::Value;
use crate::machine::{EarlyExit, ExprForm, Thunk};
use crate::refusal::Span;
use crate::types::Type;

impl Lowerer<'_> {
    pub(super) fn while_loop(&mut self, it: &syn::ExprWhile) -> Lowered {
        let at = self.at_any(&it.while_token);
        self.scoped(|own| {
            let condition = own.given(&it.cond, &Type::BOOL)?.run;
            let (body, _) = own.looped(&it.body, it.label.as_ref())?;
            Ok(Expr::new(at, move |m| {
                loop {
                    m.turn(at)?;
                    if !condition.eval(m)?.truth() || m.run_body(&body)? {
                        return Ok(m.brought());
                    }
                }
            }))
        })
    }

    pub(super) fn endless_loop(&mut self, it: &syn::ExprLoop) -> Lowered {
        let (body, is_left) = self.looped(&it.body, it.label.as_ref())?;
        let at = self.at_any(&it.loop_token);
        let made = Expr::new(at, move |m| {
            loop {
                m.turn(at)?;
                if m.run_body(&body)? {
                    return Ok(m.brought());
                }
            }
        });
        Ok(made.ending(!is_left))
    }

    pub(super) fn for_loop(&mut self, it: &syn::ExprForLoop) -> Lowered {
        let each = self.expr(&it.expr)?.run;
        let at = self.at(&it.expr);
        self.scoped(|own| {
            let pattern = own.irrefutable(&it.pat)?;
            let (body, _) = own.looped(&it.body, it.label.as_ref())?;
            Ok(Expr::new(at, move |m| {
                let each = each.eval(m)?;
                let mut each = iterator(m, &each, at)?;
                while let Some(value) = each.next(m)? {
                    m.turn(at)?;
                    pattern.binds(m, &value)?;
                    if m.run_body(&body)? {
                        break;
                    }
                }
                Ok(Value::default())
            }))
        })
    }

    pub(super) fn leave_loop(&mut self, it: &syn::ExprBreak) -> Lowered {
        let at = self.at_any(it);
        self.inside_a_loop(at, "break", it.label.as_ref())?;
        let value = match &it.expr {
            Some(value) => self.expr(value)?,
            None => tuple(Vec::new(), at),
        };
        if let Some(is_left) = self.loops.last_mut() {
            *is_left = true;
        }
        Ok(leave_with(value, EarlyExit::Break))
    }

    pub(super) fn next_turn(&mut self, it: &syn::ExprContinue) -> Lowered {
        let at = self.at_any(it);
        self.inside_a_loop(at, "continue", it.label.as_ref())?;
        Ok(Expr::new(at, |_| Err(EarlyExit::Continue)).shown(ExprForm::Never))
    }

    /// Lowers the body of a loop. The boolean is true if a `break` in it leaves the loop.
    fn looped(&mut self, body: &syn::Block, label: Option<&syn::Label>) -> Lowered<(Thunk, bool)> {
        if let Some(label) = label {
            return self.unread(self.at_any(label), "labels of loops");
        }
        self.loops.push(false);
        let body = self.block_given(body, &Type::UNIT)?;
        Ok((body.run, self.loops.pop().unwrap_or_default()))
    }

    /// Checks that `break` or `continue` stands in a loop and has no label.
    fn inside_a_loop(&self, at: Span, word: &str, label: Option<&syn::Lifetime>) -> Lowered<()> {
        if self.loops.is_empty() {
            return self.refused(at, format!("`{word}` outside of a loop"));
        }
        match label {
            Some(_) => self.unread(at, "labels of loops"),
            None => Ok(()),
        }
    }
}
