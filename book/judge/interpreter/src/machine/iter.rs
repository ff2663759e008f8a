//! Iterators: what is left of a list, or a function that makes the next value.

use std::cell::RefCell;
use std::rc::Rc;

use super::value::{ListValue, Value};
use super::{Eval, Machine};

/// An iterator: it gives one value after the other.
pub(crate) enum Iter {
    /// The parts of a list from a number on, each with so many more `&`.
    List(Rc<ListValue>, usize, u8),
    /// An iterator that is somebody else's, too.
    Shared(Rc<RefCell<Iter>>),
    Function(Box<NextOf>),
}

type NextOf = dyn FnMut(&mut Machine<'_>) -> Eval<Option<Value>>;

impl Iter {
    pub(crate) fn new(next: impl FnMut(&mut Machine<'_>) -> Eval<Option<Value>> + 'static) -> Self {
        Self::Function(Box::new(next))
    }

    /// Returns the next value.
    pub(crate) fn next(&mut self, machine: &mut Machine<'_>) -> Eval<Option<Value>> {
        match self {
            Self::List(list, n, lent) => {
                *n += 1;
                Ok(list.all.get(*n - 1).map(|it| it.clone().more_lent(*lent)))
            }
            Self::Shared(it) => it.borrow_mut().next(machine),
            Self::Function(next) => next(machine),
        }
    }
}
