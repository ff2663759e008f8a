//! Hosts: which expressions may be written as a choice between alternatives.
//!
//! No host is a place (`self.x` before a method, behind `&`, left of `=`), since a choice would move
//! what is there; nor a reference, a closure, a jump, or a condition with `let`. An edit in one of
//! these has the next expression, statement or block around it as its host.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use syn::spanned::Spanned;
use syn::{Expr, UnOp};

use crate::mistaken::level;
use crate::{Form, Host};

/// The hosts around a place of a text, and what is known of the expressions in it.
#[derive(Default)]
pub(crate) struct Hosts {
    /// The hosts, each inside of the one before.
    stack: Vec<Host>,
    /// Expressions that are no hosts where they stand.
    bare: HashSet<Range<usize>>,
    /// Operands, each with the least [`level`] of an operator that needs no brackets in its place.
    operands: HashMap<Range<usize>, u32>,
    /// Expressions before a dot or the like, in whose place a sign needs brackets, too.
    objects: HashSet<Range<usize>>,
    /// True inside of a reference to a constant, which a choice would make temporary.
    pub(crate) is_sealed: bool,
}

/// Returns the bytes of a part of a text.
pub(crate) fn bytes(it: &impl Spanned) -> Range<usize> {
    it.span().byte_range()
}

impl Hosts {
    pub(crate) fn open(&mut self, at: Range<usize>, form: Form) {
        self.stack.push(Host { at, form });
    }

    /// Opens a host at an expression if it may be one, and returns true if so.
    pub(crate) fn open_expression(&mut self, it: &Expr) -> bool {
        let in_constant = self.stack.last().is_none_or(|it| it.form == Form::Constant);
        let is_host = !in_constant && !self.is_sealed && can_be_host(it);
        let is_host = is_host && !self.bare.contains(&bytes(it));
        if is_host {
            self.open(bytes(it), Form::Expression);
        }
        is_host
    }

    pub(crate) fn close(&mut self) {
        self.stack.pop();
    }

    /// Returns the innermost host.
    pub(crate) fn innermost(&self) -> Option<&Host> {
        self.stack.last()
    }

    /// Returns the innermost host that is no expression, so that an alternative may have another
    /// type.
    pub(crate) fn of_any_type(&self) -> Option<&Host> {
        self.stack
            .iter()
            .rev()
            .find(|it| it.form != Form::Expression)
    }

    /// Forgets the hosts around an inner function, and returns them.
    pub(crate) fn take(&mut self) -> Vec<Host> {
        std::mem::take(&mut self.stack)
    }

    pub(crate) fn put_back(&mut self, hosts: Vec<Host>) {
        self.stack = hosts;
    }

    pub(crate) fn set_bare(&mut self, it: &Expr) {
        self.bare.insert(bytes(it));
    }

    pub(crate) fn is_operand(&self, it: &Expr) -> bool {
        self.operands.contains_key(&bytes(it))
    }

    /// Returns the least [`level`] of an operator that needs no brackets in the place of `it`.
    pub(crate) fn least_level(&self, it: &Expr) -> u32 {
        self.operands.get(&bytes(it)).copied().unwrap_or(0)
    }

    pub(crate) fn is_object(&self, it: &Expr) -> bool {
        self.objects.contains(&bytes(it))
    }

    /// Notes of the parts of an expression which are no hosts, and which need brackets.
    pub(crate) fn look_into(&mut self, it: &Expr, text: &str) {
        for part in bare_parts(it, text) {
            self.set_bare(part);
        }
        let operands = operands(it, text).into_iter();
        self.operands
            .extend(operands.map(|(it, least)| (bytes(it), least)));
        self.objects.extend(object_of(it).map(bytes));
    }
}

/// Lists the parts of an expression that are no hosts there.
fn bare_parts<'e>(it: &'e Expr, text: &str) -> Vec<&'e Expr> {
    let if_place = |it| is_location(it).then_some(it).into_iter().collect();
    match it {
        Expr::MethodCall(it) => if_place(&it.receiver),
        Expr::Reference(it) => if_place(&it.expr),
        Expr::Field(it) => if_place(&it.base),
        Expr::Match(it) => if_place(&it.expr),
        Expr::Let(it) => if_place(&it.expr),
        // A number in brackets has its type from there.
        Expr::Index(it) => vec![&it.expr, &it.index],
        Expr::Assign(it) => vec![&it.left],
        Expr::Call(it) => vec![&it.func],
        Expr::Unary(it) if matches!(it.op, UnOp::Deref(_)) => vec![&it.expr],
        Expr::If(it) => it.else_branch.iter().map(|it| &*it.1).collect(),
        Expr::Binary(it) if level(&text[bytes(&it.op)]) == 0 => vec![&it.left],
        _ => Vec::new(),
    }
}

/// Lists the operands of an expression, each with the least [`level`] that needs no brackets.
fn operands<'e>(it: &'e Expr, text: &str) -> Vec<(&'e Expr, u32)> {
    const ATOM: u32 = 6;
    match it {
        Expr::MethodCall(it) => vec![(&it.receiver, ATOM)],
        Expr::Reference(it) => vec![(&it.expr, ATOM)],
        Expr::Unary(it) => vec![(&it.expr, ATOM)],
        Expr::Cast(it) => vec![(&it.expr, ATOM)],
        Expr::Try(it) => vec![(&it.expr, ATOM)],
        Expr::Binary(it) => {
            // Comparisons don't follow each other.
            let level = level(&text[bytes(&it.op)]);
            vec![
                (&it.left, level + u32::from(level == 3)),
                (&it.right, level + 1),
            ]
        }
        _ => Vec::new(),
    }
}

/// Returns the part that stands before a dot, an index or a question mark.
fn object_of(it: &Expr) -> Option<&Expr> {
    match it {
        Expr::MethodCall(it) => Some(&it.receiver),
        Expr::Field(it) => Some(&it.base),
        Expr::Index(it) => Some(&it.expr),
        Expr::Try(it) => Some(&it.expr),
        _ => None,
    }
}

fn can_be_host(it: &Expr) -> bool {
    let is_no_value = matches!(
        it,
        Expr::Reference(_)
            | Expr::Closure(_)
            | Expr::Return(_)
            | Expr::Break(_)
            | Expr::Continue(_)
            | Expr::Assign(_)
            | Expr::Block(_)
            | Expr::Unsafe(_)
            | Expr::Range(_)
    );
    !is_no_value && !has_let(it)
}

/// Returns true if the expression names a location, which must not be moved out of in some places.
fn is_location(it: &Expr) -> bool {
    match it {
        Expr::Path(_) | Expr::Field(_) | Expr::Index(_) => true,
        Expr::Unary(it) => matches!(it.op, UnOp::Deref(_)),
        Expr::Paren(it) => is_location(&it.expr),
        _ => false,
    }
}

/// Returns true for a variable, a constant, or a field of one.
pub(crate) fn is_place(it: &Expr) -> bool {
    match it {
        Expr::Path(it) => {
            let last = it.path.segments.last().map(|it| it.ident.to_string());
            let last = last.unwrap_or_default();
            let is_variable = it.path.segments.len() == 1;
            it.qself.is_none() && (is_variable || last == last.to_uppercase()) && last != "None"
        }
        Expr::Field(it) => is_place(&it.base),
        _ => false,
    }
}

/// Returns true if a condition gives something a name, or has a part that does.
pub(crate) fn has_let(it: &Expr) -> bool {
    match it {
        Expr::Let(_) => true,
        Expr::Binary(it) => has_let(&it.left) || has_let(&it.right),
        _ => false,
    }
}

/// Returns true if the expression needs no brackets anywhere.
pub(crate) fn is_unit(it: &Expr) -> bool {
    matches!(
        it,
        Expr::Lit(_)
            | Expr::Path(_)
            | Expr::MethodCall(_)
            | Expr::Call(_)
            | Expr::Field(_)
            | Expr::Paren(_)
            | Expr::Index(_)
            | Expr::Macro(_)
            | Expr::Array(_)
            | Expr::Tuple(_)
    )
}
