//! The law for `set_face_normal`, which can be asked before there is a sphere.

use common::rtweekend::*;
use proptest::prelude::*;
use proptest::test_runner::{TestError, TestRunner};

use crate::Verdict;
use crate::strategies::{config, unit};
use crate::trial::holds;

pub use common::rtweekend::Vec3;

/// What a record knows of the side on which it is hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The normal, which should point against the ray.
    pub normal: Vec3,
    /// Whether the ray came from outside.
    pub front_face: bool,
}

/// A function from a ray and the outward normal to the face.
pub type Facing<'a> = dyn Fn(&Ray, Vec3) -> Face + 'a;

/// Panics with what the law says of the smallest case that breaks it.
///
/// # Panics
/// If the law is broken.
pub fn is_turned_against_the_ray(set_face_normal: &Facing) {
    let law = |(direction, outward)| the_normal_is_turned(set_face_normal, direction, outward);
    let found = TestRunner::new(config()).run(&(unit(), unit()), law);
    if let Err(TestError::Fail(_, case)) = found {
        holds(law(case));
    }
}

/// The normal is the outward one, or its opposite where that points along the ray.
///
/// Silent where the two are at a right angle but for roundings: either side will do.
fn the_normal_is_turned(set_face_normal: &Facing, direction: Vec3, outward: Vec3) -> Verdict {
    let ray = Ray::new(Point3::ZERO, direction);
    let along = direction.dot(outward);
    let front_face = along < 0.0;
    let normal = if front_face { outward } else { -outward };
    let (found, expected) = (set_face_normal(&ray, outward), Face { normal, front_face });
    prop_assert!(
        found == expected || along.abs() < 1e-9,
        "the law:  the normal is turned against the ray, and front_face says whether it came from \
         outside\n\
         found:    normal = {}, front_face = {}\n\
         allowed:  normal = {normal}, front_face = {front_face}\n\
         ray:      direction = {direction}, outward_normal = {outward}\n\
         read:     chapter 5: `set_face_normal`",
        found.normal,
        found.front_face
    );
    Ok(())
}
