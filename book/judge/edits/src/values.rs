//! Edits of values: another number, another name, and what is forgotten around one.

use std::ops::Range;

use syn::{Expr, ExprIndex, ExprLit, Lit};

use crate::hosts::{bytes, is_place};
use crate::maker::Maker;
use crate::mistaken::{self, BOUNDS, FACTORS, FORGOTTEN};

impl Maker<'_> {
    pub(crate) fn literal(&mut self, it: &Expr, literal: &ExprLit) {
        let text = self.source(it);
        match &literal.lit {
            Lit::Float(number) => {
                let Ok(old) = number.base10_digits().parse() else {
                    return;
                };
                for (new, rank) in mistaken::numbers(old) {
                    self.put_signed(it, format!("{new:?}{}", number.suffix()), rank);
                }
                BOUNDS.into_iter().for_each(|bound| self.put(it, bound, 5));
                for name in self.names(text) {
                    self.put_operator(it, "*", format!("{text} * {name}"), 8);
                    self.put_operator(it, "/", format!("{name} / {text}"), 9);
                    self.put(it, name, 7);
                }
            }
            Lit::Int(number) => {
                let Ok(old) = number.base10_digits().parse() else {
                    return;
                };
                for new in mistaken::whole_numbers(old) {
                    self.put(it, format!("{new}{}", number.suffix()), 5);
                }
                self.names(text)
                    .into_iter()
                    .for_each(|name| self.put(it, name, 8));
            }
            Lit::Bool(truth) => self.put(it, (!truth.value).to_string(), 2),
            _ => {}
        }
    }

    /// Puts another name, or a field of another name, in the place of one.
    pub(crate) fn place(&mut self, it: &Expr) {
        let text = self.source(it);
        if let Expr::Field(field) = it {
            let name = self.source(&field.member);
            self.other_words(bytes(&field.member), name);
            let defined = self.defined;
            for new in defined.fields_beside(name) {
                self.replace(bytes(&field.member), new, 4);
            }
        }
        let last = |name: &str| name.rsplit('.').next().map(str::to_owned);
        for name in self.names(text) {
            let rank = if last(&name) == last(text) { 4 } else { 5 };
            self.put(it, name, rank);
        }
        self.put_signed(it, format!("-{text}"), 4);
        self.forgotten(it);
    }

    /// Puts another element in the place of one.
    pub(crate) fn indexed(&mut self, it: &Expr, index: &ExprIndex) {
        self.other_words(bytes(&index.index), self.source(&index.index));
        self.put_signed(it, format!("-{}", self.source(it)), 4);
        self.forgotten(it);
    }

    /// Adds a call, factor or term that is forgotten around an expression.
    pub(crate) fn forgotten(&mut self, it: &Expr) {
        self.forgotten_call(it);
        let unit = self.unit(it);
        for factor in FACTORS {
            self.put_operator(it, "*", format!("{factor} * {unit}"), 7);
        }
        if !is_place(it) {
            for name in self.names("") {
                for sign in ["-", "*", "/", "+"] {
                    self.put_operator(it, sign, format!("{unit} {sign} {name}"), 9);
                }
            }
            return;
        }
        self.put_operator(it, "*", format!("{unit} * {unit}"), 5);
        self.put_operator(it, "/", format!("1.0 / {unit}"), 6);
        for name in self.unused() {
            self.put_operator(it, "*", format!("{name} * {unit}"), 4);
            self.put_operator(it, "-", format!("{unit} - {name}"), 4);
            self.put_operator(it, "+", format!("{unit} + {name}"), 5);
        }
    }

    fn forgotten_call(&mut self, it: &Expr) {
        let (unit, source, defined) = (self.unit(it), self.source(it), self.defined);
        for (name, rank) in FORGOTTEN {
            self.put(it, format!("{unit}.{name}()"), rank);
        }
        let is_new = |name: &&str| FORGOTTEN.iter().all(|it| it.0 != *name);
        for name in defined.methods(0).filter(is_new) {
            self.put(it, format!("{unit}.{name}()"), 6);
        }
        let own = defined.functions.iter();
        for function in own.filter(|it| !it.is_method && it.parameters.len() == 1) {
            self.put(it, format!("{}({source})", function.name), 7);
        }
        if self.is_in_scope("self") {
            for name in defined.methods(1) {
                self.put(it, format!("self.{name}({source})"), 8);
            }
        }
        if let Expr::Call(_) | Expr::MethodCall(_) = it {
            self.put(it, format!("{unit}.filter(|&t| t > 0.0)"), 9);
        }
    }

    /// Puts the words that are taken for a field or method in its place.
    pub(crate) fn other_words(&mut self, at: Range<usize>, old: &str) {
        for (new, rank) in mistaken::words(old) {
            self.replace(at.clone(), new, rank);
        }
    }
}
