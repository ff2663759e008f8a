//! Dynamically typed values: numbers, vectors, and all that is made of them.
//!
//! A shared reference is the value itself with a count of its `&`, since nothing changes while
//! it lives. A mutable reference is an address: a slot of the stack and the way from there to a
//! part.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::rc::Rc;
use std::sync::Arc;

use common::rtweekend::{Camera, Picture, Ray, Vec3};

use super::iter::Iter;
use super::{Closure, Native};
use crate::refusal::Span;
use crate::types::{Ctor, Int, Type};

/// A value of a running program: data behind a count of shared references.
#[derive(Clone, Default)]
pub(crate) struct Value {
    /// How many `&` lead to the data.
    pub(crate) lent: u8,
    pub(crate) data: Data,
}

/// The data of a value, by its type.
#[derive(Clone, Default)]
pub(crate) enum Data {
    #[default]
    Unit,
    Bool(bool),
    /// An integer and its type.
    Int(PackedInt, Int),
    Float(f64),
    Single(f32),
    Vec3(Vec3),
    Ray(Rc<Ray>),
    /// Width and height in pixels, and the function that colors the pixels.
    Picture(Rc<((u32, u32), Rc<Brush>)>),
    Str(Rc<String>),
    Ordering(Ordering),
    None,
    Some(Rc<Value>),
    Box(Rc<Value>),
    /// The number of one of the text's structs, and its fields.
    Own(u32, Rc<[Value]>),
    Tuple(Rc<[Value]>),
    List(Rc<ListValue>),
    /// The two ends of a range, the second `()` if there is none, and true if the second end is
    /// included.
    Range(Rc<[Value; 2]>, bool),
    Iter(Rc<RefCell<Iter>>),
    /// A mutable reference, as the address of its place.
    Mut(Address),
    /// A closure, and the variables that it uses.
    Closure(Arc<Closure>, Captures),
    /// A function of the text, by its number.
    Function(usize),
    Native(&'static Native),
}

/// An integer of any type, packed so that a value with one takes no more space than one with a
/// vector.
#[derive(Clone, Copy)]
#[repr(C, packed(8))]
pub(crate) struct PackedInt(i128);

impl PackedInt {
    pub(crate) fn get(self) -> i128 {
        self.0
    }
}

/// The elements of a `Vec` or an array.
#[derive(Clone, Default)]
pub(crate) struct ListValue {
    pub(crate) all: Vec<Value>,
    /// The declared type of the elements; unknown until one is declared.
    pub(crate) of: Type,
    pub(crate) is_array: bool,
}

/// The address of a value: a slot of the stack, and the numbers of the parts on the way from there.
#[derive(Clone)]
pub(crate) struct Address {
    pub(crate) slot: u32,
    pub(crate) steps: Box<[u32]>,
}

impl Address {
    /// Returns the address of a slot of the stack.
    pub(crate) fn of(slot: usize) -> Self {
        Self {
            slot: slot as u32,
            steps: Box::default(),
        }
    }

    /// Returns the address of part `n`.
    pub(crate) fn part(&self, n: usize) -> Self {
        Self {
            slot: self.slot,
            steps: [&*self.steps, &[n as u32]].concat().into(),
        }
    }
}

/// The variables that a closure uses.
#[derive(Clone)]
pub(crate) enum Captures {
    /// Those of a frame that is still open: its first slot, and its count of slots.
    Borrowed(u32, u32),
    /// Copies of all variables of a frame.
    Moved(Rc<Vec<Value>>),
}

/// The way in which the pixels of a picture get their colors.
pub(crate) enum Brush {
    /// A function value of column and row, and where it is given.
    Pixel(Value, Span),
    /// The book's camera, a function value of its rays, and where that is given.
    Ray(Camera, Value, Span),
    /// The book's camera, the number of the text's `ray_color`, and the world that it takes, if it
    /// takes one.
    Role(Camera, usize, Option<Value>),
    /// A picture that was printed as a P3 file.
    Printed(Picture),
}

impl From<Data> for Value {
    fn from(data: Data) -> Self {
        Self { lent: 0, data }
    }
}

macro_rules! from {
    ($($ty:ty: $variant:ident),*) => {
        $(impl From<$ty> for Value {
            fn from(it: $ty) -> Self {
                Data::$variant(it).into()
            }
        })*
    };
}

from!(f64: Float, f32: Single, bool: Bool, Vec3: Vec3, Ordering: Ordering);

impl From<Option<Self>> for Value {
    fn from(option: Option<Self>) -> Self {
        let data = option.map_or(Data::None, |it| Data::Some(Rc::new(it)));
        data.into()
    }
}

/// Defines accessors that return the data of one type. The type checks guarantee the variant.
macro_rules! taken {
    ($name:ident, $variant:ident, $ty:ty) => {
        pub(crate) fn $name(&self) -> $ty {
            match &self.data {
                Data::$variant(it, ..) => it.clone(),
                other => unreachable!("types are checked, and this is {:?}", other.ctor()),
            }
        }
    };
}

impl Value {
    taken!(truth, Bool, bool);
    taken!(vec3, Vec3, Vec3);
    taken!(ray, Ray, Rc<Ray>);
    taken!(list, List, Rc<ListValue>);
    taken!(ordering, Ordering, Ordering);
    taken!(text, Str, Rc<String>);

    /// Returns a number as an `f64`.
    pub(crate) fn float(&self) -> f64 {
        match self.data {
            Data::Float(it) => it,
            Data::Single(it) => it.into(),
            Data::Int(it, _) => it.get() as f64,
            ref other => unreachable!("types are checked, and this is {:?}", other.ctor()),
        }
    }

    /// Returns an integer.
    pub(crate) fn int(&self) -> i128 {
        match self.data {
            Data::Int(it, _) => it.get(),
            ref other => unreachable!("types are checked, and this is {:?}", other.ctor()),
        }
    }

    /// Makes an integer of a type.
    pub(crate) fn whole(number: i128, int: Int) -> Self {
        Data::Int(PackedInt(number), int).into()
    }

    /// Makes an integer of type `usize`.
    pub(crate) fn usize(number: usize) -> Self {
        Self::whole(number as i128, Int::Usize)
    }

    /// Makes a text.
    pub(crate) fn str(text: impl Into<String>) -> Self {
        Data::Str(Rc::new(text.into())).into()
    }

    /// Makes an array, or else a `Vec`.
    pub(crate) fn listed(all: Vec<Self>, is_array: bool) -> Self {
        let of = Type::UNKNOWN;
        Data::List(Rc::new(ListValue { all, of, is_array })).into()
    }

    pub(crate) fn vector(all: Vec<Self>) -> Self {
        Self::listed(all, false)
    }

    pub(crate) fn array(all: Vec<Self>) -> Self {
        Self::listed(all, true)
    }

    pub(crate) fn iter(iter: Iter) -> Self {
        Data::Iter(Rc::new(RefCell::new(iter))).into()
    }

    pub(crate) fn tuple(all: impl Into<Rc<[Self]>>) -> Self {
        Data::Tuple(all.into()).into()
    }

    /// Returns the value inside of `Some`, lent if the option is.
    pub(crate) fn option(&self) -> Option<Self> {
        match &self.data {
            Data::Some(it) => Some((**it).clone().more_lent(self.lent.min(1))),
            _ => None,
        }
    }

    /// Returns the value behind `more` further `&`.
    pub(crate) fn more_lent(self, more: u8) -> Self {
        Self {
            lent: self.lent.saturating_add(more),
            ..self
        }
    }

    /// Returns the value behind one further `&`.
    pub(crate) fn lent(self) -> Self {
        self.more_lent(1)
    }

    /// Returns the value without its `&`.
    pub(crate) fn owned(self) -> Self {
        Self { lent: 0, ..self }
    }

    /// Returns part `n` of a value: a field, an element, a component, or what a box or `Some`
    /// holds, which has the number 0.
    pub(crate) fn part(&self, n: usize) -> Self {
        match &self.data {
            Data::Own(_, fields) | Data::Tuple(fields) => fields[n].clone(),
            Data::List(list) => list.all[n].clone(),
            Data::Vec3(vector) => vector[n].into(),
            Data::Ray(ray) => [ray.origin, ray.direction][n].into(),
            Data::Some(it) | Data::Box(it) => (**it).clone(),
            other => unreachable!("types are checked, and {:?} has no parts", other.ctor()),
        }
    }

    /// Changes the part of a value to which a path of numbers leads; the value itself for an empty
    /// path.
    pub(crate) fn reach(&mut self, path: &[u32], change: &mut dyn FnMut(&mut Self)) {
        let &[first, ref rest @ ..] = path else {
            return change(self);
        };
        let first = first as usize;
        match &mut self.data {
            Data::Own(_, fields) | Data::Tuple(fields) => {
                Rc::make_mut(fields)[first].reach(rest, change);
            }
            Data::List(list) => Rc::make_mut(list).all[first].reach(rest, change),
            Data::Some(it) | Data::Box(it) => Rc::make_mut(it).reach(rest, change),
            Data::Vec3(vector) => {
                let mut part = Self::from(vector[first]);
                part.reach(rest, change);
                vector[first] = part.float();
            }
            Data::Ray(ray) => {
                let mut part = Self::from([ray.origin, ray.direction][first]);
                part.reach(rest, change);
                let ray = Rc::make_mut(ray);
                *[&mut ray.origin, &mut ray.direction][first] = part.vec3();
            }
            other => unreachable!("types are checked, and {:?} has no parts", other.ctor()),
        }
    }

    /// Returns true if both values may be of one type, as far as they show it.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        let is_same = match (self.data.ctor(), other.data.ctor()) {
            (Ctor::Int(one), Ctor::Int(other)) => one.joined(other).is_some(),
            (one, other) => one == other,
        };
        let parts = match (&self.data, &other.data) {
            (Data::Some(one), Data::Some(other)) => one.is_like(other),
            (Data::Tuple(one), Data::Tuple(other)) => {
                one.len() == other.len() && one.iter().zip(&**other).all(|it| it.0.is_like(it.1))
            }
            // Boxes may be of what has a trait.
            _ => true,
        };
        self.lent == other.lent && is_same && parts
    }

    /// Returns true if both values are equal, as by a derived `PartialEq`.
    pub(crate) fn equals(&self, other: &Self) -> bool {
        let all_equal = |one: &[Self], other: &[Self]| {
            one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.equals(other))
        };
        match (&self.data, &other.data) {
            (Data::Vec3(one), Data::Vec3(other)) => one == other,
            (Data::Ray(one), Data::Ray(other)) => one == other,
            (Data::Ordering(one), Data::Ordering(other)) => one == other,
            (Data::Str(one), Data::Str(other)) => one == other,
            (Data::None, Data::None) | (Data::Unit, Data::Unit) => true,
            (Data::Some(one), Data::Some(other)) | (Data::Box(one), Data::Box(other)) => {
                one.equals(other)
            }
            (Data::Own(_, one), Data::Own(_, other)) | (Data::Tuple(one), Data::Tuple(other)) => {
                all_equal(one, other)
            }
            (Data::List(one), Data::List(other)) => all_equal(&one.all, &other.all),
            _ => self.compared(other).is_some_and(Ordering::is_eq),
        }
    }

    /// Compares two numbers or truths; `None` for other values, or if one is NaN.
    pub(crate) fn compared(&self, other: &Self) -> Option<Ordering> {
        match (&self.data, &other.data) {
            (Data::Float(one), Data::Float(other)) => one.partial_cmp(other),
            (Data::Int(..), Data::Int(..)) => self.int().partial_cmp(&other.int()),
            (Data::Bool(one), Data::Bool(other)) => one.partial_cmp(other),
            (Data::Single(_), Data::Single(_) | Data::Float(_))
            | (Data::Float(_), Data::Single(_)) => self.float().partial_cmp(&other.float()),
            _ => None,
        }
    }

    /// Converts a number as `as` does: a float is rounded towards zero and clamped to the integer's
    /// range, an integer is wrapped. `None` for other values.
    pub(crate) fn cast(&self, ty: &Type) -> Option<Self> {
        Some(match (&self.data, ty.0) {
            (Data::Float(_) | Data::Single(_), Ctor::Int(int)) => {
                let (least, most) = int.ends();
                Self::whole((self.float() as i128).clamp(least, most), int)
            }
            (Data::Int(it, _), Ctor::Int(int)) => Self::whole(int.wrapped(it.get()), int),
            (Data::Bool(it), Ctor::Int(int)) => Self::whole((*it).into(), int),
            (Data::Int(it, _), Ctor::F32) => (it.get() as f32).into(),
            (Data::Float(_) | Data::Single(_) | Data::Int(..), Ctor::F64) => self.float().into(),
            (Data::Float(it), Ctor::F32) => (*it as f32).into(),
            (Data::Single(it), Ctor::F32) => (*it).into(),
            _ => return None,
        })
    }
}

impl Data {
    /// Returns the type of the data, without the types of its parts.
    pub(crate) fn ctor(&self) -> Ctor {
        match self {
            Data::Bool(_) => Ctor::Bool,
            Data::Int(_, int) => Ctor::Int(*int),
            Data::Float(_) => Ctor::F64,
            Data::Single(_) => Ctor::F32,
            Data::Vec3(_) => Ctor::Vec3,
            Data::Ray(_) => Ctor::Ray,
            Data::Picture(_) => Ctor::Picture,
            Data::Str(_) => Ctor::Str,
            Data::Ordering(_) => Ctor::Ordering,
            Data::None | Data::Some(_) => Ctor::Option,
            Data::Box(_) => Ctor::Box,
            Data::Own(kind, _) => Ctor::Own(*kind),
            Data::Unit | Data::Tuple(_) => Ctor::Tuple,
            Data::List(list) if list.is_array => Ctor::Array(list.all.len()),
            Data::List(_) => Ctor::Vec,
            Data::Range(..) => Ctor::Range,
            Data::Iter(_) => Ctor::Iterator,
            Data::Mut(_) => Ctor::RefMut,
            Data::Closure(..) | Data::Function(_) | Data::Native(_) => Ctor::Fn,
        }
    }
}
