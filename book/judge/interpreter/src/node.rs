//! An intermediate representation: what a text says, with its names found. Which field, method
//! or operator is meant, the value decides that it is asked of.

use std::cmp::Ordering;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use common::rtweekend::Vec3;

use crate::operators::{Order, Sign};
use crate::refusal::{At, Refusal};
use crate::types::{Head, Int, Owners, Type};

/// A part of a program, with variables by their slots.
#[derive(Debug, Default)]
pub(crate) enum Node {
    #[default]
    Unit,
    Bool(bool),
    Int(i128, Int),
    Float(f64),
    Single(f32),
    Vec3(Vec3),
    Ordering(Ordering),
    Str(Arc<str>),
    None,
    Local(usize),
    /// A shared reference to what that comes to.
    Lend(Box<Node>),
    /// A mutable reference to a place.
    Address(Box<Target>),
    Deref(Box<Node>, At),
    Field(Box<Node>, Arc<Field>),
    Index(Box<[Node; 2]>, At),
    Set(Box<Target>, Box<Node>, At),
    /// Several places, whose values come from one.
    SetAll(Vec<(Option<Target>, At)>, Box<Node>),
    Update(Box<Target>, Sign, Box<Node>, At),
    Let(Box<Pattern>, Box<Node>, Option<Box<Node>>),
    Arithmetic(Sign, Box<[Node; 2]>, At),
    /// `^` and the like, which no chapter has.
    Bits(Box<str>, Box<[Node; 2]>, At),
    /// Both sides, where the comparison stands and where its right side does.
    Compare(Order, Box<[Node; 2]>, At, At),
    And(Box<[Node; 2]>),
    Or(Box<[Node; 2]>),
    Not(Box<Node>, At),
    Negate(Box<Node>, At),
    Cast(Box<Node>, Box<Type>, At),
    /// What is declared to be of that type.
    Declared(Box<Node>, Box<Type>, At),
    Default(Box<Type>, At),
    Call(usize, Arguments),
    /// A constant is a function that is called once.
    Constant(usize, At),
    Method(Box<Method>, Receiver, Arguments),
    /// A function of the library, by its number.
    Native(usize, Arguments),
    /// A function that is a value.
    Apply(Box<Node>, Arguments),
    /// A closure, and whether it takes what it uses along.
    Closure(Arc<Closure>, bool),
    Function(usize),
    NativeFunction(usize),
    /// One of the reader's structs, its fields by their numbers, and a value that has the
    /// others.
    New(u32, Vec<(usize, Node)>, Option<Box<Node>>),
    Some(Box<Node>),
    List(Vec<Node>, bool, At),
    /// A value that is there so many times.
    Repeat(Box<[Node; 2]>, bool, At),
    Tuple(Vec<Node>),
    Range(Box<[Node; 2]>, bool, At),
    If(Box<[Node; 3]>),
    Match(Box<Node>, Vec<Arm>, At),
    Matches(Box<Pattern>, Box<Node>),
    /// A condition, and a body.
    While(Box<[Node; 2]>, At),
    For(Box<Pattern>, Box<[Node; 2]>, At),
    Break(Box<Node>),
    Continue,
    Return(Box<Node>),
    Try(Box<Node>, At),
    /// What is done one after the other, and whether the last is what it comes to.
    Block(Vec<Node>, bool),
    /// Lines that run from here on.
    Mark(Arc<Mark>),
    Panic(String, At),
    /// The first, or that of the mutant that runs: the others are those counted from this number.
    Mutants(u32, Box<[Node]>),
    /// Words, and the values between them.
    Format(Vec<String>, Vec<Node>, At),
}

/// Lines that run together, and whether they ever did.
#[derive(Debug)]
pub(crate) struct Mark {
    pub(crate) at: At,
    pub(crate) has_run: AtomicBool,
}

/// What a call gives, and where each of it and the whole call stand.
#[derive(Debug)]
pub(crate) struct Arguments {
    pub(crate) nodes: Box<[Node]>,
    pub(crate) places: Box<[At]>,
    pub(crate) at: At,
}

/// What a method is called on.
#[derive(Debug)]
pub(crate) enum Receiver {
    Value(Box<Node>),
    /// A place, which some method of that name would change.
    Place(Box<Target>),
}

/// A name after a point, before brackets: what may be meant.
#[derive(Debug)]
pub(crate) struct Method {
    pub(crate) name: String,
    /// The reader's functions, and whose they are; private ones are left out.
    pub(crate) own: Vec<(Head, usize)>,
    /// Those of the library, and on whose values.
    pub(crate) natives: Vec<(Owners, usize)>,
    pub(crate) at: At,
}

/// A name after a point: which of its fields that is of a value.
#[derive(Debug)]
pub(crate) struct Field {
    pub(crate) name: String,
    /// Of each of the reader's kinds, if it may be seen.
    pub(crate) own: Box<[Option<u32>]>,
    /// Of a vector, of a ray and of a tuple.
    pub(crate) vec3: Option<usize>,
    pub(crate) ray: Option<usize>,
    pub(crate) number: Option<usize>,
    pub(crate) at: At,
}

/// Something that can be assigned to: a variable, or a part of one.
#[derive(Debug)]
pub(crate) struct Target {
    pub(crate) root: Root,
    pub(crate) steps: Vec<Step>,
    /// What is said if the root is no mutable reference, since it is not `mut`.
    pub(crate) fixed: Option<Refusal>,
    pub(crate) at: At,
}

#[derive(Debug)]
pub(crate) enum Root {
    Local(usize),
    /// What a mutable reference leads to.
    Through(Node),
}

#[derive(Debug)]
pub(crate) enum Step {
    Field(Arc<Field>),
    Index(Node, At),
}

#[derive(Debug)]
pub(crate) struct Arm {
    pub(crate) pattern: Pattern,
    pub(crate) guard: Option<Node>,
    pub(crate) body: Node,
}

#[derive(Debug)]
pub(crate) enum Pattern {
    Any,
    Bind(usize),
    /// What is there, and a pattern for it.
    BindAs(usize, Box<Pattern>),
    None,
    Some(Box<Pattern>, At),
    /// A value of that type.
    Typed(Box<Pattern>, Type, At),
    Ref(Box<Pattern>, At),
    /// A struct, or a library type with names.
    Struct(Head, Vec<(usize, Pattern)>, At),
    /// Some parts of a tuple of so many.
    Tuple(usize, Vec<(usize, Pattern)>, At),
    List(Vec<Pattern>, At),
    /// What is equal to that.
    Equal(Node, At),
    /// From there to there, and whether the end is part of it.
    Within(Option<Node>, Option<Node>, bool, At),
    Or(Vec<Pattern>),
}

/// A function, ready to be run.
#[derive(Debug, Default)]
pub(crate) struct Function {
    pub(crate) slots: usize,
    /// The names of the slots.
    pub(crate) names: Vec<String>,
    pub(crate) body: Node,
    pub(crate) marks: Vec<Arc<Mark>>,
}

/// The parameters of a closure, and its body.
#[derive(Debug)]
pub(crate) struct Closure {
    pub(crate) parameters: Vec<Pattern>,
    pub(crate) body: Node,
}

impl Pattern {
    /// Whether every value matches.
    pub(crate) fn is_irrefutable(&self) -> bool {
        let all = |fields: &[(usize, Self)]| fields.iter().all(|it| it.1.is_irrefutable());
        match self {
            Self::Any | Self::Bind(_) => true,
            Self::BindAs(_, it) | Self::Typed(it, ..) | Self::Ref(it, _) => it.is_irrefutable(),
            Self::Struct(_, fields, _) | Self::Tuple(_, fields, _) => all(fields),
            Self::List(all, _) => all.iter().all(Self::is_irrefutable),
            _ => false,
        }
    }
}
