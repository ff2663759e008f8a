//! Iterators: what is left of a list, or a function that makes the next value.

use std::cell::RefCell;
use std::rc::Rc;

use super::value::{ListValue, Value};
use super::{Eval, Machine};

/// An iterator, which makes its values when it is asked for them.
pub(crate) enum Iter {
    /// The elements of a list, the number of the next one, and how many `&` are added to each.
    List(Rc<ListValue>, usize, u8),
    /// An iterator that another value has, too, as after `by_ref`.
    Shared(Rc<RefCell<Iter>>),
    /// A function that makes the next value.
    Function(Box<NextFn>),
}

/// A function that makes the next value; `None` at the end.
type NextFn = dyn FnMut(&mut Machine<'_>) -> Eval<Option<Value>>;

impl Iter {
    pub(crate) fn new(next: impl FnMut(&mut Machine<'_>) -> Eval<Option<Value>> + 'static) -> Self {
        Self::Function(Box::new(next))
    }

    /// Returns the next value; `None` at the end.
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
