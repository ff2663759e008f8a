//! Closures: parameters that are bound when the closure is called, and a body that runs on the
//! variables around it.

use std::sync::Arc;

use super::{Expr, Lowered, Lowerer};
use crate::machine::Closure;
use crate::types::Type;

impl Lowerer<'_> {
    /// Lowers a closure. If it is no argument of a call, its parameters without a type count as of
    /// unknown type, which the compiler refuses to use.
    pub(super) fn closure(&mut self, it: &syn::ExprClosure, is_argument: bool) -> Lowered {
        let at = self.at_any(it);
        let result = match &it.output {
            syn::ReturnType::Type(_, ty) => self.names.ty(&self.context, ty)?,
            syn::ReturnType::Default => Type::UNKNOWN,
        };
        let outer = std::mem::replace(&mut self.result, result.clone());
        let loops = std::mem::take(&mut self.loops);
        let lowered = self.scoped(|own| {
            let mut parameters = Vec::new();
            for input in &it.inputs {
                let from = own.locals.len();
                parameters.push(own.irrefutable(input)?);
                let is_open = !is_argument && !matches!(input, syn::Pat::Type(_));
                for local in &mut own.locals[from..] {
                    local.is_open = is_open;
                }
            }
            Ok((parameters, own.given(&it.body, &result)?))
        });
        self.result = outer;
        self.loops = loops;
        let (parameters, mut body) = lowered?;
        if !matches!(*it.body, syn::Expr::Block(_)) {
            body = self.marked(body, self.at(&it.body));
        }
        let closure = Arc::new(Closure {
            parameters: parameters.len(),
            body: Box::new(move |m, given| {
                for (pattern, value) in parameters.iter().zip(given) {
                    pattern.binds(m, value)?;
                }
                body.run.eval(m)
            }),
        });
        let is_moved = it.capture.is_some();
        Ok(Expr::new(at, move |m| m.closure(&closure, is_moved, at)))
    }
}
