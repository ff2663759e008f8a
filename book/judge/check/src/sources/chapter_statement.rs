//! Statements of a chapter as patterns that a reader's statements are compared with.

use std::rc::Rc;

use language::{Language, Op, Pattern, Role, Tree, canonical, normal};

use super::likeness::likeness;
use super::{TypedStatement, is_same_name, read};

/// A statement of a chapter's function, with one expression.
#[derive(Clone)]
pub(super) struct ChapterStatement {
    /// The name of the function.
    pub(super) function: Rc<str>,
    /// The text of the function.
    pub(super) text: Rc<str>,
    /// The purpose of the expression.
    pub(super) role: Role,
    /// The expression as it is written in the text.
    pub(super) value: Tree,
    /// The expression, to be found in others.
    pub(super) pattern: Pattern,
}

/// Reads the statements of a function in Rust whose expression is more than a variable.
pub(super) fn chapter_statements(name: &str, text: &str) -> Vec<ChapterStatement> {
    let (name, function): (Rc<str>, Rc<str>) = (name.into(), text.into());
    let all = read(text, Language::Rust);
    let names = all.iter().flat_map(|it| {
        let given = match &it.role {
            Role::ValueOf(name) | Role::LoopOver(name) => Some(canonical(name)),
            _ => None,
        };
        names_in(&normal(&it.value)).into_iter().chain(given)
    });
    let known: Rc<[String]> = names.collect();
    let statements = all.iter().filter_map(|it| {
        let value = match &it.value.parts[..] {
            [inner] if it.value.is_call("Some") => inner,
            _ => &it.value,
        };
        let is_enough = !value.parts.is_empty() || matches!(value.op, Op::Number(..));
        is_enough.then(|| ChapterStatement {
            function: Rc::clone(&name),
            text: Rc::clone(&function),
            role: it.role.clone(),
            pattern: Pattern::new(value, Rc::clone(&known)),
            value: value.clone(),
        })
    });
    statements.collect()
}

impl ChapterStatement {
    /// Returns true if two statements have the same purpose and normal form.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.role == other.role && self.pattern.tree().is_same(other.pattern.tree())
    }

    /// Returns true if a statement with this purpose and normal form says what this one says, maybe
    /// as a part and under other names. `chapter` has all statements of the chapter.
    pub(super) fn is_said_by(&self, role: &Role, value: &Tree, chapter: &[Self]) -> bool {
        match (&self.role, role) {
            (Role::ValueOf(name), Role::ValueOf(own)) if !is_same_name(name, own) => {
                // The value is that of another variable of the chapter.
                let is_it = |it: &Self| matches!(&it.role, Role::ValueOf(other) if is_same_name(other, own));
                if self.pattern.is_small() {
                    return false;
                }
                if chapter.iter().any(is_it) {
                    let found = self.pattern.find(value);
                    return found.is_some_and(|it| !std::ptr::eq(it.tree, value));
                }
            }
            (Role::ValueOf(_), Role::ValueOf(_)) => {}
            _ if self.pattern.is_small() && self.role != *role => return false,
            _ => {}
        }
        self.pattern.find(value).is_some()
    }

    /// Returns the share of nodes that the statement and an expression in normal form have in
    /// common, from 0 to 1.
    pub(super) fn likeness(&self, other: &Tree) -> f64 {
        let ops =
            |tree: &Tree| -> Vec<Op> { tree.nodes().iter().map(|it| it.op.clone()).collect() };
        likeness(&ops(other), &ops(self.pattern.tree()))
    }

    /// Returns true if a reader's statement has the same purpose, the same name included.
    pub(super) fn has_role_of(&self, typed: &TypedStatement) -> bool {
        match (&self.role, &typed.role) {
            (Role::ValueOf(one), Role::ValueOf(other)) => is_same_name(one, other),
            (one, other) => one == other,
        }
    }
}

/// Lists the names in an expression, in the order in which they first occur.
pub(super) fn names_in(tree: &Tree) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for name in tree.nodes().into_iter().filter_map(Tree::name) {
        if !all.iter().any(|it| it == name) {
            all.push(name.to_owned());
        }
    }
    all
}
