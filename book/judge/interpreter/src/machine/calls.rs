//! Calls: arguments on the stack, closures in their frames, functions of the library.

use std::mem;
use std::rc::Rc;
use std::sync::Arc;

use super::Machine;
use crate::host::{Eval, Host};
use crate::library::{Native, Take, native};
use crate::node::{Arguments, Closure, Node};
use crate::refusal::{At, Refusal};
use crate::types::Owners;
use crate::value::{Data, Frame, Value};

impl Machine<'_> {
    fn push_all(&mut self, nodes: &[Node]) -> Eval<()> {
        for node in nodes {
            let value = self.operand(node)?;
            self.stack.push(value);
        }
        Ok(())
    }

    #[inline(never)]
    pub(super) fn called(&mut self, function: usize, given: &Arguments) -> Eval {
        let start = self.stack.len();
        self.push_all(&given.nodes)?;
        self.arrive_as(function, start, 0, given)?;
        self.enter(function, start, given.at)
    }

    /// Calls a method whose receiver is known.
    pub(super) fn called_on(&mut self, function: usize, on: Value, given: &Arguments) -> Eval {
        let wanted = self.code.names.functions[function].parameters.len() - 1;
        if wanted != given.nodes.len() {
            return self.refused(Refusal::miscounted(
                true,
                wanted,
                given.nodes.len(),
                given.at,
            ));
        }
        let start = self.stack.len();
        self.stack.push(on);
        self.push_all(&given.nodes)?;
        self.arrive_as(function, start, 1, given)?;
        self.enter(function, start, given.at)
    }

    #[inline(never)]
    pub(super) fn constant(&mut self, function: usize, at: At) -> Eval {
        if let Some(Some(known)) = self.constants.get(function) {
            return Ok(known.clone());
        }
        let value = self.run(function, &[], at)?;
        self.constants.resize(self.code.functions.len(), None);
        self.constants[function] = Some(value.clone());
        Ok(value)
    }

    /// A function of the library by its path.
    #[inline(never)]
    pub(super) fn native(&mut self, number: usize, given: &Arguments) -> Eval {
        let native = native(number);
        if let ([node], None) = (&*given.nodes, native.on) {
            let mut values = [self.operand(node)?];
            self.check_all(native, &mut values, 0, given)?;
            return self.run_native(native, &mut values, given.at);
        }
        let mut values = self.all(&given.nodes)?;
        let is_method = native.on.is_some();
        if let Some(on) = values.first().filter(|_| is_method)
            && !self.has(on, native)
        {
            let found = self.ty(on).name(&self.code.names);
            let message = format!("no function named `{}` found for `{found}`", native.name);
            return self.refused(Refusal::new(given.at, message, "", ""));
        }
        let after = usize::from(is_method);
        self.check_all(native, &mut values, after, given)?;
        self.run_native(native, &mut values, given.at)
    }

    /// Whether a value has a method of the library.
    pub(super) fn has(&self, value: &Value, native: &Native) -> bool {
        match &value.data {
            Data::Mut(_) => native.changes() || self.has(&self.end_of(value), native),
            Data::Own(kind, _) => {
                native.name == "clone" && self.code.names.kinds[*kind as usize].derives("Clone")
            }
            _ => native.owners.has(Owners::of(value.head())),
        }
    }

    /// Checks what a function of the library takes.
    #[inline]
    pub(super) fn check_all(
        &mut self,
        native: &Native,
        values: &mut [Value],
        after: usize,
        given: &Arguments,
    ) -> Eval<()> {
        let first = given.nodes.len() + after - values.len();
        let (on, rest) = values.split_at_mut(after);
        let on = on.first().unwrap_or(&NOTHING);
        for (n, (take, value)) in native.takes.iter().zip(rest).enumerate() {
            if take.accepts(value, on) && !matches!(take, Take::Fn(_)) {
                continue;
            }
            let node = &given.nodes[first + n];
            if let (Data::Single(_), Node::Float(it)) = (&on.data, node) {
                *value = Data::Single(*it as f32).into();
            }
            self.check(*take, value, on, given.places[first + n], Some(node))?;
        }
        Ok(())
    }

    pub(super) fn check(
        &mut self,
        take: Take,
        value: &Value,
        on: &Value,
        at: At,
        node: Option<&Node>,
    ) -> Eval<()> {
        if !take.accepts(value, on) {
            return self.not_taken(take, value, on, at, node);
        }
        match take {
            Take::Fn(count) => self.takes_as_many(value, count, at),
            _ => Ok(()),
        }
    }

    #[inline(never)]
    fn not_taken(
        &mut self,
        take: Take,
        value: &Value,
        on: &Value,
        at: At,
        node: Option<&Node>,
    ) -> Eval<()> {
        if matches!(value.data, Data::Mut(_)) {
            let value = self.end_of(value).owned().lent();
            return self.check(take, &value, on, at, node);
        }
        let wanted = take.ty(&self.ty(&on.clone().owned()));
        self.mismatch(value, &wanted, at, node)
    }

    /// Whether a function takes so many arguments, as the one that calls it wants.
    fn takes_as_many(&mut self, function: &Value, count: usize, at: At) -> Eval<()> {
        let (what, takes) = match &function.data {
            Data::Closure(it, _) => ("closure", it.parameters.len()),
            Data::Function(it) => {
                let own = &self.code.names.functions[*it];
                ("function", own.parameters.len())
            }
            Data::Native(it) => {
                let native = native(*it);
                let on = usize::from(native.on.is_some());
                ("function", native.takes.len() + on)
            }
            _ => return Ok(()),
        };
        if takes == count {
            return Ok(());
        }
        let several = |n: usize| if n == 1 { "argument" } else { "arguments" };
        let message = format!(
            "{what} is expected to take {count} {}, but it takes {takes} {}",
            several(count),
            several(takes)
        );
        self.refused(Refusal::new(at, message, "", ""))
    }

    /// Runs a function of the library, or that of the text which takes its place.
    pub(super) fn run_native(&mut self, native: &Native, values: &mut [Value], at: At) -> Eval {
        if self.code.instead.is_empty() {
            return (native.run)(self, values, at);
        }
        let is_of_vectors = native.owners == Owners::VEC3 || native.owners == Owners::RAY;
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

    #[inline(never)]
    pub(super) fn applied_to(&mut self, function: &Node, given: &Arguments) -> Eval {
        let function = self.eval(function)?;
        let mut function = self.end_of(&function);
        while let Data::Box(inner) = &function.data {
            function = (**inner).clone();
        }
        let mut values = self.all(&given.nodes)?;
        let count = values.len();
        let takes = match &function.data {
            Data::Closure(it, _) => it.parameters.len(),
            Data::Function(it) => self.code.names.functions[*it].parameters.len(),
            Data::Native(it) => {
                let native = native(*it);
                native.takes.len() + usize::from(native.on.is_some())
            }
            _ => count,
        };
        if takes != count {
            return self.refused(Refusal::miscounted(false, takes, count, given.at));
        }
        self.applied(&function, &mut values, given.at)
    }

    /// Calls a value that is a function.
    pub(super) fn applied(&mut self, function: &Value, given: &mut [Value], at: At) -> Eval {
        match &function.data {
            Data::Function(function) => self.run(*function, given, at),
            Data::Native(number) => {
                self.turn(at)?;
                let native = native(*number);
                let after = usize::from(native.on.is_some());
                let (on, rest) = given.split_at(after);
                let on = on.first().unwrap_or(&NOTHING);
                for (take, value) in native.takes.iter().zip(rest) {
                    self.check(*take, value, on, at, None)?;
                }
                self.run_native(native, given, at)
            }
            Data::Closure(closure, frame) => self.in_its_frame(closure, frame, given, at),
            Data::Mut(_) => {
                let function = self.end_of(function);
                self.applied(&function, given, at)
            }
            _ => {
                let name = self.ty(function).name(&self.code.names);
                let message = format!("expected function, found `{name}`");
                self.refused(Refusal::new(at, message, "", ""))
            }
        }
    }

    fn in_its_frame(&mut self, closure: &Closure, frame: &Frame, given: &[Value], at: At) -> Eval {
        let body = |own: &mut Self| {
            for (pattern, value) in closure.parameters.iter().zip(given) {
                own.binds(pattern, value)?;
            }
            own.eval(&closure.body)
        };
        match *frame {
            Frame::Taken(ref frame) => {
                let start = self.stack.len();
                self.stack.extend_from_slice(frame);
                self.in_frame(start, start + frame.len(), at, body)
            }
            // The function that made it is over, so it uses nothing of its.
            Frame::At(base, slots) if base as usize > self.base => {
                let start = self.stack.len();
                self.in_frame(start, start + slots as usize, at, body)
            }
            Frame::At(base, _) => {
                self.turn(at)?;
                let base = mem::replace(&mut self.base, base as usize);
                let result = body(self);
                self.base = base;
                self.returned(result)
            }
        }
    }

    #[inline(never)]
    pub(super) fn closure(&mut self, closure: &Arc<Closure>, is_moved: bool, at: At) -> Eval {
        let slots = self.stack.len() - self.base;
        let frame = if is_moved {
            self.take(slots * size_of::<Value>(), at)?;
            Frame::Taken(Rc::new(self.stack[self.base..].to_vec()))
        } else {
            Frame::At(self.base as u32, slots as u32)
        };
        Ok(Data::Closure(Arc::clone(closure), frame).into())
    }

    /// A function that may be called when the one that made it is over.
    pub(super) fn with_its_frame(&self, function: &Value) -> Value {
        match &function.data {
            Data::Closure(closure, Frame::At(base, slots)) => {
                let start = *base as usize;
                let frame = self.stack[start..start + *slots as usize].to_vec();
                Data::Closure(Arc::clone(closure), Frame::Taken(Rc::new(frame))).into()
            }
            _ => function.clone(),
        }
    }
}

/// What a function is called on that is no method.
const NOTHING: Value = Value {
    lent: 0,
    data: Data::Unit,
};
