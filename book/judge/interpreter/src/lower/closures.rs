//! Closures: their parameters are what they are called with.

use std::sync::Arc;

use super::{Lowered, Lowerer};
use crate::node::{Closure, Node};
use crate::types::Type;

impl Lowerer<'_> {
    /// A closure. Where it is no argument, the compiler asks what it takes.
    pub(super) fn closure(&mut self, it: &syn::ExprClosure, is_argument: bool) -> Lowered {
        let result = match &it.output {
            syn::ReturnType::Type(_, ty) => self.names.ty(&self.context, ty)?,
            syn::ReturnType::Default => Type::UNKNOWN,
        };
        let outside = self.locals.len();
        let mut parameters = Vec::new();
        for input in &it.inputs {
            let from = self.locals.len();
            parameters.push(self.irrefutable(input)?);
            let is_open = !is_argument && !matches!(input, syn::Pat::Type(_));
            for local in &mut self.locals[from..] {
                local.is_open = is_open;
            }
        }
        let outer = std::mem::replace(&mut self.result, result.clone());
        let loops = std::mem::take(&mut self.loops);
        let body = self.given(&it.body, &result);
        self.result = outer;
        self.loops = loops;
        self.locals.truncate(outside);
        let mut body = body?;
        if !matches!(*it.body, syn::Expr::Block(_)) {
            body = self.marked(body, self.at(&it.body));
        }
        let closure = Arc::new(Closure { parameters, body });
        Ok(Node::Closure(closure, it.capture.is_some()))
    }
}
