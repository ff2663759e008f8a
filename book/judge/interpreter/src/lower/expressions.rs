//! Expressions other than calls: operators, literals, casts, references, ranges.

use std::rc::Rc;

use super::declared::tuple;
use super::{Expr, Lowered, Lowerer};
use crate::machine::value::{Data, Value};
use crate::machine::{EarlyExit, ExprForm, Thunk, alike};
use crate::names::Meaning;
use crate::operators::{ArithOp, Operator, operator};
use crate::refusal::Span;
use crate::types::{Ctor, Int, Type};

impl Lowerer<'_> {
    /// Lowers an expression of which no type is expected.
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
            syn::Expr::Tuple(it) => {
                let at = at();
                let all = it.elems.iter().map(|it| self.expr(it));
                Ok(tuple(all.collect::<Lowered<_>>()?, at))
            }
            syn::Expr::Array(it) => self.listed(&it.elems, &Type::UNKNOWN, true, at()),
            syn::Expr::Repeat(it) => self.repeated(it, true, at()),
            syn::Expr::Range(it) => self.range(it),
            syn::Expr::Reference(it) => self.reference(it),
            syn::Expr::Cast(it) => self.cast(it),
            syn::Expr::Try(it) => self.tried(it),
            syn::Expr::Struct(it) => self.structure(it),
            syn::Expr::Macro(it) => self.macro_call(&it.mac),
            syn::Expr::Unsafe(_) => self.unread(at(), "`unsafe`"),
            _ => self.unread(at(), "this kind of expression"),
        }
    }

    fn cast(&mut self, it: &syn::ExprCast) -> Lowered {
        let (from, at) = (self.expr(&it.expr)?.run, self.at_any(it));
        let to = self.names.ty(&self.context, &it.ty)?;
        Ok(Expr::new(at, move |m| {
            let value = from.eval(m)?;
            m.cast(&value, &to, at)
        }))
    }

    /// Lowers `let … = …` as a condition.
    fn test(&mut self, it: &syn::ExprLet) -> Lowered {
        let value = self.expr(&it.expr)?;
        let pattern = self.pattern(&it.pat, false)?;
        let test = Expr::new(value.spot.at, move |m| {
            let value = value.run.eval(m)?;
            Ok(pattern.binds(m, &value)?.into())
        });
        Ok(test.shown(ExprForm::Bool))
    }

    fn returned(&mut self, it: &syn::ExprReturn) -> Lowered {
        let result = self.result.clone();
        let at = self.at_span(it.return_token.span);
        let value = match &it.expr {
            Some(value) => self.given(value, &result)?,
            None if result.is_unknown() || result == Type::UNIT => tuple(Vec::new(), at),
            None => return Err(self.names.mismatch(&result, &Type::UNIT, "`()`", at)),
        };
        Ok(leave_with(value, EarlyExit::Return))
    }

    fn reference(&mut self, it: &syn::ExprReference) -> Lowered {
        let at = self.at_any(&it.and_token);
        if it.mutability.is_none() {
            let of = self.expr(&it.expr)?;
            let at = Span {
                start: at.start,
                ..of.spot.at
            };
            let lend = Expr::new(at, move |m| Ok(of.run.eval(m)?.lent()));
            return Ok(lend.shown(ExprForm::Lend));
        }
        let Some(place) = self.place(&it.expr)? else {
            let what = "`&mut` of a value without a name";
            return self.unread(self.at(&it.expr), what);
        };
        let place = self.mutable(place);
        let at = Span {
            start: at.start,
            ..place.at
        };
        Ok(Expr::new(at, move |m| m.borrowed(&place)))
    }

    /// Lowers the elements of an array or `vec!`, and adds a check that they are of one type.
    pub(super) fn listed<'s>(
        &mut self,
        all: impl IntoIterator<Item = &'s syn::Expr>,
        of: &Type,
        is_array: bool,
        at: Span,
    ) -> Lowered {
        let all = all.into_iter().map(|it| self.given(it, of));
        let all: Vec<Expr> = all.collect::<Lowered<_>>()?;
        Ok(Expr::new(at, move |m| {
            let mut values: Vec<Value> = Vec::with_capacity(all.len());
            for one in &all {
                let value = one.run.eval(m)?;
                m.keep(&value, at)?;
                if let Some(first) = values.first() {
                    m.must_be_like(&value, first, one.spot)?;
                }
                values.push(value);
            }
            Ok(Value::listed(values, is_array))
        }))
    }

    /// Lowers `[value; count]`, also of a `vec!`.
    pub(super) fn repeated(&mut self, it: &syn::ExprRepeat, is_array: bool, at: Span) -> Lowered {
        let value = self.expr(&it.expr)?.run;
        let count = self.given(&it.len, &Ctor::Int(Int::Usize).into())?.run;
        Ok(Expr::new(at, move |m| {
            let value = value.eval(m)?;
            let count = count.eval(m)?.int() as usize;
            m.take(count.saturating_mul(value.size()), at)?;
            Ok(Value::listed(vec![value; count], is_array))
        }))
    }

    pub(super) fn literal(&mut self, literal: &syn::Lit) -> Lowered {
        let at = self.at_any(literal);
        Ok(match literal {
            syn::Lit::Bool(it) => {
                let truth = it.value;
                Expr::new(at, move |_| Ok(truth.into())).shown(ExprForm::Bool)
            }
            syn::Lit::Str(it) => {
                let text = it.value();
                Expr::new(at, move |_| Ok(Value::str(&*text).lent()))
            }
            syn::Lit::Float(it) => {
                let ctor = self.suffix(it.suffix(), "float", at)?;
                let digits = it.base10_digits();
                match ctor {
                    Some(Ctor::F32) => {
                        let number: f32 = digits.parse().unwrap_or(f32::NAN);
                        Expr::new(at, move |_| Ok(number.into()))
                    }
                    ctor => float(digits.parse().unwrap_or(f64::NAN), ctor.is_none(), at),
                }
            }
            syn::Lit::Int(it) => {
                let Ok(value) = it.base10_digits().parse::<i128>() else {
                    return self.refused(at, "integer literal is too large");
                };
                match self.suffix(it.suffix(), "number", at)? {
                    Some(Ctor::F64) => float(value as f64, false, at),
                    Some(Ctor::F32) => Expr::new(at, move |_| Ok((value as f32).into())),
                    Some(Ctor::Int(int)) => Expr::new(at, move |_| Ok(Value::whole(value, int))),
                    _ => Expr::new(at, move |_| Ok(Value::whole(value, Int::Any)))
                        .shown(ExprForm::Int),
                }
            }
            _ => return self.unread(at, "this kind of literal"),
        })
    }

    /// Returns the type that the suffix of a number names; `None` for an empty one.
    fn suffix(&self, suffix: &str, what: &str, at: Span) -> Lowered<Option<Ctor>> {
        if suffix.is_empty() {
            return Ok(None);
        }
        match self.names.found(self.context.module, &[suffix.to_owned()]) {
            Ok(Meaning::Type(Type(ctor @ (Ctor::Int(_) | Ctor::F64 | Ctor::F32), _))) => {
                Ok(Some(ctor))
            }
            Ok(Meaning::Standard(_)) => self.unread(at, &format!("`{suffix}`")),
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
        let from = self.expr(from)?.run;
        let to = it.end.as_ref().map(|to| self.expr(to)).transpose()?;
        let is_closed = matches!(it.limits, syn::RangeLimits::Closed(_));
        Ok(Expr::new(at, move |m| {
            let from = from.eval(m)?;
            let mut end = Value::default();
            if let Some(to) = &to {
                end = to.run.eval(m)?;
                m.must_be_like(&end, &from, to.spot)?;
            }
            Ok(Data::Range(Rc::new([from, end]), is_closed).into())
        }))
    }

    /// Lowers `…?` on an option.
    fn tried(&mut self, it: &syn::ExprTry) -> Lowered {
        let of = self.expr(&it.expr)?.run;
        let at = self.at_any(&it.question_token);
        if !self.result.is_unknown() && !self.result.is(Ctor::Option) {
            let message =
                "the `?` operator can only be used in a function that returns `Result` or `Option`";
            let label = format!("this one returns `{}`", self.result.name(self.names));
            return self.fault(at, message, &label, "");
        }
        Ok(Expr::new(at, move |m| {
            let value = of.eval(m)?;
            match value.data {
                Data::Some(value) => Ok(Rc::unwrap_or_clone(value)),
                Data::None => {
                    m.left = None.into();
                    Err(EarlyExit::Return)
                }
                _ => {
                    let name = m.named(&value);
                    let message = "the `?` operator can only be applied to values that implement";
                    m.wrong(at, format!("{message} `Try`, and this is `{name}`"), "")
                }
            }
        }))
    }

    fn unary(&mut self, it: &syn::ExprUnary) -> Lowered {
        let at = self.at_any(it);
        let Expr { run, spot } = self.expr(&it.expr)?;
        Ok(match (&it.op, run) {
            (syn::UnOp::Deref(_), run) => Expr::new(at, move |m| {
                let value = run.eval(m)?;
                m.dereferenced(value, at)
            }),
            (syn::UnOp::Not(_), run) => Expr::new(at, move |m| {
                let value = run.eval(m)?;
                m.not(&value, at)
            }),
            (syn::UnOp::Neg(_), Thunk::Float(it)) => float(-it, spot.form == ExprForm::Float, at),
            (syn::UnOp::Neg(_), run) => {
                let negation = Expr::new(at, move |m| {
                    let value = run.eval(m)?;
                    m.negated(&value, at)
                });
                negation.shown(spot.form)
            }
            _ => return self.unread(at, "this operator"),
        })
    }

    fn binary(&mut self, it: &syn::ExprBinary) -> Lowered {
        let at = Span {
            end: self.at(&it.right).end,
            ..self.at(&it.left)
        };
        let sign = self.at_any(&it.op);
        let sign = self.text.get(sign.start as usize..sign.end as usize);
        let sign = sign.unwrap_or_default();
        match operator(sign) {
            Some(Operator::Arithmetic(sign, true)) => self.update(it, sign, at),
            Some(Operator::And) => self.logical(it, false),
            Some(Operator::Or) => self.logical(it, true),
            operator => {
                let [left, right] = [self.expr(&it.left)?, self.expr(&it.right)?];
                Ok(operation(operator, sign, [left, right], at))
            }
        }
    }

    /// Lowers `+=` and the like.
    fn update(&mut self, it: &syn::ExprBinary, sign: ArithOp, at: Span) -> Lowered {
        let Expr { run, spot } = self.expr(&it.right)?;
        let Some(place) = self.place(&it.left)? else {
            return self.refused(self.at(&it.left), "invalid left-hand side of assignment");
        };
        let place = self.mutable(place);
        Ok(Expr::new(at, move |m| {
            let right = run.eval(m)?;
            m.updated(&place, sign, right, (spot, at))
        }))
    }

    /// Lowers `&&` and `||`. The right side is not evaluated if the left one is `enough`: false for
    /// `&&`, true for `||`.
    fn logical(&mut self, it: &syn::ExprBinary, enough: bool) -> Lowered {
        let one = self.given(&it.left, &Type::BOOL)?;
        let mut other = self.given(&it.right, &Type::BOOL)?;
        let (left, right) = (self.at(&it.left), self.at(&it.right));
        // Lines of its own may never run.
        let between = left.end as usize..right.start as usize;
        if self.text.get(between).is_some_and(|it| it.contains('\n')) {
            other = self.marked(other, right);
        }
        let (one, other) = (one.run, other.run);
        let both = Expr::new(left, move |m| {
            let is_enough = one.eval(m)?.truth() == enough;
            if is_enough {
                Ok(enough.into())
            } else {
                other.eval(m)
            }
        });
        Ok(both.shown(ExprForm::Bool))
    }
}

/// Makes an expression that applies an operator to two others. `sign` is its text, for operators
/// that chapters don't have.
fn operation(operator: Option<Operator>, sign: &str, [left, right]: [Expr; 2], at: Span) -> Expr {
    let spot = right.spot;
    let forms = [left.spot.form, spot.form];
    let is_any = forms.map(|it| it == ExprForm::Float);
    let (left, right) = (left.run, right.run);
    match operator {
        Some(Operator::Arithmetic(sign, _)) => {
            let made = Expr::new(at, move |m| {
                if let (Some(a), Some(b)) = (left.number(m), right.number(m)) {
                    return Ok(m.of_floats(sign, a, b));
                }
                let left = left.eval(m)?;
                let right = right.eval(m)?;
                let [left, right] = alike([left, right], is_any);
                m.combined(sign, left, right, at)
            });
            match forms {
                [ExprForm::Float, ExprForm::Float] | [ExprForm::Int, ExprForm::Int] => {
                    made.shown(forms[0])
                }
                _ => made,
            }
        }
        Some(Operator::Compare(order)) => Expr::new(at, move |m| {
            if let (Some(a), Some(b)) = (left.number(m), right.number(m)) {
                return Ok(order.holds(a.partial_cmp(&b)).into());
            }
            let left = left.eval(m)?;
            let right = right.eval(m)?;
            m.compared(order, alike([left, right], is_any), (at, spot))
        })
        .shown(ExprForm::Bool),
        _ => {
            let sign = sign.to_owned();
            Expr::new(at, move |m| {
                let left = left.eval(m)?;
                let right = right.eval(m)?;
                m.bits(&sign, [left, right], at)
            })
        }
    }
}

/// Makes an expression for a number with a point. If `is_any`, it takes the width of what it meets.
fn float(number: f64, is_any: bool, at: Span) -> Expr {
    Expr::of(Thunk::Float(number), at).shown_if(is_any, ExprForm::Float)
}

/// Makes an expression that leaves a function or a loop with a value.
pub(super) fn leave_with(value: Expr, stop: EarlyExit) -> Expr {
    let leave = Expr::new(value.spot.at, move |m| {
        m.left = value.run.eval(m)?;
        Err(stop)
    });
    leave.shown(ExprForm::Never)
}
