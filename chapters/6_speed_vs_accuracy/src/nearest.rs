//! Exact comparison of roots, behind a filter: which of several spheres is hit first.
//!
//! A `t` within an ulp for each sphere is not enough to say that. Two roots may be
//! nearer to each other than an ulp, and a loop that keeps the closest `t` so far
//! then goes by how they were rounded. Here a few ulps decide nearly always, and
//! integers where they do not. One asks so where surfaces meet or touch, and the
//! wrong one must not show.

use common::rtweekend::*;

use crate::certified::{certified_t, comes_before};

/// Finds the sphere that the ray hits first with `t_min` < `t` < `t_max`: returns its index in
/// `spheres`, and `t`; `None` if all are missed or the list is empty.
///
/// Under the conditions of the theorem (`certified.md` of the notes) the sphere is right:
/// its nearest root in the range is the least of all. Where roots are equal, the first
/// sphere of the list counts, as in the book's loop. `t` is within an ulp of that root;
/// roots beyond the largest `f64` compare as they are, and become that. Spheres that are
/// not finite are missed, and so is everything in a range between whose ends no `f64` lies.
///
/// Cost: that of [`certified_t`] for each sphere that comes before all earlier
/// ones, and of its decision for the others. Two roots within two ulps of each
/// other are compared in integers, which takes about twice as long as
/// [`exact`](crate::exact()). Fails: never. Proof: letter N.
pub fn certified_nearest(
    spheres: &[(Point3, f64)],
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Option<(usize, f64)> {
    let mut nearest: Option<(usize, f64)> = None;
    let mut end = t_max;
    for (index, &(center, radius)) in spheres.iter().enumerate() {
        let Some(t) = certified_t(center, radius, ray, t_min, end) else {
            continue;
        };
        let is_first = nearest.is_none_or(|(other, of_other)| {
            t.next_up() <= of_other.next_down()
                || comes_before([(center, radius), spheres[other]], ray, t_min, t_max)
        });
        if is_first {
            nearest = Some((index, t));
            // What is farther than this by more than rounding need not be refined.
            end = t_max.min(t.next_up());
        }
    }
    nearest
}
