//! Hindley–Milner types: what is not written is a variable, and unification finds it.

use std::iter;

use crate::items::Items;

/// A type, with variables for what is not known yet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Type {
    Var(usize),
    Of(Head, Vec<Type>),
}

/// What a type is apart from its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Head {
    Never,
    Bool,
    Str,
    F64,
    F32,
    Int(Int),
    Vec3,
    Ray,
    Camera,
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Int {
    pub(crate) name: &'static str,
    pub(crate) least: i128,
    pub(crate) most: i128,
}

macro_rules! integers {
    ($($kind:ident)*) => {
        &[$(Int { name: stringify!($kind), least: $kind::MIN as i128, most: $kind::MAX as i128 },)*]
    };
}

/// `usize` is that of a machine with 64 bits, also where a page has 32.
pub(crate) const INTEGERS: &[Int] = integers! { u8 u16 u32 u64 i8 i16 i32 i64 };

impl Int {
    pub(crate) fn named(name: &str) -> Option<Self> {
        let sized = |name| Self::named(name);
        match name {
            "usize" => sized("u64").map(|it| Self {
                name: "usize",
                ..it
            }),
            "isize" => sized("i64").map(|it| Self {
                name: "isize",
                ..it
            }),
            _ => INTEGERS.iter().find(|it| it.name == name).copied(),
        }
    }

    /// The type of that name, which there is.
    pub(crate) fn plain(name: &str) -> Type {
        Type::plain(Head::Int(Self::named(name).expect("it is an integer type")))
    }

    /// What is left of a number that does not fit.
    pub(crate) fn wrapped(self, number: i128) -> i128 {
        let size = self.most - self.least + 1;
        (number - self.least).rem_euclid(size) + self.least
    }

    pub(crate) fn fits(self, number: i128) -> bool {
        (self.least..=self.most).contains(&number)
    }
}

impl Type {
    pub(crate) const fn plain(head: Head) -> Self {
        Self::Of(head, Vec::new())
    }

    pub(crate) fn unit() -> Self {
        Self::plain(Head::Tuple)
    }

    pub(crate) fn one(head: Head, of: Self) -> Self {
        Self::Of(head, vec![of])
    }

    pub(crate) fn function(parameters: Vec<Self>, result: Self) -> Self {
        Self::Of(
            Head::Fn,
            parameters.into_iter().chain(iter::once(result)).collect(),
        )
    }

    pub(crate) fn head(&self) -> Option<Head> {
        match self {
            Self::Var(_) => None,
            Self::Of(head, _) => Some(*head),
        }
    }

    pub(crate) fn is(&self, head: Head) -> bool {
        self.head() == Some(head)
    }

    pub(crate) fn is_unit(&self) -> bool {
        *self == Self::unit()
    }

    /// What an `Option`, a `Box`, a list or a reference is of.
    pub(crate) fn inner(&self) -> Self {
        match self {
            Self::Of(_, arguments) => arguments.first().cloned().unwrap_or_else(Self::unit),
            Self::Var(_) => self.clone(),
        }
    }

    /// The same with each parameter replaced.
    pub(crate) fn with(&self, parameters: &[Self]) -> Self {
        match self {
            Self::Of(Head::Param(n), _) => parameters[*n].clone(),
            Self::Of(head, arguments) => {
                let arguments = arguments.iter().map(|it| it.with(parameters));
                Self::Of(*head, arguments.collect())
            }
            Self::Var(_) => self.clone(),
        }
    }
}

/// What is known of a variable.
#[derive(Clone, Debug)]
enum Known {
    Nothing,
    /// It is a number without a point.
    Integer,
    /// It is a number with a point.
    Float,
    Is(Type),
}

/// The variables of a function.
#[derive(Default)]
pub(crate) struct Unifier {
    variables: Vec<Known>,
}

impl Unifier {
    pub(crate) fn any(&mut self) -> Type {
        self.variable(Known::Nothing)
    }

    pub(crate) fn integer(&mut self) -> Type {
        self.variable(Known::Integer)
    }

    pub(crate) fn float(&mut self) -> Type {
        self.variable(Known::Float)
    }

    fn variable(&mut self, known: Known) -> Type {
        self.variables.push(known);
        Type::Var(self.variables.len() - 1)
    }

    pub(crate) fn is_integer(&self, ty: &Type) -> bool {
        matches!(ty, Type::Var(n) if matches!(self.variables[*n], Known::Integer))
            || matches!(ty.head(), Some(Head::Int(_)))
    }

    pub(crate) fn is_float(&self, ty: &Type) -> bool {
        matches!(ty, Type::Var(n) if matches!(self.variables[*n], Known::Float))
            || matches!(ty.head(), Some(Head::F64 | Head::F32))
    }

    /// The type as far as it is known, its arguments aside.
    pub(crate) fn known(&self, ty: &Type) -> Type {
        match ty {
            Type::Var(n) => match &self.variables[*n] {
                Known::Is(ty) => self.known(ty),
                _ => ty.clone(),
            },
            Type::Of(..) => ty.clone(),
        }
    }

    /// The type as far as it is known.
    pub(crate) fn whole(&self, ty: &Type) -> Type {
        match self.known(ty) {
            Type::Of(head, arguments) => {
                let arguments = arguments.iter().map(|it| self.whole(it));
                Type::Of(head, arguments.collect())
            }
            variable @ Type::Var(_) => variable,
        }
    }

    /// The same, with the types that numbers have where nothing else is said.
    pub(crate) fn settled(&self, ty: &Type) -> Type {
        match self.known(ty) {
            Type::Of(head, arguments) => {
                let arguments = arguments.iter().map(|it| self.settled(it));
                Type::Of(head, arguments.collect())
            }
            Type::Var(n) => match self.variables[n] {
                Known::Integer => Int::plain("i32"),
                Known::Float => Type::plain(Head::F64),
                _ => Type::Var(n),
            },
        }
    }

    /// Makes both the same type, if they can be.
    pub(crate) fn unify(&mut self, one: &Type, other: &Type) -> bool {
        match (self.known(one), self.known(other)) {
            (Type::Var(n), Type::Var(m)) if n == m => true,
            (Type::Var(n), other) | (other, Type::Var(n)) => self.bind(n, other),
            (Type::Of(one, of), Type::Of(other, others)) => {
                one == other
                    && of.len() == others.len()
                    && of
                        .iter()
                        .zip(&others)
                        .all(|(one, other)| self.unify(one, other))
            }
        }
    }

    fn bind(&mut self, variable: usize, ty: Type) -> bool {
        let fits = match self.variables[variable] {
            Known::Integer => self.is_integer(&ty),
            Known::Float => self.is_float(&ty),
            _ => true,
        };
        match ty {
            // Of two variables the one that knows less gives way.
            Type::Var(other) if !fits && matches!(self.variables[other], Known::Nothing) => {
                self.variables[other] = Known::Is(Type::Var(variable));
                true
            }
            _ if !fits || self.occurs(variable, &ty) => false,
            _ => {
                self.variables[variable] = Known::Is(ty);
                true
            }
        }
    }

    fn occurs(&self, variable: usize, ty: &Type) -> bool {
        match self.known(ty) {
            Type::Var(n) => n == variable,
            Type::Of(_, arguments) => arguments.iter().any(|it| self.occurs(variable, it)),
        }
    }

    /// The type as the compiler says it, in its quotes if it has a name.
    pub(crate) fn said(&self, ty: &Type, items: &Items) -> String {
        match self.known(ty) {
            it @ Type::Var(_) if self.is_integer(&it) => "integer".to_owned(),
            it @ Type::Var(_) if self.is_float(&it) => "floating-point number".to_owned(),
            it => format!("`{}`", self.name(&it, items)),
        }
    }

    pub(crate) fn name(&self, ty: &Type, items: &Items) -> String {
        let ty = self.known(ty);
        let Type::Of(head, arguments) = &ty else {
            return match (self.is_integer(&ty), self.is_float(&ty)) {
                (true, _) => "{integer}".to_owned(),
                (_, true) => "{float}".to_owned(),
                _ => "_".to_owned(),
            };
        };
        let all: Vec<String> = arguments.iter().map(|it| self.name(it, items)).collect();
        let of = |name: &str| format!("{name}<{}>", all.join(", "));
        match head {
            Head::Never => "!".to_owned(),
            Head::Bool => "bool".to_owned(),
            Head::Str => "str".to_owned(),
            Head::F64 => "f64".to_owned(),
            Head::F32 => "f32".to_owned(),
            Head::Int(int) => int.name.to_owned(),
            Head::Vec3 => "Vec3".to_owned(),
            Head::Ray => "Ray".to_owned(),
            Head::Camera => "Camera".to_owned(),
            Head::Picture => "Picture".to_owned(),
            Head::Ordering => "Ordering".to_owned(),
            Head::Option => of("Option"),
            Head::Box => of("Box"),
            Head::Vec => of("Vec"),
            Head::Range => of("Range"),
            Head::Iterator => of("Iterator"),
            Head::Slice => format!("[{}]", all[0]),
            Head::Array(length) => format!("[{}; {length}]", all[0]),
            Head::Tuple if all.len() == 1 => format!("({},)", all[0]),
            Head::Tuple => format!("({})", all.join(", ")),
            Head::Ref => format!("&{}", all[0]),
            Head::RefMut => format!("&mut {}", all[0]),
            Head::Fn => {
                let (result, parameters) = all.split_last().expect("a function has a result");
                match result.as_str() {
                    "()" => format!("fn({})", parameters.join(", ")),
                    _ => format!("fn({}) -> {result}", parameters.join(", ")),
                }
            }
            Head::Own(n) => items.kinds[*n].name.clone(),
            Head::Dyn(n) => format!("dyn {}", items.traits[*n].name),
            Head::Param(n) => format!("T{n}"),
        }
    }
}
