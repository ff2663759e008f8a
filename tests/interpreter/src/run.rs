//! A tree-walking interpreter: each node is what it says, in the arithmetic of the compiled
//! chapters.
//!
//! A shared reference is the value itself, since nothing changes while it lives. A mutable
//! one is an address: a slot of the stack and the way from there to a part.

use std::cell::{Cell, RefCell};
use std::cmp::Ordering;
use std::iter;
use std::mem;
use std::rc::Rc;
use std::sync::Arc;

use common::rtweekend::{Camera, Ray, Vec3};

use crate::node::{Arithmetic, Function, Node, Order, Pattern, Root, Sign, Step, Target, TypeId};
use crate::prelude;
use crate::types::{Head, Type};
use crate::{Fault, Place};

/// What runs.
#[derive(Debug, Default)]
pub(crate) struct Code {
    pub(crate) functions: Vec<Function>,
    pub(crate) closures: Vec<Closure>,
    /// For each kind of the reader's, its methods by name.
    pub(crate) methods: Vec<Vec<(String, usize)>>,
    /// The types that some nodes need, and for each kind the types of its fields.
    pub(crate) types: Vec<Type>,
    pub(crate) fields: Vec<Vec<Type>>,
    /// What a kind's own `default` is, if it has one.
    pub(crate) defaults: Vec<Option<usize>>,
}

/// The parameters of a closure, and its body.
#[derive(Debug)]
pub(crate) struct Closure {
    pub(crate) parameters: Vec<Pattern>,
    pub(crate) body: Node,
    pub(crate) slots: usize,
}

#[derive(Clone, Debug, Default)]
pub(crate) enum Value {
    #[default]
    Unit,
    Bool(bool),
    Int(i128),
    Float(f64),
    Vec3(Vec3),
    Ray(Rc<Ray>),
    Camera(Rc<Camera>),
    /// Width, height, and three bytes a pixel.
    Picture(Rc<(u32, u32, Vec<u8>)>),
    Ordering(Ordering),
    None,
    Some(Rc<Value>),
    /// The number of a variant of one of the reader's kinds, and its fields.
    Own(u32, u32, Rc<Vec<Value>>),
    /// A list, an array or a tuple.
    Many(Rc<Vec<Value>>),
    Range(Rc<[Value; 2]>, bool),
    Iterator(Iter),
    Mut(Rc<Address>),
    /// A closure, and the frame that it looks at or has taken along.
    Closure(usize, Rc<Frame>),
    Function(usize),
    Native(usize, Rc<Place>),
    /// Is never hit, and keeps the range that it was asked for.
    Nothing(Rc<Cell<Option<[f64; 2]>>>),
}

#[derive(Clone, Debug)]
pub(crate) struct Address {
    slot: usize,
    path: Vec<usize>,
}

#[derive(Debug)]
pub(crate) enum Frame {
    At(usize),
    Taken(Vec<Value>),
}

type Next = dyn FnMut(&mut Machine) -> Eval<Option<Value>>;

/// What gives one value after the other.
#[derive(Clone)]
pub(crate) struct Iter(Rc<RefCell<Box<Next>>>);

impl std::fmt::Debug for Iter {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Iter")
    }
}

impl Iter {
    pub(crate) fn giving(next: impl FnMut(&mut Machine) -> Eval<Option<Value>> + 'static) -> Value {
        Value::Iterator(Self(Rc::new(RefCell::new(Box::new(next)))))
    }

    pub(crate) fn next(&self, machine: &mut Machine) -> Eval<Option<Value>> {
        (self.0.borrow_mut())(machine)
    }
}

/// Why what follows is not run.
#[derive(Debug)]
pub(crate) enum Stop {
    Return(Value),
    Break(usize, Value),
    Continue(usize),
    Fault(Box<Fault>),
}

pub(crate) type Eval<T = Value> = Result<T, Stop>;

/// The text has stopped by itself.
pub(crate) fn panic<T>(at: &Place, message: &str) -> Eval<T> {
    let fault = Fault::at(Some(at.clone()), message, "the program stops here", "");
    Err(Stop::Fault(Box::new(fault)))
}

/// So many turns of loops and calls are no pixel's: a loop has no end.
const TURNS: u32 = 200_000;
/// So deep is no call in a chapter.
const DEEPEST: u32 = 60;

/// Pixels, each with the levels that it should have.
pub type Sample = [(u32, [u8; 3])];

/// What runs a program: the values of all functions that are being called.
pub(crate) struct Machine {
    pub(crate) code: Arc<Code>,
    stack: Vec<Value>,
    base: usize,
    depth: u32,
    turns: u32,
    pub(crate) sample: Option<Rc<Sample>>,
    pub(crate) matched: usize,
    has_f32: bool,
}

/// What only another type could have, of which the checker has made sure.
macro_rules! taken {
    ($name:ident, $variant:ident, $ty:ty) => {
        pub(crate) fn $name(&self) -> $ty {
            match self {
                Self::$variant(it) => it.clone(),
                other => unreachable!("types are checked, and this is {other:?}"),
            }
        }
    };
}

impl Value {
    taken!(float, Float, f64);
    taken!(int, Int, i128);
    taken!(truth, Bool, bool);
    taken!(vec3, Vec3, Vec3);
    taken!(ray, Ray, Rc<Ray>);
    taken!(camera, Camera, Rc<Camera>);
    taken!(many, Many, Rc<Vec<Value>>);
    taken!(ordering, Ordering, Ordering);
    taken!(iterator, Iterator, Iter);

    pub(crate) fn option(&self) -> Option<Self> {
        match self {
            Self::Some(it) => Some(Self::clone(it)),
            _ => None,
        }
    }

    pub(crate) fn of(option: Option<Self>) -> Self {
        option.map_or(Self::None, |it| Self::Some(Rc::new(it)))
    }

    pub(crate) fn field(&self, n: usize) -> Self {
        match self {
            Self::Own(_, _, fields) | Self::Many(fields) => fields[n].clone(),
            Self::Vec3(vector) => Self::Float(vector[n]),
            Self::Ray(ray) => Self::Vec3([ray.origin, ray.direction][n]),
            Self::Camera(it) => match n {
                0 => Self::Int(it.image_width.into()),
                1 => Self::Int(it.image_height.into()),
                _ => Self::Vec3([it.center, it.pixel00, it.pixel_delta_u, it.pixel_delta_v][n - 2]),
            },
            other => unreachable!("types are checked, and {other:?} has no fields"),
        }
    }

    /// Whether they are equal, as `derive(PartialEq)` has it.
    pub(crate) fn equals(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Float(one), Self::Float(other)) => one == other,
            (Self::Int(one), Self::Int(other)) => one == other,
            (Self::Bool(one), Self::Bool(other)) => one == other,
            (Self::Vec3(one), Self::Vec3(other)) => one == other,
            (Self::Ray(one), Self::Ray(other)) => one == other,
            (Self::Ordering(one), Self::Ordering(other)) => one == other,
            (Self::None, Self::None) | (Self::Unit, Self::Unit) => true,
            (Self::Some(one), Self::Some(other)) => one.equals(other),
            (Self::Own(_, tag, fields), Self::Own(_, other, others)) => {
                tag == other && all_equal(fields, others)
            }
            (Self::Many(fields), Self::Many(others)) => all_equal(fields, others),
            _ => false,
        }
    }

    /// How numbers are ordered, unless one is none.
    pub(crate) fn compared(&self, other: &Self) -> Option<Ordering> {
        match (self, other) {
            (Self::Float(one), Self::Float(other)) => one.partial_cmp(other),
            (Self::Int(one), Self::Int(other)) => one.partial_cmp(other),
            (Self::Bool(one), Self::Bool(other)) => one.partial_cmp(other),
            _ => None,
        }
    }
}

fn all_equal(one: &[Value], other: &[Value]) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.equals(other))
}

impl Machine {
    pub(crate) fn new(code: &Arc<Code>) -> Self {
        Self {
            code: Arc::clone(code),
            stack: Vec::new(),
            base: 0,
            depth: 0,
            turns: TURNS,
            sample: None,
            matched: 0,
            has_f32: code.types.iter().any(|it| it.is(Head::F32)),
        }
    }

    /// Another pixel, which may take as long as the one before.
    pub(crate) fn begin(&mut self) {
        self.turns = TURNS;
    }

    fn turn(&mut self, at: impl FnOnce() -> Option<Place>) -> Eval<()> {
        self.turns = self.turns.saturating_sub(1);
        if self.turns > 0 {
            return Ok(());
        }
        let message = format!("a loop without end: after {TURNS} turns it was still going");
        let help = "what ends it never comes true";
        Err(Stop::Fault(Box::new(Fault::at(at(), &message, "", help))))
    }

    /// Calls a function; what stops it is a fault.
    pub(crate) fn call(&mut self, function: usize, arguments: &[Value]) -> Result<Value, Fault> {
        self.run(function, arguments).map_err(|stop| match stop {
            Stop::Fault(fault) => *fault,
            _ => unreachable!("loops and functions catch what leaves them"),
        })
    }

    /// A list of the reader's with no more than its default fields.
    pub(crate) fn default_of(&mut self, kind: u32) -> Value {
        let ty = Type::plain(Head::Own(kind as usize));
        self.default(&ty).unwrap_or_default()
    }

    /// What becomes of a value of which a method takes each of these, one after the other.
    pub(crate) fn filled(
        &mut self,
        add: usize,
        value: Value,
        with: Vec<Value>,
    ) -> Result<Value, Fault> {
        self.stack.push(value);
        let slot = self.stack.len() - 1;
        for one in with {
            let place = Value::Mut(Rc::new(Address {
                slot,
                path: Vec::new(),
            }));
            self.call(add, &[place, one])?;
        }
        Ok(self.stack.pop().unwrap_or_default())
    }

    fn run(&mut self, function: usize, arguments: &[Value]) -> Eval {
        let code = Arc::clone(&self.code);
        let function = &code.functions[function];
        let frame = iter::repeat_n(Value::Unit, function.slots);
        self.enter(&function.parameters, &function.body, arguments, frame)
    }

    /// Runs a body in a frame of its own.
    fn enter(
        &mut self,
        parameters: &[Pattern],
        body: &Node,
        arguments: &[Value],
        frame: impl Iterator<Item = Value>,
    ) -> Eval {
        if self.depth == DEEPEST {
            let message = format!("a function calls itself without end: {DEEPEST} calls are open");
            return Err(Stop::Fault(Box::new(Fault::at(None, &message, "", ""))));
        }
        self.turn(|| None)?;
        let base = mem::replace(&mut self.base, self.stack.len());
        self.stack.extend(frame);
        self.depth += 1;
        let result = self
            .bind_all(parameters, arguments)
            .and_then(|()| self.eval(body));
        self.depth -= 1;
        self.stack.truncate(self.base);
        self.base = base;
        match result {
            Err(Stop::Return(value)) => Ok(value),
            result => result,
        }
    }

    fn bind_all(&mut self, parameters: &[Pattern], arguments: &[Value]) -> Eval<()> {
        for (pattern, value) in parameters.iter().zip(arguments) {
            self.binds(pattern, value)?;
        }
        Ok(())
    }

    /// Calls a value that is a function.
    pub(crate) fn apply(&mut self, function: &Value, arguments: &mut [Value]) -> Eval {
        match function {
            Value::Function(function) => self.run(*function, arguments),
            Value::Native(native, at) => prelude::run(*native, self, arguments, at),
            Value::Closure(closure, frame) => {
                let code = Arc::clone(&self.code);
                let closure = &code.closures[*closure];
                match &**frame {
                    Frame::Taken(frame) => {
                        let rest = iter::repeat_n(Value::Unit, closure.slots - frame.len());
                        let frame = frame.iter().cloned().chain(rest);
                        self.enter(&closure.parameters, &closure.body, arguments, frame)
                    }
                    // The function that made it is over, so it uses nothing of its.
                    Frame::At(base) if *base > self.base => {
                        let frame = iter::repeat_n(Value::Unit, closure.slots);
                        self.enter(&closure.parameters, &closure.body, arguments, frame)
                    }
                    Frame::At(base) => {
                        self.turn(|| None)?;
                        let base = mem::replace(&mut self.base, *base);
                        let bound = self.bind_all(&closure.parameters, arguments);
                        let result = bound.and_then(|()| self.eval(&closure.body));
                        self.base = base;
                        match result {
                            Err(Stop::Return(value)) => Ok(value),
                            result => result,
                        }
                    }
                }
            }
            other => unreachable!("types are checked, and {other:?} is no function"),
        }
    }

    fn is(&self, ty: TypeId, head: Head) -> bool {
        self.code.types[ty].is(head)
    }

    fn boxed(&mut self, nodes: &[Node; 2]) -> Eval<[Value; 2]> {
        Ok([self.eval(&nodes[0])?, self.eval(&nodes[1])?])
    }

    fn all(&mut self, nodes: &[Node]) -> Eval<Vec<Value>> {
        nodes.iter().map(|node| self.eval(node)).collect()
    }

    /// What most nodes are, each with its result where it belongs.
    pub(crate) fn eval(&mut self, node: &Node) -> Eval {
        match node {
            Node::Local(slot) => Ok(self.stack[self.base + slot].clone()),
            Node::Float(it) => Ok(Value::Float(*it)),
            Node::Field(of, n) => match &**of {
                Node::Local(slot) => Ok(self.stack[self.base + slot].field(*n)),
                of => Ok(self.eval(of)?.field(*n)),
            },
            Node::Arithmetic(how, nodes) => self.operation(how, nodes),
            Node::Compare(order, nodes) => self.comparison(*order, nodes),
            Node::And(nodes) => match self.eval(&nodes[0])?.truth() {
                true => self.eval(&nodes[1]),
                false => Ok(Value::Bool(false)),
            },
            Node::Or(nodes) => match self.eval(&nodes[0])?.truth() {
                false => self.eval(&nodes[1]),
                true => Ok(Value::Bool(true)),
            },
            Node::If(condition, then, other) => match self.eval(condition)?.truth() {
                true => self.eval(then),
                false => self.eval(other),
            },
            Node::Block(nodes, true) if !nodes.is_empty() => {
                let (last, before) = nodes.split_last().expect("not empty");
                for node in before {
                    self.eval(node)?;
                }
                self.eval(last)
            }
            Node::Let(pattern, value, None) => self.bound(pattern, value),
            Node::Call(function, nodes) if nodes.len() <= 4 => {
                let mut arguments: [Value; 4] = Default::default();
                for (argument, node) in arguments.iter_mut().zip(nodes) {
                    *argument = self.eval(node)?;
                }
                self.run(*function, &arguments[..nodes.len()])
            }
            Node::Dispatch(of, name, nodes) if nodes.len() <= 4 => {
                let mut arguments: [Value; 4] = Default::default();
                for (argument, node) in arguments.iter_mut().zip(nodes) {
                    *argument = self.eval(node)?;
                }
                self.dispatch(*of, name, &mut arguments[..nodes.len()])
            }
            Node::Deref(of) => {
                let reference = self.eval(of)?;
                Ok(self.followed(&reference))
            }
            Node::Native(native, nodes, ty, at) => self.native(*native, nodes, *ty, at),
            node => self.eval_rest(node),
        }
    }

    #[inline(never)]
    fn bound(&mut self, pattern: &Pattern, value: &Node) -> Eval {
        let value = self.eval(value)?;
        match pattern {
            Pattern::Bind(slot, inner) if matches!(**inner, Pattern::Any) => {
                let slot = self.base + slot;
                self.stack[slot] = value;
            }
            pattern => drop(self.binds(pattern, &value)?),
        }
        Ok(Value::Unit)
    }

    #[inline(never)]
    fn native(&mut self, native: usize, nodes: &[Node], ty: TypeId, at: &Place) -> Eval {
        let mut arguments: [Value; 4] = Default::default();
        for (argument, node) in arguments.iter_mut().zip(nodes) {
            *argument = self.eval(node)?;
        }
        let value = prelude::run(native, self, &mut arguments[..nodes.len()], at)?;
        match value {
            Value::Float(it) if self.has_f32 && self.is(ty, Head::F32) => {
                Ok(Value::Float(f64::from(it as f32)))
            }
            value => Ok(value),
        }
    }

    #[inline(never)]
    fn operation(&mut self, how: &Arithmetic, nodes: &[Node; 2]) -> Eval {
        let left = self.eval(&nodes[0])?;
        let right = self.eval(&nodes[1])?;
        match (&left, &right) {
            (Value::Float(a), Value::Float(b)) if !self.has_f32 => match how.sign {
                Sign::Plus => return Ok(Value::Float(a + b)),
                Sign::Minus => return Ok(Value::Float(a - b)),
                Sign::Times => return Ok(Value::Float(a * b)),
                Sign::Over => return Ok(Value::Float(a / b)),
                _ => {}
            },
            _ => {}
        }
        self.arithmetic(how, left, right)
    }

    #[inline(never)]
    fn comparison(&mut self, order: Order, nodes: &[Node; 2]) -> Eval {
        let left = self.eval(&nodes[0])?;
        let right = self.eval(&nodes[1])?;
        if let (Value::Float(a), Value::Float(b)) = (&left, &right) {
            return Ok(Value::Bool(match order {
                Order::Equal => a == b,
                Order::Unequal => a != b,
                Order::Less => a < b,
                Order::AtMost => a <= b,
                Order::More => a > b,
                Order::AtLeast => a >= b,
            }));
        }
        Ok(Value::Bool(match order {
            Order::Equal => left.equals(&right),
            Order::Unequal => !left.equals(&right),
            order => left.compared(&right).is_some_and(|it| match order {
                Order::Less => it.is_lt(),
                Order::AtMost => it.is_le(),
                Order::More => it.is_gt(),
                _ => it.is_ge(),
            }),
        }))
    }

    #[inline(never)]
    fn eval_rest(&mut self, node: &Node) -> Eval {
        Ok(match node {
            Node::Unit => Value::Unit,
            Node::Bool(it) => Value::Bool(*it),
            Node::Int(it) => Value::Int(*it),
            Node::Float(it) => Value::Float(*it),
            Node::Vec3(it) => Value::Vec3(*it),
            Node::None => Value::None,
            Node::Ordering(it) => Value::Ordering(*it),
            Node::Local(slot) => self.stack[self.base + slot].clone(),
            Node::Deref(of) => {
                let reference = self.eval(of)?;
                self.followed(&reference)
            }
            Node::Field(of, n) => match (&**of, *n) {
                // Without a copy of the whole.
                (Node::Local(slot), n) => self.stack[self.base + slot].field(n),
                (of, n) => self.eval(of)?.field(n),
            },
            Node::Index(of, index, at) => {
                let list = self.eval(of)?;
                let index = self.eval(index)?.int();
                match list {
                    Value::Vec3(vector) if (0..3).contains(&index) => {
                        Value::Float(vector[index as usize])
                    }
                    Value::Many(all) if (0..all.len() as i128).contains(&index) => {
                        all[index as usize].clone()
                    }
                    Value::Many(all) => return out_of_bounds(at, all.len(), index),
                    _ => return out_of_bounds(at, 3, index),
                }
            }
            Node::Address(target) => Value::Mut(Rc::new(self.address(target)?)),
            Node::Set(target, value) => {
                let value = self.eval(value)?;
                match &**target {
                    Target {
                        root: Root::Local(slot),
                        steps,
                    } if steps.is_empty() => {
                        let slot = self.base + slot;
                        self.stack[slot] = value;
                    }
                    target => {
                        let address = self.address(target)?;
                        self.change(&address, |place| *place = value);
                    }
                }
                Value::Unit
            }
            Node::Update(target, arithmetic, value) => {
                let right = self.eval(value)?;
                let address = self.address(target)?;
                let left = self.at(&address);
                let value = self.arithmetic(arithmetic, left, right)?;
                self.change(&address, |place| *place = value);
                Value::Unit
            }
            Node::Let(pattern, value, other) => {
                let value = self.eval(value)?;
                if !self.binds(pattern, &value)?
                    && let Some(other) = other
                {
                    self.eval(other)?;
                }
                Value::Unit
            }
            Node::Arithmetic(how, nodes) => {
                let [left, right] = self.boxed(nodes)?;
                self.arithmetic(how, left, right)?
            }
            Node::Compare(order, nodes) => {
                let [left, right] = self.boxed(nodes)?;
                Value::Bool(match order {
                    Order::Equal => left.equals(&right),
                    Order::Unequal => !left.equals(&right),
                    order => left.compared(&right).is_some_and(|it| match order {
                        Order::Less => it.is_lt(),
                        Order::AtMost => it.is_le(),
                        Order::More => it.is_gt(),
                        _ => it.is_ge(),
                    }),
                })
            }
            Node::And(nodes) => {
                Value::Bool(self.eval(&nodes[0])?.truth() && self.eval(&nodes[1])?.truth())
            }
            Node::Or(nodes) => {
                Value::Bool(self.eval(&nodes[0])?.truth() || self.eval(&nodes[1])?.truth())
            }
            Node::Not(of, ty) => match (self.eval(of)?, self.code.types[*ty].head()) {
                (Value::Int(it), Some(Head::Int(int))) => Value::Int(int.wrapped(!it)),
                (it, _) => Value::Bool(!it.truth()),
            },
            Node::Negate(of, ty, at) => match self.eval(of)? {
                Value::Float(it) => Value::Float(-it),
                Value::Vec3(it) => Value::Vec3(-it),
                it => match self.code.types[*ty].head() {
                    Some(Head::Int(int)) if int.fits(-it.int()) => Value::Int(-it.int()),
                    _ => return panic(at, "attempt to negate with overflow"),
                },
            },
            Node::Cast(of, ty) => {
                let value = self.eval(of)?;
                cast(&value, &self.code.types[*ty])
            }
            Node::Default(ty) => {
                let ty = self.code.types[*ty].clone();
                self.default(&ty)?
            }
            Node::Call(function, arguments) => {
                let arguments = self.all(arguments)?;
                self.run(*function, &arguments)?
            }
            Node::Dispatch(of, name, arguments) => {
                let mut arguments = self.all(arguments)?;
                self.dispatch(*of, name, &mut arguments)?
            }
            Node::Native(native, nodes, ty, at) => {
                let mut arguments: [Value; 4] = Default::default();
                for (argument, node) in arguments.iter_mut().zip(nodes) {
                    *argument = self.eval(node)?;
                }
                let value = prelude::run(*native, self, &mut arguments[..nodes.len()], at)?;
                match value {
                    Value::Float(it) if self.is(*ty, Head::F32) => {
                        Value::Float(f64::from(it as f32))
                    }
                    value => value,
                }
            }
            Node::CallValue(function, arguments) => {
                let function = self.eval(function)?;
                let mut arguments = self.all(arguments)?;
                self.apply(&function, &mut arguments)?
            }
            Node::Closure(closure, is_moved) => {
                let frame = match is_moved {
                    true => Frame::Taken(self.stack[self.base..].to_vec()),
                    false => Frame::At(self.base),
                };
                Value::Closure(*closure, Rc::new(frame))
            }
            Node::Function(function) => Value::Function(*function),
            Node::NativeFunction(native, at) => Value::Native(*native, Rc::new((**at).clone())),
            Node::New(kind, variant, fields, base) => {
                let mut all = match base {
                    Some(base) => match self.eval(base)? {
                        Value::Own(_, _, fields) => Rc::unwrap_or_clone(fields),
                        other => unreachable!("types are checked, and this is {other:?}"),
                    },
                    None => vec![Value::Unit; fields.len()],
                };
                for (n, node) in fields {
                    all[*n] = self.eval(node)?;
                }
                Value::Own(*kind as u32, *variant as u32, Rc::new(all))
            }
            Node::Some(of) => Value::Some(Rc::new(self.eval(of)?)),
            Node::Many(nodes) => Value::Many(Rc::new(self.all(nodes)?)),
            Node::Repeat(node, length) => Value::Many(Rc::new(vec![self.eval(node)?; *length])),
            Node::Range(from, to, is_closed) => {
                let mut end = |node: &Option<Box<Node>>| match node {
                    Some(node) => self.eval(node),
                    None => Ok(Value::Unit),
                };
                Value::Range(Rc::new([end(from)?, end(to)?]), *is_closed)
            }
            Node::If(condition, then, other) => match self.eval(condition)?.truth() {
                true => self.eval(then)?,
                false => self.eval(other)?,
            },
            Node::Match(of, arms, at) => {
                let value = self.eval(of)?;
                for arm in arms {
                    if self.binds(&arm.pattern, &value)?
                        && match &arm.guard {
                            Some(guard) => self.eval(guard)?.truth(),
                            None => true,
                        }
                    {
                        return self.eval(&arm.body);
                    }
                }
                return panic(
                    at,
                    "no arm matches this value: rustc would refuse the match",
                );
            }
            Node::Matches(pattern, of) => {
                let value = self.eval(of)?;
                Value::Bool(self.binds(pattern, &value)?)
            }
            Node::While(condition, body, label, at) => loop {
                self.turn(|| Some((**at).clone()))?;
                if !self.eval(condition)?.truth() {
                    break Value::Unit;
                }
                match self.eval(body) {
                    Err(Stop::Break(to, value)) if to == *label => break value,
                    Err(Stop::Continue(to)) if to == *label => {}
                    result => drop(result?),
                }
            },
            Node::For(pattern, of, body, label, at) => {
                let each = self.eval(of)?;
                let each = prelude::iterator(&each);
                while let Some(value) = each.next(self)? {
                    self.turn(|| Some((**at).clone()))?;
                    self.binds(pattern, &value)?;
                    match self.eval(body) {
                        Err(Stop::Break(to, _)) if to == *label => break,
                        Err(Stop::Continue(to)) if to == *label => {}
                        result => drop(result?),
                    }
                }
                Value::Unit
            }
            Node::Labeled(body, label) => match self.eval(body) {
                Err(Stop::Break(to, value)) if to == *label => value,
                result => result?,
            },
            Node::Break(label, value) => return Err(Stop::Break(*label, self.eval(value)?)),
            Node::Continue(label) => return Err(Stop::Continue(*label)),
            Node::Return(value) => return Err(Stop::Return(self.eval(value)?)),
            Node::Try(of) => match self.eval(of)? {
                Value::Some(value) => Rc::unwrap_or_clone(value),
                _ => return Err(Stop::Return(Value::None)),
            },
            Node::Block(nodes, has_value) => {
                let mut last = Value::Unit;
                for node in nodes {
                    last = self.eval(node)?;
                }
                match has_value {
                    true => last,
                    false => Value::Unit,
                }
            }
            Node::Panic(message, at) => return panic(at, message),
        })
    }

    /// The method of the value's own kind, or of its trait.
    fn dispatch(&mut self, by_trait: usize, name: &str, arguments: &mut [Value]) -> Eval {
        let receiver = match &arguments[0] {
            reference @ Value::Mut(_) => self.followed(reference),
            value => value.clone(),
        };
        match receiver {
            Value::Own(kind, _, _) => {
                let mut methods = self.code.methods[kind as usize].iter();
                let method = methods
                    .find(|(own, _)| own == name)
                    .map_or(by_trait, |it| it.1);
                self.run(method, arguments)
            }
            Value::Nothing(asked) => {
                asked.set(Some([arguments[2].float(), arguments[3].float()]));
                Ok(Value::None)
            }
            other => unreachable!("types are checked, and this is {other:?}"),
        }
    }

    fn address(&mut self, target: &Target) -> Eval<Address> {
        let mut address = match &target.root {
            Root::Local(slot) => Address {
                slot: self.base + slot,
                path: Vec::new(),
            },
            Root::Through(reference) => match self.eval(reference)? {
                Value::Mut(address) => Rc::unwrap_or_clone(address),
                other => unreachable!("types are checked, and {other:?} is no address"),
            },
            Root::Temporary(slot, value) => {
                let slot = self.base + slot;
                self.stack[slot] = self.eval(value)?;
                Address {
                    slot,
                    path: Vec::new(),
                }
            }
        };
        for step in &target.steps {
            match step {
                Step::Field(n) => address.path.push(*n),
                Step::Index(index, at) => {
                    let index = self.eval(index)?.int();
                    let length = match self.at(&address) {
                        Value::Many(all) => all.len(),
                        _ => 3,
                    };
                    if !(0..length as i128).contains(&index) {
                        return out_of_bounds(at, length, index);
                    }
                    address.path.push(index as usize);
                }
            }
        }
        Ok(address)
    }

    /// The value at the end of a mutable reference, or of several.
    pub(crate) fn followed(&self, value: &Value) -> Value {
        match value {
            Value::Mut(address) => self.at(address),
            value => value.clone(),
        }
    }

    fn at(&self, address: &Address) -> Value {
        let root = self.stack[address.slot].clone();
        address.path.iter().fold(root, |value, &n| match value {
            Value::Some(it) => Value::clone(&it),
            value => value.field(n),
        })
    }

    /// Changes what is at an address, or at the end of a reference that is there.
    pub(crate) fn change<R>(
        &mut self,
        address: &Address,
        change: impl FnOnce(&mut Value) -> R,
    ) -> R {
        let mut change = Some(change);
        let mut result = None;
        reach(&mut self.stack[address.slot], &address.path, &mut |place| {
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
            Value::Mut(address) => self.change(&Rc::clone(address), change),
            other => unreachable!("types are checked, and {other:?} is no address"),
        }
    }

    /// References to each value of the list that is there.
    pub(crate) fn each_at(&self, reference: &Value) -> Vec<Value> {
        let (Value::Mut(address), Value::Many(all)) = (reference, self.followed(reference)) else {
            unreachable!("types are checked");
        };
        let one = |n| {
            let path = [&address.path[..], &[n]].concat();
            Value::Mut(Rc::new(Address {
                slot: address.slot,
                path,
            }))
        };
        (0..all.len()).map(one).collect()
    }

    /// Whether the value matches; if so, its parts have their names.
    fn binds(&mut self, pattern: &Pattern, value: &Value) -> Eval<bool> {
        Ok(match (pattern, value) {
            (Pattern::Any, _) => true,
            (Pattern::Bind(slot, pattern), _) => {
                let slot = self.base + slot;
                self.stack[slot] = value.clone();
                self.binds(pattern, value)?
            }
            (Pattern::Literal(literal), _) => self.eval(literal)?.equals(value),
            (Pattern::Range(from, to, is_closed), _) => {
                let is_after = match from {
                    Some(from) => value
                        .compared(&self.eval(from)?)
                        .is_some_and(Ordering::is_ge),
                    None => true,
                };
                is_after
                    && match to {
                        Some(to) => value
                            .compared(&self.eval(to)?)
                            .is_some_and(|it| it.is_lt() || *is_closed && it.is_eq()),
                        None => true,
                    }
            }
            (Pattern::None, value) => matches!(value, Value::None),
            (Pattern::Some(pattern), Value::Some(value)) => self.binds(pattern, value)?,
            (Pattern::Variant(variant, fields), Value::Own(_, own, values))
                if *variant == *own as usize =>
            {
                for (n, pattern) in fields {
                    if !self.binds(pattern, &values[*n])? {
                        return Ok(false);
                    }
                }
                true
            }
            (Pattern::Fields(fields), value) => {
                for (n, pattern) in fields {
                    if !self.binds(pattern, &value.field(*n))? {
                        return Ok(false);
                    }
                }
                true
            }
            (Pattern::Many(patterns), Value::Many(values)) if patterns.len() == values.len() => {
                for (pattern, value) in patterns.iter().zip(values.iter()) {
                    if !self.binds(pattern, value)? {
                        return Ok(false);
                    }
                }
                true
            }
            (Pattern::Or(all), value) => {
                for pattern in all {
                    if self.binds(pattern, value)? {
                        return Ok(true);
                    }
                }
                false
            }
            _ => false,
        })
    }

    fn arithmetic(&self, how: &Arithmetic, left: Value, right: Value) -> Eval {
        use Value::{Float, Int, Vec3};
        let float = |value: f64| match self.is(how.ty, Head::F32) {
            true => Float(f64::from(value as f32)),
            false => Float(value),
        };
        Ok(match (how.sign, left, right) {
            (Sign::Plus, Float(a), Float(b)) => float(a + b),
            (Sign::Minus, Float(a), Float(b)) => float(a - b),
            (Sign::Times, Float(a), Float(b)) => float(a * b),
            (Sign::Over, Float(a), Float(b)) => float(a / b),
            (Sign::Remainder, Float(a), Float(b)) => float(a % b),
            (Sign::Plus, Vec3(a), Vec3(b)) => Vec3(a + b),
            (Sign::Minus, Vec3(a), Vec3(b)) => Vec3(a - b),
            (Sign::Times, Vec3(a), Vec3(b)) => Vec3(a * b),
            (Sign::Over, Vec3(a), Vec3(b)) => Vec3(a / b),
            (Sign::Plus, Vec3(a), Float(b)) => Vec3(a + b),
            (Sign::Minus, Vec3(a), Float(b)) => Vec3(a - b),
            (Sign::Times, Vec3(a), Float(b)) => Vec3(a * b),
            (Sign::Over, Vec3(a), Float(b)) => Vec3(a / b),
            (Sign::Plus, Float(a), Vec3(b)) => Vec3(a + b),
            (Sign::Minus, Float(a), Vec3(b)) => Vec3(a - b),
            (Sign::Times, Float(a), Vec3(b)) => Vec3(a * b),
            (Sign::Over, Float(a), Vec3(b)) => Vec3(a / b),
            (sign, Value::Bool(a), Value::Bool(b)) => Value::Bool(match sign {
                Sign::BitAnd => a & b,
                Sign::BitOr => a | b,
                _ => a ^ b,
            }),
            (sign, Int(a), Int(b)) => Int(self.integer(how, sign, a, b)?),
            (sign, a, b) => unreachable!("types are checked, and {a:?} {sign:?} {b:?} is nothing"),
        })
    }

    fn integer(&self, how: &Arithmetic, sign: Sign, a: i128, b: i128) -> Eval<i128> {
        let Some(Head::Int(int)) = self.code.types[how.ty].head() else {
            unreachable!("types are checked");
        };
        let (what, result) = match sign {
            Sign::Plus => ("add", a + b),
            Sign::Minus => ("subtract", a - b),
            Sign::Times => ("multiply", a * b),
            Sign::Over | Sign::Remainder if b == 0 => {
                let what = match sign {
                    Sign::Over => "attempt to divide by zero",
                    _ => "attempt to calculate the remainder with a divisor of zero",
                };
                return panic(&how.at, what);
            }
            Sign::Over => ("divide", a / b),
            Sign::Remainder => ("calculate the remainder", a % b),
            Sign::BitAnd => ("", a & b),
            Sign::BitOr => ("", a | b),
            Sign::BitXor => ("", a ^ b),
            Sign::Left | Sign::Right => {
                let bits = (int.most - int.least + 1).ilog2();
                if !(0..i128::from(bits)).contains(&b) {
                    let side = if sign == Sign::Left { "left" } else { "right" };
                    return panic(&how.at, &format!("attempt to shift {side} with overflow"));
                }
                match sign {
                    Sign::Left => ("", int.wrapped(a << b)),
                    _ => ("", a >> b),
                }
            }
        };
        match int.fits(result) {
            true => Ok(result),
            false => panic(&how.at, &format!("attempt to {what} with overflow")),
        }
    }

    /// What `Default` gives for the type.
    fn default(&mut self, ty: &Type) -> Eval {
        let Type::Of(head, arguments) = ty else {
            unreachable!("types are checked");
        };
        Ok(match head {
            Head::Bool => Value::Bool(false),
            Head::F64 | Head::F32 => Value::Float(0.0),
            Head::Int(_) => Value::Int(0),
            Head::Vec3 => Value::Vec3(Vec3::ZERO),
            Head::Option => Value::None,
            Head::Vec => Value::Many(Rc::default()),
            Head::Box => self.default(&arguments[0])?,
            Head::Tuple if arguments.is_empty() => Value::Unit,
            Head::Tuple => {
                let all = arguments.iter().map(|it| self.default(it));
                Value::Many(Rc::new(all.collect::<Eval<_>>()?))
            }
            Head::Array(length) => {
                Value::Many(Rc::new(vec![self.default(&arguments[0])?; *length]))
            }
            Head::Own(kind) => match self.code.defaults[*kind] {
                Some(own) => self.run(own, &[])?,
                None => {
                    let code = Arc::clone(&self.code);
                    let fields = code.fields[*kind].iter().map(|it| self.default(it));
                    Value::Own(*kind as u32, 0, Rc::new(fields.collect::<Eval<_>>()?))
                }
            },
            _ => unreachable!("the checker allows no default for {ty:?}"),
        })
    }
}

fn out_of_bounds<T>(at: &Place, length: usize, index: i128) -> Eval<T> {
    panic(
        at,
        &format!("index out of bounds: the len is {length} but the index is {index}"),
    )
}

/// Changes the part of a value that a path leads to.
fn reach(value: &mut Value, path: &[usize], change: &mut dyn FnMut(&mut Value)) {
    let [first, rest @ ..] = path else {
        return change(value);
    };
    match value {
        Value::Own(_, _, fields) | Value::Many(fields) => {
            reach(&mut Rc::make_mut(fields)[*first], rest, change);
        }
        Value::Some(inner) => reach(Rc::make_mut(inner), rest, change),
        Value::Vec3(vector) => {
            let mut part = Value::Float(vector[*first]);
            reach(&mut part, rest, change);
            vector[*first] = part.float();
        }
        Value::Ray(ray) => {
            let mut part = Value::Vec3([ray.origin, ray.direction][*first]);
            reach(&mut part, rest, change);
            let ray = Rc::make_mut(ray);
            *[&mut ray.origin, &mut ray.direction][*first] = part.vec3();
        }
        other => unreachable!("types are checked, and {other:?} has no parts to change"),
    }
}

/// `as`: rounds towards zero, stays at the ends of integers, and cuts integers off.
pub(crate) fn cast(value: &Value, ty: &Type) -> Value {
    match (value, ty.head()) {
        (Value::Float(it), Some(Head::Int(int))) => {
            Value::Int((*it as i128).clamp(int.least, int.most))
        }
        (Value::Float(it), Some(Head::F32)) => Value::Float(f64::from(*it as f32)),
        (Value::Int(it), Some(Head::Int(int))) => Value::Int(int.wrapped(*it)),
        (Value::Int(it), Some(Head::F64)) => Value::Float(*it as f64),
        (Value::Int(it), Some(Head::F32)) => Value::Float(f64::from(*it as f32)),
        (Value::Bool(it), Some(Head::Int(_))) => Value::Int((*it).into()),
        (value, _) => value.clone(),
    }
}
