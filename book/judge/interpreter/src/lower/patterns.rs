//! Patterns: what a value may look like, and the names of its parts.

use super::places::member;
use super::{Lowered, Lowerer};
use crate::names::Named;
use crate::node::{Arm, Node, Pattern};
use crate::refusal::At;
use crate::types::{Head, Type};

impl Lowerer<'_> {
    /// A pattern that must match each value.
    pub(super) fn irrefutable(&mut self, it: &syn::Pat) -> Lowered<Pattern> {
        let pattern = self.pattern(it, false)?;
        if pattern.is_irrefutable() {
            return Ok(pattern);
        }
        let message = "refutable pattern in local binding";
        let help = "`let … else { … }`, or `if let`";
        self.fault(self.at_any(it), message, "", help)
    }

    /// A pattern. Its names are variables from now on, which may get their values later.
    pub(super) fn pattern(&mut self, it: &syn::Pat, is_late: bool) -> Lowered<Pattern> {
        let at = self.at_any(it);
        Ok(match it {
            syn::Pat::Wild(_) => Pattern::Any,
            syn::Pat::Paren(it) => self.pattern(&it.pat, is_late)?,
            syn::Pat::Type(it) => {
                let written = self.names.ty(&self.context, &it.ty)?;
                let of = self.pattern(&it.pat, is_late)?;
                Pattern::Typed(Box::new(of), written, at)
            }
            syn::Pat::Ident(it) => self.name(it, is_late)?,
            syn::Pat::Reference(it) if it.mutability.is_none() => {
                let of = self.pattern(&it.pat, is_late)?;
                Pattern::Ref(Box::new(of), at)
            }
            syn::Pat::TupleStruct(it) => self.tuple_struct_pattern(it, at)?,
            syn::Pat::Struct(it) => {
                let ty = self.struct_named(&it.path)?;
                let mut fields = Vec::new();
                for field in &it.fields {
                    let (n, _) = self.field_of(&ty, &member(&field.member), at)?;
                    fields.push((n, self.pattern(&field.pat, false)?));
                }
                Pattern::Struct(ty.0, fields, at)
            }
            syn::Pat::Tuple(it) => {
                let is_rest = |it: &syn::Pat| matches!(it, syn::Pat::Rest(_));
                if it.elems.iter().any(is_rest) {
                    return self.unread(at, "`..` in a tuple");
                }
                let all = self.all(&it.elems, is_late)?;
                Pattern::Tuple(all.len(), all.into_iter().enumerate().collect(), at)
            }
            syn::Pat::Slice(it) => Pattern::List(self.all(&it.elems, is_late)?, at),
            syn::Pat::Or(it) => self.alternatives(it)?,
            syn::Pat::Lit(it) => Pattern::Equal(self.literal(&it.lit)?, at),
            syn::Pat::Path(it) => Pattern::Equal(self.path(it)?, at),
            syn::Pat::Range(it) => {
                let mut end =
                    |it: &Option<Box<syn::Expr>>| it.as_ref().map(|it| self.expr(it)).transpose();
                let (start, end) = (end(&it.start)?, end(&it.end)?);
                let is_closed = matches!(it.limits, syn::RangeLimits::Closed(_));
                Pattern::Within(start, end, is_closed, at)
            }
            _ => return self.unread(at, "this kind of pattern"),
        })
    }

    fn all<'p>(
        &mut self,
        all: impl IntoIterator<Item = &'p syn::Pat>,
        is_late: bool,
    ) -> Lowered<Vec<Pattern>> {
        let all = all.into_iter();
        all.map(|it| self.pattern(it, is_late)).collect()
    }

    /// A name for what is there, or that of a constant.
    fn name(&mut self, it: &syn::PatIdent, is_late: bool) -> Lowered<Pattern> {
        let at = self.at_any(it);
        let name = it.ident.to_string();
        if name == "None" {
            return Ok(Pattern::None);
        }
        if it.by_ref.is_some() {
            return self.unread(at, "patterns with `ref`");
        }
        if let Ok(Named::Function(function)) = self
            .names
            .found(self.context.module, std::slice::from_ref(&name))
            && self.names.functions[function].is_constant
        {
            return Ok(Pattern::Equal(Node::Constant(function, at), at));
        }
        let of = match &it.subpat {
            Some((_, of)) => Some(Box::new(self.pattern(of, is_late)?)),
            None => None,
        };
        let known = self.alternatives.and_then(|start| {
            let mut known = self.locals[start..].iter();
            known.find(|it| it.name == name).map(|it| it.slot)
        });
        let is_mut = it.mutability.is_some() || is_late;
        let slot = known.unwrap_or_else(|| self.local(&name, is_mut));
        Ok(match of {
            Some(of) => Pattern::BindAs(slot, of),
            None => Pattern::Bind(slot),
        })
    }

    /// Several patterns with the same names.
    fn alternatives(&mut self, it: &syn::PatOr) -> Lowered<Pattern> {
        let outer = self.alternatives;
        self.alternatives = outer.or(Some(self.locals.len()));
        let all = self.all(&it.cases, false);
        self.alternatives = outer;
        Ok(Pattern::Or(all?))
    }

    fn tuple_struct_pattern(&mut self, it: &syn::PatTupleStruct, at: At) -> Lowered<Pattern> {
        if it.path.is_ident("Some") && it.elems.len() == 1 {
            let of = self.pattern(&it.elems[0], false)?;
            return Ok(Pattern::Some(Box::new(of), at));
        }
        let ty = self.struct_named(&it.path)?;
        let Head::Own(kind) = ty.0 else {
            return self.unread(at, "this kind of pattern");
        };
        let count = self.names.kinds[kind as usize].fields.len();
        if count != it.elems.len() {
            let given = it.elems.len();
            let message = format!(
                "this pattern has {given} fields, but the corresponding tuple struct has {count}"
            );
            return self.refused(at, message);
        }
        let all = self.all(&it.elems, false)?;
        Ok(Pattern::Struct(
            ty.0,
            all.into_iter().enumerate().collect(),
            at,
        ))
    }

    /// `match`, whose arms come to a value of that type.
    pub(super) fn matching(&mut self, it: &syn::ExprMatch, ty: &Type) -> Lowered {
        let of = self.expr(&it.expr)?;
        let mut arms: Vec<Arm> = Vec::new();
        for arm in &it.arms {
            let outside = self.locals.len();
            let (pattern, guard) = match &arm.pat {
                syn::Pat::Guard(it) => (&*it.pat, Some(&it.guard)),
                pattern => (pattern, None),
            };
            let pattern = self.pattern(pattern, false)?;
            let guard = guard.map(|it| self.given(it, &Type::BOOL)).transpose()?;
            let mut body = self.given(&arm.body, ty)?;
            self.locals.truncate(outside);
            if !matches!(*arm.body, syn::Expr::Block(_)) {
                body = self.marked(body, self.at(&arm.body));
            }
            arms.push(Arm {
                pattern,
                guard,
                body,
            });
        }
        if let Some(missing) = missing(&arms) {
            let message = format!("non-exhaustive patterns: `{missing}` not covered");
            return self.refused(self.at(&it.expr), message);
        }
        let at = self.at_any(&it.match_token);
        Ok(Node::Match(Box::new(of), arms, at))
    }
}

/// What no arm matches, where that is plain: of options, of what is true or not, of numbers.
fn missing(arms: &[Arm]) -> Option<&'static str> {
    let mut all: Vec<&Pattern> = arms.iter().map(|it| &it.pattern).collect();
    let unguarded = arms.iter().filter(|it| it.guard.is_none());
    let mut sure: Vec<&Pattern> = unguarded.map(|it| &it.pattern).collect();
    for patterns in [&mut all, &mut sure] {
        while let Some(n) = patterns.iter().position(|it| matches!(it, Pattern::Or(_))) {
            if let Pattern::Or(ways) = patterns.swap_remove(n) {
                patterns.extend(ways);
            }
        }
    }
    if sure.iter().any(|it| it.is_irrefutable()) {
        return None;
    }
    let is_option = |it: &&Pattern| matches!(it, Pattern::None | Pattern::Some(..));
    let is_bool = |it: &&Pattern| matches!(it, Pattern::Equal(Node::Bool(_), _));
    let has = |wanted: bool| {
        let is_it =
            |it: &&Pattern| matches!(it, Pattern::Equal(Node::Bool(it), _) if *it == wanted);
        sure.iter().any(is_it)
    };
    if all.iter().any(is_bool) {
        return [(true, "true"), (false, "false")]
            .into_iter()
            .find(|it| !has(it.0))
            .map(|it| it.1);
    }
    if all.iter().any(is_option) {
        let some = sure.iter().filter(|it| matches!(it, Pattern::Some(..)));
        return match (
            some.count(),
            sure.iter().any(|it| matches!(it, Pattern::None)),
        ) {
            (_, false) => Some("None"),
            (0, true) => Some("Some(_)"),
            _ => None,
        };
    }
    let is_number = |it: &&Pattern| matches!(it, Pattern::Equal(Node::Int(..) | Node::Float(_), _));
    (!all.is_empty() && all.iter().all(is_number)).then_some("_")
}
