//! Callbacks: what the library asks of the machine that runs it.

use crate::limits::DEEPEST_VALUE;
use crate::operators::Sign;
use crate::refusal::{At, Refusal};
use crate::types::Type;
use crate::value::Value;

/// Why what follows is not run. What is brought along is kept by the machine.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stop {
    Return,
    Break,
    Continue,
    Fault,
}

pub(crate) type Eval<T = Value> = Result<T, Stop>;

pub(crate) trait Host {
    /// Calls a value that is a function.
    fn apply(&mut self, function: &Value, given: &mut [Value], at: At) -> Eval;

    /// A value as what is declared.
    fn declared(&mut self, value: Value, ty: &Type, at: At) -> Eval;

    /// What comes out of an operator between two values.
    fn arithmetic(&mut self, sign: Sign, left: Value, right: Value, at: At) -> Eval;

    /// Counts a turn of a loop, or a call.
    fn turn(&mut self, at: At) -> Eval<()>;

    /// Counts what a value takes.
    fn take(&mut self, bytes: usize, at: At) -> Eval<()>;

    /// Keeps why the text does not run.
    fn refuse(&mut self, refusal: Refusal) -> Stop;

    /// The value at the end of a mutable reference.
    fn followed(&self, value: &Value) -> Value;

    /// Changes what a mutable reference leads to.
    fn change(&mut self, reference: &Value, change: &mut dyn FnMut(&mut Value));

    /// A function that may be called when the one that made it is over.
    fn kept(&self, function: &Value) -> Value;

    /// What a value is, in a label of the compiler.
    fn said(&self, value: &Value) -> String;
}

impl dyn Host + '_ {
    /// The text has stopped by itself.
    pub(crate) fn panic<T>(&mut self, at: At, message: &str) -> Eval<T> {
        Err(self.refuse(Refusal::stop(at, message, "")))
    }

    /// Counts what a value takes that is kept in another.
    pub(crate) fn keep(&mut self, value: &Value, at: At) -> Eval<()> {
        if value.depth() > DEEPEST_VALUE {
            let message = "this value is nested too deeply";
            return self.panic(at, message);
        }
        self.take(value.size(), at)
    }

    /// Whether a function says so of what it is given.
    pub(crate) fn asked(&mut self, f: &Value, given: &mut [Value], at: At) -> Eval<bool> {
        let value = self.apply(f, given, at)?;
        Ok(self.declared(value, &Type::BOOL, at)?.truth())
    }
}
