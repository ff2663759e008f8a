//! Shadows in exact arithmetic: what a ray meets that leaves a hit point, which no
//! floating-point number can name.
//!
//! A ray meets a sphere at t = (h − √D) / a with integers a, h and D. So the point there,
//! times a, has coordinates p + q·√D with integers p and q. Sums and products of such
//! numbers are such numbers again, and the sign of one is a question about integers: p²
//! against q²·D. Nothing rounds, and no question is too hard.

use std::cmp::Ordering;

use common::rtweekend::*;
use dashu_int::{IBig, UBig};
use speed_vs_accuracy::Case;

use laws::oracle::{dot, integers};

/// A sphere by its center and its radius.
pub type Ball = (Point3, f64);

/// A ray, its nearer root on a sphere, and where it goes on from there.
#[derive(Clone, Debug)]
pub struct ExactDeparture {
    case: Case,
    direction: [IBig; 3],
}

impl ExactDeparture {
    /// From the point where the line of `case` first meets its sphere, along `direction`.
    ///
    /// # Panics
    /// If a number is not finite.
    pub fn new(case: Case, direction: Vec3) -> Self {
        let (direction, _) = integers(direction.to_array()).expect(FINITE);
        Self { case, direction }
    }

    /// Whether the ray that starts at the point itself meets `ball` at a t above 0.
    ///
    /// The sphere that it leaves may be asked about too: it is met by a ray that goes in.
    ///
    /// # Panics
    /// If the line of the case has no root, or a number is not finite.
    pub fn meets(&self, ball: Ball) -> bool {
        let (root, [x, y, z], radius) = self.towards(ball);
        let e = &self.direction;
        let h = x.times(&e[0]).plus(&y.times(&e[1])).plus(&z.times(&e[2]));
        let [xx, yy, zz] = [&x, &y, &z].map(|n| root.product(n, n));
        let c = xx.plus(&yy).plus(&zz).minus(radius.sqr());
        let less = c.times(&-dot(e, e));
        let discriminant = root.product(&h, &h).plus(&less);
        match root.sign(&c) {
            Ordering::Less => true,
            Ordering::Equal => root.sign(&h).is_gt(),
            Ordering::Greater => root.sign(&h).is_gt() && root.sign(&discriminant).is_ge(),
        }
    }

    /// The way from the point P to the center B of a ball, a·(B − P), with a times its
    /// radius, and the D of the numbers.
    fn towards(&self, (center, radius): Ball) -> (Root, [Number; 3], IBig) {
        let [cx, cy, cz, r, qx, qy, qz, dx, dy, dz] = self.case.numbers();
        let [bx, by, bz] = center.to_array();
        let lengths = [cx, cy, cz, r, qx, qy, qz, bx, by, bz, radius];
        let ([cx, cy, cz, r, qx, qy, qz, bx, by, bz, radius], _) = integers(lengths).expect(FINITE);
        let (d, _) = integers([dx, dy, dz]).expect(FINITE);

        let oc = [cx - &qx, cy - &qy, cz - &qz];
        let (a, h) = (dot(&d, &d), dot(&d, &oc));
        let discriminant = h.sqr() - &a * (dot(&oc, &oc) - r.sqr());
        let has_root = discriminant >= IBig::ZERO && a > IBig::ZERO;
        assert!(has_root, "the ray meets nothing to leave: {}", self.case);

        // a·P is a·Q + (h − √D)·d.
        let ob = [bx - qx, by - qy, bz - qz];
        let way = std::array::from_fn(|k| Number {
            p: &a * &ob[k] - &h * &d[k],
            q: d[k].clone(),
        });
        (Root(discriminant), way, a * radius)
    }
}

const FINITE: &str = "shadows are cast by finite numbers";

/// p + q·√D.
#[derive(Clone, Debug)]
struct Number {
    p: IBig,
    q: IBig,
}

impl Number {
    fn plus(&self, other: &Self) -> Self {
        Self {
            p: &self.p + &other.p,
            q: &self.q + &other.q,
        }
    }

    fn minus(mut self, n: UBig) -> Self {
        self.p -= n;
        self
    }

    fn times(&self, n: &IBig) -> Self {
        Self {
            p: &self.p * n,
            q: &self.q * n,
        }
    }
}

/// The D below the root.
struct Root(IBig);

impl Root {
    fn product(&self, x: &Number, y: &Number) -> Number {
        Number {
            p: &x.p * &y.p + &x.q * &y.q * &self.0,
            q: &x.p * &y.q + &x.q * &y.p,
        }
    }

    /// The number against zero: the sign of the larger of its two terms.
    fn sign(&self, Number { p, q }: &Number) -> Ordering {
        let size = |n: &IBig| n * n;
        match size(p).cmp(&(size(q) * &self.0)) {
            Ordering::Greater => p.cmp(&IBig::ZERO),
            Ordering::Less => q.cmp(&IBig::ZERO),
            // They add up to twice one of them, or to nothing.
            Ordering::Equal if p.sign() == q.sign() => p.cmp(&IBig::ZERO),
            Ordering::Equal => Ordering::Equal,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use laws::oracle::Exact;

    /// The points of contact of a ray with whole numbers, from which an oracle that knows
    /// no roots can tell as well.
    #[test]
    fn is_that_of_a_point_with_whole_coordinates() {
        let towards = [1.0, 2.0, -1.0, 0.0, -3.0];
        for (x, y, z) in [(3.0, 4.0, 12.0), (-12.0, 3.0, 4.0), (5.0, -12.0, 0.0)] {
            let point = Point3::new(x, y, z);
            let radius = point.length();
            let looked = Case {
                center: Point3::ZERO,
                radius,
                ray: Ray::new(3.0 * point, -2.0 * point),
            };
            for (dx, dy) in towards.iter().flat_map(|dx| towards.map(|dy| (*dx, dy))) {
                let direction = Vec3::new(dx, dy, 1.0);
                let exact = ExactDeparture::new(looked, direction);
                for center in [Point3::ZERO, Point3::new(7.0, 9.0, 30.0), 2.0 * point] {
                    let ray = Ray::new(point, direction);
                    let from_there = Case {
                        center,
                        radius,
                        ray,
                    };
                    let root = Exact::of(&from_there);
                    let is_met = root.nearest_root_in(0.0, f64::INFINITY).is_some();
                    assert_eq!(exact.meets((center, radius)), is_met, "{from_there}");
                }
            }
        }
    }
}
