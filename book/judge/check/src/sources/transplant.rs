//! Program transplantation: a reader's statement, in whatever language, put into the chapter.

use std::collections::BTreeMap;
use std::rc::Rc;

use language::{Language, Rename, Role, Tree, canonical, simplified};

use super::TypedStatement;
use super::chapter_statement::{ChapterStatement, names_in};
use super::lines::CorrectedLine;

/// The most statements of a reader that are tried in one place.
const TRIED: usize = 3;
/// A statement is tried if it scores more: its likeness to the one in the place, from 0 to 1, and
/// 0.4 for the same purpose.
const ALIKE: f64 = 0.4;

/// A function of the chapter with a reader's statement in it.
pub(crate) struct Transplant {
    /// The name of the function.
    pub(crate) function: Rc<str>,
    /// The text of the function with the reader's expression, in Rust and with the chapter's names.
    pub(crate) text: String,
    /// The reader's line, and what the chapter has in its place.
    pub(crate) yours: CorrectedLine,
    /// True if the reader's expression has the purpose of the chapter's, as to be the value of `t`.
    pub(crate) has_same_role: bool,
}

impl ChapterStatement {
    /// Puts the statements that are most like this one in its place.
    pub(super) fn transplants(&self, all: &[&TypedStatement]) -> Vec<Transplant> {
        let scored = all.iter().filter(|it| self.can_be(it)).map(|it| {
            let renames = self.renames(it);
            let like = self.likeness(&in_names_of_the_chapter(&it.normal, &renames));
            let named = if self.has_role_of(it) { 0.4 } else { 0.0 };
            (like + named, renames, *it)
        });
        let mut likest: Vec<_> = scored.filter(|(score, ..)| *score > ALIKE).collect();
        likest.sort_by(|one, other| other.0.total_cmp(&one.0));
        let likest = likest.into_iter().take(TRIED);
        let transplants = likest.filter_map(|(_, renames, typed)| {
            let mut text = self.text.to_string();
            text.replace_range(self.value.at.clone(), &self.in_rust(typed, &renames)?);
            Some(Transplant {
                function: Rc::clone(&self.function),
                text,
                has_same_role: self.has_role_of(typed),
                yours: CorrectedLine {
                    line: typed.line.clone(),
                    right: self.spelled_as(typed, &renames),
                },
            })
        });
        transplants.collect()
    }

    /// Returns true if a statement can replace this one: a condition for a condition, a value
    /// for a value.
    fn can_be(&self, typed: &TypedStatement) -> bool {
        let kind = |role: &Role| match role {
            Role::Condition => 0,
            Role::Effect => 1,
            Role::LoopOver(_) => 2,
            Role::ValueOf(_) | Role::Result => 3,
        };
        kind(&self.role) == kind(&typed.role)
    }

    /// Pairs the names that only this statement has with those of a reader's statement that the
    /// chapter's function does not have, in the order in which they occur.
    fn renames(&self, typed: &TypedStatement) -> Vec<Rename> {
        let (theirs, own) = (names_in(self.pattern.tree()), names_in(&typed.normal));
        let free = theirs.iter().filter(|name| !own.contains(name));
        let new = own.iter().filter(|name| !self.pattern.knows(name));
        let pairs = free.cloned().zip(new.cloned());
        pairs.map(|(from, to)| Rename { from, to }).collect()
    }

    /// Prints the expression of a reader's statement in Rust, with the chapter's names.
    fn in_rust(&self, typed: &TypedStatement, renames: &[Rename]) -> Option<String> {
        let spelled = spelled_names(&self.text);
        let name = |it: &Tree| {
            let name = it.name()?;
            let renamed = renames.iter().find(|it| it.to == name);
            Some(Tree::name_of(
                spelled.get(renamed.map_or(name, |it| &it.from))?,
            ))
        };
        Language::Rust.to_source(&simplified(&typed.value).map_nodes(&name))
    }

    /// Prints this statement in the language and the names of a reader's statement.
    pub(super) fn spelled_as(&self, typed: &TypedStatement, renames: &[Rename]) -> String {
        let names = typed.value.nodes().into_iter().filter_map(Tree::name);
        let spelled: BTreeMap<String, &str> = names.map(|it| (canonical(it), it)).collect();
        let name = |it: &Tree| {
            let name = canonical(it.name()?);
            let renamed = renames.iter().find(|it| it.from == name);
            Some(Tree::name_of(
                spelled.get(renamed.map_or(&name, |it| &it.to))?,
            ))
        };
        let text = typed.language.to_source(&self.value.map_nodes(&name));
        let text = text.unwrap_or_else(|| self.text[self.value.at.clone()].to_owned());
        match &typed.role {
            Role::ValueOf(name) => format!("{name} = {text}"),
            _ => text,
        }
    }
}

/// Returns a reader's expression with the chapter's names for those of the reader.
fn in_names_of_the_chapter(tree: &Tree, renames: &[Rename]) -> Tree {
    tree.map_nodes(&|it| {
        let name = it.name()?;
        let rename = renames.iter().find(|it| it.to == name)?;
        Some(Tree::name_of(&rename.from))
    })
}

/// Maps the canonical names in a function of Rust to their spelling: `self.radius` for a field,
/// `f64::from(i)` for a whole number that is made a real one somewhere.
fn spelled_names(text: &str) -> BTreeMap<String, String> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let words = text.split(|c| !is_word(c)).filter(|it| !it.is_empty());
    let spelled = words.map(|word| {
        let or = |long: String, short: String| if text.contains(&long) { long } else { short };
        let name = or(format!("self.{word}"), word.to_owned());
        (canonical(word), or(format!("f64::from({name})"), name))
    });
    spelled.collect()
}
