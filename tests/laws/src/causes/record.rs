//! The mistakes in the record of a hit: its normal, and its side.

use common::rtweekend::*;
use speed_vs_accuracy::Case;

use super::{Hypothesis, Mistake, Question};
use crate::record::{Hit, Recorded};

/// A hit from which the record is made.
struct Point {
    point: Point3,
    case: Case,
    t: f64,
}

impl Point {
    /// From the center of the sphere to the point, over the radius.
    fn outward(&self) -> Vec3 {
        (self.point - self.case.center) / self.case.radius
    }

    /// The record with this vector for the normal that points out.
    fn facing(&self, outward: Vec3) -> Hit {
        let front_face = self.case.ray.direction.dot(outward) < 0.0;
        Hit {
            t: self.t,
            normal: if front_face { outward } else { -outward },
            front_face,
        }
    }

    /// The record with the right side, and this of the vectors for the normal.
    fn with(&self, normal: fn(bool, Vec3) -> Vec3) -> Hit {
        let right = self.facing(self.outward());
        Hit {
            normal: normal(right.front_face, self.outward()),
            ..right
        }
    }
}

/// A mistake, and the record that it makes of a hit.
type Known = (Mistake, fn(&Point) -> Hit);

const fn slip(
    names: &'static [&'static str],
    wrong: &'static str,
    right: &'static str,
    record: fn(&Point) -> Hit,
) -> Known {
    (
        Mistake {
            names,
            wrong,
            right,
        },
        record,
    )
}

const RECORDS: &[Known] = &[
    slip(
        &["face-normal-missing"],
        "rec.normal = outward_normal",
        "rec.set_face_normal(r, outward_normal)",
        |at| at.with(|_, outward| outward),
    ),
    slip(
        &["faces-swapped"],
        "normal = front_face ? -outward_normal : outward_normal",
        "normal = front_face ? outward_normal : -outward_normal",
        |at| at.with(|front_face, outward| if front_face { -outward } else { outward }),
    ),
    slip(
        &["normal-not-unit"],
        "N = r.at(t) - center",
        "N = unit_vector(r.at(t) - center)",
        |at| at.facing(at.outward() * at.case.radius),
    ),
    slip(
        &["normal-times-radius"],
        "outward_normal = (p - center) * radius",
        "outward_normal = (p - center) / radius",
        |at| at.facing(at.outward() * at.case.radius * at.case.radius),
    ),
    slip(
        &["normal-inward"],
        "N = unit_vector(center - r.at(t))",
        "N = unit_vector(r.at(t) - center)",
        |at| at.facing(-at.outward()),
    ),
    slip(
        &["normal-from-point"],
        "N = unit_vector(r.at(t))",
        "N = unit_vector(r.at(t) - center)",
        |at| at.facing(at.point.normalize()),
    ),
    slip(
        &["normal-from-point"],
        "N = unit_vector(r.at(t))",
        "N = unit_vector(r.at(t) - center)",
        |at| at.facing(at.point / at.case.radius),
    ),
    slip(
        &["center-after-unit"],
        "N = unit_vector(r.at(t)) - center",
        "N = unit_vector(r.at(t) - center)",
        |at| at.facing(at.point.normalize() - at.case.center),
    ),
    slip(
        &["center-added"],
        "N = unit_vector(r.at(t) + center)",
        "N = unit_vector(r.at(t) - center)",
        |at| at.facing((at.point + at.case.center) / at.case.radius),
    ),
    slip(
        &[],
        "front_face = dot(r.direction(), outward_normal) > 0",
        "front_face = dot(r.direction(), outward_normal) < 0",
        |at| {
            let right = at.facing(at.outward());
            Hit {
                normal: -right.normal,
                front_face: !right.front_face,
                ..right
            }
        },
    ),
    slip(
        &[],
        "the flag front_face is turned round",
        "front_face = dot(r.direction(), outward_normal) < 0",
        |at| {
            let right = at.facing(at.outward());
            Hit {
                front_face: !right.front_face,
                ..right
            }
        },
    ),
    slip(
        &[],
        "front_face is never set",
        "front_face = dot(r.direction(), outward_normal) < 0",
        |at| Hit {
            front_face: false,
            ..at.facing(at.outward())
        },
    ),
    slip(
        &[],
        "front_face is always true",
        "front_face = dot(r.direction(), outward_normal) < 0",
        |at| Hit {
            front_face: true,
            ..at.facing(at.outward())
        },
    ),
];

fn recorded(asked: &Recorded, record: impl Fn(&Point) -> Hit) -> Vec<Hit> {
    let case = asked.0;
    let at = |t| {
        let point = case.ray.at(t);
        record(&Point { point, case, t })
    };
    let Some(nearer) = case.right() else {
        return Vec::new();
    };
    let farther = -case.turned_round().right().unwrap_or(-nearer);
    vec![at(nearer), at(farther)]
}

impl Question for Recorded {
    type Answer = Vec<Hit>;

    const FUNCTION: &'static str = "{Hittable, Sphere}";

    fn right(&self) -> Vec<Hit> {
        recorded(self, |at| at.facing(at.outward()))
    }

    fn same(&self, one: &Vec<Hit>, other: &Vec<Hit>) -> bool {
        let near = |one: &Hit, other: &Hit| {
            let size = one.normal.length() + other.normal.length();
            one.front_face == other.front_face
                && (one.normal - other.normal).length() <= 1e-6 * size
        };
        one.len() == other.len() && one.iter().zip(other).all(|(one, other)| near(one, other))
    }

    /// A tangent has no side, so it is left out.
    fn telling() -> Vec<Self> {
        let cases = Case::telling().into_iter().map(Self);
        cases
            .filter(|asked| match &asked.right()[..] {
                [nearer, farther] => nearer.t < farther.t,
                _ => false,
            })
            .collect()
    }

    fn hypotheses() -> Vec<Hypothesis<Self>> {
        let hypothesis = |&(mistake, record): &Known| {
            Hypothesis::new(mistake, move |asked: &Self| recorded(asked, record))
        };
        RECORDS.iter().map(hypothesis).collect()
    }

    fn is_degenerate(&self) -> bool {
        self.0.is_degenerate()
    }
}
