//! Places: a variable, and the way from there to a part of it. A `&mut` is another name of a place,
//! so no address exists while a program runs.

use std::mem;
use std::rc::Rc;
use std::sync::Arc;

use crate::fault::{Fault, Span};
use crate::machine::{Code, Machine, Run};
use crate::value::{Kind, Value, kind};

/// The place of a value: it can be read, taken away and put back.
#[derive(Clone)]
pub(crate) struct Place {
    pub(crate) slot: usize,
    pub(crate) path: Vec<Part>,
    /// The indices on the way, each with the slot in which the path looks for it: they are computed
    /// once for each use.
    pub(crate) indices: Vec<(usize, Arc<Code>)>,
    /// True if the place must not change.
    pub(crate) is_fixed: bool,
}

/// A step from a value to one of its parts.
#[derive(Clone)]
pub(crate) enum Part {
    Field(FieldName),
    /// The element whose number lies in this slot.
    Index(usize),
    /// The part with this number.
    Number(usize),
}

/// The name of a field, and its number in each type that has one of that name.
#[derive(Clone)]
pub(crate) struct FieldName {
    pub(crate) name: String,
    pub(crate) of: Vec<(Kind, usize)>,
}

impl FieldName {
    #[inline]
    fn number_in(&self, kind: Kind) -> Option<usize> {
        Some(self.of.iter().find(|it| it.0 == kind)?.1)
    }
}

impl Part {
    /// Returns the code that reads the part of the value of other code.
    pub(crate) fn read(self, of: Code, at: Span) -> Code {
        Code::act(move |m| {
            // A variable's field is read where it lies.
            if let (Self::Field(field), Code::Local(slot)) = (&self, &of) {
                let value = m.local(*slot);
                if let Some(n) = field.number_in(value.kind())
                    && let Some(part) = value.part(n)
                {
                    return Ok(part);
                }
            }
            let value = of.run(m)?;
            let n = self.number(m, &value, at)?;
            Ok(value.part(n).unwrap_or_default())
        })
    }

    /// Returns the number of the part in a value that has it.
    fn number(&self, m: &mut Machine<'_>, value: &Value, at: Span) -> Run<usize> {
        match self {
            Self::Number(n) => Ok(*n),
            Self::Field(field) => match field.number_in(value.kind()) {
                Some(n) if value.part(n).is_some() => Ok(n),
                _ => {
                    let ty = m.code.names.shown(value.kind());
                    m.refuse(at, format!("there is no field `{}` in `{ty}`", field.name))
                }
            },
            Self::Index(slot) => {
                let index = m.local(*slot).clone();
                m.index_in(value, &index, at)
            }
        }
    }
}

impl Machine<'_> {
    /// Returns the number of an element of a list, or of a component of a vector.
    pub(crate) fn index_in(&mut self, list: &Value, index: &Value, at: Span) -> Run<usize> {
        let count = match list.kind() {
            kind::LIST => list.parts().len(),
            kind::VEC3 => 3,
            other => return self.mismatch(at, "Vec", other),
        };
        if index.kind() == kind::RANGE {
            return self.unread(at, "a part of a list");
        }
        let Value::Int(n, kind::USIZE | kind::INT) = *index else {
            return self.mismatch(at, "usize", index.kind());
        };
        match usize::try_from(n) {
            Ok(n) if n < count => Ok(n),
            _ => self.panic(at, format!("index {n} is not below the length {count}")),
        }
    }
}

impl Place {
    pub(crate) fn of(slot: usize, is_fixed: bool) -> Self {
        let (path, indices) = (Vec::new(), Vec::new());
        Self {
            slot,
            path,
            indices,
            is_fixed,
        }
    }

    /// Returns the place of a part.
    pub(crate) fn part(mut self, part: Part) -> Self {
        self.path.push(part);
        self
    }

    /// Refuses to change a place that must not change.
    pub(crate) fn changeable(&self, at: Span) -> Result<(), Fault> {
        let message = "this can't change: it is not declared as `mut`, or it is behind a `&`";
        match self.is_fixed {
            true => Err(Fault::refused(at, message)),
            false => Ok(()),
        }
    }

    /// Returns the code that computes the indices and reads the place.
    pub(crate) fn read(&self, at: Span) -> Code {
        let parts = self.path.iter().cloned();
        let read = parts.fold(Code::Local(self.slot), |of, part| part.read(of, at));
        if self.indices.is_empty() {
            return read;
        }
        let place = self.clone();
        Code::act(move |m| {
            place.settle(m)?;
            read.run(m)
        })
    }

    /// Computes the indices on the way.
    pub(crate) fn settle(&self, m: &mut Machine<'_>) -> Run<()> {
        for (slot, index) in &self.indices {
            *m.local_mut(*slot) = index.run(m)?;
        }
        Ok(())
    }

    /// Takes the value away, for a change.
    pub(crate) fn take(&self, m: &mut Machine<'_>, at: Span) -> Run {
        match self.changeable(at) {
            Ok(()) => self.exchange(m, None, at),
            Err(fault) => m.stop(fault),
        }
    }

    pub(crate) fn put(&self, m: &mut Machine<'_>, value: Value, at: Span) -> Run<()> {
        self.exchange(m, Some(value), at).map(drop)
    }

    /// Puts a value into the place, or takes it away; returns what was there.
    fn exchange(&self, m: &mut Machine<'_>, new: Option<Value>, at: Span) -> Run {
        if self.path.is_empty() {
            let slot = m.local_mut(self.slot);
            return Ok(mem::replace(slot, new.unwrap_or_default()));
        }
        let mut path = Vec::new();
        let mut here = m.local(self.slot).clone();
        for part in &self.path {
            let n = part.number(m, &here, at)?;
            here = here.part(n).unwrap_or_default();
            path.push(n);
        }
        drop(here);
        let mut root = mem::take(m.local_mut(self.slot));
        let old = exchange(&mut root, &path, new);
        *m.local_mut(self.slot) = m.keep(root, at)?;
        match old {
            Some(old) => Ok(old),
            None => m.refuse(at, "a component of a vector must be a `f64`"),
        }
    }
}

/// Puts a value into a part, or takes it away; returns what was there, or `None` if the new value
/// can't be there.
fn exchange(value: &mut Value, path: &[usize], new: Option<Value>) -> Option<Value> {
    let [n, rest @ ..] = path else {
        return Some(mem::replace(value, new.unwrap_or_default()));
    };
    match value {
        Value::Vec3(vector) => {
            let old = vector[*n];
            if let Some(new) = new {
                vector[*n] = new.float()?;
            }
            Some(Value::Float(old))
        }
        Value::Data(shape, Some(parts)) => {
            let part = &mut Rc::make_mut(parts)[*n];
            let old = exchange(part, rest, new);
            *shape = shape.around(part.depth());
            old
        }
        _ => None,
    }
}
