//! Generators (proptest calls them strategies): rays and spheres that lead to the
//! hard places on purpose.
//!
//! Each strategy builds its ray so that the answer is known beforehand, or lies
//! where a method may fail. Nothing is filtered out.

use std::f64::consts::{PI, SQRT_2};
use std::ops::RangeInclusive;

use common::rtweekend::*;
use proptest::prelude::*;
use proptest::sample::select;
use speed_vs_accuracy::Case;

use crate::intervals::WithInterval;
use crate::oracle::Exact;

/// Any of the cases below whose numbers are finite and in ordinary range: all
/// but [`exponents`] and [`specks`].
pub fn anywhere() -> impl Strategy<Value = Case> {
    prop_oneof![
        book_rays(),
        integers(),
        grazing(0.0..=15.0),
        far(0.5..=15.0),
        near_the_surface(1.0..=15.0),
        inside(),
        above_the_ground(2.0..=9.0),
        tangents(),
        log_uniform(),
        exponents(),
    ]
}

/// A pixel of a picture up to 400 wide, and one of the two spheres of the book.
pub fn book_rays() -> impl Strategy<Value = Case> {
    let ball = (Point3::new(0.0, 0.0, -1.0), 0.5);
    let ground = (Point3::new(0.0, -100.5, -1.0), 100.0);
    (1u32..=400, 0.0..1.0, 0.0..1.0, select(vec![ball, ground])).prop_map(
        |(width, across, down, (center, radius))| {
            let camera = Camera::new(width);
            let ray = camera.ray(
                (across * f64::from(camera.image_width)) as u32,
                (down * f64::from(camera.image_height)) as u32,
            );
            Case {
                center,
                radius,
                ray,
            }
        },
    )
}

/// Small whole numbers everywhere: what they lead to can be checked by hand.
pub fn integers() -> impl Strategy<Value = Case> {
    (whole_vector(9), 0..=9, whole_vector(9), whole_vector(9)).prop_map(
        |(center, radius, origin, direction)| Case {
            center,
            radius: f64::from(radius),
            // A direction of zero points nowhere: let it point ahead.
            ray: match direction {
                Vec3::ZERO => Ray::new(origin, Vec3::NEG_Z),
                direction => Ray::new(origin, direction),
            },
        },
    )
}

/// A line that passes the center at a distance of r·(1 ± 10⁻ᵏ): just inside,
/// just outside.
pub fn grazing(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    (k, any::<bool>(), ordinary_sphere(), sight()).prop_map(|(k, outside, sphere, sight)| {
        let sign = if outside { 1.0 } else { -1.0 };
        let miss_by = 1.0 + sign * 10f64.powf(-k);
        sight.towards(sphere, 3.0, miss_by)
    })
}

/// A sphere whose center is 10ᵏ radii away, aimed at within 1.2 radii.
pub fn far(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    (k, 0.0..1.2, ordinary_sphere(), sight())
        .prop_map(|(k, miss_by, sphere, sight)| sight.towards(sphere, 10f64.powf(k), miss_by))
}

/// A ray in any direction from r·(1 ± 10⁻ᵏ) away from the center, as one that
/// is reflected by the surface starts.
pub fn near_the_surface(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    (k, any::<bool>(), ordinary_sphere(), unit(), unit()).prop_map(
        |(k, outside, (center, radius), normal, direction)| {
            let sign = if outside { 1.0 } else { -1.0 };
            let origin = center + radius * (1.0 + sign * 10f64.powf(-k)) * normal;
            Case {
                center,
                radius,
                ray: Ray::new(origin, direction),
            }
        },
    )
}

/// A ray in any direction from anywhere inside the sphere.
pub fn inside() -> impl Strategy<Value = Case> {
    (0.0..1.0, ordinary_sphere(), unit(), unit()).prop_map(
        |(depth, (center, radius), normal, direction)| Case {
            center,
            radius,
            ray: Ray::new(center + radius * depth * normal, direction),
        },
    )
}

/// A ray in any direction from 0.01 to 10 above a ground sphere of radius 10ᵏ.
pub fn above_the_ground(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    (k, 0.01..10.0, unit()).prop_map(|(k, height, direction): (f64, f64, Vec3)| {
        let radius = 10f64.powf(k);
        Case {
            center: Point3::new(0.0, -(radius + height), 0.0),
            radius,
            ray: Ray::new(Point3::ZERO, direction),
        }
    })
}

/// Right triangles with whole sides, so that a line touches the sphere exactly
/// and every operation of the quadratic is exact too.
pub fn tangents() -> impl Strategy<Value = Case> {
    let legs_and_hypotenuse = vec![[3.0, 4.0, 5.0], [5.0, 12.0, 13.0], [8.0, 15.0, 17.0]];
    // In three planes, so that each letter of a dot product has its turn.
    let planes: Vec<fn(f64, f64) -> Vec3> = vec![
        |p, q| Vec3::new(p, q, 0.0),
        |p, q| Vec3::new(0.0, p, q),
        |p, q| Vec3::new(q, 0.0, p),
    ];
    (
        select(legs_and_hypotenuse),
        select(planes),
        1..=9,
        1..=9,
        whole_vector(99),
    )
        .prop_map(|([p, q, hypotenuse], plane, t, k, origin)| {
            // As long as the direction and at a right angle to it: the line
            // passes the center at k hypotenuses, and touches at t.
            let (direction, sideways) = (plane(p, q), plane(-q, p));
            Case {
                center: origin + f64::from(t) * direction + f64::from(k) * sideways,
                radius: f64::from(k) * hypotenuse,
                ray: Ray::new(origin, direction),
            }
        })
}

/// Each number from 2⁻²⁰ to 2²⁰ in size, all sizes equally likely.
pub fn log_uniform() -> impl Strategy<Value = Case> {
    let number = || {
        (-20.0..20.0, any::<bool>()).prop_map(|(exponent, negative)| {
            let size = f64::exp2(exponent);
            if negative { -size } else { size }
        })
    };
    let vector = move || (number(), number(), number()).prop_map(|(x, y, z)| Vec3::new(x, y, z));
    (vector(), -20.0..20.0, vector(), vector()).prop_map(|(center, radius, origin, direction)| {
        Case {
            center,
            radius: f64::exp2(radius),
            ray: Ray::new(origin, direction),
        }
    })
}

/// A direction from 1e-150 to 1e150 long, at an ordinary sphere.
pub fn exponents() -> impl Strategy<Value = Case> {
    (-150.0..150.0, 0.0..1.2, ordinary_sphere(), sight()).prop_map(
        |(exponent, miss_by, sphere, sight)| {
            let case = sight.towards(sphere, 3.0, miss_by);
            case.with_ray(case.ray.origin, 10f64.powf(exponent) * case.ray.direction)
        },
    )
}

/// Numbers that programs forget: zeros of either sign, the least and the
/// largest, and one.
pub fn specks() -> impl Strategy<Value = Case> {
    let number = select(vec![
        0.0,
        -0.0,
        1.0,
        -1.0,
        f64::from_bits(1),
        -f64::from_bits(1),
        f64::MIN_POSITIVE,
        f64::EPSILON,
        1e154,
        -1e154,
        f64::MAX,
        f64::MIN,
    ]);
    proptest::array::uniform10(number).prop_map(Case::from_numbers)
}

/// All of the above, and what only arithmetic without end gets right: for
/// methods that claim to be right for every input.
pub fn hostile() -> impl Strategy<Value = Case> {
    prop_oneof![
        4 => anywhere(),
        1 => specks(),
        1 => far(15.0..=17.0),
        1 => leaving_the_surface(0.0..=9.0),
        1 => almost_tangents(),
        1 => whole_number_tangents_an_ulp_off(),
        1 => in_another_unit(anywhere()),
        1 => moved_away(anywhere()),
        1 => any_numbers(),
    ]
}

/// A ray that starts on the surface, up to one rounding of each coordinate, as
/// the book scatters it: in the direction of the normal plus any unit vector.
/// The sphere has a radius of 10ᵏ.
pub fn leaving_the_surface(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    (k, ordinary_sphere(), unit(), unit()).prop_map(|(k, (center, _), normal, scatter)| {
        let radius = 10f64.powf(k);
        Case {
            center,
            radius,
            ray: Ray::new(center + radius * normal, normal + scatter),
        }
    })
}

/// Whole numbers, and a radius within three ulps of the line's distance from the
/// center.
pub fn almost_tangents() -> impl Strategy<Value = Case> {
    (whole_vector(50), whole_vector(50), whole_vector(50), -3..=3).prop_map(
        |(center, origin, direction, ulps)| {
            let d = if direction == Vec3::ZERO {
                Vec3::X
            } else {
                direction
            };
            let across = d.cross(center - origin);
            let distance = (across.length_squared() / d.length_squared()).sqrt();
            Case {
                center,
                radius: ulps_away(distance, ulps),
                ray: Ray::new(origin, d),
            }
        },
    )
}

/// [`tangents`] whose radius is one ulp too small, right, or one too large.
pub fn whole_number_tangents_an_ulp_off() -> impl Strategy<Value = Case> {
    (tangents(), -1..=1).prop_map(|(case, ulps)| Case {
        radius: ulps_away(case.radius, ulps),
        ..case
    })
}

/// Lengths, and apart from them the direction, times a power of two from 2⁻⁵⁰⁰
/// to 2⁵⁰⁰: the digits stay what they are.
pub fn in_another_unit(cases: impl Strategy<Value = Case>) -> impl Strategy<Value = Case> {
    (cases, -500..=500, -500..=500).prop_map(|(case, length, direction)| {
        let [length, direction] = [length, direction].map(|k| f64::exp2(f64::from(k)));
        Case {
            center: length * case.center,
            radius: length * case.radius,
            ray: Ray::new(length * case.ray.origin, direction * case.ray.direction),
        }
    })
}

/// Sphere and ray together up to 2⁶⁰ away: C and Q have fewer digits in common
/// with C − Q, which is then rounded.
pub fn moved_away(cases: impl Strategy<Value = Case>) -> impl Strategy<Value = Case> {
    (cases, unit(), 0.0..60.0).prop_map(|(case, way, exponent)| {
        let by = f64::exp2(exponent) * way;
        Case {
            center: case.center + by,
            ..case.with_ray(case.ray.origin + by, case.ray.direction)
        }
    })
}

/// Any ten finite numbers: all bits at random.
pub fn any_numbers() -> impl Strategy<Value = Case> {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    proptest::array::uniform10(POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO)
        .prop_map(Case::from_numbers)
}

/// A case, and an interval whose ends lie at a root, within two ulps of one, at
/// 0 or 1, or at an end of all numbers; one in a hundred is NaN.
pub fn with_hostile_interval(
    cases: impl Strategy<Value = Case>,
) -> impl Strategy<Value = WithInterval> {
    (cases, end(), end()).prop_map(|(case, low, high)| WithInterval {
        case,
        t_min: low.of(&case).unwrap_or(0.0),
        t_max: high.of(&case).unwrap_or(f64::INFINITY),
    })
}

/// An end of a hostile interval.
#[derive(Clone, Copy, Debug)]
enum End {
    /// What a program asks for: 0 and ∞.
    Usual,
    /// A root, and so many ulps from it.
    Root { nearer: bool, ulps: i32 },
    /// A number, whatever the roots are.
    At(f64),
}

fn end() -> impl Strategy<Value = End> {
    let fixed = vec![
        0.0,
        1.0,
        -1.0,
        f64::MIN,
        f64::MAX,
        f64::NEG_INFINITY,
        f64::INFINITY,
    ];
    prop_oneof![
        50 => Just(End::Usual),
        40 => (any::<bool>(), -2..=2).prop_map(|(nearer, ulps)| End::Root { nearer, ulps }),
        9 => select(fixed).prop_map(End::At),
        1 => Just(End::At(f64::NAN)),
    ]
}

impl End {
    /// Where the end is; `None` where a program would have it.
    fn of(self, case: &Case) -> Option<f64> {
        match self {
            Self::Usual => None,
            Self::At(x) => Some(x),
            Self::Root { nearer, ulps } => {
                let exact = Exact::of(case);
                let root = if nearer {
                    exact.nearer_root()
                } else {
                    exact.farther_root()
                };
                Some(ulps_away(root?.rounded(), ulps))
            }
        }
    }
}

/// `x`, and then so many steps up or down to the next number.
pub(crate) fn ulps_away(x: f64, ulps: i32) -> f64 {
    let step = if ulps > 0 {
        f64::next_up
    } else {
        f64::next_down
    };
    (0..ulps.abs()).fold(x, |x, _| step(x))
}

/// A case, and an interval with ends near and between its roots, far from
/// them, or infinite.
pub fn with_interval(cases: impl Strategy<Value = Case>) -> impl Strategy<Value = WithInterval> {
    let end = || prop_oneof![Just(f64::INFINITY), -3.0..3.0];
    (cases, end(), end()).prop_map(|(case, low, high)| {
        let scale = case.t_scale();
        let t_min = if low.is_infinite() { 0.0 } else { low * scale };
        WithInterval {
            case,
            t_min,
            t_max: high * scale,
        }
    })
}

/// A vector of whole numbers from −`most` to `most`.
pub(crate) fn whole_vector(most: i32) -> impl Strategy<Value = Vec3> {
    let number = move || -most..=most;
    (number(), number(), number())
        .prop_map(|(x, y, z)| Vec3::new(f64::from(x), f64::from(y), f64::from(z)))
}

/// Center and radius of a sphere of ordinary size.
fn ordinary_sphere() -> impl Strategy<Value = (Point3, f64)> {
    ((-9.0..9.0, -9.0..9.0, -9.0..9.0), -2.0..2.0)
        .prop_map(|((x, y, z), exponent)| (Point3::new(x, y, z), 10f64.powf(exponent)))
}

/// A unit vector in any direction.
pub(crate) fn unit() -> impl Strategy<Value = Vec3> {
    (-1.0..=1.0, 0.0..2.0).prop_map(|(z, turn): (f64, f64)| {
        let (sin, cos) = (turn * PI).sin_cos();
        let ring = (1.0 - z * z).sqrt();
        Vec3::new(ring * cos, ring * sin, z)
    })
}

/// From where, and how tilted, a ray looks at a sphere.
#[derive(Clone, Copy, Debug)]
struct Sight {
    /// From the origin of the ray towards the sphere.
    forward: Vec3,
    /// At a right angle to `forward`.
    sideways: Vec3,
    /// The length of the direction.
    length: f64,
}

fn sight() -> impl Strategy<Value = Sight> {
    (unit(), 0.0..2.0, -3.0..3.0).prop_map(|(forward, turn, exponent): (Vec3, f64, f64)| {
        let (sin, cos) = (turn * PI).sin_cos();
        let across = forward.any_orthonormal_vector();
        Sight {
            forward,
            sideways: cos * across + sin * forward.cross(across),
            length: SQRT_2.powf(exponent),
        }
    })
}

impl Sight {
    /// A ray that starts about `away` radii before the sphere and whose line
    /// passes the center at `miss_by` radii.
    fn towards(self, (center, radius): (Point3, f64), away: f64, miss_by: f64) -> Case {
        let closest = center + radius * miss_by * self.sideways;
        Case {
            center,
            radius,
            ray: Ray::new(
                closest - radius * away * self.forward,
                self.length * self.forward,
            ),
        }
    }
}
