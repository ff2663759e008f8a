//! Edits of operators: another sign, sides left out or swapped, brackets lost or moved.

use std::collections::BTreeSet;
use std::ops::Range;

use syn::{Expr, ExprBinary, ExprCast, ExprUnary, UnOp};

use crate::hosts::{bytes, has_let};
use crate::maker::{Maker, outermost_places};
use crate::mistaken::{self, level};

/// The most names in an expression that are exchanged with each other.
const EXCHANGED: usize = 8;

impl<'a> Maker<'a> {
    pub(crate) fn binary(&mut self, it: &Expr, binary: &ExprBinary) {
        self.other_sign(it, binary);
        if level(self.source(&binary.op)) == 0 || has_let(it) {
            return;
        }
        self.without_a_side(it, binary);
        self.other_sides(it, binary);
        self.other_brackets(it, binary);
        let sign = self.source(&binary.op);
        if level(sign) == 3 {
            self.put(it, "true", 6);
            self.put(it, "false", 8);
        }
        if level(sign) >= 4 && !self.hosts.is_operand(it) {
            self.put_signed(it, format!("-({})", self.source(it)), 5);
            self.forgotten(it);
        }
    }

    /// Puts other operators in the place of one, also where they bind less or more firmly.
    fn other_sign(&mut self, it: &Expr, binary: &ExprBinary) {
        let sign = self.source(&binary.op);
        let [left, right] = [&binary.left, &binary.right].map(|it| self.source(it));
        let [left_unit, right_unit] = [&binary.left, &binary.right].map(|it| self.side(it));
        for (new, rank) in mistaken::operators(sign) {
            if level(new) < level(sign) {
                self.put_operator(it, new, format!("{left} {new} {right}"), *rank);
                continue;
            }
            self.replace(bytes(&binary.op), *new, *rank);
            if level(new) > level(sign) {
                self.put_operator(it, new, format!("{left_unit} {new} {right_unit}"), rank + 1);
            }
        }
        self.other_sign_inside(it, binary);
    }

    /// Puts another operator in the place of one in a side where brackets were needed that nobody
    /// types: `a + b - c` for `a * b - c`.
    fn other_sign_inside(&mut self, it: &Expr, binary: &ExprBinary) {
        let outer = self.source(&binary.op);
        for (side, least) in [
            (&binary.left, level(outer)),
            (&binary.right, level(outer) + 1),
        ] {
            let Expr::Binary(inner) = &**side else {
                continue;
            };
            let place = bytes(&inner.op);
            let others = mistaken::operators(self.source(&inner.op)).iter();
            for (new, rank) in others.filter(|it| level(it.0) < least) {
                let sign = if level(new) < level(outer) {
                    new
                } else {
                    outer
                };
                let text = self.source_with(it, place.clone(), new);
                self.put_operator(it, sign, text, rank + 1);
            }
        }
    }

    /// Returns the text of a side, in brackets if it is an operator.
    fn side(&self, it: &Expr) -> String {
        match it {
            Expr::Binary(_) => format!("({})", self.source(it)),
            _ => self.source(it).to_owned(),
        }
    }

    /// Returns the text of an expression with another text for some bytes in it.
    fn source_with(&self, it: &Expr, at: Range<usize>, new: &str) -> String {
        let whole = bytes(it);
        let (before, after) = (whole.start..at.start, at.end..whole.end);
        [&self.text[before], new, &self.text[after]].concat()
    }

    /// Leaves a side out, or all but one side of a side.
    fn without_a_side(&mut self, it: &Expr, binary: &ExprBinary) {
        for side in [&*binary.left, &*binary.right] {
            self.put_part(it, side, 5);
            if let Expr::Binary(inner) = without_brackets(side) {
                for part in [&inner.left, &inner.right] {
                    self.put_part(it, part, 7);
                }
            }
        }
    }

    /// Swaps the sides, or the right sides of both sides: `a * x + b * y` becomes `a * y + b * x`.
    fn other_sides(&mut self, it: &Expr, binary: &ExprBinary) {
        let sign = self.source(&binary.op);
        if ["-", "/", "%", "<", ">"].contains(&sign) {
            let [left, right] = [&binary.left, &binary.right].map(|it| self.unit(it));
            self.put_operator(it, sign, format!("{right} {sign} {left}"), 2);
        }
        if let (Expr::Binary(one), Expr::Binary(other)) = (&*binary.left, &*binary.right)
            && self.source(&one.op) == self.source(&other.op)
            && level(self.source(&one.op)) > level(sign)
        {
            let (a, x) = (self.source(&one.left), self.source(&one.right));
            let (b, y) = (self.source(&other.left), self.source(&other.right));
            let inner = self.source(&one.op);
            self.put_operator(
                it,
                sign,
                format!("{a} {inner} {y} {sign} {b} {inner} {x}"),
                3,
            );
        }
    }

    /// Moves brackets, or loses them.
    fn other_brackets(&mut self, it: &Expr, binary: &ExprBinary) {
        let sign = self.source(&binary.op);
        let [left, right] = [&binary.left, &binary.right].map(|it| self.source(it));
        if let Expr::Binary(inner) = &*binary.left {
            let [a, op, b] = self.parts_of(inner);
            self.put_operator(it, op, format!("{a} {op} ({b} {sign} {right})"), 3);
        }
        if let Expr::Binary(inner) = &*binary.right {
            let [a, op, b] = self.parts_of(inner);
            self.put_operator(it, op, format!("({left} {sign} {a}) {op} {b}"), 3);
        }
        for side in [&*binary.left, &*binary.right] {
            if let Expr::Paren(paren) = side
                && let Expr::Binary(inner) = &*paren.expr
            {
                let inner = self.source(&inner.op);
                let weaker = if level(inner) < level(sign) {
                    inner
                } else {
                    sign
                };
                let new = self.source_with(it, bytes(side), self.source(&paren.expr));
                self.put_operator(it, weaker, new, 3);
            }
        }
        if let Expr::MethodCall(call) = &*binary.right
            && call.args.is_empty()
        {
            let object = self.unit(&call.receiver);
            self.put(it, format!("({left} {sign} {object}).{}()", call.method), 4);
        }
        if let Expr::Unary(minus) = &*binary.left
            && let UnOp::Neg(_) = minus.op
        {
            let inner = self.source(&minus.expr);
            self.put_signed(it, format!("-({inner} {sign} {right})"), 4);
        }
    }

    fn parts_of(&self, it: &ExprBinary) -> [&'a str; 3] {
        [
            self.source(&it.left),
            self.source(&it.op),
            self.source(&it.right),
        ]
    }

    pub(crate) fn unary(&mut self, it: &Expr, unary: &ExprUnary) {
        let rank = match unary.op {
            UnOp::Deref(_) => 9,
            _ => 2,
        };
        self.put(it, self.source(&unary.expr), rank);
        if let (UnOp::Neg(_), Expr::Paren(paren)) = (&unary.op, &*unary.expr)
            && let Expr::Binary(inner) = &*paren.expr
        {
            let sign = self.source(&inner.op);
            self.put_operator(it, sign, format!("-{}", self.source(&paren.expr)), 3);
        }
    }

    /// Converts both sides of an operator instead of its result: `(a / b) as f64`.
    pub(crate) fn cast(&mut self, it: &Expr, cast: &ExprCast) {
        if let Expr::Binary(inner) = without_brackets(&cast.expr) {
            let [left, right] = [&inner.left, &inner.right].map(|it| self.unit(it));
            let (sign, to) = (self.source(&inner.op), self.source(&cast.ty));
            self.put_operator(
                it,
                sign,
                format!("{left} as {to} {sign} {right} as {to}"),
                3,
            );
        }
    }

    /// Negates a condition, or has it always hold or never.
    pub(crate) fn condition(&mut self, it: &Expr) {
        if has_let(it) {
            return;
        }
        self.put_signed(it, format!("!{}", self.unit(it)), 4);
        for new in ["true", "false"] {
            self.put(it, new, 8);
        }
    }

    /// Exchanges two names throughout an expression.
    pub(crate) fn exchanged(&mut self, it: &Expr) {
        if has_let(it) {
            return;
        }
        let found = outermost_places(it);
        let names = found.iter().map(|at| &self.text[at.clone()]);
        let names: BTreeSet<&str> = names.collect();
        let names: Vec<&str> = names.into_iter().take(EXCHANGED).collect();
        let start = bytes(it).start;
        for (n, one) in names.iter().enumerate() {
            for other in &names[..n] {
                let mut new = self.source(it).to_owned();
                for at in found.iter().rev() {
                    let place = at.start - start..at.end - start;
                    match &self.text[at.clone()] {
                        name if name == *one => new.replace_range(place, other),
                        name if name == *other => new.replace_range(place, one),
                        _ => {}
                    }
                }
                self.put(it, new, 3);
            }
        }
    }
}

fn without_brackets(it: &Expr) -> &Expr {
    match it {
        Expr::Paren(it) => &it.expr,
        it => it,
    }
}
