//! An intermediate representation: what a text says, with its names, methods and types found.

use common::rtweekend::Vec3;

use crate::Place;

/// A part of a program, with variables by their slots.
#[derive(Clone, Debug)]
pub(crate) enum Node {
    Unit,
    Bool(bool),
    Int(i128),
    Float(f64),
    Vec3(Vec3),
    None,
    Ordering(std::cmp::Ordering),
    Local(usize),
    /// What a mutable reference leads to.
    Deref(Box<Node>),
    Field(Box<Node>, usize),
    Index(Box<Node>, Box<Node>, At),
    /// A mutable reference to a place.
    Address(Box<Target>),
    Set(Box<Target>, Box<Node>),
    Update(Box<Target>, Box<Arithmetic>, Box<Node>),
    Let(Box<Pattern>, Box<Node>, Option<Box<Node>>),
    Arithmetic(Box<Arithmetic>, Box<[Node; 2]>),
    Compare(Order, Box<[Node; 2]>),
    And(Box<[Node; 2]>),
    Or(Box<[Node; 2]>),
    Not(Box<Node>, TypeId),
    Negate(Box<Node>, TypeId, At),
    /// `as`, and what only has another type: an f32 is rounded.
    Cast(Box<Node>, TypeId),
    Default(TypeId),
    Call(usize, Vec<Node>),
    /// The method of that name that the first argument has.
    Dispatch(usize, String, Vec<Node>),
    Native(usize, Vec<Node>, TypeId, At),
    /// A function that is a value.
    CallValue(Box<Node>, Vec<Node>),
    /// A closure: its number, and whether it takes what it uses along.
    Closure(usize, bool),
    Function(usize),
    NativeFunction(usize, At),
    /// A variant of one of the reader's types, its fields by their numbers, and a value that
    /// has the others.
    New(usize, usize, Vec<(usize, Node)>, Option<Box<Node>>),
    Some(Box<Node>),
    Many(Vec<Node>),
    Repeat(Box<Node>, usize),
    Range(Option<Box<Node>>, Option<Box<Node>>, bool),
    If(Box<Node>, Box<Node>, Box<Node>),
    Match(Box<Node>, Vec<Arm>, At),
    Matches(Box<Pattern>, Box<Node>),
    /// A condition, a body, and a number that `break` and `continue` name it by.
    While(Box<Node>, Box<Node>, usize, At),
    For(Box<Pattern>, Box<Node>, Box<Node>, usize, At),
    /// A block that can be left by its number.
    Labeled(Box<Node>, usize),
    Break(usize, Box<Node>),
    Continue(usize),
    Return(Box<Node>),
    Try(Box<Node>),
    /// What is done one after the other, and whether the last is what it comes to.
    Block(Vec<Node>, bool),
    Panic(String, At),
}

/// Where something stands in the text, for what may fail when it runs.
pub(crate) type At = Box<Place>;

/// A place in the list of types that are known when a function is read.
pub(crate) type TypeId = usize;

/// An operator between two numbers or vectors, and the type of what comes out.
#[derive(Clone, Debug)]
pub(crate) struct Arithmetic {
    pub(crate) sign: Sign,
    pub(crate) ty: TypeId,
    pub(crate) at: Place,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Plus,
    Minus,
    Times,
    Over,
    Remainder,
    BitAnd,
    BitOr,
    BitXor,
    Left,
    Right,
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
    pub(crate) steps: Vec<Step>,
}

#[derive(Clone, Debug)]
pub(crate) enum Root {
    Local(usize),
    /// What a mutable reference leads to.
    Through(Node),
    /// A value that has no name, kept in a slot.
    Temporary(usize, Node),
}

#[derive(Clone, Debug)]
pub(crate) enum Step {
    Field(usize),
    Index(Node, At),
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
    Bind(usize, Box<Pattern>),
    Literal(Node),
    Range(Option<Node>, Option<Node>, bool),
    None,
    Some(Box<Pattern>),
    /// A variant of one of the reader's types, and its fields by their numbers.
    Variant(usize, Vec<(usize, Pattern)>),
    /// The fields of a value that has no variants.
    Fields(Vec<(usize, Pattern)>),
    Many(Vec<Pattern>),
    Or(Vec<Pattern>),
}

/// A function, ready to be run.
#[derive(Clone, Debug)]
pub(crate) struct Function {
    pub(crate) slots: usize,
    /// What each parameter is bound to.
    pub(crate) parameters: Vec<Pattern>,
    pub(crate) body: Node,
}

impl Pattern {
    /// Whether every value matches.
    pub(crate) fn is_irrefutable(&self) -> bool {
        match self {
            Self::Any => true,
            Self::Bind(_, pattern) => pattern.is_irrefutable(),
            Self::Fields(all) => all.iter().all(|(_, it)| it.is_irrefutable()),
            Self::Many(all) => all.iter().all(Self::is_irrefutable),
            Self::Or(all) => all.iter().any(Self::is_irrefutable),
            _ => false,
        }
    }
}
