//! Comparisons: which values can be compared, and what comes out.

use std::mem;

use super::Machine;
use super::operators::is_literal;
use crate::host::Eval;
use crate::node::Node;
use crate::operators::Order;
use crate::refusal::{At, Refusal};
use crate::types::Head;
use crate::value::{Data, Value};

impl Machine<'_> {
    #[inline(never)]
    pub(super) fn comparison(&mut self, order: Order, nodes: &[Node; 2], places: (At, At)) -> Eval {
        let left = self.operand(&nodes[0])?;
        let right = self.operand(&nodes[1])?;
        if let (Data::Float(a), Data::Float(b)) = (&left.data, &right.data)
            && left.lent == right.lent
        {
            let found = a.partial_cmp(b);
            mem::forget((left, right));
            return Ok(order.holds(found).into());
        }
        let [left, right] = [left, right].map(|it| match it.data {
            Data::Mut(_) => self.end_of(&it),
            _ => it,
        });
        self.comparable(order, [&left, &right], nodes, places)?;
        Ok(match order {
            Order::Equal => left.equals(&right),
            Order::Unequal => !left.equals(&right),
            order => order.holds(left.compared(&right)),
        }
        .into())
    }

    /// Whether two values can be compared like that, or the compiler's words.
    fn comparable(
        &mut self,
        order: Order,
        values: [&Value; 2],
        nodes: &[Node; 2],
        (at, right): (At, At),
    ) -> Eval<()> {
        let [one, other] = values;
        let is_equality = order.is_of_equality();
        self.has_order(order, one, at)?;
        let is_single = matches!(
            (&one.data, &other.data),
            (Data::Single(_), Data::Float(_)) if is_literal(&nodes[1])
        ) || matches!(
            (&one.data, &other.data),
            (Data::Float(_), Data::Single(_)) if is_literal(&nodes[0])
        );
        let may_differ = is_single && one.lent == other.lent;
        if !may_differ && !other.is_like(one) {
            let wanted = self.ty(one);
            return self.mismatch(other, &wanted, right, Some(&nodes[1]));
        }
        let is_ordered = matches!(
            one.head(),
            Head::Bool | Head::Int(_) | Head::F64 | Head::F32
        );
        if is_equality || is_ordered {
            return Ok(());
        }
        let name = self.ty(one).name(&self.code.names);
        let what = format!("`{}` of `{name}`", order.sign());
        self.refused(Refusal::unread(at, &what))
    }

    /// Whether values of that type can be compared like that at all.
    fn has_order(&mut self, order: Order, one: &Value, at: At) -> Eval<()> {
        let is_equality = order.is_of_equality();
        let is_comparable = match one.head() {
            Head::Own(kind) => {
                let kind = &self.code.names.kinds[kind as usize];
                is_equality && kind.derives("PartialEq")
            }
            Head::Fn | Head::Iterator | Head::Picture => false,
            Head::Vec3 | Head::Ray => is_equality,
            _ => true,
        };
        if is_comparable {
            return Ok(());
        }
        let name = self.ty(one).name(&self.code.names);
        let sign = order.sign();
        let message = format!("binary operation `{sign}` cannot be applied to type `{name}`");
        let help = match one.head() {
            Head::Own(_) if is_equality => "`#[derive(PartialEq)]` above a struct makes `==` of it",
            _ => "",
        };
        self.refused(Refusal::new(at, message, "", help))
    }
}
