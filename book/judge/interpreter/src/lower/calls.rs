//! Calls: a name on a type, then on what the type leads to, until one is found. Where the type
//! is not known, it is looked up when it runs.

use std::sync::Arc;

use common::rtweekend::Vec3;

use super::{Lowered, Lowerer, Typed};
use crate::names::{Callee, Named, Signature, names, there_is};
use crate::node::{At, Closure, Node};
use crate::prelude;
use crate::read::{Refusal, at_span};
use crate::types::{Head, Int, Type};

impl Lowerer<'_> {
    /// A name that is a value: a variable, a constant, a function.
    pub(super) fn path(&mut self, it: &syn::ExprPath) -> Lowered {
        let path = names(&it.path);
        if let [name] = path.as_slice()
            && let Some(found) = self.variable(name)
        {
            return Ok(found);
        }
        if path.last().is_some_and(|it| it == "None") {
            return Ok(Typed::new(
                Node::None,
                Type::of(Head::Option, Type::UNKNOWN),
            ));
        }
        let at = self.at_any(it);
        if let Ok(Named::Number(number)) = self.names.found(self.context.module, &path) {
            return Ok(Typed::new(Node::Float(number), Head::F64));
        }
        let (owner, name) = self.owner(&path, at)?;
        if let Some(owner) = &owner
            && self.names.method(owner, &name, None).is_none()
            && let Some((node, ty)) = prelude::constant(owner, &name)
        {
            return Ok(Typed::new(node, ty));
        }
        let callee = self.function_named(owner.as_ref(), &name, &path, at, "value")?;
        let signature = self.signature(callee);
        if let (Callee::Own(function), true) = (callee, signature.is_constant) {
            return Ok(Typed::new(Node::Constant(function, at), signature.result));
        }
        let ty = Type(
            Head::Fn,
            [signature.parameters, vec![signature.result]].concat(),
        );
        match callee {
            Callee::Own(function) => Ok(Typed::new(Node::Function(function), ty)),
            Callee::Native(native) => {
                let ty = ty.with(&[Type::UNKNOWN, Type::UNKNOWN, Type::UNKNOWN]);
                Ok(Typed::new(Node::NativeFunction(native, at), ty))
            }
            Callee::Dynamic(_) => Err(Refusal::unknown(at, "methods of traits as values")),
        }
    }

    /// The type before the last `::`, if a type is there, and what comes after.
    fn owner(&self, path: &[String], at: At) -> Lowered<(Option<Type>, String)> {
        let (name, before) = path.split_last().expect("a path has a name");
        let own = self.context.own.clone().filter(|_| before == ["Self"]);
        let owner = match (before, own) {
            ([], _) => None,
            (_, Some(own)) => Some(own),
            (before, None) => match self.names.found(self.context.module, before) {
                Ok(Named::Type(ty)) => Some(ty),
                Ok(Named::Generic(head)) => Some(Type::of(head, Type::UNKNOWN)),
                Ok(Named::Trait(of)) => Some(Head::Dyn(of).into()),
                Ok(Named::Standard(_)) => Some(Type::UNKNOWN),
                Ok(_) => None,
                Err(lost) => {
                    let module = self.context.module;
                    return Err(self.names.not_found(module, at, "type", before, lost));
                }
            },
        };
        Ok((owner, name.clone()))
    }

    fn function_named(
        &self,
        owner: Option<&Type>,
        name: &str,
        path: &[String],
        at: At,
        what: &str,
    ) -> Lowered<Callee> {
        let module = self.context.module;
        if let Some(owner) = owner {
            let Some(callee) = self.names.callee(owner, name) else {
                let message = format!(
                    "no function or associated item named `{name}` found for `{}` in the current scope",
                    owner.name(self.names)
                );
                return Err(self.names.lacks(owner, name, &message, "", at));
            };
            self.shown(callee, at)?;
            return Ok(callee);
        }
        match self.names.found(module, path) {
            Ok(Named::Function(function)) => Ok(Callee::Own(function)),
            Ok(Named::Library(name)) => {
                let native = prelude::native("", name).expect("it is listed");
                Ok(Callee::Native(native))
            }
            Ok(Named::Standard(name)) => Err(Refusal::unknown(at, &format!("`{name}`"))),
            Ok(_) => {
                let message = format!("expected {what}, found `{}`", path.join("::"));
                self.fault(at, &message, &format!("not a {what}"), "")
            }
            Err(lost) => {
                let refusal = self.names.not_found(module, at, what, path, lost);
                let locals = self.locals.iter().map(|it| it.name.as_str());
                let is_local = path.len() == 1 && what == "value";
                Err(refusal.or_help(&there_is(name, locals.filter(|_| is_local))))
            }
        }
    }

    /// Whether it may be called here.
    fn shown(&self, callee: Callee, at: At) -> Lowered<()> {
        let hidden = match callee {
            Callee::Own(own) => self.names.hidden(self.context.module, own, at),
            _ => None,
        };
        hidden.map_or(Ok(()), Err)
    }

    fn signature(&self, callee: Callee) -> Signature {
        match callee {
            Callee::Own(own) | Callee::Dynamic(own) => self.names.functions[own].clone(),
            Callee::Native(native) => native.signature.clone(),
        }
    }

    pub(super) fn call(&mut self, it: &syn::ExprCall) -> Lowered {
        let at = At {
            end: at_span(self.file, it.paren_token.span.close()).end,
            ..self.at(&it.func)
        };
        let syn::Expr::Path(function) = &*it.func else {
            let function = self.expr(&it.func)?;
            return self.call_value(function, it, at);
        };
        let path = names(&function.path);
        if let [name] = path.as_slice()
            && let Some(found) = self.variable(name)
        {
            return self.call_value(found, it, at);
        }
        if let Some("Some" | "Ok") = path.last().map(String::as_str) {
            return self.wrapped(it, path[0] == "Ok", at);
        }
        let at_path = self.at_any(&function.path);
        let (owner, name) = self.owner(&path, at_path)?;
        if let Some(made) = self.conversion(owner.as_ref(), &name, it, at)? {
            return Ok(made);
        }
        let callee = self.function_named(owner.as_ref(), &name, &path, at_path, "function")?;
        let signature = self.signature(callee);
        if signature.is_constant {
            return self.refused(at, "expected function, found a constant");
        }
        // `f64::sqrt(x)` and `Hittable::hit(&sphere, …)`: a method by its full name.
        if signature.has_self && !matches!(callee, Callee::Own(_)) {
            let Some(receiver) = it.args.first() else {
                return Err(miscounted(false, signature.parameters.len(), 0, at));
            };
            let mut typed = self.expr(receiver)?;
            // The path says which number a literal is.
            if owner.is_some_and(|it| it.is(Head::F64)) && typed.ty.is(Head::Float) {
                typed.ty = Head::F64.into();
            }
            let rest = it.args.iter().skip(1).collect();
            return self.method(typed, receiver, &name, rest, (at, at));
        }
        let of = owner.as_ref().map_or(Type::UNKNOWN, Type::inner);
        let mut with = vec![of, Type::UNKNOWN, owner.unwrap_or(Type::UNKNOWN)];
        let nodes = self.arguments(&signature.parameters, &it.args, at, &mut with)?;
        Ok(self.made(callee, nodes, signature.result.with(&with), at))
    }

    /// `Some(…)`, and the `Ok(…)` of what writes text.
    fn wrapped(&mut self, it: &syn::ExprCall, is_ok: bool, at: At) -> Lowered {
        let Some(argument) = it.args.first().filter(|_| it.args.len() == 1) else {
            return Err(miscounted(false, 1, it.args.len(), at));
        };
        let of = self.expr(argument)?;
        let ty = if is_ok {
            Type::UNKNOWN
        } else {
            Type::of(Head::Option, of.ty)
        };
        Ok(Typed::new(Node::Some(Box::new(of.node)), ty))
    }

    /// What is made of other types: `f64::from(…)`, and what is there by default.
    pub(super) fn conversion(
        &mut self,
        owner: Option<&Type>,
        name: &str,
        it: &syn::ExprCall,
        at: At,
    ) -> Lowered<Option<Typed>> {
        let Some(owner) = owner else {
            return Ok(None);
        };
        if name == "from" && owner.is(Head::F64) && it.args.len() == 1 {
            let from = self.expr(&it.args[0])?;
            return self.as_f64(from, at).map(Some);
        }
        let is_written = self.names.method(owner, "default", None).is_some();
        if name != "default" || !it.args.is_empty() || is_written {
            return Ok(None);
        }
        let has_none = match owner.0 {
            Head::Own(_) => !self.names.derives(owner, "Default"),
            Head::Ray | Head::Picture | Head::Dyn(_) => true,
            Head::Unknown => return Err(Refusal::unknown(at, "a default without its type")),
            _ => false,
        };
        if has_none {
            let message = format!(
                "no function or associated item named `default` found for `{}` in the current scope",
                owner.name(self.names)
            );
            let help = "`#[derive(Default)]` above the struct gives one";
            return self.fault(at, &message, "", help);
        }
        let node = Node::Default(Box::new(owner.clone()));
        Ok(Some(Typed::new(node, owner.clone())))
    }

    /// A number as an `f64`, if that has room for all of its type.
    fn as_f64(&self, from: Typed, at: At) -> Lowered {
        let fits = match from.ty.0 {
            Head::Int(int) => int == Int::Any || int.ends().1 < 1 << 32,
            Head::Unknown | Head::Never => true,
            _ => from.ty.is_float(),
        };
        if !fits {
            let name = from.ty.name(self.names);
            let message = format!("the trait bound `f64: From<{name}>` is not satisfied");
            return self.fault(at, &message, "", "`… as f64`");
        }
        let f64 = Type::from(Head::F64);
        let node = Node::Cast(Box::new(from.node), Box::new(f64.clone()), at);
        Ok(Typed::new(node, f64))
    }

    fn call_value(&mut self, function: Typed, it: &syn::ExprCall, at: At) -> Lowered {
        let function = self.stripped(function);
        let (parameters, result) = match (function.ty.0, function.ty.1.split_last()) {
            (Head::Fn, Some((result, parameters))) => (parameters.to_vec(), result.clone()),
            (Head::Unknown, _) => return self.needs_a_type(self.at(&it.func)),
            _ => {
                let name = function.ty.name(self.names);
                return self.refused(
                    self.at(&it.func),
                    format!("expected function, found `{name}`"),
                );
            }
        };
        let nodes = self.arguments(&parameters, &it.args, at, &mut [])?;
        let node = Node::Apply(Box::new(function.node), nodes.into(), at);
        Ok(Typed::new(node, result))
    }

    /// The arguments as their parameters want them. Types that stand for others, in what the
    /// library has, are found on the way.
    fn arguments<'s>(
        &mut self,
        parameters: &[Type],
        given: impl IntoIterator<Item = &'s syn::Expr>,
        at: At,
        with: &mut [Type],
    ) -> Lowered<Vec<Node>> {
        let given: Vec<&syn::Expr> = given.into_iter().collect();
        if given.len() != parameters.len() {
            return Err(miscounted(false, parameters.len(), given.len(), at));
        }
        let mut nodes = Vec::with_capacity(given.len());
        for (value, parameter) in given.into_iter().zip(parameters) {
            let wanted = if with.is_empty() {
                parameter.clone()
            } else {
                parameter.with(with)
            };
            let typed = match value {
                syn::Expr::Closure(it) => self.closure(it, &wanted)?,
                value => self.expr(value)?,
            };
            if let Some((n, ty)) = stands_for(parameter, &typed.ty)
                && with[n].is_unknown()
            {
                with[n] = ty.settled();
            }
            nodes.push(self.declared_of(value, typed, &wanted)?);
        }
        Ok(nodes)
    }

    pub(super) fn native(&self, owner: &str, name: &str, nodes: Vec<Node>, at: At) -> Node {
        let native = prelude::native(owner, name).expect("it is listed");
        Node::Native(native, nodes.into(), at)
    }

    fn made(&self, callee: Callee, nodes: Vec<Node>, result: Type, at: At) -> Typed {
        let nodes: Box<[Node]> = nodes.into();
        let node = match callee {
            Callee::Own(function) => Node::Call(function, nodes, at),
            // A vector of numbers is made once.
            Callee::Native(native) => match *nodes {
                [Node::Float(x), Node::Float(y), Node::Float(z)] if result.is(Head::Vec3) => {
                    Node::Vec3(Vec3::new(x, y, z))
                }
                _ => Node::Native(native, nodes, at),
            },
            Callee::Dynamic(function) => {
                let name = &self.names.functions[function].name;
                let of = |kind| self.names.method(&Head::Own(kind).into(), name, None);
                Node::Dispatch((0..self.names.kinds.len()).map(of).collect(), nodes, at)
            }
        };
        Typed::new(node, result)
    }

    pub(super) fn method_call(&mut self, it: &syn::ExprMethodCall) -> Lowered {
        let receiver = self.expr(&it.receiver)?;
        let at = at_span(self.file, it.method.span());
        let whole = At {
            start: self.at(&it.receiver).start,
            end: at_span(self.file, it.paren_token.span.close()).end,
            ..at
        };
        let name = it.method.to_string();
        let arguments = it.args.iter().collect();
        let made = self.method(receiver, &it.receiver, &name, arguments, (at, whole))?;
        // `.collect::<Vec<_>>()` says what comes out.
        if let Some(written) = &it.turbofish
            && let Some(syn::GenericArgument::Type(ty)) = written.args.first()
        {
            let ty = self.names.ty(&self.context, ty)?;
            return Ok(Typed::new(self.declared(made, &ty, whole)?, ty));
        }
        Ok(made)
    }

    /// A method by its name, on the receiver or on what that leads to. Its name stands at one
    /// place, the whole call at another.
    fn method(
        &mut self,
        receiver: Typed,
        receiver_at: &syn::Expr,
        name: &str,
        arguments: Vec<&syn::Expr>,
        (at, whole): (At, At),
    ) -> Lowered {
        let stripped = receiver.ty.stripped().clone();
        let (callee, on, through) = self.method_found(receiver, name, at)?;
        let signature = self.signature(callee);
        let Some(wanted) = signature.parameters.first().filter(|_| signature.has_self) else {
            let on = on.ty.name(self.names);
            let message = format!("no method named `{name}` found for `{on}` in the current scope");
            let label = "this is an associated function, not a method";
            return self.fault(at, &message, label, &format!("`{on}::{name}(…)`"));
        };
        let counts = [signature.parameters.len() - 1, arguments.len()];
        if counts[0] != counts[1] {
            return Err(miscounted(true, counts[0], counts[1], whole));
        }
        let mut with = vec![on.ty.inner(), Type::UNKNOWN, number(&on.ty)];
        let before = on.clone();
        let node = match (wanted.0, through) {
            (Head::RefMut, _) if on.ty.is(Head::RefMut) => on.node,
            (Head::RefMut, Some(reference)) if reference.ty.is(Head::RefMut) => reference.node,
            (Head::RefMut, _) => Node::Address(Box::new(self.mutable(on, receiver_at)?)),
            _ => on.node,
        };
        let rest = self.arguments(&signature.parameters[1..], arguments, whole, &mut with)?;
        if !before.ty.1.is_empty() {
            self.learn(&before, &Type(before.ty.0, vec![with[0].clone()]));
        }
        let nodes = [vec![node], rest].concat();
        let result = signature.result.with(&with);
        let result = match (name, stripped.0) {
            ("map", Head::Array(length)) => Type(Head::Array(length), result.1),
            _ => result,
        };
        Ok(self.made(callee, nodes, result, whole))
    }

    /// Which method is meant, what it is called on, and by what that was reached at last.
    fn method_found(
        &self,
        receiver: Typed,
        name: &str,
        at: At,
    ) -> Lowered<(Callee, Typed, Option<Typed>)> {
        if receiver.ty.stripped().is_unknown() {
            return self.needs_a_type(at);
        }
        let (mut on, mut through) = (receiver.clone(), None);
        let callee = loop {
            if let Some(callee) = self.names.callee(&number(&on.ty), name) {
                break callee;
            }
            if !matches!(on.ty.0, Head::Ref | Head::RefMut | Head::Box) {
                return Err(self.names.no_method(&receiver.ty, name, at));
            }
            through = Some(on.clone());
            on = self.dereferenced(on);
        };
        self.shown(callee, at)?;
        let Callee::Native(native) = callee else {
            return Ok((callee, on, through));
        };
        if on.ty.is(Head::Float) && matches!(on.node, Node::Float(_)) {
            let message =
                format!("can't call method `{name}` on ambiguous numeric type `{{float}}`");
            return self.fault(at, &message, "", "say which: `2.0_f64`");
        }
        // What is borrowed gives references.
        let is_borrowed = through.as_ref().is_some_and(|it| it.ty.is_reference());
        let borrowed = prelude::native(native.owner, "iter");
        let native = borrowed.filter(|_| is_borrowed && name == "into_iter");
        Ok((native.map_or(callee, Callee::Native), on, through))
    }

    pub(super) fn closure(&mut self, it: &syn::ExprClosure, wanted: &Type) -> Lowered {
        let mut types = match wanted.0 {
            Head::Fn if wanted.1.len() == it.inputs.len() + 1 => wanted.1.clone(),
            _ => vec![Type::UNKNOWN; it.inputs.len() + 1],
        };
        let mut result = types.pop().expect("a function has a result");
        if let syn::ReturnType::Type(_, ty) = &it.output {
            result = self.names.ty(&self.context, ty)?;
        }
        let outside = self.locals.len();
        let mut parameters = Vec::new();
        for (input, ty) in it.inputs.iter().zip(&mut types) {
            if let syn::Pat::Type(typed) = input {
                let written = self.names.ty(&self.context, &typed.ty)?;
                if !written.fits(ty, self.names) {
                    return Err(self.names.mismatch(ty, &written, self.at_any(&typed.ty)));
                }
                *ty = written;
            }
            parameters.push(self.pattern(input, ty, false)?);
        }
        let outer = std::mem::replace(&mut self.result, result.clone());
        let loops = std::mem::take(&mut self.loops);
        let body = self.expr(&it.body);
        self.result = outer;
        self.loops = loops;
        let body = body?;
        self.locals.truncate(outside);
        types.push(if result.is_certain() {
            result.clone()
        } else {
            body.ty.clone()
        });
        let body = self.declared_of(&it.body, body, &result)?;
        let closure = Arc::new(Closure { parameters, body });
        let node = Node::Closure(closure, it.capture.is_some());
        Ok(Typed::new(node, Type(Head::Fn, types)))
    }
}

/// Which parameter of the library's a type shows, and what that stands for.
fn stands_for(parameter: &Type, found: &Type) -> Option<(usize, Type)> {
    if let Head::Param(n) = parameter.0 {
        return Some((n, found.clone()));
    }
    let is_like = parameter.0 == found.0 || parameter.is(Head::Iterator);
    match parameter.1.last()?.0 {
        Head::Param(n) if is_like => Some((n, found.1.last()?.clone())),
        Head::Option if is_like => stands_for(parameter.1.last()?, found.1.last()?),
        _ => None,
    }
}

/// That a call has too many arguments, or too few.
pub(crate) fn miscounted(is_method: bool, wanted: usize, count: usize, at: At) -> Refusal {
    let what = if is_method { "method" } else { "function" };
    let several = |n: usize| if n == 1 { "argument" } else { "arguments" };
    let was = if count == 1 { "was" } else { "were" };
    let message = format!(
        "this {what} takes {wanted} {} but {count} {} {was} supplied",
        several(wanted),
        several(count)
    );
    Refusal::new(at, &message, "", "")
}

/// The type whose methods a number has of which not all is known.
fn number(ty: &Type) -> Type {
    match ty.0 {
        Head::Float => Head::F64.into(),
        Head::Int(Int::Any) => Head::Int(Int::I32).into(),
        _ => ty.clone(),
    }
}
