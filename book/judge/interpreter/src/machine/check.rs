//! Type checks: a value where something is declared, and what the compiler says of it.

use std::rc::Rc;

use super::Machine;
use crate::host::Eval;
use crate::node::{Arguments, Node};
use crate::refusal::{At, Refusal};
use crate::types::{Head, Int, Type};
use crate::value::{Data, Value};

impl Machine<'_> {
    /// A value as what is declared. Where its node is known, that says more.
    #[inline]
    pub(super) fn as_declared(
        &mut self,
        value: Value,
        ty: &Type,
        at: At,
        node: Option<&Node>,
    ) -> Eval {
        if is_plainly(&value, ty) {
            Ok(value)
        } else {
            self.converted(value, ty, at, node)
        }
    }

    #[inline(never)]
    fn converted(&mut self, value: Value, ty: &Type, at: At, node: Option<&Node>) -> Eval {
        if let (Data::Float(it), Head::F32, Some(Node::Float(_))) = (&value.data, ty.0, node) {
            return Ok(Data::Single(*it as f32).into());
        }
        if !self.fits(&value, ty) {
            return self.mismatch(&value, ty, at, node);
        }
        Ok(match (&value.data, ty.0) {
            (Data::Int(it, Int::Any), Head::Int(int)) if int.has(it.get()) => {
                Value::whole(it.get(), int)
            }
            (Data::Int(_, Int::Any), Head::Int(_)) => {
                return self.panic(at, "attempt to compute a number with overflow");
            }
            // A mutable reference is a shared one, too.
            (Data::Mut(_), Head::Ref) => self.end_of(&value).owned().lent(),
            (_, Head::Ref) if value.lent > 0 => self.reborrowed(value, ty),
            (Data::List(list), Head::Vec) if list.of.is_unknown() && value.lent == 0 => {
                let mut list = Rc::clone(list);
                drop(value);
                Rc::make_mut(&mut list).of = ty.inner().clone();
                Data::List(list).into()
            }
            _ => value,
        })
    }

    /// A reference as far as the declared one goes: others and boxes are followed.
    fn reborrowed(&self, mut value: Value, ty: &Type) -> Value {
        let (mut lent, mut of) = (0, ty);
        while of.is(Head::Ref) {
            lent += 1;
            of = of.inner();
        }
        if of.is_unknown() {
            return value;
        }
        while let (Data::Box(inner), false) = (&value.data, of.is(Head::Box)) {
            value = (**inner).clone();
        }
        Value { lent, ..value }
    }

    /// Whether a value may be where that type is declared.
    pub(super) fn fits(&self, value: &Value, ty: &Type) -> bool {
        self.lent_fits(value.lent, &value.data, ty)
    }

    fn lent_fits(&self, lent: u8, data: &Data, ty: &Type) -> bool {
        match (lent, ty.0) {
            (_, Head::Unknown) => true,
            (0, Head::Ref) => matches!(data, Data::Mut(_)),
            (_, Head::Ref) if ty.inner().is(Head::Ref) => {
                self.lent_fits(lent - 1, data, ty.inner())
            }
            (_, Head::Ref) => self.fits_behind(data, ty.inner()),
            (_, Head::Fn) => {
                matches!(
                    data,
                    Data::Closure(..) | Data::Function(_) | Data::Native(_)
                )
            }
            (0, _) => self.data_fits(data, ty),
            _ => false,
        }
    }

    /// Whether that is what a reference leads to, boxes and lists being seen through.
    fn fits_behind(&self, data: &Data, ty: &Type) -> bool {
        match (data, ty.0) {
            (Data::List(list), Head::Slice) => self.parts_fit(list, ty.inner()),
            (Data::Box(of), head) if head != Head::Box => self.fits_behind(&of.data, ty),
            _ => self.data_fits(data, ty),
        }
    }

    fn data_fits(&self, data: &Data, ty: &Type) -> bool {
        match (data, ty.0) {
            (Data::Float(_), Head::F64)
            | (Data::Single(_), Head::F32)
            | (Data::Bool(_), Head::Bool)
            | (Data::Vec3(_), Head::Vec3)
            | (Data::Ray(_), Head::Ray)
            | (Data::Picture(_), Head::Picture)
            | (Data::Str(_), Head::Str)
            | (Data::Ordering(_), Head::Ordering)
            | (Data::None, Head::Option)
            | (Data::Iter(_), Head::Iterator)
            | (Data::Mut(_), Head::RefMut) => true,
            (Data::Int(_, one), Head::Int(other)) => one.joined(other).is_some(),
            (Data::Own(kind, _), Head::Own(other)) => *kind == other,
            (Data::Some(of), Head::Option) | (Data::Box(of), Head::Box) => {
                self.fits(of, ty.inner())
            }
            (Data::Unit, Head::Tuple) => ty.1.is_empty(),
            (Data::Tuple(all), Head::Tuple) => {
                let mut both = all.iter().zip(&ty.1);
                all.len() == ty.1.len() && both.all(|(it, ty)| self.fits(it, ty))
            }
            (Data::List(list), Head::Vec) => !list.is_array && self.parts_fit(list, ty.inner()),
            (Data::List(list), Head::Array(length)) => {
                list.is_array && list.all.len() == length && self.parts_fit(list, ty.inner())
            }
            (Data::Range(ends, _), Head::Range) => self.fits(&ends[0], ty.inner()),
            (Data::Closure(..) | Data::Function(_) | Data::Native(_), Head::Fn) => true,
            (data, Head::Dyn(of)) => {
                let head = Value::from(data.clone()).head();
                self.code.names.implements(head, of)
            }
            _ => false,
        }
    }

    fn parts_fit(&self, list: &crate::value::List, ty: &Type) -> bool {
        list.of == *ty || list.all.first().is_none_or(|it| self.fits(it, ty))
    }

    /// Checks the arguments of a function that are on the stack, all that come after some. They
    /// stand at one place.
    pub(super) fn arrive(
        &mut self,
        function: usize,
        start: usize,
        after: usize,
        at: At,
    ) -> Eval<()> {
        let code = self.code;
        let wanted = &code.names.functions[function].parameters;
        let slots = start + after..start + wanted.len();
        for (slot, ty) in slots.zip(&wanted[after..]) {
            let value = std::mem::take(&mut self.stack[slot]);
            self.stack[slot] = self.as_declared(value, ty, at, None)?;
        }
        Ok(())
    }

    /// The same where each has its place.
    pub(super) fn arrive_as(
        &mut self,
        function: usize,
        start: usize,
        after: usize,
        given: &Arguments,
    ) -> Eval<()> {
        let code = self.code;
        let wanted = &code.names.functions[function].parameters;
        for (n, ty) in wanted[after..].iter().enumerate() {
            if is_plainly(&self.stack[start + after + n], ty) {
                continue;
            }
            let value = std::mem::take(&mut self.stack[start + after + n]);
            let value = self.as_declared(value, ty, given.places[n], Some(&given.nodes[n]))?;
            self.stack[start + after + n] = value;
        }
        Ok(())
    }

    pub(super) fn mismatch<T>(
        &mut self,
        value: &Value,
        ty: &Type,
        at: At,
        node: Option<&Node>,
    ) -> Eval<T> {
        if let (Data::Float(_) | Data::Single(_), Head::F32 | Head::F64) = (&value.data, ty.0)
            && value.lent == 0
        {
            let what = "a number that may be an `f32` or an `f64`";
            return self.refused(Refusal::unread(at, what));
        }
        let found = self.ty(value);
        let said = match node {
            Some(Node::Float(_)) => "floating-point number".to_owned(),
            _ => found.said(&self.code.names),
        };
        let help = match node {
            Some(Node::Lend(_)) if self.lent_fits(value.lent - 1, &value.data, ty) => {
                "consider removing the borrow"
            }
            _ => "",
        };
        let refusal = self.code.names.mismatch(ty, &found, &said, at);
        self.refused(refusal.or_help(help))
    }

    /// The type of a value, as far as it shows that.
    pub(super) fn ty(&self, value: &Value) -> Type {
        let of = |it: Option<&Value>| it.map_or(Type::UNKNOWN, |it| self.ty(it));
        let head = value.head();
        let ty = match &value.data {
            Data::None => Type::of(head, Type::UNKNOWN),
            Data::Some(it) | Data::Box(it) => Type::of(head, self.ty(it)),
            Data::Tuple(all) => Type(head, all.iter().map(|it| self.ty(it)).collect()),
            Data::List(list) if list.of.is_unknown() => Type::of(head, of(list.all.first())),
            Data::List(list) => Type::of(head, list.of.clone()),
            Data::Range(ends, _) => Type::of(head, self.ty(&ends[0])),
            Data::Mut(_) => Type::of(head, self.ty(&self.end_of(&value.clone().owned()))),
            Data::Closure(it, _) => Type(head, vec![Type::UNKNOWN; it.parameters.len() + 1]),
            Data::Function(n) => {
                let own = &self.code.names.functions[*n];
                let result = [own.result.clone()];
                Type(head, own.parameters.iter().cloned().chain(result).collect())
            }
            Data::Native(n) => {
                let native = crate::library::native(*n);
                let count = native.takes.len() + usize::from(native.on.is_some());
                Type(head, vec![Type::UNKNOWN; count + 1])
            }
            _ => head.into(),
        };
        (0..value.lent).fold(ty, |ty, _| Type::of(Head::Ref, ty))
    }

    /// What `Default` gives for a type.
    pub(crate) fn default(&mut self, ty: &Type, at: At) -> Eval {
        let code = self.code;
        Ok(match ty.0 {
            Head::Bool => false.into(),
            Head::F64 => 0.0.into(),
            Head::F32 => Data::Single(0.0).into(),
            Head::Int(int) => Value::whole(0, int),
            Head::Vec3 => common::rtweekend::Vec3::ZERO.into(),
            Head::Str => Value::str(""),
            Head::Option => None.into(),
            Head::Vec => {
                let list = Value::vector(Vec::new());
                self.as_declared(list, ty, at, None)?
            }
            Head::Box => {
                let inner = self.default(&ty.1[0], at)?;
                Data::Box(Rc::new(inner)).into()
            }
            Head::Tuple => {
                let all = ty.1.iter().map(|it| self.default(it, at));
                match all.collect::<Eval<Rc<[Value]>>>()? {
                    all if all.is_empty() => Value::default(),
                    all => Data::Tuple(all).into(),
                }
            }
            Head::Own(kind) => match code.names.kinds[kind as usize].default {
                Some(own) => self.run(own, &[], at)?,
                None => {
                    let fields = code.names.kinds[kind as usize].fields.iter();
                    let fields = fields.map(|it| self.default(&it.ty, at));
                    Data::Own(kind, fields.collect::<Eval<_>>()?).into()
                }
            },
            _ => {
                let what = format!("a default for `{}`", ty.name(&code.names));
                return self.refused(Refusal::unread(at, &what));
            }
        })
    }
}

/// Whether a value is what is declared without more ado, as most are.
#[inline]
fn is_plainly(value: &Value, ty: &Type) -> bool {
    let is_same = |ty: &Type| match (&value.data, ty.0) {
        (Data::Float(_), Head::F64)
        | (Data::Vec3(_), Head::Vec3)
        | (Data::Ray(_), Head::Ray)
        | (Data::None, Head::Option) => true,
        (Data::Own(kind, _), Head::Own(other)) => *kind == other,
        _ => false,
    };
    match ty.0 {
        Head::Unknown => true,
        Head::Ref => value.lent == 1 && is_same(&ty.1[0]),
        Head::Option => match &value.data {
            Data::Some(it) if value.lent == 0 => is_plainly(it, &ty.1[0]),
            Data::None => value.lent == 0,
            _ => false,
        },
        _ => value.lent == 0 && is_same(ty),
    }
}
