//! Calls of functions and methods.

use common::rtweekend::Vec3;

use super::lowerer::{Lowered, Lowerer};
use crate::calls::Argument;
use crate::fault::{Fault, Span};
use crate::integers;
use crate::machine::{Code, Machine, Run};
use crate::names::Item;
use crate::natives;
use crate::value::{Kind, Shape, Target, Value, kind};

impl Lowerer<'_> {
    pub(super) fn call(&mut self, call: &syn::ExprCall) -> Lowered {
        let path = match &*call.func {
            syn::Expr::Path(it) if self.variable(&it.path).is_none() => Some(&it.path),
            _ => None,
        };
        let arguments = call.args.iter().map(|argument| self.argument(argument));
        let arguments = arguments.collect::<Lowered<Vec<_>>>()?;
        let at = self.at(&call.func);
        match path.map_or(Ok(None), |path| self.target(path))? {
            Some(target) => self.call_of(target, arguments, at),
            None => {
                let callee = self.expr(&call.func)?;
                Ok(Code::act(move |m| {
                    let callee = callee.run(m)?;
                    m.apply(&callee, &arguments, at)
                }))
            }
        }
    }

    /// Lowers the call of a function that is known.
    pub(super) fn call_of(&self, target: Target, arguments: Vec<Argument>, at: Span) -> Lowered {
        let wanted = self.names.takes(target);
        if wanted != arguments.len() {
            return Err(Fault::miscounted(at, wanted, arguments.len()));
        }
        if let Some(vector) = constant(target, &arguments) {
            return Ok(Code::Vector(vector));
        }
        let lent = self.lent_to(target, &arguments);
        Ok(Code::act(move |m| {
            m.call(&Value::Function(target), None, &arguments, &lent, at)
        }))
    }

    /// Returns which arguments a function may change: those that lie in a place and are a `&mut`.
    fn lent_to(&self, target: Target, given: &[Argument]) -> Vec<usize> {
        let is_lent = |n: &usize| given[*n].place.is_some() && self.names.changes(target, *n);
        (0..given.len()).filter(is_lent).collect()
    }

    /// Returns what a path calls; `None` for a constant.
    pub(super) fn target(&self, path: &syn::Path) -> Lowered<Option<Target>> {
        Ok(Some(match self.item(path)? {
            Item::Function(n) if self.names.signatures[n].is_constant => return Ok(None),
            Item::Function(n) => Target::Own(n),
            Item::Native(native) if native.is_constant => return Ok(None),
            Item::Native(native) => Target::Native(native),
            Item::Variant(shape) => Target::Variant(self.without_names(path, shape)?),
            Item::Default(kind) => Target::Default(kind),
            Item::Type(kind) if self.names.kind(kind).variants.len() == 1 => {
                Target::Variant(self.without_names(path, Shape::new(kind, 0))?)
            }
            _ => return self.refused(path, "this is no value"),
        }))
    }

    /// Checks that the fields of a variant or a struct have no names.
    fn without_names(&self, path: &syn::Path, shape: Shape) -> Lowered<Shape> {
        let variant = self.names.variant(shape);
        match variant.field("0").is_some() || variant.fields.is_empty() {
            true => Ok(shape),
            false => self.refused(path, "this is no function: write `new`, or fields in `{ }`"),
        }
    }

    pub(super) fn argument(&mut self, expr: &syn::Expr) -> Lowered<Argument> {
        let (place, at) = (self.place(expr)?, self.at(expr));
        let code = match (&place, expr) {
            (Some(place), _) => place.read(at),
            (None, syn::Expr::Reference(it)) => self.expr(&it.expr)?,
            (None, _) => self.expr(expr)?,
        };
        Ok(Argument { code, place, at })
    }

    pub(super) fn method_call(&mut self, call: &syn::ExprMethodCall) -> Lowered {
        let (name, at) = (call.method.to_string(), self.at(&call.method));
        if let Some(generic) = &call.turbofish {
            self.names.arguments(generic, self.scope)?;
        }
        let mut arguments = vec![self.argument(&call.receiver)?];
        for argument in &call.args {
            arguments.push(self.argument(argument)?);
        }
        let all = self.methods(&name, arguments.len(), at)?;
        let lent = |(of, target)| (of, target, self.lent_to(target, &arguments));
        let method = Method {
            targets: all.into_iter().map(lent).collect(),
            arguments,
            name,
            at,
        };
        Ok(Code::act(move |m| method.call(m)))
    }

    /// Lists the functions of that name that take so many arguments, each with its type.
    fn methods(&self, name: &str, count: usize, at: Span) -> Lowered<Vec<(Kind, Target)>> {
        let own = self.names.methods(name).into_iter();
        let own = own.map(|(of, n)| (of, Target::Own(n)));
        let natives = natives::named(name).filter(|it| !it.is_constant);
        let natives = natives.map(|native| (native.of, Target::Native(native)));
        // What the library has goes before the trait of a text, unless all types have it.
        let (of_all, natives): (Vec<_>, Vec<_>) = natives.partition(|it| it.0 == kind::ANY);
        let mut all: Vec<_> = natives.into_iter().chain(own).chain(of_all).collect();
        let Some(takes) = all.first().map(|(_, target)| self.names.takes(*target)) else {
            return Err(self.no_method(name, at));
        };
        all.retain(|(_, target)| self.names.takes(*target) == count);
        match all.is_empty() {
            true => Err(Fault::miscounted(at, takes.saturating_sub(1), count - 1)),
            false => Ok(all),
        }
    }

    /// Makes the fault of a method that is not known: a field, or one that is not read here.
    fn no_method(&self, name: &str, at: Span) -> Fault {
        match self.names.fields().any(|field| field == name) {
            true => Fault::refused(at, format!("`{name}` is no method: leave out the `()`")),
            false => self.unread_function(at, name),
        }
    }
}

/// Returns the vector that a native function makes of numbers.
fn constant(target: Target, given: &[Argument]) -> Option<Vec3> {
    let numbers = given.iter().map(|argument| match argument.code {
        Code::Number(number) => Some(number.into()),
        _ => None,
    });
    let mut numbers = numbers.collect::<Option<Vec<Value>>>()?;
    match target {
        Target::Native(native) => (native.run)(&mut numbers).ok()?.vec3(),
        _ => None,
    }
}

/// A call of a method: which function is called depends on the type of its first argument.
struct Method {
    name: String,
    /// The functions of that name, each with its type, and the arguments that it may change.
    targets: Vec<(Kind, Target, Vec<usize>)>,
    /// The first is what stands before the point.
    arguments: Vec<Argument>,
    at: Span,
}

impl Method {
    fn call(&self, m: &mut Machine<'_>) -> Run {
        let mut receiver = self.arguments[0].code.run(m)?;
        let mut target = self.target(receiver.kind());
        if target.is_none() && receiver.kind() == kind::RANGE {
            // A range is the list of its numbers.
            receiver = m.listed(&receiver, self.at)?;
            target = self.target(kind::LIST);
        }
        if let Some((_, target, lent)) = target {
            let callee = Value::Function(*target);
            return m.call(&callee, Some(receiver), &self.arguments, lent, self.at);
        }
        let ty = m.code.names.shown(receiver.kind());
        match receiver.kind() {
            // It may be one of the library's that is not there.
            kind::LIST | kind::TEXT | kind::VEC3..=kind::PICTURE => {
                m.unread(self.at, &format!("`{}` of `{ty}`", self.name))
            }
            _ => m.refuse(
                self.at,
                format!("there is no method `{}` of `{ty}`", self.name),
            ),
        }
    }

    #[inline]
    fn target(&self, of: Kind) -> Option<&(Kind, Target, Vec<usize>)> {
        let takes = |kind: Kind| {
            kind == of || kind == kind::ANY || kind == kind::INT && integers::is_integer(of)
        };
        self.targets.iter().find(|target| takes(target.0))
    }
}
