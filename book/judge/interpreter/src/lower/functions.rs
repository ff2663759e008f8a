//! Functions, closures, and their parameters.

use std::mem;
use std::sync::Arc;

use syn::spanned::Spanned;

use super::lowerer::{Lowered, Lowerer};
use super::patterns::Pattern;
use crate::collect::{Source, is_lent};
use crate::fault::{Fault, FaultKind, PRELUDE, Span};
use crate::machine::{ClosureCode, Code, Function};
use crate::names::{Names, Signature};
use crate::place::Place;
use crate::value::{Kind, kind};

/// Lowers the function or the constant with that number.
///
/// # Errors
/// The first fault that shows without running.
pub(crate) fn lower(names: &Names, number: usize, source: Source<'_>) -> Result<Function, Fault> {
    let signature = &names.signatures[number];
    let mut own = Lowerer {
        names,
        scope: &signature.scope,
        number,
        traced: (signature.scope.file < PRELUDE).then(|| Arc::from(&*signature.name)),
        variables: Vec::new(),
        slots: 0,
        around: Vec::new(),
        closures: Vec::new(),
        result: signature.result,
    };
    let (body, text) = match source {
        Source::Constant(value) => (own.given(value, signature.result)?, None),
        Source::Function(sig, block) => {
            let text = sig.fn_token.span.join(block.span());
            let text = text.and_then(|span| span.source_text());
            (own.body(signature, sig, block)?, text)
        }
    };
    Ok(Function {
        slots: own.slots,
        body,
        text: text.unwrap_or_default(),
        closures: own.closures,
        double: None,
    })
}

/// A parameter: its slot, its pattern, and its type if that is written.
type Parameter<'s> = (usize, &'s syn::Pat, Option<&'s syn::Type>);

/// The patterns of parameters that are no names, each with the slot of its value.
type Taken = Vec<(usize, Pattern, Span)>;

impl Lowerer<'_> {
    fn body(&mut self, signature: &Signature, sig: &syn::Signature, block: &syn::Block) -> Lowered {
        let parameters = self.parameters(&sig.inputs)?;
        let last = block.stmts.last();
        let at = last.map_or_else(|| self.at(block), |last| self.at(last));
        let body = self.block(block)?;
        self.check_has_result(&signature.name, block)?;
        let body = Self::checked(body, self.result, at);
        Ok(Self::behind(parameters, body))
    }

    /// Calls a function unfinished whose last statement can't give the result.
    fn check_has_result(&self, name: &str, block: &syn::Block) -> Lowered<()> {
        let has_none = match block.stmts.last() {
            None | Some(syn::Stmt::Local(_)) => true,
            Some(syn::Stmt::Expr(syn::Expr::If(last), _)) => last.else_branch.is_none(),
            Some(syn::Stmt::Expr(last, _)) => {
                matches!(last, syn::Expr::ForLoop(_) | syn::Expr::While(_))
            }
            _ => false,
        };
        if !has_none || [kind::UNIT, kind::ANY].contains(&self.result) {
            return Ok(());
        }
        let at = Span::of_span(self.scope.file, block.brace_token.span.close());
        let message = format!("`{name}` has no result so far");
        Err(Fault::new(FaultKind::Unfinished, at, message))
    }

    /// Declares the parameters of a function, which have the first slots.
    fn parameters<'s>(
        &mut self,
        inputs: impl IntoIterator<Item = &'s syn::FnArg>,
    ) -> Lowered<Taken> {
        let mut typed: Vec<Parameter> = Vec::new();
        for input in inputs {
            match input {
                syn::FnArg::Receiver(it) => {
                    let is_fixed = match &it.kind {
                        syn::ReceiverKind::Reference(_, _, is_mut) => is_mut.is_none(),
                        _ => it.mutability.is_none(),
                    };
                    self.declare("self", is_fixed);
                }
                syn::FnArg::Typed(it) => typed.push((self.slot(), &*it.pat, Some(&*it.ty))),
            }
        }
        self.taken(typed)
    }

    /// Declares the names in patterns of parameters.
    fn taken(&mut self, parameters: Vec<Parameter>) -> Lowered<Taken> {
        let mut parts = Vec::new();
        for (slot, pattern, ty) in parameters {
            match pattern {
                syn::Pat::Ident(name) if name.subpat.is_none() => {
                    let is_fixed = match ty {
                        Some(syn::Type::Reference(it)) => it.mutability.is_none(),
                        Some(_) => name.mutability.is_none(),
                        // It may be a `&mut`.
                        None => false,
                    };
                    self.name_place(&name.ident.to_string(), Place::of(slot, is_fixed));
                }
                _ => parts.push((slot, self.pattern(pattern, None)?, self.at(pattern))),
            }
        }
        Ok(parts)
    }

    /// Returns the body of a function behind the patterns of its parameters.
    fn behind(parameters: Taken, body: Code) -> Code {
        if parameters.is_empty() {
            return body;
        }
        Code::act(move |m| {
            for (slot, pattern, at) in &parameters {
                let value = m.local(*slot).clone();
                m.bind(pattern, &value, *at)?;
            }
            body.run(m)
        })
    }

    pub(super) fn closure(&mut self, closure: &syn::ExprClosure) -> Lowered {
        let result = match &closure.output {
            syn::ReturnType::Type(_, ty) => self.names.ty(ty, self.scope)?,
            syn::ReturnType::Default => kind::ANY,
        };
        let (first, at) = (self.slots, self.at(&closure.inputs_begin));
        let outer = mem::replace(&mut self.result, result);
        self.around.push((first, Vec::new()));
        let body = self.scoped(|own| own.closure_body(closure, result));
        let (_, captured) = self.around.pop().unwrap_or_default();
        self.result = outer;
        let lowered = ClosureCode {
            first,
            parameters: closure.inputs.iter().map(goes_back).collect(),
            captured,
            is_moved: closure.capture.is_some(),
            slots: self.slots,
            body: body?,
        };
        self.closures.push(lowered);
        let code = (self.number, self.closures.len() - 1);
        Ok(Code::act(move |m| m.closure(code, at)))
    }

    fn closure_body(&mut self, closure: &syn::ExprClosure, result: Kind) -> Lowered {
        let mut parameters: Vec<Parameter> = Vec::new();
        for input in &closure.inputs {
            parameters.push(match input {
                syn::Pat::Type(it) if is_lent(&it.ty) => (self.slot(), &*it.pat, Some(&*it.ty)),
                other => (self.slot(), other, None),
            });
        }
        let taken = self.taken(parameters)?;
        Ok(Self::behind(taken, self.given(&closure.body, result)?))
    }
}

/// Returns true for a parameter of a closure that is a `&mut`, or may be one: a name without a type
/// can only change what is behind it.
fn goes_back(input: &syn::Pat) -> bool {
    match input {
        syn::Pat::Type(it) => is_lent(&it.ty),
        syn::Pat::Ident(it) => it.mutability.is_none() && it.by_ref.is_none(),
        _ => false,
    }
}
