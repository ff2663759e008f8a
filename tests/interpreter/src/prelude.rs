//! The library: each function of Rust and of our prelude that a chapter or its reader may
//! call, with its signature as Rust has it.
//!
//! Iterators are lazy, as in Rust: each is a closure that gives the next value.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::LazyLock;

use common::rtweekend::{Camera, Picture, Ray, Vec3, sky, write_color};

use crate::Place;
use crate::items::{Context, Items, Signature};
use crate::run::{Eval, Iter, Machine, Value, panic};
use crate::types::{Head, Type};

/// A function of the library.
pub(crate) struct Native {
    /// Which types have it.
    pub(crate) owner: &'static str,
    pub(crate) signature: Signature,
    run: Run,
}

type Run = fn(&mut Machine, &mut [Value], &Place) -> Eval;

/// Type parameters of the signatures: `T` is what a list, an option or an iterator is of.
const PARAMETERS: [&str; 3] = ["T", "U", "Own"];

/// The library, in the order of the list below.
pub(crate) static NATIVES: LazyLock<Vec<Native>> = LazyLock::new(|| {
    let items = Items::library();
    let of = |(n, name): (usize, &&str)| ((*name).to_owned(), Type::plain(Head::Param(n)));
    let context = Context {
        own: Some(Type::plain(Head::Param(2))),
        parameters: HashMap::from_iter(PARAMETERS.iter().enumerate().map(of)),
        ..Context::default()
    };
    let read = |&(owner, signature, run): &(&'static str, &str, Run)| {
        let tree = syn::parse_str(signature).expect("it is Rust");
        let signature = items
            .read_signature(&context, &tree)
            .expect("its types are known");
        Native {
            owner,
            signature,
            run,
        }
    };
    LIBRARY.iter().map(read).collect()
});

/// Where the type's functions are in the list. What a list has a vector has, too.
pub(crate) fn owners(ty: &Type) -> &'static [&'static str] {
    match ty.head() {
        Some(Head::F64 | Head::F32) => &["f64", "any"],
        Some(Head::Int(_)) => &["int", "any"],
        Some(Head::Bool) => &["bool", "any"],
        Some(Head::Vec3) => &["Vec3", "any"],
        Some(Head::Ray) => &["Ray", "any"],
        Some(Head::Camera) => &["Camera", "any"],
        Some(Head::Picture) => &["Picture"],
        Some(Head::Ordering) => &["Ordering", "any"],
        Some(Head::Option) => &["Option", "any"],
        Some(Head::Box) => &["Box"],
        Some(Head::Vec) => &["Vec", "list", "any"],
        Some(Head::Array(_)) => &["array", "list", "any"],
        Some(Head::Slice) => &["list"],
        Some(Head::Range) => &["Range", "Iterator"],
        Some(Head::Iterator) => &["Iterator"],
        _ => &["any"],
    }
}

/// The number of a function of the library.
pub(crate) fn native(owner: &str, name: &str) -> Option<usize> {
    let mut all = NATIVES.iter();
    all.position(|it| it.owner == owner && it.signature.name == name)
}

pub(crate) fn run(
    native: usize,
    machine: &mut Machine,
    arguments: &mut [Value],
    at: &Place,
) -> Eval {
    (NATIVES[native].run)(machine, arguments, at)
}

/// What gives the values of a list, a range or an option, one after the other.
pub(crate) fn iterator(of: &Value) -> Iter {
    let made = match of {
        Value::Iterator(it) => return it.clone(),
        Value::Many(all) => each(all.to_vec()),
        Value::Range(ends, is_closed) => {
            let mut next = ends[0].int();
            let end = match &ends[1] {
                Value::Unit => i128::MAX,
                end => end.int() + i128::from(*is_closed),
            };
            Iter::giving(move |_| {
                let is_there = next < end;
                next += i128::from(is_there);
                Ok(is_there.then(|| Value::Int(next - 1)))
            })
        }
        other => each(other.option().into_iter().collect()),
    };
    made.iterator()
}

fn each(values: Vec<Value>) -> Value {
    let mut values = values.into_iter();
    Iter::giving(move |_| Ok(values.next()))
}

fn rest(machine: &mut Machine, of: &Value) -> Eval<Vec<Value>> {
    let iterator = iterator(of);
    let mut all = Vec::new();
    while let Some(value) = iterator.next(machine)? {
        // More than a chapter has pixels is no list of a chapter.
        if all.len() == 1_000_000 {
            return panic(&Place::default(), "a list without end");
        }
        all.push(value);
    }
    Ok(all)
}

/// An iterator that does something with each value of another, and gives some of the results.
fn adapted(
    of: &Value,
    mut change: impl FnMut(&mut Machine, Value) -> Eval<Option<Value>> + 'static,
) -> Value {
    let iterator = iterator(of);
    Iter::giving(move |machine| {
        while let Some(value) = iterator.next(machine)? {
            if let Some(changed) = change(machine, value)? {
                return Ok(Some(changed));
            }
        }
        Ok(None)
    })
}

/// The first value of which the function says yes.
fn found(
    machine: &mut Machine,
    a: &[Value],
    says_yes: impl Fn(&Value) -> bool,
) -> Eval<Option<(usize, Value, Value)>> {
    let iterator = iterator(&a[0]);
    let mut n = 0;
    while let Some(value) = iterator.next(machine)? {
        let said = machine.apply(&a[1], &mut [value.clone()])?;
        if says_yes(&said) {
            return Ok(Some((n, value, said)));
        }
        n += 1;
    }
    Ok(None)
}

/// The extreme value: of equal ones the first least or the last greatest, as in Rust.
fn extreme(
    machine: &mut Machine,
    of: &Value,
    is_least: bool,
    mut compare: impl FnMut(&mut Machine, &Value, &Value) -> Eval<Ordering>,
) -> Eval {
    let mut best: Option<Value> = None;
    for value in rest(machine, of)? {
        let is_better = match &best {
            None => true,
            Some(best) => match compare(machine, best, &value)? {
                Ordering::Less => !is_least,
                Ordering::Equal => !is_least,
                Ordering::Greater => is_least,
            },
        };
        if is_better {
            best = Some(value);
        }
    }
    Ok(Value::of(best))
}

fn of_order(machine: &mut Machine, function: &Value, one: &Value, other: &Value) -> Eval<Ordering> {
    Ok(machine
        .apply(function, &mut [one.clone(), other.clone()])?
        .ordering())
}

fn of_keys(machine: &mut Machine, function: &Value, one: &Value, other: &Value) -> Eval<Ordering> {
    let one = machine.apply(function, &mut [one.clone()])?;
    let other = machine.apply(function, &mut [other.clone()])?;
    Ok(one.compared(&other).unwrap_or(Ordering::Equal))
}

/// The sum or the product of all.
fn folded(machine: &mut Machine, of: &Value, start: f64, join: fn(Value, Value) -> Value) -> Eval {
    let all = rest(machine, of)?;
    let start = match all.first() {
        Some(Value::Int(_)) => Value::Int(start as i128),
        Some(Value::Vec3(_)) => Value::Vec3(Vec3::splat(start)),
        _ => Value::Float(start),
    };
    Ok(all.into_iter().fold(start, join))
}

fn plus(one: Value, other: Value) -> Value {
    match (one, other) {
        (Value::Int(a), Value::Int(b)) => Value::Int(a + b),
        (Value::Vec3(a), Value::Vec3(b)) => Value::Vec3(a + b),
        (a, b) => Value::Float(a.float() + b.float()),
    }
}

fn times(one: Value, other: Value) -> Value {
    match (one, other) {
        (Value::Int(a), Value::Int(b)) => Value::Int(a * b),
        (a, b) => Value::Float(a.float() * b.float()),
    }
}

/// A picture whose pixels a function colors.
fn painted(
    machine: &mut Machine,
    (width, height): (u32, u32),
    mut color: impl FnMut(&mut Machine, u32, u32) -> Eval,
) -> Eval {
    if let Some(sample) = machine.sample.clone() {
        machine.matched = 0;
        for (at, right) in sample.iter() {
            machine.begin();
            let mut pixel = [0; 3];
            write_color(&mut pixel, color(machine, at % width, at / width)?.vec3());
            if width * height <= *at || pixel != *right {
                break;
            }
            machine.matched += 1;
        }
        return Ok(Value::Picture(Rc::new((width, height, Vec::new()))));
    }
    let mut rgb = Vec::with_capacity(3 * width as usize * height as usize);
    for j in 0..height {
        for i in 0..width {
            machine.begin();
            let mut pixel = [0; 3];
            write_color(&mut pixel, color(machine, i, j)?.vec3());
            rgb.extend(pixel);
        }
    }
    Ok(Value::Picture(Rc::new((width, height, rgb))))
}

/// The widest picture that is drawn here.
const WIDEST: i128 = 4096;

fn width(value: &Value, at: &Place) -> Eval<u32> {
    match value.int() {
        it @ 1..=WIDEST => Ok(it as u32),
        _ => panic(
            at,
            &format!("a picture here is 1 to {WIDEST} pixels wide and high"),
        ),
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

fn int(value: i128) -> Eval {
    Ok(Value::Int(value))
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
        $(of $of:literal $make:ident $take:ident { $($one:ident)* ; $($two:ident)* })*
        $($owner:literal { $(fn $name:ident $parameters:tt $(-> $result:ty)? => $run:expr;)* })*
    ) => {
        static LIBRARY: &[(&str, &str, Run)] = &[
            $($(($of, concat!("fn ", stringify!($one), "(self) -> Own"), |_, a, _| $make(a[0].$take().$one())),)*)*
            $($((
                $of,
                concat!("fn ", stringify!($two), "(self, other: Own) -> Own"),
                |_, a, _| $make(a[0].$take().$two(a[1].$take())),
            ),)*)*
            $($((
                $owner,
                concat!("fn ", stringify!($name), stringify!($parameters), $("->", stringify!($result))?),
                $run,
            ),)*)*
        ];
    };
}

library! {
    of "f64" float float {
        sqrt abs floor ceil round trunc fract signum recip exp exp2 ln log10 log2 cbrt
        sin cos tan asin acos atan sinh cosh tanh to_radians to_degrees;
        max min powf atan2 hypot copysign rem_euclid div_euclid log
    }
    of "Vec3" vector vec3 {
        normalize normalize_or_zero abs signum floor ceil round fract recip exp;
        cross min max reflect project_onto
    }
    "f64" {
        fn powi(self, n: i32) -> Own => |_, a, _| float(a[0].float().powi(a[1].int() as i32));
        fn clamp(self, least: Own, most: Own) -> Own => |_, a, at| {
            let [x, least, most] = [0, 1, 2].map(|n| a[n].float());
            match least <= most {
                true => float(x.clamp(least, most)),
                false => panic(
                    at,
                    &format!("min > max, or either was NaN. min = {least:?}, max = {most:?}"),
                ),
            }
        };
        fn mul_add(self, a: Own, b: Own) -> Own => |_, a, _| float(a[0].float().mul_add(a[1].float(), a[2].float()));
        fn from(value: U) -> Own => |_, a, at| match &a[0] {
            Value::Int(it) => float(*it as f64),
            Value::Float(it) => float(*it),
            _ => panic(at, "this is no number"),
        };
        fn is_nan(self) -> bool => |_, a, _| bool(a[0].float().is_nan());
        fn is_finite(self) -> bool => |_, a, _| bool(a[0].float().is_finite());
        fn is_infinite(self) -> bool => |_, a, _| bool(a[0].float().is_infinite());
        fn is_sign_negative(self) -> bool => |_, a, _| bool(a[0].float().is_sign_negative());
        fn is_sign_positive(self) -> bool => |_, a, _| bool(a[0].float().is_sign_positive());
        fn total_cmp(&self, other: &Own) -> Ordering =>
            |_, a, _| Ok(Value::Ordering(a[0].float().total_cmp(&a[1].float())));
        fn partial_cmp(&self, other: &Own) -> Option<Ordering> =>
            |_, a, _| option(a[0].compared(&a[1]).map(Value::Ordering));
    }
    "int" {
        fn abs(self) -> Own => |_, a, _| int(a[0].int().abs());
        fn pow(self, n: u32) -> Own => |_, a, at| {
            match a[0].int().checked_pow(a[1].int() as u32) {
                Some(it) => int(it),
                None => panic(at, "attempt to multiply with overflow"),
            }
        };
        fn max(self, other: Own) -> Own => |_, a, _| int(a[0].int().max(a[1].int()));
        fn min(self, other: Own) -> Own => |_, a, _| int(a[0].int().min(a[1].int()));
        fn signum(self) -> Own => |_, a, _| int(a[0].int().signum());
        fn rem_euclid(self, other: Own) -> Own => |_, a, at| match a[1].int() {
            0 => panic(
                at,
                "attempt to calculate the remainder with a divisor of zero",
            ),
            other => int(a[0].int().rem_euclid(other)),
        };
        fn cmp(&self, other: &Own) -> Ordering => |_, a, _| Ok(Value::Ordering(a[0].int().cmp(&a[1].int())));
        fn partial_cmp(&self, other: &Own) -> Option<Ordering> =>
            |_, a, _| option(a[0].compared(&a[1]).map(Value::Ordering));
    }
    "bool" {
        fn then_some(self, value: U) -> Option<U> => |_, a, _| option(a[0].truth().then(|| a[1].clone()));
        fn then(self, value: impl FnOnce() -> U) -> Option<U> => |m, a, _| match a[0].truth() {
            true => option(Some(m.apply(&a[1], &mut [])?)),
            false => option(None),
        };
    }
    "Vec3" {
        fn new(x: f64, y: f64, z: f64) -> Vec3 =>
            |_, a, _| vector(Vec3::new(a[0].float(), a[1].float(), a[2].float()));
        fn powf(self, n: f64) -> Vec3 => |_, a, _| vector(a[0].vec3().powf(a[1].float()));
        fn splat(value: f64) -> Vec3 => |_, a, _| vector(Vec3::splat(a[0].float()));
        fn dot(self, other: Vec3) -> f64 => |_, a, _| float(a[0].vec3().dot(a[1].vec3()));
        fn length(self) -> f64 => |_, a, _| float(a[0].vec3().length());
        fn length_squared(self) -> f64 => |_, a, _| float(a[0].vec3().length_squared());
        fn length_recip(self) -> f64 => |_, a, _| float(a[0].vec3().length_recip());
        fn distance(self, other: Vec3) -> f64 => |_, a, _| float(a[0].vec3().distance(a[1].vec3()));
        fn distance_squared(self, other: Vec3) -> f64 => |_, a, _| float(a[0].vec3().distance_squared(a[1].vec3()));
        fn element_sum(self) -> f64 => |_, a, _| float(a[0].vec3().element_sum());
        fn min_element(self) -> f64 => |_, a, _| float(a[0].vec3().min_element());
        fn max_element(self) -> f64 => |_, a, _| float(a[0].vec3().max_element());
        fn lerp(self, other: Vec3, s: f64) -> Vec3 => |_, a, _| vector(a[0].vec3().lerp(a[1].vec3(), a[2].float()));
        fn clamp(self, least: Vec3, most: Vec3) -> Vec3 =>
            |_, a, _| vector(a[0].vec3().max(a[1].vec3()).min(a[2].vec3()));
        fn mul_add(self, a: Vec3, b: Vec3) -> Vec3 => |_, a, _| vector(a[0].vec3().mul_add(a[1].vec3(), a[2].vec3()));
        fn is_nan(self) -> bool => |_, a, _| bool(a[0].vec3().is_nan());
        fn is_finite(self) -> bool => |_, a, _| bool(a[0].vec3().is_finite());
        fn is_normalized(self) -> bool => |_, a, _| bool(a[0].vec3().is_normalized());
        fn to_array(&self) -> [f64; 3] => |_, a, _| list(a[0].vec3().to_array().map(Value::Float).to_vec());
        fn from_array(array: [f64; 3]) -> Vec3 => |_, a, _| {
            let all = a[0].many();
            vector(Vec3::new(all[0].float(), all[1].float(), all[2].float()))
        };
    }
    "Ray" {
        fn new(origin: Vec3, direction: Vec3) -> Ray =>
            |_, a, _| Ok(Value::Ray(Rc::new(Ray::new(a[0].vec3(), a[1].vec3()))));
        fn at(&self, t: f64) -> Vec3 => |_, a, _| vector(a[0].ray().at(a[1].float()));
    }
    "Camera" {
        fn new(image_width: u32) -> Camera => |_, a, at| Ok(Value::Camera(Rc::new(Camera::new(width(&a[0], at)?))));
        fn with_size(image_width: u32, image_height: u32) -> Camera =>
            |_, a, at| Ok(Value::Camera(Rc::new(Camera::with_size(width(&a[0], at)?, width(&a[1], at)?))));
        fn ray(&self, i: u32, j: u32) -> Ray =>
            |_, a, _| Ok(Value::Ray(Rc::new(a[0].camera().ray(a[1].int() as u32, a[2].int() as u32))));
    }
    "Picture" {
        fn paint(width: u32, height: u32, color_at: impl Fn(u32, u32) -> Vec3) -> Picture => |m, a, at| {
            let size = (width(&a[0], at)?, width(&a[1], at)?);
            let color = a[2].clone();
            painted(m, size, |m, i, j| {
                m.apply(&color, &mut [Value::Int(i.into()), Value::Int(j.into())])
            })
        };
    }
    "" {
        fn render(width: u32, color: impl Fn(&Ray) -> Vec3) -> Picture => |m, a, at| {
            let camera = Camera::new(width(&a[0], at)?);
            let color = a[1].clone();
            painted(m, (camera.image_width, camera.image_height), |m, i, j| {
                m.apply(&color, &mut [Value::Ray(Rc::new(camera.ray(i, j)))])
            })
        };
        fn sky(ray: &Ray) -> Vec3 => |_, a, _| vector(sky(&a[0].ray()));
    }
    "Ordering" {
        fn reverse(self) -> Ordering => |_, a, _| Ok(Value::Ordering(a[0].ordering().reverse()));
        fn is_lt(self) -> bool => |_, a, _| bool(a[0].ordering().is_lt());
        fn is_gt(self) -> bool => |_, a, _| bool(a[0].ordering().is_gt());
    }
    "Option" {
        fn is_some(&self) -> bool => |_, a, _| bool(a[0].option().is_some());
        fn is_none(&self) -> bool => |_, a, _| bool(a[0].option().is_none());
        fn unwrap(self) -> T => |_, a, at| {
            match a[0].option() {
                Some(it) => Ok(it),
                None => panic(at, "called `Option::unwrap()` on a `None` value"),
            }
        };
        fn expect(self, message: &str) -> T => |_, a, at| match a[0].option() {
            Some(it) => Ok(it),
            None => panic(at, "called `Option::expect()` on a `None` value"),
        };
        fn unwrap_or(self, other: T) -> T => |_, a, _| Ok(a[0].option().unwrap_or_else(|| a[1].clone()));
        fn unwrap_or_else(self, other: impl FnOnce() -> T) -> T => |m, a, _| match a[0].option() {
            Some(it) => Ok(it),
            None => m.apply(&a[1], &mut []),
        };
        fn map(self, f: impl FnOnce(T) -> U) -> Option<U> => |m, a, _| match a[0].option() {
            Some(it) => option(Some(m.apply(&a[1], &mut [it])?)),
            None => option(None),
        };
        fn map_or(self, other: U, f: impl FnOnce(T) -> U) -> U => |m, a, _| match a[0].option() {
            Some(it) => m.apply(&a[2], &mut [it]),
            None => Ok(a[1].clone()),
        };
        fn map_or_else(self, other: impl FnOnce() -> U, f: impl FnOnce(T) -> U) -> U => |m, a, _| match a[0].option() {
            Some(it) => m.apply(&a[2], &mut [it]),
            None => m.apply(&a[1], &mut []),
        };
        fn and_then(self, f: impl FnOnce(T) -> Option<U>) -> Option<U> => |m, a, _| match a[0].option() {
            Some(it) => m.apply(&a[1], &mut [it]),
            None => option(None),
        };
        fn filter(self, f: impl FnOnce(&T) -> bool) -> Option<T> => |m, a, _| match a[0].option() {
            Some(it) if m.apply(&a[1], &mut [it.clone()])?.truth() => option(Some(it)),
            _ => option(None),
        };
        fn is_some_and(self, f: impl FnOnce(T) -> bool) -> bool => |m, a, _| match a[0].option() {
            Some(it) => m.apply(&a[1], &mut [it]),
            None => bool(false),
        };
        fn is_none_or(self, f: impl FnOnce(T) -> bool) -> bool => |m, a, _| match a[0].option() {
            Some(it) => m.apply(&a[1], &mut [it]),
            None => bool(true),
        };
        fn or(self, other: Option<T>) -> Option<T> => |_, a, _| option(a[0].option().or_else(|| a[1].option()));
        fn or_else(self, other: impl FnOnce() -> Option<T>) -> Option<T> => |m, a, _| match a[0].option() {
            Some(it) => option(Some(it)),
            None => m.apply(&a[1], &mut []),
        };
        fn and(self, other: Option<U>) -> Option<U> => |_, a, _| option(a[0].option().and_then(|_| a[1].option()));
        fn xor(self, other: Option<T>) -> Option<T> => |_, a, _| option(a[0].option().xor(a[1].option()));
        fn as_ref(&self) -> Option<&T> => |_, a, _| Ok(a[0].clone());
        fn take(&mut self) -> Option<T> =>
            |m, a, _| Ok(m.change_at(&a[0], |place| std::mem::replace(place, Value::None)));
        fn replace(&mut self, value: T) -> Option<T> => |m, a, _| {
            let new = Value::of(Some(a[1].clone()));
            Ok(m.change_at(&a[0], |place| std::mem::replace(place, new)))
        };
        fn insert(&mut self, value: T) -> T => |m, a, _| {
            let new = a[1].clone();
            m.change_at(&a[0], |place| *place = Value::of(Some(new)));
            Ok(a[1].clone())
        };
        fn copied(self: Option<&U>) -> Option<U> => |_, a, _| Ok(a[0].clone());
        fn cloned(self: Option<&U>) -> Option<U> => |_, a, _| Ok(a[0].clone());
        fn iter(&self) -> Iterator<&T> => |_, a, _| Ok(Value::Iterator(iterator(&a[0])));
        fn into_iter(self) -> Iterator<T> => |_, a, _| Ok(Value::Iterator(iterator(&a[0])));
    }
    "Box" {
        fn new(value: T) -> Own => |_, a, _| Ok(a[0].clone());
        fn as_ref(&self) -> &T => |_, a, _| Ok(a[0].clone());
        fn clone(&self) -> Own => |_, a, _| Ok(a[0].clone());
    }
    "Vec" {
        fn new() -> Vec<T> => |_, _, _| list(Vec::new());
        fn with_capacity(n: usize) -> Vec<T> => |_, _, _| list(Vec::new());
        fn push(&mut self, value: T) => |m, a, _| {
            let value = std::mem::take(&mut a[1]);
            Ok(m.change_at(&a[0], |list| changed(list, |all| all.push(value))))
        };
        fn pop(&mut self) -> Option<T> => |m, a, _| {
            let mut last = None;
            m.change_at(&a[0], |list| changed(list, |all| last = all.pop()));
            option(last)
        };
        fn clear(&mut self) => |m, a, _| Ok(m.change_at(&a[0], |list| changed(list, Vec::clear)));
        fn extend(&mut self, more: Iterator<T>) => |m, a, _| {
            let more = rest(m, &a[1])?;
            Ok(m.change_at(&a[0], |list| changed(list, |all| all.extend(more))))
        };
    }
    "list" {
        fn reverse(&mut self) => |m, a, _| Ok(m.change_at(&a[0], |list| changed(list, |all| all.reverse())));
        fn swap(&mut self, i: usize, j: usize) => |m, a, at| {
            let [i, j] = [1, 2].map(|n| a[n].int() as usize);
            let length = m.followed(&a[0]).many().len();
            match i < length && j < length {
                true => Ok(m.change_at(&a[0], |list| changed(list, |all| all.swap(i, j)))),
                false => panic(
                    at,
                    &format!(
                        "index out of bounds: the len is {length} but the index is {}",
                        i.max(j)
                    ),
                ),
            }
        };
        fn sort_by(&mut self, f: impl FnMut(&T, &T) -> Ordering) => |m, a, _| {
            let mut sorted: Vec<Value> = Vec::new();
            for value in m.followed(&a[0]).many().iter() {
                let mut place = sorted.len();
                while place > 0 && of_order(m, &a[1], &sorted[place - 1], value)?.is_gt() {
                    place -= 1;
                }
                sorted.insert(place, value.clone());
            }
            Ok(m.change_at(&a[0], |list| changed(list, |all| *all = sorted)))
        };
        fn len(&self) -> usize => |_, a, _| int(a[0].many().len() as i128);
        fn is_empty(&self) -> bool => |_, a, _| bool(a[0].many().is_empty());
        fn first(&self) -> Option<&T> => |_, a, _| option(a[0].many().first().cloned());
        fn last(&self) -> Option<&T> => |_, a, _| option(a[0].many().last().cloned());
        fn get(&self, n: usize) -> Option<&T> => |_, a, _| option(a[0].many().get(a[1].int() as usize).cloned());
        fn contains(&self, value: &T) -> bool => |_, a, _| bool(a[0].many().iter().any(|it| it.equals(&a[1])));
        fn iter(&self) -> Iterator<&T> => |_, a, _| Ok(Value::Iterator(iterator(&a[0])));
        fn iter_mut(&mut self) -> Iterator<&mut T> => |m, a, _| Ok(each(m.each_at(&a[0])));
        fn into_iter(self) -> Iterator<T> => |_, a, _| Ok(Value::Iterator(iterator(&a[0])));
        fn to_vec(&self) -> Vec<T> => |_, a, _| Ok(a[0].clone());
    }
    "array" {
        fn map(self, f: impl FnMut(T) -> U) -> Vec<U> => |m, a, _| {
            let all = a[0]
                .many()
                .iter()
                .map(|it| m.apply(&a[1], &mut [it.clone()]))
                .collect::<Eval<_>>()?;
            list(all)
        };
    }
    "Range" {
        fn contains(&self, value: &T) -> bool => |_, a, _| {
            let Value::Range(ends, is_closed) = &a[0] else {
                unreachable!("types are checked");
            };
            let is_before = |it: Ordering| it.is_lt() || *is_closed && it.is_eq();
            let is_after = matches!(ends[0], Value::Unit)
                || ends[0].compared(&a[1]).is_some_and(Ordering::is_le);
            bool(
                is_after
                    && (matches!(ends[1], Value::Unit)
                        || a[1].compared(&ends[1]).is_some_and(is_before)),
            )
        };
    }
    "Iterator" {
        fn iter(self) -> Iterator<T> => |_, a, _| Ok(Value::Iterator(iterator(&a[0])));
        fn into_iter(self) -> Iterator<T> => |_, a, _| Ok(Value::Iterator(iterator(&a[0])));
        fn next(&self) -> Option<T> => |m, a, _| {
            let next = iterator(&a[0]).next(m)?;
            option(next)
        };
        fn map(self, f: impl FnMut(T) -> U) -> Iterator<U> => |_, a, _| {
            let f = a[1].clone();
            Ok(adapted(&a[0], move |m, it| {
                Ok(Some(m.apply(&f, &mut [it])?))
            }))
        };
        fn filter(self, f: impl FnMut(&T) -> bool) -> Iterator<T> => |_, a, _| {
            let f = a[1].clone();
            Ok(adapted(&a[0], move |m, it| {
                Ok(m.apply(&f, &mut [it.clone()])?.truth().then_some(it))
            }))
        };
        fn filter_map(self, f: impl FnMut(T) -> Option<U>) -> Iterator<U> => |_, a, _| {
            let f = a[1].clone();
            Ok(adapted(&a[0], move |m, it| {
                Ok(m.apply(&f, &mut [it])?.option())
            }))
        };
        fn flat_map(self, f: impl FnMut(T) -> Option<U>) -> Iterator<U> => |_, a, _| {
            let f = a[1].clone();
            Ok(adapted(&a[0], move |m, it| {
                Ok(m.apply(&f, &mut [it])?.option())
            }))
        };
        fn flatten(self: Iterator<Option<U>>) -> Iterator<U> => |_, a, _| Ok(adapted(&a[0], |_, it| Ok(it.option())));
        fn take_while(self, f: impl FnMut(&T) -> bool) -> Iterator<T> => |_, a, _| {
            let (iterator, f) = (iterator(&a[0]), a[1].clone());
            let mut is_over = false;
            Ok(Iter::giving(move |m| {
                let next = if is_over { None } else { iterator.next(m)? };
                let Some(it) = next else { return Ok(None) };
                is_over = !m.apply(&f, &mut [it.clone()])?.truth();
                Ok((!is_over).then_some(it))
            }))
        };
        fn skip_while(self, f: impl FnMut(&T) -> bool) -> Iterator<T> => |_, a, _| {
            let f = a[1].clone();
            let mut has_begun = false;
            Ok(adapted(&a[0], move |m, it| {
                has_begun = has_begun || !m.apply(&f, &mut [it.clone()])?.truth();
                Ok(has_begun.then_some(it))
            }))
        };
        fn take(self, n: usize) -> Iterator<T> => |_, a, _| {
            let (iterator, mut left) = (iterator(&a[0]), a[1].int());
            Ok(Iter::giving(move |m| {
                left -= 1;
                if left < 0 { Ok(None) } else { iterator.next(m) }
            }))
        };
        fn skip(self, n: usize) -> Iterator<T> => |_, a, _| {
            let mut left = a[1].int();
            Ok(adapted(&a[0], move |_, it| {
                left -= 1;
                Ok((left < 0).then_some(it))
            }))
        };
        fn step_by(self, n: usize) -> Iterator<T> => |_, a, at| {
            let (step, mut n) = (a[1].int(), -1);
            if step == 0 {
                return panic(at, "assertion failed: step != 0");
            }
            Ok(adapted(&a[0], move |_, it| {
                n += 1;
                Ok((n % step == 0).then_some(it))
            }))
        };
        fn enumerate(self) -> Iterator<(usize, T)> => |_, a, _| {
            let mut n = -1;
            Ok(adapted(&a[0], move |_, it| {
                n += 1;
                Ok(Some(Value::Many(Rc::new(vec![Value::Int(n), it]))))
            }))
        };
        fn rev(self) -> Iterator<T> => |m, a, _| {
            let mut all = rest(m, &a[0])?;
            all.reverse();
            Ok(each(all))
        };
        fn chain(self, more: Iterator<T>) -> Iterator<T> => |_, a, _| {
            let both = [iterator(&a[0]), iterator(&a[1])];
            Ok(Iter::giving(move |m| match both[0].next(m)? {
                Some(it) => Ok(Some(it)),
                None => both[1].next(m),
            }))
        };
        fn zip(self, other: Iterator<U>) -> Iterator<(T, U)> => |_, a, _| {
            let other = iterator(&a[1]);
            let is_over = RefCell::new(false);
            let first = iterator(&a[0]);
            Ok(Iter::giving(move |m| {
                if *is_over.borrow() {
                    return Ok(None);
                }
                let both = match first.next(m)? {
                    Some(one) => other.next(m)?.map(|other| vec![one, other]),
                    None => None,
                };
                *is_over.borrow_mut() = both.is_none();
                Ok(both.map(|both| Value::Many(Rc::new(both))))
            }))
        };
        fn copied(self: Iterator<&U>) -> Iterator<U> => |_, a, _| Ok(a[0].clone());
        fn cloned(self: Iterator<&U>) -> Iterator<U> => |_, a, _| Ok(a[0].clone());
        fn find(self, f: impl FnMut(&T) -> bool) -> Option<T> =>
            |m, a, _| option(found(m, a, Value::truth)?.map(|(_, value, _)| value));
        fn find_map(self, f: impl FnMut(T) -> Option<U>) -> Option<U> =>
            |m, a, _| option(found(m, a, |said| said.option().is_some())?.and_then(|(_, _, said)| said.option()));
        fn position(self, f: impl FnMut(T) -> bool) -> Option<usize> =>
            |m, a, _| option(found(m, a, Value::truth)?.map(|(n, _, _)| Value::Int(n as i128)));
        fn any(self, f: impl FnMut(T) -> bool) -> bool => |m, a, _| bool(found(m, a, Value::truth)?.is_some());
        fn all(self, f: impl FnMut(T) -> bool) -> bool =>
            |m, a, _| bool(found(m, a, |said| !said.truth())?.is_none());
        fn for_each(self, f: impl FnMut(T)) => |m, a, _| {
            found(m, a, |_| false)?;
            Ok(Value::Unit)
        };
        fn fold(self, start: U, f: impl FnMut(U, T) -> U) -> U => |m, a, _| {
            let mut sum = a[1].clone();
            for value in rest(m, &a[0])? {
                sum = m.apply(&a[2], &mut [sum, value])?;
            }
            Ok(sum)
        };
        fn reduce(self, f: impl FnMut(T, T) -> T) -> Option<T> => |m, a, _| {
            let mut sum = None;
            for value in rest(m, &a[0])? {
                sum = Some(match sum {
                    Some(sum) => m.apply(&a[1], &mut [sum, value])?,
                    None => value,
                });
            }
            option(sum)
        };
        fn sum(self) -> T => |m, a, _| folded(m, &a[0], 0.0, plus);
        fn product(self) -> T => |m, a, _| folded(m, &a[0], 1.0, times);
        fn count(self) -> usize => |m, a, _| int(rest(m, &a[0])?.len() as i128);
        fn last(self) -> Option<T> => |m, a, _| option(rest(m, &a[0])?.pop());
        fn nth(&self, n: usize) -> Option<T> => |m, a, _| {
            let iterator = iterator(&a[0]);
            for _ in 0..a[1].int() {
                iterator.next(m)?;
            }
            option(iterator.next(m)?)
        };
        fn min_by(self, f: impl FnMut(&T, &T) -> Ordering) -> Option<T> =>
            |m, a, _| extreme(m, &a[0], true, |m, one, other| { of_order(m, &a[1], one, other) });
        fn max_by(self, f: impl FnMut(&T, &T) -> Ordering) -> Option<T> =>
            |m, a, _| extreme(m, &a[0], false, |m, one, other| { of_order(m, &a[1], one, other) });
        fn min_by_key(self, f: impl FnMut(&T) -> U) -> Option<T> =>
            |m, a, _| extreme(m, &a[0], true, |m, one, other| { of_keys(m, &a[1], one, other) });
        fn max_by_key(self, f: impl FnMut(&T) -> U) -> Option<T> =>
            |m, a, _| extreme(m, &a[0], false, |m, one, other| { of_keys(m, &a[1], one, other) });
        fn collect(self) -> Vec<T> => |m, a, _| list(rest(m, &a[0])?);
    }
    "any" {
        fn clone(&self) -> Own => |_, a, _| Ok(a[0].clone());
    }
}

fn changed(list: &mut Value, change: impl FnOnce(&mut Vec<Value>)) -> Value {
    match list {
        Value::Many(all) => change(Rc::make_mut(all)),
        other => unreachable!("types are checked, and {other:?} is no list"),
    }
    Value::Unit
}

/// The bytes of a picture that a text has drawn.
pub(crate) fn picture(value: &Value) -> Option<Picture> {
    match value {
        Value::Picture(it) => Picture::from_rgb(it.0, it.1, it.2.clone()),
        _ => None,
    }
}

/// A constant of a type of the library.
pub(crate) fn constant(owner: &Type, name: &str) -> Option<(Value, Type)> {
    let vector = |it: Vec3| Some((Value::Vec3(it), Type::plain(Head::Vec3)));
    let number = |it: f64| Some((Value::Float(it), owner.clone()));
    match (owner.head()?, name) {
        (Head::Vec3, "ZERO") => vector(Vec3::ZERO),
        (Head::Vec3, "ONE") => vector(Vec3::ONE),
        (Head::Vec3, "NEG_ONE") => vector(Vec3::NEG_ONE),
        (Head::Vec3, "X") => vector(Vec3::X),
        (Head::Vec3, "Y") => vector(Vec3::Y),
        (Head::Vec3, "Z") => vector(Vec3::Z),
        (Head::Vec3, "NEG_X") => vector(Vec3::NEG_X),
        (Head::Vec3, "NEG_Y") => vector(Vec3::NEG_Y),
        (Head::Vec3, "NEG_Z") => vector(Vec3::NEG_Z),
        (Head::F64, "INFINITY") => number(f64::INFINITY),
        (Head::F64, "NEG_INFINITY") => number(f64::NEG_INFINITY),
        (Head::F64, "MAX") => number(f64::MAX),
        (Head::F64, "MIN") => number(f64::MIN),
        (Head::F64, "MIN_POSITIVE") => number(f64::MIN_POSITIVE),
        (Head::F64, "EPSILON") => number(f64::EPSILON),
        (Head::F64, "NAN") => number(f64::NAN),
        (Head::F32, "INFINITY") => number(f64::INFINITY),
        (Head::F32, "EPSILON") => number(f32::EPSILON.into()),
        (Head::Int(int), "MAX") => Some((Value::Int(int.most), owner.clone())),
        (Head::Int(int), "MIN") => Some((Value::Int(int.least), owner.clone())),
        (Head::Ordering, "Less") => Some((Value::Ordering(Ordering::Less), owner.clone())),
        (Head::Ordering, "Equal") => Some((Value::Ordering(Ordering::Equal), owner.clone())),
        (Head::Ordering, "Greater") => Some((Value::Ordering(Ordering::Greater), owner.clone())),
        _ => None,
    }
}
