//! Parsing: the text of each file as a syntax tree, if it is one that can be walked.

use std::ops::Range;

use proc_macro2::{LexError, Span, TokenStream};
use syn::spanned::Spanned;

use crate::nesting::{self, DEEPEST};
use crate::node::At;
use crate::{Fault, Place};

/// What is wrong with a text, and where.
#[derive(Clone, Debug)]
pub(crate) struct Refusal {
    pub(crate) at: Option<At>,
    message: String,
    label: String,
    help: String,
    /// Whether the compiler would say so, and not the program when it runs.
    is_refused: bool,
    /// Whether the compiler may take it: what it refuses is said before.
    pub(crate) is_unknown: bool,
}

impl Refusal {
    pub(crate) fn new(at: At, message: &str, label: &str, help: &str) -> Self {
        Self {
            at: Some(at),
            message: message.to_owned(),
            label: label.to_owned(),
            help: help.to_owned(),
            is_refused: true,
            is_unknown: false,
        }
    }

    /// What the compiler takes, and is not known here.
    pub(crate) fn unknown(at: At, what: &str) -> Self {
        let message = format!("this page does not know {what}");
        Self {
            is_unknown: true,
            ..Self::new(at, &message, "", "cargo does")
        }
    }

    /// The same with other help, if there is some.
    pub(crate) fn or_help(mut self, help: &str) -> Self {
        if !help.is_empty() {
            help.clone_into(&mut self.help);
        }
        self
    }

    /// A program that has begun stops.
    pub(crate) fn stop(at: At, message: &str, help: &str) -> Self {
        Self {
            is_refused: false,
            ..Self::new(at, message, "the program stops here", help)
        }
    }

    pub(crate) fn fault(self, texts: &[String]) -> Fault {
        let at = self.at.filter(|at| at.end > 0);
        Fault {
            place: at.and_then(|at| place(texts.get(at.file as usize)?, at)),
            message: self.message,
            label: self.label,
            help: self.help,
            is_refused: self.is_refused,
        }
    }
}

/// The place in words, as far as its first line goes.
fn place(text: &str, at: At) -> Option<Place> {
    let before = text.get(..at.start as usize)?;
    let said = text.get(at.start as usize..at.end as usize)?;
    let start = before.chars().rev().take_while(|&it| it != '\n').count();
    let end = if said.contains('\n') {
        usize::MAX
    } else {
        start + said.chars().count().max(1)
    };
    Some(Place {
        file: at.file as usize,
        line: before.matches('\n').count() + 1,
        columns: start..end,
    })
}

/// Where a part of a tree stands.
pub(crate) fn at(file: u32, it: &impl Spanned) -> At {
    at_span(file, it.span())
}

pub(crate) fn at_span(file: u32, span: Span) -> At {
    at_bytes(file, span.byte_range())
}

fn at_bytes(file: u32, bytes: Range<usize>) -> At {
    At {
        file,
        start: bytes.start as u32,
        end: bytes.end as u32,
    }
}

/// Where an expression stands: without making its words anew, as `span` would.
pub(crate) fn at_expr(file: u32, it: &syn::Expr) -> At {
    let end = |outer: At, last: Span| At {
        end: at_span(file, last).end,
        ..outer
    };
    match it {
        syn::Expr::Binary(it) => At {
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
        it => at(file, it),
    }
}

/// The tree of a file.
pub(crate) fn parse(file: usize, text: &str) -> Result<syn::File, Refusal> {
    let file = file as u32;
    let code = plain(text);
    let tokens: TokenStream = code
        .parse()
        .map_err(|error: LexError| no_token(file, text, &code, error.span()))?;
    nesting::check(tokens.clone()).map_err(|span| {
        let what = format!("what is nested more than {DEEPEST} deep");
        Refusal::unknown(at_span(file, span), &what)
    })?;
    syn::parse2(tokens).map_err(|error| no_tree(file, text, &error))
}

/// The text with each byte in its place, but for comments that become attributes, since to
/// parse these takes longer than the rest, and for blanks that are none in Rust.
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

/// What stands where a token should begin.
fn no_token(file: u32, text: &str, code: &str, span: Span) -> Refusal {
    let at = at_span(file, span);
    let sign = text[at.start as usize..].chars().next().unwrap_or(' ');
    let place = At {
        end: at.start + sign.len_utf8() as u32,
        ..at
    };
    let (message, help) = match sign {
        '(' | '[' | '{' => ("this file contains an unclosed delimiter", ""),
        '"' => ("unterminated double quote string", ""),
        '/' => ("unterminated block comment", ""),
        '\'' => ("this is no character", "text stands between `\"`"),
        ')' | ']' | '}' => return no_bracket(sign, place, &code[..at.start as usize]),
        sign => {
            let message = format!("unknown start of token: {}", sign.escape_unicode());
            let known = LOOKALIKES.iter().find(|it| it.0 == sign);
            let help = known.map(|it| format!("it looks like `{}`, but it is not", it.1));
            return Refusal::new(place, &message, "", &help.unwrap_or_default());
        }
    };
    Refusal::new(place, message, "", help)
}

/// A bracket that closes another than the last open one, which is named, or none.
fn no_bracket(sign: char, place: At, before: &str) -> Refusal {
    let open: Result<TokenStream, LexError> = before.parse();
    let Err(open) = open else {
        let message = format!("unexpected closing delimiter: `{sign}`");
        return Refusal::new(place, &message, "", "");
    };
    let start = at_span(place.file, open.span()).start as usize;
    let message = format!("mismatched closing delimiter: `{sign}`");
    Refusal::new(at_bytes(place.file, start..start + 1), &message, "", "")
}

/// Why the tokens are no tree.
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
    Refusal::new(found, &message, "", help)
}

/// Signs that look like others, as books and word processors write them.
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
