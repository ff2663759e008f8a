//! Paths as values and as callees: variables, constants and functions, also of a type.

use std::cmp::Ordering;
use std::sync::Arc;

use common::rtweekend::Vec3;

use super::calls::made;
use super::{Expr, Lowered, Lowerer};
use crate::library;
use crate::machine::value::{Data, Value};
use crate::machine::{Closure, ExprForm, Native, Thunk};
use crate::names::words::{private, there_is, unexpected};
use crate::names::{Meaning, names, standard};
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

/// A function that a path names.
pub(super) enum Callee {
    /// A function or constant of the text, by its number.
    Own(usize),
    /// A function of the library.
    Native(&'static Native),
    /// A method of a trait of the text; the type of its first argument decides which.
    OfTrait,
    /// The `default` of a type that the text does not define.
    Default(Type),
    /// The constructor of a tuple struct or unit struct, by its number.
    Struct(u32),
}

impl Lowerer<'_> {
    /// Lowers a path as a value: a variable, a constant, a function.
    pub(super) fn path(&mut self, it: &syn::ExprPath) -> Lowered {
        let path = names(&it.path);
        let at = self.at_any(it);
        if let [name] = path.as_slice()
            && let Some(local) = self.variable(name)
        {
            let made = Expr::of(Thunk::Local(local.slot), at);
            return Ok(made.shown_if(local.is_open, ExprForm::Open));
        }
        if path.last().is_some_and(|it| it == "None") {
            return Ok(Expr::new(at, |_| Ok(None.into())));
        }
        if let Ok(Meaning::Number(number)) = self.names.found(self.context.module, &path) {
            return Ok(Expr::of(Thunk::Float(number), at));
        }
        let (owner, name) = self.owner(&path, at)?;
        if let Some(owner) = &owner
            && self.names.method(owner.0, &name).is_none()
            && let Some(constant) = constant(owner.0, &name, at)
        {
            return Ok(constant);
        }
        match self.callee(owner.as_ref(), &name, &path, at, "value")? {
            Callee::Own(function) if self.names.functions[function].is_constant => {
                Ok(Expr::new(at, move |m| m.constant(function, at)))
            }
            Callee::Own(function) => {
                Ok(Expr::new(at, move |_| Ok(Data::Function(function).into())))
            }
            Callee::Native(native) => Ok(Expr::new(at, move |_| Ok(Data::Native(native).into()))),
            Callee::Default(ty) => Ok(function_of(self.default_of(&ty, at)?)),
            Callee::Struct(kind) if self.names.structs[kind as usize].fields.is_empty() => {
                Ok(made(kind, Vec::new(), None, at))
            }
            Callee::Struct(_) => self.unread(at, "structs as functions"),
            Callee::OfTrait => self.unread(at, "methods of traits as values"),
        }
    }

    /// Splits a path at its last `::` into the type before it, if the path before it names a type,
    /// and the name behind it.
    pub(super) fn owner(&self, path: &[String], at: Span) -> Lowered<(Option<Type>, String)> {
        let (name, before) = path.split_last().expect("a path has a name");
        if before.is_empty() {
            return Ok((None, name.clone()));
        }
        let owner = match self.names.meant(&self.context, before) {
            Ok(Meaning::Type(ty)) => Some(ty),
            Ok(Meaning::Generic(ctor)) => Some(Type::of(ctor, Type::UNKNOWN)),
            Ok(Meaning::Trait(of)) => Some(Ctor::Dyn(of).into()),
            Ok(Meaning::Standard(of)) => return self.unread(at, &format!("`{of}::{name}`")),
            Ok(_) => None,
            Err(lost) => {
                let module = self.context.module;
                return Err(self.names.not_found(module, at, "type", before, lost));
            }
        };
        Ok((owner, name.clone()))
    }

    /// Returns the function that a path names. `what` says in a refusal what was expected there.
    pub(super) fn callee(
        &self,
        owner: Option<&Type>,
        name: &str,
        path: &[String],
        at: Span,
        what: &str,
    ) -> Lowered<Callee> {
        if let Some(owner) = owner {
            return self.callee_of(owner, name, at);
        }
        let named = self.names.expected(&self.context, path, what, at);
        let named = named.map_err(|refusal| {
            let locals = self.locals.iter().map(|it| it.name.as_str());
            let is_local = path.len() == 1 && what == "value";
            refusal.or_help(&there_is(name, locals.filter(|_| is_local)))
        });
        match named? {
            Meaning::Function(function) => Ok(Callee::Own(function)),
            Meaning::Library(name) => {
                let native = library::function(Ctor::Never, name);
                Ok(Callee::Native(native.expect("it is listed")))
            }
            Meaning::Type(Type(Ctor::Own(kind), _))
                if self.names.structs[kind as usize].is_tuple =>
            {
                Ok(Callee::Struct(kind))
            }
            _ => Err(unexpected(what, path, at)),
        }
    }

    /// Returns the function of that name that a type has.
    fn callee_of(&self, owner: &Type, name: &str, at: Span) -> Lowered<Callee> {
        if let Ctor::Dyn(of) = owner.0 {
            let mut methods = self.names.traits[of].methods.iter();
            if methods.any(|&it| self.names.functions[it].name == name) {
                return Ok(Callee::OfTrait);
            }
        }
        if let Some(own) = self.names.method(owner.0, name) {
            if !self.names.shows(self.context.module, own) {
                return Err(self.hidden(own, at));
            }
            return Ok(Callee::Own(own));
        }
        if name == "default" {
            self.default_of(owner, at)?;
            return Ok(Callee::Default(owner.clone()));
        }
        if let Some(native) = library::function(owner.0, name) {
            return Ok(Callee::Native(native));
        }
        let ty = owner.name(self.names);
        match owner.0 {
            Ctor::Own(_) | Ctor::Dyn(_) | Ctor::Ray | Ctor::Picture => {
                self.refused(at, no_function(name, &ty))
            }
            _ => self.unread(at, &format!("`{name}` of `{ty}`")),
        }
    }

    /// Makes the refusal of a function that is private, or whose trait is not in scope.
    pub(super) fn hidden(&self, function: usize, at: Span) -> Refusal {
        let own = &self.names.functions[function];
        let name = &own.name;
        match own.in_trait {
            None if own.has_self => private("method", name, at),
            None => private("associated function", name, at),
            Some(of) => {
                let message = format!("no method named `{name}` found");
                let help = "items from traits can only be used if the trait is in scope";
                let of = &self.names.traits[of].name;
                Refusal::new(at, message, "", &format!("{help}: `use` the trait `{of}`"))
            }
        }
    }

    /// Refuses a use of a variable whose type nothing says.
    pub(super) fn needs_a_type<T>(&self, at: Span) -> Lowered<T> {
        let help = "say its type where it begins: `let x: …`, or `|x: …|`";
        self.fault(at, "type annotations needed", "cannot infer type", help)
    }
}

/// Makes an expression for a function without parameters that evaluates the given one.
fn function_of(Expr { run, spot }: Expr) -> Expr {
    let closure = Arc::new(Closure {
        parameters: 0,
        body: Box::new(move |m, _| run.eval(m)),
    });
    Expr::new(spot.at, move |m| m.closure(&closure, false, spot.at))
}

/// Returns the compiler's message for a type without the named function.
pub(super) fn no_function(name: &str, ty: &str) -> String {
    format!("no function or associated item named `{name}` found for `{ty}` in the current scope")
}

/// Returns a constant of a library type, as `f64::MAX` or `Vec3::ZERO`; `None` if there is none.
fn constant(owner: Ctor, name: &str, at: Span) -> Option<Expr> {
    Some(match owner {
        Ctor::F64 => Expr::of(Thunk::Float(standard::number(name)?), at),
        Ctor::F32 => {
            // The others differ.
            let number = standard::number(name).filter(|it| !it.is_finite())? as f32;
            Expr::new(at, move |_| Ok(number.into()))
        }
        Ctor::Int(int) => {
            let (least, most) = int.ends();
            let number = match name {
                "MIN" => least,
                "MAX" => most,
                _ => return None,
            };
            Expr::new(at, move |_| Ok(Value::whole(number, int)))
        }
        Ctor::Vec3 => {
            let (_, vector) = VECTORS.into_iter().find(|it| it.0 == name)?;
            Expr::new(at, move |_| Ok(vector.into()))
        }
        Ctor::Ordering => {
            let all = [Ordering::Less, Ordering::Equal, Ordering::Greater];
            let order = all.into_iter().find(|it| format!("{it:?}") == name)?;
            Expr::new(at, move |_| Ok(order.into()))
        }
        _ => return None,
    })
}

/// The constants of a vector.
const VECTORS: [(&str, Vec3); 8] = [
    ("ZERO", Vec3::ZERO),
    ("ONE", Vec3::ONE),
    ("X", Vec3::X),
    ("Y", Vec3::Y),
    ("Z", Vec3::Z),
    ("NEG_X", Vec3::NEG_X),
    ("NEG_Y", Vec3::NEG_Y),
    ("NEG_Z", Vec3::NEG_Z),
];
