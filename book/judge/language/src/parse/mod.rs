//! Parsing of expressions in ten languages by one grammar: a cursor over the tokens, and what the
//! rules of the other modules share.

mod numbers;
mod operators;
mod values;

use std::collections::HashSet;

use crate::Language;
use crate::tokens::{Token, TokenKind, tokens};
use crate::tree::Tree;
use numbers::whole_numbers;

/// A cursor over the tokens of a text, which reads expressions.
pub(crate) struct Parser<'a> {
    /// The tokens of the text.
    pub(crate) tokens: Vec<Token<'a>>,
    /// The index of the token that is read next.
    pub(crate) next: usize,
    /// The language in which the text is read.
    pub(crate) language: Language,
    /// The variables that are whole numbers; empty for languages that divide these as real ones.
    whole: HashSet<&'a str>,
    /// True in a condition, where a brace begins a block and no value.
    pub(crate) is_in_condition: bool,
    /// The fields and named arguments that were read, each with its value.
    pub(crate) fields: Vec<(String, Tree)>,
    /// The number of brackets that are open.
    brackets: usize,
    /// The number of operators and values that enclose the one that is read.
    depth: usize,
}

impl<'a> Parser<'a> {
    /// Makes a cursor at the first token of a text.
    pub(crate) fn new(text: &'a str, language: Language) -> Self {
        let tokens = tokens(text, language);
        let whole = match language.divides_whole_numbers() {
            true => whole_numbers(&tokens),
            false => HashSet::new(),
        };
        Self {
            tokens,
            next: 0,
            language,
            whole,
            is_in_condition: false,
            fields: Vec::new(),
            brackets: 0,
            depth: 0,
        }
    }

    /// Returns the text of the `n`th token from here, or an empty one behind the last.
    pub(crate) fn ahead(&self, n: usize) -> &'a str {
        self.tokens.get(self.next + n).map_or("", |it| it.text)
    }

    /// Returns true if the next token has this text.
    pub(crate) fn is(&self, text: &str) -> bool {
        self.ahead(0) == text
    }

    /// Steps over the next token if it has this text, and tells if it had.
    pub(crate) fn eat(&mut self, text: &str) -> bool {
        let is_it = self.is(text);
        self.next += usize::from(is_it);
        is_it
    }

    /// Steps over the next token if it has this text; `None` if it has another.
    fn expect(&mut self, text: &str) -> Option<()> {
        self.eat(text).then_some(())
    }

    /// Returns true if the `n`th token from here is of this kind.
    fn is_kind(&self, n: usize, kind: TokenKind) -> bool {
        let token = self.tokens.get(self.next + n);
        token.is_some_and(|it| it.kind == kind)
    }

    /// Returns true if the `n`th token from here is a word.
    pub(crate) fn is_word(&self, n: usize) -> bool {
        self.is_kind(n, TokenKind::Word)
    }

    /// Returns the byte at which the next token begins, or 0 behind the last.
    pub(crate) fn start(&self) -> usize {
        self.tokens.get(self.next).map_or(0, |it| it.at)
    }

    /// Returns the byte behind the last token that was read, or 0 before the first.
    pub(crate) fn end(&self) -> usize {
        let last = self.next.checked_sub(1).and_then(|n| self.tokens.get(n));
        last.map_or(0, |it| it.at + it.text.len())
    }

    /// Returns true if the next token may begin another statement because it begins a line.
    pub(crate) fn is_on_a_new_line(&self) -> bool {
        let token = self.tokens.get(self.next);
        self.language.ends_at_lines() && self.brackets == 0 && token.is_none_or(|it| it.is_first)
    }

    /// Forgets open brackets and conditions, since a new statement begins.
    pub(crate) fn begin(&mut self) {
        (self.brackets, self.depth, self.is_in_condition) = (0, 0, false);
    }

    /// Reads the longest expression that begins here; `None` if none does.
    pub(crate) fn expression(&mut self) -> Option<Tree> {
        self.binary(1)
    }

    /// Reads values between commas in brackets; names before them go to the [fields](Self::fields).
    pub(crate) fn list(&mut self, open: &str, close: &str) -> Option<Vec<Tree>> {
        self.expect(open)?;
        self.brackets += 1;
        let is_in_condition = std::mem::take(&mut self.is_in_condition);
        let mut all = Vec::new();
        while !self.is(close) {
            // The name of a field or of an argument stands before a colon or `=`.
            let is_named =
                self.is_word(0) && (self.ahead(1) == ":" || self.ahead(1) == "=" && open == "(");
            let field = is_named.then(|| self.ahead(0).to_owned());
            self.next += if is_named { 2 } else { 0 };
            if !is_named && (self.is("..") || self.is("...")) {
                self.next += 1;
            }
            let value = self.expression()?;
            if let Some(field) = field {
                self.fields.push((field, value.clone()));
            }
            all.push(value);
            if !self.eat(",") && !self.is(close) {
                return None;
            }
        }
        self.next += 1;
        self.brackets -= 1;
        self.is_in_condition = is_in_condition;
        Some(all)
    }
}

/// Returns true if a word is part of a language's grammar and can name nothing.
pub(crate) fn is_keyword(word: &str) -> bool {
    const WORDS: [&str; 19] = [
        "return", "if", "else", "for", "while", "and", "or", "not", "in", "is", "let", "var",
        "const", "auto", "do", "switch", "match", "when", "elif",
    ];
    WORDS.contains(&word)
}
