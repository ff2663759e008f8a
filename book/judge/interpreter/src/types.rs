//! Declared types: what parameters, results, fields and variables are said to be, and whether
//! what is found fits. Nothing is inferred: what is not known by reading is checked when it
//! runs.

use crate::names::Names;

/// A type, and those that it is made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Type(pub(crate) Head, pub(crate) Vec<Type>);

/// What a type is apart from those that it is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum Head {
    /// Nothing says what it is, or it fits whatever there is.
    #[default]
    Unknown,
    Never,
    Bool,
    Str,
    F64,
    /// A number with a point of which nothing more is said.
    Float,
    Int(Int),
    Vec3,
    Ray,
    Picture,
    Ordering,
    Option,
    /// A `Box`, an `Rc` or an `Arc`: they hold one value.
    Box,
    Vec,
    Slice,
    Array(usize),
    Tuple,
    Range,
    Iterator,
    Ref,
    RefMut,
    /// The parameters, and then the result.
    Fn,
    /// A struct or an enum of the reader's.
    Own(usize),
    /// Anything that has a trait of the reader's, behind a pointer or as a parameter.
    Dyn(usize),
    /// A type parameter in the signature of the library.
    Param(usize),
}

/// An integer type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Int {
    /// That of a number without a point of which nothing more is said.
    Any,
    U8,
    U32,
    Usize,
    I32,
}

/// Each with its name and its ends. `usize` is that of a machine with 64 bits, also where a
/// page has 32.
const INTEGERS: [(Int, &str, i128, i128); 4] = [
    (Int::U8, "u8", 0, u8::MAX as i128),
    (Int::U32, "u32", 0, u32::MAX as i128),
    (Int::Usize, "usize", 0, u64::MAX as i128),
    (Int::I32, "i32", i32::MIN as i128, i32::MAX as i128),
];

impl Int {
    pub(crate) fn named(name: &str) -> Option<Self> {
        let mut all = INTEGERS.iter();
        all.find(|it| it.1 == name).map(|it| it.0)
    }

    pub(crate) fn name(self) -> &'static str {
        let mut all = INTEGERS.iter();
        all.find(|it| it.0 == self).map_or("{integer}", |it| it.1)
    }

    /// The least number and the greatest.
    pub(crate) fn ends(self) -> (i128, i128) {
        let mut all = INTEGERS.iter();
        let own = all.find(|it| it.0 == self);
        own.map_or((i64::MIN.into(), i64::MAX.into()), |it| (it.2, it.3))
    }

    pub(crate) fn fits(self, number: i128) -> bool {
        let (least, most) = self.ends();
        (least..=most).contains(&number)
    }

    /// What is left of a number that does not fit.
    pub(crate) fn wrapped(self, number: i128) -> i128 {
        let (least, most) = self.ends();
        (number - least).rem_euclid(most - least + 1) + least
    }

    pub(crate) fn is_signed(self) -> bool {
        self.ends().0 < 0
    }

    /// Which of two it is, if a number without a type gives way.
    pub(crate) fn joined(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Any, it) | (it, Self::Any) => Some(it),
            (one, other) => (one == other).then_some(one),
        }
    }
}

impl From<Head> for Type {
    fn from(head: Head) -> Self {
        Self(head, Vec::new())
    }
}

impl Type {
    pub(crate) const UNKNOWN: Self = Self(Head::Unknown, Vec::new());
    pub(crate) const UNIT: Self = Self(Head::Tuple, Vec::new());

    pub(crate) fn of(head: Head, of: Self) -> Self {
        Self(head, vec![of])
    }

    pub(crate) fn is(&self, head: Head) -> bool {
        self.0 == head
    }

    pub(crate) fn is_unknown(&self) -> bool {
        self.is(Head::Unknown)
    }

    pub(crate) fn is_reference(&self) -> bool {
        matches!(self.0, Head::Ref | Head::RefMut)
    }

    pub(crate) fn is_float(&self) -> bool {
        matches!(self.0, Head::F64 | Head::Float)
    }

    pub(crate) fn is_integer(&self) -> bool {
        matches!(self.0, Head::Int(_))
    }

    /// What an `Option`, a `Box`, a list or a reference is of.
    pub(crate) fn inner(&self) -> Self {
        self.1.first().cloned().unwrap_or(Self::UNKNOWN)
    }

    /// Without its references and boxes.
    pub(crate) fn stripped(&self) -> &Self {
        match (self.0, self.1.first()) {
            (Head::Ref | Head::RefMut | Head::Box, Some(inner)) => inner.stripped(),
            _ => self,
        }
    }

    /// As a part of a value of that type: behind a reference it is one, too.
    pub(crate) fn behind(self, whole: &Self) -> Self {
        match whole.0 {
            Head::Ref | Head::RefMut if !self.is_unknown() => Self::of(whole.0, self),
            _ => self,
        }
    }

    /// The same with each parameter replaced.
    pub(crate) fn with(&self, parameters: &[Self]) -> Self {
        match self.0 {
            Head::Param(n) => parameters[n].clone(),
            head => Self(head, self.1.iter().map(|it| it.with(parameters)).collect()),
        }
    }

    /// The type that a number has where nothing else is said.
    pub(crate) fn settled(self) -> Self {
        match self.0 {
            Head::Float => Head::F64.into(),
            Head::Int(Int::Any) => Self::UNKNOWN,
            head => Self(head, self.1.into_iter().map(Self::settled).collect()),
        }
    }

    /// Whether a value of this type may be where the other is declared.
    pub(crate) fn fits(&self, wanted: &Self, names: &Names) -> bool {
        let fit = |one: &[Self], other: &[Self]| {
            one.len() == other.len()
                && one
                    .iter()
                    .zip(other)
                    .all(|(one, other)| one.fits(other, names))
        };
        match (self.0, wanted.0) {
            (Head::Unknown | Head::Never, _) | (_, Head::Unknown | Head::Param(_)) => true,
            (Head::Float, Head::F64) | (Head::F64, Head::Float) => true,
            (Head::Int(one), Head::Int(other)) => one.joined(other).is_some(),
            (Head::Ref | Head::RefMut, Head::Ref) | (Head::RefMut, Head::RefMut) => {
                self.inner().fits_behind(&wanted.inner(), names)
            }
            (_, Head::Dyn(of)) => names.implements(self, of),
            (Head::Vec | Head::Array(_) | Head::Range, Head::Iterator) => {
                self.inner().fits(&wanted.inner(), names)
            }
            (one, other) => one == other && fit(&self.1, &wanted.1),
        }
    }

    /// The same for what references lead to: boxes and lists are seen through.
    fn fits_behind(&self, wanted: &Self, names: &Names) -> bool {
        self.fits(wanted, names)
            || match (self.0, wanted.0) {
                (Head::Vec | Head::Array(_), Head::Slice) => {
                    self.inner().fits(&wanted.inner(), names)
                }
                (Head::Box | Head::Ref | Head::RefMut, _) => {
                    self.inner().fits_behind(wanted, names)
                }
                _ => false,
            }
    }

    /// The type as the compiler says it in a label: in its quotes if it has a name.
    pub(crate) fn said(&self, names: &Names) -> String {
        match self.0 {
            Head::Int(Int::Any) => "integer".to_owned(),
            Head::Float => "floating-point number".to_owned(),
            _ => format!("`{}`", self.name(names)),
        }
    }

    /// The same in a message.
    pub(crate) fn name(&self, names: &Names) -> String {
        let all: Vec<String> = self.1.iter().map(|it| it.name(names)).collect();
        let of = |name: &str| format!("{name}<{}>", all.join(", "));
        let plain = match self.0 {
            Head::Unknown | Head::Param(_) => "_",
            Head::Never => "!",
            Head::Bool => "bool",
            Head::Str => "str",
            Head::F64 => "f64",
            Head::Float => "{float}",
            Head::Int(int) => int.name(),
            Head::Vec3 => "Vec3",
            Head::Ray => "Ray",
            Head::Picture => "Picture",
            Head::Ordering => "Ordering",
            Head::Own(n) => &names.kinds[n].name,
            Head::Dyn(n) => return format!("dyn {}", names.traits[n].name),
            Head::Option => return of("Option"),
            Head::Box => return of("Box"),
            Head::Vec => return of("Vec"),
            Head::Range => return of("Range"),
            Head::Iterator => return of("Iterator"),
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
