//! A tree-walking interpreter: each node is what it says, in the arithmetic of the compiled
//! chapters. What reading has left open is checked here: what is declared, and which types go
//! together.

use std::iter;
use std::mem;
use std::rc::Rc;
use std::sync::Arc;

use common::rtweekend::Vec3 as DVec3;

use crate::lower::miscounted;
use crate::names::Names;
use crate::node::{Arm, At, Closure, Function, Node, Order, Pattern, Root, Sign, Target};
use crate::patch::Written;
use crate::prelude::Native;
use crate::read::Refusal;
use crate::types::{Head, Int, Type};
use crate::value::{Address, Frame, Iter, Value};

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
}

/// Why what follows is not run. What is brought along is kept by the machine.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stop {
    Return,
    Break,
    Continue,
    Fault,
}

pub(crate) type Eval<T = Value> = Result<T, Stop>;

/// So deep is no call in a chapter.
const DEEPEST: u32 = 60;

/// Pixels, each with the levels that it should have.
pub type Sample = [(u32, [u8; 3])];

/// What runs a program: the values of all functions that are being called.
pub(crate) struct Machine<'c> {
    pub(crate) code: &'c Code,
    stack: Vec<Value>,
    base: usize,
    depth: u32,
    /// How many turns of loops and calls there may be, and how many are left.
    limit: u32,
    turns: u32,
    /// What `return` and `break` bring along.
    left: Value,
    fault: Option<Refusal>,
    constants: Vec<Option<Value>>,
    /// The function that runs, by its number.
    function: usize,
    /// What was bound to the slots of which functions, if that is asked for.
    pub(crate) notes: Option<Vec<(usize, usize, Value)>>,
}

impl<'c> Machine<'c> {
    /// A machine that takes so many turns for what it is asked, and for each pixel.
    pub(crate) fn new(code: &'c Code, limit: u32) -> Self {
        Self {
            code,
            stack: Vec::with_capacity(64),
            base: 0,
            depth: 0,
            limit,
            turns: limit,
            left: Value::Unit,
            fault: None,
            constants: Vec::new(),
            function: 0,
            notes: None,
        }
    }

    /// Another pixel, which may take as long as the one before.
    pub(crate) fn begin(&mut self) {
        self.turns = self.limit;
    }

    pub(crate) fn turn(&mut self, at: At) -> Eval<()> {
        self.turns = self.turns.saturating_sub(1);
        if self.turns > 0 {
            return Ok(());
        }
        let message = "this takes too many turns of loops and calls";
        let help = "the page counts no further: what ends a loop here may never come true";
        self.refuse(Refusal::stop(at, message, help))
    }

    pub(crate) fn refuse<T>(&mut self, refusal: Refusal) -> Eval<T> {
        self.fault = Some(refusal);
        Err(Stop::Fault)
    }

    /// The text has stopped by itself.
    pub(crate) fn panic<T>(&mut self, at: At, message: &str) -> Eval<T> {
        self.refuse(Refusal::stop(at, message, ""))
    }

    /// Calls a function from outside; what stops it is a refusal.
    pub(crate) fn call(&mut self, function: usize, arguments: &[Value]) -> Result<Value, Refusal> {
        self.run(function, arguments, At::default())
            .map_err(|_| self.fault())
    }

    /// What has stopped the text.
    pub(crate) fn fault(&mut self) -> Refusal {
        self.fault.take().expect("functions catch what leaves them")
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
            self.call(add, &[Value::Mut(Address::of(slot)), one])?;
        }
        Ok(self.stack.pop().unwrap_or_default())
    }

    fn run(&mut self, function: usize, arguments: &[Value], at: At) -> Eval {
        let start = self.stack.len();
        self.stack.extend_from_slice(arguments);
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
            return self.refuse(Refusal::stop(at, &message, help));
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
            Err(Stop::Return) => Ok(mem::take(&mut self.left)),
            result => result,
        }
    }

    fn push_all(&mut self, nodes: &[Node]) -> Eval<usize> {
        let start = self.stack.len();
        for node in nodes {
            let value = self.eval(node)?;
            self.stack.push(value);
        }
        Ok(start)
    }

    /// Calls a value that is a function.
    pub(crate) fn apply(&mut self, function: &Value, arguments: &mut [Value], at: At) -> Eval {
        match function {
            Value::Function(function) => {
                let wanted = self.code.names.functions[*function].parameters.clone();
                let arguments = self.all_declared(&wanted, arguments, at)?;
                self.run(*function, &arguments, at)
            }
            Value::Native(native, at) => {
                self.turn(*at)?;
                let wanted = &native.signature.parameters;
                let mut arguments = self.all_declared(wanted, arguments, *at)?;
                (native.run)(self, &mut arguments, *at)
            }
            Value::Closure(closure, frame) => {
                let body = |own: &mut Self| {
                    for (pattern, value) in closure.parameters.iter().zip(arguments) {
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
            other => {
                let name = other.ty().name(&self.code.names);
                let message = format!("expected function, found `{name}`");
                self.refuse(Refusal::new(at, &message, "", ""))
            }
        }
    }

    fn all_declared(&mut self, types: &[Type], values: &[Value], at: At) -> Eval<Vec<Value>> {
        if types.len() != values.len() {
            return self.refuse(miscounted(false, types.len(), values.len(), at));
        }
        let both = types.iter().zip(values);
        both.map(|(ty, value)| self.declared(value.clone(), ty, at))
            .collect()
    }

    /// A value as what is declared.
    pub(crate) fn declared(&mut self, value: Value, ty: &Type, at: At) -> Eval {
        let value = match (&value, ty.0) {
            (Value::Float(_), Head::F64) | (Value::Vec3(_), Head::Vec3) => return Ok(value),
            (Value::Mut(_), head) if !matches!(head, Head::RefMut | Head::Unknown) => {
                self.followed(&value)
            }
            (Value::Int(it, Int::Any), Head::Int(int)) if int.fits(*it) => Value::Int(*it, int),
            (Value::Int(_, Int::Any), Head::Int(_)) => {
                return self.panic(at, "attempt to compute a number with overflow");
            }
            _ => value,
        };
        if value.fits(ty, &self.code.names) {
            Ok(value)
        } else {
            self.refuse(self.code.names.mismatch(ty, &value.ty(), at))
        }
    }

    fn all(&mut self, nodes: &[Node]) -> Eval<Vec<Value>> {
        nodes.iter().map(|node| self.eval(node)).collect()
    }

    fn truth(&mut self, node: &Node) -> Eval<bool> {
        match self.eval(node)? {
            Value::Bool(it) => Ok(it),
            other => unreachable!("conditions are declared, and this is {other:?}"),
        }
    }

    /// What a node comes to. Each arm is a function of its own: this one is entered most.
    pub(crate) fn eval(&mut self, node: &Node) -> Eval {
        match node {
            Node::Unit => Ok(Value::Unit),
            Node::Bool(it) => Ok(Value::Bool(*it)),
            Node::Int(it, int) => Ok(Value::Int(*it, *int)),
            Node::Float(it) => Ok(Value::Float(self.rounded(*it))),
            Node::Vec3(it) => Ok(Value::Vec3(*it)),
            Node::Str(it) => Ok(Value::Str(Rc::new(it.to_string()))),
            Node::None => Ok(Value::None),
            Node::Function(function) => Ok(Value::Function(*function)),
            Node::NativeFunction(native, at) => Ok(Value::Native(native, *at)),
            Node::Closure(closure, is_moved) => Ok(self.closure(closure, *is_moved)),
            Node::Default(ty) => self.default(ty),
            Node::Constant(function, at) => self.constant(*function, *at),
            Node::Local(slot) => Ok(self.stack[self.base + slot].clone()),
            Node::Field(of, n) => self.field(of, *n),
            Node::Index(nodes, at) => self.indexed(nodes, *at),
            Node::Deref(of) => self.dereferenced(of),
            Node::Address(target) => Ok(Value::Mut(self.address(target)?)),
            Node::Set(target, value) => self.set(target, value),
            Node::Update(target, sign, value, at) => self.update(target, *sign, value, *at),
            Node::Let(pattern, value, other) => self.bound(pattern, value, other.as_deref()),
            Node::Arithmetic(sign, nodes, at) => self.operation(*sign, nodes, *at),
            Node::Compare(order, nodes, at) => self.comparison(*order, nodes, *at),
            Node::And(nodes) => self.until(nodes, false),
            Node::Or(nodes) => self.until(nodes, true),
            Node::Not(of, at) => self.not(of, *at),
            Node::Negate(of, at) => self.negated(of, *at),
            Node::Cast(of, ty, at) => self.cast(of, ty, *at),
            Node::Declared(of, ty, at) => self.checked(of, ty, *at),
            Node::Call(function, nodes, at) => self.called(*function, nodes, *at),
            Node::Native(native, nodes, at) => self.native(native, nodes, *at),
            Node::Dispatch(all, nodes, at) => self.dispatch(all, nodes, *at),
            Node::Apply(function, nodes, at) => self.applied_to(function, nodes, *at),
            Node::New(kind, fields, base) => self.made(*kind, fields, base.as_deref()),
            Node::Some(of) => Ok(Value::Some(Rc::new(self.eval(of)?))),
            Node::Many(nodes) => Ok(Value::Many(Rc::new(self.all(nodes)?))),
            Node::Tuple(nodes) => Ok(Value::Tuple(self.all(nodes)?.into())),
            Node::Range(ends, is_closed) => self.range(ends, *is_closed),
            Node::Format(pieces, nodes) => self.formatted(pieces, nodes),
            Node::If(nodes) => self.choice(nodes),
            Node::Match(of, arms, at) => self.matched(of, arms, *at),
            Node::Matches(pattern, of) => self.matches(pattern, of),
            Node::Block(nodes, has_value) => self.block(nodes, *has_value),
            Node::While(nodes, at) => self.repeated(nodes, *at),
            Node::For(pattern, nodes, at) => self.for_each(pattern, nodes, *at),
            Node::Break(value) => self.left_with(value, Stop::Break),
            Node::Continue => Err(Stop::Continue),
            Node::Return(value) => self.left_with(value, Stop::Return),
            Node::Try(of) => self.tried(of),
            Node::Panic(message, at) => self.panic(*at, message),
            Node::Mutants(first, all) => {
                let number = self.code.mutant.checked_sub(*first);
                let mutant = number.and_then(|n| all.get(n as usize + 1));
                self.eval(mutant.unwrap_or(&all[0]))
            }
        }
    }

    /// The same without a call for what operators mostly stand between.
    #[inline]
    fn operand(&mut self, node: &Node) -> Eval {
        match node {
            Node::Float(it) => return Ok(Value::Float(self.rounded(*it))),
            Node::Local(slot) => match &self.stack[self.base + slot] {
                Value::Float(it) => return Ok(Value::Float(*it)),
                Value::Vec3(it) => return Ok(Value::Vec3(*it)),
                _ => {}
            },
            _ => {}
        }
        self.eval(node)
    }

    #[inline(never)]
    fn closure(&mut self, closure: &Arc<Closure>, is_moved: bool) -> Value {
        let frame = if is_moved {
            Frame::Taken(Rc::new(self.stack[self.base..].to_vec()))
        } else {
            let slots = self.stack.len() - self.base;
            Frame::At(self.base as u32, slots as u32)
        };
        Value::Closure(Arc::clone(closure), frame)
    }

    /// A function that may be called when the one that made it is over.
    pub(crate) fn kept(&self, function: &Value) -> Value {
        match function {
            Value::Closure(closure, Frame::At(base, slots)) => {
                let start = *base as usize;
                let frame = self.stack[start..start + *slots as usize].to_vec();
                Value::Closure(Arc::clone(closure), Frame::Taken(Rc::new(frame)))
            }
            other => other.clone(),
        }
    }

    #[inline(never)]
    fn indexed(&mut self, nodes: &[Node; 2], at: At) -> Eval {
        let [list, index] = [self.eval(&nodes[0])?, self.eval(&nodes[1])?];
        let list = self.followed(&list);
        let n = self.index(&list, &index, at)?;
        Ok(list.field(n))
    }

    #[inline(never)]
    fn dereferenced(&mut self, of: &Node) -> Eval {
        let reference = self.eval(of)?;
        Ok(self.followed(&reference))
    }

    #[inline(never)]
    fn set(&mut self, target: &Target, value: &Node) -> Eval {
        let value = self.eval(value)?;
        if let (Root::Local(slot), []) = (&target.root, target.steps.as_slice()) {
            let slot = self.base + slot;
            self.stack[slot] = value;
        } else {
            let address = self.address(target)?;
            self.change(&address, |place| *place = value);
        }
        Ok(Value::Unit)
    }

    #[inline(never)]
    fn update(&mut self, target: &Target, sign: Sign, value: &Node, at: At) -> Eval {
        let right = self.eval(value)?;
        let address = self.address(target)?;
        let left = self.at(&address);
        let value = self.arithmetic(sign, left, right, at)?;
        self.change(&address, |place| *place = value);
        Ok(Value::Unit)
    }

    #[inline(never)]
    fn until(&mut self, nodes: &[Node; 2], enough: bool) -> Eval {
        let is_enough = self.truth(&nodes[0])? == enough;
        Ok(Value::Bool(if is_enough {
            enough
        } else {
            self.truth(&nodes[1])?
        }))
    }

    #[inline(never)]
    fn not(&mut self, of: &Node, at: At) -> Eval {
        match self.eval(of)? {
            Value::Bool(it) => Ok(Value::Bool(!it)),
            it => self.refuse(self.code.names.no_unary("!", &it.ty(), at)),
        }
    }

    #[inline(never)]
    fn negated(&mut self, of: &Node, at: At) -> Eval {
        Ok(match self.operand(of)? {
            Value::Float(it) => Value::Float(-it),
            Value::Vec3(it) => Value::Vec3(-it),
            Value::Int(it, int) if int.fits(-it) => Value::Int(-it, int),
            Value::Int(..) => return self.panic(at, "attempt to negate with overflow"),
            it => match self.code.names.method(&it.ty(), "neg", None) {
                Some(own) => self.run(own, &[it], at)?,
                None => return self.refuse(self.code.names.no_unary("-", &it.ty(), at)),
            },
        })
    }

    #[inline(never)]
    fn cast(&mut self, of: &Node, ty: &Type, at: At) -> Eval {
        let value = self.eval(of)?;
        let value = self.followed(&value);
        value.cast(ty).map_or_else(
            || self.refuse(self.code.names.no_cast(&value.ty(), ty, at)),
            Ok,
        )
    }

    #[inline(never)]
    fn checked(&mut self, of: &Node, ty: &Type, at: At) -> Eval {
        let value = self.eval(of)?;
        self.declared(value, ty, at)
    }

    #[inline(never)]
    fn called(&mut self, function: usize, nodes: &[Node], at: At) -> Eval {
        let start = self.push_all(nodes)?;
        self.enter(function, start, at)
    }

    #[inline(never)]
    fn applied_to(&mut self, function: &Node, nodes: &[Node], at: At) -> Eval {
        let function = self.eval(function)?;
        let mut arguments = self.all(nodes)?;
        self.apply(&function, &mut arguments, at)
    }

    #[inline(never)]
    fn made(&mut self, kind: u32, fields: &[(usize, Node)], base: Option<&Node>) -> Eval {
        let mut all = match base.map(|base| self.eval(base)).transpose()? {
            Some(Value::Own(_, fields)) => fields,
            Some(other) => unreachable!("it is declared, and this is {other:?}"),
            None => iter::repeat_n(Value::Unit, fields.len()).collect(),
        };
        for (n, node) in fields {
            let value = self.eval(node)?;
            Rc::make_mut(&mut all)[*n] = value;
        }
        Ok(Value::Own(kind, all))
    }

    #[inline(never)]
    fn range(&mut self, ends: &[Node; 2], is_closed: bool) -> Eval {
        let ends = [self.eval(&ends[0])?, self.eval(&ends[1])?];
        Ok(Value::Range(Rc::new(ends), is_closed))
    }

    #[inline(never)]
    fn formatted(&mut self, pieces: &[String], nodes: &[Node]) -> Eval {
        let values = self.all(nodes)?;
        let values = values.iter().map(|it| self.shown(it));
        let pieces = pieces.iter().zip(values.chain([String::new()]));
        let text: String = pieces
            .flat_map(|(before, value)| [before.clone(), value])
            .collect();
        Ok(Value::Str(Rc::new(text)))
    }

    #[inline(never)]
    fn choice(&mut self, nodes: &[Node; 3]) -> Eval {
        let n = if self.truth(&nodes[0])? { 1 } else { 2 };
        self.eval(&nodes[n])
    }

    #[inline(never)]
    fn matched(&mut self, of: &Node, arms: &[Arm], at: At) -> Eval {
        let value = self.eval(of)?;
        for arm in arms {
            let is_it = self.binds(&arm.pattern, &value)?;
            if is_it && arm.guard.as_ref().map_or(Ok(true), |it| self.truth(it))? {
                return self.eval(&arm.body);
            }
        }
        let message = "non-exhaustive patterns: no arm matches this value";
        self.refuse(Refusal::new(at, message, "", ""))
    }

    #[inline(never)]
    fn matches(&mut self, pattern: &Pattern, of: &Node) -> Eval {
        let value = self.eval(of)?;
        Ok(Value::Bool(self.binds(pattern, &value)?))
    }

    #[inline(never)]
    fn repeated(&mut self, nodes: &[Node; 2], at: At) -> Eval {
        loop {
            self.turn(at)?;
            if !self.truth(&nodes[0])? || self.is_left(&nodes[1])? {
                return Ok(mem::take(&mut self.left));
            }
        }
    }

    #[inline(never)]
    fn for_each(&mut self, pattern: &Pattern, nodes: &[Node; 2], at: At) -> Eval {
        let each = self.eval(&nodes[0])?;
        let mut each = self.iterator(&each, at)?;
        while let Some(value) = each.next() {
            self.turn(at)?;
            self.binds(pattern, &value)?;
            if self.is_left(&nodes[1])? {
                break;
            }
        }
        Ok(Value::Unit)
    }

    #[inline(never)]
    fn left_with(&mut self, value: &Node, stop: Stop) -> Eval {
        self.left = self.eval(value)?;
        Err(stop)
    }

    #[inline(never)]
    fn tried(&mut self, of: &Node) -> Eval {
        match self.eval(of)? {
            Value::Some(value) => Ok(Rc::unwrap_or_clone(value)),
            _ => {
                self.left = Value::None;
                Err(Stop::Return)
            }
        }
    }

    #[inline(never)]
    fn block(&mut self, nodes: &[Node], has_value: bool) -> Eval {
        let Some((last, before)) = nodes.split_last() else {
            return Ok(Value::Unit);
        };
        for node in before {
            self.eval(node)?;
        }
        let last = self.eval(last)?;
        Ok(if has_value { last } else { Value::Unit })
    }

    #[inline(never)]
    fn bound(&mut self, pattern: &Pattern, value: &Node, other: Option<&Node>) -> Eval {
        let value = self.operand(value)?;
        match pattern {
            Pattern::Bind(slot) => {
                if let Some(notes) = &mut self.notes {
                    notes.push((self.function, *slot, value.clone()));
                }
                let slot = self.base + slot;
                self.stack[slot] = value;
            }
            pattern => {
                if !self.binds(pattern, &value)?
                    && let Some(other) = other
                {
                    self.eval(other)?;
                }
            }
        }
        Ok(Value::Unit)
    }

    #[inline(never)]
    fn field(&mut self, of: &Node, n: usize) -> Eval {
        // Without a copy of the whole.
        let value = match of {
            Node::Local(slot) => &self.stack[self.base + slot],
            of => &self.eval(of)?,
        };
        match value {
            Value::Mut(address) => Ok(self.at(address).field(n)),
            value => Ok(value.field(n)),
        }
    }

    /// A result as floats have it here.
    #[inline]
    pub(crate) fn rounded(&self, it: f64) -> f64 {
        if self.code.is_single {
            f64::from(it as f32)
        } else {
            it
        }
    }

    #[inline]
    fn all_rounded(&self, it: DVec3) -> DVec3 {
        if self.code.is_single {
            DVec3::from_array(it.to_array().map(|it| f64::from(it as f32)))
        } else {
            it
        }
    }

    #[inline(never)]
    fn native(&mut self, native: &Native, nodes: &[Node], at: At) -> Eval {
        if !self.code.instead.is_empty() {
            return self.native_or_own(native, nodes, at);
        }
        match nodes {
            [one] => {
                let mut arguments = [self.operand(one)?];
                (native.run)(self, &mut arguments, at)
            }
            [one, other] => {
                let mut arguments = [self.operand(one)?, self.operand(other)?];
                (native.run)(self, &mut arguments, at)
            }
            nodes => {
                let mut arguments = self.all(nodes)?;
                (native.run)(self, &mut arguments, at)
            }
        }
    }

    /// A function of the library, or that of the text which takes its place.
    fn native_or_own(&mut self, native: &Native, nodes: &[Node], at: At) -> Eval {
        let mut arguments = self.all(nodes)?;
        let is_of_vectors = ["Vec3", "Ray"].contains(&native.owner);
        let mut instead = self.code.instead.iter().filter(|_| is_of_vectors);
        if let Some((_, own)) = instead.find(|it| it.0 == native.signature.name) {
            return self.run(*own, &arguments, at);
        }
        match (native.run)(self, &mut arguments, at)? {
            Value::Float(it) => Ok(Value::Float(self.rounded(it))),
            other => Ok(other),
        }
    }

    #[inline(never)]
    fn operation(&mut self, sign: Sign, nodes: &[Node; 2], at: At) -> Eval {
        use Value::{Float, Vec3};
        let left = self.operand(&nodes[0])?;
        let right = self.operand(&nodes[1])?;
        match (left, right) {
            (Float(a), Float(b)) => Ok(Float(self.rounded(of_floats(sign, a, b)))),
            (Vec3(a), Vec3(b)) => Ok(Vec3(self.all_rounded(of_vectors(sign, a, b)))),
            (left, right) => self.arithmetic(sign, left, right, at),
        }
    }

    #[inline(never)]
    fn comparison(&mut self, order: Order, nodes: &[Node; 2], at: At) -> Eval {
        let left = self.operand(&nodes[0])?;
        let right = self.operand(&nodes[1])?;
        if let (Value::Float(a), Value::Float(b)) = (&left, &right) {
            return Ok(Value::Bool(order.holds(a.partial_cmp(b))));
        }
        let [left, right] = [left, right].map(|it| self.followed(&it));
        let types = [&left.ty(), &right.ty()];
        if let Err(refusal) = self.code.names.comparable(order, types, at, at) {
            return self.refuse(refusal);
        }
        Ok(Value::Bool(match order {
            Order::Equal => left.equals(&right),
            Order::Unequal => !left.equals(&right),
            order => order.holds(left.compared(&right)),
        }))
    }

    /// Runs the body of a loop; whether it has left the loop.
    fn is_left(&mut self, body: &Node) -> Eval<bool> {
        self.left = Value::Unit;
        match self.eval(body) {
            Err(Stop::Break) => Ok(true),
            Err(Stop::Continue) | Ok(_) => Ok(false),
            Err(stop) => Err(stop),
        }
    }

    /// A value as text, as `{}` has it.
    fn shown(&self, value: &Value) -> String {
        match value {
            Value::Float(it) => it.to_string(),
            Value::Int(it, _) => it.to_string(),
            Value::Bool(it) => it.to_string(),
            Value::Str(it) => it.to_string(),
            Value::Mut(address) => self.shown(&self.at(address)),
            // Only the picture is looked at, and it has none of these.
            _ => "…".to_owned(),
        }
    }

    fn constant(&mut self, function: usize, at: At) -> Eval {
        if let Some(Some(known)) = self.constants.get(function) {
            return Ok(known.clone());
        }
        let value = self.run(function, &[], at)?;
        self.constants.resize(self.code.functions.len(), None);
        self.constants[function] = Some(value.clone());
        Ok(value)
    }

    /// The function that the kind of the first argument has for a trait.
    fn dispatch(&mut self, all: &[Option<usize>], nodes: &[Node], at: At) -> Eval {
        let start = self.push_all(nodes)?;
        let address = match &self.stack[start] {
            Value::Mut(_) => Some(mem::take(&mut self.stack[start])),
            _ => None,
        };
        if let Some(address) = &address {
            self.stack[start] = self.followed(address);
        }
        let function = match &self.stack[start] {
            Value::Own(kind, ..) => all[*kind as usize],
            _ => None,
        };
        let Some(function) = function else {
            let name = self.stack[start].ty().name(&self.code.names);
            return self.refuse(Refusal::unknown(at, &format!("this trait for `{name}`")));
        };
        if let Some(address) = address
            && self.code.names.functions[function].parameters[0].is(Head::RefMut)
        {
            self.stack[start] = address;
        }
        self.enter(function, start, at)
    }

    /// What gives the values of a list or a range, one after the other.
    pub(crate) fn iterator(&mut self, of: &Value, at: At) -> Eval<Iter> {
        Ok(match self.followed(of) {
            Value::Many(all) => Iter::List(all, 0),
            Value::Range(ends, is_closed) => match &*ends {
                [Value::Int(from, int), Value::Int(to, other)] => {
                    let int = int.joined(*other).unwrap_or(*int);
                    Iter::Range(*from, to + i128::from(is_closed), int)
                }
                _ => return self.no_iterator(of, at),
            },
            _ => return self.no_iterator(of, at),
        })
    }

    fn no_iterator<T>(&mut self, of: &Value, at: At) -> Eval<T> {
        let ty = self.followed(of).ty();
        self.refuse(self.code.names.no_iterator(&ty, at))
    }

    fn index(&mut self, list: &Value, index: &Value, at: At) -> Eval<usize> {
        let (length, index) = match (list, index) {
            (Value::Many(all), Value::Int(index, _)) => (all.len(), *index),
            (Value::Vec3(_), Value::Int(index, _)) => (3, *index),
            _ => {
                let name = list.ty().name(&self.code.names);
                let message = format!("cannot index into a value of type `{name}`");
                return self.refuse(Refusal::new(at, &message, "", ""));
            }
        };
        if (0..length as i128).contains(&index) {
            Ok(index as usize)
        } else {
            let message =
                format!("index out of bounds: the len is {length} but the index is {index}");
            self.panic(at, &message)
        }
    }

    fn address(&mut self, target: &Target) -> Eval<Address> {
        let mut address = match &target.root {
            // A variable may itself be a mutable reference.
            Root::Local(n) => match &self.stack[self.base + n] {
                Value::Mut(address) if !target.steps.is_empty() => address.clone(),
                _ => Address::of(self.base + n),
            },
            Root::Through(reference) => match self.eval(reference)? {
                Value::Mut(address) => address,
                other => {
                    let name = other.ty().name(&self.code.names);
                    let message = format!("type `{name}` cannot be changed through a reference");
                    return self.refuse(Refusal::new(At::default(), &message, "", ""));
                }
            },
        };
        address.steps.extend(&target.steps);
        Ok(address)
    }

    /// The value at the end of a mutable reference, or of several.
    pub(crate) fn followed(&self, value: &Value) -> Value {
        match value {
            Value::Mut(address) => self.followed(&self.at(address)),
            value => value.clone(),
        }
    }

    fn at(&self, address: &Address) -> Value {
        let root = &self.stack[address.slot];
        let mut steps = address.steps.iter();
        match steps.next() {
            None => root.clone(),
            Some(&first) => steps.fold(root.field(first), |value, &n| value.field(n)),
        }
    }

    /// Changes what is at an address.
    fn change<R>(&mut self, address: &Address, change: impl FnOnce(&mut Value) -> R) -> R {
        let mut change = Some(change);
        let mut result = None;
        self.stack[address.slot].reach(&address.steps, &mut |place| {
            result = change.take().map(|change| change(place));
        });
        result.expect("an address leads somewhere")
    }

    /// The same of a value that is a mutable reference.
    pub(crate) fn change_at<R>(
        &mut self,
        reference: &Value,
        change: impl FnOnce(&mut Value) -> R,
    ) -> R {
        match reference {
            Value::Mut(address) => match self.at(address) {
                inner @ Value::Mut(_) => self.change_at(&inner, change),
                _ => self.change(address, change),
            },
            other => unreachable!("types are checked, and {other:?} is no address"),
        }
    }

    /// Whether the value matches; if so, its parts have their names.
    fn binds(&mut self, pattern: &Pattern, value: &Value) -> Eval<bool> {
        match pattern {
            Pattern::Any => return Ok(true),
            Pattern::Bind(slot) => {
                let slot = self.base + slot;
                self.stack[slot] = value.clone();
                return Ok(true);
            }
            _ => {}
        }
        if let Value::Mut(_) = value {
            let value = self.followed(value);
            return self.binds(pattern, &value);
        }
        Ok(match (pattern, value) {
            (Pattern::None, value) => matches!(value, Value::None),
            (Pattern::Some(pattern), Value::Some(value)) => self.binds(pattern, value)?,
            (Pattern::Fields(fields), value) => self.all_bind(fields, |n| value.field(n))?,
            (Pattern::Many(patterns), Value::Many(values)) if patterns.len() == values.len() => {
                for (pattern, value) in patterns.iter().zip(values.iter()) {
                    if !self.binds(pattern, value)? {
                        return Ok(false);
                    }
                }
                true
            }
            _ => false,
        })
    }

    fn all_bind(
        &mut self,
        fields: &[(usize, Pattern)],
        part: impl Fn(usize) -> Value,
    ) -> Eval<bool> {
        for (n, pattern) in fields {
            if !self.binds(pattern, &part(*n))? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    #[inline(never)]
    pub(crate) fn arithmetic(&mut self, sign: Sign, left: Value, right: Value, at: At) -> Eval {
        use Value::{Float, Vec3};
        Ok(match (sign, left, right) {
            (sign, Vec3(a), Vec3(b)) => Vec3(self.all_rounded(of_vectors(sign, a, b))),
            (sign, Vec3(a), Float(b)) => {
                Vec3(self.all_rounded(of_vectors(sign, a, DVec3::splat(b))))
            }
            (sign, Float(a), Vec3(b)) => {
                Vec3(self.all_rounded(of_vectors(sign, DVec3::splat(a), b)))
            }
            (sign, Float(a), Float(b)) => Float(self.rounded(of_floats(sign, a, b))),
            (Sign::Plus, Value::Str(a), Value::Str(b)) => Value::Str(Rc::new(format!("{a}{b}"))),
            (sign, Value::Int(a, one), Value::Int(b, other)) => {
                let Some(int) = one.joined(other) else {
                    let values = [Value::Int(a, one), Value::Int(b, other)];
                    return self.no_operator(sign, values, at);
                };
                Value::Int(self.integer(sign, int, a, b, at)?, int)
            }
            (sign, left, right) => return self.other_arithmetic(sign, left, right, at),
        })
    }

    /// By an operator of the reader's, or of what references lead to.
    fn other_arithmetic(&mut self, sign: Sign, left: Value, right: Value, at: At) -> Eval {
        if let (Value::Mut(_), _) | (_, Value::Mut(_)) = (&left, &right) {
            let [left, right] = [left, right].map(|it| self.followed(&it));
            return self.arithmetic(sign, left, right, at);
        }
        let types = [&left.ty(), &right.ty()];
        match self.code.names.operator(sign, types) {
            Some(own) => self.run(own, &[left, right], at),
            None => self.no_operator(sign, [left, right], at),
        }
    }

    fn no_operator(&mut self, sign: Sign, values: [Value; 2], at: At) -> Eval {
        let types = values.map(|it| it.ty());
        self.refuse(
            self.code
                .names
                .no_operator(sign, [&types[0], &types[1]], at),
        )
    }

    fn integer(&mut self, sign: Sign, int: Int, a: i128, b: i128, at: At) -> Eval<i128> {
        let result = match sign {
            Sign::Over if b == 0 => return self.panic(at, "attempt to divide by zero"),
            Sign::Plus => a + b,
            Sign::Minus => a - b,
            Sign::Times => a.saturating_mul(b),
            Sign::Over => a / b,
        };
        if int.fits(result) {
            Ok(result)
        } else {
            self.panic(at, &sign.overflow())
        }
    }

    /// What `Default` gives for the type.
    pub(crate) fn default(&mut self, ty: &Type) -> Eval {
        let code = self.code;
        Ok(match ty.0 {
            Head::Bool => Value::Bool(false),
            Head::F64 => Value::Float(0.0),
            Head::Int(int) => Value::Int(0, int),
            Head::Vec3 => Value::Vec3(DVec3::ZERO),
            Head::Str => Value::Str(Rc::default()),
            Head::Option => Value::None,
            Head::Vec => Value::Many(Rc::default()),
            Head::Box => self.default(&ty.1[0])?,
            Head::Tuple if ty.1.is_empty() => Value::Unit,
            Head::Own(kind) => match code.names.method(ty, "default", None) {
                Some(own) => self.run(own, &[], At::default())?,
                None => {
                    let fields = code.names.kinds[kind].fields.iter();
                    let fields = fields.map(|it| self.default(&it.ty)).collect::<Eval<_>>()?;
                    Value::Own(kind as u32, fields)
                }
            },
            _ => {
                let message = format!(
                    "this page does not know a default for `{}`",
                    ty.name(&code.names)
                );
                return self.refuse(Refusal::new(At::default(), &message, "", "cargo does"));
            }
        })
    }
}

fn of_floats(sign: Sign, a: f64, b: f64) -> f64 {
    match sign {
        Sign::Plus => a + b,
        Sign::Minus => a - b,
        Sign::Times => a * b,
        Sign::Over => a / b,
    }
}

fn of_vectors(sign: Sign, a: DVec3, b: DVec3) -> DVec3 {
    match sign {
        Sign::Plus => a + b,
        Sign::Minus => a - b,
        Sign::Times => a * b,
        Sign::Over => a / b,
    }
}
