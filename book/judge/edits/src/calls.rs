//! Edits of calls: another method, the call without its method, the arguments elsewhere.

use syn::{Expr, ExprBinary, ExprCall, ExprMethodCall};

use crate::hosts::bytes;
use crate::maker::Maker;

/// Methods that change the type of an iterator, which only a whole statement may.
const ADAPTERS: [&str; 12] = [
    "rev",
    "map",
    "filter",
    "skip",
    "take",
    "step_by",
    "enumerate",
    "cloned",
    "copied",
    "zip",
    "chain",
    "filter_map",
];

/// Methods whose type what stands around them tells.
const OPEN: [&str; 8] = [
    "collect",
    "sum",
    "product",
    "into",
    "parse",
    "unwrap_or_default",
    "map",
    "flat_map",
];

impl Maker<'_> {
    pub(crate) fn call(&mut self, it: &Expr, call: &ExprCall) {
        let arguments: Vec<&Expr> = call.args.iter().collect();
        self.list(&arguments, 2);
        if let [one] = &arguments[..] {
            self.put_part(it, one, 7);
        }
        if self.source(&call.func) == "Some" {
            self.put(it, "None", 6);
        } else {
            self.put_signed(it, format!("-{}", self.source(it)), 5);
            self.forgotten(it);
        }
    }

    pub(crate) fn method_call(&mut self, it: &Expr, call: &ExprMethodCall) {
        let name = call.method.to_string();
        self.other_methods(call, &name);
        let object = self.source(&call.receiver);
        if ADAPTERS.contains(&&*name) {
            self.replace_widely(bytes(it), object, 4);
        } else {
            self.put(it, object, 4);
        }
        let arguments: Vec<&Expr> = call.args.iter().collect();
        self.list(&arguments, 2);
        if let [one] = &arguments[..]
            && !matches!(one, Expr::Closure(_))
        {
            self.put(it, format!("{}.{name}({object})", self.unit(one)), 5);
            let all = [&*call.receiver, one];
            for argument in all {
                let [a, b] = [self.unit(argument), self.source(argument).to_owned()];
                self.put(it, format!("{a}.{name}({b})"), 7);
            }
        }
        if let Expr::Paren(paren) = &*call.receiver
            && let Expr::Binary(inner) = &*paren.expr
            && arguments.is_empty()
        {
            let (left, sign) = (self.source(&inner.left), self.source(&inner.op));
            let right = self.unit(&inner.right);
            self.put_operator(it, sign, format!("{left} {sign} {right}.{name}()"), 5);
        }
        self.ordered(it, &name, object);
        if !OPEN.contains(&&*name) {
            self.put_signed(it, format!("-{}", self.source(it)), 5);
            self.forgotten(it);
        }
    }

    /// Calls another method, with the arguments as they are.
    fn other_methods(&mut self, call: &ExprMethodCall, name: &str) {
        self.other_words(bytes(&call.method), name);
        let defined = self.defined;
        for new in defined.methods(call.args.len()) {
            self.replace(bytes(&call.method), new, 6);
        }
    }

    /// Takes the least by a field instead of the first or the last.
    fn ordered(&mut self, it: &Expr, name: &str, object: &str) {
        if ["next", "last"].contains(&name) {
            for field in self.defined.fields() {
                let order = format!("min_by(|a, b| a.{field}.total_cmp(&b.{field}))");
                self.put(it, format!("{object}.{order}"), 8);
            }
        }
    }

    /// Calls a method that is written out: `t * ray.direction` becomes `ray.at(t)`.
    pub(crate) fn written_out(&mut self, it: &Expr, binary: &ExprBinary) {
        let sides = [(&binary.left, &binary.right), (&binary.right, &binary.left)];
        let defined = self.defined;
        for (object, argument) in sides {
            if let Expr::Field(field) = &**object {
                let (object, argument) = (self.source(&field.base), self.source(argument));
                for name in defined.methods(1).filter(|it| *it != "at").chain(["at"]) {
                    self.put(it, format!("{object}.{name}({argument})"), 8);
                }
            }
        }
    }
}
