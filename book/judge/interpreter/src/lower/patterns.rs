//! Patterns: tests of a value's shape that set variables to its parts. In one that is matched with
//! a `&mut`, a name is another name of the part's place.

use super::lowerer::{Lowered, Lowerer};
use crate::fault::{Fault, Span};
use crate::machine::{Code, Machine, Run};
use crate::names::Item;
use crate::place::{Part, Place};
use crate::value::{Shape, Value, kind};

/// A pattern that was lowered: returns true if a value matches, and then has set the variables.
pub(crate) type Pattern = Box<dyn Fn(&mut Machine<'_>, &Value, Span) -> Run<bool> + Send + Sync>;

impl Machine<'_> {
    /// Sets the variables of a pattern that must match.
    pub(crate) fn bind(&mut self, pattern: &Pattern, value: &Value, at: Span) -> Run<()> {
        match pattern(self, value, at)? {
            true => Ok(()),
            false => self.refuse(at, "this pattern does not cover all values: try `if let`"),
        }
    }

    /// Returns true if a value has this shape. One of another type is refused.
    fn is_shaped(&mut self, shape: Shape, value: &Value, at: Span) -> Run<bool> {
        if shape.kind != value.kind() {
            let wanted = self.code.names.shown(shape.kind);
            return self.mismatch(at, wanted, value.kind());
        }
        Ok(match value {
            Value::Data(of, _) => of.variant == shape.variant,
            _ => true,
        })
    }
}

impl Lowerer<'_> {
    /// Lowers a pattern and declares its variables, as names of parts of `place` if there is one.
    pub(super) fn pattern(
        &mut self,
        pattern: &syn::Pat,
        place: Option<&Place>,
    ) -> Lowered<Pattern> {
        match pattern {
            syn::Pat::Wild(_) => Ok(Box::new(|_, _, _| Ok(true))),
            syn::Pat::Paren(it) => self.pattern(&it.pat, place),
            syn::Pat::Reference(it) => self.pattern(&it.pat, place),
            syn::Pat::Type(it) => self.typed(it, place),
            syn::Pat::Ident(it) if self.is_item(&it.ident) => {
                Ok(equal(self.path(&it.ident.clone().into())?))
            }
            syn::Pat::Ident(it) if it.by_ref.is_none() && it.subpat.is_none() => {
                Ok(self.name(it, place))
            }
            syn::Pat::Path(it) => Ok(equal(self.path(&it.path)?)),
            syn::Pat::Lit(it) => Ok(equal(self.literal(&it.lit)?)),
            syn::Pat::Struct(it) => self.fields(it, place),
            syn::Pat::TupleStruct(it) => {
                let shape = self.shape(&it.path)?;
                self.check_count(shape, it)?;
                self.parts(&it.elems, shape, place)
            }
            syn::Pat::Tuple(it) => self.parts(&it.elems, Shape::TUPLE, place),
            syn::Pat::Or(it) => self.one_of(it, place),
            syn::Pat::Slice(it) => self.parts(&it.elems, Shape::LIST, place),
            _ => self.unread(pattern, "this kind of pattern"),
        }
    }

    /// Lowers `a | b`, in which no names are read.
    fn one_of(&mut self, cases: &syn::PatOr, place: Option<&Place>) -> Lowered<Pattern> {
        let count = self.variables.len();
        let patterns = cases.cases.iter().map(|case| self.pattern(case, place));
        let patterns = patterns.collect::<Lowered<Vec<_>>>()?;
        if self.variables.len() > count {
            return self.unread(cases, "names in a pattern with `|`");
        }
        Ok(Box::new(move |m, value, at| {
            for pattern in &patterns {
                if pattern(m, value, at)? {
                    return Ok(true);
                }
            }
            Ok(false)
        }))
    }

    fn typed(&mut self, typed: &syn::PatType, place: Option<&Place>) -> Lowered<Pattern> {
        let ty = self.names.ty(&typed.ty, self.scope)?;
        let pattern = self.pattern(&typed.pat, place)?;
        Ok(Box::new(move |m, value, at| {
            let mut value = value.clone();
            m.admit(ty, &mut value, at)?;
            pattern(m, &value, at)
        }))
    }

    fn fields(&mut self, fields: &syn::PatStruct, place: Option<&Place>) -> Lowered<Pattern> {
        let shape = self.shape(&fields.path)?;
        let mut all = Vec::new();
        for field in &fields.fields {
            let n = self.field_of(shape, &field.member)?;
            all.push((n, self.part(&field.pat, n, place)?));
        }
        Ok(Box::new(move |m, value, at| {
            let mut is_match = m.is_shaped(shape, value, at)?;
            for (n, pattern) in &all {
                let part = value.part(*n).unwrap_or_default();
                is_match = is_match && pattern(m, &part, at)?;
            }
            Ok(is_match)
        }))
    }

    /// Returns true for a name that is a constant or a variant, and so no new variable.
    pub(super) fn is_item(&self, name: &syn::Ident) -> bool {
        match self.names.items.get(&name.to_string()) {
            Some(Item::Variant(_)) => true,
            Some(Item::Function(n)) => self.names.signatures[*n].is_constant,
            _ => false,
        }
    }

    fn name(&mut self, name: &syn::PatIdent, place: Option<&Place>) -> Pattern {
        let text = name.ident.to_string();
        if let Some(place) = place {
            self.name_place(&text, place.clone());
            return Box::new(|_, _, _| Ok(true));
        }
        let slot = self.declare(&text, name.mutability.is_none());
        Box::new(move |m, value, _| {
            *m.local_mut(slot) = value.clone();
            Ok(true)
        })
    }

    /// Lowers the pattern of part `n`.
    fn part(&mut self, pattern: &syn::Pat, n: usize, place: Option<&Place>) -> Lowered<Pattern> {
        let place = place.map(|it| it.clone().part(Part::Number(n)));
        self.pattern(pattern, place.as_ref())
    }

    fn check_count(&self, of: Shape, pattern: &syn::PatTupleStruct) -> Lowered<()> {
        let wanted = self.names.variant(of).fields.len();
        match pattern.elems.len() {
            given if given == wanted => Ok(()),
            given => Err(Fault::miscounted(self.at(pattern), wanted, given)),
        }
    }

    /// Lowers the patterns of all parts of a list, a tuple or a variant.
    fn parts<'s>(
        &mut self,
        all: impl IntoIterator<Item = &'s syn::Pat>,
        of: Shape,
        place: Option<&Place>,
    ) -> Lowered<Pattern> {
        let mut patterns = Vec::new();
        for (n, part) in all.into_iter().enumerate() {
            if let syn::Pat::Rest(_) = part {
                return self.unread(part, "`..` between parts");
            }
            patterns.push(self.part(part, n, place)?);
        }
        Ok(Box::new(move |m, value, at| {
            if !m.is_shaped(of, value, at)? {
                return Ok(false);
            }
            let parts = value.parts();
            if parts.len() != patterns.len() && of.kind == kind::TUPLE {
                return m.refuse(at, format!("this is a tuple of {}", parts.len()));
            }
            let mut is_match = parts.len() == patterns.len();
            for (pattern, part) in patterns.iter().zip(parts) {
                is_match = is_match && pattern(m, part, at)?;
            }
            Ok(is_match)
        }))
    }
}

fn equal(code: Code) -> Pattern {
    Box::new(move |m, value, at| {
        let wanted = code.run(m)?;
        m.equal(&wanted, value, at)
    })
}
