//! Syntax trees with holes: a node is its text without its parts, so that the expressions of two
//! programs can be compared, given other names, and written again.

use std::ops::Range;

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Block, Expr, FieldValue, Pat, Stmt, Type};

/// Stands for a part in the text of a node.
const HOLE: char = '□';
/// The text of a block, whatever number of statements it has.
const BLOCK: &str = "{…}";

/// A part of a function.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    /// Its text with a hole for each part, such as `□ + □`.
    pub(super) op: String,
    pub(super) parts: Vec<Tree>,
    /// Where it stands in the text of its function.
    pub(super) at: Range<usize>,
}

impl Tree {
    /// A tree that stands nowhere yet.
    pub(super) fn new(op: &str, parts: Vec<Self>) -> Self {
        let op = op.to_owned();
        Self {
            op,
            parts,
            at: 0..0,
        }
    }

    pub(super) fn is_block(&self) -> bool {
        self.op == BLOCK
    }

    /// The sign between its two parts, if it is one.
    pub(super) fn sign(&self) -> Option<&str> {
        let sign = self.op.strip_prefix("□ ")?.strip_suffix(" □")?;
        Some(sign).filter(|sign| self.parts.len() == 2 && !sign.contains(' '))
    }

    /// The name of the method that is called, or of the field that is taken.
    pub(super) fn member(&self) -> Option<&str> {
        let name = self.op.strip_prefix("□.")?;
        Some(name.split('(').next().unwrap_or(name))
    }

    /// All nodes, each before its parts.
    pub(super) fn nodes(&self) -> Vec<&Self> {
        let parts = self.parts.iter().flat_map(Self::nodes);
        [self].into_iter().chain(parts).collect()
    }

    pub(super) fn is_same(&self, other: &Self) -> bool {
        let mut parts = self.parts.iter().zip(&other.parts);
        self.op == other.op
            && self.parts.len() == other.parts.len()
            && parts.all(|(one, other)| one.is_same(other))
    }

    /// How much two trees have in common, from 0 to 1.
    pub(super) fn likeness(&self, other: &Self) -> f64 {
        let ops = |tree: &Self| -> Vec<String> {
            tree.nodes().iter().map(|node| node.op.clone()).collect()
        };
        likeness(&ops(self), &ops(other))
    }

    /// The tree with another in one place.
    pub(super) fn with(&self, at: &Range<usize>, new: &Self) -> Self {
        if self.at == *at {
            return new.clone();
        }
        let parts = self.parts.iter().map(|part| part.with(at, new));
        Self {
            parts: parts.collect(),
            ..self.clone()
        }
    }

    /// How firmly it holds together: a part needs brackets if it holds less firmly than its
    /// place wants.
    fn level(&self) -> u8 {
        match self.sign() {
            Some("||") => 1,
            Some("&&") => 2,
            Some("<" | ">" | "<=" | ">=" | "==" | "!=") => 3,
            Some("+" | "-") => 5,
            Some("*" | "/" | "%") => 6,
            Some(_) => 0,
            None if self.op.starts_with("let ") => 3,
            None if self.op.starts_with("□ as ") => 7,
            None if self.op.starts_with(['-', '!', '&']) => 8,
            None if self.op.starts_with('|') || self.op.contains("□..") => 0,
            None if self.op.starts_with("if ") || self.op.starts_with("return") => 0,
            None => ATOM,
        }
    }

    /// How firm its nth part has to be.
    pub(super) fn least(&self, n: usize) -> u8 {
        let is_object = n == 0 && ["□.", "□?", "□["].iter().any(|it| self.op.starts_with(it));
        match self.level() {
            ATOM if is_object => ATOM,
            0 | ATOM => 0,
            level if self.sign().is_some() => level + n.min(1) as u8,
            level => level,
        }
    }

    /// Its text, in brackets where the place wants a firmer one.
    pub(super) fn within(&self, least: u8) -> String {
        let text = self.text();
        if self.level() < least {
            format!("({text})")
        } else {
            text
        }
    }

    pub(super) fn text(&self) -> String {
        if self.is_block() {
            let all: Vec<String> = self.parts.iter().map(Self::text).collect();
            return format!("{{ {} }}", all.join(" "));
        }
        let mut pieces = self.op.split(HOLE);
        let mut text = pieces.next().unwrap_or_default().to_owned();
        for (n, (part, piece)) in self.parts.iter().zip(pieces).enumerate() {
            text += &part.within(self.least(n));
            text += piece;
        }
        text
    }
}

/// What needs no brackets anywhere.
pub(super) const ATOM: u8 = 9;

/// How many of two lists' members are the same, from 0 to 1 (Dice, 1945).
pub(super) fn likeness(one: &[String], other: &[String]) -> f64 {
    let mut left = other.to_vec();
    let is_taken = |it: &&String| {
        let at = left.iter().position(|other| other == *it);
        at.map(|at| left.swap_remove(at)).is_some()
    };
    let same = one.iter().filter(is_taken).count();
    2.0 * same as f64 / (one.len() + other.len()).max(1) as f64
}

/// Reads the trees of a function.
pub(super) struct Reader<'a> {
    /// The text of the file.
    pub(super) text: &'a str,
    /// Where the function begins.
    pub(super) start: usize,
}

impl Reader<'_> {
    pub(super) fn block(&self, block: &Block) -> Tree {
        Tree {
            op: BLOCK.to_owned(),
            parts: block.stmts.iter().map(|it| self.statement(it)).collect(),
            at: self.place(block),
        }
    }

    fn statement(&self, statement: &Stmt) -> Tree {
        match statement {
            Stmt::Local(local) => {
                let value = local.init.iter().map(|init| self.expression(&init.expr));
                self.node(statement, value.collect())
            }
            Stmt::Expr(it, Some(_)) => self.node(statement, vec![self.expression(it)]),
            Stmt::Expr(it, None) => self.expression(it),
            _ => self.node(statement, Vec::new()),
        }
    }

    pub(super) fn expression(&self, it: &Expr) -> Tree {
        match it {
            Expr::Paren(inner) => Tree {
                at: self.place(it),
                ..self.expression(&inner.expr)
            },
            Expr::Block(it) => self.block(&it.block),
            Expr::Range(_) => self.node(it, Vec::new()),
            _ => {
                let mut parts = Parts {
                    reader: self,
                    found: Vec::new(),
                };
                visit::visit_expr(&mut parts, it);
                self.node(it, parts.found)
            }
        }
    }

    /// A node whose parts stand in this order in its text.
    fn node(&self, it: &impl Spanned, parts: Vec<Tree>) -> Tree {
        let at = self.place(it);
        let mut op = String::new();
        let mut before = at.start;
        for part in &parts {
            op += &self.text[self.start + before..self.start + part.at.start.max(before)];
            op.push(HOLE);
            before = part.at.end;
        }
        op += &self.text[self.start + before..self.start + at.end.max(before)];
        // A sign stands apart, whether the reader has left room for it or not.
        let op = squeezed(&op);
        let is_sign = |sign: &&str| sign.chars().all(|c| "+-*/%<>=!&|".contains(c));
        let sign = op.strip_prefix(HOLE).and_then(|it| it.strip_suffix(HOLE));
        let sign = sign
            .map(str::trim)
            .filter(|sign| !sign.is_empty())
            .filter(is_sign);
        let op = sign.map_or(op.clone(), |sign| format!("{HOLE} {sign} {HOLE}"));
        Tree { op, parts, at }
    }

    fn place(&self, it: &impl Spanned) -> Range<usize> {
        let at = it.span().byte_range();
        at.start - self.start..at.end - self.start
    }
}

/// The parts of an expression in their order, each with its own.
struct Parts<'a> {
    reader: &'a Reader<'a>,
    found: Vec<Tree>,
}

impl<'a> Visit<'a> for Parts<'_> {
    fn visit_expr(&mut self, it: &'a Expr) {
        self.found.push(self.reader.expression(it));
    }

    fn visit_block(&mut self, it: &'a Block) {
        self.found.push(self.reader.block(it));
    }

    /// A field that is given a name of its own is written out.
    fn visit_field_value(&mut self, it: &'a FieldValue) {
        let member = &self.reader.text[it.member.span().byte_range()];
        self.found.push(Tree {
            op: format!("{member}: {HOLE}"),
            parts: vec![self.reader.expression(&it.expr)],
            at: self.reader.place(it),
        });
    }

    fn visit_pat(&mut self, it: &'a Pat) {
        if let Pat::Guard(it) = it {
            self.visit_expr(&it.guard);
        }
    }

    fn visit_type(&mut self, _: &'a Type) {}
}

/// On one line, without comments, and with blanks where rustfmt has them.
pub(super) fn squeezed(text: &str) -> String {
    let code = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or(line));
    let words: Vec<&str> = code.flat_map(str::split_whitespace).collect();
    let mut text = words.join(" ");
    for (loose, tight) in [
        ("( ", "("),
        (", )", ")"),
        (",)", ")"),
        (" )", ")"),
        (", }", " }"),
        (" .", "."),
        (",..", ", .."),
        (" ,", ","),
        (",□", ", □"),
    ] {
        text = text.replace(loose, tight);
    }
    text
}
