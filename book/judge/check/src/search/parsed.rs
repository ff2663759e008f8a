//! Conversion of the syntax trees that `syn` reads.

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Block, Expr, FieldValue, Pat, Stmt, Type};

use super::tree::{BoundName, RustOp, RustTree};
use crate::sources::squeezed;

/// Converts the syntax trees of `syn` to those of this search.
pub(super) struct Reader<'a> {
    /// The text from which `syn` has read.
    pub(super) text: &'a str,
}

impl Reader<'_> {
    /// Converts a block.
    pub(super) fn block(&self, block: &Block) -> RustTree {
        let statements = block.stmts.iter().map(|it| self.statement(it));
        node(block, RustOp::Block, statements.collect())
    }

    /// Converts a statement.
    fn statement(&self, statement: &Stmt) -> RustTree {
        match statement {
            Stmt::Local(local) => match &local.init {
                Some(init) if init.diverge.is_none() => {
                    let op = RustOp::Let(self.pattern(&local.pat), true);
                    node(statement, op, vec![self.expression(&init.expr)])
                }
                _ => self.other(statement, Vec::new()),
            },
            Stmt::Expr(it, Some(_)) => {
                node(statement, RustOp::Statement, vec![self.expression(it)])
            }
            Stmt::Expr(it, None) => self.expression(it),
            _ => self.other(statement, Vec::new()),
        }
    }

    /// Converts an expression; brackets around it become a part of its place.
    pub(super) fn expression(&self, it: &Expr) -> RustTree {
        let text = |it: &dyn Spanned| squeezed(&self.text[it.span().byte_range()]);
        let op = match it {
            Expr::Paren(inner) => {
                return RustTree {
                    at: it.span().byte_range(),
                    ..self.expression(&inner.expr)
                };
            }
            Expr::Block(it) => return self.block(&it.block),
            Expr::Binary(it) => RustOp::Sign(text(&it.op)),
            Expr::Assign(_) => RustOp::Sign("=".to_owned()),
            Expr::Range(range) if range.start.is_some() && range.end.is_some() => {
                RustOp::Sign(text(&range.limits))
            }
            Expr::Unary(it) => RustOp::Prefix(text(&it.op)),
            Expr::Reference(it) if it.mutability.is_none() => RustOp::Prefix("&".to_owned()),
            Expr::MethodCall(it) if it.turbofish.is_none() => RustOp::Method(it.method.to_string()),
            Expr::Field(it) => RustOp::Field(text(&it.member)),
            Expr::Call(_) => RustOp::Call,
            Expr::Let(it) => RustOp::Let(self.pattern(&it.pat), false),
            Expr::ForLoop(it) => RustOp::For(self.pattern(&it.pat)),
            Expr::If(_) => RustOp::If,
            Expr::While(_) => RustOp::While,
            Expr::Return(it) if it.expr.is_some() => RustOp::Return,
            _ => return self.other(it, self.parts(it)),
        };
        node(it, op, self.parts(it))
    }

    /// Converts a pattern.
    fn pattern(&self, it: &Pat) -> BoundName {
        BoundName::of(&squeezed(&self.text[it.span().byte_range()]))
    }

    /// Converts the parts of an expression, in their order.
    fn parts(&self, it: &Expr) -> Vec<RustTree> {
        let mut parts = Parts {
            reader: self,
            found: Vec::new(),
        };
        visit::visit_expr(&mut parts, it);
        parts.found
    }

    /// Makes a node of the text between its parts; without parts a leaf.
    fn other(&self, it: &impl Spanned, parts: Vec<RustTree>) -> RustTree {
        const PART: char = '\0';
        let at = it.span().byte_range();
        let mut text = String::new();
        let mut before = at.start;
        for part in &parts {
            text += &self.text[before..part.at.start.max(before)];
            text.push(PART);
            before = part.at.end;
        }
        text += &self.text[before..at.end.max(before)];
        let text = squeezed(&text);
        let op = if parts.is_empty() {
            RustOp::Leaf(text)
        } else {
            RustOp::Other(text.split(PART).map(str::to_owned).collect())
        };
        RustTree { op, parts, at }
    }
}

/// Makes a node at the place of a syntax tree.
fn node(it: &impl Spanned, op: RustOp, parts: Vec<RustTree>) -> RustTree {
    let at = it.span().byte_range();
    RustTree { op, parts, at }
}

/// A visitor that converts the parts of an expression and does not go into them.
struct Parts<'a> {
    reader: &'a Reader<'a>,
    /// The parts that were visited.
    found: Vec<RustTree>,
}

impl<'a> Visit<'a> for Parts<'_> {
    fn visit_expr(&mut self, it: &'a Expr) {
        self.found.push(self.reader.expression(it));
    }

    fn visit_block(&mut self, it: &'a Block) {
        self.found.push(self.reader.block(it));
    }

    /// Converts a field of a new struct, also where only its name is written.
    fn visit_field_value(&mut self, it: &'a FieldValue) {
        let member = self.reader.text[it.member.span().byte_range()].to_owned();
        let value = vec![self.reader.expression(&it.expr)];
        self.found.push(node(it, RustOp::Member(member), value));
    }

    fn visit_pat(&mut self, it: &'a Pat) {
        if let Pat::Guard(it) = it {
            self.visit_expr(&it.guard);
        }
    }

    fn visit_type(&mut self, _: &'a Type) {}
}
