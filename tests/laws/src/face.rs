//! The law for `set_face_normal`, which can be asked before there is a sphere.

use common::rtweekend::*;

use crate::case::ray_from;
use crate::record::SET_FACE_NORMAL;
use crate::verdict::{BrokenLaw, LawResult};

/// The answer of a `set_face_normal`: a normal, and the side of the surface that the ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The normal that the function returns: if it is right, the unit normal against the ray.
    pub normal: Vec3,
    /// True if the ray comes from outside and meets the front face.
    pub front_face: bool,
}

/// A function like the `set_face_normal` of chapter 5: takes a ray and the outward unit normal at
/// the hit, and returns the face that the ray meets.
pub type SetFaceNormal<'a> = dyn Fn(&Ray, Vec3) -> Face + 'a;

/// Tests that `set_face_normal` returns `outward` with the front face for a ray along `direction`
/// that comes from outside, and −`outward` with the back face for one from inside.
///
/// Makes no claim where `direction` and `outward` are at a right angle, up to rounding.
pub fn the_normal_is_turned_against_the_ray(
    set_face_normal: &SetFaceNormal,
    direction: Vec3,
    outward: Vec3,
) -> LawResult {
    let ray = ray_from(Point3::ZERO, direction);
    let along = direction.dot(outward);
    let front_face = along < 0.0;
    let normal = if front_face { outward } else { -outward };
    let (found, expected) = (set_face_normal(&ray, outward), Face { normal, front_face });
    let is_right = found == expected || along.abs() < 1e-9;
    let said =
        |Face { normal, front_face }| format!("normal = {normal}, front_face = {front_face}");
    BrokenLaw::unless(is_right, || BrokenLaw {
        law: "the normal is turned against the ray, and front_face says whether it came from \
              outside"
            .into(),
        found: format!(
            "{}, for direction = {direction} and outward_normal = {outward}",
            said(found)
        ),
        allowed: said(expected),
        read: SET_FACE_NORMAL.into(),
    })
}
