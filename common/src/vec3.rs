//! The book's `vec3`, which here is glam's vector of three `f64`.

/// A vector in space: `x` to the right, `y` up, `z` towards the viewer.
///
/// `dot`, `length_squared` and `normalize` round exactly as the book's
/// functions do: `dot` adds x, y, z from left to right, and `normalize`
/// multiplies by the reciprocal of the length.
///
/// One operator differs. The book's `v / s` multiplies by `1 / s`, glam's
/// divides each component, and the last bit can tell them apart. Where the book
/// divides a vector, write `v * (1.0 / s)`.
pub type Vec3 = glam::DVec3;

/// A place in space: the three coordinates of a [`Vec3`] under another name.
pub type Point3 = Vec3;
