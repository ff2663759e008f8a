//! Method lookup: a name on a value, then on what that leads to, until one is found.

use super::Machine;
use crate::host::Eval;
use crate::library::{Native, native};
use crate::node::{Arguments, Method, Receiver, Target};
use crate::refusal::Refusal;
use crate::types::{Head, Owners};
use crate::value::{Address, Data, Value};

/// Which method a name means.
#[derive(Clone, Copy)]
enum Found {
    Own(usize),
    Native(usize),
}

impl Machine<'_> {
    #[inline(never)]
    pub(super) fn method(&mut self, method: &Method, on: &Receiver, given: &Arguments) -> Eval {
        match on {
            Receiver::Value(node) => {
                let value = self.operand(node)?;
                // Most are of the library, and are found at once.
                let owners = Owners::of(value.head());
                let mut natives = method.natives.iter().filter(|_| method.own.is_empty());
                match natives.find(|it| it.0.has(owners)) {
                    Some((_, n)) if !native(*n).changes() => {
                        self.native_with(native(*n), value, given)
                    }
                    _ => self.method_of(method, value, None, given),
                }
            }
            Receiver::Place(target) => {
                let address = self.address(target)?;
                let value = self.read(&address);
                self.method_of(method, value, Some((address, target)), given)
            }
        }
    }

    fn method_of(
        &mut self,
        method: &Method,
        value: Value,
        place: Option<(Address, &Target)>,
        given: &Arguments,
    ) -> Eval {
        let mut on = value;
        let (mut place, target) = place.map_or((None, None), |(at, of)| (Some(at), Some(of)));
        loop {
            match self.found(method, &on) {
                Some(Found::Native(n)) => {
                    if native(n).changes() {
                        self.may_change_on(&on, target, given)?;
                    }
                    return self.native_on(n, on, place, given);
                }
                Some(Found::Own(n)) => {
                    if self.code.names.functions[n].parameters[0].is(Head::RefMut) {
                        self.may_change_on(&on, target, given)?;
                    }
                    return self.own_on(n, on, place, given);
                }
                None => {}
            }
            on = match &on.data {
                Data::Mut(address) => {
                    let next = self.read(address);
                    place = Some(address.clone());
                    next
                }
                Data::Box(inner) => {
                    place = place.map(|it| it.part(0));
                    (**inner).clone().more_lent(on.lent)
                }
                _ => return self.no_method(method, &on),
            };
        }
    }

    /// The method of that name that a value itself has.
    #[inline]
    fn found(&self, method: &Method, on: &Value) -> Option<Found> {
        let head = on.head();
        if let Some((_, own)) = method.own.iter().find(|it| it.0 == head) {
            return Some(Found::Own(*own));
        }
        let owners = match &on.data {
            Data::Own(kind, _) if self.code.names.kinds[*kind as usize].derives("Clone") => {
                let mut natives = method.natives.iter();
                return natives
                    .find(|it| native(it.1).name == "clone")
                    .map(|it| Found::Native(it.1));
            }
            _ => Owners::of(head),
        };
        let mut natives = method.natives.iter();
        natives
            .find(|it| it.0.has(owners))
            .map(|it| Found::Native(it.1))
    }

    /// A method of the reader's on what it wants: a value, or a reference to it.
    fn own_on(
        &mut self,
        function: usize,
        on: Value,
        place: Option<Address>,
        given: &Arguments,
    ) -> Eval {
        let wanted = &self.code.names.functions[function].parameters[0];
        let on = match (wanted.0, place) {
            (Head::Ref, _) => on.owned().lent(),
            (Head::RefMut, Some(place)) => {
                drop(on);
                Data::Mut(place).into()
            }
            (Head::RefMut, None) => {
                let what = "changes of a value without a name";
                return self.refused(Refusal::unread(given.at, what));
            }
            (Head::Box, _) => on,
            _ => on.owned(),
        };
        self.called_on(function, on, given)
    }

    fn native_on(
        &mut self,
        number: usize,
        on: Value,
        place: Option<Address>,
        given: &Arguments,
    ) -> Eval {
        let native = native(number);
        let on = match place {
            Some(place) if native.changes() => {
                // Else it would be shared, and copied to be changed.
                drop(on);
                Data::Mut(place).into()
            }
            None if native.changes() => {
                let what = "changes of a value without a name";
                return self.refused(Refusal::unread(given.at, what));
            }
            _ => on,
        };
        self.native_with(native, on, given)
    }

    #[inline]
    fn native_with(&mut self, native: &Native, on: Value, given: &Arguments) -> Eval {
        if native.takes.len() != given.nodes.len() {
            let (wanted, count) = (native.takes.len(), given.nodes.len());
            return self.refused(Refusal::miscounted(true, wanted, count, given.at));
        }
        match &*given.nodes {
            [] => self.run_native(native, &mut [on], given.at),
            [node] => {
                let mut values = [on, self.operand(node)?];
                self.check_all(native, &mut values, 1, given)?;
                self.run_native(native, &mut values, given.at)
            }
            nodes => {
                let mut values = vec![on];
                for node in nodes {
                    values.push(self.operand(node)?);
                }
                self.check_all(native, &mut values, 1, given)?;
                self.run_native(native, &mut values, given.at)
            }
        }
    }

    fn may_change_on(
        &mut self,
        on: &Value,
        target: Option<&Target>,
        given: &Arguments,
    ) -> Eval<()> {
        if on.lent == 0 {
            return target.map_or(Ok(()), |it| self.may_change(it));
        }
        let message = "cannot change this, as it is behind a `&` reference";
        let help = "`&mut` instead of `&`";
        self.refused(Refusal::new(given.at, message, "", help))
    }

    fn no_method(&mut self, method: &Method, on: &Value) -> Eval {
        let names = &self.code.names;
        let (name, ty) = (&method.name, self.ty(on));
        let of = ty.name(names);
        let refusal = match ty.stripped().0 {
            Head::Own(_) | Head::Ray | Head::Picture | Head::Fn => {
                let message =
                    format!("no method named `{name}` found for `{of}` in the current scope");
                Refusal::new(method.at, message, "", "")
            }
            _ => {
                let of = ty.stripped().name(names);
                Refusal::unread(method.at, &format!("`{name}` of `{of}`"))
            }
        };
        self.refused(refusal)
    }
}
