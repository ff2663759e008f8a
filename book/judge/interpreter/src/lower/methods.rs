//! Method calls: all methods of a name are found when the text is read, and the type of the
//! receiver selects one when it runs.

use super::declared::checked;
use super::{Expr, Lowered, Lowerer};
use crate::library;
use crate::machine::value::{Address, Data, Value};
use crate::machine::{Eval, ExprForm, Given, Machine, Native, PlaceExpr, Thunk};
use crate::names::words::there_is;
use crate::refusal::{Refusal, Span};
use crate::types::Ctor;

/// A method call, ready to be run: all methods that the name may mean, and the arguments.
struct MethodCall {
    name: String,
    at: Span,
    /// The text's own methods of that name that are visible: the type of each and its number.
    own: Vec<(Ctor, usize)>,
    natives: Vec<&'static Native>,
    runs: Vec<Thunk>,
    given: Given,
}

/// The methods of a name: the text's own, each with its type and number, and the library's.
type Candidates = (Vec<(Ctor, usize)>, Vec<&'static Native>);

/// The method that a call turns out to mean.
enum MethodTarget {
    Own(usize),
    Native(&'static Native),
}

impl Lowerer<'_> {
    pub(super) fn method_call(&mut self, it: &syn::ExprMethodCall) -> Lowered {
        let at = self.at_span(it.method.span());
        let whole = Span {
            start: self.at(&it.receiver).start,
            end: self.at_span(it.paren_token.span.close()).end,
            ..at
        };
        let name = it.method.to_string();
        let given: Vec<&syn::Expr> = it.args.iter().collect();
        let made = self.method(&it.receiver, &name, &given, (at, whole))?;
        // `.collect::<Vec<_>>()` says what comes out.
        if let Some(written) = &it.turbofish
            && let Some(syn::GenericArgument::Type(ty)) = written.args.first()
        {
            let ty = self.names.ty(&self.context, ty)?;
            return Ok(checked(made, &ty));
        }
        Ok(made)
    }

    /// Lowers a method call by its name, which stands at `at` within the `whole` call.
    pub(super) fn method(
        &mut self,
        on: &syn::Expr,
        name: &str,
        given: &[&syn::Expr],
        (at, whole): (Span, Span),
    ) -> Lowered {
        let receiver = self.expr(on)?;
        if receiver.spot.form == ExprForm::Open {
            return self.needs_a_type(receiver.spot.at);
        }
        let (own, natives) = self.candidates(name, at)?;
        not_ambiguous(receiver.spot.form, name, at)?;
        self.counted(&own, &natives, given.len(), whole)?;
        let receiver_of = |it: &(Ctor, usize)| &self.names.functions[it.1].parameters[0];
        let changes = own.iter().any(|it| receiver_of(it).is(Ctor::RefMut))
            || natives.iter().any(|it| it.changes());
        let place = match changes {
            true => self.place(on)?.map(|it| self.mutable(it)),
            false => None,
        };
        let (runs, given) = self.arguments(given.iter().copied(), whole)?;
        let name = name.to_owned();
        let method = MethodCall {
            name,
            at,
            own,
            natives,
            runs,
            given,
        };
        let receiver = receiver.run;
        Ok(match place {
            Some(place) => Expr::new(whole, move |m| {
                let address = (place.address)(m)?;
                let value = m.read(&address);
                method.called(m, value, Some((address, &place)))
            }),
            None => Expr::new(whole, move |m| {
                let value = receiver.eval(m)?;
                method.called(m, value, None)
            }),
        })
    }

    /// Checks that one of the candidates takes as many arguments as are given.
    fn counted(
        &self,
        own: &[(Ctor, usize)],
        natives: &[&Native],
        given: usize,
        at: Span,
    ) -> Lowered<()> {
        let functions = &self.names.functions;
        let own = own.iter().map(|it| functions[it.1].parameters.len() - 1);
        let mut counts = own
            .chain(natives.iter().map(|it| it.takes.len()))
            .peekable();
        let first = counts.peek().copied().unwrap_or_default();
        match counts.any(|it| it == given) {
            true => Ok(()),
            false => Err(Refusal::miscounted(true, first, given, at)),
        }
    }

    /// Returns all methods of that name that may be called here; refuses a name that has none.
    fn candidates(&self, name: &str, at: Span) -> Lowered<Candidates> {
        let names = self.names;
        let methods = names.methods(name).filter(|it| {
            let is_promised = matches!(it.0, Ctor::Dyn(_));
            names.functions[it.1].has_self && !is_promised
        });
        let is_shown = |it: &(Ctor, usize)| names.shows(self.context.module, it.1);
        let (own, hidden): (Vec<_>, Vec<_>) = methods.partition(is_shown);
        let natives: Vec<_> = library::methods(name).collect();
        match hidden.first() {
            _ if !own.is_empty() || !natives.is_empty() => Ok((own, natives)),
            Some(it) => Err(self.hidden(it.1, at)),
            None => Err(self.no_method(name, at)),
        }
    }

    /// Says that no method has that name, or that it is not read here, and suggests a similar name.
    fn no_method(&self, name: &str, at: Span) -> Refusal {
        let names = self.names;
        let message = format!("no method named `{name}` found");
        if names.methods(name).next().is_some() {
            let label = "this is an associated function, not a method";
            return Refusal::new(at, message, label, &format!("`….{name}(…)` has no `self`"));
        }
        let mut structs = names.structs.iter();
        let is_listed = ["origin", "direction", "x", "y", "z"].contains(&name);
        if is_listed || structs.any(|it| it.field(name).is_some()) {
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
}

/// Refuses a method of a literal whose type nothing says, as the compiler does.
fn not_ambiguous(form: ExprForm, name: &str, at: Span) -> Lowered<()> {
    let kind = match form {
        ExprForm::Float => "{float}",
        ExprForm::Int => "{integer}",
        _ => return Ok(()),
    };
    let message = format!("can't call method `{name}` on ambiguous numeric type `{kind}`");
    Err(Refusal::new(at, message, "", "say which: `2.0_f64`"))
}

impl MethodCall {
    /// Calls the method that the receiver's type selects. If its own type has none, references and
    /// boxes are followed.
    fn called(&self, m: &mut Machine<'_>, on: Value, place: Option<(Address, &PlaceExpr)>) -> Eval {
        // Most are of the library, and are found at once.
        if self.own.is_empty()
            && place.is_none()
            && let Some(MethodTarget::Native(native)) = self.found(m, &on)
            && !native.changes()
        {
            return self.native(m, native, on);
        }
        let mut on = on;
        let (mut place, root) = place.map_or((None, None), |(at, of)| (Some(at), Some(of)));
        loop {
            if let Some(found) = self.found(m, &on) {
                return self.called_as(m, &found, on, place, root);
            }
            on = match &on.data {
                Data::Mut(address) => {
                    let next = m.read(address);
                    place = Some(address.clone());
                    next
                }
                Data::Box(inner) => {
                    place = place.map(|it| it.part(0));
                    (**inner).clone().more_lent(on.lent)
                }
                _ => return self.none(m, &on),
            };
        }
    }

    /// Returns the method for the type of a value, references and boxes not followed.
    #[inline]
    fn found(&self, m: &Machine<'_>, on: &Value) -> Option<MethodTarget> {
        let ctor = on.data.ctor();
        if let Some((_, own)) = self.own.iter().find(|it| it.0 == ctor) {
            return Some(MethodTarget::Own(*own));
        }
        let is_it = |it: &&&Native| match ctor {
            Ctor::Own(kind) => {
                it.name == "clone" && m.code.names.structs[kind as usize].derives("Clone")
            }
            _ => (it.owner)(ctor),
        };
        let mut natives = self.natives.iter();
        natives.find(is_it).map(|it| MethodTarget::Native(it))
    }

    /// Calls a method on what its receiver declares: a value, a shared reference, or an address to
    /// change it by.
    fn called_as(
        &self,
        m: &mut Machine<'_>,
        found: &MethodTarget,
        on: Value,
        place: Option<Address>,
        root: Option<&PlaceExpr>,
    ) -> Eval {
        let wanted = match found {
            MethodTarget::Own(n) => m.code.names.functions[*n].parameters[0].0,
            MethodTarget::Native(it) if it.changes() => Ctor::RefMut,
            MethodTarget::Native(_) => Ctor::Box,
        };
        let on = match (wanted, place) {
            (Ctor::RefMut, _) if on.lent > 0 => return m.behind(self.given.at),
            (Ctor::RefMut, Some(place)) => {
                if let Some(root) = root {
                    m.check_mutable(root)?;
                }
                // Else it would be shared, and copied to be changed.
                drop(on);
                Data::Mut(place).into()
            }
            (Ctor::RefMut, None) => {
                return m.unread(self.given.at, "changes of a value without a name");
            }
            (Ctor::Ref, _) => on.owned().lent(),
            (Ctor::Box, _) => on,
            _ => on.owned(),
        };
        match found {
            MethodTarget::Own(n) => m.called_on(*n, on, &self.runs, &self.given),
            MethodTarget::Native(native) => self.native(m, native, on),
        }
    }

    /// Calls a library method, whose count of arguments is checked before.
    #[inline]
    fn native(&self, m: &mut Machine<'_>, native: &Native, on: Value) -> Eval {
        let (wanted, count) = (native.takes.len(), self.runs.len());
        if wanted != count {
            return m.refused(Refusal::miscounted(true, wanted, count, self.given.at));
        }
        m.called_native(native, Some(on), &self.runs, &self.given)
    }

    /// Stops since the value has no such method.
    fn none(&self, m: &mut Machine<'_>, on: &Value) -> Eval {
        let ty = m.ty(on);
        let (name, stripped) = (&self.name, ty.stripped());
        match stripped.0 {
            Ctor::Own(_) | Ctor::Ray | Ctor::Picture | Ctor::Fn => {
                let of = ty.name(&m.code.names);
                let message = format!("no method named `{name}` found for `{of}`");
                m.wrong(self.at, message + " in the current scope", "")
            }
            _ => {
                let of = stripped.name(&m.code.names);
                m.unread(self.at, &format!("`{name}` of `{of}`"))
            }
        }
    }
}
