//! Transplantation: expressions of a reader's in the places of those of the chapter that
//! they are most like, so that they can be run there.

use std::collections::HashMap;
use std::ops::Range;

use super::alignment::common;
use super::expressions::expressions;
use super::tokens::{Token, is_name, tokens};
use super::{File, Sources};

/// An expression of the reader's, for a place in a function of the chapter's.
pub(crate) struct Variant {
    pub(crate) at: Range<usize>,
    pub(crate) with: String,
    /// The reader's line, and what is right there.
    pub(crate) wrong: String,
    pub(crate) right: String,
}

/// An expression as it can be compared.
struct Part<'a> {
    name: Option<&'a str>,
    typed: Vec<Token>,
    /// The same with the chapter's names.
    tokens: Vec<Token>,
    file: &'a File,
    line: &'a str,
}

/// So many tokens may be others in an expression, and one in so many; and it has as many at
/// least.
const OTHERS: usize = 6;
const SHARE: usize = 3;
/// So many expressions are tried in one place.
const TRIED: usize = 2;

/// Signs of other languages, token by token, in ours.
const IN_RUST: [(&str, &str); 6] = [
    ("< =", "<="),
    ("> =", ">="),
    ("& &", "&&"),
    ("| |", "||"),
    (" and ", " && "),
    (" or ", " || "),
];

/// An expression of the chapter's, and how its function spells what is in it.
struct Place<'a> {
    function: usize,
    name: Option<&'a str>,
    at: Range<usize>,
    tokens: Vec<Token>,
    spelled: &'a HashMap<String, String>,
}

impl Sources {
    /// What the reader has in the places of expressions of the chapter's functions that are
    /// nowhere in the reader's files, each with the number of its function. What is right
    /// in one place is not wrong in another.
    pub(crate) fn variants(&self, functions: &[&str]) -> Vec<(usize, Variant)> {
        let mut own: Vec<Part> = self.yours.iter().flat_map(File::parts).collect();
        let spelled: Vec<HashMap<String, String>> = functions
            .iter()
            .map(|text| of_a_ray(tokens(text)).into_iter())
            .map(|tokens| tokens.map(|it| (it.text, it.own)))
            .map(Iterator::collect)
            .collect();
        let places = functions.iter().zip(&spelled).enumerate();
        let places = places.flat_map(|(function, (text, spelled))| {
            let body = text.find('{').unwrap_or_default();
            let expressions = expressions(text, false).into_iter();
            let expressions = expressions.filter(move |it| it.at.start > body);
            expressions.map(move |it| Place {
                function,
                name: it.name,
                tokens: of_a_ray(tokens(&text[it.at.clone()])),
                at: it.at,
                spelled,
            })
        });
        let places: Vec<Place> = places.collect();
        // Names by which whole expressions are the chapter's are so everywhere.
        let mut known: Vec<(String, String)> = Vec::new();
        for (part, place) in own
            .iter()
            .flat_map(|it| places.iter().map(move |place| (it, place)))
        {
            if part.tokens.len() > OTHERS && place.is_right(part) {
                known.extend(place.renames(part));
            }
        }
        for part in &mut own {
            part.tokens = renamed(&part.tokens, &known);
        }
        let wrong = |part: &&Part| !places.iter().any(|place| place.is_right(part));
        let wrong: Vec<&Part> = own.iter().filter(wrong).collect();
        let is_missing = |place: &&Place| !own.iter().any(|part| place.is_right(part));
        let missing = places.iter().filter(is_missing);
        let variants = missing.flat_map(|place| place.variants(&wrong, |name| self.has(name)));
        variants.collect()
    }
}

impl Place<'_> {
    /// Names of the reader's that the function does not have, for others.
    fn renames(&self, part: &Part) -> Vec<(String, String)> {
        renames(&part.tokens, &self.tokens, |name| {
            self.spelled.contains_key(name)
        })
    }

    /// Whether it is the same, but for names.
    fn is_right(&self, part: &Part) -> bool {
        let own = renamed(&part.tokens, &self.renames(part));
        let own = own.iter().map(|it| &it.text);
        own.eq(self.tokens.iter().map(|it| &it.text))
    }

    fn variants(&self, wrong: &[&Part], has: impl Fn(&str) -> bool) -> Vec<(usize, Variant)> {
        let near = wrong.iter().filter_map(|part| {
            let renames = self.renames(part);
            let tokens = renamed(&part.tokens, &renames);
            let (same, all) = (
                common(&tokens, &self.tokens),
                tokens.len().max(self.tokens.len()),
            );
            let off = tokens.len() + self.tokens.len() - 2 * same;
            let is_given = self.name.is_some() && self.name == part.name;
            // What has its own name on either side is something else.
            let may_be_given = self.name.is_none_or(|name| !has(name))
                && part
                    .name
                    .is_none_or(|name| !self.spelled.contains_key(name));
            let is_renamed = |(own, new): &(&Token, &Token)| own.text != new.text;
            let is_near = may_be_given
                && off <= OTHERS
                && 2 * part.tokens.iter().zip(&tokens).filter(is_renamed).count() <= all
                && SHARE * (all - same) <= all
                && tokens.len() >= SHARE;
            (is_given || is_near).then_some((off, part, tokens))
        });
        let mut near: Vec<(usize, &&Part, Vec<Token>)> = near.collect();
        near.sort_by_key(|(off, ..)| *off);
        near.truncate(TRIED);
        let variants = near.into_iter().map(|(_, part, tokens)| {
            let own = |it: &Token| self.spelled.get(&it.text).unwrap_or(&it.text).clone();
            let with = tokens.iter().map(own).collect::<Vec<_>>().join(" ");
            let back = renames(&self.tokens, &part.typed, |_| false);
            let given = part.name.map_or(String::new(), |name| format!("{name} = "));
            let variant = Variant {
                at: self.at.clone(),
                with: IN_RUST
                    .iter()
                    .fold(with, |text, (from, to)| text.replace(from, to)),
                wrong: part.line.to_owned(),
                right: given + &part.file.said(&renamed(&self.tokens, &back)),
            };
            (self.function, variant)
        });
        variants.collect()
    }
}

impl File {
    fn parts(&self) -> Vec<Part<'_>> {
        let expressions = expressions(&self.text, self.name.ends_with(".py")).into_iter();
        let parts = expressions.map(|it| {
            let line = self.text[..it.at.start].matches('\n').count();
            let typed = of_a_ray(tokens(&self.text[it.at]));
            Part {
                name: it.name,
                tokens: typed.clone(),
                typed,
                file: self,
                line: self.text.lines().nth(line).unwrap_or_default().trim(),
            }
        });
        parts.collect()
    }

    /// The tokens as the file spells them.
    fn said(&self, tokens: &[Token]) -> String {
        let mut said = String::new();
        let mut before = "";
        for token in tokens {
            let text = token.text.as_str();
            let is_call = text == "(" && (is_name(before) || matches!(before, "" | "("));
            let is_close = matches!(text, ")" | "," | ".") || matches!(before, "(" | "." | "");
            if !is_call && !is_close {
                said.push(' ');
            }
            let own = self.tokens.iter().find(|it| it.text == text);
            said.push_str(own.map_or(text, |own| &own.own));
            before = text;
        }
        said
    }
}

/// Names that are in the first alone, and known nowhere, for those that are in the other
/// alone, in the order in which both come: those of functions, and those of values.
fn renames(
    own: &[Token],
    other: &[Token],
    is_known: impl Fn(&str) -> bool,
) -> Vec<(String, String)> {
    let only = |tokens: &[Token], other: &[Token], is_called: bool| {
        let mut names: Vec<String> = Vec::new();
        for (n, token) in tokens
            .iter()
            .enumerate()
            .filter(|(_, it)| is_name(&it.text))
        {
            let is_new = !names.contains(&token.text);
            let is_meant = tokens.get(n + 1).is_some_and(|it| it.text == "(") == is_called;
            if is_new && is_meant && other.iter().all(|it| it.text != token.text) {
                names.push(token.text.clone());
            }
        }
        names
    };
    let pairs = [true, false].into_iter().flat_map(|is_called| {
        let unknown = only(own, other, is_called).into_iter();
        let unknown: Vec<String> = unknown.filter(|name| !is_known(name)).collect();
        unknown.into_iter().zip(only(other, own, is_called))
    });
    pairs.collect()
}

/// What a ray has, in one word: some hand on its parts.
fn of_a_ray(tokens: Vec<Token>) -> Vec<Token> {
    let mut merged: Vec<Token> = Vec::new();
    for token in tokens {
        let is_part = matches!(&*token.text, "origin" | "direction");
        match &merged[..] {
            [.., ray, point] if is_part && ray.text == "r" && point.text == "." => {
                let own = format!("{}.{}", ray.own, token.own);
                merged.truncate(merged.len() - 2);
                merged.push(Token { own, ..token });
            }
            _ => merged.push(token),
        }
    }
    merged
}

fn renamed(tokens: &[Token], renames: &[(String, String)]) -> Vec<Token> {
    let rename = |token: &Token| {
        let found = renames.iter().find(|(own, _)| *own == token.text);
        found.map_or(token.clone(), |(_, other)| Token::new(other, token.line))
    };
    tokens.iter().map(rename).collect()
}
