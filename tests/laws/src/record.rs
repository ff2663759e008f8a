//! Laws for the record of a hit: its normal, and its side.

use common::rtweekend::*;
use speed_vs_accuracy::Case;

use crate::nearer_root::U;
use crate::oracle::Exact;
use crate::verdict::{Broken, Verdict};

/// The normal of a hit is a unit vector, as far as the point lies on the sphere.
///
/// The error of t moves the point off the sphere by at most 43u·M/r², in radii:
/// that of the root (see [`root_bound`](crate::nearer_root::root_bound)) times
/// √D/(r·√(a·M)). The coordinates of the point and the center round on top,
/// and the division by r rounds twice.
///
/// A sphere of radius 0 can be hit, but it is a point, and a point has no
/// normal: nothing is claimed for it here or below.
pub fn the_normal_is_a_unit_vector(case: &Case, normal: Vec3) -> Verdict {
    let (m, r) = (case.m(), case.radius);
    let coordinates = case.center.length() + case.ray.origin.length() + 3.0 * m.sqrt();
    let bound = U * (43.0 * m / (r * r) + 4.0 * coordinates / r + 6.0);
    let length = normal.length();
    if (length - 1.0).abs() <= bound || r == 0.0 || !case.is_well_scaled() {
        return Ok(());
    }
    Err(Broken {
        law: "the normal of a hit has length 1",
        found: format!("length {length:?}"),
        allowed: format!("1 ± {bound:.1e}"),
        cause: "the vector from the center to the point is not divided by the radius".to_owned(),
        page: "chapter 3: how long normals are, and why",
    })
}

/// The normal of a hit never points along the ray, on either side of the
/// surface. Holds to the last bit: turning a vector turns its dot product.
pub fn the_normal_points_against_the_ray(case: &Case, normal: Vec3) -> Verdict {
    let along = case.ray.direction.dot(normal);
    if along <= 0.0 || case.radius == 0.0 {
        return Ok(());
    }
    Err(Broken {
        law: "the normal of a hit points against the ray",
        found: format!("d·n = {along:?}, with n = {normal:?}"),
        allowed: "d·n ≤ 0".to_owned(),
        cause: "the outward normal is not turned where the ray comes from inside; or front and \
                back are mixed up"
            .to_owned(),
        page: "chapter 5: `set_face_normal`",
    })
}

/// A ray that enters the sphere meets its front face, one that leaves meets the
/// back. `nearer` says which of the two roots was hit.
///
/// Silent where half the chord inside the sphere, √D/|d|, is not longer than
/// the errors of the point and of the dot product together.
pub fn the_front_face_is_where_the_ray_enters(
    case: &Case,
    nearer: bool,
    front_face: bool,
) -> Verdict {
    let margin = Exact::of(case).discriminant_margin().max(0.0).sqrt();
    let scale = case.m().sqrt();
    let coordinates = case.center.length() + case.ray.origin.length();
    let error = 4.0 * U * (coordinates + scale * (24.0 + 24.0 / margin));
    if front_face == nearer || margin * scale <= error || !case.is_well_scaled() {
        return Ok(());
    }
    Err(Broken {
        law: "a ray meets the front face where it enters the sphere",
        found: format!("front_face = {front_face}"),
        allowed: format!("front_face = {nearer}"),
        cause: "> where it should say `ray.direction.dot(outward_normal) < 0.0`, or the normal \
                that is tested points inwards"
            .to_owned(),
        page: "chapter 5: `set_face_normal`",
    })
}
