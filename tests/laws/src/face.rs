//! The law for `set_face_normal`, which can be asked before there is a sphere.

use common::rtweekend::*;

use crate::record::SET_FACE_NORMAL;
use crate::verdict::{BrokenLaw, LawResult};

pub use common::rtweekend::Vec3;

/// The side of a surface on which a ray meets it, as `set_face_normal` answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The unit normal, which should point against the ray.
    pub normal: Vec3,
    /// True if the ray meets the outer side.
    pub front_face: bool,
}

/// A function like the `set_face_normal` of chapter 5: from a ray and the outward unit normal to
/// the face.
pub type SetFaceNormal<'a> = dyn Fn(&Ray, Vec3) -> Face + 'a;

/// Tests that the normal is the outward one, or its opposite where that points along the ray.
///
/// Makes no claim where `direction` and `outward` are at a right angle, up to rounding: either side
/// will do.
///
/// # Errors
/// The broken law, if `set_face_normal` answers otherwise.
pub fn the_normal_is_turned_against_the_ray(
    set_face_normal: &SetFaceNormal,
    direction: Vec3,
    outward: Vec3,
) -> LawResult {
    let ray = Ray::new(Point3::ZERO, direction);
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
