//! Expressions other than calls and control flow.

use std::cmp::Ordering;

use super::lowerer::{Lowered, Lowerer};
use super::places::member_name;
use crate::fault::{Fault, Span};
use crate::integers::{self, named};
use crate::machine::{Code, Exit};
use crate::names::{Item, UNREAD, path_names};
use crate::operators::Op;
use crate::place::Part;
use crate::value::{Shape, Target, Value, kind};

impl Lowerer<'_> {
    pub(super) fn expr(&mut self, expr: &syn::Expr) -> Lowered {
        match expr {
            syn::Expr::Lit(it) => self.literal(&it.lit),
            syn::Expr::Paren(it) => self.expr(&it.expr),
            syn::Expr::Group(it) => self.expr(&it.expr),
            syn::Expr::Path(it) => self.path(&it.path),
            syn::Expr::Unary(it) => self.unary(it),
            syn::Expr::Binary(it) => self.binary(it),
            syn::Expr::Assign(it) => self.assignment(&it.left, &it.right),
            syn::Expr::Call(it) => self.call(it),
            syn::Expr::MethodCall(it) => self.method_call(it),
            syn::Expr::Field(it) => self.field_of_value(it),
            syn::Expr::Index(it) => self.element(it),
            syn::Expr::Closure(it) => self.closure(it),
            syn::Expr::Tuple(it) if it.elems.is_empty() => Ok(Code::unit()),
            syn::Expr::Tuple(it) => self.several(&it.elems, self.at(it), Shape::TUPLE),
            syn::Expr::Array(it) => self.several(&it.elems, self.at(it), Shape::LIST),
            syn::Expr::Repeat(it) => self.repeated(it),
            syn::Expr::Range(it) => self.range(it),
            syn::Expr::Reference(it) if it.mutability.is_none() => self.expr(&it.expr),
            syn::Expr::Reference(it) => self.unread(it, "a `&mut` at this place"),
            syn::Expr::Cast(it) => self.cast(it),
            syn::Expr::Struct(it) => self.structure(it),
            syn::Expr::Macro(it) => self.macro_call(&it.mac),
            _ => self.control_flow(expr),
        }
    }

    /// Lowers an expression that says what runs, and how often.
    fn control_flow(&mut self, expr: &syn::Expr) -> Lowered {
        match expr {
            syn::Expr::Block(it) if it.label.is_none() => self.block(&it.block),
            syn::Expr::If(it) => self.condition(it),
            syn::Expr::Let(it) => self.test(it),
            syn::Expr::Match(it) => self.matching(it),
            syn::Expr::While(it) if it.label.is_none() => self.while_loop(it),
            syn::Expr::Loop(it) if it.label.is_none() => self.endless_loop(it),
            syn::Expr::ForLoop(it) if it.label.is_none() => self.for_loop(it),
            syn::Expr::Break(it) if it.label.is_none() => {
                self.leave(it.expr.as_deref(), Exit::Break, self.at(it))
            }
            syn::Expr::Continue(it) if it.label.is_none() => Ok(Code::act(|_| Err(Exit::Continue))),
            syn::Expr::Return(it) => self.leave(it.expr.as_deref(), Exit::Return, self.at(it)),
            syn::Expr::Try(it) => self.tried(it),
            _ => self.unread(expr, "this kind of expression"),
        }
    }

    fn field_of_value(&mut self, field: &syn::ExprField) -> Lowered {
        let part = Part::Field(self.field(&field.member)?);
        Ok(part.read(self.expr(&field.base)?, self.at(&field.member)))
    }

    fn element(&mut self, element: &syn::ExprIndex) -> Lowered {
        let (list, index) = (self.expr(&element.expr)?, self.expr(&element.index)?);
        let at = self.at(&element.index);
        Ok(Code::act(move |m| {
            let (list, index) = (list.run(m)?, index.run(m)?);
            let n = m.index_in(&list, &index, at)?;
            Ok(list.part(n).unwrap_or_default())
        }))
    }

    pub(super) fn literal(&self, literal: &syn::Lit) -> Lowered {
        let suffix = match literal {
            syn::Lit::Float(it) => it.suffix(),
            syn::Lit::Int(it) => it.suffix(),
            _ => "",
        };
        let number = |digits: &str| Ok(Code::Number(digits.parse().unwrap_or(f64::NAN)));
        match literal {
            syn::Lit::Bool(it) => {
                let truth = it.value;
                Ok(Code::constant(move || Value::Bool(truth)))
            }
            _ if suffix == "f32" => self.unread(literal, "`f32`"),
            syn::Lit::Float(it) if ["", "f64"].contains(&suffix) => number(it.base10_digits()),
            syn::Lit::Int(it) if suffix == "f64" => number(it.base10_digits()),
            syn::Lit::Int(it) if suffix.is_empty() || named(suffix).is_some() => {
                let of = named(suffix).unwrap_or(kind::INT);
                match it.base10_digits().parse() {
                    Ok(number) if of != kind::INT || integers::has(of, number) => {
                        Ok(Code::constant(move || Value::Int(number, of)))
                    }
                    _ => self.unread(literal, "an integer as large as this"),
                }
            }
            syn::Lit::Float(_) | syn::Lit::Int(_) => {
                let message = format!("a number can't end with `{suffix}`");
                self.refused(literal, message)
            }
            syn::Lit::Str(_) => Ok(Code::constant(|| Value::data(Shape::TEXT, []))),
            _ => self.unread(literal, "this kind of literal"),
        }
    }

    /// Lowers the name of a variable, a constant, a function or a variant.
    pub(super) fn path(&mut self, path: &syn::Path) -> Lowered {
        let at = self.at(path);
        if let Some(place) = self.variable(path) {
            return Ok(place.read(at));
        }
        Ok(match (self.target(path)?, self.item(path)?) {
            (Some(Target::Variant(shape)), _) if self.names.variant(shape).fields.is_empty() => {
                Code::constant(move || Value::data(shape, []))
            }
            (Some(target), _) => Code::constant(move || Value::Function(target)),
            (None, Item::Function(n)) => {
                Code::act(move |m| m.apply(&Value::Function(Target::Own(n)), &[], at))
            }
            (None, Item::Native(native)) => match (native.run)(&mut []) {
                Ok(Value::Float(number)) => Code::Number(number),
                Ok(Value::Vec3(vector)) => Code::Vector(vector),
                Ok(Value::Int(number, of)) => Code::constant(move || Value::Int(number, of)),
                _ => return self.refused(path, "this is no value"),
            },
            _ => return self.refused(path, "this is no value"),
        })
    }

    /// Returns what a path means that is no variable.
    pub(super) fn item(&self, path: &syn::Path) -> Lowered<Item> {
        let names = path_names(path);
        let (at, last) = (self.at(path), &names[names.len() - 1]);
        match self.names.find(&names, self.scope) {
            Some(item) if names.iter().all(|name| name != "f32") => return Ok(item),
            _ => {}
        }
        let is_unread = |name: &String| UNREAD.contains(&name.as_str());
        if let Some(name) = names.iter().find(|name| is_unread(name)) {
            return Err(Fault::unread(at, format!("`{name}`")));
        }
        if names.len() > 1 {
            return Err(self.unread_function(at, last));
        }
        let variables = self.variables.iter().map(|it| it.0.as_str());
        let known = self.names.items.keys().map(String::as_str).chain(variables);
        let fault = Fault::refused(at, format!("there is no variable or function `{last}`"));
        Err(fault.or_meant(last, known))
    }

    /// Makes the fault of a function that is not known here, though Rust may have it.
    pub(super) fn unread_function(&self, at: Span, name: &str) -> Fault {
        let known = self.names.functions_of_types();
        Fault::unread(at, format!("`{name}`")).or_meant(name, known)
    }

    fn unary(&mut self, unary: &syn::ExprUnary) -> Lowered {
        let (of, at) = (self.expr(&unary.expr)?, self.at(unary));
        match (&unary.op, of) {
            (syn::UnOp::Deref(_), of) => Ok(of),
            (syn::UnOp::Neg(_), Code::Number(it)) => Ok(Code::Number(-it)),
            (syn::UnOp::Neg(_), of) => Ok(Code::act(move |m| {
                let value = of.run(m)?;
                m.negated(&value, at)
            })),
            (syn::UnOp::Not(_), of) => Ok(Code::act(move |m| Ok((!m.truth(&of, at)?).into()))),
            _ => self.unread(unary, "this operator"),
        }
    }

    fn binary(&mut self, binary: &syn::ExprBinary) -> Lowered {
        use syn::BinOp::{And, Eq, Ge, Gt, Le, Lt, Ne, Or};
        let op = Op::of_syntax(&binary.op);
        if let Some((op, true)) = op {
            return self.update(op, binary);
        }
        let (left, right) = (self.expr(&binary.left)?, self.expr(&binary.right)?);
        let at = self.at(&binary.op);
        if let Some((op, false)) = op {
            return Ok(op.code(left, right, at));
        }
        Ok(match binary.op {
            Lt(_) => order(left, right, Ordering::is_lt, at),
            Le(_) => order(left, right, Ordering::is_le, at),
            Gt(_) => order(left, right, Ordering::is_gt, at),
            Ge(_) => order(left, right, Ordering::is_ge, at),
            Eq(_) => equality(left, right, true, at),
            Ne(_) => equality(left, right, false, at),
            And(_) => self.join(binary, [left, right], true),
            Or(_) => self.join(binary, [left, right], false),
            _ => return self.unread(&binary.op, "this operator between numbers"),
        })
    }

    /// Returns the code of `&&`, which goes on where the left is true, or of `||`.
    fn join(&self, binary: &syn::ExprBinary, sides: [Code; 2], goes_on: bool) -> Code {
        let ends = [self.at(&binary.left), self.at(&binary.right)];
        Code::act(move |m| match m.truth(&sides[0], ends[0])? == goes_on {
            true => m.truth(&sides[1], ends[1]).map(Value::from),
            false => Ok((!goes_on).into()),
        })
    }

    /// Lowers the parts of a tuple or an array.
    fn several<'s>(
        &mut self,
        all: impl IntoIterator<Item = &'s syn::Expr>,
        at: Span,
        shape: Shape,
    ) -> Lowered {
        let all = all.into_iter().map(|part| self.expr(part));
        let all = all.collect::<Lowered<Vec<_>>>()?;
        Ok(Code::act(move |m| m.gather(shape, &all, at)))
    }

    fn repeated(&mut self, repeat: &syn::ExprRepeat) -> Lowered {
        let (value, count) = (self.expr(&repeat.expr)?, self.expr(&repeat.len)?);
        let at = self.at(repeat);
        Ok(Code::act(move |m| match (value.run(m)?, count.run(m)?) {
            (value, Value::Int(count, kind::INT | kind::USIZE)) => {
                m.spend(count as usize, at)?;
                m.keep(Value::list(vec![value; count as usize]), at)
            }
            (_, other) => m.mismatch(at, "usize", other.kind()),
        }))
    }

    fn range(&mut self, range: &syn::ExprRange) -> Lowered {
        let mut end = |end: &Option<Box<syn::Expr>>| match end {
            Some(end) => self.expr(end),
            None => Ok(Code::unit()),
        };
        let (start, end) = (end(&range.start)?, end(&range.end)?);
        let is_closed = matches!(range.limits, syn::RangeLimits::Closed(_));
        let is_closed = Code::constant(move || is_closed.into());
        let (all, at) = ([start, end, is_closed], self.at(range));
        Ok(Code::act(move |m| {
            let range = m.gather(Shape::RANGE, &all, at)?;
            match range.parts() {
                [Value::Float(_), Value::Unit, _] | [Value::Unit, ..] => {
                    m.unread(at, "a range that is open at an end")
                }
                _ => Ok(range),
            }
        }))
    }

    fn cast(&mut self, cast: &syn::ExprCast) -> Lowered {
        let (from, at) = (self.expr(&cast.expr)?, self.at(cast));
        let to = self.names.ty(&cast.ty, self.scope)?;
        Ok(Code::act(move |m| {
            let value = from.run(m)?;
            match integers::cast(&value, to) {
                Some(value) => Ok(value),
                None => m.unread(at, "`as` between these types"),
            }
        }))
    }

    fn structure(&mut self, structure: &syn::ExprStruct) -> Lowered {
        let (shape, at) = (self.shape(&structure.path)?, self.at(structure));
        let declared = &self.names.variant(shape).fields;
        let mut fields: Vec<Option<Code>> = declared.iter().map(|_| None).collect();
        for field in &structure.fields {
            let n = self.field_of(shape, &field.member)?;
            fields[n] = Some(self.given(&field.expr, declared[n].1)?);
        }
        // The fields that `..` gives are read from a variable of their own.
        let (rest, slot) = (self.rest(structure, shape)?, self.slot());
        let mut codes = Vec::new();
        for (n, code) in fields.into_iter().enumerate() {
            codes.push(match (code, &rest) {
                (Some(code), _) => code,
                (None, Some(_)) => Part::Number(n).read(Code::Local(slot), at),
                (None, None) => {
                    let message = format!("the field `{}` is missing", declared[n].0);
                    return self.refused(structure, message);
                }
            });
        }
        Ok(Code::act(move |m| {
            if let Some(rest) = &rest {
                *m.local_mut(slot) = rest.run(m)?;
            }
            m.gather(shape, &codes, at)
        }))
    }

    /// Lowers what stands behind `..` in a struct.
    fn rest(&mut self, structure: &syn::ExprStruct, shape: Shape) -> Lowered<Option<Code>> {
        Ok(match structure.rest.as_deref() {
            Some(syn::Expr::Call(call)) if is_default(&call.func) => {
                let target = match self.names.associated(shape.kind, "default") {
                    Some(Item::Function(n)) => Target::Own(n),
                    Some(Item::Default(kind)) => Target::Default(kind),
                    _ => return self.refused(call, "this type has no default value"),
                };
                Some(self.call_of(target, Vec::new(), self.at(call))?)
            }
            Some(rest) => Some(self.given(rest, shape.kind)?),
            None => None,
        })
    }

    /// Returns the struct or the variant that a path names.
    pub(super) fn shape(&self, path: &syn::Path) -> Lowered<Shape> {
        match self.item(path)? {
            Item::Variant(shape) => Ok(shape),
            Item::Type(kind) if self.names.kind(kind).variants.len() == 1 => {
                Ok(Shape::new(kind, 0))
            }
            _ => self.refused(path, "this is no struct"),
        }
    }

    /// Returns the number of a field of a struct.
    pub(super) fn field_of(&self, shape: Shape, member: &syn::Member) -> Lowered<usize> {
        let (name, variant) = (member_name(member), self.names.variant(shape));
        let known = variant.fields.iter().map(|it| it.0.as_str());
        let fault = Fault::refused(self.at(member), format!("there is no field `{name}`"));
        variant
            .field(&name)
            .ok_or_else(|| fault.or_meant(&name, known))
    }
}

/// Returns true for `Default::default`.
fn is_default(function: &syn::Expr) -> bool {
    matches!(function, syn::Expr::Path(it) if path_names(&it.path) == ["Default", "default"])
}

/// Returns the code that compares numbers.
fn order(left: Code, right: Code, is_true: fn(Ordering) -> bool, at: Span) -> Code {
    Code::act(move |m| {
        if let (Some(a), Some(b)) = (left.number(m), right.number(m)) {
            return Ok(a.partial_cmp(&b).is_some_and(is_true).into());
        }
        let (a, b) = (left.run(m)?, right.run(m)?);
        Ok(m.order(&a, &b, at)?.is_some_and(is_true).into())
    })
}

/// Returns the code of `==` or `!=`.
fn equality(left: Code, right: Code, wanted: bool, at: Span) -> Code {
    Code::act(move |m| {
        let (a, b) = (left.run(m)?, right.run(m)?);
        Ok((m.equal(&a, &b, at)? == wanted).into())
    })
}
