//! Declared types: what parameters, results, fields and variables are said to be. Nothing is
//! inferred: a value shows what it is when it gets there.

/// A type, and those that it is made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Type(pub(crate) Head, pub(crate) Vec<Type>);

/// What a type is apart from those that it is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Head {
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
}

/// An integer type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Int {
    /// That of a number without a point of which nothing more is said.
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

    /// The least number and the greatest.
    pub(crate) fn ends(self) -> (i128, i128) {
        self.row()
            .map_or((i64::MIN.into(), i64::MAX.into()), |it| (it.2, it.3))
    }

    pub(crate) fn has(self, number: i128) -> bool {
        let (least, most) = self.ends();
        (least..=most).contains(&number)
    }

    /// What is left of a number that does not fit.
    pub(crate) fn wrapped(self, number: i128) -> i128 {
        let (least, most) = self.ends();
        (number - least).rem_euclid(most - least + 1) + least
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
    pub(crate) const BOOL: Self = Self(Head::Bool, Vec::new());
    pub(crate) const NEVER: Self = Self(Head::Never, Vec::new());

    pub(crate) fn of(head: Head, of: Self) -> Self {
        Self(head, vec![of])
    }

    pub(crate) fn is(&self, head: Head) -> bool {
        self.0 == head
    }

    pub(crate) fn is_unknown(&self) -> bool {
        self.is(Head::Unknown)
    }

    /// What an `Option`, a `Box`, a list or a reference is of.
    pub(crate) fn inner(&self) -> &Self {
        static NOTHING: Type = Type::UNKNOWN;
        self.1.first().unwrap_or(&NOTHING)
    }

    /// Without its references and boxes.
    pub(crate) fn stripped(&self) -> &Self {
        match (self.0, self.1.first()) {
            (Head::Ref | Head::RefMut | Head::Box, Some(inner)) => inner.stripped(),
            _ => self,
        }
    }
}

/// Of which types a function of the library is one, or whose functions a value has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Owners(pub(crate) u32);

impl Owners {
    /// Functions that are no type's.
    pub(crate) const NONE: Self = Self(0);
    pub(crate) const F64: Self = Self(1);
    pub(crate) const F32: Self = Self(1 << 1);
    pub(crate) const INT: Self = Self(1 << 2);
    pub(crate) const BOOL: Self = Self(1 << 3);
    pub(crate) const VEC3: Self = Self(1 << 4);
    pub(crate) const RAY: Self = Self(1 << 5);
    pub(crate) const PICTURE: Self = Self(1 << 6);
    pub(crate) const STR: Self = Self(1 << 7);
    pub(crate) const ORDERING: Self = Self(1 << 8);
    pub(crate) const OPTION: Self = Self(1 << 9);
    pub(crate) const BOX: Self = Self(1 << 10);
    pub(crate) const VEC: Self = Self(1 << 11);
    pub(crate) const ARRAY: Self = Self(1 << 12);
    /// A vector, an array or a slice.
    pub(crate) const LIST: Self = Self(1 << 13);
    pub(crate) const RANGE: Self = Self(1 << 14);
    pub(crate) const ITERATOR: Self = Self(1 << 15);
    /// Whatever can be copied.
    pub(crate) const ANY: Self = Self(1 << 16);

    pub(crate) const fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    pub(crate) fn has(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Those whose functions the type has.
    pub(crate) fn of(head: Head) -> Self {
        match head {
            Head::F64 => Self::F64.or(Self::ANY),
            Head::F32 => Self::F32.or(Self::ANY),
            Head::Int(_) => Self::INT.or(Self::ANY),
            Head::Bool => Self::BOOL.or(Self::ANY),
            Head::Vec3 => Self::VEC3.or(Self::ANY),
            Head::Ray => Self::RAY.or(Self::ANY),
            Head::Picture => Self::PICTURE,
            Head::Str => Self::STR.or(Self::ANY),
            Head::Ordering => Self::ORDERING.or(Self::ANY),
            Head::Option => Self::OPTION.or(Self::ANY),
            Head::Box => Self::BOX,
            Head::Vec => Self::VEC.or(Self::LIST).or(Self::ANY),
            Head::Array(_) => Self::ARRAY.or(Self::LIST).or(Self::ANY),
            Head::Slice => Self::LIST,
            Head::Range => Self::RANGE.or(Self::ITERATOR).or(Self::ANY),
            Head::Iterator => Self::ITERATOR.or(Self::ANY),
            Head::Tuple => Self::ANY,
            _ => Self::NONE,
        }
    }
}
