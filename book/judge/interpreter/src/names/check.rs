//! Checks of items: implementations have the methods of their traits, and no struct contains
//! itself.

use super::{Names, Resolved, Signature};
use crate::refusal::Refusal;
use crate::types::{Ctor, Type};

impl Names {
    /// Checks that each implementation of a trait has exactly the methods that the trait declares.
    pub(super) fn check_traits(&self) -> Resolved {
        let wrong = |at, message| Err(Refusal::new(at, message, "", ""));
        for own in &self.functions {
            let Some(of) = own.in_trait.map(|it| &self.traits[it]) else {
                continue;
            };
            let (name, mut methods) = (&own.name, of.methods.iter());
            let promised = methods.find(|&&it| self.functions[it].name == *name);
            match promised.map(|&it| own.is_as_promised(&self.functions[it])) {
                Some(true) => {}
                Some(false) => {
                    let message = format!("method `{name}` has an incompatible type for trait");
                    return wrong(own.at, message);
                }
                None => {
                    let message = format!("method `{name}` is not a member of trait `{}`", of.name);
                    return wrong(own.at, message);
                }
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
                    return wrong(promised.at, format!("{missing}: `{name}` for `{on}`"));
                }
            }
        }
        Ok(())
    }

    /// Checks that no struct contains itself but through a box, a reference or a list.
    pub(super) fn check_structs(&self) -> Resolved {
        for (n, kind) in self.structs.iter().enumerate() {
            let (own, mut known) = (Ctor::Own(n as u32), Vec::new());
            let mut parts: Vec<&Type> = kind.fields.iter().map(|it| &it.ty).collect();
            while let Some(ty) = parts.pop() {
                match ty.0 {
                    ctor if ctor == own => {
                        let message = format!("recursive type `{}` has infinite size", kind.name);
                        let help = "a `Box` around the field gives the struct a finite size";
                        return Err(Refusal::new(kind.at, message, "", help));
                    }
                    Ctor::Own(part) if !known.contains(&part) => {
                        known.push(part);
                        let fields = &self.structs[part as usize].fields;
                        parts.extend(fields.iter().map(|it| &it.ty));
                    }
                    Ctor::Option | Ctor::Tuple | Ctor::Array(_) => parts.extend(&ty.1),
                    _ => {}
                }
            }
        }
        Ok(())
    }
}

impl Signature {
    /// Returns true if a method has the types that its trait declares.
    fn is_as_promised(&self, promised: &Self) -> bool {
        // A `self` may be the type itself, or be behind a reference.
        let on = |it: &Self| match it.parameters.first().filter(|_| it.has_self)?.0 {
            ctor @ (Ctor::Ref | Ctor::RefMut) => Some(ctor),
            _ => Some(Ctor::Unknown),
        };
        let rest = |it: &Self| it.parameters[usize::from(it.has_self)..].to_vec();
        (on(self), rest(self), &self.result) == (on(promised), rest(promised), &promised.result)
    }
}
