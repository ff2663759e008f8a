//! Operators: which types go together, and what comes out.

use super::{Checked, Checker, Typed};
use crate::node::{Arithmetic, Node, Order, Sign};
use crate::types::{Head, Type};

/// What an operator does, and its words for where it can't.
enum Operator {
    Arithmetic(Sign, &'static str, &'static str),
    Compare(Order),
    And,
    Or,
}

impl Checker<'_> {
    pub(super) fn unary(&mut self, it: &syn::ExprUnary) -> Checked {
        let of = self.expr(&it.expr, None)?;
        let ty = self.types.known(&of.ty);
        match it.op {
            syn::UnOp::Deref(_) => match ty.head() {
                Some(Head::Ref | Head::RefMut | Head::Box) => {
                    Ok(self.dereferenced(Typed { ty, ..of }))
                }
                _ => {
                    let message = format!("type `{}` cannot be dereferenced", self.name(&ty));
                    self.fault(it, &message, "", "")
                }
            },
            syn::UnOp::Not(_) => {
                let of = self.stripped(&of);
                if !of.ty.is(Head::Bool) && !self.types.is_integer(&of.ty) {
                    let message = format!(
                        "cannot apply unary operator `!` to type `{}`",
                        self.name(&of.ty)
                    );
                    return self.fault(it, &message, "", "");
                }
                let kept = self.keep(&of.ty);
                Ok(Typed::new(Node::Not(Box::new(of.node), kept), of.ty))
            }
            syn::UnOp::Neg(_) => {
                let of = self.stripped(&of);
                let is_signed = match of.ty.head() {
                    Some(Head::Int(int)) => int.least < 0,
                    Some(Head::F64 | Head::F32 | Head::Vec3) => true,
                    Some(_) => false,
                    None => self.types.is_float(&of.ty) || self.types.is_integer(&of.ty),
                };
                if !is_signed {
                    let message = format!(
                        "cannot apply unary operator `-` to type `{}`",
                        self.name(&of.ty)
                    );
                    return self.fault(it, &message, "", "");
                }
                let kept = self.keep(&of.ty);
                Ok(Typed::new(
                    Node::Negate(Box::new(of.node), kept, self.at(it)),
                    of.ty,
                ))
            }
            _ => self.unknown(it, "this operator"),
        }
    }

    pub(super) fn binary(&mut self, it: &syn::ExprBinary) -> Checked {
        let (operator, is_assignment) = match operator(&it.op) {
            Some(operator) => operator,
            None => return self.unknown(it, "this operator"),
        };
        let bool = Type::plain(Head::Bool);
        match operator {
            Operator::And | Operator::Or => {
                let nodes = Box::new([self.given(&it.left, &bool)?, self.given(&it.right, &bool)?]);
                let node = match operator {
                    Operator::And => Node::And(nodes),
                    _ => Node::Or(nodes),
                };
                Ok(Typed::new(node, bool))
            }
            Operator::Compare(order) => {
                let left = self.expr(&it.left, None)?;
                let right = self.expr(&it.right, Some(&left.ty))?;
                self.comparable(&left, it)?;
                let ty = left.ty.clone();
                let right = self.coerced(right, &ty, &it.right)?;
                let left = self.read(left);
                let ty = self.types.known(&ty);
                let right = match ty.head() {
                    Some(Head::RefMut) => Node::Deref(Box::new(right)),
                    _ => right,
                };
                if !matches!(order, Order::Equal | Order::Unequal) && !self.has_order(&ty) {
                    let message = format!(
                        "binary operation `{}` cannot be applied to type `{}`",
                        sign_of(&it.op),
                        self.name(&ty)
                    );
                    return self.fault(it, &message, "", "");
                }
                Ok(Typed::new(
                    Node::Compare(order, Box::new([left, right])),
                    bool,
                ))
            }
            Operator::Arithmetic(sign, verb, word) => {
                let left = self.expr(&it.left, None)?;
                let right = self.expr(&it.right, None)?;
                let [one, other] = [&left, &right].map(|it| self.stripped(it));
                let Some(ty) = self.result_of(sign, &one.ty, &other.ty) else {
                    return self.no_operator(it, verb, word, [&left.ty, &right.ty], is_assignment);
                };
                let how = Box::new(Arithmetic {
                    sign,
                    ty: self.keep(&ty),
                    at: self.place(it),
                });
                if !is_assignment {
                    return Ok(Typed::new(
                        Node::Arithmetic(how, Box::new([one.node, other.node])),
                        ty,
                    ));
                }
                if !self.types.unify(&ty, &one.ty) {
                    return self.no_operator(it, verb, word, [&left.ty, &right.ty], is_assignment);
                }
                // `*x += 1`, but `x += 1` only where x is no reference.
                let is_reference = matches!(
                    self.types.known(&left.ty).head(),
                    Some(Head::Ref | Head::RefMut)
                );
                if is_reference {
                    let message = format!(
                        "binary assignment operation `{}` cannot be applied to type `{}`",
                        sign_of(&it.op),
                        self.name(&left.ty)
                    );
                    return self.fault(it, &message, "", "dereference it: `*…`");
                }
                let target = self.assignable(left, &it.left)?;
                Ok(Typed::new(
                    Node::Update(Box::new(target), how, Box::new(other.node)),
                    Type::unit(),
                ))
            }
        }
    }

    /// The value of what may be a mutable reference.
    fn read(&self, typed: Typed) -> Node {
        match self.types.known(&typed.ty).head() {
            Some(Head::RefMut) => Node::Deref(Box::new(typed.node)),
            _ => typed.node,
        }
    }

    fn comparable(&self, left: &Typed, it: &syn::ExprBinary) -> Checked<()> {
        let ty = self.stripped(left).ty;
        let is_comparable = match ty.head() {
            Some(Head::Own(kind)) => self.items.kinds[kind]
                .derives
                .iter()
                .any(|it| it == "PartialEq"),
            Some(Head::Dyn(_) | Head::Fn | Head::Iterator | Head::Camera | Head::Picture) => false,
            _ => true,
        };
        match is_comparable {
            true => Ok(()),
            false => {
                let message = format!(
                    "binary operation `{}` cannot be applied to type `{}`",
                    sign_of(&it.op),
                    self.name(&left.ty)
                );
                self.fault(
                    it,
                    &message,
                    "",
                    "`#[derive(PartialEq)]` above a struct makes `==` of it",
                )
            }
        }
    }

    fn has_order(&self, ty: &Type) -> bool {
        let mut ty = self.types.known(ty);
        while matches!(ty.head(), Some(Head::Ref | Head::RefMut)) {
            ty = self.types.known(&ty.inner());
        }
        match ty.head() {
            Some(Head::F64 | Head::F32 | Head::Int(_) | Head::Bool) => true,
            Some(_) => false,
            None => true,
        }
    }

    /// The type of what comes out, if the two go together.
    fn result_of(&mut self, sign: Sign, one: &Type, other: &Type) -> Option<Type> {
        let is_bits = matches!(sign, Sign::BitAnd | Sign::BitOr | Sign::BitXor);
        let is_shift = matches!(sign, Sign::Left | Sign::Right);
        let (one, other) = (self.types.known(one), self.types.known(other));
        let float = Type::plain(Head::F64);
        match (one.head(), other.head()) {
            (Some(Head::Bool), Some(Head::Bool)) if is_bits => Some(one),
            _ if is_shift => {
                (self.types.is_integer(&one) && self.types.is_integer(&other)).then_some(one)
            }
            (Some(Head::Vec3), Some(Head::Vec3)) if !is_bits && sign != Sign::Remainder => {
                Some(one)
            }
            (Some(Head::Vec3), _) if !is_bits && sign != Sign::Remainder => {
                self.types.unify(&other, &float).then_some(one)
            }
            (_, Some(Head::Vec3)) if !is_bits && sign != Sign::Remainder => {
                self.types.unify(&one, &float).then_some(other)
            }
            _ => {
                let is_number = |it: &Type| self.types.is_integer(it) || self.types.is_float(it);
                let is_any = |it: &Type| matches!(it, Type::Var(_));
                let may_be =
                    (is_number(&one) || is_any(&one)) && (is_number(&other) || is_any(&other));
                let is_float = self.types.is_float(&one) || self.types.is_float(&other);
                (may_be && !(is_bits && is_float) && self.types.unify(&one, &other)).then_some(one)
            }
        }
    }

    fn no_operator(
        &self,
        it: &syn::ExprBinary,
        verb: &str,
        word: &str,
        types: [&Type; 2],
        is_assignment: bool,
    ) -> Checked {
        let [one, other] = types.map(|ty| self.name(ty));
        let message = match (verb, is_assignment) {
            ("", _) => format!("no implementation for `{one} {} {other}`", sign_of(&it.op)),
            ("add", false) | ("add", true) => format!(
                "cannot add{} `{other}` to `{one}`",
                if is_assignment { "-assign" } else { "" }
            ),
            ("subtract", _) => format!(
                "cannot subtract{} `{other}` from `{one}`",
                if is_assignment { "-assign" } else { "" }
            ),
            (verb, _) => format!(
                "cannot {verb}{} `{one}` {word} `{other}`",
                if is_assignment { "-assign" } else { "" }
            ),
        };
        let is_mixed = self.types.is_integer(types[0]) != self.types.is_integer(types[1]);
        let is_number = |ty: &Type| {
            self.types.is_integer(ty)
                || self.types.is_float(ty)
                || self.types.known(ty).is(Head::Vec3)
        };
        let help = match is_mixed && types.into_iter().all(is_number) {
            true if one == "{integer}" || other == "{integer}" => {
                "consider using a floating-point literal, such as `2.0`"
            }
            true => "convert the integer: `f64::from(…)`, or `… as f64`",
            false => "",
        };
        self.fault(it, &message, "", help)
    }
}

fn operator(op: &syn::BinOp) -> Option<(Operator, bool)> {
    use syn::BinOp as Op;
    let arithmetic = |sign, verb, word, is_assignment| {
        Some((Operator::Arithmetic(sign, verb, word), is_assignment))
    };
    let compare = |order| Some((Operator::Compare(order), false));
    match op {
        Op::Add(_) => arithmetic(Sign::Plus, "add", "", false),
        Op::Sub(_) => arithmetic(Sign::Minus, "subtract", "", false),
        Op::Mul(_) => arithmetic(Sign::Times, "multiply", "by", false),
        Op::Div(_) => arithmetic(Sign::Over, "divide", "by", false),
        Op::Rem(_) => arithmetic(
            Sign::Remainder,
            "calculate the remainder of",
            "divided by",
            false,
        ),
        Op::BitAnd(_) => arithmetic(Sign::BitAnd, "", "", false),
        Op::BitOr(_) => arithmetic(Sign::BitOr, "", "", false),
        Op::BitXor(_) => arithmetic(Sign::BitXor, "", "", false),
        Op::Shl(_) => arithmetic(Sign::Left, "", "", false),
        Op::Shr(_) => arithmetic(Sign::Right, "", "", false),
        Op::AddAssign(_) => arithmetic(Sign::Plus, "add", "", true),
        Op::SubAssign(_) => arithmetic(Sign::Minus, "subtract", "", true),
        Op::MulAssign(_) => arithmetic(Sign::Times, "multiply", "by", true),
        Op::DivAssign(_) => arithmetic(Sign::Over, "divide", "by", true),
        Op::RemAssign(_) => arithmetic(
            Sign::Remainder,
            "calculate the remainder of",
            "divided by",
            true,
        ),
        Op::Eq(_) => compare(Order::Equal),
        Op::Ne(_) => compare(Order::Unequal),
        Op::Lt(_) => compare(Order::Less),
        Op::Le(_) => compare(Order::AtMost),
        Op::Gt(_) => compare(Order::More),
        Op::Ge(_) => compare(Order::AtLeast),
        Op::And(_) => Some((Operator::And, false)),
        Op::Or(_) => Some((Operator::Or, false)),
        _ => None,
    }
}

fn sign_of(op: &syn::BinOp) -> &'static str {
    use syn::BinOp as Op;
    match op {
        Op::Eq(_) => "==",
        Op::Ne(_) => "!=",
        Op::Lt(_) => "<",
        Op::Le(_) => "<=",
        Op::Gt(_) => ">",
        Op::Ge(_) => ">=",
        Op::AddAssign(_) => "+=",
        Op::SubAssign(_) => "-=",
        Op::MulAssign(_) => "*=",
        Op::DivAssign(_) => "/=",
        Op::RemAssign(_) => "%=",
        Op::BitAnd(_) => "&",
        Op::BitOr(_) => "|",
        Op::BitXor(_) => "^",
        Op::Shl(_) => "<<",
        Op::Shr(_) => ">>",
        _ => "that",
    }
}
