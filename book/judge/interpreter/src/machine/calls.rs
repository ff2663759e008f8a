//! Calls: frames of functions and closures, and functions of the library.

use std::mem;
use std::rc::Rc;
use std::sync::Arc;

use common::rtweekend::Vec3;

use super::checks::is_plainly;
use super::value::{Address, Captures, Data, Value};
use super::{Closure, EarlyExit, Eval, ExprInfo, Machine, Thunk};
use crate::limits::MAX_CALL_DEPTH;
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

/// The places of a call and its arguments in the text, for messages about a wrong one.
pub(crate) struct Given {
    /// The form and span of each argument; empty if the arguments are not written at the call.
    pub(crate) spots: Vec<ExprInfo>,
    /// The whole call.
    pub(crate) at: Span,
}

impl Given {
    /// Returns the form and span of argument `n`; the whole call if that is not written.
    pub(super) fn spot(&self, n: usize) -> ExprInfo {
        self.spots.get(n).copied().unwrap_or(self.at.into())
    }
}

/// Makes a call whose arguments are not written, such as one by an iterator.
impl From<Span> for Given {
    fn from(at: Span) -> Self {
        let spots = Vec::new();
        Self { spots, at }
    }
}

impl Machine<'_> {
    /// Calls a function from outside of the program, with each value lent where a reference is
    /// declared.
    ///
    /// # Errors
    /// The refusal that stops the program.
    pub(crate) fn call(&mut self, function: usize, given: &[Value]) -> Result<Value, Refusal> {
        let wanted = &self.code.names.functions[function].parameters;
        let as_wanted = given.iter().zip(wanted).map(|(value, ty)| {
            let is_lent = ty.is(Ctor::Ref) && !matches!(value.data, Data::Mut(_));
            let (lent, data) = (u8::from(is_lent), value.data.clone());
            Value { lent, data }
        });
        let given: Vec<Value> = as_wanted.collect();
        self.run(function, &given, Span::default())
            .map_err(|_| self.fault())
    }

    /// Returns the color to which a function comes for a pixel or a ray.
    ///
    /// # Errors
    /// The refusal that stops the program, or the one of a value that is no vector.
    pub(crate) fn colored(
        &mut self,
        color: &Value,
        given: &mut [Value],
        at: Span,
    ) -> Result<Vec3, Refusal> {
        let value = self.applied(color, given, at);
        let value = value.and_then(|it| self.as_declared(it, &Ctor::Vec3.into(), at.into()));
        value.map(|it| it.vec3()).map_err(|_| self.fault())
    }

    /// Calls the method `add` on a value once for each element of `with`, and returns the value.
    ///
    /// # Errors
    /// The refusal that stops the program.
    pub(crate) fn filled(
        &mut self,
        add: usize,
        value: Value,
        with: Vec<Value>,
    ) -> Result<Value, Refusal> {
        self.stack.push(value);
        let slot = self.stack.len() - 1;
        for one in with {
            self.call(add, &[Data::Mut(Address::of(slot)).into(), one])?;
        }
        Ok(self.stack.pop().unwrap_or_default())
    }

    /// Calls a function with values, whose types are checked first.
    pub(crate) fn run(&mut self, function: usize, given: &[Value], at: Span) -> Eval {
        let start = self.stack.len();
        self.stack.extend_from_slice(given);
        self.arrive(function, start, &at.into())?;
        self.enter(function, start, at)
    }

    /// Evaluates arguments that check their own types, and calls a function with them.
    pub(crate) fn called(&mut self, function: usize, given: &[Thunk], at: Span) -> Eval {
        let start = self.stack.len();
        for run in given {
            let value = run.eval(self)?;
            self.stack.push(value);
        }
        self.enter(function, start, at)
    }

    /// Evaluates arguments, checks their count and types, and calls a method of the text on a
    /// value.
    pub(crate) fn called_on(
        &mut self,
        function: usize,
        on: Value,
        runs: &[Thunk],
        given: &Given,
    ) -> Eval {
        let wanted = self.code.names.functions[function].parameters.len() - 1;
        if wanted != runs.len() {
            return self.refused(Refusal::miscounted(true, wanted, runs.len(), given.at));
        }
        let start = self.stack.len();
        self.stack.push(on);
        for run in runs {
            let value = run.eval(self)?;
            self.stack.push(value);
        }
        self.arrive(function, start, given)?;
        self.enter(function, start, given.at)
    }

    /// Checks the types of a function's arguments on the stack, from slot `start` on. If the
    /// arguments are written, the first is a receiver that is checked already.
    fn arrive(&mut self, function: usize, start: usize, given: &Given) -> Eval<()> {
        let code = self.code;
        let wanted = &code.names.functions[function].parameters;
        let after = usize::from(!given.spots.is_empty());
        for (n, ty) in wanted.iter().enumerate().skip(after) {
            if !is_plainly(&self.stack[start + n], ty) {
                let value = mem::take(&mut self.stack[start + n]);
                self.stack[start + n] = self.as_declared(value, ty, given.spot(n - after))?;
            }
        }
        Ok(())
    }

    /// Runs a function whose arguments are on the stack, from slot `start` on.
    fn enter(&mut self, function: usize, start: usize, at: Span) -> Eval {
        let code = self.code;
        let caller = mem::replace(&mut self.function, function);
        let function = &code.functions[function];
        let size = start + function.slots;
        let result = self.in_frame(start, size, at, |own| function.body.eval(own));
        self.function = caller;
        result
    }

    /// Runs a body in its own frame of the stack, from `start` to `end`, within the limits of depth
    /// and turns.
    fn in_frame(
        &mut self,
        start: usize,
        end: usize,
        at: Span,
        body: impl FnOnce(&mut Self) -> Eval,
    ) -> Eval {
        if self.depth == MAX_CALL_DEPTH {
            let message = format!("more than {MAX_CALL_DEPTH} calls are open at once");
            let help = "the page goes no deeper: a function that calls itself may have no end";
            return self.refused(Refusal::stop(at, &message, help));
        }
        self.turn(at)?;
        let base = mem::replace(&mut self.base, start);
        self.stack.resize_with(end, Value::default);
        self.depth += 1;
        let result = body(self);
        self.depth -= 1;
        self.stack.truncate(start);
        self.base = base;
        self.returned(result)
    }

    /// Turns the early exit of a `return` into its value, which is added to the trace.
    fn returned(&mut self, result: Eval) -> Eval {
        let Err(EarlyExit::Return) = result else {
            return result;
        };
        let value = self.brought();
        self.note(None, &value);
        Ok(value)
    }

    /// Returns the value of a constant, which is computed once.
    pub(crate) fn constant(&mut self, function: usize, at: Span) -> Eval {
        if let Some(Some(known)) = self.constants.get(function) {
            return Ok(known.clone());
        }
        let value = self.run(function, &[], at)?;
        self.constants.resize(self.code.functions.len(), None);
        self.constants[function] = Some(value.clone());
        Ok(value)
    }

    /// Calls a value that is a function, with values whose count is checked already.
    pub(crate) fn applied(&mut self, function: &Value, given: &mut [Value], at: Span) -> Eval {
        match &function.data {
            Data::Function(function) => self.run(*function, given, at),
            Data::Native(native) => {
                self.turn(at)?;
                self.receives(native, given, at)?;
                self.native(native, given, &at.into())
            }
            Data::Closure(closure, frame) => self.in_its_frame(closure, frame, given, at),
            Data::Mut(_) => {
                let function = self.end_of(function);
                self.applied(&function, given, at)
            }
            Data::Box(inner) => self.applied(&inner.clone(), given, at),
            _ => {
                let name = self.named(function);
                self.wrong(at, format!("expected function, found `{name}`"), "")
            }
        }
    }

    /// Calls a predicate, and returns its truth.
    pub(crate) fn asked(&mut self, f: &Value, given: &mut [Value], at: Span) -> Eval<bool> {
        let value = self.applied(f, given, at)?;
        Ok(self.as_declared(value, &Type::BOOL, at.into())?.truth())
    }

    /// Returns the word for a function value, `closure` or `function`, and the count of its
    /// parameters; `None` for any other value.
    pub(super) fn parameters(&self, function: &Value) -> Option<(&'static str, usize)> {
        Some(match &function.data {
            Data::Closure(it, _) => ("closure", it.parameters),
            Data::Function(it) => ("function", self.code.names.functions[*it].parameters.len()),
            Data::Native(it) => ("function", it.count()),
            Data::Box(it) => return self.parameters(it),
            _ => return None,
        })
    }

    /// Calls a value that is a function, and checks the count of its arguments.
    pub(crate) fn applied_to(&mut self, function: &Value, given: &mut [Value], at: Span) -> Eval {
        let function = self.end_of(function);
        match self.parameters(&function) {
            Some((_, takes)) if takes != given.len() => {
                self.refused(Refusal::miscounted(false, takes, given.len(), at))
            }
            _ => self.applied(&function, given, at),
        }
    }

    /// Runs a closure with the variables that it captured.
    fn in_its_frame(
        &mut self,
        closure: &Closure,
        frame: &Captures,
        given: &[Value],
        at: Span,
    ) -> Eval {
        let start = self.stack.len();
        match *frame {
            Captures::Moved(ref frame) => {
                self.stack.extend_from_slice(frame);
                let end = start + frame.len();
                self.in_frame(start, end, at, |own| (closure.body)(own, given))
            }
            // The function that made the closure is over: the closure uses none of its variables.
            Captures::Borrowed(base, slots) if base as usize > self.base => {
                let end = start + slots as usize;
                self.in_frame(start, end, at, |own| (closure.body)(own, given))
            }
            Captures::Borrowed(base, _) => {
                self.turn(at)?;
                let base = mem::replace(&mut self.base, base as usize);
                let result = (closure.body)(self, given);
                self.base = base;
                self.returned(result)
            }
        }
    }

    /// Makes a value of a closure. With `move`, it takes a copy of all variables of the current
    /// frame.
    pub(crate) fn closure(&mut self, closure: &Arc<Closure>, is_moved: bool, at: Span) -> Eval {
        let slots = self.stack.len() - self.base;
        let frame = if is_moved {
            self.take(slots * size_of::<Value>(), at)?;
            Captures::Moved(Rc::new(self.stack[self.base..].to_vec()))
        } else {
            Captures::Borrowed(self.base as u32, slots as u32)
        };
        Ok(Data::Closure(Arc::clone(closure), frame).into())
    }

    /// Returns a function value that outlives the current frame: a closure gets a copy of its
    /// variables.
    pub(crate) fn kept(&self, function: &Value) -> Value {
        match &function.data {
            Data::Closure(closure, Captures::Borrowed(base, slots)) => {
                let start = *base as usize;
                let frame = self.stack[start..start + *slots as usize].to_vec();
                Data::Closure(Arc::clone(closure), Captures::Moved(Rc::new(frame))).into()
            }
            _ => function.clone(),
        }
    }
}
