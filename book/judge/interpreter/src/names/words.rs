//! The compiler's messages: names of types, paths that lead nowhere, and similar names.

use strsim::levenshtein;

use super::{Meaning, Names, PathError, TypeScope, standard};
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Int, Type};

impl Names {
    /// Makes the refusal of a `use` whose path leads nowhere.
    pub(super) fn unresolved(&self, at: Span, path: &[String], lost: PathError) -> Refusal {
        let part = &path[lost.part];
        if lost.is_private {
            return private("item", part, at);
        }
        let message = format!("unresolved import `{}`", path[..=lost.part].join("::"));
        let label = match path[..lost.part].join("::").as_str() {
            "" | "crate" => format!("could not find `{part}` in the crate root"),
            module => format!("no `{part}` in `{module}`"),
        };
        let help = if lost.part + 1 < path.len() {
            format!("`mod {part};` in `src/lib.rs` declares the file `src/{part}.rs`")
        } else {
            String::new()
        };
        Refusal::new(at, message, &label, &help)
    }

    /// Resolves a path that should name a `what`, such as a type or a function.
    ///
    /// # Errors
    /// The compiler's words for a path that leads nowhere, or the refusal of a name of the standard
    /// library that is not read here.
    pub(crate) fn expected(
        &self,
        context: &TypeScope,
        path: &[String],
        what: &str,
        at: Span,
    ) -> Result<Meaning, Refusal> {
        match self.meant(context, path) {
            Ok(Meaning::Standard(name)) => Err(Refusal::unread(at, &format!("`{name}`"))),
            Ok(named) => Ok(named),
            Err(lost) => Err(self.not_found(context.module, at, what, path, lost)),
        }
    }

    /// Makes the refusal of a path that leads nowhere, and suggests an import or a similar name.
    pub(crate) fn not_found(
        &self,
        module: usize,
        at: Span,
        what: &str,
        path: &[String],
        lost: PathError,
    ) -> Refusal {
        let name = &path[lost.part];
        if lost.is_private {
            return private(what, name, at);
        }
        let message = if lost.part + 1 < path.len() {
            format!("cannot find module or crate `{name}` in this scope")
        } else {
            format!("cannot find {what} `{name}` in this scope")
        };
        let mut elsewhere = self.modules.iter().filter(|it| !it.name.is_empty());
        let help = if standard::prelude(name).is_some() {
            "`use common::rtweekend::*;` is missing".to_owned()
        } else if let Some(other) = elsewhere.find(|it| it.names.contains_key(name)) {
            format!("`use crate::{}::{name};` is missing", other.name)
        } else {
            let own = self.modules[module].names.keys().map(String::as_str);
            there_is(name, own.chain(standard::PRELUDE.map(|it| it.0)))
        };
        Refusal::new(at, message, "not found in this scope", &help)
    }

    /// Returns the names of a type's fields.
    pub(crate) fn fields(&self, ty: &Type) -> Vec<&str> {
        match ty.0 {
            Ctor::Own(kind) => {
                let fields = self.structs[kind as usize].fields.iter();
                fields.map(|it| it.name.as_str()).collect()
            }
            Ctor::Vec3 => vec!["x", "y", "z"],
            Ctor::Ray => vec!["origin", "direction"],
            _ => Vec::new(),
        }
    }

    /// Makes the refusal of a field that a type does not have, or no type at all if `ty` is
    /// unknown.
    pub(crate) fn no_field(&self, name: &str, ty: &Type, at: Span) -> Refusal {
        let help = if self.methods(name).next().is_some() {
            format!("`{name}` is a method: `.{name}(…)`")
        } else {
            there_is(name, self.fields(ty.stripped()).into_iter())
        };
        let on = if ty.is_unknown() {
            String::new()
        } else {
            format!(" on type `{}`", ty.name(self))
        };
        Refusal::new(at, format!("no field `{name}`{on}"), "unknown field", &help)
    }

    /// Makes the refusal of a value of another type than the expected one. `said` names what was
    /// found.
    pub(crate) fn mismatch(&self, wanted: &Type, found: &Type, said: &str, at: Span) -> Refusal {
        let label = format!("expected {}, found {said}", wanted.said(self));
        Refusal::new(at, "mismatched types", &label, help(wanted, found))
    }
}

/// Returns the hint for a type that is not the wanted one; empty if there is none.
fn help(wanted: &Type, found: &Type) -> &'static str {
    let is_like = |wanted: &Type| {
        wanted.is_unknown() || wanted.0 == found.0 || matches!(wanted.0, Ctor::Dyn(_))
    };
    match (wanted.0, found.0) {
        (Ctor::F64, Ctor::Int(Int::Any)) => "use a float literal, such as `1.0`",
        (Ctor::F64, Ctor::Int(_)) => "convert it: `f64::from(…)`, or `… as f64`",
        (Ctor::Option, _) if is_like(wanted.inner()) => {
            "try wrapping the expression in `Some`: `Some(…)`"
        }
        (Ctor::Box, ctor) if ctor != Ctor::Box => "store it in the heap: `Box::new(…)`",
        (Ctor::Ref, _) if is_like(wanted.inner()) => "consider borrowing here: `&…`",
        (Ctor::RefMut, _) if is_like(wanted.inner()) => "consider mutably borrowing here: `&mut …`",
        (_, Ctor::Ref) if found.inner() == wanted => "consider dereferencing it: `*…`",
        (_, Ctor::Option) if found.inner().0 == wanted.0 => {
            "the option may be `None`: look with `if let Some(…) = …`"
        }
        (Ctor::Own(_), Ctor::Fn) => "use parentheses to call this function: `…()`",
        _ => "",
    }
}

impl Type {
    /// Returns the type's name as the compiler has it in a label, mostly in quotes.
    pub(crate) fn said(&self, names: &Names) -> String {
        match self.0 {
            Ctor::Int(Int::Any) => "integer".to_owned(),
            _ => format!("`{}`", self.name(names)),
        }
    }

    /// Returns the type's name as the compiler has it in a message.
    pub(crate) fn name(&self, names: &Names) -> String {
        let all: Vec<String> = self.1.iter().map(|it| it.name(names)).collect();
        let of = |name: &str| format!("{name}<{}>", all.join(", "));
        let plain = match self.0 {
            Ctor::Unknown | Ctor::Like => "_",
            Ctor::Never => "!",
            Ctor::Bool => "bool",
            Ctor::Str => "str",
            Ctor::F64 => "f64",
            Ctor::F32 => "f32",
            Ctor::Int(int) => int.name(),
            Ctor::Vec3 => "Vec3",
            Ctor::Ray => "Ray",
            Ctor::Picture => "Picture",
            Ctor::Ordering => "Ordering",
            Ctor::Own(n) => &names.structs[n as usize].name,
            Ctor::Dyn(n) => return format!("dyn {}", names.traits[n].name),
            Ctor::Option => return of("Option"),
            Ctor::Box => return of("Box"),
            Ctor::Vec => return of("Vec"),
            Ctor::Range => return of("Range"),
            Ctor::Iterator => "Iterator",
            Ctor::Slice => return format!("[{}]", all[0]),
            Ctor::Array(length) => return format!("[{}; {length}]", all[0]),
            Ctor::Tuple if all.len() == 1 => return format!("({},)", all[0]),
            Ctor::Tuple => return format!("({})", all.join(", ")),
            Ctor::Ref => return format!("&{}", all[0]),
            Ctor::RefMut => return format!("&mut {}", all[0]),
            Ctor::Fn => {
                let (result, parameters) = all.split_last().expect("a function has a result");
                let result = match result.as_str() {
                    "()" => String::new(),
                    result => format!(" -> {result}"),
                };
                return format!("fn({}){result}", parameters.join(", "));
            }
        };
        plain.to_owned()
    }
}

/// Makes the refusal of a path that means something else than `what`.
pub(crate) fn unexpected(what: &str, path: &[String], at: Span) -> Refusal {
    let message = format!("expected {what}, found `{}`", path.join("::"));
    Refusal::new(at, message, &format!("not a {what}"), "")
}

/// Makes the refusal of something that is private.
pub(crate) fn private(what: &str, name: &str, at: Span) -> Refusal {
    let message = format!("{what} `{name}` is private");
    let help = "`pub` before the declaration shows it to other files";
    Refusal::new(at, message, &format!("private {what}"), help)
}

/// Returns a hint at the most similar name; empty if none is similar.
pub(crate) fn there_is<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> String {
    similar(name, among).map_or(String::new(), |it| format!("there is `{it}`"))
}

/// Finds the most similar name; `None` if none is similar enough.
fn similar<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let near = |other: &&str| {
        let distance = levenshtein(name, other);
        let is_part = name.starts_with(other) || other.starts_with(name);
        distance * 3 <= name.len().max(3) || is_part && name.len().min(other.len()) > 2
    };
    among
        .filter(near)
        .min_by_key(|other| (levenshtein(name, other), *other))
}
