//! Parsing: a text as a syntax tree, and what is wrong with one that is none.

use proc_macro2::{LexError, TokenStream};
use syn::parse::Parse;

use crate::fault::{Fault, FaultKind, Span};
use crate::nesting::{self, MAX_NESTING};

/// Parses a text, unless it is nested so deeply that the parser would overflow its stack.
///
/// # Errors
/// The first place that is no Rust.
pub(crate) fn parse<T: Parse>(file: u16, text: &str) -> Result<T, Fault> {
    let text = text.trim_start_matches('\u{feff}');
    let tokens: Result<TokenStream, LexError> = text.parse();
    let tokens = tokens.map_err(|error| no_token(file, text, error.span()))?;
    nesting::check(tokens.clone()).map_err(|at| {
        let words = format!("what is nested more than {MAX_NESTING} deep");
        Fault::unread(Span::of_span(file, at), words)
    })?;
    syn::parse2(tokens).map_err(|error| no_tree(file, text, &error))
}

/// Makes the fault of a place where no token begins.
fn no_token(file: u16, text: &str, span: proc_macro2::Span) -> Fault {
    let mut at = Span::of_span(file, span);
    at.end = at.start + 1;
    let sign = text
        .get(span.byte_range().start..)
        .and_then(|rest| rest.chars().next());
    let message = match sign {
        Some('(' | '[' | '{') => {
            return Fault::new(FaultKind::Unfinished, at, "a bracket is open");
        }
        Some(')' | ']' | '}') => return no_bracket(file, at, &text[..span.byte_range().start]),
        Some('"') => "this text has no end".to_owned(),
        Some('/') => "this comment has no end".to_owned(),
        Some(sign) => format!("`{}` is no sign of Rust", sign.escape_debug()),
        None => "this is no Rust".to_owned(),
    };
    Fault::new(FaultKind::Unparsed, at, message)
}

/// Makes the fault of a closing bracket behind a text: no bracket is open, or another one.
fn no_bracket(file: u16, at: Span, before: &str) -> Fault {
    let open: Result<TokenStream, LexError> = before.parse();
    match open {
        Ok(_) => Fault::new(
            FaultKind::Unparsed,
            at,
            "no bracket is open that this one closes",
        ),
        Err(open) => {
            let at = Span::of_span(file, open.span());
            Fault::new(FaultKind::Unparsed, at, "this bracket is not closed")
        }
    }
}

/// Makes the fault of tokens that are no syntax tree.
fn no_tree(file: u16, text: &str, error: &syn::Error) -> Fault {
    let mut at = Span::of_span(file, error.span());
    let message = error.to_string();
    let missing = message.trim_start_matches("unexpected token, ");
    if ["expected `;`", "expected `,`"].contains(&missing) {
        // What the line before lacks is missing at its end.
        let before = &text[..error.span().byte_range().start];
        let last = before.trim_end();
        let line = last.rfind('\n').map_or(last, |start| &last[start + 1..]);
        if before[last.len()..].contains('\n') {
            at.line = last.matches('\n').count() as u32 + 1;
            at.end = line.chars().count() as u32;
            at.start = at.end.saturating_sub(1);
        }
        return Fault::new(FaultKind::Unparsed, at, missing);
    }
    Fault::new(FaultKind::Unparsed, at, message)
}
