//! Operators: which types go together, what comes out, and the compiler's words where nothing
//! does. Asked when types are known by reading, and else when it runs.

use std::cmp::Ordering;

use crate::names::{Names, Signature};
use crate::node::{At, Order, Sign};
use crate::read::Refusal;
use crate::types::{Head, Type};

/// What an operator does, and whether it changes its left side.
#[derive(Clone, Copy)]
pub(crate) enum Operator {
    Arithmetic(Sign, bool),
    Compare(Order),
    And,
    Or,
}

pub(crate) fn operator(op: &syn::BinOp) -> Option<Operator> {
    use Operator::{Arithmetic, Compare};
    use syn::BinOp as Op;
    Some(match op {
        Op::Add(_) => Arithmetic(Sign::Plus, false),
        Op::Sub(_) => Arithmetic(Sign::Minus, false),
        Op::Mul(_) => Arithmetic(Sign::Times, false),
        Op::Div(_) => Arithmetic(Sign::Over, false),
        Op::AddAssign(_) => Arithmetic(Sign::Plus, true),
        Op::SubAssign(_) => Arithmetic(Sign::Minus, true),
        Op::MulAssign(_) => Arithmetic(Sign::Times, true),
        Op::DivAssign(_) => Arithmetic(Sign::Over, true),
        Op::Eq(_) => Compare(Order::Equal),
        Op::Ne(_) => Compare(Order::Unequal),
        Op::Lt(_) => Compare(Order::Less),
        Op::Le(_) => Compare(Order::AtMost),
        Op::Gt(_) => Compare(Order::More),
        Op::Ge(_) => Compare(Order::AtLeast),
        Op::And(_) => Operator::And,
        Op::Or(_) => Operator::Or,
        _ => return None,
    })
}

impl Sign {
    /// The trait of the standard library that has it, its sign, and its verb.
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Plus => ("Add", "+", "add"),
            Self::Minus => ("Sub", "-", "subtract"),
            Self::Times => ("Mul", "*", "multiply"),
            Self::Over => ("Div", "/", "divide"),
        }
    }

    /// What the compiled program says where the result does not fit.
    pub(crate) fn overflow(self) -> String {
        format!("attempt to {} with overflow", self.words().2)
    }
}

impl Order {
    fn sign(self) -> &'static str {
        match self {
            Self::Equal => "==",
            Self::Unequal => "!=",
            Self::Less => "<",
            Self::AtMost => "<=",
            Self::More => ">",
            Self::AtLeast => ">=",
        }
    }

    pub(crate) fn holds(self, found: Option<Ordering>) -> bool {
        match self {
            Self::Equal => found.is_some_and(Ordering::is_eq),
            Self::Unequal => !found.is_some_and(Ordering::is_eq),
            Self::Less => found.is_some_and(Ordering::is_lt),
            Self::AtMost => found.is_some_and(Ordering::is_le),
            Self::More => found.is_some_and(Ordering::is_gt),
            Self::AtLeast => found.is_some_and(Ordering::is_ge),
        }
    }

    fn is_of_equality(self) -> bool {
        matches!(self, Self::Equal | Self::Unequal)
    }
}

impl Names {
    /// The reader's function for an operator between these types.
    pub(crate) fn operator(&self, sign: Sign, types: [&Type; 2]) -> Option<usize> {
        if types.into_iter().any(Type::is_unknown) {
            return None;
        }
        let (name, _, _) = sign.words();
        let is_it = |it: &Signature| {
            let mut wanted = it.of.iter().chain(it.parameters.get(1)).zip(types);
            it.in_standard.as_deref() == Some(name)
                && wanted.all(|(wanted, found)| found.fits(wanted, self))
        };
        self.functions.iter().position(is_it)
    }

    /// The type of what comes out, if the two go together.
    pub(crate) fn result_of(&self, sign: Sign, one: &Type, other: &Type) -> Option<Type> {
        if let Some(own) = self.operator(sign, [one, other]) {
            return Some(self.functions[own].result.clone());
        }
        match (one.0, other.0) {
            (Head::Never, _) | (_, Head::Never) => Some(Head::Never.into()),
            (Head::Own(_), _) | (_, Head::Own(_)) if !one.is_unknown() && !other.is_unknown() => {
                None
            }
            (Head::Unknown, _) | (_, Head::Unknown) => Some(Type::UNKNOWN),
            (Head::Int(a), Head::Int(b)) => a.joined(b).map(|it| Head::Int(it).into()),
            (Head::Vec3, Head::Vec3 | Head::F64 | Head::Float) => Some(one.clone()),
            (Head::F64 | Head::Float, Head::Vec3) => Some(other.clone()),
            (Head::Float, Head::F64 | Head::Float) => Some(other.clone()),
            (Head::F64, Head::F64 | Head::Float) => Some(one.clone()),
            (Head::Str, Head::Str) if sign == Sign::Plus => Some(one.clone()),
            _ => None,
        }
    }

    /// That these two do not go together, in the words of the compiler.
    pub(crate) fn no_operator(&self, sign: Sign, types: [&Type; 2], at: At) -> Refusal {
        let (_, sign, verb) = sign.words();
        let [one, other] = types.map(|it| it.name(self));
        let message = match sign {
            "+" => format!("cannot {verb} `{other}` to `{one}`"),
            "-" => format!("cannot {verb} `{other}` from `{one}`"),
            _ => format!("cannot {verb} `{one}` by `{other}`"),
        };
        let is_number = |it: &Type| it.is_integer() || it.is_float() || it.is(Head::Vec3);
        let is_mixed = types[0].is_integer() != types[1].is_integer();
        let help = if !(is_mixed && types.into_iter().all(is_number)) {
            ""
        } else if one == "{integer}" || other == "{integer}" {
            "consider using a floating-point literal, such as `2.0`"
        } else {
            "convert the integer: `f64::from(…)`, or `… as f64`"
        };
        Refusal::new(at, &message, "", help)
    }

    /// The same of remainders and bits, which no chapter has: a `^` is meant as a power.
    pub(crate) fn no_bits(&self, sign: &str, types: [&Type; 2], at: At) -> Refusal {
        let has_bits = |it: &Type| it.is_integer() || it.is(Head::Bool) || it.is_unknown();
        if sign.starts_with('%') || types.into_iter().all(has_bits) {
            return Refusal::unknown(at, &format!("`{sign}`"));
        }
        let [one, other] = types.map(|it| it.name(self));
        let message = format!("no implementation for `{one} {sign} {other}`");
        Refusal::new(at, &message, "", "")
    }

    pub(crate) fn no_cast(&self, from: &Type, to: &Type, at: At) -> Refusal {
        let [from, to] = [from, to].map(|it| it.name(self));
        Refusal::new(
            at,
            &format!("non-primitive cast: `{from}` as `{to}`"),
            "",
            "",
        )
    }

    pub(crate) fn no_iterator(&self, ty: &Type, at: At) -> Refusal {
        let name = ty.name(self);
        match ty.0 {
            Head::Option => Refusal::unknown(at, "loops over an `Option`"),
            _ => Refusal::new(at, &format!("`{name}` is not an iterator"), "", ""),
        }
    }

    pub(crate) fn no_unary(&self, sign: &str, ty: &Type, at: At) -> Refusal {
        let name = ty.name(self);
        let message = format!("cannot apply unary operator `{sign}` to type `{name}`");
        Refusal::new(at, &message, "", "")
    }

    /// Whether two values can be compared like that, or the compiler's words.
    pub(crate) fn comparable(
        &self,
        order: Order,
        types: [&Type; 2],
        at: At,
        right: At,
    ) -> Result<(), Refusal> {
        let [one, other] = types;
        let on = if one.is_reference() && other.is_reference() {
            one.stripped()
        } else {
            one
        };
        let is_comparable = match on.0 {
            Head::Own(_) if order.is_of_equality() => self.derives(on, "PartialEq"),
            Head::Dyn(_) | Head::Fn | Head::Iterator | Head::Picture => false,
            Head::Vec3 | Head::Ray => order.is_of_equality(),
            _ => true,
        };
        if !is_comparable {
            let message = format!(
                "binary operation `{}` cannot be applied to type `{}`",
                order.sign(),
                one.name(self)
            );
            let help = match on.0 {
                Head::Own(_) => "`#[derive(PartialEq)]` above a struct makes `==` of it",
                _ => "",
            };
            return Err(Refusal::new(at, &message, "", help));
        }
        if !other.fits(one, self) && !one.fits(other, self) {
            return Err(self.mismatch(one, other, right));
        }
        let is_ordered = matches!(on.0, Head::Bool | Head::Unknown | Head::Never);
        if order.is_of_equality() || is_ordered || on.is_integer() || on.is_float() {
            return Ok(());
        }
        let what = format!("`{}` of `{}`", order.sign(), on.name(self));
        Err(Refusal::unknown(at, &what))
    }

    /// That something else is declared than is found.
    pub(crate) fn mismatch(&self, wanted: &Type, found: &Type, at: At) -> Refusal {
        let label = format!("expected {}, found {}", wanted.said(self), found.said(self));
        Refusal::new(at, "mismatched types", &label, &self.help(wanted, found))
    }

    fn help(&self, wanted: &Type, found: &Type) -> String {
        let is_like = |it: &Type| found.fits(it, self);
        let help = match (wanted.0, found.0) {
            (Head::F64, Head::Int(_)) if found.name(self) == "{integer}" => {
                "use a float literal, such as `1.0`"
            }
            (Head::F64, Head::Int(_)) => "convert it: `f64::from(…)`, or `… as f64`",
            (Head::Option, _) if is_like(&wanted.inner()) => {
                "try wrapping the expression in `Some`: `Some(…)`"
            }
            (Head::Ref, _) if is_like(&wanted.inner()) => "consider borrowing here: `&…`",
            (Head::RefMut, _) if is_like(&wanted.inner()) => {
                "consider mutably borrowing here: `&mut …`"
            }
            (_, Head::Ref) if found.inner() == *wanted => "consider dereferencing it: `*…`",
            (Head::Box, head) if head != Head::Box => "store it in the heap: `Box::new(…)`",
            (_, Head::Option) if found.inner() == *wanted => {
                "it is `None` where there is nothing: look with `if let Some(…) = …`"
            }
            _ => "",
        };
        help.to_owned()
    }
}
