//! A runtime for closures that are made of a text: values on a stack, frames of calls,
//! addresses, and the budgets of all that.
//!
//! The arithmetic is that of the compiled chapters. A type is checked where a value meets what
//! is declared.

mod calls;
mod checks;
pub(crate) mod iter;
mod operators;
mod places;
mod sizes;
pub(crate) mod value;

use std::collections::HashMap;
use std::fmt;
use std::mem;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::{Arc, Mutex};

use crate::limits::{DEEPEST_VALUE, MEMORY};
use crate::names::Names;
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};
pub(crate) use calls::Given;
pub(crate) use operators::alike;
pub(crate) use places::{FieldAccess, PlaceExpr};
use value::{Data, Value};

/// A program that is ready to be run.
#[derive(Clone)]
pub(crate) struct Code {
    pub(crate) names: Arc<Names>,
    pub(crate) functions: Vec<Arc<CompiledFunction>>,
    pub(crate) texts: Arc<Vec<String>>,
    /// True if floats have 24 bits.
    pub(crate) is_single: bool,
    /// The number of the mutant that runs, or 0.
    pub(crate) mutant: u32,
    /// Functions of the text that are called in place of those of the library.
    pub(crate) instead: Vec<(&'static str, usize)>,
    /// Other texts of functions that were read before.
    pub(crate) read: Arc<Mutex<FunctionCache>>,
}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&*self.texts).finish()
    }
}

/// Functions by their numbers and texts.
pub(crate) type FunctionCache = HashMap<(usize, String), Arc<CompiledFunction>>;

/// A function, ready to be run.
#[derive(Default)]
pub(crate) struct CompiledFunction {
    pub(crate) slots: usize,
    /// The names of the slots.
    pub(crate) names: Vec<String>,
    pub(crate) body: Thunk,
    pub(crate) marks: Vec<Arc<CoveragePoint>>,
    /// The function as it is written, unless it is a constant or only promised.
    pub(crate) written: Option<FunctionSource>,
}

/// A function as it is written.
pub(crate) struct FunctionSource {
    /// Its name, behind that of its type if it has one: `Sphere::hit`.
    pub(crate) name: String,
    /// Its text from `fn` to its closing bracket.
    pub(crate) text: String,
}

/// Lines that run together, and whether they ever did.
pub(crate) struct CoveragePoint {
    pub(crate) at: Span,
    pub(crate) has_run: AtomicBool,
}

impl CoveragePoint {
    pub(crate) fn at(at: Span) -> Self {
        let has_run = false.into();
        Self { at, has_run }
    }

    pub(crate) fn notes_that_it_runs(&self) {
        self.has_run.store(true, Relaxed);
    }
}

/// How many parameters a closure has, and what binds them and runs its body.
pub(crate) struct Closure {
    pub(crate) parameters: usize,
    pub(crate) body: Box<Body>,
}

type Body = dyn Fn(&mut Machine<'_>, &[Value]) -> Eval + Send + Sync;

/// A function of the library.
pub(crate) struct Native {
    /// Finds whether it is called on values of a type, or the type's name stands before it.
    pub(crate) owner: fn(Ctor) -> bool,
    pub(crate) name: &'static str,
    /// If it is a method, how it takes the value that it is called on.
    pub(crate) on: Option<Receiver>,
    /// The types of its other parameters.
    pub(crate) takes: Vec<Type>,
    pub(crate) run: fn(&mut Machine<'_>, &mut [Value], Span) -> Eval,
}

/// How a method of the library takes the value that it is called on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Receiver {
    Value,
    /// By its address, to change it.
    Place,
}

impl Native {
    /// Finds whether it changes what it is called on.
    pub(crate) fn changes(&self) -> bool {
        self.on == Some(Receiver::Place)
    }

    /// Returns how many arguments it takes where it is called by its path.
    pub(crate) fn count(&self) -> usize {
        self.takes.len() + usize::from(self.on.is_some())
    }
}

/// Why what follows is not run. What is brought along is kept by the machine.
#[derive(Clone, Copy, Debug)]
pub(crate) enum EarlyExit {
    Return,
    Break,
    Continue,
    Fault,
}

pub(crate) type Eval<T = Value> = Result<T, EarlyExit>;

/// An expression, ready to be run.
pub(crate) enum Thunk {
    Float(f64),
    Local(usize),
    Act(Box<Act>),
}

type Act = dyn Fn(&mut Machine<'_>) -> Eval + Send + Sync;

impl Thunk {
    pub(crate) fn new(act: impl Fn(&mut Machine<'_>) -> Eval + Send + Sync + 'static) -> Self {
        Self::Act(Box::new(act))
    }

    /// Returns what it comes to. It is called for each part of each expression, from many places.
    #[inline(always)]
    pub(crate) fn eval(&self, machine: &mut Machine<'_>) -> Eval {
        match self {
            Self::Float(it) => Ok(machine.rounded(*it).into()),
            Self::Local(slot) => Ok(machine.local(*slot)),
            Self::Act(act) => act(machine),
        }
    }

    /// Returns the number that it is without a call, as most operands of operators are.
    #[inline(always)]
    pub(crate) fn number(&self, machine: &Machine<'_>) -> Option<f64> {
        match self {
            Self::Float(it) => Some(machine.rounded(*it)),
            Self::Local(slot) => match machine.stack[machine.base + slot] {
                Value {
                    lent: 0,
                    data: Data::Float(it),
                } => Some(it),
                _ => None,
            },
            Self::Act(_) => None,
        }
    }
}

impl Default for Thunk {
    fn default() -> Self {
        Self::new(|_| Ok(Value::default()))
    }
}

/// The place of an expression, and what its text shows before it runs.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ExprInfo {
    pub(crate) at: Span,
    pub(crate) form: ExprForm,
}

/// A form of expression that the compiler's words depend on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum ExprForm {
    #[default]
    Other,
    /// A number with a point, of which nothing says how wide it is.
    Float,
    /// A number without one, of which nothing says what it is.
    Int,
    Bool,
    /// A reference that is made there.
    Lend,
    /// A variable of which the compiler wants to know the type.
    Open,
    /// One after which nothing comes.
    Never,
}

impl From<Span> for ExprInfo {
    fn from(at: Span) -> Self {
        let form = ExprForm::Other;
        Self { at, form }
    }
}

/// A value that a `let` binds, or that a function returns before its end.
pub(crate) struct Binding {
    /// The number of the function.
    pub(crate) function: usize,
    /// The slot of the variable; `None` for the value of a `return`.
    pub(crate) slot: Option<usize>,
    pub(crate) value: Value,
}

/// The state of a program that runs: the values of all functions that are being called.
pub(crate) struct Machine<'c> {
    pub(crate) code: &'c Code,
    stack: Vec<Value>,
    base: usize,
    depth: u32,
    /// How many more turns of loops and calls there may be.
    turns: u32,
    /// How many bytes are left.
    memory: usize,
    /// The value that `return` or `break` brings along.
    pub(crate) left: Value,
    fault: Option<Refusal>,
    constants: Vec<Option<Value>>,
    /// The function that runs, by its number.
    function: usize,
    /// The values that were bound so far; `None` if no trace is kept.
    pub(crate) trace: Option<Vec<Binding>>,
}

impl<'c> Machine<'c> {
    /// Makes a machine that takes so many turns for what it is asked.
    pub(crate) fn new(code: &'c Code, turns: u32) -> Self {
        Self {
            code,
            stack: Vec::with_capacity(64),
            base: 0,
            depth: 0,
            turns,
            memory: MEMORY,
            left: Value::default(),
            fault: None,
            constants: Vec::new(),
            function: 0,
            trace: None,
        }
    }

    /// Returns what has stopped the text.
    pub(crate) fn fault(&mut self) -> Refusal {
        self.fault.take().expect("functions catch what leaves them")
    }

    /// Returns the value of a variable.
    #[inline]
    pub(crate) fn local(&self, slot: usize) -> Value {
        let value = &self.stack[self.base + slot];
        let data = match value.data {
            Data::Float(it) => Data::Float(it),
            Data::Vec3(it) => Data::Vec3(it),
            ref data => data.clone(),
        };
        let lent = value.lent;
        Value { lent, data }
    }

    /// Gives a variable its value.
    #[inline]
    pub(crate) fn set_local(&mut self, slot: usize, value: Value) {
        self.stack[self.base + slot] = value;
    }

    /// Gives a variable that a `let` declares its value, and notes that.
    #[inline]
    pub(crate) fn bind(&mut self, slot: usize, value: Value) {
        self.note(Some(slot), &value);
        self.set_local(slot, value);
    }

    /// Adds a value to the trace, if one is kept.
    #[inline]
    fn note(&mut self, slot: Option<usize>, value: &Value) {
        if let Some(trace) = &mut self.trace {
            let (function, value) = (self.function, value.clone());
            trace.push(Binding {
                function,
                slot,
                value,
            });
        }
    }

    /// Stops with what the compiler refuses, or what is not read here.
    pub(crate) fn refused<T>(&mut self, refusal: Refusal) -> Eval<T> {
        self.fault = Some(refusal);
        Err(EarlyExit::Fault)
    }

    /// Stops with the compiler's words.
    pub(crate) fn wrong<T>(&mut self, at: Span, message: impl Into<String>, help: &str) -> Eval<T> {
        self.refused(Refusal::new(at, message, "", help))
    }

    /// Stops with what is not read here.
    pub(crate) fn unread<T>(&mut self, at: Span, what: &str) -> Eval<T> {
        self.refused(Refusal::unread(at, what))
    }

    /// Stops as the compiled program would.
    pub(crate) fn panic<T>(&mut self, at: Span, message: &str) -> Eval<T> {
        self.refused(Refusal::stop(at, message, ""))
    }

    /// Counts a turn of a loop, or a call.
    pub(crate) fn turn(&mut self, at: Span) -> Eval<()> {
        self.turns = self.turns.saturating_sub(1);
        if self.turns > 0 {
            return Ok(());
        }
        let message = "this takes too many turns of loops and calls";
        let help = "the page counts no further: what ends a loop here may never come true";
        self.refused(Refusal::stop(at, message, help))
    }

    /// Counts the bytes that a value takes.
    pub(crate) fn take(&mut self, bytes: usize, at: Span) -> Eval<()> {
        if let Some(left) = self.memory.checked_sub(bytes) {
            self.memory = left;
            return Ok(());
        }
        let message = "this takes too much memory";
        let help = "the page keeps no more: what ends a loop here may never come true";
        self.refused(Refusal::stop(at, message, help))
    }

    /// Counts what a value takes that is kept in another.
    pub(crate) fn keep(&mut self, value: &Value, at: Span) -> Eval<()> {
        if matches!(value.data, Data::Float(_)) {
            return self.take(size_of::<Value>(), at);
        }
        if value.depth() > DEEPEST_VALUE {
            return self.panic(at, "this value is nested too deeply");
        }
        self.take(value.size(), at)
    }

    /// Runs the body of a loop; returns whether it has left the loop.
    pub(crate) fn is_left(&mut self, body: &Thunk) -> Eval<bool> {
        self.left = Value::default();
        match body.eval(self) {
            Err(EarlyExit::Break) => Ok(true),
            Err(EarlyExit::Continue) | Ok(_) => Ok(false),
            Err(stop) => Err(stop),
        }
    }

    /// Returns what a loop has left with.
    pub(crate) fn brought(&mut self) -> Value {
        mem::take(&mut self.left)
    }
}
