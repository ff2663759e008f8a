//! Known methods that chapter 6 leaves out: how exact they are, beside those that it has.

use common::rtweekend::*;
use speed_vs_accuracy::{Method, Solve};

/// The methods that chapter 6 names and does not use.
pub(crate) const REJECTED: &[Method] = &[
    method("nearest_point_q", nearest_point_q),
    method("factored_distance_q", factored_distance_q),
    method("moved_origin", moved_origin),
    method("kahan_q", kahan_q),
    method("factored_c_q", factored_c_q),
    method("intervals_q", intervals_q),
    method("unit_direction_q", unit_direction_q),
];

type Double = fn(Point3, f64, &Ray, f64, f64) -> Option<f64>;

const fn method(name: &'static str, solve: Double) -> Method {
    let solve = Solve::Double(solve);
    Method {
        name,
        solve,
        is_certified: false,
    }
}

/// Returns center − origin, and a, h and c of the equation, as in chapter 5.
fn coefficients(center: Point3, radius: f64, ray: &Ray) -> (Vec3, [f64; 3]) {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    (oc, [a, h, oc.length_squared() - radius * radius])
}

/// Returns the nearest root in the range, neither of which cancels.
fn by_q([a, h, c]: [f64; 3], discriminant: f64, t_min: f64, t_max: f64) -> Option<f64> {
    let q = h + discriminant.sqrt().copysign(h);
    let roots = if q > 0.0 {
        [c / q, q / a]
    } else {
        [q / a, c / q]
    };
    let mut roots = roots.into_iter();
    roots.find(|&t| discriminant >= 0.0 && t_min < t && t < t_max)
}

/// Returns the vector to the center from the point of the line that is nearest to it.
fn from_nearest_point(oc: Vec3, [a, h, _]: [f64; 3], ray: &Ray) -> Vec3 {
    oc - h / a * ray.direction
}

/// D/a = r² − l², with l from the nearest point: Haines and others, Embree.
fn nearest_point_q(center: Point3, r: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let (oc, of) = coefficients(center, r, ray);
    let l_squared = from_nearest_point(oc, of, ray).length_squared();
    by_q(of, of[0] * (r * r - l_squared), t_min, t_max)
}

/// D/a = (r − l)(r + l): pbrt.
fn factored_distance_q(center: Point3, r: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let (oc, of) = coefficients(center, r, ray);
    let l = from_nearest_point(oc, of, ray).length();
    by_q(of, of[0] * ((r - l) * (r + l)), t_min, t_max)
}

/// The ray starts at its nearest point instead: Wald.
fn moved_origin(center: Point3, r: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let (_, [a, h, _]) = coefficients(center, r, ray);
    let way = h / a;
    let moved = Ray::new(ray.at(way), ray.direction);
    let (_, [a, h, c]) = coefficients(center, r, &moved);
    let discriminant = h * h - a * c;
    let roots = [-1.0, 1.0].map(|sign| way + (h + sign * discriminant.sqrt()) / a);
    roots.into_iter().find(|&t| t_min < t && t < t_max)
}

/// h² − ac rounded hardly more than once: Kahan, Boost.Math.
fn kahan_q(center: Point3, r: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let (_, [a, h, c]) = coefficients(center, r, ray);
    let ac = a * c;
    let lost = (-a).mul_add(c, ac);
    by_q([a, h, c], h.mul_add(h, -ac) + lost, t_min, t_max)
}

/// c = (|oc| − r)(|oc| + r).
fn factored_c_q(center: Point3, r: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let (oc, [a, h, _]) = coefficients(center, r, ray);
    let c = (oc.length() - r) * (oc.length() + r);
    by_q([a, h, c], h * h - a * c, t_min, t_max)
}

/// The direction is divided by its length first.
fn unit_direction_q(center: Point3, r: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let length = ray.direction.length();
    let (_, [_, h, c]) = coefficients(center, r, &Ray::new(ray.origin, ray.direction / length));
    let [from, to] = [t_min, t_max].map(|t| t * length);
    by_q([1.0, h, c], h * h - c, from, to).map(|t| t / length)
}

/// A miss if the lower bound of D is negative: pbrt. The roots are those of `half_b_q`.
fn intervals_q(center: Point3, r: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let exactly = |x: f64| Bounds([x, x]);
    let (d, oc) = (
        ray.direction.to_array().map(exactly),
        (center.to_array().into_iter().zip(ray.origin.to_array()))
            .map(|(to, from)| exactly(to).plus(exactly(-from)))
            .collect::<Vec<_>>(),
    );
    let dot = |u: &[Bounds], v: &[Bounds]| {
        let products = u.iter().zip(v).map(|(x, y)| x.times(*y));
        products.reduce(Bounds::plus).expect("three of them")
    };
    let [a, h] = [dot(&d, &d), dot(&d, &oc)];
    let c = dot(&oc, &oc).plus(exactly(r).times(exactly(-r)));
    let discriminant = h.times(h).plus(a.times(c).times(exactly(-1.0)));
    let (_, of) = coefficients(center, r, ray);
    by_q(of, discriminant.0[0], t_min, t_max)?;
    by_q(of, of[1] * of[1] - of[0] * of[2], t_min, t_max)
}

/// A number that lies between two, of which the first is not greater.
#[derive(Clone, Copy)]
struct Bounds([f64; 2]);

impl Bounds {
    fn plus(self, other: Self) -> Self {
        let [[least, most], [low, high]] = [self.0, other.0];
        Self::around([least + low, most + high])
    }

    fn times(self, other: Self) -> Self {
        let products = self.0.into_iter().flat_map(|x| other.0.map(|y| x * y));
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        Self::around(products.fold(start, |[low, high], x| [x.min(low), x.max(high)]))
    }

    /// One step wider on each side, which holds what rounding took.
    fn around([least, most]: [f64; 2]) -> Self {
        Self([least.next_down(), most.next_up()])
    }
}
