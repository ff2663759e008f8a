//! Blocks: statements one after the other, and the value at their end.

use std::sync::Arc;

use super::declared::checked;
use super::{Expr, Lowered, Lowerer};
use crate::machine::value::Value;
use crate::machine::{CoveragePoint, Thunk};
use crate::read::at_statement;
use crate::refusal::Refusal;
use crate::types::Type;

/// A statement that was lowered, and its coverage point.
struct LoweredStatement {
    run: Thunk,
    mark: Arc<CoveragePoint>,
}

impl Lowerer<'_> {
    /// Lowers a block that should come to type `ty`.
    pub(super) fn block_given(&mut self, block: &syn::Block, ty: &Type) -> Lowered {
        let (mut steps, has_value, is_left) = self.scoped(|own| own.statements(block, ty))?;
        if !has_value && !is_left && !ty.is_unknown() && *ty != Type::UNIT {
            return self.no_value(block, ty);
        }
        let at = self.at_span(block.brace_token.span.join());
        let last = if has_value { steps.pop() } else { None };
        let made = Expr::new(at, move |m| {
            for step in &steps {
                step.mark.notes_that_it_runs();
                drop(step.run.eval(m)?);
            }
            let Some(last) = &last else {
                return Ok(Value::default());
            };
            last.mark.notes_that_it_runs();
            last.run.eval(m)
        });
        Ok(made.ending(is_left))
    }

    /// Refuses a block without a value where type `ty` is expected.
    fn no_value<T>(&self, block: &syn::Block, ty: &Type) -> Lowered<T> {
        let refusal = |at| self.names.mismatch(ty, &Type::UNIT, "`()`", at);
        Err(match block.stmts.last() {
            Some(syn::Stmt::Expr(last, Some(_))) if self.may_be_value(last) => {
                refusal(self.at(last)).or_help("remove this semicolon to return this value")
            }
            _ => {
                let refusal = refusal(self.at_span(block.brace_token.span.close()));
                if !self.is_top(block) {
                    return Err(refusal);
                }
                let help = format!("`{}` has no result so far", self.name);
                refusal.or_help(&help).unfinished()
            }
        })
    }

    /// Returns false for an expression that is evaluated only for its effect, so that a `;` behind
    /// it is no mistake.
    fn may_be_value(&self, it: &syn::Expr) -> bool {
        match it {
            syn::Expr::Assign(_) => false,
            syn::Expr::MethodCall(it) => {
                let name = it.method.to_string();
                let mut own = self.names.methods(&name);
                own.all(|(_, n)| self.names.functions[n].result != Type::UNIT)
            }
            _ => true,
        }
    }

    /// Returns true for the outermost block of the function.
    fn is_top(&self, block: &syn::Block) -> bool {
        self.top.is_some_and(|top| std::ptr::eq(top, block))
    }

    /// Lowers the statements of a block. The first boolean is true if the last one is the block's
    /// value, the second if the block's end is never reached.
    fn statements(
        &mut self,
        block: &syn::Block,
        ty: &Type,
    ) -> Lowered<(Vec<LoweredStatement>, bool, bool)> {
        let (mut steps, mut has_value, mut is_left) = (Vec::new(), false, false);
        for (n, statement) in block.stmts.iter().enumerate() {
            if let syn::Stmt::Item(it) = statement {
                if self.is_top(block) {
                    continue;
                }
                return self.unread(self.at_any(it), "declarations in an inner block");
            }
            let made;
            let mark = self.mark(at_statement(self.file, statement));
            let is_open = self.is_top(block) && returns_early(statement);
            let is_last = n + 1 == block.stmts.len() && !is_open;
            (made, has_value) = self.statement(statement, is_last, ty)?;
            is_left |= made.never_ends();
            let run = made.run;
            steps.push(LoweredStatement { run, mark });
        }
        Ok((steps, has_value, is_left))
    }

    /// Lowers a statement. The boolean is true if it is the value of its block.
    fn statement(&mut self, it: &syn::Stmt, is_last: bool, ty: &Type) -> Lowered<(Expr, bool)> {
        Ok(match it {
            syn::Stmt::Local(it) => (self.declaration(it)?, false),
            syn::Stmt::Macro(it) => {
                let has_value = is_last && it.semi_token.is_none();
                let made = self.macro_call(&it.mac)?;
                let made = if has_value { checked(made, ty) } else { made };
                (made, has_value)
            }
            syn::Stmt::Expr(it, None) if is_last => (self.given(it, ty)?, true),
            syn::Stmt::Expr(
                it @ (syn::Expr::If(_) | syn::Expr::Match(_) | syn::Expr::Block(_)),
                None,
            ) => (self.given(it, &Type::UNIT)?, false),
            syn::Stmt::Expr(it, _) => (self.expr(it)?, false),
            syn::Stmt::Item(it) => return self.unread(self.at_any(it), "this declaration"),
        })
    }

    /// Lowers `let`.
    fn declaration(&mut self, it: &syn::Local) -> Lowered {
        let (pattern, written) = match &it.pat {
            syn::Pat::Type(it) => (&*it.pat, Some(self.names.ty(&self.context, &it.ty)?)),
            pattern => (pattern, None),
        };
        let Some(init) = &it.init else {
            // It gets its value later, once.
            self.pattern(pattern, true)?;
            return Ok(super::declared::tuple(Vec::new(), self.at_any(pattern)));
        };
        let value = match written {
            Some(ty) => self.given(&init.expr, &ty)?,
            None => self.expr(&init.expr)?,
        };
        let never_ends = value.never_ends();
        let (run, at) = (value.run, value.spot.at);
        let made = if let Some((_, other)) = &init.diverge {
            let other = self.given(other, &Type::NEVER)?.run;
            let pattern = self.pattern(pattern, false)?;
            Expr::new(at, move |m| {
                let value = run.eval(m)?;
                if !pattern.binds(m, &value)? {
                    other.eval(m)?;
                }
                Ok(Value::default())
            })
        } else {
            let pattern = self.irrefutable(pattern)?;
            match pattern.slot {
                Some(slot) => Expr::new(at, move |m| {
                    let value = run.eval(m)?;
                    m.bind(slot, value);
                    Ok(Value::default())
                }),
                None => Expr::new(at, move |m| {
                    let value = run.eval(m)?;
                    pattern.binds(m, &value)?;
                    Ok(Value::default())
                }),
            }
        };
        Ok(made.ending(never_ends))
    }

    /// Lowers `if`, whose branches should come to type `ty`.
    pub(super) fn condition(&mut self, it: &syn::ExprIf, ty: &Type) -> Lowered {
        let at = self.at_span(it.if_token.span);
        let (condition, then) = self.scoped(|own| {
            let condition = own.given(&it.cond, &Type::BOOL)?.run;
            let unit = Type::UNIT;
            let wanted = it.else_branch.as_ref().map_or(&unit, |_| ty);
            Ok((condition, own.block_given(&it.then_branch, wanted)))
        })?;
        let help = "`return …;`, or an `else` that gives the other value";
        let Some((_, other)) = &it.else_branch else {
            let last = it.then_branch.stmts.last();
            let is_value = |it: &Refusal| last.is_some_and(|last| it.is_at(self.at_any(last)));
            let then = then
                .map_err(|it| if is_value(&it) { it.or_help(help) } else { it })?
                .run;
            if !ty.is_unknown() && *ty != Type::UNIT {
                return self.fault(at, "`if` may be missing an `else` clause", "", help);
            }
            return Ok(Expr::new(at, move |m| match condition.eval(m)?.truth() {
                true => then.eval(m),
                false => Ok(Value::default()),
            }));
        };
        let (then, other) = (then?, self.given(other, ty)?);
        let is_left = then.never_ends() && other.never_ends();
        let (then, other) = (then.run, other.run);
        let made = Expr::new(at, move |m| match condition.eval(m)?.truth() {
            true => then.eval(m),
            false => other.eval(m),
        });
        Ok(made.ending(is_left))
    }
}

/// Returns true for an `if` without `else` that ends with `return`: a function that ends with one
/// lacks its other result.
fn returns_early(it: &syn::Stmt) -> bool {
    let syn::Stmt::Expr(syn::Expr::If(it), None) = it else {
        return false;
    };
    let last = it.then_branch.stmts.last();
    let returns = matches!(last, Some(syn::Stmt::Expr(syn::Expr::Return(_), _)));
    returns && it.else_branch.is_none()
}
