//! Declared types of parameters, results, fields and variables. No type is inferred: that of a
//! value is checked against the declared one when the program runs.

/// A type: its constructor and the types to which that is applied, as `Option` and `f64`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Type(pub(crate) Ctor, pub(crate) Vec<Type>);

/// A type constructor: `Option` in `Option<f64>`, or a whole type without parameters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Ctor {
    /// An unknown type, which fits every value.
    #[default]
    Unknown,
    Never,
    Bool,
    /// Both `str` and `String`.
    Str,
    F64,
    F32,
    Int(Int),
    Vec3,
    Ray,
    Picture,
    Ordering,
    Option,
    /// A `Box`, an `Rc` or an `Arc`, which hold one value.
    Box,
    Vec,
    Slice,
    Array(usize),
    Tuple,
    Range,
    Iterator,
    Ref,
    RefMut,
    /// A function: applied to its parameters, and then to its result.
    Fn,
    /// A struct of the text, by its number.
    Own(u32),
    /// Any type that has a trait of the text, by the trait's number: `dyn` or `impl`.
    Dyn(usize),
    /// The type of the receiver, in the signature of a library method.
    Like,
}

/// An integer type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Int {
    /// The type of an integer literal of which nothing more is known.
    Any,
    U8,
    U16,
    U32,
    U64,
    Usize,
    I32,
    I64,
}

/// Each integer type with its name and its least and greatest number. `usize` has 64 bits, also
/// where a page has 32.
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
    /// Returns the integer type of that name.
    pub(crate) fn named(name: &str) -> Option<Self> {
        INTEGERS.iter().find(|it| it.1 == name).map(|it| it.0)
    }

    /// Returns the type's row in the table.
    fn row(self) -> Option<&'static (Self, &'static str, i128, i128)> {
        INTEGERS.iter().find(|it| it.0 == self)
    }

    /// Returns the name of the type.
    pub(crate) fn name(self) -> &'static str {
        self.row().map_or("{integer}", |it| it.1)
    }

    /// Returns the least and the greatest number of the type.
    pub(crate) fn ends(self) -> (i128, i128) {
        self.row()
            .map_or((i64::MIN.into(), i64::MAX.into()), |it| (it.2, it.3))
    }

    /// Returns true if the number is one of the type's.
    pub(crate) fn has(self, number: i128) -> bool {
        let (least, most) = self.ends();
        (least..=most).contains(&number)
    }

    /// Wraps a number around the ends of the type, as `as` does.
    pub(crate) fn wrapped(self, number: i128) -> i128 {
        let (least, most) = self.ends();
        (number - least).rem_euclid(most - least + 1) + least
    }

    /// Returns the one type of two integers: a literal takes that of the other. `None` if they
    /// differ.
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

    /// Makes a type of a constructor and one parameter.
    pub(crate) fn of(ctor: Ctor, of: Self) -> Self {
        Self(ctor, vec![of])
    }

    /// Returns true if this is the type's constructor.
    pub(crate) fn is(&self, ctor: Ctor) -> bool {
        self.0 == ctor
    }

    pub(crate) fn is_unknown(&self) -> bool {
        self.is(Ctor::Unknown)
    }

    /// Returns the type's first parameter: the value of an `Option`, a `Box`, a list or a
    /// reference. Unknown if there is none.
    pub(crate) fn inner(&self) -> &Self {
        static NOTHING: Type = Type::UNKNOWN;
        self.1.first().unwrap_or(&NOTHING)
    }

    /// Returns the type of a function with that many parameters of unknown types.
    pub(crate) fn function(parameters: usize) -> Self {
        Self(Ctor::Fn, vec![Self::UNKNOWN; parameters + 1])
    }

    /// Replaces [`Ctor::Like`] by the type of a method's receiver.
    pub(crate) fn with(&self, like: &Self) -> Self {
        match self.0 {
            Ctor::Like => like.clone(),
            ctor => Self(ctor, self.1.iter().map(|it| it.with(like)).collect()),
        }
    }

    /// Returns the type behind references and boxes.
    pub(crate) fn stripped(&self) -> &Self {
        match (self.0, self.1.first()) {
            (Ctor::Ref | Ctor::RefMut | Ctor::Box, Some(inner)) => inner.stripped(),
            _ => self,
        }
    }
}
