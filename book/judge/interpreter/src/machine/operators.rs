//! Operators: which values go together, what comes out, and the compiler's words where nothing
//! does.

use std::mem;

use common::rtweekend::Vec3 as DVec3;

use super::Machine;
use crate::host::{Eval, Host};
use crate::node::{Node, Root, Target};
use crate::operators::Sign;
use crate::refusal::{At, Refusal};
use crate::types::{Head, Type};
use crate::value::{Data, Value};

impl Machine<'_> {
    /// A result as floats have it here.
    #[inline]
    pub(super) fn rounded(&self, it: f64) -> f64 {
        if self.code.is_single {
            f64::from(it as f32)
        } else {
            it
        }
    }

    #[inline]
    fn all_rounded(&self, it: DVec3) -> DVec3 {
        if self.code.is_single {
            DVec3::from_array(it.to_array().map(|it| f64::from(it as f32)))
        } else {
            it
        }
    }

    #[inline(never)]
    pub(super) fn operation(&mut self, sign: Sign, nodes: &[Node; 2], at: At) -> Eval {
        let left = self.operand(&nodes[0])?;
        let right = self.operand(&nodes[1])?;
        if let (Data::Float(a), Data::Float(b)) = (&left.data, &right.data) {
            let result = self.rounded(of_floats(sign, *a, *b));
            // They have nothing to drop.
            mem::forget((left, right));
            return Ok(result.into());
        }
        match (&left.data, &right.data) {
            (Data::Single(_), Data::Float(b)) if is_literal(&nodes[1]) => {
                let right = Data::Single(*b as f32).into();
                self.combined(sign, left, right, at)
            }
            (Data::Float(a), Data::Single(_)) if is_literal(&nodes[0]) => {
                let left = Data::Single(*a as f32).into();
                self.combined(sign, left, right, at)
            }
            _ => self.combined(sign, left, right, at),
        }
    }

    /// What comes out of an operator between two values.
    #[inline(never)]
    pub(super) fn combined(&mut self, sign: Sign, left: Value, right: Value, at: At) -> Eval {
        Ok(match (&left.data, &right.data) {
            (Data::Float(a), Data::Float(b)) => self.rounded(of_floats(sign, *a, *b)).into(),
            (Data::Vec3(a), Data::Vec3(b)) => self.all_rounded(of_vectors(sign, *a, *b)).into(),
            (Data::Vec3(a), Data::Float(b)) => self
                .all_rounded(of_vectors(sign, *a, DVec3::splat(*b)))
                .into(),
            (Data::Float(a), Data::Vec3(b)) => self
                .all_rounded(of_vectors(sign, DVec3::splat(*a), *b))
                .into(),
            (Data::Single(a), Data::Single(b)) => Data::Single(of_singles(sign, *a, *b)).into(),
            (Data::Str(a), Data::Str(b))
                if sign == Sign::Plus && left.lent == 0 && right.lent > 0 =>
            {
                self.take(a.len() + b.len(), at)?;
                Value::str(format!("{a}{b}"))
            }
            (Data::Int(a, one), Data::Int(b, other)) => match one.joined(*other) {
                Some(int) => {
                    let result = self.integer(sign, a.get(), b.get(), at)?;
                    if !int.has(result) {
                        return self.panic(at, &sign.overflow());
                    }
                    Value::whole(result, int)
                }
                None => return self.no_operator(sign, false, [&left, &right], at),
            },
            (Data::Mut(_), _) | (_, Data::Mut(_)) => {
                let [left, right] = [left, right].map(|it| self.end_of(&it));
                return self.combined(sign, left, right, at);
            }
            _ => return self.by_the_reader(sign, left, right, at),
        })
    }

    fn integer(&mut self, sign: Sign, a: i128, b: i128, at: At) -> Eval<i128> {
        Ok(match sign {
            Sign::Over if b == 0 => return self.panic(at, "attempt to divide by zero"),
            Sign::Remainder if b == 0 => {
                let message = "attempt to calculate the remainder with a divisor of zero";
                return self.panic(at, message);
            }
            Sign::Plus => a + b,
            Sign::Minus => a - b,
            Sign::Times => a.saturating_mul(b),
            Sign::Over => a / b,
            Sign::Remainder => a % b,
        })
    }

    /// By an operator of the reader's.
    fn by_the_reader(&mut self, sign: Sign, left: Value, right: Value, at: At) -> Eval {
        match self.operator(sign, false, [&left, &right]) {
            Some(own) => self.run(own, &[left, right], at),
            None => self.no_operator(sign, false, [&left, &right], at),
        }
    }

    /// The reader's function for an operator between these values.
    fn operator(&self, sign: Sign, is_assignment: bool, values: [&Value; 2]) -> Option<usize> {
        let names = &self.code.names;
        let is_it = |it: &&(Sign, bool, usize)| {
            if (it.0, it.1) != (sign, is_assignment) {
                return false;
            }
            let wanted = &names.functions[it.2].parameters;
            let left = if is_assignment {
                wanted[0].inner()
            } else {
                &wanted[0]
            };
            self.fits(values[0], left) && self.fits(values[1], &wanted[1])
        };
        names.operators.iter().find(is_it).map(|it| it.2)
    }

    /// That these two do not go together, in the words of the compiler.
    fn no_operator<T>(
        &mut self,
        sign: Sign,
        is_assignment: bool,
        values: [&Value; 2],
        at: At,
    ) -> Eval<T> {
        let heads = values.map(Value::head);
        let is_single = |it: &Head| *it == Head::F32;
        if heads.iter().any(is_single) && heads.contains(&Head::F64) {
            let what = "a number that may be an `f32` or an `f64`";
            return self.refused(Refusal::unread(at, what));
        }
        let types = values.map(|it| self.ty(it));
        let [one, other] = types.each_ref().map(|it| it.name(&self.code.names));
        let message = sign.refused(is_assignment, &one, &other);
        let is_integer = |it: &Head| matches!(it, Head::Int(_));
        let is_number = |it: &Head| is_integer(it) || matches!(it, Head::F64 | Head::Vec3);
        let is_mixed = is_integer(&heads[0]) != is_integer(&heads[1]);
        let help = if !(is_mixed && heads.iter().all(is_number)) {
            ""
        } else if one == "{integer}" || other == "{integer}" {
            "consider using a floating-point literal, such as `2.0`"
        } else {
            "convert the integer: `f64::from(…)`, or `… as f64`"
        };
        self.refused(Refusal::new(at, message, "", help))
    }

    /// `+=` and the like.
    #[inline(never)]
    pub(super) fn update(&mut self, target: &Target, sign: Sign, value: &Node, at: At) -> Eval {
        let right = self.operand(value)?;
        self.may_change(target)?;
        if let (Root::Local(slot), []) = (&target.root, &*target.steps)
            && let (Data::Float(a), Data::Float(b)) =
                (&self.stack[self.base + slot].data, &right.data)
            && self.stack[self.base + slot].lent == 0
        {
            let result = self.rounded(of_floats(sign, *a, *b));
            let slot = self.base + slot;
            self.stack[slot] = result.into();
            return Ok(Value::default());
        }
        let address = self.address(target)?;
        let left = self.read(&address);
        if let (Data::Own(..), 0) = (&left.data, left.lent) {
            let Some(own) = self.operator(sign, true, [&left, &right]) else {
                return self.no_operator(sign, true, [&left, &right], at);
            };
            drop(left);
            return self.run(own, &[Data::Mut(address).into(), right], at);
        }
        if let (Data::Str(_), Data::Str(more)) = (&left.data, &right.data) {
            let more = std::rc::Rc::clone(more);
            drop(left);
            self.append(address, &more, at)?;
            return Ok(Value::default());
        }
        if matches!(left.data, Data::Mut(_)) || left.lent > 0 {
            return self.no_operator(sign, true, [&left, &right], at);
        }
        let right = match (&left.data, &right.data) {
            (Data::Single(_), Data::Float(it)) if is_literal(value) => {
                Data::Single(*it as f32).into()
            }
            _ => right,
        };
        let result = self.combined(sign, left.clone(), right.clone(), at)?;
        if !result.is_like(&left) {
            return self.no_operator(sign, true, [&left, &right], at);
        }
        drop(left);
        let mut result = Some(result);
        self.stack[address.slot as usize].reach(&address.steps, &mut |place| {
            *place = result.take().unwrap_or_default();
        });
        Ok(Value::default())
    }

    /// Operators on bits: a `^` is meant as a power.
    #[inline(never)]
    pub(super) fn bits(&mut self, sign: &str, nodes: &[Node; 2], at: At) -> Eval {
        let values = [self.eval(&nodes[0])?, self.eval(&nodes[1])?];
        if let [Data::Bool(one), Data::Bool(other)] = [&values[0].data, &values[1].data] {
            return Ok(match sign {
                "&" => one & other,
                "|" => one | other,
                _ => one ^ other,
            }
            .into());
        }
        let is_whole = |it: &Value| matches!(it.data, Data::Int(..));
        if values.iter().all(is_whole) {
            return self.refused(Refusal::unread(at, &format!("`{sign}`")));
        }
        let [one, other] = values.map(|it| self.ty(&it).name(&self.code.names));
        let message = format!("no implementation for `{one} {sign} {other}`");
        self.refused(Refusal::new(at, message, "", ""))
    }

    #[inline(never)]
    pub(super) fn not(&mut self, of: &Node, at: At) -> Eval {
        let value = self.eval(of)?;
        match self.end_of(&value).data {
            Data::Bool(it) => Ok((!it).into()),
            Data::Int(..) => self.refused(Refusal::unread(at, "`!` of integers")),
            _ => self.no_unary("!", &value, at),
        }
    }

    #[inline(never)]
    pub(super) fn negated(&mut self, of: &Node, at: At) -> Eval {
        let value = self.operand(of)?;
        Ok(match &value.data {
            Data::Float(it) => (-it).into(),
            Data::Vec3(it) => (-*it).into(),
            Data::Single(it) => Data::Single(-it).into(),
            Data::Int(it, int) if int.ends().0 < 0 => match int.has(-it.get()) {
                true => Value::whole(-it.get(), *int),
                false => return self.panic(at, "attempt to negate with overflow"),
            },
            Data::Mut(_) => {
                let value = self.end_of(&value);
                return self.no_unary("-", &value.lent(), at);
            }
            _ => {
                let negations = &self.code.names.negations;
                let functions = &self.code.names.functions;
                let mut all = negations.iter();
                match all.find(|&&it| self.fits(&value, &functions[it].parameters[0])) {
                    Some(own) => self.run(*own, &[value], at)?,
                    None => return self.no_unary("-", &value, at),
                }
            }
        })
    }

    fn no_unary(&mut self, sign: &str, value: &Value, at: At) -> Eval {
        let name = self.ty(value).name(&self.code.names);
        let message = format!("cannot apply unary operator `{sign}` to type `{name}`");
        self.refused(Refusal::new(at, message, "", ""))
    }

    #[inline(never)]
    pub(super) fn cast(&mut self, of: &Node, ty: &Type, at: At) -> Eval {
        let value = self.eval(of)?;
        let cast = match ty.0 {
            _ if value.lent > 0 => None,
            Head::Int(_) | Head::F64 | Head::F32 => value.cast(ty),
            _ => self.fits(&value, ty).then(|| value.clone()),
        };
        match cast {
            Some(cast) => Ok(cast),
            None => {
                let names = &self.code.names;
                let (from, to) = (self.ty(&value).name(names), ty.name(names));
                let message = format!("non-primitive cast: `{from}` as `{to}`");
                self.refused(Refusal::new(at, message, "", ""))
            }
        }
    }
}

/// Whether it is a number of which nothing says which kind it is.
pub(super) fn is_literal(node: &Node) -> bool {
    match node {
        Node::Float(_) => true,
        Node::Negate(of, _) => is_literal(of),
        Node::Arithmetic(_, nodes, _) => nodes.iter().all(is_literal),
        _ => false,
    }
}

fn of_floats(sign: Sign, a: f64, b: f64) -> f64 {
    match sign {
        Sign::Plus => a + b,
        Sign::Minus => a - b,
        Sign::Times => a * b,
        Sign::Over => a / b,
        Sign::Remainder => a % b,
    }
}

fn of_singles(sign: Sign, a: f32, b: f32) -> f32 {
    match sign {
        Sign::Plus => a + b,
        Sign::Minus => a - b,
        Sign::Times => a * b,
        Sign::Over => a / b,
        Sign::Remainder => a % b,
    }
}

fn of_vectors(sign: Sign, a: DVec3, b: DVec3) -> DVec3 {
    match sign {
        Sign::Plus => a + b,
        Sign::Minus => a - b,
        Sign::Times => a * b,
        Sign::Over => a / b,
        Sign::Remainder => a % b,
    }
}
