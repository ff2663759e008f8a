//! The functions of the standard library and of glam that no text defines, one line for each, and
//! the faster doubles of functions in the prelude's text.

use std::mem;
use std::ops::{Add, Div, Mul, Neg, Rem, Sub};

use common::rtweekend::{Ray, Vec3};

use crate::integers;
use crate::value::{Native, Value, Wrong, kind};

/// Lists all functions.
pub(crate) fn all() -> impl Iterator<Item = &'static Native> {
    [FLOATS, VECTORS, CONSTANTS, OTHERS].into_iter().flatten()
}

/// Lists the functions of that name.
pub(crate) fn named(name: &str) -> impl Iterator<Item = &'static Native> {
    all().filter(move |it| it.name == name)
}

/// Finds the function that stands in for one of the prelude's text, `Ray::at` or `sky`: it is
/// faster, and returns the same to the last bit.
pub(crate) fn double(name: &str) -> Option<&'static Native> {
    let owned = |it: &&Native| {
        let owner = match it.of {
            kind::ANY => return it.name == name,
            of => kind::NAMES[usize::from(of)],
        };
        name.split_once("::") == Some((owner, it.name))
    };
    [DOUBLES, VECTOR_DOUBLES].into_iter().flatten().find(owned)
}

/// Returns true if the text of a function with a double may call this function of the prelude: an
/// edit of it would be missed there.
pub(crate) fn is_in_doubles(name: &str) -> bool {
    let is_called = ["DVec3::", "f64::", "Ray::new"];
    name != "DVec3::dot" && is_called.iter().any(|it| name.starts_with(it))
}

/// A type that an argument is taken as.
trait Arg<'a>: Sized {
    const CHANGES: usize = 0;

    fn arg(value: &'a mut Value) -> Result<Self, Wrong>;
}

/// Says as which Rust types values are taken.
macro_rules! args {
    ($($ty:ty, $name:literal: $pattern:pat => $taken:expr;)*) => {
        $(impl Arg<'_> for $ty {
            #[inline(always)]
            fn arg(value: &mut Value) -> Result<Self, Wrong> {
                match value {
                    $pattern => Ok($taken),
                    other => Err(Wrong::Type($name, other.kind())),
                }
            }
        })*
    };
}

args! {
    f64, "f64": Value::Float(it) => *it;
    Vec3, "Vec3": Value::Vec3(it) => *it;
    i32, "i32": Value::Int(it, kind::INT | kind::I32) => *it as Self;
    usize, "usize": Value::Int(it, kind::INT | kind::USIZE) => {
        usize::try_from(*it).unwrap_or(Self::MAX)
    };
}

impl Arg<'_> for Value {
    fn arg(value: &mut Value) -> Result<Self, Wrong> {
        Ok(mem::take(value))
    }
}

impl<'a> Arg<'a> for &'a mut Value {
    const CHANGES: usize = 1;

    fn arg(value: &'a mut Value) -> Result<Self, Wrong> {
        Ok(value)
    }
}

impl Arg<'_> for Ray {
    #[inline(always)]
    fn arg(value: &mut Value) -> Result<Self, Wrong> {
        value.ray().ok_or(Wrong::Type("Ray", value.kind()))
    }
}

/// Makes a function from its type, name, parameters and result.
macro_rules! native {
    ($of:ident $name:ident ($($arg:ident: $ty:ty),*) $result:expr) => {
        Native {
            of: kind::$of,
            name: stringify!($name),
            takes: <[&str]>::len(&[$(stringify!($arg)),*]),
            changes: 0 $(+ <$ty as Arg>::CHANGES)*,
            is_constant: false,
            run: |given| {
                let [$($arg),*] = given else {
                    return Err(Wrong::Panic("these are other arguments"));
                };
                $(let $arg: $ty = Arg::arg($arg)?;)*
                Ok(Value::from($result))
            },
        }
    };
}

/// Makes methods of numbers or vectors that are called as in Rust, by their names alone.
macro_rules! same {
    ($($of:ident $ty:ident $arguments:tt { $($name:ident)* })*) => {
        &[$($(same!(@ $of $ty $name $arguments)),*),*]
    };
    (@ $of:ident $ty:ident $name:ident ($($arg:ident: $other:ty),*)) => {
        native!($of $name (this: $ty $(, $arg: $other)*) this.$name($($arg),*))
    };
}

/// Makes constants of types.
macro_rules! constants {
    ($($of:ident { $($name:ident: $value:expr),* })*) => {
        &[$($(Native { is_constant: true, ..native!($of $name () $value) }),*),*]
    };
}

/// Makes functions that have other names or arguments than those of Rust by which they compute.
macro_rules! natives {
    ($($of:ident.$name:ident $arguments:tt => $result:expr;)*) => {
        &[$(native!($of $name $arguments $result)),*]
    };
}

static FLOATS: &[Native] = same! {
    FLOAT f64 () {
        sqrt abs floor ceil round trunc fract signum recip exp ln cbrt sin cos tan asin acos atan
        to_radians to_degrees exp2 log10 log2 sinh cosh tanh
        is_nan is_finite is_infinite is_sign_negative is_sign_positive
    }
    FLOAT f64 (other: f64) { max min powf atan2 hypot copysign rem_euclid log }
    FLOAT f64 (a: f64, b: f64) { mul_add }
    FLOAT f64 (n: i32) { powi }
};

static VECTORS: &[Native] = same! {
    VEC3 Vec3 () {
        normalize_or_zero abs signum floor ceil round fract recip exp length_recip element_sum
        min_element max_element is_nan is_finite is_normalized
    }
    VEC3 Vec3 (other: Vec3) {
        cross min max reflect project_onto distance distance_squared
    }
    VEC3 Vec3 (a: Vec3, t: f64) { lerp }
    VEC3 Vec3 (power: f64) { powf }
};

static VECTOR_DOUBLES: &[Native] = same! {
    VEC3 Vec3 () { length length_squared normalize neg }
    VEC3 Vec3 (other: Vec3) { dot add sub mul div rem }
};

static DOUBLES: &[Native] = natives! {
    RAY.new(origin: Vec3, direction: Vec3) => Ray { origin, direction };
    RAY.at(ray: Ray, t: f64) => ray.origin + t * ray.direction;
    FLOAT.mul(number: f64, vector: Vec3) => number * vector;
    CAMERA.ray(camera: Value, i: Value, j: Value) => match (camera.parts(), i, j) {
        (
            [_, _, Value::Vec3(center), Value::Vec3(pixel00), Value::Vec3(u), Value::Vec3(v)],
            Value::Int(i, _), Value::Int(j, _),
        ) => Ray {
            origin: *center,
            direction: *pixel00 + i as f64 * *u + j as f64 * *v - *center,
        },
        _ => return Err(Wrong::Type("Camera", camera.kind())),
    };
    ANY.sky(ray: Ray) => {
        let a = 0.5 * (ray.direction.normalize().y + 1.0);
        (1.0 - a) * Vec3::ONE + a * Vec3::new(0.5, 0.7, 1.0)
    };
};

static CONSTANTS: &[Native] = constants! {
    FLOAT {
        INFINITY: f64::INFINITY, NEG_INFINITY: f64::NEG_INFINITY, NAN: f64::NAN, MAX: f64::MAX,
        MIN: f64::MIN, MIN_POSITIVE: f64::MIN_POSITIVE, EPSILON: f64::EPSILON
    }
    CONSTS { PI: std::f64::consts::PI, TAU: std::f64::consts::TAU }
    U8 { MAX: Value::Int(u8::MAX.into(), kind::U8) }
    U32 { MAX: u32::MAX }
    I32 { MAX: Value::Int(i32::MAX.into(), kind::I32), MIN: Value::Int(i32::MIN.into(), kind::I32) }
    VEC3 {
        ZERO: Vec3::ZERO, ONE: Vec3::ONE, X: Vec3::X, Y: Vec3::Y, Z: Vec3::Z,
        NEG_X: Vec3::NEG_X, NEG_Y: Vec3::NEG_Y, NEG_Z: Vec3::NEG_Z, NEG_ONE: Vec3::NEG_ONE
    }
};

static OTHERS: &[Native] = natives! {
    ANY.clone(this: Value) => this;
    ANY.as_ref(this: Value) => this;
    ANY.copied(this: Value) => this;
    ANY.cloned(this: Value) => this;
    BOX.new(this: Value) => this;
    MEM.swap(a: &mut Value, b: &mut Value) => mem::swap(a, b);
    MEM.replace(place: &mut Value, new: Value) => mem::replace(place, new);

    FLOAT.from(this: Value) => match this {
        Value::Float(number) => number,
        Value::Bool(truth) => truth.into(),
        Value::Int(number, of) if integers::is_in_a_float(of) => number as f64,
        other => return Err(Wrong::Type("number of at most 32 bits", other.kind())),
    };
    FLOAT.clamp(this: f64, least: f64, most: f64) => match least <= most {
        true => this.clamp(least, most),
        false => return Err(Wrong::Panic("min > max, or either was NaN")),
    };
    FLOAT.total_cmp(a: f64, b: f64) => a.total_cmp(&b);
    FLOAT.partial_cmp(a: f64, b: f64) => a.partial_cmp(&b).map(Value::from);

    VEC3.new(x: f64, y: f64, z: f64) => Vec3::new(x, y, z);
    VEC3.splat(this: f64) => Vec3::splat(this);
    VEC3.clamp(this: Vec3, least: Vec3, most: Vec3) => this.max(least).min(most);
    VEC3.to_array(this: Vec3) => Value::list(this.to_array().map(Value::from));
    VEC3.from_array(all: Value) => match *all.parts() {
        [Value::Float(x), Value::Float(y), Value::Float(z)] => Vec3::new(x, y, z),
        _ => return Err(Wrong::Type("[f64; 3]", all.kind())),
    };

    LIST.new() => Value::list([]);
    LIST.with_capacity(_count: usize) => Value::list([]);
    LIST.len(list: Value) => list.parts().len();
    LIST.iter(list: Value) => list;
    LIST.into_iter(list: Value) => list;
    LIST.collect(list: Value) => list;
    LIST.to_vec(list: Value) => list;
    LIST.clear(list: &mut Value) => *list = Value::list([]);
    LIST.push(list: &mut Value, new: Value) => changed(list, |all| all.push(new));
    LIST.remove(list: &mut Value, n: usize) => match list.parts().len() {
        count if n < count => changed(list, |all| all.remove(n)),
        _ => return Err(Wrong::Panic("removal index should be < len")),
    };
};

/// Changes a list as a `Vec`.
fn changed<T>(list: &mut Value, change: impl FnOnce(&mut Vec<Value>) -> T) -> T {
    let mut all = list.parts().to_vec();
    let result = change(&mut all);
    *list = Value::list(all);
    result
}
