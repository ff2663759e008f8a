//! A runtime for closures that are made of a text: values on a stack, frames of calls,
//! addresses, and the budgets of all that.
//!
//! The arithmetic is that of the compiled chapters. A type is checked where a value meets what
//! is declared.

mod calls;
mod checks;
pub(crate) mod iter;
mod natives;
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

use crate::limits::{MAX_BYTES, MAX_VALUE_DEPTH};
use crate::names::Names;
use crate::refusal::{Refusal, Span};
pub(crate) use calls::Given;
pub(crate) use natives::{Native, Receiver};
pub(crate) use operators::alike;
pub(crate) use places::{FieldAccess, PlaceExpr};
use value::{Data, Value};

/// A program that was lowered, with the settings under which it runs.
#[derive(Clone)]
pub(crate) struct Code {
    pub(crate) names: Arc<Names>,
    pub(crate) functions: Vec<Arc<CompiledFunction>>,
    /// The text of each file.
    pub(crate) texts: Arc<Vec<String>>,
    /// True if every float is rounded to 24 bits, as an `f32`.
    pub(crate) is_single: bool,
    /// The number of the mutant that runs; 0 for none.
    pub(crate) mutant: u32,
    /// Names of library methods, each with the number of the text's function that is called in its
    /// place.
    pub(crate) instead: Vec<(&'static str, usize)>,
    /// The cache of functions that were patched in before.
    pub(crate) read: Arc<Mutex<FunctionCache>>,
}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&*self.texts).finish()
    }
}

/// Functions that were lowered, by their number and text.
pub(crate) type FunctionCache = HashMap<(usize, String), Arc<CompiledFunction>>;

/// A function that was lowered.
#[derive(Default)]
pub(crate) struct CompiledFunction {
    /// The count of variables in its frame; parameters come first.
    pub(crate) slots: usize,
    /// The name of each slot's variable.
    pub(crate) names: Vec<String>,
    pub(crate) body: Thunk,
    /// The statements of the function, each with a note if it ever ran.
    pub(crate) marks: Vec<Arc<CoveragePoint>>,
    /// The function's name and text; `None` for a constant, or a method that a trait only declares.
    pub(crate) written: Option<FunctionSource>,
}

/// A function as it stands in the text.
pub(crate) struct FunctionSource {
    /// The name, behind that of the type if it is a method: `Sphere::hit`.
    pub(crate) name: String,
    /// The text from `fn` to the closing bracket.
    pub(crate) text: String,
}

/// A part of the text that runs as a whole, with a note if it ever ran.
pub(crate) struct CoveragePoint {
    pub(crate) at: Span,
    pub(crate) has_run: AtomicBool,
}

impl CoveragePoint {
    pub(crate) fn at(at: Span) -> Self {
        let has_run = false.into();
        Self { at, has_run }
    }

    /// Notes that the part ran.
    pub(crate) fn notes_that_it_runs(&self) {
        self.has_run.store(true, Relaxed);
    }
}

/// A closure that was lowered.
pub(crate) struct Closure {
    /// The count of parameters.
    pub(crate) parameters: usize,
    /// The function that binds the arguments to the parameters and runs the body.
    pub(crate) body: Box<Body>,
}

/// The function behind a closure: from its arguments to its value.
type Body = dyn Fn(&mut Machine<'_>, &[Value]) -> Eval + Send + Sync;

/// A reason why evaluation does not go on: a jump, or a refusal. The machine keeps the value of a
/// jump, or the refusal.
#[derive(Clone, Copy, Debug)]
pub(crate) enum EarlyExit {
    Return,
    Break,
    Continue,
    Fault,
}

/// The result of running a part of a program.
pub(crate) type Eval<T = Value> = Result<T, EarlyExit>;

/// A part of a program that can be run: constants and variables need no call.
pub(crate) enum Thunk {
    /// A number with a point.
    Float(f64),
    /// The variable in a slot of the current frame.
    Local(usize),
    /// A function that runs the part.
    Act(Box<Act>),
}

/// The function behind a thunk.
type Act = dyn Fn(&mut Machine<'_>) -> Eval + Send + Sync;

impl Thunk {
    pub(crate) fn new(act: impl Fn(&mut Machine<'_>) -> Eval + Send + Sync + 'static) -> Self {
        Self::Act(Box::new(act))
    }

    /// Runs the part, and returns its value. Inlined everywhere: each part of each expression runs
    /// so.
    #[inline(always)]
    pub(crate) fn eval(&self, machine: &mut Machine<'_>) -> Eval {
        match self {
            Self::Float(it) => Ok(machine.rounded(*it).into()),
            Self::Local(slot) => Ok(machine.local(*slot)),
            Self::Act(act) => act(machine),
        }
    }

    /// Returns the number of a constant or of a variable that holds an `f64`, as most operands are;
    /// `None` for anything that must be run.
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

/// The span of an expression, and the form that its text shows.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ExprInfo {
    pub(crate) at: Span,
    pub(crate) form: ExprForm,
}

/// A form of expression on which the compiler's words depend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum ExprForm {
    #[default]
    Other,
    /// A number with a point and without a type.
    Float,
    /// A number without a point and without a type.
    Int,
    /// A comparison, or another expression that is certainly a `bool`.
    Bool,
    /// A `&…` that is written at this place.
    Lend,
    /// A variable whose type nothing says.
    Open,
    /// An expression after which nothing runs.
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

/// The state of a running program: a stack of variables, the frames of open calls, and the budgets
/// that are left.
pub(crate) struct Machine<'c> {
    pub(crate) code: &'c Code,
    /// The variables of all open calls, the innermost last.
    stack: Vec<Value>,
    /// The first slot of the current frame.
    base: usize,
    /// The count of open calls.
    depth: u32,
    /// How many turns of loops and calls are left.
    turns: u32,
    /// How many bytes are left.
    memory: usize,
    /// The value of the `return` or `break` that is on its way.
    pub(crate) left: Value,
    /// The refusal that stops the program.
    fault: Option<Refusal>,
    /// The constants by their function's number, as far as they are computed.
    constants: Vec<Option<Value>>,
    /// The number of the current function.
    function: usize,
    /// The values that were bound so far; `None` if no trace is kept.
    pub(crate) trace: Option<Vec<Binding>>,
}

impl<'c> Machine<'c> {
    /// Makes a machine with a budget of turns of loops and calls.
    pub(crate) fn new(code: &'c Code, turns: u32) -> Self {
        Self {
            code,
            stack: Vec::with_capacity(64),
            base: 0,
            depth: 0,
            turns,
            memory: MAX_BYTES,
            left: Value::default(),
            fault: None,
            constants: Vec::new(),
            function: 0,
            trace: None,
        }
    }

    /// Takes the refusal that has stopped the program.
    pub(crate) fn fault(&mut self) -> Refusal {
        self.fault.take().expect("functions catch what leaves them")
    }

    /// Returns a copy of the variable in a slot of the current frame.
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

    /// Sets the variable in a slot of the current frame.
    #[inline]
    pub(crate) fn set_local(&mut self, slot: usize, value: Value) {
        self.stack[self.base + slot] = value;
    }

    /// Sets the variable that a `let` declares, and adds its value to the trace.
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

    /// Stops the program with a refusal.
    pub(crate) fn refused<T>(&mut self, refusal: Refusal) -> Eval<T> {
        self.fault = Some(refusal);
        Err(EarlyExit::Fault)
    }

    /// Stops the program with a message of the compiler.
    pub(crate) fn wrong<T>(&mut self, at: Span, message: impl Into<String>, help: &str) -> Eval<T> {
        self.refused(Refusal::new(at, message, "", help))
    }

    /// Stops the program at something that this interpreter does not read.
    pub(crate) fn unread<T>(&mut self, at: Span, what: &str) -> Eval<T> {
        self.refused(Refusal::unread(at, what))
    }

    /// Stops the program as a panic would.
    pub(crate) fn panic<T>(&mut self, at: Span, message: &str) -> Eval<T> {
        self.refused(Refusal::stop(at, message, ""))
    }

    /// Spends one turn of a loop or one call from the budget, and stops the program if none is
    /// left.
    pub(crate) fn turn(&mut self, at: Span) -> Eval<()> {
        self.turns = self.turns.saturating_sub(1);
        if self.turns > 0 {
            return Ok(());
        }
        let message = "this takes too many turns of loops and calls";
        let help = "the page counts no further: the condition that ends a loop may never hold";
        self.refused(Refusal::stop(at, message, help))
    }

    /// Spends bytes from the budget, and stops the program if too few are left.
    pub(crate) fn take(&mut self, bytes: usize, at: Span) -> Eval<()> {
        if let Some(left) = self.memory.checked_sub(bytes) {
            self.memory = left;
            return Ok(());
        }
        let message = "this takes too much memory";
        let help = "the page keeps no more: the condition that ends a loop may never hold";
        self.refused(Refusal::stop(at, message, help))
    }

    /// Spends the bytes of a value that is put into another one, and stops the program if the value
    /// is nested too deeply.
    pub(crate) fn keep(&mut self, value: &Value, at: Span) -> Eval<()> {
        if matches!(value.data, Data::Float(_)) {
            return self.take(size_of::<Value>(), at);
        }
        if value.depth() > MAX_VALUE_DEPTH {
            return self.panic(at, "this value is nested too deeply");
        }
        self.take(value.size(), at)
    }

    /// Runs the body of a loop once; returns true if a `break` left the loop.
    pub(crate) fn run_body(&mut self, body: &Thunk) -> Eval<bool> {
        self.left = Value::default();
        match body.eval(self) {
            Err(EarlyExit::Break) => Ok(true),
            Err(EarlyExit::Continue) | Ok(_) => Ok(false),
            Err(stop) => Err(stop),
        }
    }

    /// Takes the value of the `break` or `return` that came last.
    pub(crate) fn brought(&mut self) -> Value {
        mem::take(&mut self.left)
    }
}
