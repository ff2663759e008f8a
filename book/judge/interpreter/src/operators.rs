//! Operators: their signs, and what the compiler calls them.

use std::cmp::Ordering;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Plus,
    Minus,
    Times,
    Over,
    Remainder,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    Equal,
    Unequal,
    Less,
    AtMost,
    More,
    AtLeast,
}

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
        Op::Rem(_) => Arithmetic(Sign::Remainder, false),
        Op::AddAssign(_) => Arithmetic(Sign::Plus, true),
        Op::SubAssign(_) => Arithmetic(Sign::Minus, true),
        Op::MulAssign(_) => Arithmetic(Sign::Times, true),
        Op::DivAssign(_) => Arithmetic(Sign::Over, true),
        Op::RemAssign(_) => Arithmetic(Sign::Remainder, true),
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
    const ALL: [(Self, &str, &str); 5] = [
        (Self::Plus, "Add", "add"),
        (Self::Minus, "Sub", "subtract"),
        (Self::Times, "Mul", "multiply"),
        (Self::Over, "Div", "divide"),
        (Self::Remainder, "Rem", "calculate the remainder of"),
    ];

    /// The sign that a trait of the standard library has.
    pub(crate) fn of_trait(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|it| it.1 == name).map(|it| it.0)
    }

    fn verb(self) -> &'static str {
        let own = Self::ALL.iter().find(|it| it.0 == self);
        own.expect("all are listed").2
    }

    /// What the compiled program says where the result does not fit.
    pub(crate) fn overflow(self) -> String {
        format!("attempt to {} with overflow", self.verb())
    }

    /// What the compiler says where these two do not go together.
    pub(crate) fn refused(self, is_assignment: bool, one: &str, other: &str) -> String {
        let verb = if is_assignment {
            format!("{}-assign", self.verb())
        } else {
            self.verb().to_owned()
        };
        match self {
            Self::Plus => format!("cannot {verb} `{other}` to `{one}`"),
            Self::Minus => format!("cannot {verb} `{other}` from `{one}`"),
            Self::Times | Self::Over => format!("cannot {verb} `{one}` by `{other}`"),
            Self::Remainder => format!("cannot {verb} `{one}` divided by `{other}`"),
        }
    }
}

impl Order {
    pub(crate) fn sign(self) -> &'static str {
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
}
