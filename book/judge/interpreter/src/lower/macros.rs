//! Macros: `panic!` and its kind, `assert!`, `vec!`, and those that format text.

use syn::parse::Parser;
use syn::punctuated::Punctuated;

use super::declared::some;
use super::{Expr, Lowered, Lowerer};
use crate::machine::value::{Data, Value};
use crate::machine::{ExprForm, Machine, Thunk};
use crate::refusal::Span;
use crate::types::Type;

impl Lowerer<'_> {
    pub(super) fn macro_call(&mut self, it: &syn::Macro) -> Lowered {
        let at = self.at_any(&it.path);
        let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        let repeated = repeated(&it.tokens);
        let arguments: Vec<syn::Expr> = match parser.parse2(it.tokens.clone()) {
            Ok(arguments) => arguments.into_iter().collect(),
            Err(_) if repeated.is_some() => Vec::new(),
            Err(error) => return self.refused(at, error.to_string()),
        };
        let name = it.path.segments.last().expect("a path has a name");
        match name.ident.to_string().as_str() {
            "todo" | "unimplemented" => Ok(panic("not yet implemented", at)),
            "unreachable" => Ok(panic("internal error: entered unreachable code", at)),
            "panic" => Ok(panic("the program panics here", at)),
            "assert" | "debug_assert" => {
                let Some(condition) = arguments.first() else {
                    return self.refused(at, "requires a boolean expression as 1st argument");
                };
                let condition = self.given(condition, &Type::BOOL)?.run;
                Ok(Expr::new(at, move |m| match condition.eval(m)?.truth() {
                    true => Ok(Value::default()),
                    false => m.panic(at, "assertion failed"),
                }))
            }
            "vec" => match repeated {
                Some(it) => self.repeated(&it, false, at),
                None => self.listed(&arguments, &Type::UNKNOWN, false, at),
            },
            "format" => self.formatted(&arguments, "", at),
            "dbg" if arguments.len() == 1 => self.expr(&arguments[0]),
            // Nothing shows what is printed beside the picture.
            "println" | "eprintln" | "print" | "eprint" => {
                let text = self.formatted(&arguments, "", at)?.run;
                Ok(Expr::new(at, move |m| {
                    text.eval(m).map(|_| Value::default())
                }))
            }
            "mutants" => self.mutants(&arguments, at),
            "write" => self.written(&arguments, "", at),
            "writeln" => self.written(&arguments, "\n", at),
            name => self.unread(at, &format!("`{name}!`")),
        }
    }

    /// Lowers `mutants!(n, right, one, other, …)`: the mutant `n` is `one`, `n + 1` is `other`, and
    /// `right` runs for any other number. A mutant that is refused stops when it runs.
    fn mutants(&mut self, arguments: &[syn::Expr], at: Span) -> Lowered {
        let number = |it: &syn::Expr| match it {
            syn::Expr::Lit(it) => match &it.lit {
                syn::Lit::Int(it) => it.base10_parse::<u32>().ok(),
                _ => None,
            },
            _ => None,
        };
        let Some((first, [right, mutants @ ..])) = arguments
            .split_first()
            .and_then(|(it, rest)| Some((number(it)?, rest)))
        else {
            return self.refused(at, "requires a number and an expression");
        };
        let right = self.expr(right)?;
        let spot = right.spot;
        let mut all = Vec::new();
        for one in mutants {
            let loops = self.loops.clone();
            let lowered = self.scoped(|own| own.expr(one));
            self.loops = loops;
            all.push(lowered.unwrap_or_else(|_| panic("no program", at)).run);
        }
        let run = Thunk::new(move |m| {
            let n = m.code.mutant.checked_sub(first);
            let mutant = n.and_then(|n| all.get(n as usize));
            mutant.unwrap_or(&right.run).eval(m)
        });
        Ok(Expr { run, spot }.shown(ExprForm::Other))
    }

    /// Lowers `write!` and `writeln!`, whose text ends with `end`.
    fn written(&mut self, arguments: &[syn::Expr], end: &str, at: Span) -> Lowered {
        let Some((to, rest)) = arguments.split_first() else {
            return self.refused(at, "requires at least a format string argument");
        };
        let to = match self.place(to)? {
            Some(place) => {
                let place = self.mutable(place);
                Thunk::new(move |m| m.borrowed(&place))
            }
            None => self.expr(to)?.run,
        };
        let text = self.formatted(rest, end, at)?.run;
        let write = Expr::new(at, move |m| {
            let (to, text) = (to.eval(m)?, text.eval(m)?);
            if !matches!(
                (&to.data, &m.end_of(&to).data),
                (Data::Mut(_), Data::Str(_))
            ) {
                let ty = m.named(&to);
                return m.unread(at, &format!("`write!` to `{ty}`"));
            }
            m.append(&to, &text.text(), at)
        });
        Ok(some(write, at))
    }

    /// Lowers a format string with `{}` and `{name}`, and adds `end`. A format behind a colon is
    /// ignored.
    fn formatted(&mut self, arguments: &[syn::Expr], end: &str, at: Span) -> Lowered {
        let (text, values) = match arguments.split_first() {
            None => (String::new(), arguments),
            Some((syn::Expr::Lit(it), values)) => match &it.lit {
                syn::Lit::Str(text) => (text.value(), values),
                _ => return self.refused(at, "format argument must be a string literal"),
            },
            Some(_) => return self.refused(at, "format argument must be a string literal"),
        };
        // Two brackets stand for one.
        let text = text.replace("{{", "\u{1}").replace("}}", "\u{2}") + end;
        let plain = |text: &str| text.replace('\u{1}', "{").replace('\u{2}', "}");
        let mut pieces: Vec<(String, Thunk)> = Vec::new();
        let mut unnamed = values.iter();
        let mut rest = text.as_str();
        while let Some((before, inside, after)) = bracket(rest) {
            let name = inside.split(':').next().unwrap_or_default();
            let value = match name {
                "" => unnamed.next().map(|it| self.expr(it)),
                name => Some(self.inline(name, at)),
            };
            let Some(value) = value else {
                return self.refused(at, "this text has more brackets than there are arguments");
            };
            pieces.push((plain(before), value?.run));
            rest = after;
        }
        if unnamed.next().is_some() {
            return self.refused(at, "argument never used");
        }
        let rest = plain(rest);
        Ok(Expr::new(at, move |m| {
            let mut text = String::new();
            for (before, value) in &pieces {
                let value = value.eval(m)?;
                let value = shown(m, &value);
                m.take(before.len() + value.len(), at)?;
                text += before;
                text += &value;
            }
            m.take(rest.len(), at)?;
            Ok(Value::str(text + &rest))
        }))
    }

    /// Lowers the variable that a `{name}` in a format string names.
    fn inline(&mut self, name: &str, at: Span) -> Lowered {
        if name.starts_with(|it: char| it.is_ascii_digit()) {
            return self.unread(at, &format!("`{{{name}}}` in a text"));
        }
        match self.variable(name) {
            Some(local) => Ok(Expr::of(Thunk::Local(local.slot), at)),
            None => {
                let message = format!("cannot find value `{name}` in this scope");
                self.fault(at, &message, "not found in this scope", "")
            }
        }
    }
}

/// Makes an expression that panics.
fn panic(message: &'static str, at: Span) -> Expr {
    Expr::new(at, move |m| m.panic(at, message)).shown(ExprForm::Never)
}

/// Formats a value as `{}` does, without its format.
fn shown(m: &Machine<'_>, value: &Value) -> String {
    match &value.data {
        Data::Float(it) => it.to_string(),
        Data::Single(it) => it.to_string(),
        Data::Int(it, _) => it.get().to_string(),
        Data::Bool(it) => it.to_string(),
        Data::Str(it) => it.to_string(),
        Data::Mut(_) => shown(m, &m.end_of(value)),
        // Only the picture is looked at, and it has none of these.
        _ => "…".to_owned(),
    }
}

/// Parses the `value; count` in a `vec!`.
fn repeated(tokens: &proc_macro2::TokenStream) -> Option<syn::ExprRepeat> {
    let tokens = tokens.clone();
    let group = proc_macro2::Group::new(proc_macro2::Delimiter::Bracket, tokens);
    syn::parse2(proc_macro2::TokenTree::from(group).into()).ok()
}

/// Splits a text at its first `{…}` into the parts before, inside and after; `None` if there is
/// none.
fn bracket(text: &str) -> Option<(&str, &str, &str)> {
    let (before, after) = text.split_once('{')?;
    let (inside, after) = after.split_once('}')?;
    Some((before, inside, after))
}
