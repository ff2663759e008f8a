//! The walk through a syntax tree: keeps names and hosts, and asks for the edits of each part.

use std::ops::Range;

use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};
use syn::{
    Arm, Attribute, Block, Expr, ExprConst, Generics, ImplItemConst, ImplItemFn, ItemConst, ItemFn,
    ItemImpl, ItemMod, ItemStatic, Local, Macro, Pat, PatIdent, Signature, Stmt, Token,
    TraitItemFn, Type,
};

use crate::hosts::{bytes, is_place};
use crate::maker::{self, Maker};
use crate::{ConstantUse, Form};

impl Maker<'_> {
    /// Walks through a function, with its own names and hosts.
    fn function(&mut self, signature: &Signature, block: &Block) {
        let name = signature.ident.to_string();
        if signature.constness.is_some() && self.defined.in_constants.contains(&name) {
            return;
        }
        let whole = bytes(signature).start..bytes(block).end;
        let function = std::mem::replace(&mut self.function, whole);
        let read = self.places_in(block);
        let places = std::mem::replace(&mut self.places, read);
        let scope = std::mem::take(&mut self.scope);
        let hosts = self.hosts.take();
        for it in &signature.inputs {
            match it {
                syn::FnArg::Receiver(_) => self.declare("self", false),
                syn::FnArg::Typed(it) => self.visit_pat(&it.pat),
            }
        }
        self.visit_block(block);
        self.hosts.put_back(hosts);
        (self.scope, self.places, self.function) = (scope, places, function);
    }

    fn declare(&mut self, name: &str, is_mut: bool) {
        let name = name.to_owned();
        self.scope.push(maker::Local { name, is_mut });
    }

    fn constant(&mut self, whole: Range<usize>, value: &Expr) {
        let function = std::mem::replace(&mut self.function, whole.clone());
        let hosts = self.hosts.take();
        self.hosts.open(whole, Form::Constant);
        self.visit_expr(value);
        self.hosts.put_back(hosts);
        self.function = function;
    }

    /// Lists all edits of an expression but those inside of its parts.
    fn edits_of(&mut self, it: &Expr) {
        match it {
            Expr::Binary(binary) => {
                self.binary(it, binary);
                if self.source(&binary.op) == "*" {
                    self.written_out(it, binary);
                }
            }
            Expr::Unary(unary) => self.unary(it, unary),
            Expr::Lit(literal) => self.literal(it, literal),
            Expr::Path(_) | Expr::Field(_) if is_place(it) => self.place(it),
            Expr::Index(index) => self.indexed(it, index),
            Expr::Call(call) => self.call(it, call),
            Expr::MethodCall(call) => self.method_call(it, call),
            Expr::Array(list) => self.list(&list.elems.iter().collect::<Vec<_>>(), 4),
            Expr::Tuple(list) => self.list(&list.elems.iter().collect::<Vec<_>>(), 4),
            Expr::Struct(list) => {
                let fields = list.fields.iter().filter(|it| it.colon_token.is_some());
                self.list(&fields.map(|it| &it.expr).collect::<Vec<_>>(), 4);
            }
            Expr::Cast(cast) => self.cast(it, cast),
            Expr::Match(choice) => {
                let bodies: Vec<&Expr> = choice.arms.iter().map(|it| &*it.body).collect();
                self.list(&bodies, 5);
            }
            Expr::Return(back) => self.returned(it, back),
            Expr::Range(range) => self.range(it, range),
            Expr::Assign(assign) => self.assigned(assign),
            _ => {}
        }
    }

    /// Walks through the parts of an expression.
    fn parts_of_expression(&mut self, it: &Expr) {
        match it {
            // A function's name is no value.
            Expr::Call(it) => {
                if !matches!(*it.func, Expr::Path(_)) {
                    self.visit_expr(&it.func);
                }
                it.args.iter().for_each(|it| self.visit_expr(it));
            }
            Expr::ForLoop(it) => {
                self.root(&it.expr);
                self.visit_pat(&it.pat);
                self.visit_block(&it.body);
            }
            Expr::Repeat(it) => self.visit_expr(&it.expr),
            Expr::Struct(it) => it.fields.iter().for_each(|it| self.field_value(it)),
            Expr::Reference(it) if is_constant(&it.expr) => {
                let outer = std::mem::replace(&mut self.hosts.is_sealed, true);
                self.visit_expr(&it.expr);
                self.hosts.is_sealed = outer;
            }
            Expr::Field(it) if is_place(&it.base) && self.source(&it.base) == "self" => {}
            Expr::If(it) => {
                self.decision(&it.cond);
                self.visit_block(&it.then_branch);
                it.else_branch.iter().for_each(|it| self.visit_expr(&it.1));
            }
            Expr::While(it) => {
                self.decision(&it.cond);
                self.visit_block(&it.body);
            }
            Expr::Assign(it) => {
                self.visit_expr(&it.left);
                self.root(&it.right);
            }
            Expr::Return(it) => it.expr.iter().for_each(|it| self.root(it)),
            it => visit::visit_expr(self, it),
        }
    }

    /// Walks through an expression that is no operand of another one.
    fn root(&mut self, it: &Expr) {
        self.visit_expr(it);
        if !is_block_like(it) && !matches!(it, Expr::Return(_) | Expr::Assign(_) | Expr::Block(_)) {
            self.hosted(it, |maker| maker.exchanged(it));
        }
    }

    /// Walks through a condition.
    fn decision(&mut self, it: &Expr) {
        self.root(it);
        self.hosted(it, |maker| maker.condition(it));
    }

    /// Makes edits whose host is the expression, if it may be one.
    fn hosted(&mut self, it: &Expr, make: impl FnOnce(&mut Self)) {
        let is_host = self.hosts.open_expression(it);
        make(self);
        if is_host {
            self.hosts.close();
        }
    }

    /// Walks through the value of a block, which may be an `if` or a loop without a value.
    fn value_of_block(&mut self, it: &Expr) {
        self.root(it);
        if is_block_like(it) {
            self.hosted(it, |maker| maker.put(it, "{}", 7));
        }
    }

    /// Walks through the value of a field in a new struct, also where only a name is written.
    fn field_value(&mut self, it: &syn::FieldValue) {
        if it.colon_token.is_some() {
            return self.root(&it.expr);
        }
        let (name, at) = (self.source(&it.expr), bytes(&it.expr));
        for other in self.names(name) {
            self.replace(at.clone(), format!("{name}: {other}"), 5);
        }
        self.replace(at, format!("{name}: -{name}"), 4);
    }
}

/// Returns true for an expression that lives as long as the program where it is borrowed.
fn is_constant(it: &Expr) -> bool {
    matches!(
        it,
        Expr::Array(_) | Expr::Lit(_) | Expr::Tuple(_) | Expr::Struct(_)
    )
}

fn is_for_some(attributes: &[Attribute], name: &str) -> bool {
    attributes.iter().any(|it| it.path().is_ident(name))
}

impl<'a> Visit<'a> for Maker<'_> {
    fn visit_attribute(&mut self, _: &'a Attribute) {}
    fn visit_type(&mut self, _: &'a Type) {}
    fn visit_generics(&mut self, _: &'a Generics) {}
    fn visit_expr_const(&mut self, _: &'a ExprConst) {}
    fn visit_item_static(&mut self, _: &'a ItemStatic) {}

    fn visit_item_mod(&mut self, it: &'a ItemMod) {
        if !is_for_some(&it.attrs, "cfg") {
            visit::visit_item_mod(self, it);
        }
    }

    fn visit_item_fn(&mut self, it: &'a ItemFn) {
        if !is_for_some(&it.attrs, "test") && !is_for_some(&it.attrs, "cfg") {
            self.function(&it.sig, &it.block);
        }
    }

    fn visit_item_impl(&mut self, it: &'a ItemImpl) {
        let name = self
            .source(&it.self_ty)
            .split('<')
            .next()
            .unwrap_or_default();
        self.of_type(name);
        it.items.iter().for_each(|it| self.visit_impl_item(it));
        self.of_type("");
    }

    fn visit_impl_item_fn(&mut self, it: &'a ImplItemFn) {
        self.function(&it.sig, &it.block);
    }

    fn visit_trait_item_fn(&mut self, it: &'a TraitItemFn) {
        if let Some(block) = &it.default {
            self.function(&it.sig, block);
        }
    }

    fn visit_item_const(&mut self, it: &'a ItemConst) {
        self.constant(bytes(it), &it.expr);
    }

    fn visit_impl_item_const(&mut self, it: &'a ImplItemConst) {
        self.constant(bytes(it), &it.expr);
    }

    fn visit_block(&mut self, it: &'a Block) {
        let before = self.scope.len();
        self.hosts.open(bytes(it), Form::Block);
        for (n, statement) in it.stmts.iter().enumerate() {
            let is_last = n + 1 == it.stmts.len();
            match statement {
                Stmt::Expr(value, None) if is_last => self.value_of_block(value),
                statement => self.visit_stmt(statement),
            }
            self.missing_statements(statement, n == 0, is_last);
        }
        self.hosts.close();
        self.scope.truncate(before);
    }

    fn visit_stmt(&mut self, it: &'a Stmt) {
        let (value, rank) = match it {
            Stmt::Expr(value, Some(_)) => (value, 6),
            Stmt::Expr(value, None) if is_block_like(value) => (value, 7),
            it => return visit::visit_stmt(self, it),
        };
        self.hosts.open(bytes(it), Form::Statement);
        self.hosts.set_bare(value);
        self.replace(bytes(it), "", rank);
        self.root(value);
        self.hosts.close();
    }

    fn visit_local(&mut self, it: &'a Local) {
        if let Some(init) = &it.init {
            self.root(&init.expr);
            init.diverge.iter().for_each(|it| self.visit_expr(&it.1));
        }
        self.visit_pat(&it.pat);
    }

    fn visit_pat(&mut self, it: &'a Pat) {
        self.pattern(it);
        visit::visit_pat(self, it);
    }

    fn visit_pat_ident(&mut self, it: &'a PatIdent) {
        self.declare(&it.ident.to_string(), it.mutability.is_some());
    }

    fn visit_arm(&mut self, it: &'a Arm) {
        let before = self.scope.len();
        visit::visit_arm(self, it);
        self.scope.truncate(before);
    }

    /// Walks through the arguments of a macro that takes expressions, as `println!`.
    fn visit_macro(&mut self, it: &'a Macro) {
        let all = it.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated);
        // What is written to is no value.
        let is_written = ["write", "writeln"]
            .iter()
            .any(|name| it.path.is_ident(name));
        for part in all.into_iter().flatten().skip(usize::from(is_written)) {
            match &part {
                Expr::Assign(it) => self.visit_expr(&it.right),
                it => self.visit_expr(it),
            }
        }
    }

    fn visit_expr(&mut self, it: &'a Expr) {
        let (names, edits) = (self.scope.len(), self.edits.len());
        self.hosts.look_into(it, self.text);
        let is_host = self.hosts.open_expression(it);
        self.note_use(it);
        self.edits_of(it);
        self.parts_of_expression(it);
        self.on_all_axes(it, edits);
        if is_host {
            self.hosts.close();
        }
        // The names of a condition last to the end of what it decides.
        if !matches!(it, Expr::Let(_) | Expr::Binary(_)) {
            self.scope.truncate(names);
        }
    }
}

impl Maker<'_> {
    /// Notes a use of a constant, at which its edits are chosen.
    fn note_use(&mut self, it: &Expr) {
        let in_constant = self
            .hosts
            .innermost()
            .is_none_or(|it| it.form == Form::Constant);
        if let Expr::Path(path) = it
            && let Some(last) = path.path.segments.last()
            && self.defined.constants.contains(&last.ident.to_string())
            && !in_constant
        {
            let (file, at) = (self.file, bytes(it));
            self.uses.push(ConstantUse { file, at });
        }
    }
}

/// Returns true for what ends with a brace and is a statement without a semicolon.
fn is_block_like(it: &Expr) -> bool {
    let is_choice = matches!(it, Expr::If(_) | Expr::Match(_));
    is_choice || matches!(it, Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_))
}
