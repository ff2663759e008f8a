//! Calls of functions and closures. What a call changes through a `&mut` is copied in before it and
//! copied out after it, as exclusive borrows allow.

use std::cell::{Cell, RefCell};
use std::mem;
use std::rc::Rc;

use crate::fault::{Fault, Span};
use crate::machine::{ClosureCode, Code, Compiled, Exit, MAX_PARTS, MAX_TURNS, Machine, Run};
use crate::place::Place;
use crate::value::{Closure, Kind, Native, Shape, Target, Value, Variables, Wrong};

/// An argument of a call.
pub(crate) struct Argument {
    pub(crate) code: Code,
    /// The place in which the value lies, if it does.
    pub(crate) place: Option<Place>,
    pub(crate) at: Span,
}

impl Compiled {
    fn closure(&self, closure: &Closure) -> &ClosureCode {
        let (function, number) = closure.code;
        &self.functions[function].closures[number]
    }
}

impl Machine<'_> {
    /// Calls a function or a closure from outside, with fresh budgets. What it changes by a `&mut`
    /// is changed in `given`.
    ///
    /// # Errors
    /// The fault at which the call stops.
    pub(crate) fn ask(&mut self, callee: &Value, given: &mut [Value]) -> Result<Value, Fault> {
        (self.base, self.top, self.calls) = (0, 0, 0);
        (self.turns, self.parts) = (MAX_TURNS, MAX_PARTS);
        let base = self.open(self.slots(callee).max(given.len()));
        self.stack[..given.len()].clone_from_slice(given);
        let result = self.enter(callee, base, given.len(), Span::default());
        given.clone_from_slice(&self.stack[..given.len()]);
        result.map_err(|_| self.fault.take().expect("a call catches all jumps"))
    }

    /// Calls the value of an expression: a function or a closure.
    pub(crate) fn apply(&mut self, callee: &Value, given: &[Argument], at: Span) -> Run {
        let can_change = |(n, argument): (usize, &Argument)| {
            let place = argument.place.as_ref().filter(|place| !place.is_fixed);
            place.filter(|_| self.changes(callee, n)).map(|_| n)
        };
        let lent: Vec<usize> = given.iter().enumerate().filter_map(can_change).collect();
        self.call(callee, None, given, &lent, at)
    }

    /// Returns true if what a function makes of its parameter `n` goes back to the caller.
    fn changes(&self, callee: &Value, n: usize) -> bool {
        match callee {
            Value::Function(target) => self.code.names.changes(*target, n),
            Value::Closure(closure) => self.code.closure(closure).parameters.get(n) == Some(&true),
            _ => false,
        }
    }

    /// Returns how many slots the frame of a function needs at least.
    fn slots(&self, callee: &Value) -> usize {
        match callee {
            Value::Function(Target::Own(n)) => self.code.functions[*n].slots,
            _ => 0,
        }
    }

    /// Calls a function. The arguments with the numbers in `lent` are taken from their places, after
    /// the others are computed, and brought back after the call. A receiver is a first argument that
    /// is computed already.
    pub(crate) fn call(
        &mut self,
        callee: &Value,
        receiver: Option<Value>,
        given: &[Argument],
        lent: &[usize],
        at: Span,
    ) -> Run {
        let base = self.open(self.slots(callee).max(given.len()));
        let first = usize::from(receiver.is_some());
        if let Some(receiver) = receiver {
            self.stack[base] = receiver;
        }
        for (n, argument) in given.iter().enumerate().skip(first) {
            let is_lent = !lent.is_empty() && lent.contains(&n);
            match argument.place.as_ref().filter(|_| is_lent) {
                Some(place) => place.settle(self)?,
                None => self.stack[base + n] = argument.code.run(self)?,
            }
        }
        for &n in lent {
            if let Some(place) = &given[n].place {
                self.stack[base + n] = Value::Unit;
                self.stack[base + n] = place.take(self, given[n].at)?;
            }
        }
        let result = self.enter(callee, base, given.len(), at);
        if let (Err(Exit::Fault), Some(fault)) = (&result, &mut self.fault) {
            fault.called_at(at);
        }
        for &n in lent {
            if let Some(place) = &given[n].place {
                let value = mem::take(&mut self.stack[base + n]);
                let value = self.keep(value, given[n].at)?;
                place.put(self, value, given[n].at)?;
            }
        }
        self.top = base;
        result
    }

    /// Calls a function with the arguments that lie in the first slots of a frame. What the call
    /// makes of them lies there afterwards.
    fn enter(&mut self, callee: &Value, base: usize, count: usize, at: Span) -> Run {
        let code = self.code;
        let wanted = match callee {
            Value::Function(target) => code.names.takes(*target),
            Value::Closure(closure) => code.closure(closure).parameters.len(),
            other => return self.mismatch(at, "fn", other.kind()),
        };
        if count != wanted {
            return self.stop(Fault::miscounted(at, wanted, count));
        }
        match callee {
            Value::Function(Target::Own(n)) => match code.functions[*n].double {
                Some(native) if !code.is_edited && !code.is_single && self.trace.is_none() => {
                    self.run_native(native, base, at)
                }
                _ => self.enter_own(*n, base, at),
            },
            Value::Function(Target::Native(native)) => self.run_native(native, base, at),
            Value::Function(Target::Default(kind)) => {
                Ok(code.names.default_of(*kind).unwrap_or_default())
            }
            Value::Function(Target::Variant(shape)) => self.enter_variant(*shape, base, count, at),
            Value::Closure(closure) => self.enter_closure(closure, base, at),
            _ => Ok(Value::Unit),
        }
    }

    fn enter_own(&mut self, n: usize, base: usize, at: Span) -> Run {
        let code = self.code;
        let parameters = code.names.signatures[n].parameters.iter();
        self.admit_all(parameters.map(|it| it.kind), base, at)?;
        self.within(base, &code.functions[n].body, at)
    }

    #[inline]
    fn run_native(&mut self, native: &Native, base: usize, at: Span) -> Run {
        match (native.run)(&mut self.stack[base..base + native.takes]) {
            Ok(Value::Float(number)) => Ok(Value::Float(self.rounded(number))),
            Ok(value @ Value::Vec3(_)) => Ok(value),
            Ok(value) => self.keep(value, at),
            Err(Wrong::Type(wanted, found)) => self.mismatch(at, wanted, found),
            Err(Wrong::Panic(message)) => self.panic(at, message),
        }
    }

    /// Makes a struct or a variant of the values of its fields.
    fn enter_variant(&mut self, shape: Shape, base: usize, count: usize, at: Span) -> Run {
        let fields = self.code.names.variant(shape).fields.iter();
        self.admit_all(fields.map(|it| it.1), base, at)?;
        self.taken(shape, base, count, at)
    }

    /// Checks that the values in the first slots of a frame are of their declared types.
    #[inline]
    fn admit_all(&mut self, kinds: impl Iterator<Item = Kind>, base: usize, at: Span) -> Run<()> {
        for (slot, kind) in (base..).zip(kinds) {
            if kind != self.stack[slot].kind() {
                let mut value = mem::take(&mut self.stack[slot]);
                self.admit(kind, &mut value, at)?;
                self.stack[slot] = value;
            }
        }
        Ok(())
    }
}

/// Closures.
impl Machine<'_> {
    /// Calls a closure, whose parameters are variables of the frame in which its other variables
    /// are: that of the function around it, or one with copies.
    fn enter_closure(&mut self, closure: &Closure, base: usize, at: Span) -> Run {
        if closure.is_running.replace(true) {
            return self.unread(at, "a closure that calls itself");
        }
        let result = self.run_closure(closure, base, at);
        closure.is_running.set(false);
        result
    }

    fn run_closure(&mut self, closure: &Closure, base: usize, at: Span) -> Run {
        let code = self.code.closure(closure);
        let frame = match &closure.variables {
            Variables::InFrame(frame) if frame + code.slots <= base => *frame,
            Variables::InFrame(_) => {
                return self.refuse(at, "this closure outlives the variables that it uses");
            }
            Variables::Moved(values) => {
                let frame = self.open(code.slots);
                for (slot, value) in code.captured.iter().zip(&*values.borrow()) {
                    self.stack[frame + slot] = value.clone();
                }
                frame
            }
        };
        let count = code.parameters.len();
        (0..count).for_each(|n| self.stack.swap(base + n, frame + code.first + n));
        let result = self.within(frame, &code.body, at)?;
        (0..count).for_each(|n| self.stack.swap(base + n, frame + code.first + n));
        if let Variables::Moved(values) = &closure.variables {
            for (slot, value) in code.captured.iter().zip(&mut *values.borrow_mut()) {
                *value = mem::take(&mut self.stack[frame + slot]);
            }
        }
        Ok(result)
    }

    /// Makes a closure of the current frame, by the function around it and its number there.
    pub(crate) fn closure(&mut self, code: (usize, usize), at: Span) -> Run {
        let lowered = &self.code.functions[code.0].closures[code.1];
        let captured = lowered.captured.iter();
        let moved: Vec<Value> = captured.map(|slot| self.local(*slot).clone()).collect();
        let depths = moved.iter().map(|value| value.depth().saturating_add(1));
        let depth = depths.max().unwrap_or(0);
        // One that uses nothing may outlive the frame.
        let variables = match lowered.is_moved || moved.is_empty() {
            true => Variables::Moved(RefCell::new(moved)),
            false => Variables::InFrame(self.base),
        };
        let is_running = Cell::new(false);
        let closure = Closure {
            code,
            variables,
            depth,
            is_running,
        };
        self.keep(Value::Closure(Rc::new(closure)), at)
    }
}
