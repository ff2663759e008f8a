//! Expected types: a declared type is passed down to the expression that makes the value, which is
//! checked there, so that a mismatch has the place that the compiler would name.

use super::{Expr, Lowered, Lowerer};
use crate::machine::{ExprForm, Thunk};
use crate::names::names;
use crate::refusal::Span;
use crate::types::{Ctor, Type};

impl Lowerer<'_> {
    /// Lowers an expression whose value should be of type `ty`, which is passed on to where the
    /// value arises and checked there.
    pub(super) fn given(&mut self, value: &syn::Expr, ty: &Type) -> Lowered {
        let made = match value {
            syn::Expr::Paren(it) => return self.given(&it.expr, ty),
            syn::Expr::Group(it) => return self.given(&it.expr, ty),
            syn::Expr::If(it) => return self.condition(it, ty),
            syn::Expr::Match(it) => return self.matching(it, ty),
            syn::Expr::Block(it) if it.label.is_none() => return self.block_given(&it.block, ty),
            syn::Expr::Closure(it) => self.closure(it, true)?,
            syn::Expr::Call(it) if is_default(it) && !ty.is_unknown() => {
                self.default_of(ty, self.at(value))?
            }
            syn::Expr::Call(it) if ty.is(Ctor::Option) && is_some(it) => {
                let of = self.given(&it.args[0], ty.inner())?;
                some(of, self.at(value))
            }
            syn::Expr::Tuple(it) if ty.is(Ctor::Tuple) && it.elems.len() == ty.1.len() => {
                let all = it.elems.iter().zip(&ty.1);
                let all = all.map(|(it, ty)| self.given(it, ty));
                tuple(all.collect::<Lowered<_>>()?, self.at(value))
            }
            syn::Expr::Array(it) if matches!(ty.0, Ctor::Array(_)) => {
                self.listed(&it.elems, ty.inner(), true, self.at(value))?
            }
            value => self.expr(value)?,
        };
        Ok(checked(made, ty))
    }

    /// Lowers several expressions, each with its expected type.
    pub(super) fn all_given<'s>(
        &mut self,
        all: impl IntoIterator<Item = &'s syn::Expr>,
        types: impl IntoIterator<Item = Type>,
    ) -> Lowered<Vec<Thunk>> {
        let both = all.into_iter().zip(types);
        both.map(|(it, ty)| Ok(self.given(it, &ty)?.run)).collect()
    }
}

/// Adds a check of the type to an expression, unless its form shows that the value fits.
pub(super) fn checked(made: Expr, ty: &Type) -> Expr {
    let is_certain = match made.spot.form {
        ExprForm::Never => true,
        ExprForm::Float => ty.is(Ctor::F64),
        ExprForm::Bool => ty.is(Ctor::Bool),
        _ => false,
    };
    if is_certain || ty.is_unknown() {
        return made;
    }
    let (ty, Expr { run, spot }) = (ty.clone(), made);
    let check = Thunk::new(move |m| {
        let value = run.eval(m)?;
        m.as_declared(value, &ty, spot)
    });
    Expr { run: check, spot }
}

/// Makes an expression `Some(…)`.
pub(super) fn some(of: Expr, at: Span) -> Expr {
    Expr::new(at, move |m| Ok(Some(of.run.eval(m)?).into()))
}

/// Makes an expression for a tuple; for `()` if there are no parts.
pub(super) fn tuple(all: Vec<Expr>, at: Span) -> Expr {
    if all.is_empty() {
        return Expr::new(at, |_| Ok(crate::machine::value::Value::default()));
    }
    Expr::new(at, move |m| {
        let all = all.iter().map(|it| it.run.eval(m));
        let all = all.collect::<crate::machine::Eval<Vec<_>>>()?;
        Ok(crate::machine::value::Value::tuple(all))
    })
}

/// Returns true for `Default::default()`, whose type is that of its place.
fn is_default(it: &syn::ExprCall) -> bool {
    matches!(&*it.func, syn::Expr::Path(it) if names(&it.path) == ["Default", "default"])
}

/// Returns true for `Some(…)`.
fn is_some(it: &syn::ExprCall) -> bool {
    matches!(&*it.func, syn::Expr::Path(path) if path.path.is_ident("Some")) && it.args.len() == 1
}
