//! Native functions: the library's own code, called with values whose types are checked.

use std::mem;

use super::calls::Given;
use super::checks::is_plainly;
use super::value::{Data, Value};
use super::{Eval, Machine, Thunk};
use crate::refusal::Span;
use crate::types::{Ctor, Type};

/// A function of the library, written in Rust.
pub(crate) struct Native {
    /// Returns true for a type that has this method, or whose name stands before `::` in a call.
    pub(crate) owner: fn(Ctor) -> bool,
    pub(crate) name: &'static str,
    /// How a method takes its receiver; `None` for a function without one.
    pub(crate) on: Option<Receiver>,
    /// The types of its parameters, without the receiver.
    pub(crate) takes: Vec<Type>,
    /// The function itself, given the receiver and the arguments.
    pub(crate) run: fn(&mut Machine<'_>, &mut [Value], Span) -> Eval,
}

/// How a library method takes the value on which it is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Receiver {
    /// As a value.
    Value,
    /// As the address of a place, to change it.
    Place,
}

impl Native {
    /// Returns true for a method that changes its receiver.
    pub(crate) fn changes(&self) -> bool {
        self.on == Some(Receiver::Place)
    }

    /// Returns how many arguments the function takes where it is called by its path, the receiver
    /// included.
    pub(crate) fn count(&self) -> usize {
        self.takes.len() + usize::from(self.on.is_some())
    }
}

impl Machine<'_> {
    /// Evaluates arguments and calls a library function, on a receiver if there is one.
    pub(crate) fn called_native(
        &mut self,
        native: &Native,
        on: Option<Value>,
        runs: &[Thunk],
        given: &Given,
    ) -> Eval {
        match (on, runs) {
            (Some(on), []) => self.native(native, &mut [on], given),
            (Some(on), [run]) => {
                let value = run.eval(self)?;
                self.native(native, &mut [on, value], given)
            }
            (on, runs) => {
                let is_method = on.is_some();
                let mut values = Vec::with_capacity(runs.len() + 1);
                values.extend(on);
                for run in runs {
                    values.push(run.eval(self)?);
                }
                if !is_method {
                    self.receives(native, &values, given.at)?;
                }
                self.native(native, &mut values, given)
            }
        }
    }

    /// Checks that the first value has the library method that is called by its path.
    pub(super) fn receives(&mut self, native: &Native, values: &[Value], at: Span) -> Eval<()> {
        match values.first() {
            Some(on) if native.on.is_some() && !(native.owner)(on.data.ctor()) => {
                let (name, found) = (native.name, self.named(on));
                let message = format!("no function named `{name}` found for `{found}`");
                self.wrong(at, message, "")
            }
            _ => Ok(()),
        }
    }

    /// Checks the types of all values but the receiver, the first of a method, and calls a library
    /// function with them.
    #[inline]
    pub(crate) fn native(&mut self, native: &Native, values: &mut [Value], given: &Given) -> Eval {
        let first = usize::from(native.on.is_some());
        for (n, ty) in native.takes.iter().enumerate() {
            let value = &values[first + n];
            let is_it = match (ty.0, &value.data) {
                (Ctor::Like, Data::Float(_)) => {
                    value.lent == 0 && matches!(values[0].data, Data::Float(_))
                }
                _ => is_plainly(value, ty),
            };
            if !is_it {
                self.take_as(native, values, n, given)?;
            }
        }
        self.run_native(native, values, given.at)
    }

    /// Checks the value for the library function's parameter `n`.
    #[inline(never)]
    fn take_as(
        &mut self,
        native: &Native,
        values: &mut [Value],
        n: usize,
        given: &Given,
    ) -> Eval<()> {
        let first = usize::from(native.on.is_some());
        let like = self.ty(&values[0].clone().owned());
        // Where it is called by its path, the value that it is called on has a place, too.
        let after = first * usize::from(given.spots.len() == native.count());
        let value = mem::take(&mut values[first + n]);
        let ty = native.takes[n].with(&like);
        values[first + n] = self.as_declared(value, &ty, given.spot(n + after))?;
        Ok(())
    }

    /// Runs a library function, or the function of the text that takes its place.
    #[inline]
    fn run_native(&mut self, native: &Native, values: &mut [Value], at: Span) -> Eval {
        if self.code.instead.is_empty() {
            return (native.run)(self, values, at);
        }
        self.run_instead(native, values, at)
    }

    /// Runs the function of the text that takes a library function's place; if there is none,
    /// rounds the library's result to an `f32` where the program runs in single precision.
    #[inline(never)]
    fn run_instead(&mut self, native: &Native, values: &mut [Value], at: Span) -> Eval {
        let is_of_vectors = (native.owner)(Ctor::Vec3) || (native.owner)(Ctor::Ray);
        let mut instead = self.code.instead.iter().filter(|_| is_of_vectors);
        if let Some((_, own)) = instead.find(|it| it.0 == native.name) {
            return self.run(*own, values, at);
        }
        let value = (native.run)(self, values, at)?;
        Ok(match value.data {
            Data::Float(it) => self.rounded(it).into(),
            _ => value,
        })
    }
}
