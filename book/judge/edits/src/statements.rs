//! Edits of statements: one is left out, or one is missing.

use std::collections::BTreeSet;

use syn::{Expr, ExprAssign, ExprRange, ExprReturn, RangeLimits, Stmt};

use crate::Form;
use crate::hosts::bytes;
use crate::maker::Maker;

impl Maker<'_> {
    /// Adds a missing statement after each but a block's value, and before the first.
    pub(crate) fn missing_statements(&mut self, it: &Stmt, is_first: bool, is_last: bool) {
        if self.mutable().is_empty() {
            return;
        }
        let is_value = is_last && matches!(it, Stmt::Expr(_, None));
        let at = bytes(it);
        let places = [is_first.then_some(at.start), (!is_value).then_some(at.end)];
        let new = self.assignments();
        for place in places.into_iter().flatten() {
            self.hosts.open(place..place, Form::Statement);
            for statement in &new {
                self.replace(place..place, statement, 9);
            }
            self.hosts.close();
        }
    }

    /// Lists the statements that change a variable: it gets a value that is at hand, or a method
    /// is called whose arguments are all there.
    fn assignments(&self) -> Vec<String> {
        let fields = self.defined.fields();
        let locals = self.scope.iter().flat_map(|local| {
            let name = local.name.clone();
            fields.iter().map(move |field| format!("{name}.{field}"))
        });
        let names = self.names("").into_iter().filter(|it| !it.contains("::"));
        let values: BTreeSet<String> = names.chain(locals).collect();
        let mutable = self.mutable();
        let mut all = Vec::new();
        for value in &values {
            let others = mutable.iter().filter(|it| *it != value);
            all.extend(others.map(|it| format!("{it} = {value};")));
        }
        for it in self.defined.functions.iter().filter(|it| it.is_method) {
            let given = &it.parameters;
            if !given.is_empty() && given.iter().all(|it| self.is_in_scope(it)) {
                let call = format!("{}({});", it.name, given.join(", "));
                all.extend(mutable.iter().map(|it| format!("{it}.{call}")));
            }
        }
        all
    }

    /// Keeps a value instead of returning it at once.
    pub(crate) fn returned(&mut self, it: &Expr, back: &ExprReturn) {
        if let Some(value) = &back.expr {
            for name in self.mutable() {
                let new = format!("{name} = {}", self.source(value));
                self.replace_widely(bytes(it), new, 6);
            }
        }
    }

    /// Includes the end of a range or excludes it, or goes backwards.
    pub(crate) fn range(&mut self, it: &Expr, range: &ExprRange) {
        let new = match range.limits {
            RangeLimits::Closed(_) => "..",
            RangeLimits::HalfOpen(_) => "..=",
        };
        if range.end.is_some() {
            self.replace_widely(bytes(&range.limits), new, 4);
            self.replace_widely(bytes(it), format!("({}).rev()", self.source(it)), 5);
        }
    }

    /// Adds up instead of assigning.
    pub(crate) fn assigned(&mut self, assign: &ExprAssign) {
        for (new, rank) in [("+=", 3), ("-=", 5), ("*=", 5)] {
            self.replace(bytes(&assign.eq_token), new, rank);
        }
    }
}
