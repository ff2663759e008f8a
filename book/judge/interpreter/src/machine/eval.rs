//! Evaluation: what each node comes to.

use std::iter;
use std::mem;
use std::rc::Rc;
use std::sync::atomic::Ordering::Relaxed;

use super::Machine;
use crate::host::{Eval, Host, Stop};
use crate::library::{iterator, next};
use crate::node::{Node, Pattern};
use crate::refusal::{At, Refusal};
use crate::types::Type;
use crate::value::{Data, Value};

impl Machine<'_> {
    /// What a node comes to. Each arm is a function of its own: this one is entered most.
    pub(super) fn eval(&mut self, node: &Node) -> Eval {
        match node {
            Node::Unit => Ok(Value::default()),
            Node::Bool(it) => Ok((*it).into()),
            Node::Int(it, int) => Ok(Value::whole(*it, *int)),
            Node::Float(it) => Ok(self.rounded(*it).into()),
            Node::Single(it) => Ok(Data::Single(*it).into()),
            Node::Vec3(it) => Ok((*it).into()),
            Node::Ordering(it) => Ok(Data::Ordering(*it).into()),
            Node::Str(it) => Ok(Value::str(&**it).lent()),
            Node::None => Ok(None.into()),
            Node::Local(slot) => Ok(self.stack[self.base + slot].clone()),
            Node::Lend(of) => Ok(self.operand(of)?.lent()),
            Node::Address(target) => self.borrowed(target),
            Node::Deref(of, at) => self.dereferenced(of, *at),
            Node::Field(of, field) => self.field(of, field),
            Node::Index(nodes, at) => self.indexed(nodes, *at),
            Node::Set(target, value, at) => self.set(target, value, *at),
            Node::SetAll(targets, value) => self.set_all(targets, value),
            Node::Update(target, sign, value, at) => self.update(target, *sign, value, *at),
            Node::Let(pattern, value, other) => self.bound(pattern, value, other.as_deref()),
            Node::Arithmetic(sign, nodes, at) => self.operation(*sign, nodes, *at),
            Node::Bits(sign, nodes, at) => self.bits(sign, nodes, *at),
            Node::Compare(order, nodes, at, right) => self.comparison(*order, nodes, (*at, *right)),
            Node::And(nodes) => self.until(nodes, false),
            Node::Or(nodes) => self.until(nodes, true),
            Node::Not(of, at) => self.not(of, *at),
            Node::Negate(of, at) => self.negated(of, *at),
            Node::Cast(of, ty, at) => self.cast(of, ty, *at),
            Node::Declared(of, ty, at) => self.checked(of, ty, *at),
            Node::Default(ty, at) => self.default(ty, *at),
            Node::Call(function, given) => self.called(*function, given),
            Node::Constant(function, at) => self.constant(*function, *at),
            Node::Method(method, on, given) => self.method(method, on, given),
            Node::Native(native, given) => self.native(*native, given),
            Node::Apply(function, given) => self.applied_to(function, given),
            Node::Closure(closure, is_moved) => self.closure(closure, *is_moved, At::default()),
            Node::Function(function) => Ok(Data::Function(*function).into()),
            Node::NativeFunction(native) => Ok(Data::Native(*native).into()),
            Node::New(kind, fields, base) => self.made(*kind, fields, base.as_deref()),
            Node::Some(of) => Ok(Data::Some(Rc::new(self.eval(of)?)).into()),
            Node::Tuple(nodes) => Ok(Data::Tuple(self.all(nodes)?.into()).into()),
            Node::If(nodes) => self.choice(nodes),
            Node::Matches(pattern, of) => self.matches(pattern, of),
            Node::Return(value) => self.left_with(value, Stop::Return),
            Node::Block(nodes, has_value) => self.block(nodes, *has_value),
            node => self.rarer(node),
        }
    }

    /// The same of what is evaluated less often.
    fn rarer(&mut self, node: &Node) -> Eval {
        match node {
            Node::Match(of, arms, at) => self.matched(of, arms, *at),
            Node::While(nodes, at) => self.repeated(nodes, *at),
            Node::For(pattern, nodes, at) => self.for_each(pattern, nodes, *at),
            Node::Break(value) => self.left_with(value, Stop::Break),
            Node::Continue => Err(Stop::Continue),
            Node::Try(of, at) => self.tried(of, *at),
            Node::Mark(mark) => {
                mark.has_run.store(true, Relaxed);
                Ok(Value::default())
            }
            Node::Panic(message, at) => self.panic(*at, message),
            Node::Mutants(first, all) => {
                let number = self.code.mutant.checked_sub(*first);
                let mutant = number.and_then(|n| all.get(n as usize + 1));
                self.eval(mutant.unwrap_or(&all[0]))
            }
            Node::List(nodes, is_array, at) => self.list(nodes, *is_array, *at),
            Node::Repeat(nodes, is_array, at) => self.repeat(nodes, *is_array, *at),
            Node::Range(ends, is_closed, at) => self.range(ends, *is_closed, *at),
            Node::Format(pieces, nodes, at) => self.formatted(pieces, nodes, *at),
            node => unreachable!("each node is listed here or above, and not {node:?}"),
        }
    }

    /// The same without a call for what operators mostly stand between.
    #[inline]
    pub(super) fn operand(&mut self, node: &Node) -> Eval {
        match node {
            Node::Float(it) => return Ok(self.rounded(*it).into()),
            Node::Local(slot) => {
                let value = &self.stack[self.base + slot];
                let lent = value.lent;
                match value.data {
                    Data::Float(it) => {
                        let data = Data::Float(it);
                        return Ok(Value { lent, data });
                    }
                    Data::Vec3(it) => {
                        let data = Data::Vec3(it);
                        return Ok(Value { lent, data });
                    }
                    _ => {}
                }
            }
            _ => {}
        }
        self.eval(node)
    }

    pub(super) fn truth(&mut self, node: &Node) -> Eval<bool> {
        Ok(self.eval(node)?.truth())
    }

    #[inline(never)]
    fn until(&mut self, nodes: &[Node; 2], enough: bool) -> Eval {
        let is_enough = self.truth(&nodes[0])? == enough;
        Ok(if is_enough {
            enough
        } else {
            self.truth(&nodes[1])?
        }
        .into())
    }

    #[inline(never)]
    fn checked(&mut self, of: &Node, ty: &Type, at: At) -> Eval {
        let value = self.operand(of)?;
        self.as_declared(value, ty, at, Some(of))
    }

    #[inline(never)]
    fn made(&mut self, kind: u32, fields: &[(usize, Node)], base: Option<&Node>) -> Eval {
        let mut all: Rc<[Value]> = match base.map(|base| self.eval(base)).transpose()? {
            Some(Value {
                data: Data::Own(_, fields),
                ..
            }) => fields,
            Some(other) => unreachable!("it is declared, and this is {other:?}"),
            None => iter::repeat_n(Value::default(), fields.len()).collect(),
        };
        for (n, node) in fields {
            let value = self.eval(node)?;
            Rc::make_mut(&mut all)[*n] = value;
        }
        Ok(Data::Own(kind, all).into())
    }

    #[inline(never)]
    fn list(&mut self, nodes: &[Node], is_array: bool, at: At) -> Eval {
        let all = self.all(nodes)?;
        for value in &all {
            if !matches!(value.data, Data::Float(_)) {
                (self as &mut dyn Host).keep(value, at)?;
            }
        }
        self.take(all.len() * size_of::<Value>(), at)?;
        if let Some((first, rest)) = all.split_first()
            && let Some(other) = rest.iter().find(|it| !it.is_like(first))
        {
            let wanted = self.ty(first);
            return self.mismatch(other, &wanted, at, None);
        }
        Ok(Value::listed(all, is_array))
    }

    #[inline(never)]
    fn repeat(&mut self, nodes: &[Node; 2], is_array: bool, at: At) -> Eval {
        let [value, count] = [self.eval(&nodes[0])?, self.eval(&nodes[1])?];
        let usize = crate::types::Head::Int(crate::types::Int::Usize).into();
        let count = self.as_declared(count, &usize, at, Some(&nodes[1]))?.int() as usize;
        self.take(count.saturating_mul(value.size()), at)?;
        Ok(Value::listed(vec![value; count], is_array))
    }

    #[inline(never)]
    fn range(&mut self, ends: &[Node; 2], is_closed: bool, at: At) -> Eval {
        let all = [self.eval(&ends[0])?, self.eval(&ends[1])?];
        if !matches!(all[1].data, Data::Unit) && !all[1].is_like(&all[0]) {
            let wanted = self.ty(&all[0]);
            return self.mismatch(&all[1], &wanted, at, Some(&ends[1]));
        }
        Ok(Data::Range(Rc::new(all), is_closed).into())
    }

    #[inline(never)]
    fn formatted(&mut self, pieces: &[String], nodes: &[Node], at: At) -> Eval {
        let values = self.all(nodes)?;
        let mut text = String::new();
        for (n, piece) in pieces.iter().enumerate() {
            let value = values.get(n).map_or_else(String::new, |it| self.shown(it));
            self.take(piece.len() + value.len(), at)?;
            text += piece;
            text += &value;
        }
        Ok(Value::str(text))
    }

    /// A value as text, as `{}` has it.
    fn shown(&self, value: &Value) -> String {
        match &value.data {
            Data::Float(it) => it.to_string(),
            Data::Single(it) => it.to_string(),
            Data::Int(it, _) => it.get().to_string(),
            Data::Bool(it) => it.to_string(),
            Data::Str(it) => it.to_string(),
            Data::Mut(_) => self.shown(&self.end_of(value)),
            // Only the picture is looked at, and it has none of these.
            _ => "…".to_owned(),
        }
    }

    #[inline(never)]
    fn choice(&mut self, nodes: &[Node; 3]) -> Eval {
        let n = if self.truth(&nodes[0])? { 1 } else { 2 };
        self.eval(&nodes[n])
    }

    #[inline(never)]
    fn matches(&mut self, pattern: &Pattern, of: &Node) -> Eval {
        let value = self.eval(of)?;
        Ok(self.binds(pattern, &value)?.into())
    }

    #[inline(never)]
    fn repeated(&mut self, nodes: &[Node; 2], at: At) -> Eval {
        loop {
            self.turn(at)?;
            if !self.truth(&nodes[0])? || self.is_left(&nodes[1])? {
                return Ok(mem::take(&mut self.left));
            }
        }
    }

    #[inline(never)]
    fn for_each(&mut self, pattern: &Pattern, nodes: &[Node; 2], at: At) -> Eval {
        let each = self.eval(&nodes[0])?;
        let mut each = iterator(self, &each, at)?;
        while let Some(value) = next(self, &mut each, at)? {
            self.turn(at)?;
            self.binds(pattern, &value)?;
            if self.is_left(&nodes[1])? {
                break;
            }
        }
        Ok(Value::default())
    }

    /// Runs the body of a loop; whether it has left the loop.
    fn is_left(&mut self, body: &Node) -> Eval<bool> {
        self.left = Value::default();
        match self.eval(body) {
            Err(Stop::Break) => Ok(true),
            Err(Stop::Continue) | Ok(_) => Ok(false),
            Err(stop) => Err(stop),
        }
    }

    #[inline(never)]
    fn left_with(&mut self, value: &Node, stop: Stop) -> Eval {
        self.left = self.eval(value)?;
        Err(stop)
    }

    #[inline(never)]
    fn tried(&mut self, of: &Node, at: At) -> Eval {
        let value = self.eval(of)?;
        match value.data {
            Data::Some(value) => Ok(Rc::unwrap_or_clone(value)),
            Data::None => {
                self.left = None.into();
                Err(Stop::Return)
            }
            _ => {
                let name = self.ty(&value).name(&self.code.names);
                let message = format!(
                    "the `?` operator can only be applied to values that implement `Try`, \
                     and this is `{name}`"
                );
                self.refused(Refusal::new(at, message, "", ""))
            }
        }
    }

    #[inline(never)]
    fn block(&mut self, nodes: &[Node], has_value: bool) -> Eval {
        let Some((last, before)) = nodes.split_last() else {
            return Ok(Value::default());
        };
        for node in before {
            match node {
                Node::Mark(mark) => mark.has_run.store(true, Relaxed),
                node => drop(self.eval(node)?),
            }
        }
        let last = self.eval(last)?;
        Ok(if has_value { last } else { Value::default() })
    }
}
