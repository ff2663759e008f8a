//! Addresses: reads and changes of variables and their parts, through references and boxes.

use super::value::{Address, Data, Value};
use super::{Eval, ExprInfo, Machine};
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Int, Type};

/// An expression that can be assigned to: a variable, or a part of one.
pub(crate) struct PlaceExpr {
    /// The slot of the variable, if the place is a whole variable.
    pub(crate) local: Option<usize>,
    /// The slot of the variable in which the place lies; `None` behind a `*`.
    pub(crate) root: Option<usize>,
    /// The refusal of a change, if the variable is not `mut`; it applies unless the variable holds
    /// a mutable reference.
    pub(crate) fixed: Option<Refusal>,
    /// The function that finds the address, through mutable references and boxes on the way.
    pub(crate) address: Box<AddressFn>,
    pub(crate) at: Span,
}

/// A function that finds the address of a place.
type AddressFn = dyn Fn(&mut Machine<'_>) -> Eval<Address> + Send + Sync;

/// The name behind a `.`: the number of the field with that name in each type.
pub(crate) struct FieldAccess {
    pub(crate) name: String,
    /// The number of the field in each struct of the text; `None` if it has none that is visible
    /// here.
    pub(crate) own: Box<[Option<u32>]>,
    /// The number of the component of a vector.
    pub(crate) vec3: Option<usize>,
    /// The number of the field of a ray.
    pub(crate) ray: Option<usize>,
    /// The number of the part of a tuple.
    pub(crate) number: Option<usize>,
    pub(crate) at: Span,
}

impl FieldAccess {
    /// Returns the number of the field in a value; `None` if it has no such field.
    fn of(&self, value: &Data) -> Option<usize> {
        match value {
            Data::Own(kind, _) => self.own[*kind as usize].map(|it| it as usize),
            Data::Vec3(_) => self.vec3,
            Data::Ray(_) => self.ray,
            Data::Tuple(all) => self.number.filter(|it| *it < all.len()),
            _ => None,
        }
    }
}

impl Machine<'_> {
    /// Returns the value at the end of mutable references; another value as it is.
    pub(crate) fn end_of(&self, value: &Value) -> Value {
        match &value.data {
            Data::Mut(address) => self.end_of(&self.read(address)),
            _ => value.clone(),
        }
    }

    /// Returns the value behind mutable references and boxes.
    fn unboxed(&self, value: &Value) -> Value {
        let mut value = self.end_of(value);
        while let Data::Box(inner) = &value.data {
            value = (**inner).clone();
        }
        value
    }

    /// Returns a copy of the value at an address.
    pub(crate) fn read(&self, address: &Address) -> Value {
        let root = &self.stack[address.slot as usize];
        match address.steps.split_first() {
            None => root.clone(),
            Some((&first, steps)) => {
                let first = root.part(first as usize);
                steps.iter().fold(first, |value, &n| value.part(n as usize))
            }
        }
    }

    /// Stores a value at an address.
    pub(super) fn write(&mut self, address: &Address, value: Value) {
        let mut value = Some(value);
        self.stack[address.slot as usize].reach(&address.steps, &mut |place| {
            *place = value.take().unwrap_or_default();
        });
    }

    /// Changes the value at the end of a mutable reference in its place.
    pub(crate) fn change(&mut self, reference: &Value, mut change: impl FnMut(&mut Value)) {
        let Data::Mut(address) = &reference.data else {
            unreachable!("types are checked, and this is no address");
        };
        let mut address = address.clone();
        while let Data::Mut(next) = self.read(&address).data {
            address = next;
        }
        self.stack[address.slot as usize].reach(&address.steps, &mut change);
    }

    /// Returns the address of a slot of the current frame.
    pub(crate) fn address_of(&self, slot: usize) -> Address {
        Address::of(self.base + slot)
    }

    /// Returns the address that a mutable reference holds; stops at any other value.
    pub(crate) fn address_behind(&mut self, reference: Value, at: Span) -> Eval<Address> {
        match reference.data {
            Data::Mut(address) => Ok(address),
            _ if reference.lent > 0 => self.behind(at),
            Data::Box(_) => self.unread(at, "changes through a `*` of a `Box`"),
            _ => self.no_reference(&reference, at),
        }
    }

    /// Returns the value behind a reference or in a box; stops at any other value.
    pub(crate) fn dereferenced(&mut self, value: Value, at: Span) -> Eval {
        match &value.data {
            _ if value.lent > 0 => Ok(Value {
                lent: value.lent - 1,
                ..value
            }),
            Data::Mut(address) => Ok(self.read(address)),
            Data::Box(inner) => Ok((**inner).clone()),
            _ => self.no_reference(&value, at),
        }
    }

    /// Stops since a value is no reference.
    fn no_reference<T>(&mut self, value: &Value, at: Span) -> Eval<T> {
        let name = self.named(value);
        self.wrong(at, format!("type `{name}` cannot be dereferenced"), "")
    }

    /// Stops unless the place's variable is `mut` or holds a mutable reference.
    pub(crate) fn check_mutable(&mut self, place: &PlaceExpr) -> Eval<()> {
        let (Some(slot), Some(fixed)) = (place.root, &place.fixed) else {
            return Ok(());
        };
        let root = &self.stack[self.base + slot];
        match root.data {
            Data::Mut(_) => Ok(()),
            _ if root.lent > 0 => self.behind(place.at),
            _ => self.refused(fixed.clone()),
        }
    }

    /// Follows mutable references and boxes from an address to a value that has parts; returns the
    /// address there, and the value. Stops at a shared reference.
    pub(crate) fn opened(&mut self, mut address: Address, at: Span) -> Eval<(Address, Value)> {
        loop {
            let value = self.read(&address);
            if value.lent > 0 {
                return self.behind(at);
            }
            match value.data {
                Data::Mut(next) => address = next,
                Data::Box(_) => address = address.part(0),
                _ => return Ok((address, value)),
            }
        }
    }

    /// Stops since a value behind a `&` can't be changed.
    pub(crate) fn behind<T>(&mut self, at: Span) -> Eval<T> {
        let message = "cannot change this, as it is behind a `&` reference";
        self.wrong(at, message, "`&mut` instead of `&`")
    }

    /// Returns a mutable reference to a place.
    pub(crate) fn borrowed(&mut self, place: &PlaceExpr) -> Eval {
        self.check_mutable(place)?;
        let address = (place.address)(self)?;
        if place.local.is_none() && self.read(&address).lent > 0 {
            return self.behind(place.at);
        }
        Ok(Data::Mut(address).into())
    }

    /// Assigns a value to a place, whose type it must have.
    pub(crate) fn put(&mut self, place: &PlaceExpr, new: Value, spot: ExprInfo) -> Eval {
        if let Some(slot) = place.local.map(|it| self.base + it)
            && new.is_like(&self.stack[slot])
        {
            self.stack[slot] = new;
            return Ok(Value::default());
        }
        self.check_mutable(place)?;
        let address = (place.address)(self)?;
        let old = self.read(&address);
        if !matches!(old.data, Data::Unit) || old.lent > 0 {
            self.must_be_like(&new, &old, spot)?;
        }
        drop(old);
        self.write(&address, new);
        Ok(Value::default())
    }

    /// Returns the `count` parts of a tuple; stops at any other value.
    pub(crate) fn parted(&mut self, value: &Value, count: usize, at: Span) -> Eval<Vec<Value>> {
        match &value.data {
            Data::Tuple(all) if all.len() == count => Ok(all.to_vec()),
            _ => {
                let wanted = Type(Ctor::Tuple, vec![Type::UNKNOWN; count]);
                self.mismatch(value, &wanted, at.into())
            }
        }
    }

    /// Returns a field of the variable in a slot, without a copy of the whole variable.
    #[inline]
    pub(crate) fn field_of_local(&mut self, slot: usize, field: &FieldAccess) -> Eval {
        match plain_field(&self.stack[self.base + slot], field) {
            Some(part) => Ok(part),
            None => self.field(self.local(slot), field),
        }
    }

    /// Returns a field of a value, behind references and boxes.
    pub(crate) fn field(&mut self, value: Value, field: &FieldAccess) -> Eval {
        if let Some(part) = plain_field(&value, field) {
            return Ok(part);
        }
        let whole = self.unboxed(&value);
        match field.of(&whole.data) {
            Some(n) => Ok(whole.part(n)),
            None => self.no_field(&value, field),
        }
    }

    /// Returns the number of a field in a value; stops if it has no such field.
    pub(crate) fn number(&mut self, value: &Value, field: &FieldAccess) -> Eval<usize> {
        match field.of(&value.data) {
            Some(n) => Ok(n),
            None => self.no_field(value, field),
        }
    }

    /// Stops since a value has no such field.
    fn no_field<T>(&mut self, value: &Value, field: &FieldAccess) -> Eval<T> {
        let ty = self.ty(value);
        let refusal = self.code.names.no_field(&field.name, &ty, field.at);
        self.refused(refusal)
    }

    /// Returns the element of a list or the component of a vector at an index.
    pub(crate) fn indexed(&mut self, list: &Value, index: &Value, at: Span) -> Eval {
        let list = self.unboxed(list);
        let n = self.index(&list, index, at)?;
        Ok(list.part(n))
    }

    /// Checks an index into a list or a vector, and returns it.
    pub(crate) fn index(&mut self, list: &Value, index: &Value, at: Span) -> Eval<usize> {
        let length = match &list.data {
            Data::List(list) => list.all.len(),
            Data::Vec3(_) => 3,
            _ => {
                let name = self.named(list);
                let message = format!("cannot index into a value of type `{name}`");
                return self.wrong(at, message, "");
            }
        };
        let index = match &index.data {
            Data::Int(it, int) if index.lent == 0 && int.joined(Int::Usize).is_some() => it.get(),
            _ => {
                let of = self.ty(list).inner().name(&self.code.names);
                let by = self.named(index);
                let message = format!("the type `[{of}]` cannot be indexed by `{by}`");
                return self.wrong(at, message, "an index is a `usize`");
            }
        };
        if (0..length as i128).contains(&index) {
            return Ok(index as usize);
        }
        let message = format!("index out of bounds: the len is {length} but the index is {index}");
        self.panic(at, &message)
    }
}

/// Returns a field of a struct, a vector or a ray that is not behind a box; `None` for any other
/// value.
#[inline]
fn plain_field(value: &Value, field: &FieldAccess) -> Option<Value> {
    match &value.data {
        Data::Own(kind, fields) => field.own[*kind as usize].map(|n| fields[n as usize].clone()),
        Data::Vec3(vector) => field.vec3.map(|n| vector[n].into()),
        Data::Ray(ray) => field.ray.map(|n| [ray.origin, ray.direction][n].into()),
        _ => None,
    }
}
