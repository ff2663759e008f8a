//! Operators at run time: the values that each accepts, its result, and the compiler's words for
//! values that it refuses.

use std::mem;
use std::ops::{Add, Div, Mul, Rem, Sub};
use std::rc::Rc;
use std::slice;

use common::rtweekend::Vec3;

use super::places::PlaceExpr;
use super::value::{Data, Value};
use super::{Eval, ExprForm, ExprInfo, Machine};
use crate::operators::{ArithOp, CompareOp};
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

impl Machine<'_> {
    /// Rounds a result to an `f32` if the program runs in single precision.
    #[inline]
    pub(crate) fn rounded(&self, it: f64) -> f64 {
        if self.code.is_single {
            f64::from(it as f32)
        } else {
            it
        }
    }

    /// Rounds the components of a vector to `f32` if the program runs in single precision.
    #[inline]
    fn all_rounded(&self, it: Vec3) -> Vec3 {
        Vec3::from_array(it.to_array().map(|it| self.rounded(it)))
    }

    /// Applies an arithmetic operator to two floats.
    #[inline]
    pub(crate) fn of_floats(&self, sign: ArithOp, a: f64, b: f64) -> Value {
        self.rounded(combine(sign, a, b)).into()
    }

    /// Applies an arithmetic operator to two values.
    #[inline]
    pub(crate) fn combined(&mut self, sign: ArithOp, left: Value, right: Value, at: Span) -> Eval {
        if let (Data::Float(a), Data::Float(b)) = (&left.data, &right.data) {
            let result = self.of_floats(sign, *a, *b);
            // They have nothing to drop.
            mem::forget((left, right));
            return Ok(result);
        }
        self.rarely_combined(sign, left, right, at)
    }

    /// Applies an arithmetic operator to two values that are not both floats.
    #[inline(never)]
    fn rarely_combined(&mut self, sign: ArithOp, left: Value, right: Value, at: Span) -> Eval {
        let vector = |own: &Self, a, b| Ok(own.all_rounded(combine(sign, a, b)).into());
        match (&left.data, &right.data) {
            (Data::Vec3(a), Data::Vec3(b)) => vector(self, *a, *b),
            (Data::Vec3(a), Data::Float(b)) => vector(self, *a, Vec3::splat(*b)),
            (Data::Float(a), Data::Vec3(b)) => vector(self, Vec3::splat(*a), *b),
            (Data::Single(a), Data::Single(b)) => Ok(combine(sign, *a, *b).into()),
            (Data::Str(a), Data::Str(b))
                if sign == ArithOp::Plus && left.lent == 0 && right.lent > 0 =>
            {
                self.take(a.len() + b.len(), at)?;
                Ok(Value::str(format!("{a}{b}")))
            }
            (Data::Int(a, one), Data::Int(b, other)) if one.joined(*other).is_some() => {
                let int = one.joined(*other).unwrap_or(*one);
                let result = self.integer(sign, a.get(), b.get(), at)?;
                if !int.has(result) {
                    return self.panic(at, &sign.overflow());
                }
                Ok(Value::whole(result, int))
            }
            (Data::Mut(_), _) | (_, Data::Mut(_)) => {
                let [left, right] = [left, right].map(|it| self.end_of(&it));
                self.combined(sign, left, right, at)
            }
            _ => match self.operator(sign, false, [&left, &right]) {
                Some(own) => self.run(own, &[left, right], at),
                None => self.no_operator(sign, false, [&left, &right], at),
            },
        }
    }

    /// Applies an arithmetic operator to two integers; the caller checks if the result fits its
    /// type.
    fn integer(&mut self, sign: ArithOp, a: i128, b: i128, at: Span) -> Eval<i128> {
        Ok(match sign {
            ArithOp::Over if b == 0 => return self.panic(at, "attempt to divide by zero"),
            ArithOp::Remainder if b == 0 => {
                let message = "attempt to calculate the remainder with a divisor of zero";
                return self.panic(at, message);
            }
            ArithOp::Times => a.saturating_mul(b),
            sign => combine(sign, a, b),
        })
    }

    /// Returns the number of the text's function for an operator between these values.
    fn operator(&self, sign: ArithOp, is_assignment: bool, values: [&Value; 2]) -> Option<usize> {
        let names = &self.code.names;
        let is_it = |it: &&(ArithOp, bool, usize)| {
            let wanted = &names.functions[it.2].parameters;
            let left = match is_assignment {
                true => wanted[0].inner(),
                false => &wanted[0],
            };
            (it.0, it.1) == (sign, is_assignment)
                && self.fits(values[0], left)
                && self.fits(values[1], &wanted[1])
        };
        names.operators.iter().find(is_it).map(|it| it.2)
    }

    /// Stops since no operator takes these two values.
    fn no_operator<T>(
        &mut self,
        sign: ArithOp,
        is_assignment: bool,
        values: [&Value; 2],
        at: Span,
    ) -> Eval<T> {
        let heads = values.map(|it| it.data.ctor());
        if heads.contains(&Ctor::F32) && heads.contains(&Ctor::F64) {
            return self.unread(at, "a number that may be an `f32` or an `f64`");
        }
        let [one, other] = values.map(|it| self.named(it));
        let is_integer = |it: &Ctor| matches!(it, Ctor::Int(_));
        let is_number = |it: &Ctor| is_integer(it) || matches!(it, Ctor::F64 | Ctor::Vec3);
        let is_mixed = is_integer(&heads[0]) != is_integer(&heads[1]);
        let help = if !(is_mixed && heads.iter().all(is_number)) {
            ""
        } else if one == "{integer}" || other == "{integer}" {
            "consider using a floating-point literal, such as `2.0`"
        } else {
            "convert the integer: `f64::from(…)`, or `… as f64`"
        };
        self.wrong(at, sign.refused(is_assignment, &one, &other), help)
    }

    /// Changes a place by `+=` or the like.
    pub(crate) fn updated(
        &mut self,
        place: &PlaceExpr,
        sign: ArithOp,
        right: Value,
        (right_spot, at): (ExprInfo, Span),
    ) -> Eval {
        self.check_mutable(place)?;
        let address = (place.address)(self)?;
        let left = self.read(&address);
        match (&left.data, &right.data) {
            (Data::Own(..), _) if left.lent == 0 => {
                let Some(own) = self.operator(sign, true, [&left, &right]) else {
                    return self.no_operator(sign, true, [&left, &right], at);
                };
                return self.run(own, &[Data::Mut(address).into(), right], at);
            }
            (Data::Str(_), Data::Str(more)) => {
                let more = Rc::clone(more);
                drop(left);
                return self.append(&Data::Mut(address).into(), &more, at);
            }
            (Data::Mut(_), _) => return self.no_operator(sign, true, [&left, &right], at),
            _ if left.lent > 0 => return self.no_operator(sign, true, [&left, &right], at),
            _ => {}
        }
        let [left, right] = alike([left, right], [false, right_spot.form == ExprForm::Float]);
        let result = self.combined(sign, left.clone(), right.clone(), at)?;
        if !result.is_like(&left) {
            return self.no_operator(sign, true, [&left, &right], at);
        }
        drop(left);
        self.write(&address, result);
        Ok(Value::default())
    }

    /// Appends to the text behind a mutable reference.
    pub(crate) fn append(&mut self, text: &Value, more: &str, at: Span) -> Eval {
        self.take(more.len(), at)?;
        self.change(text, |text| {
            if let Data::Str(text) = &mut text.data {
                Rc::make_mut(text).push_str(more);
            }
        });
        Ok(Value::default())
    }

    /// Applies `&`, `|` or `^` to two booleans; stops at integers, since a `^` between them may be
    /// meant as a power.
    pub(crate) fn bits(&mut self, sign: &str, values: [Value; 2], at: Span) -> Eval {
        if let [Data::Bool(one), Data::Bool(other)] = [&values[0].data, &values[1].data] {
            let truth = match sign {
                "&" => one & other,
                "|" => one | other,
                _ => one ^ other,
            };
            return Ok(truth.into());
        }
        if values.iter().all(|it| matches!(it.data, Data::Int(..))) {
            return self.unread(at, &format!("`{sign}`"));
        }
        let [one, other] = values.map(|it| self.named(&it));
        let message = format!("no implementation for `{one} {sign} {other}`");
        self.wrong(at, message, "")
    }

    /// Applies `!` to a boolean.
    pub(crate) fn not(&mut self, value: &Value, at: Span) -> Eval {
        match self.end_of(value).data {
            Data::Bool(it) => Ok((!it).into()),
            Data::Int(..) => self.unread(at, "`!` of integers"),
            _ => self.no_unary("!", value, at),
        }
    }

    /// Applies `-` to a value.
    pub(crate) fn negated(&mut self, value: &Value, at: Span) -> Eval {
        Ok(match &value.data {
            Data::Float(it) => (-it).into(),
            Data::Vec3(it) => (-*it).into(),
            Data::Single(it) => (-it).into(),
            Data::Int(it, int) if int.ends().0 < 0 => match int.has(-it.get()) {
                true => Value::whole(-it.get(), *int),
                false => return self.panic(at, "attempt to negate with overflow"),
            },
            Data::Mut(_) => return self.no_unary("-", value, at),
            _ => {
                let names = &self.code.names;
                let fits = |&&it: &&usize| self.fits(value, &names.functions[it].parameters[0]);
                match names.negations.iter().find(fits) {
                    Some(own) => self.run(*own, slice::from_ref(value), at)?,
                    None => return self.no_unary("-", value, at),
                }
            }
        })
    }

    /// Stops since a value has no such unary operator.
    fn no_unary(&mut self, sign: &str, value: &Value, at: Span) -> Eval {
        let name = self.named(value);
        let message = format!("cannot apply unary operator `{sign}` to type `{name}`");
        self.wrong(at, message, "")
    }

    /// Converts a value as `as` does.
    pub(crate) fn cast(&mut self, value: &Value, ty: &Type, at: Span) -> Eval {
        let cast = match ty.0 {
            _ if value.lent > 0 => None,
            Ctor::Int(_) | Ctor::F64 | Ctor::F32 => value.cast(ty),
            _ => self.fits(value, ty).then(|| value.clone()),
        };
        match cast {
            Some(cast) => Ok(cast),
            None => {
                let (from, to) = (self.named(value), ty.name(&self.code.names));
                self.wrong(at, format!("non-primitive cast: `{from}` as `{to}`"), "")
            }
        }
    }

    /// Compares two values. `spot` is that of the right one, which is to blame if the types differ.
    #[inline]
    pub(crate) fn compared(
        &mut self,
        order: CompareOp,
        [left, right]: [Value; 2],
        (at, spot): (Span, ExprInfo),
    ) -> Eval {
        if let (Data::Float(a), Data::Float(b)) = (&left.data, &right.data)
            && left.lent == right.lent
        {
            let found = a.partial_cmp(b);
            mem::forget((left, right));
            return Ok(order.holds(found).into());
        }
        self.rarely_compared(order, [left, right], (at, spot))
    }

    /// Compares two values that are not both floats.
    #[inline(never)]
    fn rarely_compared(
        &mut self,
        order: CompareOp,
        both: [Value; 2],
        (at, spot): (Span, ExprInfo),
    ) -> Eval {
        let [left, right] = both.map(|it| match it.data {
            Data::Mut(_) => self.end_of(&it),
            _ => it,
        });
        let is_equality = matches!(order, CompareOp::Equal | CompareOp::Unequal);
        let is_ordered = match left.data.ctor() {
            Ctor::Own(kind) => {
                is_equality && self.code.names.structs[kind as usize].derives("PartialEq")
            }
            Ctor::Fn | Ctor::Iterator | Ctor::Picture => false,
            Ctor::Vec3 | Ctor::Ray => is_equality,
            _ => true,
        };
        let sign = order.sign();
        if !is_ordered {
            let name = self.named(&left);
            let message = format!("binary operation `{sign}` cannot be applied to type `{name}`");
            let help = match left.data {
                Data::Own(..) if is_equality => {
                    "`#[derive(PartialEq)]` above the struct defines `==`"
                }
                _ => "",
            };
            return self.wrong(at, message, help);
        }
        self.must_be_like(&right, &left, spot)?;
        let is_number = matches!(
            left.data.ctor(),
            Ctor::Bool | Ctor::Int(_) | Ctor::F64 | Ctor::F32
        );
        match order {
            CompareOp::Equal => Ok(left.equals(&right).into()),
            CompareOp::Unequal => Ok((!left.equals(&right)).into()),
            order if is_number => Ok(order.holds(left.compared(&right)).into()),
            _ => {
                let name = self.named(&left);
                self.refused(Refusal::unread(at, &format!("`{sign}` of `{name}`")))
            }
        }
    }
}

/// Converts the one of two floats whose literal has no type, as `is_any` says, to an `f32` if the
/// other is one.
#[inline]
pub(crate) fn alike(both: [Value; 2], is_any: [bool; 2]) -> [Value; 2] {
    if is_any == [false; 2] {
        return both;
    }
    let [left, right] = both;
    match (&left.data, &right.data) {
        (Data::Single(_), &Data::Float(it)) if is_any[1] => [left, (it as f32).into()],
        (&Data::Float(it), Data::Single(_)) if is_any[0] => [(it as f32).into(), right],
        _ => [left, right],
    }
}

/// Applies an arithmetic operator to two numbers or vectors.
fn combine<T>(sign: ArithOp, a: T, b: T) -> T
where
    T: Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T> + Rem<Output = T>,
{
    match sign {
        ArithOp::Plus => a + b,
        ArithOp::Minus => a - b,
        ArithOp::Times => a * b,
        ArithOp::Over => a / b,
        ArithOp::Remainder => a % b,
    }
}
