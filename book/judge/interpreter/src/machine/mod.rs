//! A tree-walking interpreter: each node is what it says, in the arithmetic of the compiled
//! chapters. A type is checked where a value meets what is declared.

mod calls;
mod check;
mod comparisons;
mod eval;
mod methods;
mod operators;
mod patterns;
mod places;

use std::collections::HashMap;
use std::mem;
use std::sync::{Arc, Mutex};

use common::rtweekend::Vec3;

use crate::host::{Eval, Host, Stop};
use crate::limits::{DEEPEST, MEMORY};
use crate::names::Names;
use crate::node::{Function, Node};
use crate::operators::Sign;
use crate::refusal::{At, Refusal};
use crate::types::{Head, Type};
use crate::value::{Address, Data, Value};
use crate::written::Written;

/// What runs.
#[derive(Clone, Debug)]
pub(crate) struct Code {
    pub(crate) names: Arc<Names>,
    pub(crate) functions: Vec<Arc<Function>>,
    /// The functions as they are written, in the same order.
    pub(crate) written: Vec<Option<Written>>,
    pub(crate) texts: Arc<Vec<String>>,
    /// Whether floats have 24 bits.
    pub(crate) is_single: bool,
    /// Which of all mutants runs, or 0.
    pub(crate) mutant: u32,
    /// Functions of the text that are called in place of those of the library.
    pub(crate) instead: Vec<(&'static str, usize)>,
    /// Other texts of functions that were read before.
    pub(crate) read: Arc<Mutex<Texts>>,
}

/// Functions by their numbers and texts.
pub(crate) type Texts = HashMap<(usize, String), Arc<Function>>;

/// What a `let` has bound, or a function has returned before its end: the function, the slot if
/// there is one, the value.
pub(crate) type Bound = (usize, Option<usize>, Value);

/// What runs a program: the values of all functions that are being called.
pub(crate) struct Machine<'c> {
    pub(crate) code: &'c Code,
    stack: Vec<Value>,
    base: usize,
    depth: u32,
    /// How many more turns of loops and calls there may be.
    turns: u32,
    /// How many bytes are left.
    memory: usize,
    /// What `return` and `break` bring along.
    left: Value,
    fault: Option<Refusal>,
    constants: Vec<Option<Value>>,
    /// The function that runs, by its number.
    function: usize,
    /// What was bound, if that is asked for.
    pub(crate) notes: Option<Vec<Bound>>,
}

impl<'c> Machine<'c> {
    /// A machine that takes so many turns for what it is asked.
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
            notes: None,
        }
    }

    /// Calls a function from outside; what stops it is a refusal.
    pub(crate) fn call(&mut self, function: usize, given: &[Value]) -> Result<Value, Refusal> {
        let wanted = &self.code.names.functions[function].parameters;
        let as_wanted = given.iter().zip(wanted).map(|(value, ty)| {
            let is_lent = ty.is(Head::Ref);
            let is_address = matches!(value.data, Data::Mut(_));
            Value {
                lent: u8::from(is_lent && !is_address),
                data: value.data.clone(),
            }
        });
        let given: Vec<Value> = as_wanted.collect();
        self.run(function, &given, At::default())
            .map_err(|_| self.fault())
    }

    /// What has stopped the text.
    pub(crate) fn fault(&mut self) -> Refusal {
        self.fault.take().expect("functions catch what leaves them")
    }

    /// The color that a function gives to a pixel.
    pub(crate) fn colored(&mut self, color: &Value, given: &mut [Value], at: At) -> Eval<Vec3> {
        let value = self.applied(color, given, at)?;
        Ok(self
            .as_declared(value, &Head::Vec3.into(), at, None)?
            .vec3())
    }

    /// What becomes of a value of which a method takes each of these, one after the other.
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

    /// Runs a function with what is checked where it arrives.
    fn run(&mut self, function: usize, given: &[Value], at: At) -> Eval {
        let start = self.stack.len();
        self.stack.extend_from_slice(given);
        self.arrive(function, start, 0, at)?;
        self.enter(function, start, at)
    }

    /// Runs a function whose arguments are on the stack.
    fn enter(&mut self, function: usize, start: usize, at: At) -> Eval {
        let code = self.code;
        let caller = mem::replace(&mut self.function, function);
        let function = &code.functions[function];
        let size = start + function.slots;
        let result = self.in_frame(start, size, at, |own| own.eval(&function.body));
        self.function = caller;
        result
    }

    /// Runs a body in a frame of its own.
    fn in_frame(
        &mut self,
        start: usize,
        end: usize,
        at: At,
        body: impl FnOnce(&mut Self) -> Eval,
    ) -> Eval {
        if self.depth == DEEPEST {
            let message = format!("more than {DEEPEST} calls are open at once");
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

    fn returned(&mut self, result: Eval) -> Eval {
        match result {
            Err(Stop::Return) => {
                let value = mem::take(&mut self.left);
                if let Some(notes) = &mut self.notes {
                    notes.push((self.function, None, value.clone()));
                }
                Ok(value)
            }
            result => result,
        }
    }

    fn refused<T>(&mut self, refusal: Refusal) -> Eval<T> {
        self.fault = Some(refusal);
        Err(Stop::Fault)
    }

    /// The text has stopped by itself.
    fn panic<T>(&mut self, at: At, message: &str) -> Eval<T> {
        self.refused(Refusal::stop(at, message, ""))
    }

    fn all(&mut self, nodes: &[Node]) -> Eval<Vec<Value>> {
        nodes.iter().map(|node| self.eval(node)).collect()
    }
}

impl Host for Machine<'_> {
    fn apply(&mut self, function: &Value, given: &mut [Value], at: At) -> Eval {
        self.applied(function, given, at)
    }

    fn declared(&mut self, value: Value, ty: &Type, at: At) -> Eval {
        self.as_declared(value, ty, at, None)
    }

    fn arithmetic(&mut self, sign: Sign, left: Value, right: Value, at: At) -> Eval {
        self.combined(sign, left, right, at)
    }

    fn turn(&mut self, at: At) -> Eval<()> {
        self.turns = self.turns.saturating_sub(1);
        if self.turns > 0 {
            return Ok(());
        }
        let message = "this takes too many turns of loops and calls";
        let help = "the page counts no further: what ends a loop here may never come true";
        self.refused(Refusal::stop(at, message, help))
    }

    fn take(&mut self, bytes: usize, at: At) -> Eval<()> {
        match self.memory.checked_sub(bytes) {
            Some(left) => {
                self.memory = left;
                Ok(())
            }
            None => {
                let message = "this takes too much memory";
                let help = "the page keeps no more: what ends a loop here may never come true";
                self.refused(Refusal::stop(at, message, help))
            }
        }
    }

    fn refuse(&mut self, refusal: Refusal) -> Stop {
        self.fault = Some(refusal);
        Stop::Fault
    }

    fn followed(&self, value: &Value) -> Value {
        self.end_of(value)
    }

    fn change(&mut self, reference: &Value, change: &mut dyn FnMut(&mut Value)) {
        let mut address = match &reference.data {
            Data::Mut(address) => address.clone(),
            other => unreachable!("types are checked, and {other:?} is no address"),
        };
        while let Data::Mut(next) = self.read(&address).data {
            address = next;
        }
        self.stack[address.slot as usize].reach(&address.steps, change);
    }

    fn kept(&self, function: &Value) -> Value {
        self.with_its_frame(function)
    }

    fn said(&self, value: &Value) -> String {
        self.ty(value).said(&self.code.names)
    }
}
