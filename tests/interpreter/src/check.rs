//! Type checking: finds a type for each expression, and says as the compiler does where
//! there is none. What comes out is run.

mod calls;
mod operators;
mod patterns;

use std::collections::HashMap;

use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;

use crate::items::{Body, Context, Items, Signature, names, similar, unknown};
use crate::node::{At, Function, Node, Pattern, Root, Target, TypeId};
use crate::prelude;
use crate::read::place_of;
use crate::run::Code;
use crate::types::{Head, Int, Type, Unifier};
use crate::{Fault, Place};

type Checked<T = Typed> = Result<T, Fault>;

/// What can be run, and what the compiler would warn of.
pub(crate) fn check(items: &Items) -> Result<(Code, Vec<String>), Vec<Fault>> {
    let mut code = Code::default();
    let mut faults = Vec::new();
    let mut warnings = Vec::new();
    for (signature, body) in items.functions.iter().zip(&items.bodies) {
        let mut checker = Checker::new(items, &mut code, signature);
        let checked = checker.function(signature, body.as_ref());
        warnings.append(&mut checker.warnings);
        match checked {
            Ok(function) => code.functions.push(function),
            Err(fault) => faults.push(fault),
        }
    }
    for (n, kind) in items.kinds.iter().enumerate() {
        let own = items
            .functions
            .iter()
            .filter(|it| it.has_self && it.of.as_ref().is_some_and(|of| of.is(Head::Own(n))));
        let methods =
            own.filter_map(|it| Some((it.name.clone(), items.method(n, &it.name, None)?)));
        code.methods.push(methods.collect());
        let fields = kind.variants.first().map_or(&[][..], |it| &it.fields);
        code.fields
            .push(fields.iter().map(|it| it.ty.clone()).collect());
        code.defaults.push(items.method(n, "default", None));
    }
    match faults.is_empty() {
        true => Ok((code, warnings)),
        false => Err(faults),
    }
}

/// An expression: what it does, its type, and what can be assigned to if it is a place.
#[derive(Clone)]
pub(crate) struct Typed {
    node: Node,
    ty: Type,
    target: Option<Target>,
    /// The variable that would have to be `mut`.
    fixed: Option<String>,
}

impl Typed {
    fn new(node: Node, ty: Type) -> Self {
        Self {
            node,
            ty,
            target: None,
            fixed: None,
        }
    }
}

struct Local {
    name: String,
    slot: usize,
    ty: Type,
    is_mut: bool,
    is_used: bool,
}

/// A loop or a block that can be left.
struct Way {
    label: Option<String>,
    is_loop: bool,
    /// What is left behind, where that is a value, and whether it is ever left.
    value: Option<Type>,
    is_left: bool,
}

struct Checker<'a> {
    items: &'a Items<'a>,
    code: &'a mut Code,
    context: Context,
    types: Unifier,
    /// The types that nodes need, from here on in the list of all.
    first_type: usize,
    first_closure: usize,
    locals: Vec<Local>,
    slots: usize,
    ways: Vec<Way>,
    result: Type,
    /// Numbers whose size depends on what is done with them.
    literals: Vec<(Type, Place)>,
    warnings: Vec<String>,
}

impl<'a> Checker<'a> {
    fn new(items: &'a Items<'a>, code: &'a mut Code, signature: &Signature) -> Self {
        Self {
            first_type: code.types.len(),
            first_closure: code.closures.len(),
            items,
            code,
            context: Context {
                file: signature.file,
                own: signature.of.clone(),
                parameters: HashMap::new(),
            },
            types: Unifier::default(),
            locals: Vec::new(),
            slots: 0,
            ways: Vec::new(),
            result: signature.result.clone(),
            literals: Vec::new(),
            warnings: Vec::new(),
        }
    }

    fn function(&mut self, signature: &Signature, body: Option<&Body>) -> Checked<Function> {
        let mut parameters = Vec::new();
        let body = match body {
            None => Node::Unit,
            Some(Body::Constant(value)) => self.given(value, &signature.result)?,
            Some(Body::Function(syntax, block)) => {
                for (input, ty) in syntax.inputs.iter().zip(&signature.parameters) {
                    parameters.push(match input {
                        syn::FnArg::Receiver(it) => {
                            let slot = self.local("self", ty.clone(), it.mutability.is_some());
                            Pattern::Bind(slot, Box::new(Pattern::Any))
                        }
                        syn::FnArg::Typed(it) => self.pattern(&it.pat, ty, false)?,
                    });
                }
                self.body(block, &signature.result)?
            }
        };
        self.leave(0);
        self.settle()?;
        Ok(Function {
            slots: self.slots,
            parameters,
            body,
        })
    }

    /// The body of a function, which comes to its result.
    fn body(&mut self, block: &syn::Block, result: &Type) -> Checked<Node> {
        let body = self.block(block, Some(result))?;
        let last = block.stmts.last();
        if let (Some(syn::Stmt::Expr(last, Some(_))), true) = (last, body.ty.is_unit())
            && !self.types.known(result).is_unit()
        {
            let (message, label) = self.mismatch(result, &body.ty);
            let help = "remove this semicolon to return this value";
            return Err(Fault::at(Some(self.place(last)), message, &label, help));
        }
        match last {
            Some(syn::Stmt::Expr(last, None)) => self.coerced(body, result, last),
            _ => self.coerced_at(body, result, self.place(&block.brace_token.span.close())),
        }
    }

    /// All types are known now: numbers of which nothing is said are `i32` and `f64`.
    fn settle(&mut self) -> Checked<()> {
        for (ty, place) in std::mem::take(&mut self.literals) {
            if self.types.known(&ty).is(Head::F32) {
                return unknown(
                    place,
                    "`f32` in a number that does not say so, as `0.1_f32` does",
                );
            }
        }
        for n in self.first_type..self.code.types.len() {
            self.code.types[n] = self.types.settled(&self.code.types[n]);
        }
        for closure in &mut self.code.closures[self.first_closure..] {
            closure.slots = self.slots;
        }
        Ok(())
    }

    fn place(&self, it: &impl Spanned) -> Place {
        place_of(self.context.file, it)
    }

    fn at(&self, it: &impl Spanned) -> At {
        Box::new(self.place(it))
    }

    fn unknown<T>(&self, it: &impl Spanned, what: &str) -> Checked<T> {
        unknown(self.place(it), what)
    }

    fn fault<T>(&self, it: &impl Spanned, message: &str, label: &str, help: &str) -> Checked<T> {
        Err(Fault::at(Some(self.place(it)), message, label, help))
    }

    fn name(&self, ty: &Type) -> String {
        self.types.name(ty, self.items)
    }

    fn keep(&mut self, ty: &Type) -> TypeId {
        self.code.types.push(ty.clone());
        self.code.types.len() - 1
    }

    fn local(&mut self, name: &str, ty: Type, is_mut: bool) -> usize {
        let slot = self.slots;
        self.slots += 1;
        self.locals.push(Local {
            name: name.to_owned(),
            slot,
            ty,
            is_mut,
            is_used: false,
        });
        slot
    }

    /// Forgets the variables of a block.
    fn leave(&mut self, outside: usize) {
        for local in self.locals.drain(outside..) {
            if !local.is_used && !local.name.starts_with('_') && local.name != "self" {
                self.warnings
                    .push(format!("unused variable: `{}`", local.name));
            }
        }
    }

    /// A type without its references and boxes, and the value that they lead to.
    fn stripped(&self, typed: &Typed) -> Typed {
        let mut typed = typed.clone();
        loop {
            typed.ty = self.types.known(&typed.ty);
            typed = match typed.ty.head() {
                Some(Head::Ref | Head::Box | Head::RefMut) => self.dereferenced(typed),
                _ => return typed,
            };
        }
    }

    /// What a reference or a box leads to.
    fn dereferenced(&self, typed: Typed) -> Typed {
        let ty = typed.ty.inner();
        match typed.ty.head() {
            Some(Head::RefMut) => Typed {
                target: Some(Target {
                    root: Root::Through(typed.node.clone()),
                    steps: Vec::new(),
                }),
                node: Node::Deref(Box::new(typed.node)),
                ty,
                fixed: None,
            },
            Some(Head::Ref) => Typed {
                fixed: Some("&".to_owned()),
                ty,
                ..typed
            },
            _ => Typed { ty, ..typed },
        }
    }

    /// An expression whose value is to have that type.
    fn given(&mut self, value: &syn::Expr, ty: &Type) -> Checked<Node> {
        let typed = self.expr(value, Some(ty))?;
        self.coerced(typed, ty, value)
    }

    fn coerced(&mut self, typed: Typed, ty: &Type, at: &impl Spanned) -> Checked<Node> {
        self.coerced_at(typed, ty, self.place(at))
    }

    fn coerced_at(&mut self, typed: Typed, ty: &Type, place: Place) -> Checked<Node> {
        match self.coerce(typed.node, &typed.ty, ty) {
            Some(node) => Ok(node),
            None => {
                let help = self.help(ty, &typed.ty);
                let (message, label) = self.mismatch(ty, &typed.ty);
                Err(Fault::at(Some(place), message, &label, &help))
            }
        }
    }

    fn mismatch(&self, expected: &Type, found: &Type) -> (&'static str, String) {
        let [expected, found] = [expected, found].map(|it| self.types.whole(it));
        let said = |it| self.types.said(it, self.items);
        (
            "mismatched types",
            format!("expected {}, found {}", said(&expected), said(&found)),
        )
    }

    fn help(&self, expected: &Type, found: &Type) -> String {
        let [expected, found] = [expected, found].map(|it| self.types.whole(it));
        let is_like =
            |it: &Type| *it == found || matches!(found, Type::Var(_)) && self.types.is_float(it);
        match (expected.head(), found.head()) {
            (Some(Head::F64 | Head::F32), _) if self.types.is_integer(&found) => match found {
                Type::Var(_) => "use a float literal, such as `1.0`".to_owned(),
                _ => "convert it: `f64::from(…)`, or `… as f64`".to_owned(),
            },
            (Some(Head::Option), _) if is_like(&expected.inner()) => {
                "try wrapping the expression in `Some`: `Some(…)`".to_owned()
            }
            (Some(Head::Ref), _) if is_like(&expected.inner()) => {
                "consider borrowing here: `&…`".to_owned()
            }
            (Some(Head::RefMut), _) if is_like(&expected.inner()) => {
                "consider mutably borrowing here: `&mut …`".to_owned()
            }
            (_, Some(Head::Ref)) if found.inner() == expected => {
                "consider dereferencing it: `*…`".to_owned()
            }
            (Some(Head::Box), _) if found.head() != Some(Head::Box) => {
                "store it in the heap: `Box::new(…)`".to_owned()
            }
            (_, Some(Head::Option)) if found.inner() == expected => {
                "it is `None` where there is nothing: look with `if let Some(…) = …`".to_owned()
            }
            _ => String::new(),
        }
    }

    /// The same value as another type, as far as the language does it by itself.
    fn coerce(&mut self, node: Node, from: &Type, to: &Type) -> Option<Node> {
        let (from, to) = (self.types.known(from), self.types.known(to));
        match (&from, &to) {
            (Type::Of(Head::Never, _), _) => return Some(node),
            (Type::Of(one, of), Type::Of(other, others)) => match (one, other) {
                (Head::RefMut, Head::Ref) => {
                    return self.coerce(
                        Node::Deref(Box::new(node)),
                        &Type::one(Head::Ref, of[0].clone()),
                        &to,
                    );
                }
                (Head::Ref | Head::RefMut, Head::Ref | Head::RefMut) if one == other => {
                    let (inner, wanted) = (self.types.known(&of[0]), self.types.known(&others[0]));
                    let unwrapped = Type::one(*one, inner.inner());
                    match (inner.head(), wanted.head()) {
                        (Some(Head::Vec | Head::Array(_)), Some(Head::Slice)) => {
                            return self
                                .types
                                .unify(&inner.inner(), &wanted.inner())
                                .then_some(node);
                        }
                        (Some(Head::Own(_)), Some(Head::Dyn(_))) => {
                            return self.implements(&inner, &wanted).then_some(node);
                        }
                        (Some(Head::Box | Head::Ref), Some(head)) if Some(head) != inner.head() => {
                            return self.coerce(node, &unwrapped, &to);
                        }
                        (Some(Head::RefMut), Some(head)) if Some(head) != inner.head() => {
                            return self.coerce(Node::Deref(Box::new(node)), &unwrapped, &to);
                        }
                        _ => {}
                    }
                }
                (Head::Box, Head::Box) if self.implements(&of[0], &others[0]) => return Some(node),
                (Head::Own(_), Head::Dyn(_)) => return self.implements(&from, &to).then_some(node),
                (Head::Vec | Head::Array(_) | Head::Range, Head::Iterator) => {
                    return self.types.unify(&of[0], &others[0]).then_some(node);
                }
                _ => {}
            },
            _ => {}
        }
        self.types.unify(&from, &to).then_some(node)
    }

    fn implements(&self, kind: &Type, dynamic: &Type) -> bool {
        match (
            self.types.known(kind).head(),
            self.types.known(dynamic).head(),
        ) {
            (Some(Head::Own(kind)), Some(Head::Dyn(of))) => {
                self.items.traits[of].implemented_for.contains(&kind)
            }
            _ => false,
        }
    }

    fn block(&mut self, block: &syn::Block, expected: Option<&Type>) -> Checked {
        let outside = self.locals.len();
        let mut nodes = Vec::new();
        let mut value = Type::unit();
        let mut is_left = false;
        let mut has_value = false;
        for (n, statement) in block.stmts.iter().enumerate() {
            let is_last = n + 1 == block.stmts.len();
            has_value = false;
            let done = match statement {
                syn::Stmt::Local(it) => self.declaration(it)?,
                syn::Stmt::Expr(it, None) if is_last => {
                    has_value = true;
                    self.expr(it, expected)?
                }
                syn::Stmt::Expr(it, semicolon) => {
                    let typed = self.expr(it, None)?;
                    let ty = self.types.known(&typed.ty);
                    if semicolon.is_none() && !ty.is_unit() && !ty.is(Head::Never) {
                        let (message, label) = self.mismatch(&Type::unit(), &ty);
                        return self.fault(
                            it,
                            message,
                            &label,
                            "if it is to be returned: `return …;`",
                        );
                    }
                    typed
                }
                syn::Stmt::Macro(it) => {
                    has_value = is_last && it.semi_token.is_none();
                    self.macro_call(&it.mac)?
                }
                syn::Stmt::Item(it) => return self.unknown(it, "items in functions"),
            };
            is_left |= self.types.known(&done.ty).is(Head::Never);
            if has_value {
                value = done.ty.clone();
            }
            nodes.push(done.node);
        }
        self.leave(outside);
        if is_left && !has_value {
            value = Type::plain(Head::Never);
        }
        Ok(Typed::new(Node::Block(nodes, has_value), value))
    }

    fn declaration(&mut self, it: &syn::Local) -> Checked {
        let (pattern, written) = match &it.pat {
            syn::Pat::Type(typed) => (&*typed.pat, Some(self.ty(&typed.ty)?)),
            pattern => (pattern, None),
        };
        let Some(init) = &it.init else {
            let ty = written.unwrap_or_else(|| self.types.any());
            // It gets its value later, once.
            self.pattern(pattern, &ty, true)?;
            return Ok(Typed::new(Node::Unit, Type::unit()));
        };
        let typed = self.expr(&init.expr, written.as_ref())?;
        let mut ty = typed.ty.clone();
        let is_never = self.types.known(&ty).is(Head::Never);
        let node = match &written {
            Some(written) => {
                ty = written.clone();
                self.coerced(typed, written, &init.expr)?
            }
            None => typed.node,
        };
        let other = match &init.diverge {
            None => None,
            Some((_, other)) => {
                let other_typed = self.expr(other, None)?;
                if !self.types.known(&other_typed.ty).is(Head::Never) {
                    let label = format!(
                        "expected `!`, found {}",
                        self.types.said(&other_typed.ty, self.items)
                    );
                    return self.fault(
                        other,
                        "`else` clause of `let...else` does not diverge",
                        &label,
                        "`return`, `break` or `continue` there",
                    );
                }
                Some(Box::new(other_typed.node))
            }
        };
        let bound = self.pattern(pattern, &ty, false)?;
        if other.is_none() && !bound.is_irrefutable() {
            return self.fault(
                pattern,
                "refutable pattern in local binding",
                "",
                "`let … else { … }`, or `if let`",
            );
        }
        let ty = if is_never {
            Type::plain(Head::Never)
        } else {
            Type::unit()
        };
        Ok(Typed::new(
            Node::Let(Box::new(bound), Box::new(node), other),
            ty,
        ))
    }

    fn ty(&mut self, ty: &syn::Type) -> Checked<Type> {
        match ty {
            syn::Type::Infer(_) => Ok(self.types.any()),
            // `Vec<_>`, of which the rest is found.
            syn::Type::Path(it) if it.path.segments.len() == 1 => {
                let segment = &it.path.segments[0];
                if let syn::PathArguments::AngleBracketed(arguments) = &segment.arguments
                    && let Some(syn::GenericArgument::Type(of @ syn::Type::Infer(_))) =
                        arguments.args.first()
                {
                    let of = self.ty(of)?;
                    return Ok(Type::one(
                        crate::items::generic(&segment.ident.to_string()),
                        of,
                    ));
                }
                self.items.ty(&self.context, ty)
            }
            ty => self.items.ty(&self.context, ty),
        }
    }

    fn expr(&mut self, expr: &syn::Expr, expected: Option<&Type>) -> Checked {
        let typed = |node, ty| Ok(Typed::new(node, ty));
        match expr {
            syn::Expr::Lit(it) => self.literal(&it.lit),
            syn::Expr::Paren(it) => self.expr(&it.expr, expected),
            syn::Expr::Group(it) => self.expr(&it.expr, expected),
            syn::Expr::Path(it) => self.path(it),
            syn::Expr::Unary(it) => self.unary(it),
            syn::Expr::Binary(it) => self.binary(it),
            syn::Expr::Assign(it) => {
                let left = self.expr(&it.left, None)?;
                let right = self.given(&it.right, &left.ty)?;
                let target = self.assignable(left, &it.left)?;
                typed(Node::Set(Box::new(target), Box::new(right)), Type::unit())
            }
            syn::Expr::Call(it) => self.call(it),
            syn::Expr::MethodCall(it) => self.method_call(it),
            syn::Expr::Field(it) => self.field(it),
            syn::Expr::Index(it) => self.index(it),
            syn::Expr::Block(it) => {
                let Some(label) = &it.label else {
                    return self.block(&it.block, expected);
                };
                self.ways.push(Way {
                    label: Some(label.name.to_string()),
                    is_loop: false,
                    value: Some(self.types.any()),
                    is_left: false,
                });
                let way = self.ways.len() - 1;
                let body = self.block(&it.block, expected)?;
                let value = self.ways[way].value.clone().expect("a block has a value");
                let node = self.coerced(body, &value, &it.block)?;
                self.ways.pop();
                typed(Node::Labeled(Box::new(node), way), value)
            }
            syn::Expr::If(it) => self.condition(it, expected),
            syn::Expr::Let(it) => {
                let value = self.expr(&it.expr, None)?;
                let pattern = self.pattern(&it.pat, &value.ty, false)?;
                typed(
                    Node::Matches(Box::new(pattern), Box::new(value.node)),
                    Type::plain(Head::Bool),
                )
            }
            syn::Expr::Match(it) => self.matching(it, expected),
            syn::Expr::While(it) => {
                let outside = self.locals.len();
                let condition = self.given(&it.cond, &Type::plain(Head::Bool))?;
                let (body, way, _) = self.looped(&it.body, it.label.as_ref(), None)?;
                self.leave(outside);
                typed(
                    Node::While(
                        Box::new(condition),
                        Box::new(body),
                        way,
                        self.at(&it.while_token),
                    ),
                    Type::unit(),
                )
            }
            syn::Expr::Loop(it) => {
                let value = self.types.any();
                let (body, way, is_left) =
                    self.looped(&it.body, it.label.as_ref(), Some(value.clone()))?;
                let ty = if is_left {
                    value
                } else {
                    Type::plain(Head::Never)
                };
                let at = self.at(&it.loop_token);
                typed(
                    Node::While(Box::new(Node::Bool(true)), Box::new(body), way, at),
                    ty,
                )
            }
            syn::Expr::ForLoop(it) => {
                let each = self.expr(&it.expr, None)?;
                let (each, of) = self.iterated(each, &it.expr)?;
                let outside = self.locals.len();
                let pattern = self.pattern(&it.pat, &of, false)?;
                let (body, way, _) = self.looped(&it.body, it.label.as_ref(), None)?;
                self.leave(outside);
                let at = self.at(&it.for_token);
                typed(
                    Node::For(Box::new(pattern), Box::new(each), Box::new(body), way, at),
                    Type::unit(),
                )
            }
            syn::Expr::Break(it) => {
                let way = self.way(it.label.as_ref(), it, "break")?;
                let value = match (&it.expr, self.ways[way].value.clone()) {
                    (Some(value), Some(ty)) => self.given(value, &ty)?,
                    (Some(value), None) => {
                        return self.fault(
                            value,
                            "`break` with value from a loop that has none",
                            "",
                            "only `loop` has a value",
                        );
                    }
                    (None, Some(ty)) if self.ways[way].is_loop => {
                        self.types.unify(&ty, &Type::unit());
                        Node::Unit
                    }
                    (None, _) => Node::Unit,
                };
                self.ways[way].is_left = true;
                typed(Node::Break(way, Box::new(value)), Type::plain(Head::Never))
            }
            syn::Expr::Continue(it) => {
                let way = self.way(it.label.as_ref(), it, "continue")?;
                typed(Node::Continue(way), Type::plain(Head::Never))
            }
            syn::Expr::Return(it) => {
                let result = self.result.clone();
                let value = match &it.expr {
                    Some(value) => self.given(value, &result)?,
                    None => self.coerced(Typed::new(Node::Unit, Type::unit()), &result, it)?,
                };
                typed(Node::Return(Box::new(value)), Type::plain(Head::Never))
            }
            syn::Expr::Closure(it) => self.closure(it, expected),
            syn::Expr::Tuple(it) => {
                let wanted: Vec<Type> = match expected.map(|it| self.types.known(it)) {
                    Some(Type::Of(Head::Tuple, of)) if of.len() == it.elems.len() => of,
                    _ => it.elems.iter().map(|_| self.types.any()).collect(),
                };
                if it.elems.is_empty() {
                    return typed(Node::Unit, Type::unit());
                }
                let nodes = it
                    .elems
                    .iter()
                    .zip(&wanted)
                    .map(|(it, ty)| self.given(it, ty));
                let nodes = nodes.collect::<Checked<Vec<_>>>()?;
                typed(Node::Many(nodes), Type::Of(Head::Tuple, wanted))
            }
            syn::Expr::Array(it) => {
                let of = self.types.any();
                let nodes = self.listed(it.elems.iter(), &of)?;
                let length = nodes.len();
                typed(Node::Many(nodes), Type::one(Head::Array(length), of))
            }
            syn::Expr::Repeat(it) => {
                let of = self.expr(&it.expr, None)?;
                match crate::items::literal(&it.len) {
                    Some(length) if length <= 1000 => typed(
                        Node::Repeat(Box::new(of.node), length),
                        Type::one(Head::Array(length), of.ty),
                    ),
                    _ => self.unknown(&it.len, "such a length"),
                }
            }
            syn::Expr::Range(it) => {
                let of = self.types.any();
                let mut end = |end: &Option<Box<syn::Expr>>| match end {
                    Some(end) => Ok(Some(Box::new(self.given(end, &of)?))),
                    None => Ok(None),
                };
                let (from, to) = (end(&it.start)?, end(&it.end)?);
                let is_closed = matches!(it.limits, syn::RangeLimits::Closed(_));
                typed(Node::Range(from, to, is_closed), Type::one(Head::Range, of))
            }
            syn::Expr::Reference(it) => {
                let wanted = expected
                    .map(|it| self.types.known(it))
                    .filter(|it| matches!(it.head(), Some(Head::Ref | Head::RefMut)));
                let of = self.expr(&it.expr, wanted.map(|it| it.inner()).as_ref())?;
                match it.mutability {
                    None => typed(of.node, Type::one(Head::Ref, of.ty)),
                    Some(_) => {
                        let ty = Type::one(Head::RefMut, of.ty.clone());
                        let target = self.mutable(of, &it.expr)?;
                        typed(Node::Address(Box::new(target)), ty)
                    }
                }
            }
            syn::Expr::Cast(it) => self.cast(it),
            syn::Expr::Try(it) => {
                let of = self.expr(&it.expr, None)?;
                let value = self.types.any();
                let option = Type::one(Head::Option, value.clone());
                if !self.types.unify(&of.ty, &option) {
                    let message = format!(
                        "the `?` operator can only be applied to an `Option` here, and this is `{}`",
                        self.name(&of.ty)
                    );
                    return self.fault(it, &message, "", "");
                }
                if !matches!(self.types.known(&self.result).head(), Some(Head::Option)) {
                    let message =
                        "the `?` operator can only be used in a function that returns `Option`";
                    return self.fault(
                        &it.question_token,
                        message,
                        &format!("this one returns `{}`", self.name(&self.result)),
                        "",
                    );
                }
                typed(Node::Try(Box::new(of.node)), value)
            }
            syn::Expr::Struct(it) => self.structure(it),
            syn::Expr::Macro(it) => self.macro_call(&it.mac),
            syn::Expr::Unsafe(_) => self.unknown(expr, "`unsafe`"),
            syn::Expr::Async(_) | syn::Expr::Await(_) => self.unknown(expr, "`async`"),
            _ => self.unknown(expr, "this kind of expression"),
        }
    }

    fn listed<'s>(
        &mut self,
        all: impl Iterator<Item = &'s syn::Expr>,
        of: &Type,
    ) -> Checked<Vec<Node>> {
        all.map(|it| self.given(it, of)).collect()
    }

    fn literal(&mut self, literal: &syn::Lit) -> Checked {
        let named = |suffix: &str| match suffix {
            "f64" => Some(Type::plain(Head::F64)),
            "f32" => Some(Type::plain(Head::F32)),
            name => Int::named(name).map(|it| Type::plain(Head::Int(it))),
        };
        Ok(match literal {
            syn::Lit::Bool(it) => Typed::new(Node::Bool(it.value), Type::plain(Head::Bool)),
            syn::Lit::Float(it) => {
                let ty = named(it.suffix()).unwrap_or_else(|| self.types.float());
                let value = it.base10_digits().parse().unwrap_or(f64::NAN);
                if it.suffix().is_empty() {
                    self.literals.push((ty.clone(), self.place(it)));
                }
                match ty.is(Head::F32) {
                    true => Typed::new(Node::Float(f64::from(value as f32)), ty),
                    false => Typed::new(Node::Float(value), ty),
                }
            }
            syn::Lit::Int(it) => {
                let ty = named(it.suffix()).unwrap_or_else(|| self.types.integer());
                let Ok(value) = it.base10_parse::<i128>() else {
                    return self.fault(it, "integer literal is too large", "", "");
                };
                match self.types.is_float(&ty) {
                    true => Typed::new(Node::Float(value as f64), ty),
                    false => Typed::new(Node::Int(value), ty),
                }
            }
            syn::Lit::Str(_) => {
                Typed::new(Node::Unit, Type::one(Head::Ref, Type::plain(Head::Str)))
            }
            _ => return self.unknown(literal, "this kind of literal"),
        })
    }

    /// Looks a variable up.
    fn variable(&mut self, name: &str) -> Option<Typed> {
        let local = self.locals.iter_mut().rev().find(|it| it.name == name)?;
        local.is_used = true;
        Some(Typed {
            node: Node::Local(local.slot),
            ty: local.ty.clone(),
            target: Some(Target {
                root: Root::Local(local.slot),
                steps: Vec::new(),
            }),
            fixed: (!local.is_mut).then(|| name.to_owned()),
        })
    }

    /// What may be assigned to, or borrowed to be changed.
    fn mutable(&mut self, typed: Typed, at: &syn::Expr) -> Checked<Target> {
        match (typed.target, typed.fixed) {
            (Some(_), Some(name)) if name == "&" => self.fault(
                at,
                "cannot borrow as mutable what is behind a `&` reference",
                "",
                "it takes `&mut`",
            ),
            (Some(_), Some(name)) => {
                let message =
                    format!("cannot borrow `{name}` as mutable, as it is not declared as mutable");
                self.fault(
                    at,
                    &message,
                    "cannot borrow as mutable",
                    &format!("`mut {name}`"),
                )
            }
            (Some(target), None) => Ok(target),
            (None, _) => {
                let slot = self.slots;
                self.slots += 1;
                Ok(Target {
                    root: Root::Temporary(slot, typed.node),
                    steps: Vec::new(),
                })
            }
        }
    }

    fn assignable(&self, typed: Typed, at: &syn::Expr) -> Checked<Target> {
        match (typed.target, typed.fixed) {
            (Some(_), Some(name)) if name == "&" => self.fault(
                at,
                "cannot assign to what is behind a `&` reference",
                "",
                "it takes `&mut`",
            ),
            (Some(_), Some(name)) => {
                let message = format!("cannot assign twice to immutable variable `{name}`");
                self.fault(at, &message, "", &format!("`mut {name}`"))
            }
            (Some(target), None) => Ok(target),
            (None, _) => self.fault(
                at,
                "invalid left-hand side of assignment",
                "cannot assign to this expression",
                "",
            ),
        }
    }

    fn condition(&mut self, it: &syn::ExprIf, expected: Option<&Type>) -> Checked {
        let outside = self.locals.len();
        let condition = self.given(&it.cond, &Type::plain(Head::Bool))?;
        let then = self.block(&it.then_branch, expected)?;
        self.leave(outside);
        let Some((_, other)) = &it.else_branch else {
            let ty = self.types.known(&then.ty);
            if !ty.is_unit() && !ty.is(Head::Never) {
                let (message, label) = self.mismatch(&Type::unit(), &ty);
                let last = it.then_branch.stmts.last();
                let place = last.map_or_else(|| self.place(it), |last| self.place(last));
                return Err(Fault::at(
                    Some(place),
                    message,
                    &label,
                    "`return …;`, or an `else` that gives the other value",
                ));
            }
            let node = Node::If(
                Box::new(condition),
                Box::new(then.node),
                Box::new(Node::Unit),
            );
            return Ok(Typed::new(node, Type::unit()));
        };
        let other_typed = self.expr(other, expected)?;
        let message = "`if` and `else` have incompatible types";
        let ([then, other], ty) = self.joined(then, other_typed, message, other)?;
        Ok(Typed::new(
            Node::If(Box::new(condition), Box::new(then), Box::new(other)),
            ty,
        ))
    }

    /// Two ways to the same value.
    fn joined(
        &mut self,
        one: Typed,
        other: Typed,
        message: &str,
        at: &impl Spanned,
    ) -> Checked<([Node; 2], Type)> {
        if self.types.known(&one.ty).is(Head::Never) {
            return Ok(([one.node, other.node], other.ty));
        }
        let ty = one.ty.clone();
        let (_, label) = self.mismatch(&ty, &other.ty);
        match self.coerce(other.node, &other.ty, &ty) {
            Some(node) => Ok(([one.node, node], ty)),
            None => self.fault(at, message, &label, ""),
        }
    }

    fn looped(
        &mut self,
        body: &syn::Block,
        label: Option<&syn::Label>,
        value: Option<Type>,
    ) -> Checked<(Node, usize, bool)> {
        self.ways.push(Way {
            label: label.map(|it| it.name.to_string()),
            is_loop: true,
            value,
            is_left: false,
        });
        let way = self.ways.len() - 1;
        let typed = self.block(body, None)?;
        let node = self.coerced(typed, &Type::unit(), body)?;
        let is_left = self.ways.pop().is_some_and(|it| it.is_left);
        Ok((node, way, is_left))
    }

    fn way(&self, label: Option<&syn::Lifetime>, at: &impl Spanned, word: &str) -> Checked<usize> {
        let is_it = |way: &Way| match label {
            Some(label) => way.label.as_deref() == Some(&label.to_string()),
            None => way.is_loop,
        };
        match self.ways.iter().rposition(is_it) {
            Some(way) => Ok(way),
            None => self.fault(at, &format!("`{word}` outside of a loop"), "", ""),
        }
    }

    /// What a loop goes over, and the type of each.
    fn iterated(&mut self, each: Typed, at: &syn::Expr) -> Checked<(Node, Type)> {
        let ty = self.types.known(&each.ty);
        let inner = self.types.known(&ty.inner());
        let of = inner.inner();
        match (ty.head(), inner.head()) {
            (Some(Head::Vec | Head::Array(_) | Head::Iterator | Head::Option), _) => {
                Ok((each.node, ty.inner()))
            }
            (Some(Head::Range), _) if self.types.is_integer(&inner) => Ok((each.node, inner)),
            (Some(Head::Ref), Some(Head::Vec | Head::Array(_) | Head::Slice | Head::Option)) => {
                Ok((each.node, Type::one(Head::Ref, of)))
            }
            (Some(Head::RefMut), Some(Head::Vec | Head::Array(_) | Head::Slice)) => {
                let native = prelude::native("list", "iter_mut").expect("it is listed");
                let kept = self.keep(&ty);
                Ok((
                    Node::Native(native, vec![each.node], kept, self.at(at)),
                    Type::one(Head::RefMut, of),
                ))
            }
            (Some(Head::RefMut), Some(Head::Iterator)) => {
                Ok((Node::Deref(Box::new(each.node)), of))
            }
            _ => {
                let message = format!("`{}` is not an iterator", self.name(&ty));
                self.fault(at, &message, "", "")
            }
        }
    }

    fn structure(&mut self, it: &syn::ExprStruct) -> Checked {
        let (kind, variant) = match self.variant(&it.path) {
            Some(found) => found,
            None => {
                let path = &it.path;
                return match self.items.found(self.context.file, &names(path)) {
                    Some(crate::items::Named::Type(Type::Of(Head::Vec3 | Head::Ray, _))) => {
                        self.native_structure(it)
                    }
                    _ => {
                        let name = names(path).join("::");
                        Err(self.items.not_found(
                            self.context.file,
                            self.place(path),
                            "struct, variant or union type",
                            &name,
                        ))
                    }
                };
            }
        };
        let items = self.items;
        let own = &items.kinds[kind];
        let ty = Type::plain(Head::Own(kind));
        let mut nodes: Vec<(usize, Node)> = Vec::new();
        for field in &it.fields {
            let name = match &field.member {
                syn::Member::Named(name) => name.to_string(),
                syn::Member::Unnamed(n) => n.index.to_string(),
            };
            let found = own.variants[variant]
                .fields
                .iter()
                .position(|it| it.name == name);
            let Some(n) = found else {
                let message = format!("struct `{}` has no field named `{name}`", own.name);
                let known = own.variants[variant]
                    .fields
                    .iter()
                    .map(|it| it.name.as_str());
                let help =
                    similar(&name, known).map_or(String::new(), |it| format!("there is `{it}`"));
                return self.fault(&field.member, &message, "", &help);
            };
            if nodes.iter().any(|(known, _)| *known == n) {
                return self.fault(
                    &field.member,
                    &format!("field `{name}` specified more than once"),
                    "",
                    "",
                );
            }
            nodes.push((
                n,
                self.given(&field.expr, &own.variants[variant].fields[n].ty)?,
            ));
        }
        let base = match &it.rest {
            Some(rest) => Some(Box::new(self.given(rest, &ty)?)),
            None => None,
        };
        let mut fields = own.variants[variant].fields.iter().enumerate();
        if base.is_none()
            && let Some((_, missing)) =
                fields.find(|(n, _)| nodes.iter().all(|(known, _)| known != n))
        {
            let message = format!(
                "missing field `{}` in initializer of `{}`",
                missing.name, own.name
            );
            return self.fault(&it.path, &message, "", "");
        }
        Ok(Typed::new(Node::New(kind, variant, nodes, base), ty))
    }

    /// `Ray { origin, direction }`, and a vector by its components.
    fn native_structure(&mut self, it: &syn::ExprStruct) -> Checked {
        let (owner, order): (_, &[&str]) =
            match it.path.segments.last().is_some_and(|it| it.ident == "Ray") {
                true => ("Ray", &["origin", "direction"]),
                false => ("Vec3", &["x", "y", "z"]),
            };
        let native = prelude::native(owner, "new").expect("it is listed");
        let mut arguments = Vec::new();
        for (name, ty) in order
            .iter()
            .zip(&prelude::NATIVES[native].signature.parameters)
        {
            let is_it = |field: &&syn::FieldValue| matches!(&field.member, syn::Member::Named(it) if it == name);
            match it.fields.iter().find(is_it) {
                Some(field) => arguments.push(self.given(&field.expr, ty)?),
                None => {
                    return self.fault(
                        &it.path,
                        &format!("missing field `{name}` in initializer of `{owner}`"),
                        "",
                        "",
                    );
                }
            }
        }
        if it.fields.len() > order.len() || it.rest.is_some() {
            return self.unknown(it, "such an initializer");
        }
        let ty = prelude::NATIVES[native].signature.result.clone();
        let kept = self.keep(&ty);
        Ok(Typed::new(
            Node::Native(native, arguments, kept, self.at(it)),
            ty,
        ))
    }

    /// The kind of the reader's that a path names, and the variant.
    fn variant(&self, path: &syn::Path) -> Option<(usize, usize)> {
        let names = names(path);
        let own = |names: &[String]| match names {
            [name] if name == "Self" => self.context.own.as_ref().and_then(Type::head),
            names => match self.items.found(self.context.file, names)? {
                crate::items::Named::Type(ty) => ty.head(),
                _ => None,
            },
        };
        if let Some(Head::Own(kind)) = own(&names)
            && !self.items.kinds[kind].is_enum
        {
            return Some((kind, 0));
        }
        let (variant, kind) = names.split_last()?;
        match own(kind) {
            Some(Head::Own(kind)) if self.items.kinds[kind].is_enum => {
                let mut variants = self.items.kinds[kind].variants.iter();
                Some((kind, variants.position(|it| it.name == *variant)?))
            }
            _ => None,
        }
    }

    fn macro_call(&mut self, it: &syn::Macro) -> Checked {
        let name = it
            .path
            .segments
            .last()
            .map_or(String::new(), |it| it.ident.to_string());
        let at = self.at(&it.path);
        let arguments = || -> Checked<Vec<syn::Expr>> {
            let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
            match parser.parse2(it.tokens.clone()) {
                Ok(arguments) => Ok(arguments.into_iter().collect()),
                Err(error) => Err(Fault::at(Some((*at).clone()), &error.to_string(), "", "")),
            }
        };
        let never = |message: &str, at| {
            Ok(Typed::new(
                Node::Panic(message.to_owned(), at),
                Type::plain(Head::Never),
            ))
        };
        match name.as_str() {
            "todo" | "unimplemented" => never("not yet implemented", at),
            "unreachable" => never("internal error: entered unreachable code", at),
            "panic" => never("the program panics here", at),
            "assert" | "debug_assert" => {
                let arguments = arguments()?;
                let Some(condition) = arguments.first() else {
                    return self.fault(
                        &it.path,
                        "requires a boolean expression as 1st argument",
                        "",
                        "",
                    );
                };
                let condition = self.given(condition, &Type::plain(Head::Bool))?;
                let panic = Node::Panic("assertion failed".to_owned(), at);
                Ok(Typed::new(
                    Node::If(Box::new(condition), Box::new(Node::Unit), Box::new(panic)),
                    Type::unit(),
                ))
            }
            "vec" => {
                let of = self.types.any();
                let all = arguments()?;
                let nodes = self.listed(all.iter(), &of)?;
                Ok(Typed::new(Node::Many(nodes), Type::one(Head::Vec, of)))
            }
            // Nobody sees what is printed beside the picture.
            "println" | "eprintln" | "print" | "eprint" | "dbg" => {
                self.unknown(it, &format!("`{name}!`: there is no place to print to"))
            }
            _ => self.unknown(it, &format!("`{name}!`")),
        }
    }
}
