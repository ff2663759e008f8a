//! Dynamically typed values, and the types that are known from the start.
//!
//! A shared reference `&x` is the value itself: nothing changes while it lives. Values are copied
//! when one of two owners changes its own (copy on write).

use std::cell::{Cell, RefCell};
use std::fmt;
use std::rc::Rc;

use common::rtweekend::{Ray, Vec3};

/// A type without its arguments: `Option`, not `Option<f64>`. The number of a struct or an enum of
/// a text, or of a type that is known from the start.
pub(crate) type Kind = u16;

/// Numbers the kinds that are known from the start, and lists their names.
macro_rules! kinds {
    ($($constant:ident $name:literal)*) => {
        pub(crate) mod kind {
            use super::Kind;

            pub(crate) const NAMES: &[&str] = &[$($name),*];
            kinds!(@ 0; $($constant)*);
            /// Not the kind of any value: what is declared as such may be of each kind.
            pub(crate) const ANY: Kind = Kind::MAX;
        }
    };
    (@ $n:expr; $constant:ident $($more:ident)*) => {
        pub(crate) const $constant: Kind = $n;
        kinds!(@ $n + 1; $($more)*);
    };
    (@ $n:expr;) => {};
}

// An `INT` is an integer of which no more is known, as a literal. The kinds from `VEC3` on are
// declared in `texts/std.rs` and `texts/prelude.rs`, in this order.
kinds! {
    UNIT "()" BOOL "bool" INT "integer" U8 "u8" U16 "u16" U32 "u32" U64 "u64" USIZE "usize"
    I8 "i8" I16 "i16" I32 "i32" I64 "i64" ISIZE "isize" FLOAT "f64" TUPLE "tuple" LIST "Vec"
    FUNCTION "fn" TEXT "text" BOX "Box" MEM "mem" CONSTS "consts"
    VEC3 "DVec3" OPTION "Option" ORDERING "Ordering" RANGE "Range" PICTURE "Picture" RAY "Ray"
    CAMERA "Camera"
}

/// A value of a running program.
#[derive(Clone, Default)]
pub enum Value {
    /// The value `()`.
    #[default]
    Unit,
    /// A truth.
    Bool(bool),
    /// An integer and its type.
    Int(i64, Kind),
    /// A number in double precision.
    Float(f64),
    /// A vector, a point or a color.
    Vec3(Vec3),
    /// A value with parts: a struct, a variant, a tuple or a list; `None` if it is empty.
    Data(Shape, Option<Rc<[Self]>>),
    /// A function that has a name.
    Function(Target),
    /// A closure.
    Closure(Rc<Closure>),
}

/// What a value with parts is, and how deep its parts are nested. Aligned, so that the payload of
/// each value starts at the same byte: a processor is slow to read across what it has just written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(8))]
pub struct Shape {
    pub(crate) kind: Kind,
    pub(crate) variant: u8,
    depth: u8,
}

/// A function that has a name.
#[derive(Clone, Copy)]
pub enum Target {
    /// A function of a text, by its number.
    Own(usize),
    /// A function of the table of natives.
    Native(&'static Native),
    /// A variant or a struct whose fields have no names.
    Variant(Shape),
    /// `default` of a type whose text has no such function.
    Default(Kind),
}

/// A function that no text defines, or a constant. It needs nothing but its arguments.
pub struct Native {
    /// The type to which it belongs.
    pub(crate) of: Kind,
    pub(crate) name: &'static str,
    pub(crate) takes: usize,
    /// How many of its first arguments it changes.
    pub(crate) changes: usize,
    pub(crate) is_constant: bool,
    pub(crate) run: fn(&mut [Value]) -> Result<Value, Wrong>,
}

/// A reason why a native function has no result.
pub(crate) enum Wrong {
    /// An argument is not of the type that is named, but of another.
    Type(&'static str, Kind),
    Panic(&'static str),
}

/// A closure, and where the variables are that it uses.
pub struct Closure {
    /// The function in whose text it stands, and its number there.
    pub(crate) code: (usize, usize),
    pub(crate) variables: Variables,
    pub(crate) depth: u8,
    /// True while it is called.
    pub(crate) is_running: Cell<bool>,
}

/// The variables around a closure that it uses.
pub(crate) enum Variables {
    /// Those of a frame that is still open, by its first slot.
    InFrame(usize),
    /// Copies of its own.
    Moved(RefCell<Vec<Value>>),
}

impl Shape {
    pub(crate) const TUPLE: Self = Self::new(kind::TUPLE, 0);
    pub(crate) const LIST: Self = Self::new(kind::LIST, 0);
    pub(crate) const NONE: Self = Self::new(kind::OPTION, 0);
    pub(crate) const SOME: Self = Self::new(kind::OPTION, 1);
    pub(crate) const RANGE: Self = Self::new(kind::RANGE, 0);
    /// A text. It is only shown, and so has no letters here.
    pub(crate) const TEXT: Self = Self::new(kind::TEXT, 0);

    pub(crate) const fn new(kind: Kind, variant: u8) -> Self {
        Self {
            kind,
            variant,
            depth: 0,
        }
    }

    /// Returns the shape of a value in which a part is nested that deeply.
    pub(crate) fn around(self, depth: u8) -> Self {
        Self {
            depth: self.depth.max(depth.saturating_add(1)),
            ..self
        }
    }
}

impl Value {
    /// Makes a value of its parts. A vector has a representation of its own.
    pub(crate) fn data(shape: Shape, parts: impl Into<Rc<[Self]>>) -> Self {
        let parts = parts.into();
        if let (kind::VEC3, &[Self::Float(x), Self::Float(y), Self::Float(z)]) =
            (shape.kind, &*parts)
        {
            return Self::Vec3(Vec3::new(x, y, z));
        }
        let shape = parts.iter().fold(shape, |it, part| it.around(part.depth()));
        Self::Data(shape, (!parts.is_empty()).then_some(parts))
    }

    pub(crate) fn list(parts: impl Into<Rc<[Self]>>) -> Self {
        Self::data(Shape::LIST, parts)
    }

    pub(crate) fn kind(&self) -> Kind {
        match self {
            Self::Unit => kind::UNIT,
            Self::Bool(_) => kind::BOOL,
            Self::Int(_, kind) => *kind,
            Self::Float(_) => kind::FLOAT,
            Self::Vec3(_) => kind::VEC3,
            Self::Data(shape, _) => shape.kind,
            Self::Function(_) | Self::Closure(_) => kind::FUNCTION,
        }
    }

    /// Returns how deep values are nested in the value.
    pub(crate) fn depth(&self) -> u8 {
        match self {
            Self::Data(shape, _) => shape.depth,
            Self::Closure(closure) => closure.depth,
            _ => 0,
        }
    }

    /// Returns the parts of a struct, a variant, a tuple or a list, in their order; none of another
    /// value. An `Option` has one or none.
    pub fn parts(&self) -> &[Self] {
        match self {
            Self::Data(_, Some(parts)) => parts,
            _ => &[],
        }
    }

    /// Returns part `n`, which may be a component of a vector.
    #[inline]
    pub(crate) fn part(&self, n: usize) -> Option<Self> {
        match self {
            Self::Vec3(vector) => vector.to_array().get(n).map(|&it| Self::Float(it)),
            _ => self.parts().get(n).cloned(),
        }
    }

    /// Returns the number, if it is an `f64`.
    pub fn float(&self) -> Option<f64> {
        match self {
            Self::Float(number) => Some(*number),
            _ => None,
        }
    }

    /// Returns the vector, the point or the color.
    pub fn vec3(&self) -> Option<Vec3> {
        match self {
            Self::Vec3(vector) => Some(*vector),
            _ => None,
        }
    }

    /// Returns the ray, if it is one of the prelude's type.
    pub fn ray(&self) -> Option<Ray> {
        match self.parts() {
            [Self::Vec3(origin), Self::Vec3(direction)] if self.kind() == kind::RAY => Some(Ray {
                origin: *origin,
                direction: *direction,
            }),
            _ => None,
        }
    }
}

/// Says how values are made of Rust's own.
macro_rules! from {
    ($($ty:ty: $it:ident => $value:expr;)*) => {
        $(impl From<$ty> for Value {
            #[inline]
            fn from($it: $ty) -> Self {
                $value
            }
        })*
    };
}

from! {
    (): _unit => Self::Unit;
    f64: it => Self::Float(it);
    bool: it => Self::Bool(it);
    Vec3: it => Self::Vec3(it);
    u32: it => Self::Int(it.into(), kind::U32);
    usize: it => Self::Int(it as i64, kind::USIZE);
    Ray: it => Self::data(Shape::new(kind::RAY, 0), [it.origin, it.direction].map(Self::from));
    Option<Self>: option => match option {
        Some(it) => Self::data(Shape::SOME, [it]),
        None => Self::Data(Shape::NONE, None),
    };
    std::cmp::Ordering: it => Self::Data(Shape::new(kind::ORDERING, (it as i8 + 1) as u8), None);
}

impl fmt::Display for Value {
    /// Writes a number, a truth, a vector or an option of these in one line, numbers as
    /// [`format_number`] formats them; nothing for any other value.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Float(number) => f.write_str(&format_number(*number)),
            Self::Int(number, _) => number.fmt(f),
            Self::Bool(truth) => truth.fmt(f),
            Self::Vec3(vector) => {
                let [x, y, z] = vector.to_array().map(format_number);
                write!(f, "({x}, {y}, {z})")
            }
            Self::Data(Shape::NONE, _) => f.write_str("none"),
            _ if self.kind() == kind::OPTION => self.parts()[0].fmt(f),
            _ => Ok(()),
        }
    }
}

/// Formats a number with up to six decimals and no zeros at the end, such as `0.5`, or in
/// scientific notation with four significant digits if its size is below 0.001 and not 0. NaN is
/// `NaN`.
pub fn format_number(number: f64) -> String {
    match number.abs() {
        small if small != 0.0 && small < 1e-3 => format!("{number:.3e}"),
        _ => format!("{}", (number * 1e6).round() / 1e6),
    }
}
