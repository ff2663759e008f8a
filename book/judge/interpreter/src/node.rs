//! An intermediate representation: what a text says, with its names found.

use std::sync::Arc;

use common::rtweekend::Vec3;

use crate::prelude::Native;
use crate::types::{Int, Type};

/// A part of a program, with variables by their slots.
#[derive(Clone, Debug, Default)]
pub(crate) enum Node {
    #[default]
    Unit,
    Bool(bool),
    Int(i128, Int),
    Float(f64),
    Vec3(Vec3),
    Str(Arc<str>),
    None,
    Local(usize),
    /// What a mutable reference leads to.
    Deref(Box<Node>),
    Field(Box<Node>, usize),
    Index(Box<[Node; 2]>, At),
    /// A mutable reference to a place.
    Address(Box<Target>),
    Set(Box<Target>, Box<Node>),
    Update(Box<Target>, Sign, Box<Node>, At),
    Let(Box<Pattern>, Box<Node>, Option<Box<Node>>),
    Arithmetic(Sign, Box<[Node; 2]>, At),
    Compare(Order, Box<[Node; 2]>, At),
    And(Box<[Node; 2]>),
    Or(Box<[Node; 2]>),
    Not(Box<Node>, At),
    Negate(Box<Node>, At),
    Cast(Box<Node>, Box<Type>, At),
    /// What is declared to be of that type.
    Declared(Box<Node>, Box<Type>, At),
    Default(Box<Type>),
    Call(usize, Box<[Node]>, At),
    /// A constant is a function that is called once.
    Constant(usize, At),
    /// Of each of the reader's kinds the function that it has for a trait.
    Dispatch(Box<[Option<usize>]>, Box<[Node]>, At),
    Native(&'static Native, Box<[Node]>, At),
    /// A function that is a value.
    Apply(Box<Node>, Box<[Node]>, At),
    /// A closure, and whether it takes what it uses along.
    Closure(Arc<Closure>, bool),
    Function(usize),
    NativeFunction(&'static Native, At),
    /// One of the reader's structs, its fields by their numbers, and a value that has the
    /// others.
    New(u32, Vec<(usize, Node)>, Option<Box<Node>>),
    Some(Box<Node>),
    Many(Vec<Node>),
    Tuple(Vec<Node>),
    Range(Box<[Node; 2]>, bool),
    If(Box<[Node; 3]>),
    Match(Box<Node>, Vec<Arm>, At),
    Matches(Box<Pattern>, Box<Node>),
    /// A condition, and a body.
    While(Box<[Node; 2]>, At),
    For(Box<Pattern>, Box<[Node; 2]>, At),
    Break(Box<Node>),
    Continue,
    Return(Box<Node>),
    Try(Box<Node>),
    /// What is done one after the other, and whether the last is what it comes to.
    Block(Vec<Node>, bool),
    Panic(String, At),
    /// The first, or that of the mutant that runs: the others are those counted from this number.
    Mutants(u32, Box<[Node]>),
    /// Words, and the values between them.
    Format(Vec<String>, Vec<Node>),
}

/// Where something stands in the texts: the file, and the bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct At {
    pub(crate) file: u32,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Plus,
    Minus,
    Times,
    Over,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    Equal,
    Unequal,
    Less,
    AtMost,
    More,
    AtLeast,
}

/// Something that can be assigned to: a variable, or a part of one.
#[derive(Clone, Debug)]
pub(crate) struct Target {
    pub(crate) root: Root,
    /// The numbers of the fields that lead there.
    pub(crate) steps: Vec<usize>,
}

#[derive(Clone, Debug)]
pub(crate) enum Root {
    Local(usize),
    /// What a mutable reference leads to.
    Through(Node),
}

#[derive(Clone, Debug)]
pub(crate) struct Arm {
    pub(crate) pattern: Pattern,
    pub(crate) guard: Option<Node>,
    pub(crate) body: Node,
}

#[derive(Clone, Debug)]
pub(crate) enum Pattern {
    Any,
    Bind(usize),
    None,
    Some(Box<Pattern>),
    /// The fields of a value, by their numbers.
    Fields(Vec<(usize, Pattern)>),
    Many(Vec<Pattern>),
}

/// A function, ready to be run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Function {
    pub(crate) slots: usize,
    pub(crate) body: Node,
    /// The names of the slots.
    pub(crate) names: Vec<String>,
}

/// The parameters of a closure, and its body.
#[derive(Clone, Debug)]
pub(crate) struct Closure {
    pub(crate) parameters: Vec<Pattern>,
    pub(crate) body: Node,
}

impl Pattern {
    /// Whether every value matches.
    pub(crate) fn is_irrefutable(&self) -> bool {
        match self {
            Self::Any | Self::Bind(_) => true,
            Self::Fields(all) => all.iter().all(|(_, it)| it.is_irrefutable()),
            Self::Many(all) => all.iter().all(Self::is_irrefutable),
            _ => false,
        }
    }
}
