//! Groups of chapters in which the same slips can be made.

use crate::chapter::Chapter;

pub(super) const EVERY: &[Chapter] = &Chapter::OF_THE_BOOK;
pub(super) const BUILD_TEST: &[Chapter] = &[Chapter::BuildTest];
pub(super) const GRADIENT: &[Chapter] = &[Chapter::Gradient];
pub(super) const RED_SPHERE: &[Chapter] = &[Chapter::RedSphere];
pub(super) const HITTABLE_LIST: &[Chapter] = &[Chapter::HittableList];
/// Every chapter that casts rays.
pub(super) const RAYS: &[Chapter] = EVERY.split_at(1).1;
/// Every chapter that has a sphere.
pub(super) const SPHERES: &[Chapter] = EVERY.split_at(2).1;
