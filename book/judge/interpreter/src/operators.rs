//! Operators: their texts, and the compiler's words for them.

use std::cmp::Ordering;

/// An arithmetic operator between two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ArithOp {
    Plus,
    Minus,
    Times,
    Over,
    Remainder,
}

/// A comparison of two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CompareOp {
    Equal,
    Unequal,
    Less,
    AtMost,
    More,
    AtLeast,
}

/// An operator between two expressions.
#[derive(Clone, Copy)]
pub(crate) enum Operator {
    /// An arithmetic operator, and true if it assigns, as `+=`.
    Arithmetic(ArithOp, bool),
    Compare(CompareOp),
    And,
    Or,
}

/// Returns the operator with that text; `None` for one that chapters don't have.
pub(crate) fn operator(sign: &str) -> Option<Operator> {
    let order = CompareOp::ALL.iter().find(|it| it.1 == sign);
    match sign {
        "&&" => Some(Operator::And),
        "||" => Some(Operator::Or),
        _ if order.is_some() => order.map(|it| Operator::Compare(it.0)),
        _ => {
            let plain = sign.trim_end_matches('=');
            let row = ArithOp::ALL.iter().find(|it| it.1 == plain)?;
            Some(Operator::Arithmetic(row.0, plain != sign))
        }
    }
}

impl ArithOp {
    /// Each operator with its text, its trait, and the compiler's verb.
    const ALL: [(Self, &str, &str, &str); 5] = [
        (Self::Plus, "+", "Add", "add"),
        (Self::Minus, "-", "Sub", "subtract"),
        (Self::Times, "*", "Mul", "multiply"),
        (Self::Over, "/", "Div", "divide"),
        (Self::Remainder, "%", "Rem", "calculate the remainder of"),
    ];

    /// Returns the operator of a trait of the standard library, as `Add`.
    pub(crate) fn of_trait(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|it| it.2 == name).map(|it| it.0)
    }

    /// Returns the compiler's verb for the operator.
    fn verb(self) -> &'static str {
        let own = Self::ALL.iter().find(|it| it.0 == self);
        own.expect("all are listed").3
    }

    /// Returns the panic message for a result that does not fit its type.
    pub(crate) fn overflow(self) -> String {
        format!("attempt to {} with overflow", self.verb())
    }

    /// Returns the compiler's message for two types that have no such operator.
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

impl CompareOp {
    /// Each comparison with its text.
    const ALL: [(Self, &str); 6] = [
        (Self::Equal, "=="),
        (Self::Unequal, "!="),
        (Self::Less, "<"),
        (Self::AtMost, "<="),
        (Self::More, ">"),
        (Self::AtLeast, ">="),
    ];

    /// Returns the text of the comparison.
    pub(crate) fn sign(self) -> &'static str {
        let own = Self::ALL.iter().find(|it| it.0 == self);
        own.expect("all are listed").1
    }

    /// Returns true if the comparison holds for values in this order; `None` means that one is NaN.
    #[inline]
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
