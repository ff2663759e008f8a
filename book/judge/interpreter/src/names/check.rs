//! Item checks: that implementations have what their traits promise, and that structs end.

use super::{Names, Signature};
use crate::refusal::Refusal;
use crate::types::{Head, Type};

type Checked = Result<(), Refusal>;

impl Names {
    /// Whether each implementation of a trait has what that promises, and nothing else.
    pub(super) fn are_traits_complete(&self) -> Checked {
        for own in &self.functions {
            let Some(of) = own.in_trait.map(|it| &self.traits[it]) else {
                continue;
            };
            let mut methods = of.methods.iter().map(|&it| &self.functions[it]);
            let Some(promised) = methods.find(|it| it.name == own.name) else {
                let (name, of) = (&own.name, &of.name);
                let message = format!("method `{name}` is not a member of trait `{of}`");
                return Err(Refusal::new(own.at, message, "", ""));
            };
            if !own.is_as_promised(promised) {
                let message = format!("method `{}` has an incompatible type for trait", own.name);
                return Err(Refusal::new(own.at, message, "", ""));
            }
        }
        for (n, of) in self.traits.iter().enumerate() {
            let promised = of.methods.iter().map(|&it| &self.functions[it]);
            let each = promised.flat_map(|it| of.implemented_for.iter().map(move |of| (it, of)));
            for (promised, ty) in each {
                let is_it = |it: &Signature| {
                    it.in_trait == Some(n) && it.name == promised.name && it.of.as_ref() == Some(ty)
                };
                if !self.functions.iter().any(is_it) {
                    let (name, on) = (&promised.name, ty.name(self));
                    let missing = "not all trait items implemented, missing";
                    let message = format!("{missing}: `{name}` for `{on}`");
                    return Err(Refusal::new(promised.at, message, "", ""));
                }
            }
        }
        Ok(())
    }

    /// Whether no struct is a part of itself.
    pub(super) fn do_structs_end(&self) -> Checked {
        for (n, kind) in self.kinds.iter().enumerate() {
            let mut inside = Vec::new();
            self.add_parts(n as u32, &mut inside);
            if inside.contains(&(n as u32)) {
                let message = format!("recursive type `{}` has infinite size", kind.name);
                let help = "a `Box` around the part makes an end";
                return Err(Refusal::new(kind.at, message, "", help));
            }
        }
        Ok(())
    }

    /// Adds all structs whose values are parts of a struct's.
    fn add_parts(&self, kind: u32, known: &mut Vec<u32>) {
        let fields = self.kinds[kind as usize].fields.iter();
        let mut types: Vec<&Type> = fields.map(|it| &it.ty).collect();
        while let Some(ty) = types.pop() {
            match ty.0 {
                Head::Own(part) if !known.contains(&part) => {
                    known.push(part);
                    self.add_parts(part, known);
                }
                Head::Option | Head::Tuple | Head::Array(_) => types.extend(&ty.1),
                _ => {}
            }
        }
    }
}

impl Signature {
    fn is_as_promised(&self, promised: &Self) -> bool {
        let others = |it: &Self| it.parameters[usize::from(it.has_self)..].to_vec();
        let on = |it: &Self| it.parameters.first().filter(|_| it.has_self).map(|it| it.0);
        let is_reference = |head| matches!(head, Head::Ref | Head::RefMut);
        let is_lent_alike = match (on(self), on(promised)) {
            (Some(one), Some(other)) => one == other || !is_reference(one) && !is_reference(other),
            (one, other) => one.is_none() && other.is_none(),
        };
        is_lent_alike && others(self) == others(promised) && self.result == promised.result
    }
}
