//! Pattern matching: tests of a value's shape that bind its parts to variables.

use super::places::member;
use super::{Expr, Lowered, Lowerer};
use crate::machine::value::{Data, Value};
use crate::machine::{Eval, Machine};
use crate::names::Meaning;
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

/// A function that returns true if a value matches a pattern, and then sets the pattern's
/// variables.
type MatchFn = dyn Fn(&mut Machine<'_>, &Value) -> Eval<bool> + Send + Sync;

/// A pattern that was lowered.
pub(super) struct Matcher {
    bind: Box<MatchFn>,
    /// The values that the pattern may match: [`Coverage::Some`] for every `Some(…)`.
    pub(super) shape: Coverage,
    /// The slot of its variable, if the pattern is one name.
    pub(super) slot: Option<usize>,
}

/// The values that a pattern matches, as far as its text shows.
#[derive(PartialEq)]
pub(super) enum Coverage {
    Any,
    None,
    Some,
    Bool(bool),
    Number,
    Or(Vec<Coverage>),
    Other,
}

impl Matcher {
    fn new(
        shape: Coverage,
        bind: impl Fn(&mut Machine<'_>, &Value) -> Eval<bool> + Send + Sync + 'static,
    ) -> Self {
        Self {
            bind: Box::new(bind),
            shape,
            slot: None,
        }
    }

    /// Returns true if a value matches, and then sets the pattern's variables.
    pub(super) fn binds(&self, m: &mut Machine<'_>, value: &Value) -> Eval<bool> {
        (self.bind)(m, value)
    }
}

impl Lowerer<'_> {
    /// Lowers a pattern, and refuses one that a value may not match.
    pub(super) fn irrefutable(&mut self, it: &syn::Pat) -> Lowered<Matcher> {
        let pattern = self.pattern(it, false)?;
        if matches!(pattern.shape, Coverage::Any) {
            return Ok(pattern);
        }
        let message = "refutable pattern in local binding";
        let help = "`let … else { … }`, or `if let`";
        self.fault(self.at_any(it), message, "", help)
    }

    /// Lowers a pattern and declares its variables. If `is_late`, they get their values by later
    /// assignments.
    pub(super) fn pattern(&mut self, it: &syn::Pat, is_late: bool) -> Lowered<Matcher> {
        let at = self.at_any(it);
        Ok(match it {
            syn::Pat::Wild(_) => Matcher::new(Coverage::Any, |_, _| Ok(true)),
            syn::Pat::Paren(it) => self.pattern(&it.pat, is_late)?,
            syn::Pat::Type(it) => {
                let ty = self.names.ty(&self.context, &it.ty)?;
                let Matcher { bind, shape, .. } = self.pattern(&it.pat, is_late)?;
                Matcher::new(shape, move |m, value| {
                    let value = m.as_declared(value.clone(), &ty, at.into())?;
                    bind(m, &value)
                })
            }
            syn::Pat::Ident(it) => self.name(it, is_late)?,
            syn::Pat::Reference(it) if it.mutability.is_none() => {
                let Matcher { bind, shape, .. } = self.pattern(&it.pat, is_late)?;
                Matcher::new(shape, move |m, value| {
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
                let found = Type(Ctor::Tuple, vec![Type::UNKNOWN; count]);
                parts(all, found, at, move |it| {
                    matches!(it, Data::Tuple(all) if all.len() == count).then_some(true)
                })
            }
            syn::Pat::Slice(it) => list(self.all(&it.elems, is_late)?, at),
            syn::Pat::Or(it) => self.alternatives(it)?,
            syn::Pat::Lit(it) => equal(self.literal(&it.lit)?, literal_shape(&it.lit)),
            syn::Pat::Path(it) => equal(self.path(it)?, Coverage::Other),
            syn::Pat::Range(it) => self.within(it)?,
            _ => return self.unread(at, "this kind of pattern"),
        })
    }

    /// Lowers the patterns of parts, with their numbers.
    fn all<'p>(
        &mut self,
        all: impl IntoIterator<Item = &'p syn::Pat>,
        is_late: bool,
    ) -> Lowered<Vec<(usize, Matcher)>> {
        let all = all.into_iter().enumerate();
        all.map(|(n, it)| Ok((n, self.pattern(it, is_late)?)))
            .collect()
    }

    /// Lowers a name: a new variable, `None`, or a constant.
    fn name(&mut self, it: &syn::PatIdent, is_late: bool) -> Lowered<Matcher> {
        let at = self.at_any(it);
        let name = it.ident.to_string();
        if name == "None" {
            return Ok(option(None, at));
        }
        if it.by_ref.is_some() {
            return self.unread(at, "patterns with `ref`");
        }
        if let Ok(Meaning::Function(function)) = self
            .names
            .found(self.context.module, std::slice::from_ref(&name))
            && self.names.functions[function].is_constant
        {
            let constant = Expr::new(at, move |m| m.constant(function, at));
            return Ok(equal(constant, Coverage::Other));
        }
        let of = it.subpat.as_ref().map(|(_, of)| self.pattern(of, is_late));
        let of = of.transpose()?;
        let known = self.alternatives.and_then(|start| {
            let mut known = self.locals[start..].iter();
            known.find(|it| it.name == name).map(|it| it.slot)
        });
        let is_mut = it.mutability.is_some() || is_late;
        let slot = known.unwrap_or_else(|| self.local(&name, is_mut));
        let name = Matcher::new(Coverage::Any, move |m, value| {
            m.set_local(slot, value.clone());
            Ok(true)
        });
        Ok(match of {
            None => Matcher {
                slot: Some(slot),
                ..name
            },
            Some(Matcher { bind, shape, .. }) => Matcher::new(shape, move |m, value| {
                Ok(name.binds(m, value)? && bind(m, value)?)
            }),
        })
    }

    /// Lowers a pattern with `|`, whose alternatives share their variables.
    fn alternatives(&mut self, it: &syn::PatOr) -> Lowered<Matcher> {
        let outer = self.alternatives;
        self.alternatives = outer.or(Some(self.locals.len()));
        let all = self.all(&it.cases, false);
        self.alternatives = outer;
        let all = all?.into_iter().map(|(_, it)| (it.shape, it.bind));
        let (shapes, binds): (Vec<_>, Vec<_>) = all.unzip();
        Ok(Matcher::new(Coverage::Or(shapes), move |m, value| {
            for bind in &binds {
                if bind(m, value)? {
                    return Ok(true);
                }
            }
            Ok(false)
        }))
    }

    /// Lowers a pattern that is a range of numbers.
    fn within(&mut self, it: &syn::PatRange) -> Lowered<Matcher> {
        let mut end = |it: &Option<Box<syn::Expr>>| match it {
            Some(it) => self.expr(it).map(Some),
            None => Ok(None),
        };
        let ends = [end(&it.start)?, end(&it.end)?];
        let is_closed = matches!(it.limits, syn::RangeLimits::Closed(_));
        Ok(Matcher::new(Coverage::Other, move |m, value| {
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

    /// Lowers `Some(…)` or the pattern of a tuple struct.
    fn tuple_struct_pattern(&mut self, it: &syn::PatTupleStruct, at: Span) -> Lowered<Matcher> {
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
}

/// Makes a matcher of those of a value's parts. `is_it` returns `None` for a value of another type
/// than `found`, and else true if it has these parts.
fn parts(
    all: Vec<(usize, Matcher)>,
    found: Type,
    at: Span,
    is_it: impl Fn(&Data) -> Option<bool> + Send + Sync + 'static,
) -> Matcher {
    let is_any = all.iter().all(|it| matches!(it.1.shape, Coverage::Any));
    let shape = match is_any {
        true => Coverage::Any,
        false => Coverage::Other,
    };
    Matcher::new(shape, move |m, value| {
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

/// Makes a matcher for `Some` of what `of` matches, or for `None`.
fn option(of: Option<Matcher>, at: Span) -> Matcher {
    let is_some = of.is_some();
    let shape = match is_some {
        true => Coverage::Some,
        false => Coverage::None,
    };
    let found = Type::of(Ctor::Option, Type::UNKNOWN);
    let all = of.into_iter().map(|it| (0, it)).collect();
    let pattern = parts(all, found, at, move |it| match it {
        Data::Some(_) => Some(is_some),
        Data::None => Some(!is_some),
        _ => None,
    });
    Matcher { shape, ..pattern }
}

/// Makes a matcher for an array or a slice of just these elements.
fn list(all: Vec<(usize, Matcher)>, at: Span) -> Matcher {
    let count = all.len();
    let found = Type::of(Ctor::Array(count), Type::UNKNOWN);
    parts(all, found, at, move |it| match it {
        Data::List(list) if list.all.len() == count => Some(true),
        Data::List(list) if !list.is_array => Some(false),
        _ => None,
    })
}

/// Makes a matcher for a struct by some of its fields.
fn structure(ctor: Ctor, fields: Vec<(usize, Matcher)>, at: Span) -> Matcher {
    parts(fields, ctor.into(), at, move |it| {
        (it.ctor() == ctor).then_some(true)
    })
}

/// Makes a matcher for a value that is equal to an expression.
fn equal(of: Expr, shape: Coverage) -> Matcher {
    Matcher::new(shape, move |m, value| {
        let wanted = of.run.eval(m)?.owned();
        let value = m.end_of(value).owned();
        m.must_be_like(&wanted, &value, of.spot)?;
        Ok(wanted.equals(&value))
    })
}

/// Returns the values that a literal matches.
fn literal_shape(it: &syn::Lit) -> Coverage {
    match it {
        syn::Lit::Bool(it) => Coverage::Bool(it.value),
        syn::Lit::Int(_) | syn::Lit::Float(_) => Coverage::Number,
        _ => Coverage::Other,
    }
}

/// Returns the value behind one `&`, which a pattern with `&` wants; stops if it has none.
fn without_reference(m: &mut Machine<'_>, value: &Value, at: Span) -> Eval {
    if let Some(lent) = value.lent.checked_sub(1) {
        let data = value.data.clone();
        return Ok(Value { lent, data });
    }
    let said = m.ty(value).said(&m.code.names);
    let label = format!("expected {said}, found reference");
    let refusal = Refusal::new(at, "mismatched types", &label, "leave the `&` out");
    m.refused(refusal)
}
