//! Statements of a file in any language with infix signs, by the look of its lines.

use super::roots::Role;
use super::spelling::in_rust;
use super::tree::{Tree, squeezed};
use crate::sources::{Line, with_brackets};

/// A statement of a reader's.
pub(super) struct Statement {
    pub(super) line: Line,
    pub(super) role: Role,
    pub(super) value: Tree,
}

/// Reads what a file gives to names, returns, asks and calls.
pub(super) fn statements(name: &str, text: &str) -> Vec<Statement> {
    let is_python = name.ends_with(".py");
    let comment = if is_python { "#" } else { "//" };
    let mut all = Vec::new();
    let (mut open, mut first, mut depth) = (String::new(), 0, 0);
    let typed: Vec<&str> = text.lines().collect();
    for (n, line) in with_brackets(name, text).lines().enumerate() {
        let code = line.split(comment).next().unwrap_or_default().trim();
        if open.is_empty() {
            first = n;
        }
        if !open.is_empty() {
            open.push(' ');
        }
        open += code;
        let brackets = |signs: [char; 2]| code.matches(signs).count() as i32;
        depth += brackets(['(', '[']) - brackets([')', ']']);
        if depth > 0 || !is_python && !code.ends_with([';', '{', '}']) && !code.is_empty() {
            continue;
        }
        let line = Line {
            file: name.to_owned(),
            number: first + 1,
            text: squeezed(&typed[first..=n].join(" ")),
        };
        let values = values(&open, is_python).into_iter();
        all.extend(values.filter_map(|(role, value)| {
            let (line, value) = (line.clone(), in_rust(value.trim(), is_python)?);
            Some(Statement { line, role, value })
        }));
        (open, depth) = (String::new(), 0);
    }
    all
}

/// Finds the expressions of a statement, each with its role.
fn values(statement: &str, is_python: bool) -> Vec<(Role, &str)> {
    let mut all = Vec::new();
    let mut statement = bare(statement);
    while let Some(rest) = condition_of(statement) {
        // A statement may stand behind the condition.
        let end = if is_python {
            rest.find(": ")
        } else {
            closing(rest)
        };
        let (condition, rest) = rest.split_at(end.map_or(rest.len(), |at| at + 1));
        all.push((Role::Condition, condition.trim_end_matches(':')));
        statement = bare(rest);
    }
    if let Some(value) = statement.strip_prefix("return ") {
        all.push((Role::Result, value));
    } else if let Some((name, value)) = statement.split_once(" = ") {
        let name = name.rsplit([' ', '.', '>', '&']).next().unwrap_or(name);
        all.push((Role::Let(name.to_owned()), value));
    } else if statement.contains(['.', '>']) && statement.ends_with(')') {
        all.push((Role::Called, statement));
    }
    all
}

fn bare(statement: &str) -> &str {
    let statement = statement.trim_matches([' ', ';', '{', '}', ':']);
    statement.strip_prefix("else ").unwrap_or(statement)
}

/// Returns what stands behind `if` or `elif`.
fn condition_of(statement: &str) -> Option<&str> {
    let rest = statement.strip_prefix("el").unwrap_or(statement);
    rest.strip_prefix("if")
        .filter(|it| it.starts_with([' ', '(']))
}

/// Where the first bracket is closed.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0;
    let closed = text.char_indices().find(|(_, letter)| {
        depth += i32::from(*letter == '(') - i32::from(*letter == ')');
        depth == 0 && *letter == ')'
    });
    closed.map(|(at, _)| at)
}
