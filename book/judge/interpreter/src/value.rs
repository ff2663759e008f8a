//! Values: numbers, vectors, and what is made of them.
//!
//! A shared reference is the value itself, since nothing changes while it lives, and so is a
//! box. A mutable reference is an address: a slot of the stack and the way from there to a part.

use std::cmp::Ordering;
use std::rc::Rc;
use std::sync::Arc;

use common::rtweekend::{Ray, Vec3};

use crate::canvas::Brush;
use crate::names::Names;
use crate::node::{At, Closure};
use crate::prelude::Native;
use crate::types::{Head, Int, Type};

#[derive(Clone, Debug, Default)]
pub(crate) enum Value {
    #[default]
    Unit,
    Bool(bool),
    Int(i128, Int),
    Float(f64),
    Vec3(Vec3),
    Ray(Rc<Ray>),
    /// Width and height, and what colors its pixels.
    Picture(Rc<((u32, u32), Rc<Brush>)>),
    Str(Rc<String>),
    Ordering(Ordering),
    None,
    Some(Rc<Value>),
    /// One of the reader's structs, and its fields.
    Own(u32, Rc<[Value]>),
    Tuple(Rc<[Value]>),
    /// A list, an array, or what an iterator gives.
    Many(Rc<Vec<Value>>),
    Range(Rc<[Value; 2]>, bool),
    Mut(Address),
    /// A closure, and the frame that it looks at or has taken along.
    Closure(Arc<Closure>, Frame),
    Function(usize),
    Native(&'static Native, At),
}

/// The place of a value: a slot of the stack, and the way from there to a part.
#[derive(Clone, Debug)]
pub(crate) struct Address {
    pub(crate) slot: usize,
    pub(crate) steps: Vec<usize>,
}

impl Address {
    pub(crate) fn of(slot: usize) -> Self {
        let steps = Vec::new();
        Self { slot, steps }
    }
}

#[derive(Clone, Debug)]
pub(crate) enum Frame {
    /// Where it begins, and how many slots it has.
    At(u32, u32),
    Taken(Rc<Vec<Value>>),
}

/// What gives one value after the other: of a list by its place, or of a range by the next
/// number and the one after the last.
pub(crate) enum Iter {
    List(Rc<Vec<Value>>, usize),
    Range(i128, i128, Int),
}

impl Iter {
    pub(crate) fn next(&mut self) -> Option<Value> {
        match self {
            Self::List(all, next) => {
                *next += 1;
                all.get(*next - 1).cloned()
            }
            Self::Range(next, end, int) => {
                let is_there = *next < *end;
                *next += i128::from(is_there);
                is_there.then(|| Value::Int(*next - 1, *int))
            }
        }
    }
}

/// What only another type could have, of which the checks have made sure.
macro_rules! taken {
    ($name:ident, $variant:ident, $ty:ty) => {
        pub(crate) fn $name(&self) -> $ty {
            match self {
                Self::$variant(it, ..) => it.clone(),
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
    taken!(many, Many, Rc<Vec<Value>>);
    taken!(ordering, Ordering, Ordering);
    taken!(text, Str, Rc<String>);

    pub(crate) fn usize(number: usize) -> Self {
        Self::Int(number as i128, Int::Usize)
    }

    pub(crate) fn option(&self) -> Option<Self> {
        match self {
            Self::Some(it) => Some(Self::clone(it)),
            _ => None,
        }
    }

    pub(crate) fn of(option: Option<Self>) -> Self {
        option.map_or(Self::None, |it| Self::Some(Rc::new(it)))
    }

    /// Its type, as far as a value shows it.
    pub(crate) fn ty(&self) -> Type {
        let of = |value: Option<&Self>| value.map_or(Type::UNKNOWN, Self::ty);
        match self {
            Self::Unit => Type::UNIT,
            Self::Bool(_) => Head::Bool.into(),
            Self::Int(_, int) => Head::Int(*int).into(),
            Self::Float(_) => Head::F64.into(),
            Self::Vec3(_) => Head::Vec3.into(),
            Self::Ray(_) => Head::Ray.into(),
            Self::Picture(_) => Head::Picture.into(),
            Self::Str(_) => Head::Str.into(),
            Self::Ordering(_) => Head::Ordering.into(),
            Self::None => Type::of(Head::Option, Type::UNKNOWN),
            Self::Some(it) => Type::of(Head::Option, it.ty()),
            Self::Own(kind, ..) => Head::Own(*kind as usize).into(),
            Self::Tuple(all) => Type(Head::Tuple, all.iter().map(Self::ty).collect()),
            Self::Many(all) => Type::of(Head::Vec, of(all.first())),
            Self::Range(ends, _) => Type::of(Head::Range, ends[0].ty()),
            Self::Mut(_) => Type::of(Head::RefMut, Type::UNKNOWN),
            Self::Closure(closure, _) => {
                let unknown = vec![Type::UNKNOWN; closure.parameters.len() + 1];
                Type(Head::Fn, unknown)
            }
            Self::Function(_) | Self::Native(..) => Type::UNKNOWN,
        }
    }

    /// Whether it may be where that type is declared.
    pub(crate) fn fits(&self, ty: &Type, names: &Names) -> bool {
        match (self, ty.0) {
            (Self::Float(_), Head::F64) | (Self::Vec3(_), Head::Vec3) | (_, Head::Unknown) => true,
            (Self::Mut(_), Head::RefMut) => true,
            (value, Head::Ref | Head::Box) => value.fits(&ty.1[0], names),
            (Self::Some(it), Head::Option) => it.fits(&ty.1[0], names),
            (Self::Many(all), Head::Vec | Head::Slice | Head::Array(_)) => {
                let is_as_long = !matches!(ty.0, Head::Array(length) if length != all.len());
                is_as_long && all.first().is_none_or(|it| it.fits(&ty.1[0], names))
            }
            (Self::Tuple(all), Head::Tuple) => {
                let mut both = all.iter().zip(&ty.1);
                all.len() == ty.1.len() && both.all(|(it, ty)| it.fits(ty, names))
            }
            _ => self.ty().fits(ty, names),
        }
    }

    /// A part of a value that has parts, by its number.
    pub(crate) fn field(&self, n: usize) -> Self {
        match self {
            Self::Own(_, fields) | Self::Tuple(fields) => fields[n].clone(),
            Self::Many(fields) => fields[n].clone(),
            Self::Vec3(vector) => Self::Float(vector[n]),
            Self::Ray(ray) => Self::Vec3([ray.origin, ray.direction][n]),
            other => unreachable!("types are checked, and {other:?} has no fields"),
        }
    }

    /// Whether they are equal, as `derive(PartialEq)` has it.
    pub(crate) fn equals(&self, other: &Self) -> bool {
        let all_equal = |one: &[Self], other: &[Self]| {
            one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.equals(other))
        };
        match (self, other) {
            (Self::Vec3(one), Self::Vec3(other)) => one == other,
            (Self::Ray(one), Self::Ray(other)) => one == other,
            (Self::Ordering(one), Self::Ordering(other)) => one == other,
            (Self::Str(one), Self::Str(other)) => one == other,
            (Self::None, Self::None) | (Self::Unit, Self::Unit) => true,
            (Self::Some(one), Self::Some(other)) => one.equals(other),
            (Self::Own(_, fields), Self::Own(_, others)) => all_equal(fields, others),
            (Self::Tuple(fields), Self::Tuple(others)) => all_equal(fields, others),
            (Self::Many(fields), Self::Many(others)) => all_equal(fields, others),
            (one, other) => one.compared(other).is_some_and(Ordering::is_eq),
        }
    }

    /// How numbers are ordered, unless one is none.
    pub(crate) fn compared(&self, other: &Self) -> Option<Ordering> {
        match (self, other) {
            (Self::Float(one), Self::Float(other)) => one.partial_cmp(other),
            (Self::Int(one, _), Self::Int(other, _)) => one.partial_cmp(other),
            (Self::Bool(one), Self::Bool(other)) => one.partial_cmp(other),
            _ => None,
        }
    }

    /// `as`: rounds towards zero, stays at the ends of integers, and cuts integers off.
    pub(crate) fn cast(&self, ty: &Type) -> Option<Self> {
        Some(match (self, ty.0) {
            (Self::Float(it), Head::Int(int)) => {
                let (least, most) = int.ends();
                Self::Int((*it as i128).clamp(least, most), int)
            }
            (Self::Int(it, _), Head::Int(int)) => Self::Int(int.wrapped(*it), int),
            (Self::Int(it, _), Head::F64) => Self::Float(*it as f64),
            (Self::Bool(it), Head::Int(int)) => Self::Int((*it).into(), int),
            (Self::Float(_), Head::F64) => self.clone(),
            (_, Head::Int(_) | Head::F64) => return None,
            (value, _) => value.clone(),
        })
    }

    /// Changes the part that a path leads to.
    pub(crate) fn reach(&mut self, path: &[usize], change: &mut dyn FnMut(&mut Self)) {
        let &[first, ref rest @ ..] = path else {
            return change(self);
        };
        match self {
            Self::Own(_, fields) | Self::Tuple(fields) => {
                Rc::make_mut(fields)[first].reach(rest, change);
            }
            Self::Vec3(vector) => {
                let mut part = Self::Float(vector[first]);
                part.reach(rest, change);
                vector[first] = part.float();
            }
            Self::Ray(ray) => {
                let mut part = Self::Vec3([ray.origin, ray.direction][first]);
                part.reach(rest, change);
                let ray = Rc::make_mut(ray);
                *[&mut ray.origin, &mut ray.direction][first] = part.vec3();
            }
            other => unreachable!("types are checked, and {other:?} has no parts to change"),
        }
    }
}
