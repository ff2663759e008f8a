//! Groups of chapters in which the same slips can be made.

use crate::chapter::Chapter;

pub(super) const EVERY: &[Chapter] = &Chapter::OF_THE_BOOK;
pub(super) const BUILD_TEST: &[Chapter] = &[Chapter::BuildTest];
pub(super) const GRADIENT: &[Chapter] = &[Chapter::Gradient];
pub(super) const RED_SPHERE: &[Chapter] = &[Chapter::RedSphere];
pub(super) const NORMALS: &[Chapter] = &[Chapter::Normals];
pub(super) const HITTABLE_LIST: &[Chapter] = &[Chapter::HittableList];
/// Every chapter that casts rays.
pub(super) const RAYS: &[Chapter] = EVERY.split_at(1).1;
/// Every chapter that has a sphere.
pub(super) const SPHERES: &[Chapter] = EVERY.split_at(2).1;
/// Every chapter that looks for roots and colors normals.
pub(super) const ROOTS: &[Chapter] = EVERY.split_at(3).1;
/// The chapters that use b.
pub(super) const FULL_B: &[Chapter] = &[Chapter::RedSphere, Chapter::Normals];
/// The chapters that use half of b.
pub(super) const HALF_B: &[Chapter] = &[Chapter::HalfBSphere, Chapter::HittableList];
/// The chapters that make the normal a unit vector by its length.
pub(super) const ONE_SPHERE: &[Chapter] = &[Chapter::Normals, Chapter::HalfBSphere];
/// The chapters whose scene is one sphere.
pub(super) const LONE_SPHERE: &[Chapter] = SPHERES.split_at(3).0;
