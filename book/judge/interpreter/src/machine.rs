//! A stack machine: the variables of a running program, the frames of its open calls, and the
//! budgets that are left to it.

use std::mem;
use std::rc::Rc;
use std::sync::Arc;

use common::rtweekend::Vec3;

use crate::fault::{Fault, FaultKind, Span};
use crate::integers;
use crate::names::Names;
use crate::value::{Kind, Native, Shape, Value, kind};

/// The budget of turns of loops and calls for one pixel: far above what a chapter's pixel takes.
pub(crate) const MAX_TURNS: u32 = 200_000;
/// The budget of parts of values for one pixel.
pub(crate) const MAX_PARTS: usize = 1 << 23;
/// The deepest call of functions.
const MAX_CALLS: u32 = 60;
/// The deepest nesting of a value; in a chapter, a struct in a list is two deep.
const MAX_DEPTH: u8 = 100;

/// A reason why evaluation does not go on. The machine keeps the value of a jump, or the fault.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Exit {
    Return,
    Break,
    Continue,
    Fault,
}

/// The result of running a part of a program.
pub(crate) type Run<T = Value> = Result<T, Exit>;

/// A part of a program that can be run: constants and variables need no call.
pub(crate) enum Code {
    Number(f64),
    Vector(Vec3),
    /// The variable in a slot of the current frame.
    Local(usize),
    Act(Box<Act>),
}

type Act = dyn Fn(&mut Machine<'_>) -> Run + Send + Sync;

/// A program that can be run.
#[derive(Clone)]
pub(crate) struct Compiled {
    pub(crate) names: Arc<Names>,
    pub(crate) functions: Vec<Arc<Function>>,
    /// The number of the mutant that runs; 0 for none.
    pub(crate) mutant: u32,
    /// True if every number is rounded to 24 bits, as an `f32`.
    pub(crate) is_single: bool,
    /// True if an edit touches a function of the prelude that natives stand in for: none does then.
    pub(crate) is_edited: bool,
}

/// A function that was lowered.
pub(crate) struct Function {
    /// The count of variables in its frame; parameters come first.
    pub(crate) slots: usize,
    pub(crate) body: Code,
    /// The text from `fn` to the closing bracket; empty for a constant.
    pub(crate) text: String,
    /// The closures in its text.
    pub(crate) closures: Vec<ClosureCode>,
    /// The native that runs in its place.
    pub(crate) double: Option<&'static Native>,
}

/// A closure that was lowered.
pub(crate) struct ClosureCode {
    /// The slot of its first parameter.
    pub(crate) first: usize,
    /// For each parameter, true if what the closure makes of it goes back to the caller's place.
    pub(crate) parameters: Vec<bool>,
    /// The slots of the variables around it that it uses.
    pub(crate) captured: Vec<usize>,
    pub(crate) is_moved: bool,
    pub(crate) slots: usize,
    pub(crate) body: Code,
}

/// A value on the way to a pixel's color.
#[derive(Clone)]
pub struct TracedValue {
    /// The function in which the value arises: `ray_color`, or `Sphere::hit` for a method.
    pub function: Arc<str>,
    /// The name that a `let` gives the value; `None` if the function returns it before its end.
    pub name: Option<Arc<str>>,
    /// The value itself.
    pub value: Value,
}

/// The state of a running program.
pub(crate) struct Machine<'c> {
    pub(crate) code: &'c Compiled,
    is_single: bool,
    pub(crate) stack: Vec<Value>,
    /// The first slot of the current frame.
    pub(crate) base: usize,
    /// The first slot above all frames.
    pub(crate) top: usize,
    pub(crate) calls: u32,
    pub(crate) turns: u32,
    pub(crate) parts: usize,
    /// The value of the `return` or `break` that is on its way.
    pub(crate) left: Value,
    pub(crate) fault: Option<Fault>,
    /// The values of the pixel so far, if they are wanted.
    pub(crate) trace: Option<Vec<TracedValue>>,
}

impl Code {
    pub(crate) fn act(act: impl Fn(&mut Machine<'_>) -> Run + Send + Sync + 'static) -> Self {
        Self::Act(Box::new(act))
    }

    /// Makes code that only returns a value.
    pub(crate) fn constant(make: impl Fn() -> Value + Send + Sync + 'static) -> Self {
        Self::act(move |_| Ok(make()))
    }

    pub(crate) fn unit() -> Self {
        Self::constant(|| Value::Unit)
    }

    #[inline(always)]
    pub(crate) fn run(&self, m: &mut Machine<'_>) -> Run {
        match self {
            Self::Number(number) => Ok(Value::Float(m.rounded(*number))),
            Self::Vector(vector) => Ok(Value::Vec3(m.all_rounded(*vector))),
            Self::Local(slot) => Ok(match m.local(*slot) {
                Value::Float(number) => Value::Float(*number),
                Value::Vec3(vector) => Value::Vec3(*vector),
                value => value.clone(),
            }),
            Self::Act(act) => act(m),
        }
    }

    /// Returns the number of a constant, or of a variable that has one now; `None` for all that
    /// must be run.
    #[inline(always)]
    pub(crate) fn number(&self, m: &Machine<'_>) -> Option<f64> {
        match self {
            Self::Number(number) => Some(m.rounded(*number)),
            Self::Local(slot) => m.local(*slot).float(),
            _ => None,
        }
    }
}

impl<'c> Machine<'c> {
    /// Makes a machine without any budget. The stack may be that of another one.
    pub(crate) fn new(code: &'c Compiled, mut stack: Vec<Value>) -> Self {
        stack.resize(stack.len().max(64), Value::Unit);
        Self {
            code,
            is_single: code.is_single,
            stack,
            base: 0,
            top: 0,
            calls: 0,
            turns: 0,
            parts: 0,
            left: Value::Unit,
            fault: None,
            trace: None,
        }
    }

    #[inline(always)]
    pub(crate) fn local(&self, slot: usize) -> &Value {
        &self.stack[self.base + slot]
    }

    #[inline(always)]
    pub(crate) fn local_mut(&mut self, slot: usize) -> &mut Value {
        &mut self.stack[self.base + slot]
    }

    /// Rounds a number to 24 bits if the program runs in single precision.
    #[inline(always)]
    pub(crate) fn rounded(&self, number: f64) -> f64 {
        match self.is_single {
            true => f64::from(number as f32),
            false => number,
        }
    }

    /// Rounds the components of a vector if the program runs in single precision.
    #[inline(always)]
    pub(crate) fn all_rounded(&self, vector: Vec3) -> Vec3 {
        match self.is_single {
            true => Vec3::from_array(vector.to_array().map(|it| self.rounded(it))),
            false => vector,
        }
    }

    /// Adds a value to the trace, if one is kept.
    #[inline]
    pub(crate) fn note(&mut self, function: &Arc<str>, name: Option<&Arc<str>>, value: &Value) {
        if let Some(trace) = &mut self.trace {
            trace.push(TracedValue {
                function: Arc::clone(function),
                name: name.cloned(),
                value: value.clone(),
            });
        }
    }

    /// Runs codes and makes a value of theirs.
    pub(crate) fn gather(&mut self, shape: Shape, codes: &[Code], at: Span) -> Run {
        if let [code] = codes {
            let parts = [code.run(self)?];
            return self.keep(Value::data(shape, parts), at);
        }
        let base = self.open(codes.len());
        for (n, code) in codes.iter().enumerate() {
            self.stack[base + n] = code.run(self)?;
        }
        self.top = base;
        self.taken(shape, base, codes.len(), at)
    }

    /// Makes a value of the parts that lie in the slots of a frame.
    pub(crate) fn taken(&mut self, shape: Shape, base: usize, count: usize, at: Span) -> Run {
        let slots = self.stack[base..base + count].iter_mut();
        let parts: Rc<[Value]> = slots.map(mem::take).collect();
        self.keep(Value::data(shape, parts), at)
    }

    /// Opens a frame above all others. Its slots keep what was there before.
    pub(crate) fn open(&mut self, slots: usize) -> usize {
        let base = self.top;
        self.top += slots;
        if self.top > self.stack.len() {
            self.stack.resize(2 * self.top, Value::Unit);
        }
        base
    }

    /// Runs a body in a frame, and catches its `return`.
    pub(crate) fn within(&mut self, base: usize, body: &Code, at: Span) -> Run {
        self.turn(at)?;
        if self.calls == MAX_CALLS {
            return self.panic(at, "functions call each other too deeply");
        }
        let outer = mem::replace(&mut self.base, base);
        self.calls += 1;
        let result = body.run(self);
        self.calls -= 1;
        self.base = outer;
        match result {
            Err(Exit::Return) => Ok(mem::take(&mut self.left)),
            result => result,
        }
    }

    /// Runs the body of a loop once; returns true if a `break` left the loop.
    pub(crate) fn run_body(&mut self, body: &Code, at: Span) -> Run<bool> {
        self.turn(at)?;
        match body.run(self) {
            Err(Exit::Break) => Ok(true),
            Err(Exit::Continue) => Ok(false),
            result => self.admit(kind::UNIT, &mut result?, at).map(|()| false),
        }
    }

    /// Runs a condition.
    #[inline]
    pub(crate) fn truth(&mut self, code: &Code, at: Span) -> Run<bool> {
        match code.run(self)? {
            Value::Bool(truth) => Ok(truth),
            other => self.mismatch(at, "bool", other.kind()),
        }
    }

    /// Checks that a value is of a declared type. An integer of no known type becomes one of that
    /// type.
    #[inline]
    pub(crate) fn admit(&mut self, wanted: Kind, value: &mut Value, at: Span) -> Run<()> {
        match wanted == value.kind() || wanted == kind::ANY {
            true => Ok(()),
            false => self.convert(wanted, value, at),
        }
    }

    #[inline(never)]
    fn convert(&mut self, wanted: Kind, value: &mut Value, at: Span) -> Run<()> {
        match value {
            Value::Int(_, _) if wanted == kind::INT => Ok(()),
            Value::Int(number, of @ kind::INT) if integers::is_integer(wanted) => {
                if !integers::has(wanted, *number) {
                    let name = self.code.names.shown(wanted);
                    return self.refuse(at, format!("{number} is no `{name}`: out of its range"));
                }
                *of = wanted;
                Ok(())
            }
            _ => {
                let wanted = self.code.names.shown(wanted);
                self.mismatch(at, wanted, value.kind())
            }
        }
    }
}

/// Faults and budgets.
impl Machine<'_> {
    #[cold]
    pub(crate) fn stop<T>(&mut self, fault: Fault) -> Run<T> {
        self.fault = Some(fault);
        Err(Exit::Fault)
    }

    /// Stops the program at what the compiler would refuse.
    #[cold]
    pub(crate) fn refuse<T>(&mut self, at: Span, message: impl Into<String>) -> Run<T> {
        self.stop(Fault::refused(at, message))
    }

    /// Stops the program at what the compiler may accept and is not read here.
    #[cold]
    pub(crate) fn unread<T>(&mut self, at: Span, words: &str) -> Run<T> {
        self.stop(Fault::unread(at, words))
    }

    /// Stops the program as a panic would.
    #[cold]
    pub(crate) fn panic<T>(&mut self, at: Span, message: impl Into<String>) -> Run<T> {
        self.stop(Fault::new(FaultKind::Stopped, at, message))
    }

    /// Stops the program at a value of the wrong type.
    #[cold]
    pub(crate) fn mismatch<T>(&mut self, at: Span, wanted: &str, found: Kind) -> Run<T> {
        let found = self.code.names.shown(found);
        self.refuse(at, format!("expected `{wanted}`, found `{found}`"))
    }

    /// Spends one turn of a loop, or one call.
    #[inline]
    pub(crate) fn turn(&mut self, at: Span) -> Run<()> {
        self.turns = self.turns.saturating_sub(1);
        match self.turns {
            0 => self.panic(at, "this takes too many turns of loops and calls"),
            _ => Ok(()),
        }
    }

    /// Spends room for parts of values.
    #[inline]
    pub(crate) fn spend(&mut self, parts: usize, at: Span) -> Run<()> {
        match self.parts.checked_sub(parts) {
            Some(left) => self.parts = left,
            None => return self.panic(at, "this takes too much memory"),
        }
        Ok(())
    }

    /// Spends the room for a new value, and refuses one that is nested too deeply.
    #[inline]
    pub(crate) fn keep(&mut self, value: Value, at: Span) -> Run {
        self.spend(value.parts().len(), at)?;
        match value.depth() {
            0..=MAX_DEPTH => Ok(value),
            _ => self.panic(at, "this value is nested too deeply"),
        }
    }
}
