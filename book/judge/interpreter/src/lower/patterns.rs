//! Patterns: what a value may look like, and the names of its parts.

use super::places::member;
use super::{Expr, Lowered, Lowerer};
use crate::machine::value::{Data, Value};
use crate::machine::{Eval, Form, Machine, Run};
use crate::names::Named;
use crate::refusal::{At, Refusal};
use crate::types::{Head, Type};

type Bind = dyn Fn(&mut Machine<'_>, &Value) -> Eval<bool> + Send + Sync;

/// What finds whether a value matches and gives its parts their names.
pub(super) struct Pattern {
    bind: Box<Bind>,
    shape: Shape,
    /// The slot of its name, if it is a name alone.
    pub(super) slot: Option<usize>,
}

/// What a pattern shows of the values that match it.
#[derive(PartialEq)]
enum Shape {
    Any,
    None,
    Some,
    Bool(bool),
    Number,
    Or(Vec<Shape>),
    Other,
}

impl Pattern {
    fn new(
        shape: Shape,
        bind: impl Fn(&mut Machine<'_>, &Value) -> Eval<bool> + Send + Sync + 'static,
    ) -> Self {
        Self {
            bind: Box::new(bind),
            shape,
            slot: None,
        }
    }

    /// Finds whether a value matches; if so, its parts have their names.
    pub(super) fn binds(&self, m: &mut Machine<'_>, value: &Value) -> Eval<bool> {
        (self.bind)(m, value)
    }
}

impl Lowerer<'_> {
    /// Lowers a pattern that must match each value.
    pub(super) fn irrefutable(&mut self, it: &syn::Pat) -> Lowered<Pattern> {
        let pattern = self.pattern(it, false)?;
        if matches!(pattern.shape, Shape::Any) {
            return Ok(pattern);
        }
        let message = "refutable pattern in local binding";
        let help = "`let … else { … }`, or `if let`";
        self.fault(self.at_any(it), message, "", help)
    }

    /// Lowers a pattern. Its names are variables from now on, which may get their values later.
    pub(super) fn pattern(&mut self, it: &syn::Pat, is_late: bool) -> Lowered<Pattern> {
        let at = self.at_any(it);
        Ok(match it {
            syn::Pat::Wild(_) => Pattern::new(Shape::Any, |_, _| Ok(true)),
            syn::Pat::Paren(it) => self.pattern(&it.pat, is_late)?,
            syn::Pat::Type(it) => {
                let ty = self.names.ty(&self.context, &it.ty)?;
                let Pattern { bind, shape, .. } = self.pattern(&it.pat, is_late)?;
                Pattern::new(shape, move |m, value| {
                    let value = m.as_declared(value.clone(), &ty, at.into())?;
                    bind(m, &value)
                })
            }
            syn::Pat::Ident(it) => self.name(it, is_late)?,
            syn::Pat::Reference(it) if it.mutability.is_none() => {
                let Pattern { bind, shape, .. } = self.pattern(&it.pat, is_late)?;
                Pattern::new(shape, move |m, value| {
                    let value = without_reference(m, value, at)?;
                    bind(m, &value)
                })
            }
            syn::Pat::TupleStruct(it) => self.tuple_struct_pattern(it, at)?,
            syn::Pat::Struct(it) => {
                let ty = self.struct_named(&it.path)?;
                let mut fields = Vec::new();
                for field in &it.fields {
                    let (n, _) = self.field_of(&ty, &member(&field.member), at)?;
                    fields.push((n, self.pattern(&field.pat, false)?));
                }
                structure(ty.0, fields, at)
            }
            syn::Pat::Tuple(it) => {
                let all = self.all(&it.elems, is_late)?;
                let count = all.len();
                let found = Type(Head::Tuple, vec![Type::UNKNOWN; count]);
                parts(all, found, at, move |it| {
                    matches!(it, Data::Tuple(all) if all.len() == count).then_some(true)
                })
            }
            syn::Pat::Slice(it) => {
                let all = self.all(&it.elems, is_late)?;
                let count = all.len();
                let found = Type::of(Head::Array(count), Type::UNKNOWN);
                parts(all, found, at, move |it| match it {
                    Data::List(list) if list.all.len() == count => Some(true),
                    Data::List(list) if !list.is_array => Some(false),
                    _ => None,
                })
            }
            syn::Pat::Or(it) => self.alternatives(it)?,
            syn::Pat::Lit(it) => equal(self.literal(&it.lit)?, literal_shape(&it.lit)),
            syn::Pat::Path(it) => equal(self.path(it)?, Shape::Other),
            syn::Pat::Range(it) => self.within(it)?,
            _ => return self.unread(at, "this kind of pattern"),
        })
    }

    fn all<'p>(
        &mut self,
        all: impl IntoIterator<Item = &'p syn::Pat>,
        is_late: bool,
    ) -> Lowered<Vec<(usize, Pattern)>> {
        let all = all.into_iter().enumerate();
        all.map(|(n, it)| Ok((n, self.pattern(it, is_late)?)))
            .collect()
    }

    /// Lowers a name for what is there, or that of a constant.
    fn name(&mut self, it: &syn::PatIdent, is_late: bool) -> Lowered<Pattern> {
        let at = self.at_any(it);
        let name = it.ident.to_string();
        if name == "None" {
            return Ok(option(None, at));
        }
        if it.by_ref.is_some() {
            return self.unread(at, "patterns with `ref`");
        }
        if let Ok(Named::Function(function)) = self
            .names
            .found(self.context.module, std::slice::from_ref(&name))
            && self.names.functions[function].is_constant
        {
            let constant = Expr::new(at, move |m| m.constant(function, at));
            return Ok(equal(constant, Shape::Other));
        }
        let of = it.subpat.as_ref().map(|(_, of)| self.pattern(of, is_late));
        let of = of.transpose()?;
        let known = self.alternatives.and_then(|start| {
            let mut known = self.locals[start..].iter();
            known.find(|it| it.name == name).map(|it| it.slot)
        });
        let is_mut = it.mutability.is_some() || is_late;
        let slot = known.unwrap_or_else(|| self.local(&name, is_mut));
        let name = Pattern::new(Shape::Any, move |m, value| {
            m.set_local(slot, value.clone());
            Ok(true)
        });
        Ok(match of {
            None => Pattern {
                slot: Some(slot),
                ..name
            },
            Some(Pattern { bind, shape, .. }) => Pattern::new(shape, move |m, value| {
                Ok(name.binds(m, value)? && bind(m, value)?)
            }),
        })
    }

    /// Lowers several patterns with the same names.
    fn alternatives(&mut self, it: &syn::PatOr) -> Lowered<Pattern> {
        let outer = self.alternatives;
        self.alternatives = outer.or(Some(self.locals.len()));
        let all = self.all(&it.cases, false);
        self.alternatives = outer;
        let all = all?.into_iter().map(|(_, it)| (it.shape, it.bind));
        let (shapes, binds): (Vec<_>, Vec<_>) = all.unzip();
        Ok(Pattern::new(Shape::Or(shapes), move |m, value| {
            for bind in &binds {
                if bind(m, value)? {
                    return Ok(true);
                }
            }
            Ok(false)
        }))
    }

    /// Lowers a pattern of numbers from one to another.
    fn within(&mut self, it: &syn::PatRange) -> Lowered<Pattern> {
        let mut end = |it: &Option<Box<syn::Expr>>| match it {
            Some(it) => self.expr(it).map(Some),
            None => Ok(None),
        };
        let ends = [end(&it.start)?, end(&it.end)?];
        let is_closed = matches!(it.limits, syn::RangeLimits::Closed(_));
        Ok(Pattern::new(Shape::Other, move |m, value| {
            let value = m.end_of(value).owned();
            for (n, end) in ends.iter().enumerate() {
                let Some(Expr { run, spot }) = end else {
                    continue;
                };
                let end = run.eval(m)?;
                m.must_be_like(&end, &value, *spot)?;
                let is_inside = value.compared(&end).is_some_and(|order| match n {
                    0 => order.is_ge(),
                    _ => order.is_lt() || is_closed && order.is_eq(),
                });
                if !is_inside {
                    return Ok(false);
                }
            }
            Ok(true)
        }))
    }

    fn tuple_struct_pattern(&mut self, it: &syn::PatTupleStruct, at: At) -> Lowered<Pattern> {
        if it.path.is_ident("Some") && it.elems.len() == 1 {
            let of = self.pattern(&it.elems[0], false)?;
            return Ok(option(Some(of), at));
        }
        let ty = self.struct_named(&it.path)?;
        let (count, given) = (self.names.fields(&ty).len(), it.elems.len());
        if count != given {
            let message = format!(
                "this pattern has {given} fields, but the corresponding tuple struct has {count}"
            );
            return self.refused(at, message);
        }
        let all = self.all(&it.elems, false)?;
        Ok(structure(ty.0, all, at))
    }

    /// Lowers `match`, whose arms come to a value of that type.
    pub(super) fn matching(&mut self, it: &syn::ExprMatch, ty: &Type) -> Lowered {
        struct Arm {
            pattern: Pattern,
            guard: Option<Run>,
            body: Run,
        }
        let of = self.expr(&it.expr)?.run;
        let (mut arms, mut is_left) = (Vec::new(), !it.arms.is_empty());
        for arm in &it.arms {
            let (pattern, guard) = match &arm.pat {
                syn::Pat::Guard(it) => (&*it.pat, Some(&it.guard)),
                pattern => (pattern, None),
            };
            let (pattern, guard, mut body) = self.scoped(|own| {
                let pattern = own.pattern(pattern, false)?;
                let guard = guard.map(|it| own.given(it, &Type::BOOL)).transpose()?;
                Ok((pattern, guard.map(|it| it.run), own.given(&arm.body, ty)?))
            })?;
            is_left &= body.never_ends();
            if !matches!(*arm.body, syn::Expr::Block(_)) {
                body = self.marked(body, self.at(&arm.body));
            }
            let body = body.run;
            arms.push(Arm {
                pattern,
                guard,
                body,
            });
        }
        let shapes = arms
            .iter()
            .map(|it| (&it.pattern.shape, it.guard.is_none()));
        if let Some(missing) = missing(&shapes.collect::<Vec<_>>()) {
            let message = format!("non-exhaustive patterns: `{missing}` not covered");
            return self.refused(self.at(&it.expr), message);
        }
        let at = self.at_any(&it.match_token);
        let made = Expr::new(at, move |m| {
            let value = of.eval(m)?;
            for arm in &arms {
                let is_it = arm.pattern.binds(m, &value)?;
                if is_it
                    && arm
                        .guard
                        .as_ref()
                        .map_or(Ok(true), |it| Ok(it.eval(m)?.truth()))?
                {
                    return arm.body.eval(m);
                }
            }
            m.wrong(at, "non-exhaustive patterns: no arm matches this value", "")
        });
        Ok(if is_left {
            made.shown(Form::Never)
        } else {
            made
        })
    }
}

/// Makes a pattern of those of some parts. Of a value it is asked whether it matches, if it is
/// of the right type.
fn parts(
    all: Vec<(usize, Pattern)>,
    found: Type,
    at: At,
    is_it: impl Fn(&Data) -> Option<bool> + Send + Sync + 'static,
) -> Pattern {
    let is_any = all.iter().all(|it| matches!(it.1.shape, Shape::Any));
    let shape = if is_any { Shape::Any } else { Shape::Other };
    Pattern::new(shape, move |m, value| {
        let whole = m.end_of(value);
        match is_it(&whole.data) {
            Some(true) => {}
            Some(false) => return Ok(false),
            None => {
                let wanted = m.ty(&whole);
                let said = found.said(&m.code.names);
                let refusal = m.code.names.mismatch(&wanted, &found, &said, at);
                return m.refused(refusal);
            }
        }
        for (n, of) in &all {
            // A part of a value behind a reference is behind one, too.
            let part = match &value.data {
                Data::Mut(address) => Data::Mut(address.part(*n)).into(),
                _ => whole.part(*n).more_lent(whole.lent.min(1)),
            };
            if !of.binds(m, &part)? {
                return Ok(false);
            }
        }
        Ok(true)
    })
}

/// Makes a pattern of one that what is there matches, or of nothing.
fn option(of: Option<Pattern>, at: At) -> Pattern {
    let shape = if of.is_some() {
        Shape::Some
    } else {
        Shape::None
    };
    let is_some = of.is_some();
    let found = Type::of(Head::Option, Type::UNKNOWN);
    let all = of.into_iter().map(|it| (0, it)).collect();
    let pattern = parts(all, found, at, move |it| match it {
        Data::Some(_) => Some(is_some),
        Data::None => Some(!is_some),
        _ => None,
    });
    Pattern { shape, ..pattern }
}

fn structure(head: Head, fields: Vec<(usize, Pattern)>, at: At) -> Pattern {
    parts(fields, head.into(), at, move |it| {
        (it.head() == head).then_some(true)
    })
}

/// Makes a pattern of what is equal to a value.
fn equal(of: Expr, shape: Shape) -> Pattern {
    Pattern::new(shape, move |m, value| {
        let wanted = of.run.eval(m)?.owned();
        let value = m.end_of(value).owned();
        m.must_be_like(&wanted, &value, of.spot)?;
        Ok(wanted.equals(&value))
    })
}

fn literal_shape(it: &syn::Lit) -> Shape {
    match it {
        syn::Lit::Bool(it) => Shape::Bool(it.value),
        syn::Lit::Int(_) | syn::Lit::Float(_) => Shape::Number,
        _ => Shape::Other,
    }
}

/// Returns what the reference that a `&` in a pattern wants leads to.
fn without_reference(m: &mut Machine<'_>, value: &Value, at: At) -> Eval {
    if let Some(lent) = value.lent.checked_sub(1) {
        let data = value.data.clone();
        return Ok(Value { lent, data });
    }
    let said = m.ty(value).said(&m.code.names);
    let label = format!("expected {said}, found reference");
    m.refused(Refusal::new(
        at,
        "mismatched types",
        &label,
        "leave the `&` out",
    ))
}

/// Finds what no arm matches, where that is plain: of options, of what is true or not, of
/// numbers. Of each arm it is known whether it has no guard.
fn missing(arms: &[(&Shape, bool)]) -> Option<&'static str> {
    fn flat<'s>(shape: &'s Shape, is_sure: bool, all: &mut Vec<(&'s Shape, bool)>) {
        match shape {
            Shape::Or(ways) => ways.iter().for_each(|it| flat(it, is_sure, all)),
            shape => all.push((shape, is_sure)),
        }
    }
    let mut all = Vec::new();
    for &(shape, is_sure) in arms {
        flat(shape, is_sure, &mut all);
    }
    let has = |wanted: Shape| all.iter().any(|it| *it.0 == wanted);
    let sure = |wanted: &Shape| all.iter().any(|it| it.1 && it.0 == wanted);
    let ways = if sure(&Shape::Any) || all.is_empty() {
        return None;
    } else if has(Shape::Bool(true)) || has(Shape::Bool(false)) {
        [(Shape::Bool(true), "true"), (Shape::Bool(false), "false")]
    } else if has(Shape::None) || has(Shape::Some) {
        [(Shape::None, "None"), (Shape::Some, "Some(_)")]
    } else {
        let is_number = |it: &(&Shape, bool)| *it.0 == Shape::Number;
        return all.iter().all(is_number).then_some("_");
    };
    ways.into_iter().find(|it| !sure(&it.0)).map(|it| it.1)
}
