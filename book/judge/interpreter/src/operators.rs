//! Operators: the arithmetic of the compiled chapters, to the last bit. A new one is a line in
//! the table.

use std::cmp::Ordering;

use common::rtweekend::Vec3;

use crate::calls::Argument;
use crate::fault::Span;
use crate::integers;
use crate::machine::{Code, Machine, Run};
use crate::names::Item;
use crate::value::{Kind, Shape, Target, Value, kind};

/// Makes the operators of arithmetic from their names in `syn`, alone and before `=`, their names in
/// the prelude, their signs, and the functions of integers that return `None` for an overflow.
macro_rules! operators {
    ($($name:ident $assign:ident $function:ident $sign:tt $checked:ident;)*) => {
        /// An operator of arithmetic.
        #[derive(Clone, Copy, Debug)]
        pub(crate) enum Op {
            $($name),*
        }

        impl Op {
            /// Returns the operator, and true if it stands before `=`; `None` for those that compare.
            pub(crate) fn of_syntax(op: &syn::BinOp) -> Option<(Self, bool)> {
                match op {
                    $(syn::BinOp::$name(_) => Some((Self::$name, false)),)*
                    $(syn::BinOp::$assign(_) => Some((Self::$name, true)),)*
                    _ => None,
                }
            }

            fn sign(self) -> &'static str {
                match self {
                    $(Self::$name => stringify!($sign)),*
                }
            }

            /// Returns the name of the function in the prelude's text that computes with vectors.
            fn function(self) -> &'static str {
                match self {
                    $(Self::$name => stringify!($function)),*
                }
            }

            fn of_vectors(self, a: Vec3, b: Vec3) -> Vec3 {
                match self {
                    $(Self::$name => a $sign b),*
                }
            }

            fn of_floats(self, a: f64, b: f64) -> f64 {
                match self {
                    $(Self::$name => a $sign b),*
                }
            }

            /// Computes with integers; `None` for an overflow, or a division by zero.
            fn of_integers(self, a: i64, b: i64) -> Option<i64> {
                match self {
                    $(Self::$name => a.$checked(b)),*
                }
            }

            /// Returns the code that computes with the values of other code. Each operator has code
            /// of its own, so that the common case needs no `match`.
            pub(crate) fn code(self, left: Code, right: Code, at: Span) -> Code {
                match self {
                    $(Self::$name => Code::act(move |m| {
                        if let (Some(a), Some(b)) = (left.number(m), right.number(m)) {
                            return Ok(Value::Float(m.rounded(a $sign b)));
                        }
                        let (a, b) = (left.run(m)?, right.run(m)?);
                        if let (Value::Float(a), Value::Float(b)) = (&a, &b) {
                            return Ok(Value::Float(m.rounded(a $sign b)));
                        }
                        m.arithmetic(self, &a, &b, at)
                    })),*
                }
            }
        }
    };
}
operators! {
    Add AddAssign add + checked_add;
    Sub SubAssign sub - checked_sub;
    Mul MulAssign mul * checked_mul;
    Div DivAssign div / checked_div;
    Rem RemAssign rem % checked_rem;
}

impl Machine<'_> {
    pub(crate) fn arithmetic(&mut self, op: Op, a: &Value, b: &Value, at: Span) -> Run {
        // A number beside a vector is three components.
        let [one, other] = match (a, b) {
            (Value::Vec3(a), Value::Vec3(b)) => [*a, *b],
            (Value::Vec3(a), Value::Float(b)) => [*a, Vec3::splat(*b)],
            (Value::Float(a), Value::Vec3(b)) => [Vec3::splat(*a), *b],
            (Value::Float(a), Value::Float(b)) => {
                return Ok(Value::Float(self.rounded(op.of_floats(*a, *b))));
            }
            (Value::Int(..), Value::Int(..)) => return self.integer(op, a, b, at),
            _ => return self.no_operator(op, [a.kind(), b.kind()], at),
        };
        if !self.code.is_edited {
            return Ok(Value::Vec3(self.all_rounded(op.of_vectors(one, other))));
        }
        let (of, given) = match (op, a, b) {
            (Op::Mul, &Value::Float(number), _) => {
                (kind::FLOAT, [Code::Number(number), Code::Vector(other)])
            }
            (Op::Mul, _, &Value::Float(number)) => {
                (kind::FLOAT, [Code::Number(number), Code::Vector(one)])
            }
            _ => (kind::VEC3, [Code::Vector(one), Code::Vector(other)]),
        };
        self.by_text(of, op.function(), given, at)
    }

    /// Computes by a function of the prelude's text, which an edit may have changed.
    #[cold]
    fn by_text<const N: usize>(&mut self, of: Kind, name: &str, given: [Code; N], at: Span) -> Run {
        let argument = |code| Argument {
            code,
            place: None,
            at,
        };
        let given = given.map(argument);
        match self.code.names.associated(of, name) {
            Some(Item::Function(n)) => {
                let function = Value::Function(Target::Own(n));
                self.call(&function, None, &given, &[], at)
            }
            _ => self.unread(at, name),
        }
    }

    fn integer(&mut self, op: Op, a: &Value, b: &Value, at: Span) -> Run {
        let (&Value::Int(a, one), &Value::Int(b, other)) = (a, b) else {
            return Ok(Value::Unit);
        };
        let Some(of) = integers::joined(one, other) else {
            return self.no_operator(op, [one, other], at);
        };
        let result = op.of_integers(a, b);
        match result.filter(|result| integers::has(of, *result)) {
            Some(result) => Ok(Value::Int(result, of)),
            None => {
                let of = if of == kind::INT { kind::I32 } else { of };
                let ty = self.code.names.shown(of);
                self.panic(at, format!("the result of `{}` is no `{ty}`", op.sign()))
            }
        }
    }

    #[cold]
    fn no_operator(&mut self, op: Op, kinds: [Kind; 2], at: Span) -> Run {
        // Those of a text would be functions of a trait.
        if kinds
            .iter()
            .any(|kind| (kind::CAMERA + 1..kind::ANY).contains(kind))
        {
            return self.unread(at, "operators of types of your own");
        }
        let [a, b] = kinds.map(|kind| self.code.names.shown(kind));
        let message = format!("there is no `{a} {} {b}`", op.sign());
        self.refuse(at, message)
    }

    pub(crate) fn negated(&mut self, value: &Value, at: Span) -> Run {
        match value {
            Value::Float(number) => Ok(Value::Float(-number)),
            Value::Vec3(vector) if !self.code.is_edited => Ok(Value::Vec3(-vector)),
            Value::Vec3(vector) => self.by_text(kind::VEC3, "neg", [Code::Vector(*vector)], at),
            Value::Int(number, of) => match number.checked_neg() {
                Some(negated) if integers::has(*of, negated) => Ok(Value::Int(negated, *of)),
                _ => self.panic(at, "the result of `-` is out of range"),
            },
            other => self.mismatch(at, "number", other.kind()),
        }
    }

    /// Compares two numbers or truths; `None` if one is NaN.
    pub(crate) fn order(&mut self, a: &Value, b: &Value, at: Span) -> Run<Option<Ordering>> {
        match (a, b) {
            (Value::Float(a), Value::Float(b)) => Ok(a.partial_cmp(b)),
            (Value::Int(a, one), Value::Int(b, other))
                if integers::joined(*one, *other).is_some() =>
            {
                Ok(Some(a.cmp(b)))
            }
            (Value::Bool(a), Value::Bool(b)) => Ok(Some(a.cmp(b))),
            _ if a.kind() == b.kind() => self.unread(at, "an order of these values"),
            _ => {
                let wanted = self.code.names.shown(a.kind());
                self.mismatch(at, wanted, b.kind())
            }
        }
    }

    /// Returns true if two values are equal, as by a derived `PartialEq`.
    pub(crate) fn equal(&mut self, a: &Value, b: &Value, at: Span) -> Run<bool> {
        match (a, b) {
            (Value::Vec3(a), Value::Vec3(b)) => Ok(a == b),
            (Value::Unit, Value::Unit) => Ok(true),
            (Value::Data(Shape::TEXT, _), _) => self.unread(at, "a comparison of texts"),
            (Value::Data(one, _), Value::Data(other, _)) if one.kind == other.kind => {
                self.turn(at)?;
                let (all, others) = (a.parts(), b.parts());
                let mut is_equal = one.variant == other.variant && all.len() == others.len();
                for (a, b) in all.iter().zip(others) {
                    is_equal = is_equal && self.equal(a, b, at)?;
                }
                Ok(is_equal)
            }
            _ => Ok(self.order(a, b, at)? == Some(Ordering::Equal)),
        }
    }
}
