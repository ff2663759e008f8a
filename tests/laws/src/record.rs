//! Laws for the record of a hit: its normal, and its side.

use common::rtweekend::*;
use proptest::strategy::Strategy;

use crate::case::{Case, IntervalCase, point_at};
use crate::intervals::{
    no_t_outside_the_interval_is_returned, the_nearest_root_in_the_interval_is_returned,
};
use crate::nearer_root::{
    self, U, a_tangent_is_a_hit_and_its_root_is_exact, the_point_lies_on_the_sphere,
};
use crate::oracle::ExactCase;
use crate::question::{Question, numbers_of_hit, telling_cases};
use crate::strategies::{
    any_case, in_front, integers, ordinary, ordinary_with_interval, with_interval,
};
use crate::trial::LawSuite;
use crate::verdict::{BrokenLaw, LawResult};

/// The record of a hit that a program's `Sphere::hit` returned, as in chapter 5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RecordedHit {
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
    /// The point where the ray meets the sphere.
    pub point: Point3,
    /// The normal at the point: a unit vector against the ray, if the program is right.
    pub normal: Vec3,
    /// True if the ray met the sphere from outside.
    pub front_face: bool,
}

/// A function like the `Sphere::hit` of chapter 5: takes a ray, a sphere and an interval, and
/// returns the record of the nearest hit between the ends, both excluded; `None` for a miss.
pub type RecordSolver<'a> = dyn Fn(&IntervalCase) -> Option<RecordedHit> + 'a;

/// The page that explains `set_face_normal`.
pub(crate) const SET_FACE_NORMAL: &str = "chapter 5: `set_face_normal`";

/// All laws for a record, those that teach most first.
const LAWS: [fn(&RecordSolver, &IntervalCase) -> LawResult; 6] = [
    |record, asked| the_point_lies_on_the_sphere(&nearer_root_of(record, asked), &asked.case),
    |record, asked| no_t_outside_the_interval_is_returned(&t_of(record), asked),
    |record, asked| the_nearest_root_in_the_interval_is_returned(&t_of(record), asked),
    a_tangent_in_the_interval_is_a_hit,
    on_the_whole_line_t_is_the_nearer_root,
    what_is_recorded_belongs_to_t,
];

/// Tests all laws for a record on the answers of `record` for one ray, sphere and interval, those
/// that teach most first.
pub fn obeys_every_law(record: &RecordSolver, asked: &IntervalCase) -> LawResult {
    LAWS.iter().try_for_each(|law| law(record, asked))
}

/// Makes of `record` a solver that returns only `t`.
fn t_of(record: &RecordSolver) -> impl Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> {
    move |center, radius, ray, t_min, t_max| {
        let case = Case::new(center, radius, *ray);
        record(&IntervalCase { case, t_min, t_max }).map(|hit| hit.t)
    }
}

/// Makes of `record` a solver that returns only `t`, for the interval of `asked`.
fn nearer_root_of(
    record: &RecordSolver,
    asked: &IntervalCase,
) -> impl Fn(Point3, f64, &Ray) -> Option<f64> {
    let IntervalCase { t_min, t_max, .. } = *asked;
    move |center, radius, ray| t_of(record)(center, radius, ray, t_min, t_max)
}

fn a_tangent_in_the_interval_is_a_hit(record: &RecordSolver, asked: &IntervalCase) -> LawResult {
    let IntervalCase { case, t_min, t_max } = asked;
    let root = nearer_root::exact_tangent(case).filter(|root| t_min < root && root < t_max);
    root.map_or(Ok(()), |_| {
        a_tangent_is_a_hit_and_its_root_is_exact(&nearer_root_of(record, asked), case)
    })
}

fn on_the_whole_line_t_is_the_nearer_root(
    record: &RecordSolver,
    asked: &IntervalCase,
) -> LawResult {
    if *asked != IntervalCase::unbounded(asked.case) {
        return Ok(());
    }
    nearer_root::obeys_every_law(&nearer_root_of(record, asked), &asked.case)
}

fn what_is_recorded_belongs_to_t(record: &RecordSolver, asked: &IntervalCase) -> LawResult {
    let (case, Some(hit)) = (&asked.case, record(asked)) else {
        return Ok(());
    };
    the_point_is_the_one_at_t(case, &hit)?;
    the_normal_is_the_radius_to_the_point_by_its_length(case, &hit)?;
    the_normal_points_against_the_ray(case, &hit)?;
    the_front_face_is_where_the_ray_enters(case, &hit)
}

/// Lists the cases and laws for a record: first what a camera sees, then any interval, and the whole
/// line last, of which only the laws ask; in each, whole numbers come first, and cases where only
/// rounding or an overflow shows a mistake last.
pub(crate) fn suite<'a>(record: &'a RecordSolver<'a>) -> LawSuite<'a, IntervalCase> {
    LawSuite {
        of: "sphere",
        kinds: vec![
            in_front().prop_map(IntervalCase::ahead).boxed(),
            integers().prop_map(IntervalCase::ahead).boxed(),
            ordinary().prop_map(IntervalCase::ahead).boxed(),
            with_interval(integers()).boxed(),
            with_interval(any_case()).boxed(),
            integers().prop_map(IntervalCase::unbounded).boxed(),
            any_case().prop_map(IntervalCase::unbounded).boxed(),
        ],
        telling: telling_cases(&ordinary_with_interval()),
        question: Question::Record,
        answer: Box::new(|asked| numbers_of_hit(asked, record(asked))),
        laws: LAWS
            .map(|law| Box::new(move |asked: &IntervalCase| law(record, asked)) as _)
            .into(),
        test: &|asked| {
            format!(
                "{asked}\nlet case = laws::Case::new(center, radius, ray);\n\
                 let asked = laws::IntervalCase {{ case, t_min, t_max }};\n\
                 laws::holds(laws::record::obeys_every_law(&record, &asked));"
            )
        },
    }
}

/// Tests that the point of a record is that of the ray at its t, up to two roundings of each
/// component, and two more if it was computed in another way.
fn the_point_is_the_one_at_t(case: &Case, hit: &RecordedHit) -> LawResult {
    let Ray { origin, direction } = case.ray;
    let expected = origin + hit.t * direction;
    let bound = 4.0 * U * (origin.abs() + (hit.t * direction).abs()).max_element();
    let holds = (hit.point - expected).abs().max_element() <= bound || !case.is_well_scaled();
    BrokenLaw::unless(holds, || BrokenLaw {
        law: "the point of a hit is the one at its t".into(),
        found: format!("{} at t = {}", hit.point, hit.t),
        allowed: format!("{expected} ± {bound:.1e}"),
        read: "chapter 5: anything that a ray can hit".into(),
    })
}

/// Tests that the normal is the unit vector from the center to the point at t, or its opposite, as
/// far as the point lies on the sphere. See [`normal_bound`] for how far.
///
/// A sphere of radius 0 can be hit, but it is a point, and a point has no normal: this law and
/// those below make no claim then.
fn the_normal_is_the_radius_to_the_point_by_its_length(
    case: &Case,
    hit: &RecordedHit,
) -> LawResult {
    let (r, bound) = (case.radius, normal_bound(case));
    let outward = (point_at(&case.ray, hit.t) - case.center) / r;
    let is_near = |normal: Vec3| (normal - outward).length() <= bound;
    let is_silent = r == 0.0 || !case.is_well_scaled();
    let holds = is_near(hit.normal) || is_near(-hit.normal) || is_silent;
    BrokenLaw::unless(holds, || BrokenLaw {
        law: "the normal of a hit is the radius to its point, and of length 1".into(),
        found: format!("{}, of length {}", hit.normal, hit.normal.length()),
        allowed: format!("{outward} ± {bound:.1e}, or the other way"),
        read: "chapter 3: how long normals are, and why".into(),
    })
}

/// Returns how far from a unit vector rounding may take a normal.
///
/// The error of t moves the point off the sphere by at most 43u·M/r², in radii: that of the root
/// (see [`root_bound`](crate::nearer_root::root_bound)) times √D/(r·√(a·M)). The coordinates of the
/// point and the center round on top, and the division by r rounds twice.
pub(crate) fn normal_bound(case: &Case) -> f64 {
    let (m, r) = (case.m(), case.radius);
    let coordinates = case.center.length() + case.ray.origin.length() + 3.0 * m.sqrt();
    U * (43.0 * m / (r * r) + 4.0 * coordinates / r + 6.0)
}

/// Tests that the normal never points along the ray, on either side of the surface. Holds to the
/// last bit: turning a vector turns its dot product.
fn the_normal_points_against_the_ray(case: &Case, hit: &RecordedHit) -> LawResult {
    let along = case.ray.direction.dot(hit.normal);
    BrokenLaw::unless(along <= 0.0 || case.radius == 0.0, || BrokenLaw {
        law: "the normal of a hit points against the ray".into(),
        found: format!("d·n = {along:?}, with n = {}", hit.normal),
        allowed: "d·n ≤ 0".into(),
        read: SET_FACE_NORMAL.into(),
    })
}

/// Tests that a ray which enters the sphere, before it is nearest to the center, meets the front
/// face, and one that leaves it the back.
///
/// Makes no claim where half the chord inside the sphere, √D/|d|, is not longer than the errors of
/// the point and of the dot product together.
fn the_front_face_is_where_the_ray_enters(case: &Case, hit: &RecordedHit) -> LawResult {
    let front_face = hit.front_face;
    let enters = hit.t < case.h() / case.a();
    let margin = ExactCase::of(case).discriminant_margin().max(0.0).sqrt();
    let scale = case.m().sqrt();
    let coordinates = case.center.length() + case.ray.origin.length();
    let error = 4.0 * U * (coordinates + scale * (24.0 + 24.0 / margin));
    let holds = front_face == enters || margin * scale <= error || !case.is_well_scaled();
    BrokenLaw::unless(holds, || BrokenLaw {
        law: "a ray meets the front face where it enters the sphere".into(),
        found: format!("front_face = {front_face}"),
        allowed: format!("front_face = {enters}"),
        read: SET_FACE_NORMAL.into(),
    })
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::{Complaint, Trial};

    /// Makes the right record of a hit.
    pub(crate) fn record(asked: &IntervalCase) -> Option<RecordedHit> {
        recorded(asked, |nearer, farther| vec![nearer, farther])
    }

    /// Makes the record of the first of the roots that lies in the interval.
    fn recorded(asked: &IntervalCase, roots: impl Fn(f64, f64) -> Vec<f64>) -> Option<RecordedHit> {
        let IntervalCase { case, t_min, t_max } = *asked;
        let exact = ExactCase::of(&case);
        let roots = roots(
            exact.nearer_root()?.rounded(),
            exact.farther_root()?.rounded(),
        );
        let t = roots.into_iter().find(|&t| t_min < t && t < t_max)?;
        let point = point_at(&case.ray, t);
        let outward = (point - case.center) / case.radius;
        let front_face = case.ray.direction.dot(outward) < 0.0;
        Some(RecordedHit {
            t,
            point,
            normal: if front_face { outward } else { -outward },
            front_face,
        })
    }

    #[test]
    fn the_right_record_obeys_the_laws() {
        crate::holds(Trial::default().record(&record));
    }

    /// On the whole line its author would not believe that it is wrong.
    #[test]
    fn inside_as_seen_from_the_worlds_origin_is_shown_in_the_range_that_a_camera_has() {
        let inside_if_the_origin_is = |asked: &IntervalCase| {
            let is_inside = asked.case.center.length() < asked.case.radius;
            recorded(asked, |nearer, farther| {
                vec![if is_inside { farther } else { nearer }]
            })
        };
        let Err(Complaint::Broken(report)) = Trial::default().record(&inside_if_the_origin_is)
        else {
            panic!("a law is broken");
        };
        let range = "(t_min, t_max) = (0.0, f64::INFINITY)";
        assert!(report.test.contains(range), "{report}");
    }
}
