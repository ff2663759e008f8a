//! A limit of depth for recursive descent: how deep a syntax tree will be, seen from its tokens.
//!
//! A recursive-descent parser calls itself for each bracket and each operator. A text that is
//! nested deeply enough would overflow its stack, so the depth is checked before.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

/// The deepest nesting of brackets and operators that is read: more than twice that of any chapter.
///
/// A level takes up to 60 kB of stack while it is read, without optimization, and up to 3 kB in
/// each call while it runs.
pub const MAX_NESTING: usize = 200;

/// Parses the text of a file, unless it is nested so deeply that the parser would overflow its
/// stack.
///
/// # Errors
/// If the text is no Rust, or is nested deeper than [`MAX_NESTING`].
pub fn parse_file(text: &str) -> syn::Result<syn::File> {
    // What is no token is refused there, in the parser's words.
    if let Ok(tokens) = text.trim_start_matches('\u{feff}').parse() {
        let message =
            format!("this is nested more than {MAX_NESTING} deep, and can't be read here");
        check(tokens).map_err(|at| syn::Error::new(at, message))?;
    }
    syn::parse_file(text)
}

/// Checks that tokens are not nested deeper than [`MAX_NESTING`].
///
/// # Errors
/// The first place that is.
pub(crate) fn check(tokens: TokenStream) -> Result<(), Span> {
    depth(tokens, MAX_NESTING).map(drop)
}

/// Returns how deep a parser of the tokens may call itself, or the first place deeper than `room`.
///
/// Each bracket is a level, and so is each sign and each word after a word, until a comma, the
/// statement or the item ends. A comma between angles, or between the parameters of a closure, ends
/// nothing.
fn depth(tokens: TokenStream, room: usize) -> Result<usize, Span> {
    let (mut deepest, mut level, mut held, mut inside) = (0, 0, 0_usize, 0);
    let mut tokens = tokens.into_iter().peekable();
    let mut last = None;
    while let Some(token) = tokens.next() {
        match &token {
            TokenTree::Group(group) => {
                level += 1;
                let room = room.checked_sub(level + held).ok_or(group.span_open())?;
                inside = inside.max(depth(group.stream(), room)?);
            }
            TokenTree::Punct(sign) => match sign.as_char() {
                ';' => (level, held, inside) = (0, 0, 0),
                ',' => (level, inside) = (0, 0),
                '<' | '|' => held += 1,
                '>' if held > 0 && !is_sign(last.as_ref(), "-=") => held -= 1,
                ':' | '\'' => {}
                _ => level += 1,
            },
            TokenTree::Ident(_) => level += usize::from(matches!(last, Some(TokenTree::Ident(_)))),
            TokenTree::Literal(_) => {}
        }
        deepest = deepest.max(level + held + inside);
        if deepest > room {
            return Err(token.span());
        }
        if is_block(&token) && !goes_on(tokens.peek()) {
            (level, held, inside) = (0, 0, 0);
        }
        last = Some(token);
    }
    Ok(deepest)
}

/// Returns true for a token that is one of these signs.
fn is_sign(token: Option<&TokenTree>, signs: &str) -> bool {
    matches!(token, Some(TokenTree::Punct(sign)) if signs.contains(sign.as_char()))
}

/// Returns true for a group in `{}`.
fn is_block(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
}

/// Returns true if the token after a block may continue the same expression.
fn goes_on(next: Option<&TokenTree>) -> bool {
    match next {
        Some(TokenTree::Ident(word)) => word == "else" || word == "as",
        Some(TokenTree::Punct(_)) => !is_sign(next, "#"),
        Some(TokenTree::Group(_)) => true,
        Some(TokenTree::Literal(_)) | None => false,
    }
}
