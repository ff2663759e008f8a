//! Parsing: the text of each file as a syntax tree, if it is one that can be walked.

use std::ops::Range;

use proc_macro2::{LexError, TokenStream};
use syn::spanned::Spanned;

use crate::nesting::{self, MAX_NESTING};
use crate::refusal::{Refusal, Span};

/// Returns the span of a part of a syntax tree.
pub(crate) fn at(file: u32, it: &impl Spanned) -> Span {
    at_span(file, it.span())
}

/// Converts a span of a file's token.
pub(crate) fn at_span(file: u32, span: proc_macro2::Span) -> Span {
    at_bytes(file, span.byte_range())
}

fn at_bytes(file: u32, bytes: Range<usize>) -> Span {
    Span {
        file,
        start: bytes.start as u32,
        end: bytes.end as u32,
    }
}

/// Returns the span of an expression, faster than by its tokens.
pub(crate) fn at_expr(file: u32, it: &syn::Expr) -> Span {
    let end = |outer: Span, last: proc_macro2::Span| Span {
        end: at_span(file, last).end,
        ..outer
    };
    match it {
        syn::Expr::Binary(it) => Span {
            end: at_expr(file, &it.right).end,
            ..at_expr(file, &it.left)
        },
        syn::Expr::MethodCall(it) => end(at_expr(file, &it.receiver), it.paren_token.span.close()),
        syn::Expr::Call(it) => end(at_expr(file, &it.func), it.paren_token.span.close()),
        syn::Expr::Field(it) => end(at_expr(file, &it.base), it.member.span()),
        syn::Expr::Paren(it) => at_span(file, it.paren_token.span.join()),
        syn::Expr::Path(it) if it.path.get_ident().is_some() => {
            at_span(file, it.path.segments[0].ident.span())
        }
        syn::Expr::Lit(it) => at_span(file, it.lit.span()),
        syn::Expr::Unary(it) => Span {
            start: at(file, &it.op).start,
            ..at_expr(file, &it.expr)
        },
        syn::Expr::Reference(it) => Span {
            start: at_span(file, it.and_token.span).start,
            ..at_expr(file, &it.expr)
        },
        syn::Expr::If(it) => {
            let last = match &it.else_branch {
                Some((_, other)) => at_expr(file, other),
                None => at_span(file, it.then_branch.brace_token.span.close()),
            };
            Span {
                start: at_span(file, it.if_token.span).start,
                ..last
            }
        }
        syn::Expr::Match(it) => end(
            at_span(file, it.match_token.span),
            it.brace_token.span.close(),
        ),
        syn::Expr::ForLoop(it) => end(
            at_span(file, it.for_token.span),
            it.body.brace_token.span.close(),
        ),
        syn::Expr::Block(it) => at_span(file, it.block.brace_token.span.join()),
        it => at(file, it),
    }
}

/// Returns the span of a statement; of a `let`, to its `;`.
pub(crate) fn at_statement(file: u32, it: &syn::Stmt) -> Span {
    match it {
        syn::Stmt::Local(it) => Span {
            end: at_span(file, it.semi_token.span).end,
            ..at_span(file, it.let_token.span)
        },
        syn::Stmt::Expr(it, _) => at_expr(file, it),
        it => at(file, it),
    }
}

/// Parses the text of the file with that number.
///
/// # Errors
/// The first fault, in the compiler's words where it has some.
pub(crate) fn parse(file: usize, text: &str) -> Result<syn::File, Refusal> {
    let file = file as u32;
    let code = plain(text);
    let tokens: TokenStream = code
        .parse()
        .map_err(|error: LexError| no_token(file, text, &code, error.span()))?;
    nesting::check(tokens.clone()).map_err(|span| {
        let what = format!("what is nested more than {MAX_NESTING} deep");
        Refusal::unread(at_span(file, span), &what)
    })?;
    syn::parse2(tokens).map_err(|error| no_tree(file, text, &error))
}

/// Replaces doc comments by blanks, since parsing them takes longer than the rest, unless the text
/// has block comments; and blanks that Rust does not know by signs that it refuses. Each byte keeps
/// its place.
fn plain(text: &str) -> String {
    let has_blocks = text.contains("/*");
    let line = |line: &str| {
        let start = line.trim_start();
        if has_blocks || !start.starts_with("///") && !start.starts_with("//!") {
            let line = line.replace('\u{a0}', "×");
            return line.replace(['\u{2009}', '\u{202f}'], "−");
        }
        let end = line.trim_end_matches(['\r', '\n']);
        " ".repeat(end.len()) + &line[end.len()..]
    };
    text.split_inclusive('\n').map(line).collect()
}

/// Makes the refusal of a place where no token begins.
fn no_token(file: u32, text: &str, code: &str, span: proc_macro2::Span) -> Refusal {
    let at = at_span(file, span);
    let sign = text[at.start as usize..].chars().next().unwrap_or(' ');
    let place = Span {
        end: at.start + sign.len_utf8() as u32,
        ..at
    };
    let (message, help) = match sign {
        '(' | '[' | '{' => {
            let message = "this file contains an unclosed delimiter";
            return Refusal::new(place, message, "", "a bracket is open").unfinished();
        }
        '"' => ("unterminated double quote string", ""),
        '/' => ("unterminated block comment", ""),
        '\'' => ("this is no character", "text stands between `\"`"),
        ')' | ']' | '}' => return no_bracket(sign, place, &code[..at.start as usize]),
        sign => {
            let message = format!("unknown start of token: {}", sign.escape_unicode());
            let known = LOOKALIKES.iter().find(|it| it.0 == sign);
            let help = known.map(|it| format!("it looks like `{}`, but it is not", it.1));
            return Refusal::new(place, message, "", &help.unwrap_or_default());
        }
    };
    Refusal::new(place, message, "", help)
}

/// Makes the refusal of a closing bracket that no open one fits.
fn no_bracket(sign: char, place: Span, before: &str) -> Refusal {
    let open: Result<TokenStream, LexError> = before.parse();
    let Err(open) = open else {
        let message = format!("unexpected closing delimiter: `{sign}`");
        return Refusal::new(place, message, "", "");
    };
    let start = at_span(place.file, open.span()).start as usize;
    let message = format!("mismatched closing delimiter: `{sign}`");
    Refusal::new(at_bytes(place.file, start..start + 1), message, "", "")
}

/// Makes the refusal of tokens that are no syntax tree.
fn no_tree(file: u32, text: &str, error: &syn::Error) -> Refusal {
    let message = error.to_string();
    let found = at_span(file, error.span());
    // What the line before lacks is missing at its end.
    let before = &text[..found.start as usize];
    let end = before.trim_end().len();
    let missing = message.trim_start_matches("unexpected token, ");
    let is_missing = missing == "expected `;`" || missing == "expected `,`";
    if is_missing && end > 0 && before[end..].contains('\n') {
        let last = before[..end].chars().next_back().map_or(0, char::len_utf8);
        return Refusal::new(at_bytes(file, end - last..end), missing, "", "");
    }
    let help = if message.contains("unexpected end of input") {
        "something is missing before the closing bracket"
    } else {
        ""
    };
    Refusal::new(found, message, "", help)
}

/// Characters of word processors that look like others, each with what is meant.
const LOOKALIKES: [(char, &str); 14] = [
    ('−', "-"),
    ('–', "-"),
    ('—', "-"),
    ('×', "*"),
    ('·', "*"),
    ('÷', "/"),
    ('≤', "<="),
    ('≥', ">="),
    ('“', "\""),
    ('”', "\""),
    ('‘', "'"),
    ('’', "'"),
    ('½', "0.5"),
    ('\u{a0}', " "),
];
