//! Transplantation: lines of a reader's in any language, spelled in Rust, beside those of the
//! chapter that they are most like.

use super::edit::Edit;
use super::functions::Function;
use super::roots::{Role, roots};
use super::spelling::plain;
use super::statements::{Statement, statements};
use super::tree::{ATOM, Op, Tree};
use crate::sources::{Line, Said};

/// So many lines are tried in one place, if they have this much in common with what is there.
const TRIED: usize = 3;
const ALIKE: f64 = 0.4;

/// The lines of a reader's beside a chapter.
pub(super) struct Lines<'a> {
    places: Vec<Place<'a>>,
    statements: &'a [Statement],
}

/// An expression of the chapter's.
struct Place<'a> {
    function: &'a Function,
    role: Role,
    value: &'a Tree,
    plain: Tree,
    /// The names that its function has.
    known: Vec<String>,
}

/// A line of a reader's in the place of the chapter's.
pub(super) struct Transplant<'a> {
    pub(super) function: &'a Function,
    pub(super) edit: Edit,
    pub(super) line: &'a Line,
    /// Whether it is there for what the chapter's is there for.
    pub(super) has_same_role: bool,
}

/// Reads the statements of a reader's files.
pub(super) fn read(files: &[(String, String)]) -> Vec<Statement> {
    files
        .iter()
        .flat_map(|(name, text)| statements(name, text))
        .collect()
}

impl<'a> Lines<'a> {
    pub(super) fn new(chapter: &'a [Function], statements: &'a [Statement]) -> Self {
        Self {
            places: chapter.iter().flat_map(places).collect(),
            statements,
        }
    }

    /// Returns true if no line is known.
    pub(super) fn is_empty(&self) -> bool {
        self.statements.is_empty()
    }

    /// Counts the chapter's expressions that the reader has.
    pub(super) fn count(&self) -> usize {
        self.places.len() - self.compared().0.len()
    }

    /// Puts lines that the chapter does not have in the place of those that the reader does not
    /// have.
    pub(super) fn transplants(&self) -> Vec<Transplant<'_>> {
        let (missing, wrong) = self.compared();
        let all = missing
            .into_iter()
            .flat_map(|place| place.transplants(&wrong));
        all.collect()
    }

    /// Tells what the lines say of another text of a function: a line is wrong if it stands there
    /// more often than in the chapter, and right if it stands there as often.
    pub(super) fn say(&self, function: &Function, wrong: &str) -> Said {
        let wrong = Function::read(&function.name, wrong).filter(|_| !self.is_empty());
        let Some(wrong) = &wrong else {
            return Said::Neither;
        };
        let (right, wrong) = (places(function), places(wrong));
        let only = |one: &[Place], other: &[Place]| -> Vec<usize> {
            let has = |it: &Place| other.iter().any(|other| other.is_same(it));
            (0..one.len()).filter(|n| !has(&one[*n])).collect()
        };
        let typed = |place: &Place| self.statements.iter().filter(|it| place.has(it)).count();
        let stands = |place: &Place| self.places.iter().filter(|it| it.is_same(place)).count();
        let mut added = only(&wrong, &right).into_iter().map(|n| &wrong[n]);
        let mut lost = only(&right, &wrong).into_iter().map(|n| &right[n]);
        if lost.any(|it| typed(it) >= stands(it)) {
            Said::Right
        } else if added.any(|it| typed(it) > stands(it)) {
            Said::Wrong
        } else {
            Said::Neither
        }
    }

    /// The chapter's expressions that the reader does not have, and the reader's that the chapter
    /// does not have.
    fn compared(&self) -> (Vec<&Place<'a>>, Vec<&'a Statement>) {
        let is_right = |it: &&Statement| is_in(&self.places, it);
        let (right, wrong): (Vec<&Statement>, Vec<&Statement>) =
            self.statements.iter().partition(is_right);
        let is_missing = |place: &&Place| !right.iter().any(|it| place.has(it));
        (self.places.iter().filter(is_missing).collect(), wrong)
    }
}

/// Whether the chapter has the statement. A name that the chapter gives too is to have the
/// chapter's value.
fn is_in(places: &[Place], statement: &Statement) -> bool {
    let is_named = |it: &&Place| it.role == statement.role && matches!(it.role, Role::Let(_));
    if places.iter().any(|it| is_named(&it)) {
        let mut named = places.iter().filter(is_named);
        return named.any(|it| it.has(statement));
    }
    places.iter().any(|it| it.has(statement))
}

/// Finds the expressions of a function; of what is put into `Some` only that.
fn places(function: &Function) -> Vec<Place<'_>> {
    let all = roots(&function.body).into_iter();
    let known = [names(&plain(&function.body)), function.parameters.clone()].concat();
    let all = all.map(|(role, value)| {
        let value = match &value.parts[..] {
            [some, given] if value.op == Op::Call && some.name() == Some("Some") => given,
            _ => value,
        };
        Place {
            function,
            role,
            plain: plain(value),
            known: known.clone(),
            value,
        }
    });
    all.filter(|it| it.value.op != Op::Block && !it.value.parts.is_empty())
        .collect()
}

impl<'a> Place<'a> {
    fn is_same(&self, other: &Self) -> bool {
        self.role == other.role && self.plain.is_same(&other.plain)
    }

    /// Returns true if the statement says the same.
    fn has(&self, statement: &Statement) -> bool {
        self.spell(&statement.value).is_same(&self.plain)
    }

    /// Returns true if the statement can stand there: a condition for one, a call for one, a value
    /// for a value.
    fn takes(&self, statement: &Statement) -> bool {
        let kind = |role: &Role| match role {
            Role::Condition | Role::Part => 0,
            Role::Called => 1,
            Role::Each => 2,
            Role::Let(_) | Role::Set(_) | Role::Result => 3,
        };
        kind(&self.role) == kind(&statement.role)
    }

    /// The reader's expression with the chapter's names for those that its function does not
    /// have, in the order in which they come.
    fn spell(&self, value: &Tree) -> Tree {
        let own = names(value);
        let theirs = names(&self.plain);
        let new = own.iter().filter(|name| !self.known.contains(name));
        let free = theirs.iter().filter(|name| !own.contains(name));
        let renames: Vec<(&String, &String)> = new.zip(free).collect();
        renamed(value, &renames)
    }

    /// Whether something of the statement stands in the place under the same name: else its
    /// names, turned into those of the place, make any sum look like any other.
    fn shares(&self, typed: &Tree, spelled: &Tree) -> bool {
        let leaves = |tree: &Tree| -> Vec<String> {
            let leaves = tree.nodes().into_iter().filter(|it| it.parts.is_empty());
            leaves
                .filter_map(|it| it.name().map(str::to_owned))
                .collect()
        };
        let (typed, theirs) = (leaves(typed), leaves(&self.plain));
        let mut both = leaves(spelled).into_iter();
        both.any(|it| typed.contains(&it) && theirs.contains(&it))
    }

    fn transplants<'l>(&'l self, wrong: &[&'a Statement]) -> Vec<Transplant<'l>> {
        let scored = wrong.iter().filter(|it| self.takes(it)).map(|it| {
            let value = self.spell(&it.value);
            let named = if it.role == self.role { 0.4 } else { 0.0 };
            (value.likeness(&self.plain) + named, value, *it)
        });
        let is_let = |role: &Role| matches!(role, Role::Let(_));
        let is_like = |(score, value, it): &(f64, Tree, &Statement)| {
            *score > ALIKE
                && (is_let(&it.role) == is_let(&self.role) || self.shares(&it.value, value))
        };
        let mut likest: Vec<_> = scored.filter(is_like).collect();
        likest.sort_by(|one, other| other.0.total_cmp(&one.0));
        let transplants = likest.into_iter().take(TRIED).map(|(_, value, it)| {
            let (text, at) = (&self.function.text, self.value.at.clone());
            Transplant {
                function: self.function,
                edit: Edit::new(text, at, value.within(ATOM), 0),
                line: &it.line,
                has_same_role: it.role == self.role,
            }
        });
        transplants.collect()
    }
}

/// Lists names of values, and fields of an object itself, in the order in which they first stand.
fn names(tree: &Tree) -> Vec<String> {
    let is_field = matches!(tree.op, Op::Field(_)) && tree.parts[0].name() == Some("self");
    let is_name = tree.name().is_some_and(|it| {
        it.starts_with(|c: char| c.is_alphabetic() || c == '_') && !it.contains("::")
    });
    if is_field || is_name {
        return vec![tree.text()];
    }
    let mut all: Vec<String> = Vec::new();
    for name in tree.parts.iter().flat_map(names) {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    all
}

fn renamed(tree: &Tree, renames: &[(&String, &String)]) -> Tree {
    tree.mapped(&|it| {
        let renamed = renames.iter().find(|(old, _)| **old == it.text());
        renamed.map(|(_, new)| Tree::leaf(new))
    })
}
