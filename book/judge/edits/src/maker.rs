//! The state of a walk through one text: names in scope, hosts, and the edits so far.

use std::collections::HashSet;
use std::ops::Range;

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Block, Expr, ExprCall};

use crate::hosts::{Hosts, bytes, is_place, is_unit};
use crate::mistaken::level;
use crate::{ConstantUse, Defined, Edit, Host};

/// Makes the edits of one text.
pub(crate) struct Maker<'a> {
    pub(crate) file: usize,
    pub(crate) text: &'a str,
    pub(crate) defined: &'a Defined,
    pub(crate) edits: Vec<Edit>,
    pub(crate) uses: Vec<ConstantUse>,
    pub(crate) hosts: Hosts,
    /// The bytes of the function or constant that is walked through.
    pub(crate) function: Range<usize>,
    /// The names in scope, the last declared at the end.
    pub(crate) scope: Vec<Local>,
    /// What the function reads: variables, fields and constants, as they are written there.
    pub(crate) places: Vec<String>,
    /// The fields of `Self`.
    fields: &'a [String],
}

/// A variable in scope.
#[derive(Clone, Debug)]
pub(crate) struct Local {
    pub(crate) name: String,
    pub(crate) is_mut: bool,
}

impl<'a> Maker<'a> {
    pub(crate) fn new(file: usize, text: &'a str, defined: &'a Defined) -> Self {
        Self {
            file,
            text,
            defined,
            edits: Vec::new(),
            uses: Vec::new(),
            hosts: Hosts::default(),
            function: 0..0,
            scope: Vec::new(),
            places: Vec::new(),
            fields: &[],
        }
    }

    /// Goes on with the methods of a type.
    pub(crate) fn of_type(&mut self, name: &str) {
        self.fields = self.defined.fields_of(name);
    }

    /// Returns the text of a part.
    pub(crate) fn source(&self, it: &impl Spanned) -> &'a str {
        &self.text[bytes(it)]
    }

    /// Returns the text of an expression, in brackets if it is an operator or the like.
    pub(crate) fn unit(&self, it: &Expr) -> String {
        match is_unit(it) {
            true => self.source(it).to_owned(),
            false => format!("({})", self.source(it)),
        }
    }

    /// Replaces a part of an expression, whose type may not change.
    pub(crate) fn replace(&mut self, at: Range<usize>, new: impl Into<String>, rank: u32) {
        let host = self.hosts.innermost().cloned();
        self.push(host, at, new.into(), rank);
    }

    /// Replaces a part of a statement or block; the types of its expressions may change.
    pub(crate) fn replace_widely(&mut self, at: Range<usize>, new: impl Into<String>, rank: u32) {
        let host = self.hosts.of_any_type().cloned();
        self.push(host, at, new.into(), rank);
    }

    /// Replaces an expression by one that needs no brackets.
    pub(crate) fn put(&mut self, it: &Expr, new: impl Into<String>, rank: u32) {
        self.replace(bytes(it), new, rank);
    }

    /// Replaces an expression by one whose weakest operator is `sign`, in brackets where these are
    /// needed.
    pub(crate) fn put_operator(&mut self, it: &Expr, sign: &str, new: String, rank: u32) {
        let new = match level(sign) < self.hosts.least_level(it) {
            true => format!("({new})"),
            false => new,
        };
        self.put(it, new, rank);
    }

    /// Replaces an expression by one with a sign before it, in brackets where these are needed.
    pub(crate) fn put_signed(&mut self, it: &Expr, new: String, rank: u32) {
        let new = match self.hosts.is_object(it) {
            true => format!("({new})"),
            false => new,
        };
        self.put(it, new, rank);
    }

    /// Replaces an expression by a part of it.
    pub(crate) fn put_part(&mut self, it: &Expr, part: &Expr, rank: u32) {
        let new = self.source(part).to_owned();
        match part {
            Expr::Unary(_) => self.put_signed(it, new, rank),
            Expr::Binary(part) => self.put_operator(it, self.source(&part.op), new, rank),
            part if is_unit(part) => self.put(it, new, rank),
            _ => self.put_operator(it, "", new, rank),
        }
    }

    fn push(&mut self, host: Option<Host>, at: Range<usize>, new: String, rank: u32) {
        let old = &self.text[at.clone()];
        let Some(host) = host.filter(|_| old != new) else {
            return;
        };
        let is_number = old.starts_with(|it: char| it.is_ascii_digit());
        let has_type = new.starts_with(char::is_alphabetic) || new.contains(['*', '/']);
        self.edits.push(Edit {
            file: self.file,
            at,
            new,
            rank,
            function: self.function.clone(),
            host,
            gives_type: is_number && has_type,
        });
    }

    /// Lists the names and fields that may stand in the place of `but`, the likeliest first.
    pub(crate) fn names(&self, but: &str) -> Vec<String> {
        let is_known = |it: &&String| {
            let root = it.split(['.', '[', ':']).next().unwrap_or_default();
            let is_constant = it.contains("::") || self.defined.constants.contains(root);
            is_constant || self.is_in_scope(root)
        };
        let read = self.places.iter().filter(is_known).cloned();
        let declared = self.scope.iter().rev().map(|it| it.name.clone());
        let fields = self.fields.iter().filter(|_| self.is_in_scope("self"));
        let fields = fields.map(|it| format!("self.{it}"));
        let mut seen = HashSet::from([but.to_owned(), "self".to_owned()]);
        let mut all: Vec<String> = read.chain(declared).chain(fields).collect();
        all.retain(|it| !it.starts_with('_') && seen.insert(it.clone()));
        all
    }

    /// Lists the names in scope that the function has once only: it seems to forget them.
    pub(crate) fn unused(&self) -> Vec<String> {
        let text = &self.text[self.function.clone()];
        let words: Vec<&str> = text
            .split(|it: char| !it.is_alphanumeric() && it != '_')
            .collect();
        let count = |name: &str| words.iter().filter(|it| **it == name).count();
        let names = self.scope.iter().map(|it| it.name.clone());
        names
            .filter(|name| name != "self" && count(name) == 1)
            .collect()
    }

    /// Lists the names in scope that are `mut`.
    pub(crate) fn mutable(&self) -> Vec<String> {
        let mutable = self.scope.iter().filter(|it| it.is_mut);
        mutable.map(|it| it.name.clone()).collect()
    }

    pub(crate) fn is_in_scope(&self, name: &str) -> bool {
        self.scope.iter().any(|it| it.name == name)
    }

    /// Lists what a function's body reads, and the constants beside it.
    pub(crate) fn places_in(&self, block: &Block) -> Vec<String> {
        let mut places = Places(Vec::new());
        places.visit_block(block);
        let read = places.0.into_iter().map(|at| self.text[at].to_owned());
        let is_here = |it: &&String| self.text.contains(&format!("const {it}:"));
        let constants = self.defined.constants.iter().filter(is_here);
        let mut constants: Vec<String> = constants.cloned().collect();
        constants.sort();
        read.chain(constants).collect()
    }
}

/// The bytes of all variables, constants and fields in a part of a text, and of the places inside
/// of these.
struct Places(Vec<Range<usize>>);

impl<'a> Visit<'a> for Places {
    fn visit_expr(&mut self, it: &'a Expr) {
        if is_place(it) {
            self.0.push(bytes(it));
        }
        visit::visit_expr(self, it);
    }

    /// A function's name is no place.
    fn visit_expr_call(&mut self, it: &'a ExprCall) {
        it.args.iter().for_each(|it| self.visit_expr(it));
    }
}

/// Lists the bytes of the outermost variables, constants and fields in an expression.
pub(crate) fn outermost_places(it: &Expr) -> Vec<Range<usize>> {
    let mut places = Places(Vec::new());
    places.visit_expr(it);
    let mut outer: Vec<Range<usize>> = Vec::new();
    for at in places.0 {
        // Each stands before those inside of it.
        if outer.last().is_none_or(|it| at.start >= it.end) {
            outer.push(at);
        }
    }
    outer
}
