//! The macros that the chapters use, those that people add while they look for a mistake, and
//! `mutants!`.

use proc_macro2::{Delimiter, Group, TokenTree};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;

use super::lowerer::{Lowered, Lowerer};
use crate::fault::{Fault, Span};
use crate::machine::Code;
use crate::value::Value;

impl Lowerer<'_> {
    pub(super) fn macro_call(&mut self, call: &syn::Macro) -> Lowered {
        let at = self.at(&call.path);
        let name = call.path.get_ident().map(ToString::to_string);
        match name.as_deref().unwrap_or_default() {
            "vec" => {
                let mut list = Group::new(Delimiter::Bracket, call.tokens.clone());
                list.set_span(call.path.span());
                let list = syn::parse2(TokenTree::from(list).into())
                    .map_err(|error| self.of_syntax(&error))?;
                self.expr(&list)
            }
            "mutants" => self.mutants(call),
            // What is printed beside the picture is not seen here.
            "println" | "print" | "eprintln" | "eprint" => Ok(Code::unit()),
            "assert" | "debug_assert" => self.asserted(call, at),
            "dbg" => self.expr(&call.parse_body().map_err(|error| self.of_syntax(&error))?),
            "todo" | "unimplemented" => Ok(panic("not yet implemented", at)),
            "unreachable" => Ok(panic("internal error: entered unreachable code", at)),
            "panic" => Ok(panic("the program panics here", at)),
            name => self.unread(&call.path, &format!("`{name}!`")),
        }
    }

    fn of_syntax(&self, error: &syn::Error) -> Fault {
        Fault::refused(
            Span::of_span(self.scope.file, error.span()),
            error.to_string(),
        )
    }

    fn arguments(&self, call: &syn::Macro) -> Lowered<Vec<syn::Expr>> {
        let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        let all = call.parse_body_with(parser);
        let all = all.map_err(|error| self.of_syntax(&error))?;
        Ok(all.into_iter().collect())
    }

    fn asserted(&mut self, call: &syn::Macro, at: Span) -> Lowered {
        let arguments = self.arguments(call)?;
        let Some(condition) = arguments.first() else {
            return self.refused(call, "`assert!` needs a condition");
        };
        let condition = self.expr(condition)?;
        Ok(Code::act(move |m| match m.truth(&condition, at)? {
            true => Ok(Value::Unit),
            false => m.panic(at, "assertion failed"),
        }))
    }

    /// Lowers `mutants!(7, right, one, other)`: `one` if mutant 7 runs, `other` if 8 does, else
    /// `right`. A mutant that is refused is lost alone.
    fn mutants(&mut self, call: &syn::Macro) -> Lowered {
        let all = self.arguments(call)?;
        let first = |number: &syn::Expr| match number {
            syn::Expr::Lit(syn::ExprLit {
                lit: syn::Lit::Int(number),
                ..
            }) => number.base10_parse::<u32>().ok(),
            _ => None,
        };
        let [number, right, others @ ..] = &*all else {
            return self.refused(call, "`mutants!` needs a number and what is right");
        };
        let Some(first) = first(number) else {
            return self.refused(number, "`mutants!` needs the number of the first");
        };
        let right = self.expr(right)?;
        let lost = |fault: Fault| Code::act(move |m| m.stop(fault.clone()));
        let others = others
            .iter()
            .map(|other| self.scoped(|own| own.expr(other)).unwrap_or_else(lost));
        let others: Vec<Code> = others.collect();
        Ok(Code::act(move |m| {
            let number = m.code.mutant.checked_sub(first);
            let chosen = number.and_then(|n| others.get(n as usize));
            chosen.unwrap_or(&right).run(m)
        }))
    }
}

fn panic(message: &'static str, at: Span) -> Code {
    Code::act(move |m| m.panic(at, message))
}
