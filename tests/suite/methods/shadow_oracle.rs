//! The shadows of hit points in exact arithmetic, against points that are numbers and
//! against tangents that are known.

use common::rtweekend::*;
use laws::Case;
use laws::oracle::Exact;
use laws::shadow::ExactDeparture;

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
            for ball in [Point3::ZERO, Point3::new(7.0, 9.0, 30.0), 2.0 * point] {
                let from_there = Case {
                    center: ball,
                    radius,
                    ray: Ray::new(point, direction),
                };
                let expected = Exact::of(&from_there)
                    .nearest_root_in(0.0, f64::INFINITY)
                    .is_some();
                assert_eq!(exact.meets((ball, radius)), expected, "{from_there}");
            }
        }
    }
}

/// The point is (√¾, ½, 0), and the tangent there is (−½, √¾, 0), which no `f64` is.
#[test]
fn tells_the_neighbors_of_an_irrational_tangent() {
    let looked = Case {
        center: Point3::ZERO,
        radius: 1.0,
        ray: Ray::new(Point3::new(2.0, 0.5, 0.0), Vec3::NEG_X),
    };
    let root = 0.75_f64.sqrt();
    let [below, above] = if root.mul_add(root, -0.75) < 0.0 {
        [root, root.next_up()]
    } else {
        [root.next_down(), root]
    };
    let goes_in = |up: f64| {
        let direction = Vec3::new(-0.5, up, 0.0);
        ExactDeparture::new(looked, direction).meets((looked.center, looked.radius))
    };
    assert!(goes_in(below) && !goes_in(above));
}
