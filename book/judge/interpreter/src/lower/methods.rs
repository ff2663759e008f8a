//! Method calls: all that a name after a point may mean; which of it, the value decides.

use super::{Lowered, Lowerer};
use crate::library;
use crate::names::words::there_is;
use crate::node::{Method, Node, Receiver};
use crate::refusal::{At, Refusal};
use crate::types::{Head, Type};

impl Lowerer<'_> {
    pub(super) fn method_call(&mut self, it: &syn::ExprMethodCall) -> Lowered {
        let at = self.at_span(it.method.span());
        let whole = At {
            start: self.at(&it.receiver).start,
            end: self.at_span(it.paren_token.span.close()).end,
            ..at
        };
        let name = it.method.to_string();
        let given: Vec<&syn::Expr> = it.args.iter().collect();
        let node = self.method(&it.receiver, &name, &given, (at, whole))?;
        // `.collect::<Vec<_>>()` says what comes out.
        if let Some(written) = &it.turbofish
            && let Some(syn::GenericArgument::Type(ty)) = written.args.first()
        {
            let ty = self.names.ty(&self.context, ty)?;
            return Ok(self.checked(node, &ty, whole));
        }
        Ok(node)
    }

    /// A method by its name. That stands at one place, the whole call at another.
    pub(super) fn method(
        &mut self,
        on: &syn::Expr,
        name: &str,
        given: &[&syn::Expr],
        (at, whole): (At, At),
    ) -> Lowered {
        let receiver = self.expr(on)?;
        if self.is_open(on) {
            return self.needs_a_type(self.at(on));
        }
        let method = self.candidates(name, at)?;
        if let Some(kind) = ambiguous(on) {
            let message =
                format!("can't call method `{name}` on ambiguous numeric type `{{{kind}}}`");
            return self.fault(at, &message, "", "say which: `2.0_f64`");
        }
        let place = if self.may_change(&method) {
            self.place(on)?.map(|it| self.mutable(it))
        } else {
            None
        };
        let receiver = match place {
            Some(place) => Receiver::Place(Box::new(place)),
            None => Receiver::Value(Box::new(receiver)),
        };
        self.counted_by(&method, given.len(), whole)?;
        let unknown = vec![Type::UNKNOWN; given.len()];
        let arguments = self.arguments(&unknown, given.iter().copied(), whole)?;
        Ok(Node::Method(Box::new(method), receiver, arguments))
    }

    /// All methods of that name that may be called here.
    fn candidates(&self, name: &str, at: At) -> Lowered<Method> {
        let names = self.names;
        let methods = names.methods(name).filter(|it| {
            let is_promised = matches!(it.0, Head::Dyn(_));
            names.functions[it.1].has_self && !is_promised
        });
        let is_shown = |it: &(Head, usize)| names.shows(self.context.module, it.1);
        let (own, hidden): (Vec<_>, Vec<_>) = methods.partition(is_shown);
        let natives: Vec<_> = library::methods(name).collect();
        if own.is_empty() && natives.is_empty() {
            return Err(match hidden.first() {
                Some(it) => self.hidden(it.1, at),
                None => self.no_method(name, at),
            });
        }
        let name = name.to_owned();
        Ok(Method {
            name,
            own,
            natives,
            at,
        })
    }

    /// Says that there is no such method, or that it is not read here, and which was meant.
    fn no_method(&self, name: &str, at: At) -> Refusal {
        let names = self.names;
        let message = format!("no method named `{name}` found");
        if names.methods(name).next().is_some() {
            let label = "this is an associated function, not a method";
            return Refusal::new(at, message, label, &format!("`….{name}(…)` has no `self`"));
        }
        let mut kinds = names.kinds.iter();
        let is_listed = ["origin", "direction", "x", "y", "z"].contains(&name);
        if is_listed || kinds.any(|it| it.field(name).is_some()) {
            let help = format!("`{name}` is a field: without `()`");
            return Refusal::new(at, message, "", &help);
        }
        let own = names.functions.iter().filter(|it| it.has_self);
        let own = there_is(name, own.map(|it| it.name.as_str()));
        if !own.is_empty() {
            return Refusal::new(at, message, "", &own);
        }
        let help = there_is(name, library::names());
        Refusal::unread(at, &format!("`{name}`")).or_help(&help)
    }

    /// Whether some of what may be meant takes so many arguments.
    fn counted_by(&self, method: &Method, given: usize, at: At) -> Lowered<()> {
        let own = method.own.iter();
        let own = own.map(|it| self.names.functions[it.1].parameters.len() - 1);
        let natives = method.natives.iter();
        let natives = natives.map(|it| library::native(it.1).takes.len());
        let mut counts = own.chain(natives).peekable();
        let first = *counts.peek().expect("some may be meant");
        if counts.any(|it| it == given) {
            return Ok(());
        }
        Err(Refusal::miscounted(true, first, given, at))
    }

    /// Whether some of what may be meant changes what it is called on.
    fn may_change(&self, method: &Method) -> bool {
        let functions = &self.names.functions;
        let mut own = method.own.iter();
        let mut natives = method.natives.iter();
        own.any(|it| functions[it.1].parameters[0].is(Head::RefMut))
            || natives.any(|it| library::native(it.1).changes())
    }
}

/// Which kind of number it is, if the compiler wants to know more.
fn ambiguous(it: &syn::Expr) -> Option<&'static str> {
    match it {
        syn::Expr::Paren(it) => ambiguous(&it.expr),
        syn::Expr::Unary(it) if matches!(it.op, syn::UnOp::Neg(_)) => ambiguous(&it.expr),
        syn::Expr::Binary(it) => ambiguous(&it.left).and(ambiguous(&it.right)),
        syn::Expr::Lit(it) => match &it.lit {
            syn::Lit::Float(it) if it.suffix().is_empty() => Some("float"),
            syn::Lit::Int(it) if it.suffix().is_empty() => Some("integer"),
            _ => None,
        },
        _ => None,
    }
}
