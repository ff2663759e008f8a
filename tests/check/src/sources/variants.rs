//! Transplantation: expressions of a reader's in the places of those of the chapter that
//! they are most like, so that they can be run there.

use std::collections::HashMap;
use std::ops::Range;

use super::alignment::common;
use super::expressions::expressions;
use super::tokens::{Token, is_name, opening, tokens};
use super::{File, Sources, squeezed};

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
    /// The reader's statement, on one line.
    line: String,
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
    ///
    /// Returns how many expressions of the chapter's are missing, too.
    pub(crate) fn variants(&self, functions: &[&str]) -> (usize, Vec<(usize, Variant)>) {
        let spelled: Vec<_> = functions.iter().map(|text| spellings(text)).collect();
        let functions = functions.iter().zip(&spelled).enumerate();
        let places = functions.flat_map(|(n, (text, spelled))| places(n, text, spelled));
        let places: Vec<Place> = places.collect();
        let mut own: Vec<Part> = self.yours.iter().flat_map(File::parts).collect();
        let given = rename_all(&mut own, &places);
        // Under a name of the chapter's only the chapter's value is right.
        let is_right = |part: &Part| {
            let is_named = places.iter().any(|place| place.is_named_as(part));
            let mut places = places.iter();
            places.any(|it| (!is_named || it.is_named_as(part)) && it.is_right(part, &given))
        };
        let wrong: Vec<&Part> = own.iter().filter(|part| !is_right(part)).collect();
        let is_missing = |place: &&Place| !own.iter().any(|part| place.is_right(part, &given));
        let missing: Vec<&Place> = places.iter().filter(is_missing).collect();
        let variants = missing
            .iter()
            .flat_map(|place| place.variants(&wrong, &given, |name| self.has(name)));
        (missing.len(), variants.collect())
    }

    /// Whether the reader has the line's expressions, by other names perhaps. A short one is
    /// the same as many others.
    pub(super) fn have(&self, line: &str) -> bool {
        let wanted = expressions(line, false).into_iter();
        let wanted = wanted.map(|it| of_a_ray(tokens(&line[it.at])));
        let mut wanted = wanted.filter(|it| it.len() > OTHERS).peekable();
        let is_had = |wanted: Vec<Token>| {
            let is_it = |own: &Vec<Token>| {
                let renames = || renames(own, &wanted, |_| false);
                own.len() == wanted.len() && is_same(&renamed(own, &renames()), &wanted)
            };
            self.expressions.iter().any(is_it)
        };
        wanted.peek().is_some() && wanted.all(is_had)
    }
}

/// How a function spells what is in it.
fn spellings(text: &str) -> HashMap<String, String> {
    let tokens = of_a_ray(tokens(text)).into_iter();
    tokens.map(|it| (it.text, it.own)).collect()
}

/// The expressions of the nth function.
fn places<'a>(
    function: usize,
    text: &'a str,
    spelled: &'a HashMap<String, String>,
) -> impl Iterator<Item = Place<'a>> {
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
}

/// Gives the reader's expressions the chapter's names: those by which whole expressions are
/// the chapter's are so everywhere. Returns those of values that are given a name.
fn rename_all(own: &mut [Part], places: &[Place]) -> Vec<Rename> {
    let (mut known, mut given): (Vec<Rename>, Vec<Rename>) = Default::default();
    for part in own.iter().filter(|it| it.tokens.len() > OTHERS) {
        for place in places.iter().filter(|place| place.is_right(part, &[])) {
            known.extend(place.renames(part, &[]));
            given.extend(place.given_as(part));
        }
    }
    for part in own {
        part.tokens = renamed(&renamed(&part.tokens, &given), &known);
    }
    given
}

impl Place<'_> {
    /// Names of the reader's that the function does not have, for others; but for those of
    /// values that are given a name.
    fn renames(&self, part: &Part, given: &[Rename]) -> Vec<Rename> {
        renames(&part.tokens, &self.tokens, |name| {
            self.spelled.contains_key(name) || given.iter().any(|(_, chapter)| chapter == name)
        })
    }

    /// The name that the reader gives it, for the chapter's.
    fn given_as(&self, part: &Part) -> Option<Rename> {
        let own = part.name.filter(|name| !self.spelled.contains_key(*name))?;
        Some((own.to_owned(), self.name?.to_owned()))
    }

    fn is_named_as(&self, part: &Part) -> bool {
        self.name.is_some() && self.name == part.name
    }

    /// Whether it is the same, but for names.
    fn is_right(&self, part: &Part, given: &[Rename]) -> bool {
        is_same(
            &renamed(&part.tokens, &self.renames(part, given)),
            &self.tokens,
        )
    }

    fn variants(
        &self,
        wrong: &[&Part],
        given: &[Rename],
        has: impl Fn(&str) -> bool,
    ) -> Vec<(usize, Variant)> {
        let near = wrong.iter().filter_map(|part| {
            let tokens = renamed(&part.tokens, &self.renames(part, given));
            let (same, all) = (
                common(&tokens, &self.tokens),
                tokens.len().max(self.tokens.len()),
            );
            let off = tokens.len() + self.tokens.len() - 2 * same;
            let is_given = self.is_named_as(part);
            // What has its own name on either side is something else.
            let may_be_given = self.name.is_none_or(|name| !has(name))
                && part
                    .name
                    .is_none_or(|name| !self.spelled.contains_key(name));
            let is_renamed = |(own, new): &(&Token, &Token)| own.text != new.text;
            // A short one that has another name is any question with a number.
            let others = part.tokens.iter().zip(&tokens).filter(is_renamed).count();
            let is_itself = 2 * others <= all && (others == 0 || all > OTHERS);
            let is_near = may_be_given
                && is_itself
                && off <= OTHERS
                && SHARE * (all - same) <= all
                && tokens.len() >= SHARE;
            (is_given || is_near).then_some((off, part, tokens))
        });
        let mut near: Vec<(usize, &&Part, Vec<Token>)> = near.collect();
        near.sort_by_key(|(off, ..)| *off);
        near.truncate(TRIED);
        let variants = near.into_iter().flat_map(|(_, part, tokens)| {
            let own = |it: &Token| self.spelled.get(&it.text).unwrap_or(&it.text).clone();
            let with = tokens.iter().map(own).collect::<Vec<_>>().join(" ");
            let back = renames(&self.tokens, &part.typed, |_| false);
            let given = part.name.map_or(String::new(), |name| format!("{name} = "));
            let with = IN_RUST
                .iter()
                .fold(with, |text, (from, to)| text.replace(from, to));
            // By the reader's own names it may be the reader's line: then by the chapter's.
            let own = renamed(&self.tokens, &back);
            let own = if is_same(&own, &part.typed) {
                &self.tokens
            } else {
                &own
            };
            let right = given + &part.file.said(own);
            // A question asked the other way round is about the same thing.
            let turned = turned(&right).map(|right| (format!("!({with})"), right));
            let variants = [Some((with, right)), turned].into_iter().flatten();
            variants.map(|(with, right)| {
                let variant = Variant {
                    at: self.at.clone(),
                    with,
                    wrong: part.line.clone(),
                    // The chapter's line is in our Rust.
                    right: if part.file.name.ends_with(".rs") {
                        right
                    } else {
                        String::new()
                    },
                };
                (self.function, variant)
            })
        });
        variants.collect()
    }
}

impl File {
    /// The tokens of each expression.
    pub(super) fn expressions(&self) -> impl Iterator<Item = Vec<Token>> {
        self.parts().into_iter().map(|it| it.tokens)
    }

    /// The statement around an expression, without line breaks.
    fn statement(&self, expression: &Range<usize>) -> String {
        let start = self.text[..expression.start].rfind('\n');
        let rest = &self.text[expression.end..];
        let end = expression.end + rest.find(['\n', ';']).unwrap_or(rest.len());
        squeezed(&self.text[start.map_or(0, |start| start + 1)..end])
    }

    fn parts(&self) -> Vec<Part<'_>> {
        let expressions = expressions(&self.text, self.name.ends_with(".py")).into_iter();
        let parts = expressions.map(|it| {
            let typed = of_a_ray(tokens(&self.text[it.at.clone()]));
            Part {
                name: it.name,
                tokens: typed.clone(),
                typed,
                file: self,
                line: self.statement(&it.at),
            }
        });
        parts.collect()
    }

    /// The tokens as the file spells them.
    pub(super) fn said(&self, tokens: &[Token]) -> String {
        let mut said = String::new();
        let mut before = "";
        for token in tokens {
            let text = token.text.as_str();
            let is_call = text == "(" && (is_name(before) || matches!(before, "" | "("));
            let is_close = matches!(text, ")" | "," | ".")
                || matches!(before, "(" | "." | "")
                || text == "=" && matches!(before, "<" | ">");
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

/// The same question the other way round.
fn turned(question: &str) -> Option<String> {
    let turns = [
        (" <= ", " > "),
        (" >= ", " < "),
        (" < ", " >= "),
        (" > ", " <= "),
    ];
    let (from, to) = turns.iter().find(|(from, _)| question.contains(from))?;
    Some(question.replace(from, to))
}

fn is_same(own: &[Token], other: &[Token]) -> bool {
    own.iter()
        .map(|it| &it.text)
        .eq(other.iter().map(|it| &it.text))
}

/// A name of the reader's, and the chapter's.
type Rename = (String, String);

/// Names that are in the first alone, and known nowhere, for those that are in the other
/// alone, in the order in which both come: those of functions, and those of values.
fn renames(own: &[Token], other: &[Token], is_known: impl Fn(&str) -> bool) -> Vec<Rename> {
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
    // Of a short call nothing would be left but its brackets.
    let is_called = [false, true]
        .into_iter()
        .take(1 + usize::from(own.len() > OTHERS));
    let pairs = is_called.flat_map(|is_called| {
        let unknown = only(own, other, is_called).into_iter();
        let unknown: Vec<String> = unknown.filter(|name| !is_known(name)).collect();
        unknown.into_iter().zip(only(other, own, is_called))
    });
    pairs.collect()
}

/// What a ray has, in one word: some hand on its parts. Brackets around all of it go.
fn of_a_ray(mut tokens: Vec<Token>) -> Vec<Token> {
    let is_listed = tokens.iter().any(|it| it.text == ",");
    let is_in_brackets = tokens.first().is_some_and(|it| it.text == "(")
        && tokens.last().is_some_and(|it| it.text == ")")
        && opening(&tokens) == 0;
    if is_in_brackets && !is_listed {
        tokens.pop();
        tokens.remove(0);
    }
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

fn renamed(tokens: &[Token], renames: &[Rename]) -> Vec<Token> {
    let rename = |token: &Token| {
        let found = renames.iter().find(|(own, _)| *own == token.text);
        found.map_or(token.clone(), |(_, other)| Token::new(other, token.line))
    };
    tokens.iter().map(rename).collect()
}
