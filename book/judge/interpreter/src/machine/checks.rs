//! Type checks at run time: whether a value fits a declared type, and the compiler's words if not.

use std::rc::Rc;

use super::value::{Data, ListValue, Value};
use super::{Eval, ExprForm, ExprInfo, Machine};
use crate::refusal::{Refusal, Span, arguments};
use crate::types::{Ctor, Int, Type};

impl Machine<'_> {
    /// Checks that a value fits a declared type, and converts it as the compiler's inference would:
    /// an integer literal to its type, `&mut` to `&`; a `Vec` whose elements have no declared type
    /// so far gets this one.
    #[inline]
    pub(crate) fn as_declared(&mut self, value: Value, ty: &Type, spot: ExprInfo) -> Eval {
        if is_plainly(&value, ty) {
            Ok(value)
        } else {
            self.converted(value, ty, spot)
        }
    }

    /// Does the rarer half of `as_declared`.
    #[inline(never)]
    fn converted(&mut self, value: Value, ty: &Type, spot: ExprInfo) -> Eval {
        if let (Data::Float(it), Ctor::F32, ExprForm::Float) = (&value.data, ty.0, spot.form) {
            return Ok((*it as f32).into());
        }
        if !self.fits(&value, ty) {
            return self.mismatch(&value, ty, spot);
        }
        Ok(match (&value.data, ty.0) {
            (Data::Int(it, Int::Any), Ctor::Int(int)) => {
                if !int.has(it.get()) {
                    let message = "attempt to compute a number with overflow";
                    return self.panic(spot.at, message);
                }
                Value::whole(it.get(), int)
            }
            // A mutable reference is a shared one, too.
            (Data::Mut(_), Ctor::Ref) => self.end_of(&value).owned().lent(),
            (_, Ctor::Ref) if value.lent > 0 => reborrowed(value, ty),
            (Data::List(list), Ctor::Vec) if list.of.is_unknown() && value.lent == 0 => {
                let mut list = Rc::clone(list);
                drop(value);
                Rc::make_mut(&mut list).of = ty.inner().clone();
                Data::List(list).into()
            }
            (_, Ctor::Fn) => {
                self.takes_as_many(&value, ty.1.len() - 1, spot.at)?;
                value
            }
            _ => value,
        })
    }

    /// Checks that a function value takes as many arguments as its declared type.
    fn takes_as_many(&mut self, function: &Value, count: usize, at: Span) -> Eval<()> {
        let function = self.end_of(function);
        let Some((what, takes)) = self.parameters(&function).filter(|it| it.1 != count) else {
            return Ok(());
        };
        let [wanted, takes] = [count, takes].map(arguments);
        let message = format!("{what} is expected to take {wanted}, but it takes {takes}");
        self.wrong(at, message, "")
    }

    /// Returns true if a value may stand where this type is declared.
    pub(super) fn fits(&self, value: &Value, ty: &Type) -> bool {
        self.lent_fits(value.lent, &value.data, ty)
    }

    /// Returns true if data behind that many `&` may stand where this type is declared.
    fn lent_fits(&self, lent: u8, data: &Data, ty: &Type) -> bool {
        match (lent, ty.0) {
            (_, Ctor::Unknown) => true,
            (0, Ctor::Ref) => matches!(data, Data::Mut(_)),
            (_, Ctor::Ref) if ty.inner().is(Ctor::Ref) => {
                self.lent_fits(lent - 1, data, ty.inner())
            }
            (_, Ctor::Ref) => self.fits_behind(data, ty.inner()),
            (_, Ctor::Fn) | (0, _) => self.data_fits(data, ty),
            _ => false,
        }
    }

    /// Returns true if data may stand behind a reference to this type: through boxes, and lists for
    /// slices.
    fn fits_behind(&self, data: &Data, ty: &Type) -> bool {
        match (data, ty.0) {
            (Data::List(list), Ctor::Slice) => self.parts_fit(list, ty.inner()),
            (Data::Box(of), ctor) if ctor != Ctor::Box => self.fits_behind(&of.data, ty),
            _ => self.data_fits(data, ty),
        }
    }

    /// Returns true if data that is not lent may stand where this type is declared.
    fn data_fits(&self, data: &Data, ty: &Type) -> bool {
        match (data, ty.0) {
            (Data::Int(_, one), Ctor::Int(other)) => one.joined(other).is_some(),
            (Data::Some(of), Ctor::Option) | (Data::Box(of), Ctor::Box) => {
                self.fits(of, ty.inner())
            }
            (Data::Unit, Ctor::Tuple) => ty.1.is_empty(),
            (Data::Tuple(all), Ctor::Tuple) => {
                let mut both = all.iter().zip(&ty.1);
                all.len() == ty.1.len() && both.all(|(it, ty)| self.fits(it, ty))
            }
            (Data::List(list), Ctor::Vec) => !list.is_array && self.parts_fit(list, ty.inner()),
            (Data::List(list), Ctor::Array(length)) => {
                list.is_array && list.all.len() == length && self.parts_fit(list, ty.inner())
            }
            (Data::Range(ends, _), Ctor::Range) => self.fits(&ends[0], ty.inner()),
            (data, Ctor::Dyn(of)) => self.code.names.implements(data.ctor(), of),
            // What is made of nothing else.
            (data, ctor) => data.ctor() == ctor,
        }
    }

    /// Returns true if the elements of a list are of this type, as the first shows.
    fn parts_fit(&self, list: &ListValue, ty: &Type) -> bool {
        list.of == *ty || list.all.first().is_none_or(|it| self.fits(it, ty))
    }

    /// Stops since a value has another type than the expected one, in the compiler's words.
    pub(crate) fn mismatch<T>(&mut self, value: &Value, ty: &Type, spot: ExprInfo) -> Eval<T> {
        if let (Data::Float(_) | Data::Single(_), Ctor::F32 | Ctor::F64) = (&value.data, ty.0)
            && value.lent == 0
        {
            return self.unread(spot.at, "a number that may be an `f32` or an `f64`");
        }
        let found = self.ty(value);
        let said = match spot.form {
            ExprForm::Float => "floating-point number".to_owned(),
            _ => found.said(&self.code.names),
        };
        let refusal = self.code.names.mismatch(ty, &found, &said, spot.at);
        let is_lent = spot.form == ExprForm::Lend && value.lent > 0;
        self.refused(
            match is_lent && self.lent_fits(value.lent - 1, &value.data, ty) {
                true => refusal.or_help("consider removing the borrow"),
                false => refusal,
            },
        )
    }

    /// Stops unless a value has the type of a known one, so that both may be in one place.
    pub(crate) fn must_be_like(
        &mut self,
        value: &Value,
        known: &Value,
        spot: ExprInfo,
    ) -> Eval<()> {
        if value.is_like(known) {
            return Ok(());
        }
        let wanted = self.ty(known);
        self.mismatch(value, &wanted, spot)
    }

    /// Returns the type of a value, as far as the value shows it: the elements of an empty list are
    /// unknown.
    pub(crate) fn ty(&self, value: &Value) -> Type {
        let of = |it: Option<&Value>| it.map_or(Type::UNKNOWN, |it| self.ty(it));
        let ctor = value.data.ctor();
        let ty = match &value.data {
            Data::None => Type::of(ctor, Type::UNKNOWN),
            Data::Some(it) | Data::Box(it) => Type::of(ctor, self.ty(it)),
            Data::Tuple(all) => Type(ctor, all.iter().map(|it| self.ty(it)).collect()),
            Data::List(list) if list.of.is_unknown() => Type::of(ctor, of(list.all.first())),
            Data::List(list) => Type::of(ctor, list.of.clone()),
            Data::Range(ends, _) => Type::of(ctor, self.ty(&ends[0])),
            Data::Mut(_) => Type::of(ctor, self.ty(&self.end_of(&value.clone().owned()))),
            Data::Function(n) => {
                let own = &self.code.names.functions[*n];
                let result = [own.result.clone()];
                Type(ctor, own.parameters.iter().cloned().chain(result).collect())
            }
            Data::Closure(..) | Data::Native(_) => {
                Type::function(self.parameters(value).map_or(0, |it| it.1))
            }
            _ => ctor.into(),
        };
        (0..value.lent).fold(ty, |ty, _| Type::of(Ctor::Ref, ty))
    }

    /// Returns the name of a value's type, for a message.
    pub(crate) fn named(&self, value: &Value) -> String {
        self.ty(value).name(&self.code.names)
    }

    /// Computes the `Default` of a type.
    pub(crate) fn default(&mut self, ty: &Type, at: Span) -> Eval {
        let code = self.code;
        Ok(match ty.0 {
            Ctor::Bool => false.into(),
            Ctor::F64 => 0.0.into(),
            Ctor::F32 => 0.0_f32.into(),
            Ctor::Int(int) => Value::whole(0, int),
            Ctor::Vec3 => common::rtweekend::Vec3::ZERO.into(),
            Ctor::Str => Value::str(""),
            Ctor::Option => None.into(),
            Ctor::Vec => self.as_declared(Value::vector(Vec::new()), ty, at.into())?,
            Ctor::Box => Data::Box(Rc::new(self.default(&ty.1[0], at)?)).into(),
            Ctor::Tuple if ty.1.is_empty() => Value::default(),
            Ctor::Tuple => {
                let all = ty.1.iter().map(|it| self.default(it, at));
                Value::tuple(all.collect::<Eval<Vec<_>>>()?)
            }
            Ctor::Own(kind) => match code.names.structs[kind as usize].default {
                Some(own) => self.run(own, &[], at)?,
                None => {
                    let fields = &code.names.structs[kind as usize].fields;
                    let mut all = Vec::with_capacity(fields.len());
                    for field in fields {
                        all.push(self.default(&field.ty, at)?);
                    }
                    Data::Own(kind, all.into()).into()
                }
            },
            _ => {
                let what = format!("a default for `{}`", ty.name(&code.names));
                return self.refused(Refusal::unread(at, &what));
            }
        })
    }
}

/// Follows the references and boxes that a value has beyond those of the declared type.
fn reborrowed(mut value: Value, ty: &Type) -> Value {
    let (mut lent, mut of) = (0, ty);
    while of.is(Ctor::Ref) {
        lent += 1;
        of = of.inner();
    }
    if of.is_unknown() {
        return value;
    }
    while let (Data::Box(inner), false) = (&value.data, of.is(Ctor::Box)) {
        value = (**inner).clone();
    }
    Value { lent, ..value }
}

/// Returns true if a value certainly has the declared type: the fast path of most checks. False
/// says nothing.
#[inline]
pub(super) fn is_plainly(value: &Value, ty: &Type) -> bool {
    let is_same = |ty: &Type| match (&value.data, ty.0) {
        (Data::Float(_), Ctor::F64)
        | (Data::Vec3(_), Ctor::Vec3)
        | (Data::Ray(_), Ctor::Ray)
        | (Data::Bool(_), Ctor::Bool)
        | (Data::None, Ctor::Option) => true,
        (Data::Own(kind, _), Ctor::Own(other)) => *kind == other,
        (Data::Closure(it, _), Ctor::Fn) => it.parameters + 1 == ty.1.len(),
        _ => false,
    };
    match ty.0 {
        Ctor::Unknown => true,
        Ctor::Ref => value.lent == 1 && is_same(&ty.1[0]),
        Ctor::Option => match &value.data {
            Data::Some(it) if value.lent == 0 => is_plainly(it, &ty.1[0]),
            Data::None => value.lent == 0,
            _ => false,
        },
        _ => value.lent == 0 && is_same(ty),
    }
}
