//! The chapters' own functions, line by line: what each line comes to for a ray.
//!
//! The functions are copied by `build.rs`, with a note behind each `let`.

use common::rtweekend::*;
use hittable_list::HitRecord;

use crate::number::{spoken, triple};

include!(concat!(env!("OUT_DIR"), "/traced.rs"));

/// A sphere of chapter 5, whose own fields are private.
struct Sphere {
    center: Point3,
    radius: f64,
}

/// The value of each line, by the name that it gives; `none` is the line that returns
/// nothing, and `result` the last one. What is not reached is empty.
pub(crate) type Lines = Vec<(&'static str, String)>;

/// The lines of `hit_sphere` in chapter 2.
pub(crate) fn red_sphere_lines(center: Point3, radius: f64, ray: &Ray) -> Lines {
    lines(red_sphere::LINES, |trace| {
        Some(red_sphere::hit_sphere(center, radius, ray, trace).to_string())
    })
}

/// The lines of `hit_sphere` in chapter 3.
pub(crate) fn normals_lines(center: Point3, radius: f64, ray: &Ray) -> Lines {
    lines(normals::LINES, |trace| {
        normals::hit_sphere(center, radius, ray, trace).map(some)
    })
}

/// The lines of `hit_sphere` in chapter 4.
pub(crate) fn half_b_lines(center: Point3, radius: f64, ray: &Ray) -> Lines {
    lines(half_b_sphere::LINES, |trace| {
        half_b_sphere::hit_sphere(center, radius, ray, trace).map(some)
    })
}

/// The lines of `Sphere::hit` in chapter 5, for everything in front of the ray.
pub(crate) fn sphere_lines(center: Point3, radius: f64, ray: &Ray) -> Lines {
    lines(sphere::LINES, |trace| {
        let record = Sphere { center, radius }.hit(ray, 0.0, f64::INFINITY, trace)?;
        Some(format!("Some(t = {}, …)", spoken(record.t)))
    })
}

fn some(t: f64) -> String {
    format!("Some({})", spoken(t))
}

fn lines(names: &[&'static str], function: impl FnOnce(&mut Trace) -> Option<String>) -> Lines {
    let mut trace = Trace(names.iter().map(|&name| (name, String::new())).collect());
    match function(&mut trace) {
        Some(result) => trace.set("result", result),
        // It went no further than the first line without a value.
        None => {
            let stopped = trace.0.iter_mut().find(|(_, value)| value.is_empty());
            stopped.expect("the result has none").1 = "None".to_owned();
        }
    }
    trace.0
}

/// The notes of one call.
struct Trace(Lines);

impl Trace {
    fn note(&mut self, name: &str, value: &impl Shown) {
        self.set(name, value.shown());
    }

    fn set(&mut self, name: &str, shown: String) {
        let line = self.0.iter_mut().find(|(of, _)| *of == name);
        line.expect("each line has its name").1 = shown;
    }
}

/// What a page shows of a value.
trait Shown {
    fn shown(&self) -> String;
}

impl Shown for f64 {
    fn shown(&self) -> String {
        spoken(*self)
    }
}

impl Shown for Vec3 {
    fn shown(&self) -> String {
        triple(*self)
    }
}

impl<const N: usize> Shown for [f64; N] {
    fn shown(&self) -> String {
        format!("[{}]", self.map(spoken).join(", "))
    }
}
