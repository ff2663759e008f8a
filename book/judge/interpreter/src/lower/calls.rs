//! Calls of functions by their paths, and of values that are functions.

use std::rc::Rc;

use common::rtweekend::Vec3;

use super::declared::some;
use super::paths::Callee;
use super::{Expr, Lowered, Lowerer};
use crate::machine::value::{Data, Value};
use crate::machine::{Eval, ExprForm, Given, Native, Thunk};
use crate::names::names;
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

impl Lowerer<'_> {
    /// Lowers a call by a path or of a value that is a function.
    pub(super) fn call(&mut self, it: &syn::ExprCall) -> Lowered {
        let at = Span {
            end: self.at_span(it.paren_token.span.close()).end,
            ..self.at(&it.func)
        };
        let syn::Expr::Path(function) = &*it.func else {
            return self.call_value(it, at);
        };
        if self.variable_of(&it.func).is_some() {
            return self.call_value(it, at);
        }
        let path = names(&function.path);
        if let Some("Some" | "Ok") = path.last().map(String::as_str) {
            counted(1, it, at)?;
            return Ok(some(self.expr(&it.args[0])?, at));
        }
        let at_path = self.at_any(&function.path);
        let (owner, name) = self.owner(&path, at_path)?;
        match self.callee(owner.as_ref(), &name, &path, at_path, "function")? {
            Callee::Own(own) => self.call_own(own, it, at),
            Callee::Default(ty) => {
                counted(0, it, at)?;
                self.default_of(&ty, at)
            }
            Callee::Struct(kind) => {
                let fields = self.names.structs[kind as usize].fields.iter();
                let wanted: Vec<Type> = fields.map(|it| it.ty.clone()).collect();
                counted(wanted.len(), it, at)?;
                let given = self.all_given(&it.args, wanted)?;
                Ok(made(
                    kind,
                    given.into_iter().enumerate().collect(),
                    None,
                    at,
                ))
            }
            Callee::Native(native) => {
                counted(native.count(), it, at)?;
                self.call_native(native, &it.args, at)
            }
            Callee::OfTrait => {
                let given: Vec<&syn::Expr> = it.args.iter().collect();
                let Some((receiver, rest)) = given.split_first() else {
                    return Err(Refusal::miscounted(false, 1, 0, at));
                };
                self.method(receiver, &name, rest, (at_path, at))
            }
        }
    }

    /// Lowers a call of one of the text's own functions.
    fn call_own(&mut self, function: usize, it: &syn::ExprCall, at: Span) -> Lowered {
        let own = &self.names.functions[function];
        if own.is_constant {
            return self.refused(at, "expected function, found a constant");
        }
        let wanted = own.parameters.clone();
        counted(wanted.len(), it, at)?;
        let given = self.all_given(&it.args, wanted)?;
        Ok(Expr::new(at, move |m| m.called(function, &given, at)))
    }

    /// Lowers a call of a library function by its path.
    pub(super) fn call_native<'s>(
        &mut self,
        native: &'static Native,
        all: impl IntoIterator<Item = &'s syn::Expr>,
        at: Span,
    ) -> Lowered {
        let (runs, given) = self.arguments(all, at)?;
        if let [Thunk::Float(x), Thunk::Float(y), Thunk::Float(z)] = runs[..]
            && native.name == "new"
            && (native.owner)(Ctor::Vec3)
        {
            // A vector of numbers is made once.
            let vector = Vec3::new(x, y, z);
            return Ok(Expr::new(at, move |_| Ok(vector.into())));
        }
        Ok(Expr::new(at, move |m| {
            m.called_native(native, None, &runs, &given)
        }))
    }

    /// Lowers a call of a value that is a function, such as a closure in a variable.
    fn call_value(&mut self, it: &syn::ExprCall, at: Span) -> Lowered {
        let function = self.expr(&it.func)?;
        if function.spot.form == ExprForm::Open {
            return self.needs_a_type(function.spot.at);
        }
        let (runs, _) = self.arguments(&it.args, at)?;
        Ok(Expr::new(at, move |m| {
            let function = function.run.eval(m)?;
            let values = runs.iter().map(|it| it.eval(m));
            let mut values = values.collect::<Eval<Vec<_>>>()?;
            m.applied_to(&function, &mut values, at)
        }))
    }

    /// Lowers the arguments of a call whose callee is known only when it runs, and which checks
    /// their types then.
    pub(super) fn arguments<'s>(
        &mut self,
        all: impl IntoIterator<Item = &'s syn::Expr>,
        at: Span,
    ) -> Lowered<(Vec<Thunk>, Given)> {
        let all = all.into_iter().map(|it| self.given(it, &Type::UNKNOWN));
        let all = all.collect::<Lowered<Vec<Expr>>>()?;
        let spots = all.iter().map(|it| it.spot).collect();
        let runs = all.into_iter().map(|it| it.run).collect();
        Ok((runs, Given { spots, at }))
    }
}

/// Checks that a call has as many arguments as wanted.
fn counted(wanted: usize, call: &syn::ExprCall, at: Span) -> Lowered<()> {
    match call.args.len() {
        count if count == wanted => Ok(()),
        count => Err(Refusal::miscounted(false, wanted, count, at)),
    }
}

/// Makes an expression for a struct: its fields by their numbers, and the others from the value
/// behind `..`, if there is one.
pub(super) fn made(kind: u32, fields: Vec<(usize, Thunk)>, base: Option<Thunk>, at: Span) -> Expr {
    Expr::new(at, move |m| {
        let base = base.as_ref().map(|base| base.eval(m)).transpose()?;
        let mut all: Rc<[Value]> = match base.map(|it| it.data) {
            Some(Data::Own(_, fields)) => fields,
            _ => fields.iter().map(|_| Value::default()).collect(),
        };
        for (n, run) in &fields {
            let value = run.eval(m)?;
            Rc::make_mut(&mut all)[*n] = value;
        }
        Ok(Data::Own(kind, all).into())
    })
}
