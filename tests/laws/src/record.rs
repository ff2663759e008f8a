//! Laws for the record of a hit: its normal, and its side.

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Ball, Chapter, Program};
use speed_vs_accuracy::Case;

use crate::broken::{Broken, Verdict};
use crate::nearer_root::U;
use crate::oracle::Exact;
use crate::question::{Question, numbers};
use crate::strategies;

pub use slips::Hit;

/// A function from center, radius, ray, `t_min` and `t_max` to the record of the
/// nearest hit between the two.
pub type Recorder<'a> = dyn Fn(Point3, f64, &Ray, f64, f64) -> Option<Hit> + 'a;

/// A law for a record. The flag says whether it is that of the nearer root.
type RecordLaw = fn(&Case, bool, &Hit) -> Verdict;

/// Every law for a record.
const RECORD: [RecordLaw; 4] = [
    the_point_is_the_one_at_t,
    the_normal_is_the_radius_to_the_point_by_its_length,
    the_normal_points_against_the_ray,
    the_front_face_is_where_the_ray_enters,
];

/// A case of which the records of both roots matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recorded(pub Case);

impl Recorded {
    /// The record of each root, the nearer one first: that is what an endless range
    /// finds, and a range behind it finds the farther one.
    pub fn hits(&self, record: &Recorder) -> Vec<Hit> {
        let Case {
            center,
            radius,
            ref ray,
        } = self.0;
        let behind = |t_min| record(center, radius, ray, t_min, f64::INFINITY);
        let nearer = behind(f64::NEG_INFINITY);
        let farther = nearer.and_then(|nearer| behind(nearer.t));
        nearer.into_iter().chain(farther).collect()
    }

    /// The numbers of both records.
    pub(crate) fn answer(&self, record: &Recorder) -> Vec<f64> {
        let of_hit = |hit: Hit| {
            let [[x, y, z], [u, v, w]] = [hit.point.to_array(), hit.normal.to_array()];
            [hit.t, x, y, z, u, v, w, f64::from(hit.front_face)]
        };
        let hits = self.hits(record).into_iter();
        hits.flat_map(|hit| numbers(Some(of_hit(hit)))).collect()
    }
}

/// The records of both roots obey every law for a record.
pub fn both_records_obey_the_laws(record: &Recorder, asked: &Recorded) -> Verdict {
    let hits = asked.hits(record);
    let nearer_first = [true, false].into_iter().zip(&hits);
    for (nearer, hit) in nearer_first {
        for law in RECORD {
            law(&asked.0, nearer, hit)?;
        }
    }
    Ok(())
}

/// The point of a record is that of the ray at its t: two roundings of each letter, and
/// two more if it was computed in another way.
fn the_point_is_the_one_at_t(case: &Case, _nearer: bool, hit: &Hit) -> Verdict {
    let Ray { origin, direction } = case.ray;
    let expected = origin + hit.t * direction;
    let bound = 4.0 * U * (origin.abs() + (hit.t * direction).abs()).max_element();
    if (hit.point - expected).abs().max_element() <= bound || !case.is_well_scaled() {
        return Ok(());
    }
    Err(Broken {
        law: "the point of a hit is the one at its t",
        found: format!("{} at t = {}", hit.point, hit.t),
        allowed: format!("{expected} ± {bound:.1e}"),
        usually: "it is computed before t is known, or without the origin of the ray",
        page: "chapter 5: anything that a ray can hit",
    })
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
fn the_normal_is_the_radius_to_the_point_by_its_length(
    case: &Case,
    _nearer: bool,
    hit: &Hit,
) -> Verdict {
    let (m, r) = (case.m(), case.radius);
    let coordinates = case.center.length() + case.ray.origin.length() + 3.0 * m.sqrt();
    let bound = U * (43.0 * m / (r * r) + 4.0 * coordinates / r + 6.0);
    let outward = (case.ray.at(hit.t) - case.center) / r;
    let is_near = |normal: Vec3| (normal - outward).length() <= bound;
    if is_near(hit.normal) || is_near(-hit.normal) || r == 0.0 || !case.is_well_scaled() {
        return Ok(());
    }
    Err(Broken {
        law: "the normal of a hit is the radius to its point, and of length 1",
        found: format!("{}, of length {}", hit.normal, hit.normal.length()),
        allowed: format!("{outward} ± {bound:.1e}, or the other way"),
        usually: "it is not that of point - center, or set before the point is, or not divided by \
                  the radius",
        page: "chapter 3: how long normals are, and why",
    })
}

/// The normal of a hit never points along the ray, on either side of the
/// surface. Holds to the last bit: turning a vector turns its dot product.
fn the_normal_points_against_the_ray(case: &Case, _nearer: bool, hit: &Hit) -> Verdict {
    let along = case.ray.direction.dot(hit.normal);
    if along <= 0.0 || case.radius == 0.0 {
        return Ok(());
    }
    Err(Broken {
        law: "the normal of a hit points against the ray",
        found: format!("d·n = {along:?}, with n = {}", hit.normal),
        allowed: "d·n ≤ 0".to_owned(),
        usually: "the outward normal is not turned where the ray comes from inside; or front and \
                back are mixed up",
        page: "chapter 5: `set_face_normal`",
    })
}

/// A ray that enters the sphere meets its front face, one that leaves meets the
/// back.
///
/// Silent where half the chord inside the sphere, √D/|d|, is not longer than
/// the errors of the point and of the dot product together.
fn the_front_face_is_where_the_ray_enters(case: &Case, nearer: bool, hit: &Hit) -> Verdict {
    let front_face = hit.front_face;
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
        usually: "> where it should say `ray.direction.dot(outward_normal) < 0.0`, or the normal \
                that is tested points inwards",
        page: "chapter 5: `set_face_normal`",
    })
}

/// What the record of a sphere in chapter 5 is asked for.
impl Question for Recorded {
    fn kind(&self) -> &'static str {
        "record"
    }

    fn as_test(&self, _: Chapter) -> String {
        format!(
            "{}\nlaws::trial::one_record(&record, &laws::Case {{ center, radius, ray }});",
            self.0
        )
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        self.answer(&|center, radius, ray, t_min, t_max| {
            program.record(Ball { center, radius }, ray, t_min, t_max)
        })
    }

    fn ordinary(_: Chapter) -> BoxedStrategy<Self> {
        strategies::ordinary().prop_map(Self).boxed()
    }

    fn cases(_: Chapter) -> Vec<BoxedStrategy<Self>> {
        strategies::kinds()
            .map(|kind| kind.prop_map(Self).boxed())
            .into()
    }

    /// A tangent has no side, so it is left out.
    fn telling(chapter: Chapter) -> Vec<Self> {
        let cases = Case::telling(chapter).into_iter();
        let has_sides = |case: &Case| Exact::of(case).discriminant().is_gt();
        cases.filter(has_sides).map(Self).collect()
    }
}
