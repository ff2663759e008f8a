//! Addresses: where a place is, what stands there, and changes of it.

use super::Machine;
use crate::host::{Eval, Host};
use crate::node::{Field, Node, Root, Step, Target};
use crate::refusal::{At, Refusal};
use crate::value::{Address, Data, Value};

impl Machine<'_> {
    /// The value at the end of a mutable reference, or of several.
    pub(super) fn end_of(&self, value: &Value) -> Value {
        match &value.data {
            Data::Mut(address) => self.end_of(&self.read(address)),
            _ => value.clone(),
        }
    }

    /// The value at an address.
    pub(super) fn read(&self, address: &Address) -> Value {
        let root = &self.stack[address.slot as usize];
        let mut steps = address.steps.iter();
        match steps.next() {
            None => root.clone(),
            Some(&first) => {
                let first = root.part(first as usize);
                steps.fold(first, |value, &n| value.part(n as usize))
            }
        }
    }

    /// Where a place is. Mutable references and boxes on the way are followed.
    pub(super) fn address(&mut self, target: &Target) -> Eval<Address> {
        let mut address = match &target.root {
            Root::Local(slot) => Address::of(self.base + slot),
            Root::Through(reference) => match self.eval(reference)? {
                Value {
                    data: Data::Mut(address),
                    ..
                } => address,
                it if it.lent > 0 => return self.behind(target.at),
                Value {
                    data: Data::Box(_), ..
                } => {
                    let what = "changes through a `*` of a `Box`";
                    return self.refused(Refusal::unread(target.at, what));
                }
                it => {
                    let name = self.ty(&it).name(&self.code.names);
                    let message = format!("type `{name}` cannot be dereferenced");
                    return self.refused(Refusal::new(target.at, message, "", ""));
                }
            },
        };
        for step in &target.steps {
            let (whole, value) = self.opened(address, target.at)?;
            let n = match step {
                Step::Field(field) => self.number_of(field, &value)?,
                Step::Index(index, at) => {
                    let index = self.eval(index)?;
                    self.index(&value, &index, *at)?
                }
            };
            address = whole.part(n);
        }
        Ok(address)
    }

    /// Whether a place may be changed whose variable is not `mut`: it may be a mutable reference.
    pub(super) fn may_change(&mut self, target: &Target) -> Eval<()> {
        if let (Some(fixed), Root::Local(slot)) = (&target.fixed, &target.root) {
            let root = &self.stack[self.base + slot];
            return match root.data {
                Data::Mut(_) => Ok(()),
                _ if root.lent > 0 => self.behind(target.at),
                _ => self.refused(fixed.clone()),
            };
        }
        Ok(())
    }

    /// What stands at an address that is to be changed, behind references and boxes.
    pub(super) fn opened(&mut self, mut address: Address, at: At) -> Eval<(Address, Value)> {
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

    fn behind<T>(&mut self, at: At) -> Eval<T> {
        let message = "cannot change this, as it is behind a `&` reference";
        self.refused(Refusal::new(at, message, "", "`&mut` instead of `&`"))
    }

    #[inline(never)]
    pub(super) fn set(&mut self, target: &Target, value: &Node, at: At) -> Eval {
        let new = self.operand(value)?;
        if let (Root::Local(slot), []) = (&target.root, &*target.steps) {
            let slot = self.base + slot;
            if new.is_like(&self.stack[slot]) {
                self.stack[slot] = new;
                return Ok(Value::default());
            }
        }
        self.put(target, new, at, Some(value))?;
        Ok(Value::default())
    }

    /// Puts a value in the place of another of its type.
    pub(super) fn put(
        &mut self,
        target: &Target,
        new: Value,
        at: At,
        node: Option<&Node>,
    ) -> Eval<()> {
        self.may_change(target)?;
        let address = self.address(target)?;
        let old = self.read(&address);
        let is_first = matches!(old.data, Data::Unit) && old.lent == 0;
        if !is_first && !new.is_like(&old) {
            let wanted = self.ty(&old);
            return self.mismatch(&new, &wanted, at, node);
        }
        drop(old);
        let mut new = Some(new);
        self.stack[address.slot as usize].reach(&address.steps, &mut |place| {
            *place = new.take().unwrap_or_default();
        });
        Ok(())
    }

    #[inline(never)]
    pub(super) fn set_all(&mut self, targets: &[(Option<Target>, At)], value: &Node) -> Eval {
        let value = self.eval(value)?;
        let all = match &value.data {
            Data::Tuple(all) if all.len() == targets.len() => all.clone(),
            _ => {
                let unknown = vec![crate::types::Type::UNKNOWN; targets.len()];
                let wanted = crate::types::Type(crate::types::Head::Tuple, unknown);
                let at = targets.first().map_or(At::default(), |it| it.1);
                return self.mismatch(&value, &wanted, at, None);
            }
        };
        for ((target, at), value) in targets.iter().zip(all.iter()) {
            if let Some(target) = target {
                self.put(target, value.clone(), *at, None)?;
            }
        }
        Ok(Value::default())
    }

    /// A part of a value, without a copy of the whole.
    #[inline(never)]
    pub(super) fn field(&mut self, of: &Node, field: &Field) -> Eval {
        let evaluated;
        let value = match of {
            Node::Local(slot) => &self.stack[self.base + slot],
            of => {
                evaluated = self.eval(of)?;
                &evaluated
            }
        };
        let part = match &value.data {
            Data::Own(kind, fields) => {
                field.own[*kind as usize].map(|n| fields[n as usize].clone())
            }
            Data::Vec3(vector) => field.vec3.map(|n| vector[n].into()),
            Data::Ray(ray) => field.ray.map(|n| [ray.origin, ray.direction][n].into()),
            _ => None,
        };
        match part {
            Some(part) => Ok(part),
            None => {
                let value = value.clone();
                self.other_field(value, field)
            }
        }
    }

    /// The same behind references and boxes.
    fn other_field(&mut self, value: Value, field: &Field) -> Eval {
        let mut whole = self.end_of(&value);
        while let Data::Box(inner) = &whole.data {
            whole = (**inner).clone();
        }
        match self.number(field, &whole) {
            Some(n) => Ok(whole.part(n)),
            None => self.no_field(field, &value),
        }
    }

    fn number(&self, field: &Field, value: &Value) -> Option<usize> {
        match &value.data {
            Data::Own(kind, _) => field.own[*kind as usize].map(|it| it as usize),
            Data::Vec3(_) => field.vec3,
            Data::Ray(_) => field.ray,
            Data::Tuple(all) => field.number.filter(|it| *it < all.len()),
            _ => None,
        }
    }

    fn number_of(&mut self, field: &Field, value: &Value) -> Eval<usize> {
        match self.number(field, value) {
            Some(n) => Ok(n),
            None => self.no_field(field, value),
        }
    }

    fn no_field<T>(&mut self, field: &Field, value: &Value) -> Eval<T> {
        let ty = self.ty(value);
        let refusal = self.code.names.no_field(&field.name, &ty, field.at);
        self.refused(refusal)
    }

    #[inline(never)]
    pub(super) fn indexed(&mut self, nodes: &[Node; 2], at: At) -> Eval {
        let [list, index] = [self.eval(&nodes[0])?, self.eval(&nodes[1])?];
        let mut list = self.end_of(&list);
        while let Data::Box(inner) = &list.data {
            list = (**inner).clone();
        }
        let n = self.index(&list, &index, at)?;
        Ok(list.part(n))
    }

    fn index(&mut self, list: &Value, index: &Value, at: At) -> Eval<usize> {
        let length = match &list.data {
            Data::List(list) => list.all.len(),
            Data::Vec3(_) => 3,
            _ => {
                let name = self.ty(list).name(&self.code.names);
                let message = format!("cannot index into a value of type `{name}`");
                return self.refused(Refusal::new(at, message, "", ""));
            }
        };
        let usize = crate::types::Int::Usize;
        let index = match &index.data {
            Data::Int(it, int) if index.lent == 0 && int.joined(usize).is_some() => it.get(),
            _ => {
                let names = &self.code.names;
                let (of, by) = (
                    self.ty(list).inner().name(names),
                    self.ty(index).name(names),
                );
                let message = format!("the type `[{of}]` cannot be indexed by `{by}`");
                return self.refused(Refusal::new(at, message, "an index is a `usize`", ""));
            }
        };
        if (0..length as i128).contains(&index) {
            return Ok(index as usize);
        }
        let message = format!("index out of bounds: the len is {length} but the index is {index}");
        self.panic(at, &message)
    }

    #[inline(never)]
    pub(super) fn dereferenced(&mut self, of: &Node, at: At) -> Eval {
        let value = self.eval(of)?;
        if value.lent > 0 {
            return Ok(Value {
                lent: value.lent - 1,
                ..value
            });
        }
        match &value.data {
            Data::Mut(address) => Ok(self.read(address)),
            Data::Box(inner) => Ok((**inner).clone()),
            _ => {
                let name = self.ty(&value).name(&self.code.names);
                let message = format!("type `{name}` cannot be dereferenced");
                self.refused(Refusal::new(at, message, "", ""))
            }
        }
    }

    /// A mutable reference to a place.
    #[inline(never)]
    pub(super) fn borrowed(&mut self, target: &Target) -> Eval {
        self.may_change(target)?;
        let address = self.address(target)?;
        if self.read(&address).lent > 0 && !target.steps.is_empty() {
            return self.behind(target.at);
        }
        Ok(Data::Mut(address).into())
    }

    /// Adds to a text in its place.
    pub(super) fn append(&mut self, address: Address, more: &str, at: At) -> Eval<()> {
        self.take(more.len(), at)?;
        self.change(&Data::Mut(address).into(), &mut |text| {
            if let Data::Str(text) = &mut text.data {
                std::rc::Rc::make_mut(text).push_str(more);
            }
        });
        Ok(())
    }
}
