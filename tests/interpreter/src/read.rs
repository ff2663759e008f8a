//! Parsing: the text of each file as a syntax tree, if it is one that can be walked.

use std::ops::Range;

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::spanned::Spanned;

use crate::node::At;
use crate::{Fault, Place};

/// A text is no longer than this, in bytes: a chapter has some three thousand.
const LONGEST: usize = 100_000;
/// No bracket is in more brackets than that, and no expression has more words and signs:
/// a walk goes as deep as its tree is.
const DEEPEST: usize = 40;
const WORDIEST: usize = 240;
/// So many branches of one `if` follow each other.
const BRANCHES: usize = 40;

/// What is wrong with a text, and where.
#[derive(Clone, Debug)]
pub(crate) struct Refusal {
    pub(crate) at: Option<At>,
    message: String,
    label: String,
    help: String,
    /// Whether the compiler would say so, and not the program when it runs.
    is_refused: bool,
}

impl Refusal {
    pub(crate) fn new(at: At, message: &str, label: &str, help: &str) -> Self {
        Self {
            at: Some(at),
            message: message.to_owned(),
            label: label.to_owned(),
            help: help.to_owned(),
            is_refused: true,
        }
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
    if text.len() > LONGEST {
        let message = format!("this text is longer than {LONGEST} bytes");
        return Err(Refusal::new(
            At::default(),
            &message,
            "",
            "the page runs a chapter",
        ));
    }
    let code = scan(file, text)?;
    let tokens: Result<TokenStream, _> = code.parse();
    let tokens = tokens.map_err(|error: proc_macro2::LexError| {
        let place = at_span(file, error.span());
        Refusal::new(
            place,
            "this is no Rust",
            "",
            "look for a quote without its other half",
        )
    })?;
    let mut limits = Limits {
        file,
        words: 0,
        branches: 0,
        signs: 0,
    };
    limits.walk(tokens.clone(), 0)?;
    syn::parse2(tokens).map_err(|error| {
        let message = error.to_string();
        let found = at_span(file, error.span());
        // What is missing is missing after the word before.
        let is_missing = message.starts_with("expected `;`") || message.starts_with("expected `,`");
        let before = text[..found.start as usize].trim_end().len();
        let place = if is_missing && before > 0 {
            at_bytes(file, last_char(text, before)..before)
        } else {
            found
        };
        let help = if message.contains("unexpected end of input") {
            "something is missing before the closing bracket"
        } else {
            ""
        };
        Refusal::new(place, &message, "", help)
    })
}

fn last_char(text: &str, end: usize) -> usize {
    text[..end].char_indices().next_back().map_or(0, |it| it.0)
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

/// Scanning, before anything else: characters that no Rust has, and brackets without their
/// other halves. Comments and quotes are passed over. Returns the text with blanks for its
/// comments: those for readers would take longer to parse than the rest.
fn scan(file: u32, text: &str) -> Result<String, Refusal> {
    let mut code = text.as_bytes().to_vec();
    let mut open: Vec<(char, At)> = Vec::new();
    let mut at = 0;
    while let Some(sign) = text[at..].chars().next() {
        let end = at + sign.len_utf8();
        let place = at_bytes(file, at..end);
        let start = at;
        at += passed_over(&text[at..]).unwrap_or(sign.len_utf8());
        if sign == '/' && at > end {
            let comment = code[start..at].iter_mut();
            comment.filter(|it| **it != b'\n').for_each(|it| *it = b' ');
        }
        match sign {
            '(' | '[' | '{' if at == end => open.push((sign, place)),
            ')' | ']' | '}' => {
                let wanted = match sign {
                    ')' => '(',
                    ']' => '[',
                    _ => '{',
                };
                let (place, message) = match open.pop() {
                    Some((other, _)) if other == wanted => continue,
                    Some((_, place)) => (place, format!("mismatched closing delimiter: `{sign}`")),
                    None => (place, format!("unexpected closing delimiter: `{sign}`")),
                };
                return Err(Refusal::new(place, &message, "", ""));
            }
            _ if sign.is_ascii() || sign.is_alphabetic() || at > end => {}
            _ => {
                let message = format!("unknown start of token: {}", sign.escape_unicode());
                let known = LOOKALIKES.iter().find(|it| it.0 == sign);
                let help = known.map_or(String::new(), |it| {
                    format!("it looks like `{}`, but it is not", it.1)
                });
                return Err(Refusal::new(place, &message, "", &help));
            }
        }
    }
    match open.pop() {
        None => Ok(String::from_utf8_lossy(&code).into_owned()),
        Some((sign, place)) => {
            let message = "this file contains an unclosed delimiter";
            Err(Refusal::new(
                place,
                message,
                &format!("`{sign}` is still open"),
                "",
            ))
        }
    }
}

/// How many bytes a comment or a quote has that begins here.
fn passed_over(text: &str) -> Option<usize> {
    let until = |end: &str, from: usize| {
        text[from..]
            .find(end)
            .map_or(text.len(), |it| from + it + end.len())
    };
    if text.starts_with("//") {
        return Some(text.find('\n').unwrap_or(text.len()));
    }
    if text.starts_with("/*") {
        return Some(until("*/", 2));
    }
    if let Some(inside) = text.strip_prefix('"') {
        let mut is_escaped = false;
        let end = inside.find(|it| {
            let is_end = it == '"' && !is_escaped;
            is_escaped = it == '\\' && !is_escaped;
            is_end
        });
        return Some(end.map_or(text.len(), |it| it + 2));
    }
    // A character, and no lifetime.
    let rest = text.strip_prefix('\'')?;
    let mut signs = rest.chars();
    match (signs.next()?, signs.next()?) {
        ('\\', second) => Some(until("'", 2 + second.len_utf8())),
        (sign, '\'') => Some(2 + sign.len_utf8()),
        _ => None,
    }
}

struct Limits {
    file: u32,
    words: usize,
    branches: usize,
    /// Signs before a value that follow each other: each is a level deeper.
    signs: usize,
}

impl Limits {
    fn walk(&mut self, tokens: TokenStream, depth: usize) -> Result<(), Refusal> {
        for token in tokens {
            let span = token.span();
            match token {
                TokenTree::Group(group) => {
                    let outside = self.words;
                    self.check(depth < DEEPEST, span)?;
                    self.walk(group.stream(), depth + 1)?;
                    self.words = match group.delimiter() {
                        Delimiter::Brace => 0,
                        _ => outside + 1,
                    };
                    continue;
                }
                TokenTree::Punct(sign) if matches!(sign.as_char(), ',' | ';') => {
                    (self.words, self.branches, self.signs) = (0, 0, 0);
                }
                TokenTree::Punct(sign) if matches!(sign.as_char(), '-' | '!' | '*' | '&') => {
                    self.signs += 1;
                    self.check(self.signs < DEEPEST, span)?;
                    self.words += 1;
                    continue;
                }
                TokenTree::Ident(word) if word == "else" => self.branches += 1,
                TokenTree::Ident(word) if word == "fn" || word == "let" => {
                    (self.words, self.branches) = (0, 0);
                }
                _ => {}
            }
            self.signs = 0;
            self.words += 1;
            self.check(self.words < WORDIEST && self.branches < BRANCHES, span)?;
        }
        Ok(())
    }

    fn check(&self, is_small: bool, span: Span) -> Result<(), Refusal> {
        if is_small {
            return Ok(());
        }
        let message = "this is nested too deeply for the page";
        Err(Refusal::new(
            at_span(self.file, span),
            message,
            "",
            "give a part of it a name",
        ))
    }
}
