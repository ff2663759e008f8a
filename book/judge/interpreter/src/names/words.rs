//! The words of the compiler: what types are called, what was not found, and what was meant.

use strsim::levenshtein;

use super::{Context, Lost, Named, Names, standard};
use crate::refusal::{At, Refusal};
use crate::types::{Head, Int, Type};

impl Names {
    /// Says what is wrong with a path in a `use`.
    pub(super) fn unresolved(&self, at: At, path: &[String], lost: Lost) -> Refusal {
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

    /// Finds what a path means that should be the name of something, or says what is wrong.
    pub(crate) fn expected(
        &self,
        context: &Context,
        path: &[String],
        what: &str,
        at: At,
    ) -> Result<Named, Refusal> {
        match self.meant(context, path) {
            Ok(Named::Standard(name)) => Err(Refusal::unread(at, &format!("`{name}`"))),
            Ok(named) => Ok(named),
            Err(lost) => Err(self.not_found(context.module, at, what, path, lost)),
        }
    }

    /// Says that there is no such name, and which one was meant.
    pub(crate) fn not_found(
        &self,
        module: usize,
        at: At,
        what: &str,
        path: &[String],
        lost: Lost,
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
            Head::Own(kind) => {
                let fields = self.kinds[kind as usize].fields.iter();
                fields.map(|it| it.name.as_str()).collect()
            }
            Head::Vec3 => vec!["x", "y", "z"],
            Head::Ray => vec!["origin", "direction"],
            _ => Vec::new(),
        }
    }

    /// Says that nothing has a field of that name, or that what is of this type has none.
    pub(crate) fn no_field(&self, name: &str, ty: &Type, at: At) -> Refusal {
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

    /// Says that something else is declared than is found, which is said in these words.
    pub(crate) fn mismatch(&self, wanted: &Type, found: &Type, said: &str, at: At) -> Refusal {
        let label = format!("expected {}, found {said}", wanted.said(self));
        Refusal::new(at, "mismatched types", &label, help(wanted, found))
    }
}

/// Says what to do where a type is not what is wanted.
fn help(wanted: &Type, found: &Type) -> &'static str {
    let is_like = |wanted: &Type| {
        wanted.is_unknown() || wanted.0 == found.0 || matches!(wanted.0, Head::Dyn(_))
    };
    match (wanted.0, found.0) {
        (Head::F64, Head::Int(Int::Any)) => "use a float literal, such as `1.0`",
        (Head::F64, Head::Int(_)) => "convert it: `f64::from(…)`, or `… as f64`",
        (Head::Option, _) if is_like(wanted.inner()) => {
            "try wrapping the expression in `Some`: `Some(…)`"
        }
        (Head::Box, head) if head != Head::Box => "store it in the heap: `Box::new(…)`",
        (Head::Ref, _) if is_like(wanted.inner()) => "consider borrowing here: `&…`",
        (Head::RefMut, _) if is_like(wanted.inner()) => "consider mutably borrowing here: `&mut …`",
        (_, Head::Ref) if found.inner() == wanted => "consider dereferencing it: `*…`",
        (_, Head::Option) if found.inner().0 == wanted.0 => {
            "it is `None` where there is nothing: look with `if let Some(…) = …`"
        }
        (Head::Own(_), Head::Fn) => "use parentheses to call this function: `…()`",
        _ => "",
    }
}

impl Type {
    /// Returns the type as the compiler says it in a label: in its quotes if it has a name.
    pub(crate) fn said(&self, names: &Names) -> String {
        match self.0 {
            Head::Int(Int::Any) => "integer".to_owned(),
            _ => format!("`{}`", self.name(names)),
        }
    }

    /// Returns the name of the type as the compiler has it in a message.
    pub(crate) fn name(&self, names: &Names) -> String {
        let all: Vec<String> = self.1.iter().map(|it| it.name(names)).collect();
        let of = |name: &str| format!("{name}<{}>", all.join(", "));
        let plain = match self.0 {
            Head::Unknown | Head::Like => "_",
            Head::Never => "!",
            Head::Bool => "bool",
            Head::Str => "str",
            Head::F64 => "f64",
            Head::F32 => "f32",
            Head::Int(int) => int.name(),
            Head::Vec3 => "Vec3",
            Head::Ray => "Ray",
            Head::Picture => "Picture",
            Head::Ordering => "Ordering",
            Head::Own(n) => &names.kinds[n as usize].name,
            Head::Dyn(n) => return format!("dyn {}", names.traits[n].name),
            Head::Option => return of("Option"),
            Head::Box => return of("Box"),
            Head::Vec => return of("Vec"),
            Head::Range => return of("Range"),
            Head::Iterator => "Iterator",
            Head::Slice => return format!("[{}]", all[0]),
            Head::Array(length) => return format!("[{}; {length}]", all[0]),
            Head::Tuple if all.len() == 1 => return format!("({},)", all[0]),
            Head::Tuple => return format!("({})", all.join(", ")),
            Head::Ref => return format!("&{}", all[0]),
            Head::RefMut => return format!("&mut {}", all[0]),
            Head::Fn => {
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

/// Says that a path means something else than it should.
pub(crate) fn unexpected(what: &str, path: &[String], at: At) -> Refusal {
    let message = format!("expected {what}, found `{}`", path.join("::"));
    Refusal::new(at, message, &format!("not a {what}"), "")
}

/// Says that something is there, but not to be used here.
pub(crate) fn private(what: &str, name: &str, at: At) -> Refusal {
    let message = format!("{what} `{name}` is private");
    let help = "`pub` before it shows it to other files";
    Refusal::new(at, message, &format!("private {what}"), help)
}

/// Says which name was meant, if one is like it.
pub(crate) fn there_is<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> String {
    similar(name, among).map_or(String::new(), |it| format!("there is `{it}`"))
}

/// Finds the name that is most like this one, if one is.
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
