//! The chapters' own functions, line by line: the value of each line for a ray.
//!
//! `build.rs` copies the functions and adds a note behind each `let`.

use common::rtweekend::*;
use hittable_list::HitRecord;

use crate::live::Says;
use crate::number::{spoken, triple};

include!(concat!(env!("OUT_DIR"), "/traced.rs"));

/// A sphere of chapter 5 with fields that can be read from here.
struct TracedSphere {
    center: Point3,
    radius: f64,
}

/// Returns the values of the lines of `hit_sphere` in chapter 2.
pub(crate) fn red_sphere_lines(center: Point3, radius: f64, ray: &Ray) -> Says {
    lines(red_sphere::LINES, |notes| {
        Some(red_sphere::hit_sphere(center, radius, ray, notes).to_string())
    })
}

/// Returns the values of the lines of `hit_sphere` in chapter 3.
pub(crate) fn normals_lines(center: Point3, radius: f64, ray: &Ray) -> Says {
    lines(normals::LINES, |notes| {
        normals::hit_sphere(center, radius, ray, notes).map(some)
    })
}

/// Returns the values of the lines of `hit_sphere` in chapter 4.
pub(crate) fn half_b_lines(center: Point3, radius: f64, ray: &Ray) -> Says {
    lines(half_b_sphere::LINES, |notes| {
        half_b_sphere::hit_sphere(center, radius, ray, notes).map(some)
    })
}

/// Returns the values of the lines of `Sphere::hit` in chapter 5, for t from 0 to infinity.
pub(crate) fn sphere_lines(center: Point3, radius: f64, ray: &Ray) -> Says {
    lines(sphere::LINES, |notes| {
        let record = TracedSphere { center, radius }.hit(ray, 0.0, f64::INFINITY, notes)?;
        Some(format!("Some(t = {}, …)", spoken(record.t)))
    })
}

/// Writes a root as the `Option` that holds it.
fn some(t: f64) -> String {
    format!("Some({})", spoken(t))
}

/// Returns the value of each line by the name that the line defines. The line that returns nothing
/// is called `none`, and the last one `result`; a line that was not reached has an empty value.
fn lines(
    names: &[&'static str],
    function: impl FnOnce(&mut Vec<String>) -> Option<String>,
) -> Says {
    let mut notes = Vec::new();
    // Without a result, it went no further than the first line without a note.
    let result = function(&mut notes).unwrap_or("None".to_owned());
    notes.push(result);
    notes.resize(names.len(), String::new());
    names.iter().copied().zip(notes).collect()
}

/// A value that a page shows beside a line.
trait Shown {
    /// Writes the value with at most two decimals.
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
