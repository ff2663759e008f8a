//! Lowering: trees become nodes, with variables in slots and names found. What is declared is
//! known here; what is not is left to be checked when it runs.

mod calls;
mod loops;
mod macros;
mod patterns;

pub(crate) use calls::miscounted;

use std::mem;
use std::sync::Arc;

use syn::spanned::Spanned;

use crate::names::{Context, Inside, Named, Names, Signature, names};
use crate::node::{At, Function, Node, Root, Target};
use crate::operators::{Operator, operator};
use crate::read::{Refusal, at, at_expr, at_span};
use crate::types::{Head, Int, Type};

type Lowered<T = Typed> = Result<T, Refusal>;

/// A function that can be run.
pub(crate) fn lower(
    names: &Names,
    signature: &Signature,
    body: Option<Inside>,
) -> Lowered<Function> {
    let module = signature.module;
    let mut lowerer = Lowerer {
        names,
        file: names.file(module),
        context: Context {
            own: signature.of.clone(),
            ..Context::of(module)
        },
        locals: Vec::new(),
        slots: 0,
        slot_names: Vec::new(),
        loops: Vec::new(),
        result: signature.result.clone(),
    };
    lowerer.function(signature, body)
}

/// An expression: what it does, its type as far as that is known, and what can be assigned to
/// if it is a place.
#[derive(Clone)]
struct Typed {
    node: Node,
    ty: Type,
    target: Option<Target>,
    fixed: Option<Fixed>,
}

/// Why a place can't be changed: it is part of a variable that is not `mut`, or behind a `&`.
#[derive(Clone)]
enum Fixed {
    Variable(String),
    Behind,
}

impl Typed {
    fn new(node: Node, ty: impl Into<Type>) -> Self {
        Self {
            node,
            ty: ty.into(),
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
}

struct Lowerer<'n> {
    names: &'n Names,
    file: u32,
    context: Context,
    locals: Vec<Local>,
    slots: usize,
    slot_names: Vec<String>,
    /// Of each loop around whether it is ever left.
    loops: Vec<bool>,
    result: Type,
}

impl Lowerer<'_> {
    fn function(&mut self, signature: &Signature, body: Option<Inside>) -> Lowered<Function> {
        let body = match body {
            None => Node::Unit,
            Some(Inside::Constant(value)) => self.given(value, &signature.result)?,
            Some(Inside::Function(syntax, block)) => {
                // The arguments are in the first slots.
                self.slots = signature.parameters.len();
                for (n, (input, ty)) in syntax.inputs.iter().zip(&signature.parameters).enumerate()
                {
                    match input {
                        syn::FnArg::Receiver(it) => {
                            self.named("self", n, ty.clone(), it.mutability.is_some());
                        }
                        syn::FnArg::Typed(it) => match &*it.pat {
                            syn::Pat::Ident(name) if name.subpat.is_none() => {
                                let is_mut = name.mutability.is_some();
                                self.named(&name.ident.to_string(), n, ty.clone(), is_mut);
                            }
                            pattern => {
                                let at = self.at_any(pattern);
                                return Err(Refusal::unknown(at, "patterns as parameters"));
                            }
                        },
                    }
                }
                self.body(block, &signature.result)?
            }
        };
        Ok(Function {
            slots: self.slots,
            body,
            names: mem::take(&mut self.slot_names),
        })
    }

    /// The body of a function, which comes to its result.
    fn body(&mut self, block: &syn::Block, result: &Type) -> Lowered<Node> {
        let body = self.block(block)?;
        let last = block.stmts.last();
        if let Some(syn::Stmt::Expr(last, Some(_))) = last
            && body.ty == Type::UNIT
            && !body.ty.fits(result, self.names)
        {
            let label = format!("expected {}, found `()`", result.said(self.names));
            let help = "remove this semicolon to return this value";
            return Err(Refusal::new(
                self.at(last),
                "mismatched types",
                &label,
                help,
            ));
        }
        match last {
            Some(syn::Stmt::Expr(last, None)) => self.declared_of(last, body, result),
            _ => {
                let end = at_span(self.file, block.brace_token.span.close());
                self.declared(body, result, end)
            }
        }
    }

    fn at(&self, it: &syn::Expr) -> At {
        at_expr(self.file, it)
    }

    fn at_any(&self, it: &impl Spanned) -> At {
        at(self.file, it)
    }

    fn fault<T>(&self, at: At, message: &str, label: &str, help: &str) -> Lowered<T> {
        Err(Refusal::new(at, message, label, help))
    }

    fn refused<T>(&self, at: At, message: impl AsRef<str>) -> Lowered<T> {
        self.fault(at, message.as_ref(), "", "")
    }

    /// Of what is not known nothing can be asked: neither here nor there.
    fn needs_a_type<T>(&self, at: At) -> Lowered<T> {
        let help = "say its type where it begins: `let x: …`, or `|x: …|`";
        self.fault(at, "type annotations needed", "cannot infer type", help)
    }

    /// What is put into a variable of which not all is known says more of its type.
    fn learn(&mut self, of: &Typed, ty: &Type) {
        if let (Node::Local(slot), false) = (&of.node, of.ty.is_certain() || !ty.is_certain()) {
            let known = self.locals.iter_mut().rev().find(|it| it.slot == *slot);
            if let Some(local) = known {
                local.ty = ty.clone();
            }
        }
    }

    fn local(&mut self, name: &str, ty: Type, is_mut: bool) -> usize {
        let slot = self.slots;
        self.slots += 1;
        self.named(name, slot, ty, is_mut);
        slot
    }

    fn named(&mut self, name: &str, slot: usize, ty: Type, is_mut: bool) {
        let slots = self.slot_names.len().max(slot + 1);
        self.slot_names.resize(slots, String::new());
        name.clone_into(&mut self.slot_names[slot]);
        self.locals.push(Local {
            name: name.to_owned(),
            slot,
            ty,
            is_mut,
        });
    }

    /// A type without its references and boxes, and the value that they lead to.
    fn stripped(&self, mut typed: Typed) -> Typed {
        while matches!(typed.ty.0, Head::Ref | Head::Box | Head::RefMut) {
            typed = self.dereferenced(typed);
        }
        typed
    }

    /// What a reference or a box leads to.
    fn dereferenced(&self, typed: Typed) -> Typed {
        let ty = typed.ty.inner();
        match typed.ty.0 {
            Head::RefMut | Head::Unknown => Typed {
                target: Some(Target {
                    root: Root::Through(typed.node.clone()),
                    steps: Vec::new(),
                }),
                node: Node::Deref(Box::new(typed.node)),
                ty,
                fixed: None,
            },
            Head::Ref => Typed {
                fixed: Some(Fixed::Behind),
                ty,
                ..typed
            },
            _ => Typed { ty, ..typed },
        }
    }

    /// An expression whose value is to have that type.
    fn given(&mut self, value: &syn::Expr, ty: &Type) -> Lowered<Node> {
        let typed = match value {
            syn::Expr::Closure(it) => self.closure(it, ty)?,
            syn::Expr::Call(it) if is_default(it) && !ty.is_unknown() => {
                let made = self.conversion(Some(ty), "default", it, self.at(value))?;
                made.unwrap_or_else(|| Typed::new(Node::Default(Box::new(ty.clone())), ty.clone()))
            }
            value => self.expr(value)?,
        };
        self.declared_of(value, typed, ty)
    }

    /// The same of what an expression is known to be.
    fn declared_of(&self, value: &syn::Expr, typed: Typed, ty: &Type) -> Lowered<Node> {
        let is_lent = matches!(value, syn::Expr::Reference(it) if it.mutability.is_none());
        let help = if is_lent && typed.ty.inner().fits(ty, self.names) {
            "consider removing the borrow"
        } else {
            ""
        };
        let declared = self.declared(typed, ty, self.at(value));
        declared.map_err(|it| it.or_help(help))
    }

    /// The same of what is known: refused, taken, or checked when it runs.
    fn declared(&self, typed: Typed, ty: &Type, at: At) -> Lowered<Node> {
        if !typed.ty.fits(ty, self.names) {
            return Err(self.names.mismatch(ty, &typed.ty, at));
        }
        let node = match (typed.ty.0, ty.0) {
            (Head::RefMut, head) if !matches!(head, Head::RefMut | Head::Unknown) => {
                Node::Deref(Box::new(typed.node))
            }
            _ => typed.node,
        };
        match (typed.ty.0, ty.0) {
            (Head::Never, _) | (_, Head::Unknown | Head::Fn | Head::Param(_)) => Ok(node),
            (Head::Int(Int::Any), Head::Int(int)) if int != Int::Any => {
                self.literal_as(node, ty, at)
            }
            _ if typed.ty.is_certain() => Ok(node),
            _ => Ok(Node::Declared(Box::new(node), Box::new(ty.clone()), at)),
        }
    }

    /// A number as the type that it is to have.
    fn literal_as(&self, node: Node, ty: &Type, at: At) -> Lowered<Node> {
        match (node, ty.0) {
            (Node::Int(it, _), Head::Int(int)) if int.fits(it) => Ok(Node::Int(it, int)),
            (Node::Int(..), _) => self.refused(
                at,
                format!("literal out of range for `{}`", ty.name(self.names)),
            ),
            (node, _) => Ok(Node::Declared(Box::new(node), Box::new(ty.clone()), at)),
        }
    }

    fn block(&mut self, block: &syn::Block) -> Lowered {
        let outside = self.locals.len();
        let mut nodes = Vec::new();
        let mut value = Type::UNIT;
        let mut is_left = false;
        let mut has_value = false;
        for (n, statement) in block.stmts.iter().enumerate() {
            let is_last = n + 1 == block.stmts.len();
            has_value = false;
            let done = match statement {
                syn::Stmt::Local(it) => self.declaration(it)?,
                syn::Stmt::Item(it) => {
                    let what = "declarations in a function";
                    return Err(Refusal::unknown(self.at_any(it), what));
                }
                syn::Stmt::Macro(it) => {
                    has_value = is_last && it.semi_token.is_none();
                    self.macro_call(&it.mac)?
                }
                syn::Stmt::Expr(it, semicolon) => {
                    has_value = is_last && semicolon.is_none();
                    let typed = self.expr(it)?;
                    let is_block = matches!(
                        it,
                        syn::Expr::If(_) | syn::Expr::Match(_) | syn::Expr::Block(_)
                    );
                    if semicolon.is_none() && !is_last && is_block {
                        let node = self.declared(typed, &Type::UNIT, self.at(it))?;
                        Typed::new(node, Type::UNIT)
                    } else {
                        typed
                    }
                }
            };
            is_left = is_left || done.ty.is(Head::Never);
            if has_value {
                value = done.ty;
            }
            nodes.push(done.node);
        }
        self.locals.truncate(outside);
        if is_left && !has_value {
            value = Head::Never.into();
        }
        Ok(Typed::new(Node::Block(nodes, has_value), value))
    }

    fn declaration(&mut self, it: &syn::Local) -> Lowered {
        let (pattern, written) = match &it.pat {
            syn::Pat::Type(it) => (&*it.pat, Some(self.names.ty(&self.context, &it.ty)?)),
            pattern => (pattern, None),
        };
        let Some(init) = &it.init else {
            // It gets its value later, once.
            self.pattern(pattern, &written.unwrap_or(Type::UNKNOWN), true)?;
            return Ok(Typed::new(Node::Unit, Type::UNIT));
        };
        let (node, ty) = match written {
            Some(ty) => (self.given(&init.expr, &ty)?, ty),
            None => {
                let typed = self.expr(&init.expr)?;
                (typed.node, typed.ty)
            }
        };
        let other = match &init.diverge {
            None => None,
            Some((_, other)) => {
                let typed = self.expr(other)?;
                Some(Box::new(self.declared(
                    typed,
                    &Head::Never.into(),
                    self.at(other),
                )?))
            }
        };
        let is_never = ty.is(Head::Never);
        let bound = self.pattern(pattern, &ty.settled(), false)?;
        if other.is_none() && !bound.is_irrefutable() {
            let message = "refutable pattern in local binding";
            return self.fault(
                self.at_any(pattern),
                message,
                "",
                "`let … else { … }`, or `if let`",
            );
        }
        let ty = if is_never {
            Head::Never.into()
        } else {
            Type::UNIT
        };
        Ok(Typed::new(
            Node::Let(Box::new(bound), Box::new(node), other),
            ty,
        ))
    }

    fn expr(&mut self, expr: &syn::Expr) -> Lowered {
        match expr {
            syn::Expr::Lit(it) => self.literal(&it.lit),
            syn::Expr::Paren(it) => self.expr(&it.expr),
            syn::Expr::Group(it) => self.expr(&it.expr),
            syn::Expr::Path(it) => self.path(it),
            syn::Expr::Unary(it) => self.unary(it),
            syn::Expr::Binary(it) => self.binary(it),
            syn::Expr::Assign(it) => self.assignment(it),
            syn::Expr::Call(it) => self.call(it),
            syn::Expr::MethodCall(it) => self.method_call(it),
            syn::Expr::Field(it) => self.field(it),
            syn::Expr::Index(it) => self.index(it),
            syn::Expr::Block(it) if it.label.is_none() => self.block(&it.block),
            syn::Expr::If(it) => self.condition(it),
            syn::Expr::Let(it) => self.test(it),
            syn::Expr::Match(it) => self.matching(it),
            syn::Expr::While(it) => self.while_loop(it),
            syn::Expr::Loop(it) => self.endless_loop(it),
            syn::Expr::ForLoop(it) => self.for_loop(it),
            syn::Expr::Break(it) => self.leave_loop(it),
            syn::Expr::Continue(_) => {
                self.inside_a_loop(self.at(expr), "continue")?;
                Ok(Typed::new(Node::Continue, Head::Never))
            }
            syn::Expr::Return(it) => self.returned(it, self.at(expr)),
            syn::Expr::Closure(it) => self.closure(it, &Type::UNKNOWN),
            syn::Expr::Tuple(it) => self.tuple(it),
            syn::Expr::Array(it) => {
                let (nodes, of) = self.listed(&it.elems)?;
                let head = Head::Array(nodes.len());
                Ok(Typed::new(Node::Many(nodes), Type::of(head, of)))
            }
            syn::Expr::Range(it) => self.range(it),
            syn::Expr::Reference(it) => self.reference(it),
            syn::Expr::Cast(it) => self.cast(it),
            syn::Expr::Try(it) => self.tried(it),
            syn::Expr::Struct(it) => self.structure(it),
            syn::Expr::Macro(it) => self.macro_call(&it.mac),
            syn::Expr::Unsafe(_) => Err(Refusal::unknown(self.at(expr), "`unsafe`")),
            _ => Err(Refusal::unknown(self.at(expr), "this kind of expression")),
        }
    }

    fn assignment(&mut self, it: &syn::ExprAssign) -> Lowered {
        let left = self.expr(&it.left)?;
        let right = self.expr(&it.right)?;
        self.learn(&left, &right.ty.clone().settled());
        let right = self.declared(right, &left.ty, self.at(&it.right))?;
        let target = self.assignable(left, &it.left)?;
        let node = Node::Set(Box::new(target), Box::new(right));
        Ok(Typed::new(node, Type::UNIT))
    }

    /// `let … = …` as a condition.
    fn test(&mut self, it: &syn::ExprLet) -> Lowered {
        let value = self.expr(&it.expr)?;
        let pattern = self.pattern(&it.pat, &value.ty, false)?;
        let node = Node::Matches(Box::new(pattern), Box::new(value.node));
        Ok(Typed::new(node, Head::Bool))
    }

    fn returned(&mut self, it: &syn::ExprReturn, at: At) -> Lowered {
        let result = self.result.clone();
        let value = match &it.expr {
            Some(value) => self.given(value, &result)?,
            None => self.declared(Typed::new(Node::Unit, Type::UNIT), &result, at)?,
        };
        Ok(Typed::new(Node::Return(Box::new(value)), Head::Never))
    }

    fn tuple(&mut self, it: &syn::ExprTuple) -> Lowered {
        if it.elems.is_empty() {
            return Ok(Typed::new(Node::Unit, Type::UNIT));
        }
        let all = it.elems.iter().map(|it| {
            let typed = self.expr(it)?;
            Ok((typed.node, typed.ty.settled()))
        });
        let (nodes, types) = all.collect::<Lowered<_>>()?;
        Ok(Typed::new(Node::Tuple(nodes), Type(Head::Tuple, types)))
    }

    fn reference(&mut self, it: &syn::ExprReference) -> Lowered {
        let of = self.expr(&it.expr)?;
        if it.mutability.is_none() {
            return Ok(Typed::new(of.node, Type::of(Head::Ref, of.ty)));
        }
        let ty = Type::of(Head::RefMut, of.ty.clone());
        let target = self.mutable(of, &it.expr)?;
        Ok(Typed::new(Node::Address(Box::new(target)), ty))
    }

    /// Values of one type, as far as it is known.
    fn listed<'s>(
        &mut self,
        all: impl IntoIterator<Item = &'s syn::Expr>,
    ) -> Lowered<(Vec<Node>, Type)> {
        let mut of = Type::UNKNOWN;
        let nodes = all.into_iter().map(|it| {
            let typed = self.expr(it)?;
            if !typed.ty.fits(&of, self.names) {
                return Err(self.names.mismatch(&of, &typed.ty, self.at(it)));
            }
            if of.is_unknown() {
                of = typed.ty.clone().settled();
            }
            Ok(typed.node)
        });
        let nodes = nodes.collect::<Lowered<_>>()?;
        Ok((nodes, of))
    }

    fn literal(&mut self, literal: &syn::Lit) -> Lowered {
        let place = self.at_any(literal);
        let suffixed = |suffix: &str, what: &str| match suffix {
            "" => Ok(None),
            "f64" => Ok(Some(Head::F64)),
            name => match self.names.found(self.context.module, &[name.to_owned()]) {
                Ok(Named::Type(Type(head @ Head::Int(_), _))) => Ok(Some(head)),
                Ok(Named::Standard(_)) => Err(Refusal::unknown(place, &format!("`{name}`"))),
                _ => {
                    let message = format!("invalid suffix `{name}` for {what} literal");
                    let help = format!("a sign is missing before `{name}`, or a blank");
                    Err(Refusal::new(
                        place,
                        &message,
                        &format!("invalid suffix `{name}`"),
                        &help,
                    ))
                }
            },
        };
        Ok(match literal {
            syn::Lit::Bool(it) => Typed::new(Node::Bool(it.value), Head::Bool),
            syn::Lit::Float(it) => {
                let value: f64 = it.base10_digits().parse().unwrap_or(f64::NAN);
                let head = suffixed(it.suffix(), "float")?;
                Typed::new(Node::Float(value), head.unwrap_or(Head::Float))
            }
            syn::Lit::Int(it) => {
                let Ok(value) = it.base10_digits().parse::<i128>() else {
                    return self.refused(place, "integer literal is too large");
                };
                match suffixed(it.suffix(), "number")? {
                    Some(Head::F64) => Typed::new(Node::Float(value as f64), Head::F64),
                    Some(Head::Int(int)) => Typed::new(Node::Int(value, int), Head::Int(int)),
                    _ => Typed::new(Node::Int(value, Int::Any), Head::Int(Int::Any)),
                }
            }
            syn::Lit::Str(it) => Typed::new(
                Node::Str(Arc::from(it.value())),
                Type::of(Head::Ref, Head::Str.into()),
            ),
            _ => return Err(Refusal::unknown(place, "this kind of literal")),
        })
    }

    /// Looks a variable up.
    fn variable(&self, name: &str) -> Option<Typed> {
        let local = self.locals.iter().rev().find(|it| it.name == name)?;
        Some(Typed {
            node: Node::Local(local.slot),
            ty: local.ty.clone(),
            target: Some(Target {
                root: Root::Local(local.slot),
                steps: Vec::new(),
            }),
            fixed: (!local.is_mut).then(|| Fixed::Variable(name.to_owned())),
        })
    }

    /// What may be borrowed to be changed.
    fn mutable(&self, typed: Typed, at: &syn::Expr) -> Lowered<Target> {
        let message = match (typed.target, typed.fixed) {
            (Some(target), None) => return Ok(target),
            (Some(_), Some(Fixed::Variable(name))) => {
                format!("cannot borrow `{name}` as mutable, as it is not declared as mutable")
            }
            (Some(_), Some(Fixed::Behind)) => {
                "cannot change this, as it is behind a `&` reference".to_owned()
            }
            (None, _) => {
                let what = "changes of a part of a list, or of a value without a name";
                return Err(Refusal::unknown(self.at(at), what));
            }
        };
        self.refused(self.at(at), message)
    }

    fn assignable(&self, typed: Typed, at: &syn::Expr) -> Lowered<Target> {
        match (&typed.target, &typed.fixed) {
            (Some(target), Some(Fixed::Variable(name))) if target.steps.is_empty() => {
                let message = format!("cannot assign twice to immutable variable `{name}`");
                self.refused(self.at(at), message)
            }
            _ => self.mutable(typed, at),
        }
    }

    fn condition(&mut self, it: &syn::ExprIf) -> Lowered {
        let outside = self.locals.len();
        let condition = self.given(&it.cond, &Head::Bool.into())?;
        let then = self.block(&it.then_branch)?;
        self.locals.truncate(outside);
        let Some((_, other)) = &it.else_branch else {
            if !then.ty.fits(&Type::UNIT, self.names) {
                let last = it.then_branch.stmts.last();
                let place = last.map_or_else(|| self.at_any(it), |last| self.at_any(last));
                let label = format!("expected `()`, found {}", then.ty.said(self.names));
                let help = "`return …;`, or an `else` that gives the other value";
                return self.fault(place, "mismatched types", &label, help);
            }
            let at = self.at_any(&it.then_branch);
            let then = self.declared(then, &Type::UNIT, at)?;
            return Ok(Typed::new(
                Node::If(Box::new([condition, then, Node::Unit])),
                Type::UNIT,
            ));
        };
        let other_typed = self.expr(other)?;
        let place = match &**other {
            syn::Expr::Block(it) => it.block.stmts.last().map(|it| self.at_any(it)),
            _ => None,
        };
        let place = place.unwrap_or_else(|| self.at(other));
        let ty = self.joined(
            &then.ty,
            &other_typed.ty,
            "`if` and `else` have incompatible types",
            place,
        )?;
        Ok(Typed::new(
            Node::If(Box::new([condition, then.node, other_typed.node])),
            ty,
        ))
    }

    /// The type of two ways to the same value.
    fn joined(&self, one: &Type, other: &Type, message: &str, at: At) -> Lowered<Type> {
        if !one.fits(other, self.names) && !other.fits(one, self.names) {
            let label = format!(
                "expected {}, found {}",
                one.said(self.names),
                other.said(self.names)
            );
            return self.fault(at, message, &label, "");
        }
        Ok(
            match (
                one.is(Head::Never),
                other.is_certain() && !other.is(Head::Never),
            ) {
                (false, true) if !one.is_certain() || one.is(Head::Float) => other.clone(),
                (true, _) => other.clone(),
                _ => one.clone(),
            },
        )
    }

    fn range(&mut self, it: &syn::ExprRange) -> Lowered {
        let (Some(from), Some(to)) = (&it.start, &it.end) else {
            let what = "ranges without a beginning or an end";
            return Err(Refusal::unknown(self.at_any(it), what));
        };
        let ends = [self.expr(from)?, self.expr(to)?];
        let [one, other] = [&ends[0].ty, &ends[1].ty];
        let of = self.joined(other, one, "mismatched types", self.at(to))?;
        let is_closed = matches!(it.limits, syn::RangeLimits::Closed(_));
        let nodes = ends.map(|it| it.node);
        Ok(Typed::new(
            Node::Range(Box::new(nodes), is_closed),
            Type::of(Head::Range, of),
        ))
    }

    fn cast(&mut self, it: &syn::ExprCast) -> Lowered {
        let from = self.expr(&it.expr)?;
        let to = self.names.ty(&self.context, &it.ty)?;
        let ty = &from.ty;
        let is_number = |it: &Type| it.is_integer() || it.is_float();
        let fits = match to.0 {
            _ if ty.is_unknown() || ty.is(Head::Never) => true,
            Head::Int(_) if ty.is(Head::Bool) => true,
            _ => is_number(ty) && is_number(&to) || *ty == to,
        };
        let at = self.at_any(it);
        if !fits {
            return Err(self.names.no_cast(ty, &to, at));
        }
        Ok(Typed::new(
            Node::Cast(Box::new(from.node), Box::new(to.clone()), at),
            to,
        ))
    }

    fn tried(&mut self, it: &syn::ExprTry) -> Lowered {
        let of = self.expr(&it.expr)?;
        let at = self.at_any(&it.question_token);
        if !of.ty.is_unknown() && !of.ty.is(Head::Option) {
            let name = of.ty.name(self.names);
            return self.refused(self.at_any(it), format!(
                "the `?` operator can only be applied to values that implement `Try`, and this is `{name}`"
            ));
        }
        if !self.result.is_unknown() && !self.result.is(Head::Option) {
            let message =
                "the `?` operator can only be used in a function that returns `Result` or `Option`";
            let label = format!("this one returns `{}`", self.result.name(self.names));
            return self.fault(at, message, &label, "");
        }
        Ok(Typed::new(Node::Try(Box::new(of.node)), of.ty.inner()))
    }

    fn structure(&mut self, it: &syn::ExprStruct) -> Lowered {
        let ty = self.struct_named(&it.path)?;
        let mut nodes = self.fields_given(it, &ty)?;
        let base = match &it.rest {
            Some(rest) => Some(Box::new(self.given(rest, &ty)?)),
            None => None,
        };
        if let Head::Own(kind) = ty.0 {
            return Ok(Typed::new(Node::New(kind as u32, nodes, base), ty));
        }
        let at = self.at_any(&it.path);
        if base.is_some() {
            return Err(Refusal::unknown(at, "such an initializer"));
        }
        nodes.sort_by_key(|it| it.0);
        let nodes = nodes.into_iter().map(|it| it.1).collect();
        let node = self.native(&ty.name(self.names), "new", nodes, at);
        Ok(Typed::new(node, ty))
    }

    /// The type that a path names, which has fields.
    fn struct_named(&self, path: &syn::Path) -> Lowered<Type> {
        let (path, at) = (names(path), self.at_any(path));
        let named = match (path.as_slice(), &self.context.own) {
            ([name], Some(own)) if name == "Self" => Ok(Named::Type(own.clone())),
            (path, _) => self.names.found(self.context.module, path),
        };
        let what = "struct, variant or union type";
        match named {
            Ok(Named::Type(ty)) if matches!(ty.0, Head::Own(_) | Head::Vec3 | Head::Ray) => Ok(ty),
            Ok(Named::Standard(name)) => Err(Refusal::unknown(at, &format!("`{name}`"))),
            Ok(_) => {
                let message = format!("expected {what}, found `{}`", path.join("::"));
                self.fault(at, &message, &format!("not a {what}"), "")
            }
            Err(lost) => {
                let module = self.context.module;
                Err(self.names.not_found(module, at, what, &path, lost))
            }
        }
    }

    /// The fields of an initializer by their numbers.
    fn fields_given(&mut self, it: &syn::ExprStruct, ty: &Type) -> Lowered<Vec<(usize, Node)>> {
        let mut nodes: Vec<(usize, Node)> = Vec::new();
        for field in &it.fields {
            let name = member(&field.member);
            let at = self.at_any(&field.member);
            let (n, of) = self.names.field(ty, &name, self.context.module, at)?;
            if nodes.iter().any(|it| it.0 == n) {
                return self.refused(at, format!("field `{name}` specified more than once"));
            }
            nodes.push((n, self.given(&field.expr, &of)?));
        }
        let known = self.names.fields_of(ty);
        let mut all = known.iter().enumerate();
        let missing = all.find(|(n, _)| nodes.iter().all(|it| it.0 != *n));
        match missing {
            Some((_, missing)) if it.rest.is_none() => {
                let name = ty.name(self.names);
                let message = format!("missing field `{}` in initializer of `{name}`", missing.0);
                self.refused(self.at_any(&it.path), message)
            }
            _ => Ok(nodes),
        }
    }

    fn field(&mut self, it: &syn::ExprField) -> Lowered {
        let base = self.expr(&it.base)?;
        let name = member(&it.member);
        let at = at_span(self.file, it.member.span());
        if base.ty.stripped().is_unknown() {
            return self.needs_a_type(at);
        }
        let (n, ty) = self.names.field(&base.ty, &name, self.context.module, at)?;
        let on = self.stripped(base);
        let target = on.target.map(|mut target| {
            target.steps.push(n);
            target
        });
        Ok(Typed {
            node: Node::Field(Box::new(on.node), n),
            ty,
            target,
            fixed: on.fixed,
        })
    }

    fn index(&mut self, it: &syn::ExprIndex) -> Lowered {
        let base = self.expr(&it.expr)?;
        let name = base.ty.name(self.names);
        let on = self.stripped(base);
        let of = match on.ty.0 {
            Head::Vec | Head::Slice | Head::Array(_) | Head::Unknown => on.ty.inner(),
            Head::Vec3 => Head::F64.into(),
            _ => {
                return self.refused(
                    self.at_any(it),
                    format!("cannot index into a value of type `{name}`"),
                );
            }
        };
        let index = self.expr(&it.index)?;
        let at = self.at_any(it);
        if index.ty.is(Head::Range) {
            return Err(Refusal::unknown(self.at(&it.index), "slices by a range"));
        }
        let usize = Type::from(Head::Int(Int::Usize));
        if !index.ty.fits(&usize, self.names) {
            let [of, by] = [&of, &index.ty].map(|it| it.name(self.names));
            let message = format!("the type `[{of}]` cannot be indexed by `{by}`");
            return self.fault(self.at(&it.index), &message, "an index is a `usize`", "");
        }
        let index = self.declared(index, &usize, self.at(&it.index))?;
        Ok(Typed::new(Node::Index(Box::new([on.node, index]), at), of))
    }

    fn unary(&mut self, it: &syn::ExprUnary) -> Lowered {
        let of = self.expr(&it.expr)?;
        let at = self.at_any(it);
        match it.op {
            syn::UnOp::Deref(_) => match of.ty.0 {
                Head::Ref | Head::RefMut | Head::Box | Head::Unknown => Ok(self.dereferenced(of)),
                _ => {
                    let name = of.ty.name(self.names);
                    self.refused(at, format!("type `{name}` cannot be dereferenced"))
                }
            },
            syn::UnOp::Not(_) => {
                let of = self.stripped(of);
                match of.ty.0 {
                    Head::Int(_) => Err(Refusal::unknown(at, "`!` of integers")),
                    Head::Bool | Head::Unknown => {
                        Ok(Typed::new(Node::Not(Box::new(of.node), at), of.ty))
                    }
                    _ => Err(self.names.no_unary("!", &of.ty, at)),
                }
            }
            syn::UnOp::Neg(_) => {
                let of = self.stripped(of);
                if let Some(own) = self.names.method(&of.ty, "neg", None) {
                    let result = self.names.functions[own].result.clone();
                    return Ok(Typed::new(Node::Call(own, Box::new([of.node]), at), result));
                }
                let is_signed = match of.ty.0 {
                    Head::Int(int) => int.is_signed(),
                    Head::Vec3 | Head::Unknown | Head::Never => true,
                    _ => of.ty.is_float(),
                };
                match of.node {
                    _ if !is_signed => Err(self.names.no_unary("-", &of.ty, at)),
                    Node::Int(it, int) => Ok(Typed::new(Node::Int(-it, int), of.ty)),
                    Node::Float(it) => Ok(Typed::new(Node::Float(-it), of.ty)),
                    node => Ok(Typed::new(Node::Negate(Box::new(node), at), of.ty)),
                }
            }
            _ => Err(Refusal::unknown(at, "this operator")),
        }
    }

    fn binary(&mut self, it: &syn::ExprBinary) -> Lowered {
        let at = At {
            end: self.at(&it.right).end,
            ..self.at(&it.left)
        };
        let Some(operator) = operator(&it.op) else {
            let sign = it.op.span().source_text().unwrap_or_default();
            let types = [self.expr(&it.left)?.ty, self.expr(&it.right)?.ty];
            return Err(self.names.no_bits(&sign, [&types[0], &types[1]], at));
        };
        let bool = Type::from(Head::Bool);
        match operator {
            Operator::And | Operator::Or => {
                let nodes = Box::new([self.given(&it.left, &bool)?, self.given(&it.right, &bool)?]);
                let node = match operator {
                    Operator::And => Node::And(nodes),
                    _ => Node::Or(nodes),
                };
                Ok(Typed::new(node, bool))
            }
            Operator::Compare(order) => {
                let (left, right) = (self.expr(&it.left)?, self.expr(&it.right)?);
                let types = [&left.ty, &right.ty];
                self.names
                    .comparable(order, types, at, self.at(&it.right))?;
                let nodes = [left, right].map(|it| self.stripped(it).node);
                Ok(Typed::new(Node::Compare(order, Box::new(nodes), at), bool))
            }
            Operator::Arithmetic(sign, is_assignment) => {
                let (left, right) = (self.expr(&it.left)?, self.expr(&it.right)?);
                self.arithmetic(sign, is_assignment, [left, right], &it.left, at)
            }
        }
    }

    fn arithmetic(
        &mut self,
        sign: crate::node::Sign,
        is_assignment: bool,
        [left, right]: [Typed; 2],
        left_at: &syn::Expr,
        at: At,
    ) -> Lowered {
        let [one, other] = [&left, &right].map(|it| self.stripped(it.clone()));
        let refused = self.names.no_operator(sign, [&left.ty, &right.ty], at);
        if is_assignment && matches!(one.ty.0, Head::Own(_)) {
            let what = "operators that change a struct";
            return Err(Refusal::unknown(at, what));
        }
        let Some(ty) = self.names.result_of(sign, &one.ty, &other.ty) else {
            return Err(refused);
        };
        if !is_assignment {
            let nodes = Box::new([one.node, other.node]);
            let node = match self.names.operator(sign, [&one.ty, &other.ty]) {
                Some(own) if !one.ty.is_unknown() && !other.ty.is_unknown() => {
                    Node::Call(own, nodes, at)
                }
                _ => Node::Arithmetic(sign, nodes, at),
            };
            return Ok(Typed::new(node, ty));
        }
        // `*x += 1`, but `x += 1` only where x is no reference.
        if left.ty.is_reference() || !ty.fits(&one.ty, self.names) {
            return Err(refused);
        }
        let target = self.assignable(left, left_at)?;
        Ok(Typed::new(
            Node::Update(Box::new(target), sign, Box::new(other.node), at),
            Type::UNIT,
        ))
    }
}

impl Type {
    /// Whether all of it is known, so that nothing need be checked when it runs.
    fn is_certain(&self) -> bool {
        let is_open = matches!(self.0, Head::Unknown | Head::Int(Int::Any) | Head::RefMut);
        !is_open && self.1.iter().all(Self::is_certain)
    }
}

/// `Default::default()`, whose type is that of its place.
fn is_default(it: &syn::ExprCall) -> bool {
    matches!(&*it.func, syn::Expr::Path(it) if names(&it.path) == ["Default", "default"])
}

/// The name of a field, or its number.
fn member(it: &syn::Member) -> String {
    match it {
        syn::Member::Named(name) => name.to_string(),
        syn::Member::Unnamed(n) => n.index.to_string(),
    }
}
