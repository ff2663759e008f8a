//! Patterns: what a value may look like, and the names of its parts.

use super::{Checked, Checker, Typed};
use crate::items::{Named, Shape, names};
use crate::node::{Arm, Node, Pattern};
use crate::types::{Head, Type};

impl Checker<'_> {
    /// The pattern for a value of that type. Its names are variables from now on.
    pub(super) fn pattern(&mut self, it: &syn::Pat, ty: &Type, is_late: bool) -> Checked<Pattern> {
        match it {
            syn::Pat::Wild(_) => Ok(Pattern::Any),
            syn::Pat::Paren(it) => self.pattern(&it.pat, ty, is_late),
            syn::Pat::Type(it) => {
                let written = self.ty(&it.ty)?;
                match self.types.unify(&written, ty) {
                    true => self.pattern(&it.pat, ty, is_late),
                    false => {
                        let (message, label) = self.mismatch(&written, ty);
                        self.fault(&it.ty, message, &label, "")
                    }
                }
            }
            syn::Pat::Ident(name) if name.ident == "None" => self.option(it, ty, None),
            syn::Pat::Ident(it) => {
                if let Some((kind, variant)) = self.variant(&it.ident.clone().into())
                    && self.items.kinds[kind].variants[variant].shape == Shape::Unit
                {
                    let named = (
                        Type::plain(Head::Own(kind)),
                        self.items.kinds[kind].is_enum.then_some(variant),
                    );
                    return self.fields(it, ty, named, Vec::new());
                }
                let inner = match &it.subpat {
                    Some((_, pattern)) => self.pattern(pattern, ty, is_late)?,
                    None => Pattern::Any,
                };
                let is_mut = it.mutability.is_some() || is_late;
                let ty = match it.by_ref {
                    Some(_) => Type::one(Head::Ref, ty.clone()),
                    None => ty.clone(),
                };
                let slot = self.local(&it.ident.to_string(), ty, is_mut);
                Ok(Pattern::Bind(slot, Box::new(inner)))
            }
            syn::Pat::Reference(it) => {
                let of = self.types.any();
                match self.types.unify(ty, &Type::one(Head::Ref, of.clone())) {
                    true => self.pattern(&it.pat, &of, is_late),
                    false => {
                        let (message, label) = self.mismatch(ty, &Type::one(Head::Ref, of));
                        self.fault(it, message, &label, "leave the `&` out")
                    }
                }
            }
            syn::Pat::Lit(it) => {
                let (ty, _) = self.behind(ty);
                let literal = self.literal(&it.lit)?;
                Ok(Pattern::Literal(self.coerced(literal, &ty, it)?))
            }
            syn::Pat::Range(it) => {
                let (ty, _) = self.behind(ty);
                let mut end = |end: &Option<Box<syn::Expr>>| {
                    end.as_ref().map(|end| self.given(end, &ty)).transpose()
                };
                let (from, to) = (end(&it.start)?, end(&it.end)?);
                Ok(Pattern::Range(
                    from,
                    to,
                    matches!(it.limits, syn::RangeLimits::Closed(_)),
                ))
            }
            syn::Pat::Or(it) => {
                let first = self.locals.len();
                let mut all = Vec::new();
                for (n, case) in it.cases.iter().enumerate() {
                    let before = self.locals.len();
                    all.push(self.pattern(case, ty, is_late)?);
                    if n > 0 && self.locals.len() > before {
                        return self.unknown(case, "names in alternatives");
                    }
                }
                if all.len() > 1 && self.locals.len() > first {
                    return self.unknown(it, "names in alternatives");
                }
                Ok(Pattern::Or(all))
            }
            syn::Pat::TupleStruct(tuple) if tuple.path.is_ident("Some") => {
                match tuple.elems.first() {
                    Some(inner) if tuple.elems.len() == 1 => self.option(it, ty, Some(inner)),
                    _ => self.fault(
                        it,
                        "this pattern has the wrong number of fields",
                        "`Some` has 1",
                        "",
                    ),
                }
            }
            syn::Pat::TupleStruct(it) => match self.named(&it.path) {
                Some(found) => {
                    let named = it
                        .elems
                        .iter()
                        .enumerate()
                        .map(|(n, it)| (n.to_string(), it));
                    self.fields(&it.path, ty, found, named.collect())
                }
                None => Err(self.no_variant(&it.path)),
            },
            syn::Pat::Struct(it) => match self.named(&it.path) {
                Some(found) => {
                    let named = it.fields.iter().map(|field| {
                        let name = match &field.member {
                            syn::Member::Named(name) => name.to_string(),
                            syn::Member::Unnamed(n) => n.index.to_string(),
                        };
                        (name, &*field.pat)
                    });
                    self.fields(&it.path, ty, found, named.collect())
                }
                None => Err(self.no_variant(&it.path)),
            },
            syn::Pat::Path(it) => match self.named(&it.path) {
                Some(found) => self.fields(&it.path, ty, found, Vec::new()),
                None => {
                    let (ty, _) = self.behind(ty);
                    let constant = self.path(it)?;
                    Ok(Pattern::Literal(self.coerced(constant, &ty, it)?))
                }
            },
            syn::Pat::Tuple(tuple) => {
                let (inner, wrap) = self.behind(ty);
                let types: Vec<Type> = tuple.elems.iter().map(|_| self.types.any()).collect();
                if !self
                    .types
                    .unify(&inner, &Type::Of(Head::Tuple, types.clone()))
                {
                    let (message, label) = self.mismatch(&inner, &Type::Of(Head::Tuple, types));
                    return self.fault(it, message, &label, "");
                }
                let each = tuple.elems.iter().zip(&types);
                let all = each.map(|(it, ty)| self.pattern(it, &wrapped(ty, wrap), is_late));
                match tuple.elems.is_empty() {
                    true => Ok(Pattern::Any),
                    false => Ok(Pattern::Many(all.collect::<Checked<_>>()?)),
                }
            }
            syn::Pat::Slice(slice) => {
                let (inner, wrap) = self.behind(ty);
                match inner.head() {
                    Some(Head::Array(length)) if length == slice.elems.len() => {}
                    _ => return self.unknown(it, "this pattern of a list"),
                }
                let of = wrapped(&inner.inner(), wrap);
                let all = slice.elems.iter().map(|it| self.pattern(it, &of, is_late));
                Ok(Pattern::Many(all.collect::<Checked<_>>()?))
            }
            _ => self.unknown(it, "this kind of pattern"),
        }
    }

    /// The type behind references, and whether there were some.
    fn behind(&self, ty: &Type) -> (Type, bool) {
        let mut ty = self.types.known(ty);
        let mut is_reference = false;
        while matches!(ty.head(), Some(Head::Ref)) {
            ty = self.types.known(&ty.inner());
            is_reference = true;
        }
        (ty, is_reference)
    }

    fn option(&mut self, it: &syn::Pat, ty: &Type, inner: Option<&syn::Pat>) -> Checked<Pattern> {
        let (own, wrap) = self.behind(ty);
        let of = self.types.any();
        if !self.types.unify(&own, &Type::one(Head::Option, of.clone())) {
            let (message, label) = self.mismatch(&own, &Type::one(Head::Option, of));
            return self.fault(it, message, &label, "");
        }
        match inner {
            None => Ok(Pattern::None),
            Some(inner) => Ok(Pattern::Some(Box::new(self.pattern(
                inner,
                &wrapped(&of, wrap),
                false,
            )?))),
        }
    }

    fn no_variant(&self, path: &syn::Path) -> crate::Fault {
        let name = names(path).join("::");
        self.items.not_found(
            self.context.file,
            self.place(path),
            "struct or variant",
            &name,
        )
    }

    /// What has fields: a variant of one of the reader's types, or a struct.
    fn fields(
        &mut self,
        at: &impl syn::spanned::Spanned,
        ty: &Type,
        (kind, variant): (Type, Option<usize>),
        given: Vec<(String, &syn::Pat)>,
    ) -> Checked<Pattern> {
        let (own, wrap) = self.behind(ty);
        if !self.types.unify(&own, &kind) {
            let (message, label) = self.mismatch(&own, &kind);
            return self.fault(at, message, &label, "");
        }
        let fields = match (variant, kind.head()) {
            (Some(variant), Some(Head::Own(kind))) => {
                let fields = self.items.kinds[kind].variants[variant].fields.iter();
                fields.map(|it| (it.name.as_str(), it.ty.clone())).collect()
            }
            _ => self.fields_of(&kind),
        };
        let mut all = Vec::new();
        for (name, pattern) in given {
            if matches!(pattern, syn::Pat::Rest(_)) {
                continue;
            }
            let Some(n) = fields.iter().position(|it| it.0 == name) else {
                return self.fault(pattern, &format!("there is no field `{name}`"), "", "");
            };
            let part = self.pattern(pattern, &wrapped(&fields[n].1, wrap), false)?;
            all.push((n, part));
        }
        Ok(match variant {
            Some(variant) => Pattern::Variant(variant, all),
            None => Pattern::Fields(all),
        })
    }

    /// The struct or the variant that a path names.
    fn named(&self, path: &syn::Path) -> Option<(Type, Option<usize>)> {
        if let Some((kind, variant)) = self.variant(path) {
            let variant = self.items.kinds[kind].is_enum.then_some(variant);
            return Some((Type::plain(Head::Own(kind)), variant));
        }
        match self.items.found(self.context.file, &names(path))? {
            Named::Type(ty @ Type::Of(Head::Vec3 | Head::Ray, _)) => Some((ty, None)),
            _ => None,
        }
    }

    pub(super) fn matching(&mut self, it: &syn::ExprMatch, expected: Option<&Type>) -> Checked {
        let of = self.expr(&it.expr, None)?;
        let node = match self.types.known(&of.ty).head() {
            Some(Head::RefMut) => return self.unknown(&it.expr, "`match` on `&mut`"),
            _ => of.node,
        };
        let mut arms: Vec<Arm> = Vec::new();
        let mut joined: Option<Type> = None;
        for arm in &it.arms {
            let outside = self.locals.len();
            let (pattern, guard) = match &arm.pat {
                syn::Pat::Guard(it) => (&*it.pat, Some(&it.guard)),
                pattern => (pattern, None),
            };
            let pattern = self.pattern(pattern, &of.ty, false)?;
            let guard = guard
                .map(|guard| self.given(guard, &Type::plain(Head::Bool)))
                .transpose()?;
            let body = self.expr(&arm.body, expected)?;
            self.leave(outside);
            let body = match &joined {
                None if self.types.known(&body.ty).is(Head::Never) => body.node,
                None => {
                    joined = Some(body.ty);
                    body.node
                }
                Some(ty) => {
                    let first = Typed::new(Node::Unit, ty.clone());
                    let ([_, node], _) = self.joined(
                        first,
                        body,
                        "`match` arms have incompatible types",
                        &arm.body,
                    )?;
                    node
                }
            };
            arms.push(Arm {
                pattern,
                guard,
                body,
            });
        }
        if let Some(missing) = self.missing(&of.ty, &arms) {
            let message = format!("non-exhaustive patterns: {missing} not covered");
            return self.fault(&it.expr, &message, "", "add an arm, or `_ => …`");
        }
        let ty = joined.unwrap_or_else(|| Type::plain(Head::Never));
        Ok(Typed::new(
            Node::Match(Box::new(node), arms, self.at(&it.match_token)),
            ty,
        ))
    }

    /// What no arm matches, as far as single values go.
    fn missing(&self, ty: &Type, arms: &[Arm]) -> Option<String> {
        let all: Vec<&Pattern> = arms
            .iter()
            .filter(|it| it.guard.is_none())
            .map(|it| &it.pattern)
            .collect();
        let has = |is_it: &dyn Fn(&Pattern) -> bool| {
            all.iter().any(|it| match it {
                Pattern::Or(all) => all.iter().any(|it| it.is_irrefutable() || is_it(it)),
                Pattern::Bind(_, inner) => inner.is_irrefutable() || is_it(inner),
                it => it.is_irrefutable() || is_it(it),
            })
        };
        let (own, _) = self.behind(ty);
        match own.head() {
            Some(Head::Option) => {
                let is_some = |it: &Pattern| matches!(it, Pattern::Some(of) if of.is_irrefutable());
                if !has(&is_some)
                    && !arms
                        .iter()
                        .any(|it| matches!(it.pattern, Pattern::Some(_)) && it.guard.is_none())
                {
                    return Some("`Some(_)`".to_owned());
                }
                (!has(&|it| matches!(it, Pattern::None))).then(|| "`None`".to_owned())
            }
            Some(Head::Bool) => [true, false].into_iter().find_map(|value| {
                let is_it =
                    |it: &Pattern| matches!(it, Pattern::Literal(Node::Bool(own)) if *own == value);
                (!has(&is_it)).then(|| format!("`{value}`"))
            }),
            Some(Head::Own(kind)) if self.items.kinds[kind].is_enum => {
                let variants = self.items.kinds[kind].variants.iter().enumerate();
                let missing = variants.filter(|(n, _)| {
                    !has(&|it| matches!(it, Pattern::Variant(own, _) if own == n))
                });
                missing
                    .map(|(_, it)| format!("`{}::{}`", self.items.kinds[kind].name, it.name))
                    .next()
            }
            Some(Head::F64 | Head::F32 | Head::Int(_)) => {
                (!has(&|_| false)).then(|| "`_`".to_owned())
            }
            _ => None,
        }
    }
}

/// A part of what is behind a reference is one, too.
fn wrapped(ty: &Type, is_reference: bool) -> Type {
    match is_reference {
        true => Type::one(Head::Ref, ty.clone()),
        false => ty.clone(),
    }
}
