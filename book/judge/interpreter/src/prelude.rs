//! The library: each function of Rust and of our prelude that a chapter or its reader may
//! call, with its signature as Rust has it.
//!
//! What iterators give is a list at once: only a closure that changes something could tell.

use std::cmp::Ordering;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::LazyLock;

use common::rtweekend::{Camera, Picture, Ray, Vec3, sky};

use crate::canvas::Brush;
use crate::names::{Context, Names, Signature};
use crate::node::{At, Node};
use crate::run::{Eval, Machine};
use crate::types::{Head, Int, Type};
use crate::value::Value;

/// A function of the library.
#[derive(Debug)]
pub(crate) struct Native {
    /// Which types have it.
    pub(crate) owner: &'static str,
    pub(crate) signature: Signature,
    pub(crate) run: Run,
}

type Run = fn(&mut Machine<'_>, &mut [Value], At) -> Eval;

/// Type parameters of the signatures: `T` is what a list, an option or an iterator is of.
const PARAMETERS: [&str; 3] = ["T", "U", "Own"];

/// The library, in the order of the list below.
pub(crate) static NATIVES: LazyLock<Vec<Native>> = LazyLock::new(|| {
    let names = Names::library();
    let of = |(n, name): (usize, &&str)| ((*name).to_owned(), Head::Param(n).into());
    let context = Context {
        own: Some(Head::Param(2).into()),
        parameters: HashMap::from_iter(PARAMETERS.iter().enumerate().map(of)),
        ..Context::default()
    };
    let read = |&(owner, signature, run): &(&'static str, &str, Run)| {
        let tree = syn::parse_str(signature).expect("it is Rust");
        let signature = names.signature(&context, &tree);
        Native {
            owner,
            signature: signature.expect("its types are known"),
            run,
        }
    };
    LIBRARY.iter().map(read).collect()
});

/// The same, by whose they are and their names.
static BY_NAME: LazyLock<HashMap<(&str, &str), &Native>> = LazyLock::new(|| {
    let all = NATIVES.iter();
    all.map(|it| ((it.owner, it.signature.name.as_str()), it))
        .collect()
});

/// Where the type's functions are in the list. What a list has a vector has, too.
pub(crate) fn owners(ty: &Type) -> &'static [&'static str] {
    match ty.0 {
        Head::F64 => &["f64", "any"],
        Head::Int(_) => &["int", "any"],
        Head::Bool => &["bool", "any"],
        Head::Vec3 => &["Vec3", "any"],
        Head::Ray => &["Ray", "any"],
        Head::Picture => &["Picture"],
        Head::Str => &["str", "any"],
        Head::Ordering => &["Ordering", "any"],
        Head::Option => &["Option", "any"],
        Head::Box => &["Box"],
        Head::Vec => &["Vec", "list", "any"],
        Head::Array(_) => &["array", "list", "any"],
        Head::Slice => &["list"],
        Head::Range => &["Range", "Iterator"],
        Head::Iterator => &["Iterator"],
        _ => &["any"],
    }
}

/// A function of the library.
pub(crate) fn native(owner: &str, name: &str) -> Option<&'static Native> {
    BY_NAME.get(&(owner, name)).copied()
}

fn rest(machine: &mut Machine<'_>, of: &Value, at: At) -> Eval<Vec<Value>> {
    let mut iterator = machine.iterator(of, at)?;
    let mut all = Vec::new();
    while let Some(value) = iterator.next() {
        machine.turn(at)?;
        all.push(value);
    }
    Ok(all)
}

/// Some of what becomes of each value.
fn adapted(
    machine: &mut Machine<'_>,
    of: &Value,
    at: At,
    mut change: impl FnMut(&mut Machine<'_>, Value) -> Eval<Option<Value>>,
) -> Eval {
    let mut iterator = machine.iterator(of, at)?;
    let mut all = Vec::new();
    while let Some(value) = iterator.next() {
        machine.turn(at)?;
        all.extend(change(machine, value)?);
    }
    list(all)
}

/// The first value of which the function says that.
fn found(machine: &mut Machine<'_>, a: &[Value], at: At, wanted: bool) -> Eval<Option<Value>> {
    let mut iterator = machine.iterator(&a[0], at)?;
    while let Some(value) = iterator.next() {
        machine.turn(at)?;
        if machine.asked(&a[1], &mut [value.clone()], at)? == wanted {
            return Ok(Some(value));
        }
    }
    Ok(None)
}

/// The least value, of equal ones the first.
fn least(machine: &mut Machine<'_>, a: &[Value], at: At) -> Eval {
    let mut best: Option<Value> = None;
    for value in rest(machine, &a[0], at)? {
        let is_better = match &best {
            None => true,
            Some(best) => machine.ordered(&a[1], [best, &value], at)?.is_gt(),
        };
        if is_better {
            best = Some(value);
        }
    }
    Ok(Value::of(best))
}

/// A picture whose pixels are colored when they are asked for.
fn painted(size: (u32, u32), brush: Brush) -> Eval {
    Ok(Value::Picture(Rc::new((size, Rc::new(brush)))))
}

fn size(value: &Value) -> u32 {
    value.int().clamp(0, u32::MAX.into()) as u32
}

/// What a function comes to that is given to another.
impl Machine<'_> {
    fn applied(&mut self, f: &Value, given: &mut [Value], ty: impl Into<Type>, at: At) -> Eval {
        let value = self.apply(f, given, at)?;
        self.declared(value, &ty.into(), at)
    }

    fn asked(&mut self, f: &Value, given: &mut [Value], at: At) -> Eval<bool> {
        Ok(self.applied(f, given, Head::Bool, at)?.truth())
    }

    fn chosen(&mut self, f: &Value, given: &mut [Value], at: At) -> Eval<Option<Value>> {
        let ty = Type::of(Head::Option, Type::UNKNOWN);
        Ok(self.applied(f, given, ty, at)?.option())
    }

    fn ordered(&mut self, f: &Value, given: [&Value; 2], at: At) -> Eval<Ordering> {
        let mut given = given.map(Value::clone);
        Ok(self.applied(f, &mut given, Head::Ordering, at)?.ordering())
    }
}

fn float(value: f64) -> Eval {
    Ok(Value::Float(value))
}

fn vector(value: Vec3) -> Eval {
    Ok(Value::Vec3(value))
}

fn bool(value: bool) -> Eval {
    Ok(Value::Bool(value))
}

fn text(value: String) -> Eval {
    Ok(Value::Str(Rc::new(value)))
}

fn order(value: Ordering) -> Eval {
    Ok(Value::Ordering(value))
}

fn ray(value: Ray) -> Eval {
    Ok(Value::Ray(Rc::new(value)))
}

fn same(_: &mut Machine<'_>, a: &mut [Value], _: At) -> Eval {
    Ok(a[0].clone())
}

fn option(value: Option<Value>) -> Eval {
    Ok(Value::of(value))
}

fn list(values: Vec<Value>) -> Eval {
    Ok(Value::Many(Rc::new(values)))
}

/// The library in its own words: whose functions they are, and of each its signature and
/// what it does. Those of one or two numbers or vectors are named only.
macro_rules! library {
    (
        $(of $of:literal $make:ident $take:ident -> $out:ident { $($one:ident)* ; $($two:ident)* })*
        $($owner:literal { $(fn $name:ident $parameters:tt $(-> $result:ty)? => $run:expr;)* })*
    ) => {
        static LIBRARY: &[(&str, &str, Run)] = &[
            $($((
                $of,
                concat!("fn ", stringify!($one), "(self) -> ", stringify!($out)),
                |_, a, _| $make(a[0].$take().$one()),
            ),)*)*
            $($((
                $of,
                concat!("fn ", stringify!($two), "(self, other: Own) -> ", stringify!($out)),
                |_, a, _| $make(a[0].$take().$two(a[1].$take())),
            ),)*)*
            $($((
                $owner,
                concat!(
                    "fn ",
                    stringify!($name),
                    stringify!($parameters),
                    $("->", stringify!($result))?
                ),
                $run,
            ),)*)*
        ];
    };
}

library! {
    of "f64" float float -> Own {
        sqrt abs floor ceil round trunc fract signum recip exp ln cbrt
        sin cos tan asin acos atan to_radians to_degrees;
        max min powf atan2 hypot copysign
    }
    of "f64" bool float -> bool {
        is_nan is_finite is_infinite is_sign_negative is_sign_positive;
    }
    of "Vec3" vector vec3 -> Own {
        normalize normalize_or_zero abs signum floor ceil round fract recip exp;
        cross min max reflect project_onto
    }
    of "Vec3" float vec3 -> f64 {
        length length_squared length_recip element_sum min_element max_element;
        dot distance distance_squared
    }
    of "Vec3" bool vec3 -> bool { is_nan is_finite is_normalized; }
    of "Ordering" order ordering -> Own { reverse; }
    of "Ordering" bool ordering -> bool { is_lt is_gt; }
    "f64" {
        fn powi(self, n: i32) -> Own => |_, a, _| float(a[0].float().powi(a[1].int() as i32));
        fn clamp(self, least: Own, most: Own) -> Own => |m, a, at| {
            let [x, least, most] = [0, 1, 2].map(|n| a[n].float());
            if least <= most {
                float(x.clamp(least, most))
            } else {
                m.panic(at, "min > max, or either was NaN")
            }
        };
        fn from(value: U) -> Own => |m, a, at| match &a[0] {
            Value::Int(it, _) => float(*it as f64),
            Value::Float(it) => float(*it),
            _ => m.panic(at, "this is no number"),
        };
        fn total_cmp(&self, other: &Own) -> Ordering =>
            |_, a, _| order(a[0].float().total_cmp(&a[1].float()));
        fn partial_cmp(&self, other: &Own) -> Option<Ordering> =>
            |_, a, _| option(a[0].compared(&a[1]).map(Value::Ordering));
    }
    "int" {
        fn max(self, other: Own) -> Own =>
            |_, a, _| Ok(a[usize::from(a[1].int() > a[0].int())].clone());
        fn min(self, other: Own) -> Own =>
            |_, a, _| Ok(a[usize::from(a[1].int() < a[0].int())].clone());
    }
    "bool" {
        fn then_some(self, value: U) -> Option<U> =>
            |_, a, _| option(a[0].truth().then(|| a[1].clone()));
        fn then(self, value: impl FnOnce() -> U) -> Option<U> => |m, a, at| match a[0].truth() {
            true => option(Some(m.apply(&a[1], &mut [], at)?)),
            false => option(None),
        };
    }
    "Vec3" {
        fn new(x: f64, y: f64, z: f64) -> Vec3 =>
            |_, a, _| vector(Vec3::new(a[0].float(), a[1].float(), a[2].float()));
        fn powf(self, n: f64) -> Vec3 => |_, a, _| vector(a[0].vec3().powf(a[1].float()));
        fn splat(value: f64) -> Vec3 => |_, a, _| vector(Vec3::splat(a[0].float()));
        fn lerp(self, other: Vec3, s: f64) -> Vec3 =>
            |_, a, _| vector(a[0].vec3().lerp(a[1].vec3(), a[2].float()));
        fn clamp(self, least: Vec3, most: Vec3) -> Vec3 =>
            |_, a, _| vector(a[0].vec3().max(a[1].vec3()).min(a[2].vec3()));
        fn to_array(&self) -> [f64; 3] =>
            |_, a, _| list(a[0].vec3().to_array().map(Value::Float).to_vec());
        fn from_array(array: [f64; 3]) -> Vec3 => |_, a, _| {
            let all = a[0].many();
            vector(Vec3::new(all[0].float(), all[1].float(), all[2].float()))
        };
    }
    "Ray" {
        fn new(origin: Vec3, direction: Vec3) -> Ray =>
            |_, a, _| ray(Ray::new(a[0].vec3(), a[1].vec3()));
        fn at(&self, t: f64) -> Vec3 => |_, a, _| vector(a[0].ray().at(a[1].float()));
    }
    "Picture" {
        fn paint(width: u32, height: u32, color: impl Fn(u32, u32) -> Vec3) -> Picture =>
            |m, a, _| painted((size(&a[0]), size(&a[1])), Brush::Pixel(m.kept(&a[2])));
    }
    "" {
        fn render(width: u32, color: impl Fn(&Ray) -> Vec3) -> Picture => |m, a, _| {
            let camera = Camera::new(size(&a[0]).max(1));
            let size = (camera.image_width, camera.image_height);
            painted(size, Brush::Ray(camera, m.kept(&a[1])))
        };
        fn sky(ray: &Ray) -> Vec3 => |_, a, _| vector(sky(&a[0].ray()));
    }
    "Option" {
        fn is_some(&self) -> bool => |_, a, _| bool(a[0].option().is_some());
        fn is_none(&self) -> bool => |_, a, _| bool(a[0].option().is_none());
        fn unwrap(self) -> T => |m, a, at| {
            match a[0].option() {
                Some(it) => Ok(it),
                None => m.panic(at, "called `Option::unwrap()` on a `None` value"),
            }
        };
        fn expect(self, message: &str) -> T => |m, a, at| match a[0].option() {
            Some(it) => Ok(it),
            None => m.panic(at, "called `Option::expect()` on a `None` value"),
        };
        fn unwrap_or(self, other: T) -> T =>
            |_, a, _| Ok(a[0].option().unwrap_or_else(|| a[1].clone()));
        fn unwrap_or_else(self, other: impl FnOnce() -> T) -> T => |m, a, at| match a[0].option() {
            Some(it) => Ok(it),
            None => m.apply(&a[1], &mut [], at),
        };
        fn map(self, f: impl FnOnce(T) -> U) -> Option<U> => |m, a, at| match a[0].option() {
            Some(it) => option(Some(m.apply(&a[1], &mut [it], at)?)),
            None => option(None),
        };
        fn map_or(self, other: U, f: impl FnOnce(T) -> U) -> U => |m, a, at| match a[0].option() {
            Some(it) => m.apply(&a[2], &mut [it], at),
            None => Ok(a[1].clone()),
        };
        fn and_then(self, f: impl FnOnce(T) -> Option<U>) -> Option<U> =>
            |m, a, at| match a[0].option() {
                Some(it) => m.apply(&a[1], &mut [it], at),
                None => option(None),
            };
        fn filter(self, f: impl FnOnce(&T) -> bool) -> Option<T> => |m, a, at| match a[0].option() {
            Some(it) if m.asked(&a[1], &mut [it.clone()], at)? => option(Some(it)),
            _ => option(None),
        };
        fn or(self, other: Option<T>) -> Option<T> =>
            |_, a, _| option(a[0].option().or_else(|| a[1].option()));
        fn as_ref(&self) -> Option<&T> => same;
        fn copied(self: Option<&U>) -> Option<U> => same;
        fn cloned(self: Option<&U>) -> Option<U> => same;
    }
    "Box" {
        fn new(value: T) -> Own => same;
        fn as_ref(&self) -> &T => same;
        fn clone(&self) -> Own => same;
    }
    "Vec" {
        fn new() -> Vec<T> => |_, _, _| list(Vec::new());
        fn push(&mut self, value: T) => |m, a, _| {
            let value = std::mem::take(&mut a[1]);
            m.change_at(&a[0], |list| match list {
                Value::Many(all) => Rc::make_mut(all).push(value),
                other => unreachable!("types are checked, and {other:?} is no list"),
            });
            Ok(Value::Unit)
        };
    }
    "list" {
        fn len(&self) -> usize => |_, a, _| Ok(Value::usize(a[0].many().len()));
        fn is_empty(&self) -> bool => |_, a, _| bool(a[0].many().is_empty());
        fn first(&self) -> Option<&T> => |_, a, _| option(a[0].many().first().cloned());
        fn last(&self) -> Option<&T> => |_, a, _| option(a[0].many().last().cloned());
        fn iter(&self) -> Iterator<&T> => same;
        fn into_iter(self) -> Iterator<T> => same;
    }
    "array" {
        fn map(self, f: impl FnMut(T) -> U) -> Vec<U> => |m, a, at| {
            adapted(m, &a[0], at, |m, it| Ok(Some(m.apply(&a[1], &mut [it], at)?)))
        };
    }
    "str" {
        fn new() -> String => |_, _, _| text(String::new());
        fn with_capacity(n: usize) -> String => |_, _, _| text(String::new());
        fn from(value: &str) -> String => same;
        fn to_string(&self) -> String => same;
        fn to_owned(&self) -> String => same;
        fn as_str(&self) -> &str => same;
        fn push_str(&mut self, more: &str) => |m, a, _| {
            let more = a[1].text();
            m.change_at(&a[0], |text| match text {
                Value::Str(text) => Rc::make_mut(text).push_str(&more),
                other => unreachable!("types are checked, and {other:?} is no text"),
            });
            Ok(Value::Unit)
        };
    }
    "Range" {
        fn contains(&self, value: &T) -> bool => |_, a, _| {
            let Value::Range(ends, is_closed) = &a[0] else {
                unreachable!("types are checked");
            };
            let is_before = |it: Ordering| it.is_lt() || *is_closed && it.is_eq();
            let is_after = ends[0].compared(&a[1]).is_some_and(Ordering::is_le);
            bool(is_after && a[1].compared(&ends[1]).is_some_and(is_before))
        };
    }
    "Iterator" {
        fn into_iter(self) -> Iterator<T> => same;
        fn map(self, f: impl FnMut(T) -> U) -> Iterator<U> => |m, a, at| {
            let f = a[1].clone();
            adapted(m, &a[0], at, move |m, it| {
                Ok(Some(m.apply(&f, &mut [it], at)?))
            })
        };
        fn filter(self, f: impl FnMut(&T) -> bool) -> Iterator<T> => |m, a, at| {
            let f = a[1].clone();
            adapted(m, &a[0], at, move |m, it| {
                Ok(m.asked(&f, &mut [it.clone()], at)?.then_some(it))
            })
        };
        fn filter_map(self, f: impl FnMut(T) -> Option<U>) -> Iterator<U> => |m, a, at| {
            let f = a[1].clone();
            adapted(m, &a[0], at, move |m, it| m.chosen(&f, &mut [it], at))
        };
        fn enumerate(self) -> Iterator<(usize, T)> => |m, a, at| {
            let mut n = -1;
            adapted(m, &a[0], at, move |_, it| {
                n += 1;
                Ok(Some(Value::Tuple([Value::Int(n, Int::Usize), it].into())))
            })
        };
        fn rev(self) -> Iterator<T> => |m, a, at| {
            let mut all = rest(m, &a[0], at)?;
            all.reverse();
            list(all)
        };
        fn copied(self: Iterator<&U>) -> Iterator<U> => same;
        fn cloned(self: Iterator<&U>) -> Iterator<U> => same;
        fn find(self, f: impl FnMut(&T) -> bool) -> Option<T> =>
            |m, a, at| option(found(m, a, at, true)?);
        fn any(self, f: impl FnMut(T) -> bool) -> bool =>
            |m, a, at| bool(found(m, a, at, true)?.is_some());
        fn all(self, f: impl FnMut(T) -> bool) -> bool =>
            |m, a, at| bool(found(m, a, at, false)?.is_none());
        fn fold(self, start: U, f: impl FnMut(U, T) -> U) -> U => |m, a, at| {
            let mut sum = a[1].clone();
            for value in rest(m, &a[0], at)? {
                sum = m.apply(&a[2], &mut [sum, value], at)?;
            }
            Ok(sum)
        };
        fn min_by(self, f: impl FnMut(&T, &T) -> Ordering) -> Option<T> =>
            |m, a, at| least(m, a, at);
        fn collect(self) -> Vec<T> => |m, a, at| list(rest(m, &a[0], at)?);
    }
    "any" {
        fn clone(&self) -> Own => same;
    }
}

/// The picture that a text has printed as a P3 file.
pub(crate) fn printed(text: &str) -> Option<Picture> {
    let mut words = text
        .strip_prefix("P3")?
        .split_whitespace()
        .map(str::parse::<u32>);
    let [width, height, most] = [(); 3].map(|()| words.next().and_then(Result::ok));
    let levels = words.map(|it| u8::try_from(it.ok()?).ok());
    most.filter(|&it| it == 255)?;
    Picture::from_rgb(width?, height?, levels.collect::<Option<_>>()?)
}

/// The names and the types of what a type of the library has.
pub(crate) fn fields(head: Head) -> impl Iterator<Item = (&'static str, Type)> {
    let all: &'static [(&str, Head)] = match head {
        Head::Vec3 => &[("x", Head::F64), ("y", Head::F64), ("z", Head::F64)],
        Head::Ray => &[("origin", Head::Vec3), ("direction", Head::Vec3)],
        _ => &[],
    };
    all.iter().map(|&(name, head)| (name, head.into()))
}

/// A constant of `f64`.
pub(crate) fn number(name: &str) -> Option<f64> {
    Some(match name {
        "INFINITY" => f64::INFINITY,
        "NEG_INFINITY" => f64::NEG_INFINITY,
        "MAX" => f64::MAX,
        "EPSILON" => f64::EPSILON,
        "NAN" => f64::NAN,
        _ => return None,
    })
}

/// A constant of a type of the library.
pub(crate) fn constant(owner: &Type, name: &str) -> Option<(Node, Type)> {
    let node = match (owner.0, name) {
        (Head::Vec3, name) => Node::Vec3(match name {
            "ZERO" => Vec3::ZERO,
            "ONE" => Vec3::ONE,
            "X" => Vec3::X,
            "Y" => Vec3::Y,
            "Z" => Vec3::Z,
            "NEG_Z" => Vec3::NEG_Z,
            _ => return None,
        }),
        (Head::F64, name) => Node::Float(number(name)?),
        (Head::Int(int), "MAX") => Node::Int(int.ends().1, int),
        (Head::Int(int), "MIN") => Node::Int(int.ends().0, int),
        _ => return None,
    };
    Some((node, owner.clone()))
}
