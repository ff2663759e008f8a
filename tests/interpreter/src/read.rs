//! Parsing: the text of each file as a syntax tree, if it is one that can be walked.

use std::ops::Range;

use proc_macro2::LexError;
use syn::spanned::Spanned;

use crate::{Fault, Place};

/// A text is no longer than this, in bytes: a chapter has some three thousand.
const LONGEST: usize = 100_000;
/// No bracket is in more brackets than that, and no expression has more words and signs:
/// whoever walks a tree goes as deep as it is.
const DEEPEST: usize = 40;
const WORDIEST: usize = 240;
/// So many branches of one `if` follow each other.
const BRANCHES: usize = 40;

/// The tree of a file.
pub(crate) fn parse(file: usize, text: &str) -> Result<syn::File, Fault> {
    if text.len() > LONGEST {
        let message = format!("this text is longer than {LONGEST} bytes");
        return Err(Fault::at(None, &message, "", "the page runs a chapter"));
    }
    let tokens: Result<proc_macro2::TokenStream, LexError> = text.parse();
    let tokens = tokens.map_err(|error| {
        let place = place(file, error.span());
        Fault::at(
            Some(place),
            "this is no Rust",
            "",
            "look for a quote or a bracket without its other half",
        )
    })?;
    let mut limits = Limits {
        file,
        words: 0,
        branches: 0,
    };
    limits.walk(tokens.clone(), 0)?;
    syn::parse2(tokens).map_err(|error| {
        let at_end = error.to_string().contains("unexpected end of input");
        let help = match at_end {
            true => "something is missing before the closing bracket",
            false => "",
        };
        Fault::at(
            Some(place(file, error.span())),
            &error.to_string(),
            "",
            help,
        )
    })
}

/// Where it stands, as far as the first line goes.
pub(crate) fn place_of(file: usize, it: &impl Spanned) -> Place {
    place(file, it.span())
}

fn place(file: usize, span: proc_macro2::Span) -> Place {
    let (start, end) = (span.start(), span.end());
    let columns: Range<usize> = match start.line == end.line {
        true => start.column..end.column.max(start.column + 1),
        false => start.column..usize::MAX,
    };
    Place {
        file,
        line: start.line,
        columns,
    }
}

struct Limits {
    file: usize,
    words: usize,
    branches: usize,
}

impl Limits {
    fn walk(&mut self, tokens: proc_macro2::TokenStream, depth: usize) -> Result<(), Fault> {
        for token in tokens {
            let span = token.span();
            match token {
                proc_macro2::TokenTree::Group(group) => {
                    let outside = self.words;
                    self.check(depth < DEEPEST, span)?;
                    self.walk(group.stream(), depth + 1)?;
                    self.words = match group.delimiter() {
                        proc_macro2::Delimiter::Brace => 0,
                        _ => outside + 1,
                    };
                    continue;
                }
                proc_macro2::TokenTree::Punct(sign) if matches!(sign.as_char(), ',' | ';') => {
                    (self.words, self.branches) = (0, 0);
                }
                proc_macro2::TokenTree::Ident(word) if word == "else" => self.branches += 1,
                proc_macro2::TokenTree::Ident(word) if word == "fn" || word == "let" => {
                    (self.words, self.branches) = (0, 0);
                }
                _ => {}
            }
            self.words += 1;
            self.check(self.words < WORDIEST && self.branches < BRANCHES, span)?;
        }
        Ok(())
    }

    fn check(&self, is_small: bool, span: proc_macro2::Span) -> Result<(), Fault> {
        if is_small {
            return Ok(());
        }
        let message = "this is nested too deeply for the page";
        Err(Fault::at(
            Some(place(self.file, span)),
            message,
            "",
            "give a part of it a name",
        ))
    }
}
