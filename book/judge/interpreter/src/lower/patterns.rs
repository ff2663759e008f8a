//! Patterns: what a value may look like, and the names of its parts.

use super::{Lowered, Lowerer, Typed, member};
use crate::node::{Arm, At, Node, Pattern};
use crate::read::Refusal;
use crate::types::{Head, Type};

impl Lowerer<'_> {
    /// The pattern for a value of that type. Its names are variables from now on.
    pub(super) fn pattern(&mut self, it: &syn::Pat, ty: &Type, is_late: bool) -> Lowered<Pattern> {
        let at = self.at_any(it);
        let is_name = matches!(
            it,
            syn::Pat::Wild(_) | syn::Pat::Ident(_) | syn::Pat::Type(_)
        );
        if ty.is(Head::RefMut) && !is_name {
            return Err(Refusal::unknown(at, "patterns for what is behind `&mut`"));
        }
        match it {
            syn::Pat::Wild(_) => Ok(Pattern::Any),
            syn::Pat::Paren(it) => self.pattern(&it.pat, ty, is_late),
            syn::Pat::Type(it) => {
                let written = self.names.ty(&self.context, &it.ty)?;
                self.expect(ty, &written, at)?;
                self.pattern(&it.pat, &written, is_late)
            }
            syn::Pat::Ident(name) if name.ident == "None" => self.option(ty, None, at),
            syn::Pat::Ident(it) => self.name(it, ty, is_late),
            syn::Pat::Reference(it) if ty.is_reference() || ty.is_unknown() => {
                self.pattern(&it.pat, &ty.inner(), is_late)
            }
            syn::Pat::Reference(_) => {
                let label = format!("expected {}, found reference", ty.said(self.names));
                self.fault(at, "mismatched types", &label, "leave the `&` out")
            }
            syn::Pat::TupleStruct(it) if it.path.is_ident("Some") && it.elems.len() == 1 => {
                self.option(ty, it.elems.first(), at)
            }
            syn::Pat::Struct(it) => {
                let named = it.fields.iter();
                let named = named.map(|it| (member(&it.member), &*it.pat)).collect();
                self.structure_pattern(&it.path, ty, named, at)
            }
            syn::Pat::Tuple(it) => self.tuple_pattern(it, ty, is_late, at),
            syn::Pat::Slice(slice) => {
                let of = ty.stripped().inner().behind(ty);
                let all = slice.elems.iter().map(|it| self.pattern(it, &of, is_late));
                Ok(Pattern::Many(all.collect::<Lowered<_>>()?))
            }
            _ => Err(Refusal::unknown(at, "this kind of pattern")),
        }
    }

    /// A name for what is there.
    fn name(&mut self, it: &syn::PatIdent, ty: &Type, is_late: bool) -> Lowered<Pattern> {
        if it.subpat.is_some() || it.by_ref.is_some() {
            let what = "patterns with `@` or `ref`";
            return Err(Refusal::unknown(self.at_any(it), what));
        }
        let is_mut = it.mutability.is_some() || is_late;
        let slot = self.local(&it.ident.to_string(), ty.clone(), is_mut);
        Ok(Pattern::Bind(slot))
    }

    fn tuple_pattern(
        &mut self,
        tuple: &syn::PatTuple,
        ty: &Type,
        is_late: bool,
        at: At,
    ) -> Lowered<Pattern> {
        let on = ty.stripped();
        let wanted = Type(Head::Tuple, vec![Type::UNKNOWN; tuple.elems.len()]);
        self.expect(on, &wanted, at)?;
        let all = tuple.elems.iter().enumerate().map(|(n, it)| {
            let part = on.1.get(n).cloned().unwrap_or(Type::UNKNOWN);
            Ok((n, self.pattern(it, &part.behind(ty), is_late)?))
        });
        Ok(Pattern::Fields(all.collect::<Lowered<_>>()?))
    }

    fn expect(&self, ty: &Type, wanted: &Type, at: At) -> Lowered<()> {
        if wanted.fits(ty, self.names) || ty.fits(wanted, self.names) {
            Ok(())
        } else {
            Err(self.names.mismatch(ty, wanted, at))
        }
    }

    fn option(&mut self, ty: &Type, inner: Option<&syn::Pat>, at: At) -> Lowered<Pattern> {
        let on = ty.stripped();
        self.expect(on, &Type::of(Head::Option, Type::UNKNOWN), at)?;
        let of = on.inner().behind(ty);
        match inner {
            None => Ok(Pattern::None),
            Some(inner) => {
                let inner = self.pattern(inner, &of, false)?;
                Ok(Pattern::Some(Box::new(inner)))
            }
        }
    }

    fn structure_pattern(
        &mut self,
        path: &syn::Path,
        ty: &Type,
        given: Vec<(String, &syn::Pat)>,
        at: At,
    ) -> Lowered<Pattern> {
        let own = self.struct_named(path)?;
        self.expect(ty.stripped(), &own, at)?;
        let mut all = Vec::new();
        for (name, pattern) in given {
            let (n, part) = self.names.field(&own, &name, self.context.module, at)?;
            all.push((n, self.pattern(pattern, &part.behind(ty), false)?));
        }
        Ok(Pattern::Fields(all))
    }

    pub(super) fn matching(&mut self, it: &syn::ExprMatch) -> Lowered {
        let of = self.expr(&it.expr)?;
        let mut arms: Vec<Arm> = Vec::new();
        let mut ty = Type::from(Head::Never);
        for arm in &it.arms {
            let outside = self.locals.len();
            let (pattern, guard) = match &arm.pat {
                syn::Pat::Guard(it) => (&*it.pat, Some(&it.guard)),
                pattern => (pattern, None),
            };
            let pattern = self.pattern(pattern, &of.ty, false)?;
            let guard = guard.map(|it| self.given(it, &Head::Bool.into()));
            let guard = guard.transpose()?;
            let body: Typed = self.expr(&arm.body)?;
            self.locals.truncate(outside);
            let message = "`match` arms have incompatible types";
            ty = self.joined(&ty, &body.ty, message, self.at(&arm.body))?;
            arms.push(Arm {
                pattern,
                guard,
                body: body.node,
            });
        }
        let at = self.at_any(&it.match_token);
        Ok(Typed::new(Node::Match(Box::new(of.node), arms, at), ty))
    }
}
