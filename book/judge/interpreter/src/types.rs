//! Declared types: what parameters, results, fields and variables are said to be. Nothing is
//! inferred: a value shows what it is when it gets there.

/// A type, and those that it is made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Type(pub(crate) Ctor, pub(crate) Vec<Type>);

/// A type apart from those that it is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Ctor {
    /// Nothing says what it is: it fits whatever there is.
    #[default]
    Unknown,
    Never,
    Bool,
    Str,
    F64,
    F32,
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
    /// A struct of the reader's.
    Own(u32),
    /// Anything that has a trait of the reader's, behind a pointer or as a parameter.
    Dyn(usize),
    /// The type of the value that a method of the library is called on.
    Like,
}

/// An integer type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Int {
    /// The type of a number without a point of which nothing more is said.
    Any,
    U8,
    U16,
    U32,
    U64,
    Usize,
    I32,
    I64,
}

/// Each with its name and its ends. `usize` is that of a machine with 64 bits, also where a
/// page has 32.
const INTEGERS: [(Int, &str, i128, i128); 7] = [
    (Int::U8, "u8", 0, u8::MAX as i128),
    (Int::U16, "u16", 0, u16::MAX as i128),
    (Int::U32, "u32", 0, u32::MAX as i128),
    (Int::U64, "u64", 0, u64::MAX as i128),
    (Int::Usize, "usize", 0, u64::MAX as i128),
    (Int::I32, "i32", i32::MIN as i128, i32::MAX as i128),
    (Int::I64, "i64", i64::MIN as i128, i64::MAX as i128),
];

impl Int {
    pub(crate) fn named(name: &str) -> Option<Self> {
        INTEGERS.iter().find(|it| it.1 == name).map(|it| it.0)
    }

    fn row(self) -> Option<&'static (Self, &'static str, i128, i128)> {
        INTEGERS.iter().find(|it| it.0 == self)
    }

    pub(crate) fn name(self) -> &'static str {
        self.row().map_or("{integer}", |it| it.1)
    }

    /// Returns the least number and the greatest.
    pub(crate) fn ends(self) -> (i128, i128) {
        self.row()
            .map_or((i64::MIN.into(), i64::MAX.into()), |it| (it.2, it.3))
    }

    pub(crate) fn has(self, number: i128) -> bool {
        let (least, most) = self.ends();
        (least..=most).contains(&number)
    }

    /// Returns what is left of a number that does not fit.
    pub(crate) fn wrapped(self, number: i128) -> i128 {
        let (least, most) = self.ends();
        (number - least).rem_euclid(most - least + 1) + least
    }

    /// Returns which of two it is, if a number without a type gives way.
    pub(crate) fn joined(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Any, it) | (it, Self::Any) => Some(it),
            (one, other) => (one == other).then_some(one),
        }
    }
}

impl From<Ctor> for Type {
    fn from(ctor: Ctor) -> Self {
        Self(ctor, Vec::new())
    }
}

impl Type {
    pub(crate) const UNKNOWN: Self = Self(Ctor::Unknown, Vec::new());
    pub(crate) const UNIT: Self = Self(Ctor::Tuple, Vec::new());
    pub(crate) const BOOL: Self = Self(Ctor::Bool, Vec::new());
    pub(crate) const NEVER: Self = Self(Ctor::Never, Vec::new());

    pub(crate) fn of(ctor: Ctor, of: Self) -> Self {
        Self(ctor, vec![of])
    }

    pub(crate) fn is(&self, ctor: Ctor) -> bool {
        self.0 == ctor
    }

    pub(crate) fn is_unknown(&self) -> bool {
        self.is(Ctor::Unknown)
    }

    /// Returns what an `Option`, a `Box`, a list or a reference is of.
    pub(crate) fn inner(&self) -> &Self {
        static NOTHING: Type = Type::UNKNOWN;
        self.1.first().unwrap_or(&NOTHING)
    }

    /// Returns the type of a function of so many parameters.
    pub(crate) fn function(parameters: usize) -> Self {
        Self(Ctor::Fn, vec![Self::UNKNOWN; parameters + 1])
    }

    /// Returns the type with another in the place of what a method is called on.
    pub(crate) fn with(&self, like: &Self) -> Self {
        match self.0 {
            Ctor::Like => like.clone(),
            ctor => Self(ctor, self.1.iter().map(|it| it.with(like)).collect()),
        }
    }

    /// Returns the type without its references and boxes.
    pub(crate) fn stripped(&self) -> &Self {
        match (self.0, self.1.first()) {
            (Ctor::Ref | Ctor::RefMut | Ctor::Box, Some(inner)) => inner.stripped(),
            _ => self,
        }
    }
}
