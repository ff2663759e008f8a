//! Laws for the record of a hit: its normal, and its side.

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Ball, Chapter, Program};
use speed_vs_accuracy::Case;

use crate::Verdict;
use crate::intervals::{
    no_t_outside_the_interval_is_returned, the_nearest_root_in_the_interval_is_returned,
};
use crate::nearer_root::{self, Solver, U};
use crate::oracle::Exact;
use crate::question::{Question, WithInterval};

pub use slips::Hit;

/// A function from a case with a range of `t` to the record of the nearest hit in it.
pub type Recorder<'a> = dyn Fn(&WithInterval) -> Option<Hit> + 'a;

/// Every law for a record, in the order in which they teach most: its `t` first. On the
/// whole line, that is the nearer root.
pub fn obeys_every_law(record: &Recorder, asked: &WithInterval) -> Verdict {
    let solve = |center, radius, ray: &Ray, t_min, t_max| {
        let case = Case::new(center, radius, *ray);
        record(&WithInterval { case, t_min, t_max }).map(|hit| hit.t)
    };
    let on_the_line =
        |center, radius, ray: &Ray| solve(center, radius, ray, f64::NEG_INFINITY, f64::INFINITY);
    nearer_root::obeys_every_law(&on_the_line, &asked.case)?;
    no_t_outside_the_interval_is_returned(&solve, asked)?;
    the_nearest_root_in_the_interval_is_returned(&solve, asked)?;
    let Some(hit) = record(asked) else {
        return Ok(());
    };
    the_point_is_the_one_at_t(&asked.case, &hit)?;
    the_normal_is_the_radius_to_the_point_by_its_length(&asked.case, &hit)?;
    the_normal_points_against_the_ray(&asked.case, &hit)?;
    the_front_face_is_where_the_ray_enters(&asked.case, &hit)
}

/// The point of a record is that of the ray at its t: two roundings of each letter, and
/// two more if it was computed in another way.
fn the_point_is_the_one_at_t(case: &Case, hit: &Hit) -> Verdict {
    let Ray { origin, direction } = case.ray;
    let expected = origin + hit.t * direction;
    let bound = 4.0 * U * (origin.abs() + (hit.t * direction).abs()).max_element();
    prop_assert!(
        (hit.point - expected).abs().max_element() <= bound || !case.is_well_scaled(),
        "the law:  the point of a hit is the one at its t\n\
         found:    {} at t = {}\n\
         allowed:  {expected} ± {bound:.1e}\n\
         read:     chapter 5: anything that a ray can hit",
        hit.point,
        hit.t
    );
    Ok(())
}

/// The normal of a hit is a unit vector from the center to the point at t, or the other
/// way, as far as the point lies on the sphere.
///
/// A sphere of radius 0 can be hit, but it is a point, and a point has no
/// normal: nothing is claimed for it here or below.
///
/// The error of t moves the point off the sphere by at most 43u·M/r², in radii:
/// that of the root (see [`root_bound`](crate::nearer_root::root_bound)) times
/// √D/(r·√(a·M)). The coordinates of the point and the center round on top,
/// and the division by r rounds twice.
fn the_normal_is_the_radius_to_the_point_by_its_length(case: &Case, hit: &Hit) -> Verdict {
    let (m, r) = (case.m(), case.radius);
    let coordinates = case.center.length() + case.ray.origin.length() + 3.0 * m.sqrt();
    let bound = U * (43.0 * m / (r * r) + 4.0 * coordinates / r + 6.0);
    let outward = (case.ray.at(hit.t) - case.center) / r;
    let is_near = |normal: Vec3| (normal - outward).length() <= bound;
    let is_silent = r == 0.0 || !case.is_well_scaled();
    prop_assert!(
        is_near(hit.normal) || is_near(-hit.normal) || is_silent,
        "the law:  the normal of a hit is the radius to its point, and of length 1\n\
         found:    {}, of length {}\n\
         allowed:  {outward} ± {bound:.1e}, or the other way\n\
         read:     chapter 3: how long normals are, and why",
        hit.normal,
        hit.normal.length()
    );
    Ok(())
}

/// The normal of a hit never points along the ray, on either side of the
/// surface. Holds to the last bit: turning a vector turns its dot product.
fn the_normal_points_against_the_ray(case: &Case, hit: &Hit) -> Verdict {
    let along = case.ray.direction.dot(hit.normal);
    prop_assert!(
        along <= 0.0 || case.radius == 0.0,
        "the law:  the normal of a hit points against the ray\n\
         found:    d·n = {along:?}, with n = {}\n\
         allowed:  d·n ≤ 0\n\
         read:     chapter 5: `set_face_normal`",
        hit.normal
    );
    Ok(())
}

/// A ray that enters the sphere, before it is nearest to the center, meets the front face;
/// one that leaves meets the back.
///
/// Silent where half the chord inside the sphere, √D/|d|, is not longer than
/// the errors of the point and of the dot product together.
fn the_front_face_is_where_the_ray_enters(case: &Case, hit: &Hit) -> Verdict {
    let front_face = hit.front_face;
    let enters = hit.t < case.h() / case.a();
    let margin = Exact::of(case).discriminant_margin().max(0.0).sqrt();
    let scale = case.m().sqrt();
    let coordinates = case.center.length() + case.ray.origin.length();
    let error = 4.0 * U * (coordinates + scale * (24.0 + 24.0 / margin));
    prop_assert!(
        front_face == enters || margin * scale <= error || !case.is_well_scaled(),
        "the law:  a ray meets the front face where it enters the sphere\n\
         found:    front_face = {front_face}\n\
         allowed:  front_face = {enters}\n\
         read:     chapter 5: `set_face_normal`"
    );
    Ok(())
}

/// The numbers of a root, without a range. Chapter 2 only says whether there is one: any
/// number stands for it.
pub(crate) fn root(chapter: Chapter, solve: &Solver, asked: &WithInterval) -> Vec<f64> {
    let root = asked.case.solve(solve);
    let is_told = chapter != Chapter::RedSphere;
    let told = root.map(|t| if is_told { t } else { 0.0 });
    told.into_iter().collect()
}

/// The numbers of a record. Which side of a tangent is hit is a matter of rounding.
pub(crate) fn numbers(asked: &WithInterval, record: &Recorder) -> Vec<f64> {
    let Some(hit) = record(asked) else {
        return Vec::new();
    };
    if Exact::of(&asked.case).discriminant().is_eq() {
        return vec![hit.t];
    }
    let vectors = [hit.point.to_array(), hit.normal.to_array()].concat();
    [vec![hit.t, f64::from(hit.front_face)], vectors].concat()
}

/// The record that a program makes.
pub(crate) fn record_of(program: &Program, asked: &WithInterval) -> Option<Hit> {
    let Case {
        center,
        radius,
        ray,
    } = asked.case;
    program.record(Ball { center, radius }, &ray, asked.t_min, asked.t_max)
}

/// What is asked of `hit_sphere` in chapters 2 to 4, and of the `hit` of a sphere in chapter 5:
/// only this has a range.
impl Question for WithInterval {
    fn kind(&self) -> &'static str {
        "sphere"
    }

    fn as_test(&self, chapter: Chapter) -> String {
        let case = "let case = laws::Case::new(center, radius, ray);";
        match chapter {
            Chapter::RedSphere => {
                let is_hit = Exact::of(&self.case).nearer_root().is_some();
                let case = self.case;
                format!("{case}\nassert_eq!(hit_sphere(center, radius, &ray), {is_hit});")
            }
            Chapter::HittableList => format!(
                "{self}\n{case}\nlet asked = laws::WithInterval {{ case, t_min, t_max }};\n\
                 laws::holds(laws::record::obeys_every_law(&record, &asked));"
            ),
            _ => format!(
                "{}\n{case}\nlaws::holds(laws::nearer_root::obeys_every_law(&hit_sphere, &case));",
                self.case
            ),
        }
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        let solve = |center, radius, ray: &Ray| program.hit_sphere(center, radius, ray);
        match program.chapter {
            Chapter::HittableList => numbers(self, &|asked| record_of(program, asked)),
            chapter => root(chapter, &solve, self),
        }
    }
}
