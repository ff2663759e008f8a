//! Control flow: blocks, `let`, conditions, loops, and what leaves them.

use std::mem;
use std::ops::Range;
use std::rc::Rc;
use std::sync::Arc;

use super::lowerer::{Lowered, Lowerer};
use super::patterns::Pattern;
use crate::fault::Span;
use crate::integers;
use crate::machine::{Code, Exit, Machine, Run};
use crate::place::{Part, Place};
use crate::value::{Kind, Value, kind};

impl Lowerer<'_> {
    pub(super) fn block(&mut self, block: &syn::Block) -> Lowered {
        self.scoped(|own| {
            let mut statements = Vec::new();
            let mut last = None;
            for (n, statement) in block.stmts.iter().enumerate() {
                let is_last = n + 1 == block.stmts.len();
                match statement {
                    syn::Stmt::Item(_) => {}
                    syn::Stmt::Local(it) => statements.push(own.local(it)?),
                    syn::Stmt::Expr(it, None) if is_last => last = Some(own.expr(it)?),
                    // One that ends with a block has no value.
                    syn::Stmt::Expr(it, None) => statements.push(own.given(it, kind::UNIT)?),
                    syn::Stmt::Expr(it, Some(_)) => statements.push(own.expr(it)?),
                    syn::Stmt::Macro(it) if is_last && it.semi_token.is_none() => {
                        last = Some(own.macro_call(&it.mac)?);
                    }
                    syn::Stmt::Macro(it) => statements.push(own.macro_call(&it.mac)?),
                }
            }
            let last = last.unwrap_or_else(Code::unit);
            if statements.is_empty() {
                return Ok(last);
            }
            Ok(Code::act(move |m| {
                for statement in &statements {
                    statement.run(m)?;
                }
                last.run(m)
            }))
        })
    }

    fn local(&mut self, local: &syn::Local) -> Lowered {
        let (pattern, ty) = match &local.pat {
            syn::Pat::Type(it) => (&*it.pat, self.names.ty(&it.ty, self.scope)?),
            other => (other, kind::ANY),
        };
        let Some(init) = &local.init else {
            return self.without_value(pattern);
        };
        let (value, place) = self.tested(&init.expr, ty)?;
        let other = init.diverge.as_ref().map(|(_, other)| self.expr(other));
        let (other, at) = (other.transpose()?, self.at(pattern));
        match (pattern, &place) {
            (syn::Pat::Ident(name), None)
                if name.subpat.is_none() && !self.is_item(&name.ident) =>
            {
                Ok(self.named(name, value))
            }
            _ => {
                let pattern = self.pattern(pattern, place.as_ref())?;
                Ok(Code::act(move |m| {
                    let value = value.run(m)?;
                    match &other {
                        None => m.bind(&pattern, &value, at).map(Value::from),
                        Some(other) if !pattern(m, &value, at)? => other.run(m),
                        Some(_) => Ok(Value::Unit),
                    }
                }))
            }
        }
    }

    /// Lowers `let name = …`, whose value is part of the trace.
    fn named(&mut self, name: &syn::PatIdent, value: Code) -> Code {
        let text = name.ident.to_string();
        let slot = self.declare(&text, name.mutability.is_none());
        let Some(function) = self.traced.clone() else {
            return Code::act(move |m| {
                *m.local_mut(slot) = value.run(m)?;
                Ok(Value::Unit)
            });
        };
        let text = Arc::from(text);
        Code::act(move |m| {
            let value = value.run(m)?;
            m.note(&function, Some(&text), &value);
            *m.local_mut(slot) = value;
            Ok(Value::Unit)
        })
    }

    /// Lowers `let name;`, which gets its value by a later assignment.
    fn without_value(&mut self, pattern: &syn::Pat) -> Lowered {
        let syn::Pat::Ident(name) = pattern else {
            return self.unread(pattern, "a pattern without a value");
        };
        let slot = self.declare(&name.ident.to_string(), false);
        Ok(Code::act(move |m| {
            *m.local_mut(slot) = Value::Unit;
            Ok(Value::Unit)
        }))
    }

    pub(super) fn condition(&mut self, test: &syn::ExprIf) -> Lowered {
        let (at, then_at) = (self.at(&test.cond), self.at(&test.then_branch));
        let (condition, then) =
            self.scoped(|own| Ok((own.expr(&test.cond)?, own.block(&test.then_branch)?)))?;
        let (then, other) = match &test.else_branch {
            Some((_, other)) => (then, self.expr(other)?),
            None => (Self::checked(then, kind::UNIT, then_at), Code::unit()),
        };
        Ok(Code::act(move |m| match m.truth(&condition, at)? {
            true => then.run(m),
            false => other.run(m),
        }))
    }

    /// Lowers the value of patterns, which may be a `&mut` of a place.
    fn tested(&mut self, expr: &syn::Expr, ty: Kind) -> Lowered<(Code, Option<Place>)> {
        match self.lent(expr)? {
            Some((place, value)) => Ok((value, Some(place))),
            None => Ok((self.given(expr, ty)?, None)),
        }
    }

    /// Lowers `let … = …` as a condition.
    pub(super) fn test(&mut self, test: &syn::ExprLet) -> Lowered {
        let (value, place) = self.tested(&test.expr, kind::ANY)?;
        let at = self.at(&test.expr);
        let pattern = self.pattern(&test.pat, place.as_ref())?;
        Ok(Code::act(move |m| {
            let value = value.run(m)?;
            pattern(m, &value, at).map(Value::from)
        }))
    }

    pub(super) fn matching(&mut self, test: &syn::ExprMatch) -> Lowered {
        let (value, place) = self.tested(&test.expr, kind::ANY)?;
        let at = self.at(&test.expr);
        let arms = test.arms.iter();
        let arms = arms.map(|arm| self.scoped(|own| own.arm(arm, place.as_ref())));
        let arms = arms.collect::<Lowered<Vec<_>>>()?;
        Ok(Code::act(move |m| {
            let value = value.run(m)?;
            for (pattern, guard, body) in &arms {
                let is_match = pattern(m, &value, at)?;
                if is_match && guard.as_ref().map_or(Ok(true), |it| m.truth(it, at))? {
                    return body.run(m);
                }
            }
            m.refuse(at, "no arm of this `match` covers a value that it meets")
        }))
    }

    fn arm(
        &mut self,
        arm: &syn::Arm,
        place: Option<&Place>,
    ) -> Lowered<(Pattern, Option<Code>, Code)> {
        let (pattern, guard) = match &arm.pat {
            syn::Pat::Guard(it) => (&*it.pat, Some(&it.guard)),
            other => (other, None),
        };
        let pattern = self.pattern(pattern, place)?;
        let guard = guard.map(|guard| self.expr(guard)).transpose()?;
        Ok((pattern, guard, self.expr(&arm.body)?))
    }

    pub(super) fn while_loop(&mut self, looped: &syn::ExprWhile) -> Lowered {
        let (at, body_at) = (self.at(&looped.cond), self.at(&looped.body));
        let (condition, body) =
            self.scoped(|own| Ok((own.expr(&looped.cond)?, own.block(&looped.body)?)))?;
        Ok(Code::act(move |m| {
            while m.truth(&condition, at)? && !m.run_body(&body, body_at)? {}
            Ok(Value::Unit)
        }))
    }

    pub(super) fn endless_loop(&mut self, looped: &syn::ExprLoop) -> Lowered {
        let (body, at) = (self.block(&looped.body)?, self.at(&looped.body));
        Ok(Code::act(move |m| {
            while !m.run_body(&body, at)? {}
            Ok(mem::take(&mut m.left))
        }))
    }

    pub(super) fn for_loop(&mut self, looped: &syn::ExprForLoop) -> Lowered {
        let (at, body_at) = (self.at(&looped.expr), self.at(&looped.body));
        if let Some((place, all)) = self.lent(&looped.expr)? {
            return self.for_each_place(looped, place, all);
        }
        let all = self.expr(&looped.expr)?;
        let (pattern, body) =
            self.scoped(|own| Ok((own.pattern(&looped.pat, None)?, own.block(&looped.body)?)))?;
        Ok(Code::act(move |m| {
            let turn = |m: &mut Machine<'_>, value: &Value| -> Run<bool> {
                m.bind(&pattern, value, at)?;
                m.run_body(&body, body_at)
            };
            let all = all.run(m)?;
            if let kind::LIST | kind::OPTION = all.kind() {
                for value in all.parts() {
                    if turn(m, value)? {
                        break;
                    }
                }
                return Ok(Value::Unit);
            }
            let (numbers, of) = m.numbers(&all, at)?;
            for n in numbers {
                if turn(m, &Value::Int(n, of))? {
                    break;
                }
            }
            Ok(Value::Unit)
        }))
    }

    /// Lowers `for part in &mut place`: `part` is another name of each element's place.
    fn for_each_place(&mut self, looped: &syn::ExprForLoop, place: Place, all: Code) -> Lowered {
        let (at, slot) = (self.at(&looped.body), self.slot());
        let element = place.part(Part::Index(slot));
        let body = self.scoped(|own| {
            let _ = own.pattern(&looped.pat, Some(&element))?;
            own.block(&looped.body)
        })?;
        Ok(Code::act(move |m| {
            for n in 0..all.run(m)?.parts().len() {
                *m.local_mut(slot) = n.into();
                if m.run_body(&body, at)? {
                    break;
                }
            }
            Ok(Value::Unit)
        }))
    }

    /// Lowers `return` or `break`.
    pub(super) fn leave(&mut self, value: Option<&syn::Expr>, exit: Exit, at: Span) -> Lowered {
        let is_return = matches!(exit, Exit::Return);
        let ty = if is_return { self.result } else { kind::ANY };
        let value = match value {
            Some(value) => self.given(value, ty)?,
            None => Self::checked(Code::unit(), ty, at),
        };
        let traced = self.traced.clone().filter(|_| is_return);
        Ok(Code::act(move |m| {
            let value = value.run(m)?;
            if let Some(function) = &traced {
                m.note(function, None, &value);
            }
            m.left = value;
            Err(exit)
        }))
    }

    /// Lowers `value?`.
    pub(super) fn tried(&mut self, tried: &syn::ExprTry) -> Lowered {
        let (value, at) = (self.expr(&tried.expr)?, self.at(&tried.question_token));
        let traced = self.traced.clone();
        Ok(Code::act(move |m| {
            let mut value = value.run(m)?;
            m.admit(kind::OPTION, &mut value, at)?;
            if let Some(part) = value.part(0) {
                return Ok(part);
            }
            if let Some(function) = &traced {
                m.note(function, None, &value);
            }
            m.left = value;
            Err(Exit::Return)
        }))
    }
}

impl Machine<'_> {
    /// Returns the numbers of a range of integers, and their type.
    fn numbers(&mut self, range: &Value, at: Span) -> Run<(Range<i64>, Kind)> {
        if range.kind() != kind::RANGE {
            return self.mismatch(at, "Range", range.kind());
        }
        match *range.parts() {
            [
                Value::Int(start, one),
                Value::Int(end, other),
                Value::Bool(is_closed),
            ] => match integers::joined(one, other) {
                Some(of) => Ok((start..end.saturating_add(is_closed.into()), of)),
                None => {
                    let wanted = self.code.names.shown(one);
                    self.mismatch(at, wanted, other)
                }
            },
            [Value::Int(start, of), Value::Unit, _] => Ok((start..i64::MAX, of)),
            _ => self.refuse(at, "only a range of integers can be counted"),
        }
    }

    /// Returns the list of a range's numbers.
    pub(super) fn listed(&mut self, range: &Value, at: Span) -> Run {
        let (numbers, of) = self.numbers(range, at)?;
        if numbers.end == i64::MAX {
            return self.unread(at, "a list without an end");
        }
        self.spend((numbers.end - numbers.start).max(0) as usize, at)?;
        let numbers: Rc<[_]> = numbers.map(|n| Value::Int(n, of)).collect();
        Ok(Value::list(numbers))
    }
}
