//! How a list finds the nearest hit.

use common::rtweekend::*;
use glam::DVec2;
use hittable_list::{Hittable, HittableList, Sphere};

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg, spoken};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "nearest",
    title: "The nearest hit wins",
    description: "A ray passes through two spheres that overlap. Below, a bar for each step of the \
        list shows which t still count. At first all t above 0 do. The first sphere is hit, and \
        the bar ends there. The second one is hit nearer, and the bar ends there. \
        Nothing beyond is left to find.",
    caption: "A list asks each sphere in turn, and each hit shortens the interval for the next. \
        What is behind the nearest hit so far can no longer win.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Debug)]
pub struct Parameters {
    /// The spheres, in the order of the list, in the plane of x and y.
    pub spheres: Vec<(Point3, f64)>,
    /// A ray in the same plane.
    pub ray: Ray,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            spheres: vec![
                (Point3::new(3.1, 0.3, 0.0), 0.8),
                (Point3::new(1.9, -0.3, 0.0), 0.7),
            ],
            ray: Ray::new(Point3::ZERO, Vec3::X),
        }
    }
}

/// Draws the spheres, and the interval after each of them.
pub fn draw(Parameters { spheres, ray }: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 272.0);
    let plane = Plane::new(24.0, 94.0, 82.0);
    let end = 4.25;
    for &(center, radius) in spheres {
        svg.circle("sphere area", plane.point(center), plane.scale * radius);
    }
    svg.arrow(
        "ray line",
        plane.point(ray.origin),
        plane.point(ray.at(end)),
    );
    svg.circle("ray solid", plane.point(ray.origin), 4.5);

    let mut world = HittableList::default();
    let mut closest_so_far = f64::INFINITY;
    let step = |svg: &mut Svg, y: f64, to: f64, words: &str| {
        let shown = plane.point(ray.at(to.min(end)));
        let from = DVec2::new(plane.origin.x, y);
        let tip = DVec2::new(shown.x, y);
        if to < end {
            svg.line("ray bold", from, tip);
            svg.line(
                "ray line",
                tip - DVec2::new(0.0, 6.0),
                tip + DVec2::new(0.0, 6.0),
            );
            svg.line(
                "ray dashed",
                shown + DVec2::new(0.0, 6.0),
                tip - DVec2::new(0.0, 6.0),
            );
            svg.label("ink", tip + DVec2::new(10.0, 5.0), Anchor::Start, words);
        } else {
            svg.arrow("ray bold", from, tip);
            svg.label("ink", from - DVec2::new(0.0, 9.0), Anchor::Start, words);
        }
    };
    step(&mut svg, 194.0, closest_so_far, "0 < *t* < ∞");
    for (&(center, radius), n) in spheres.iter().zip(1..) {
        world.add(Sphere::new(center, radius));
        svg.label(
            "sphere",
            plane.point(center) + DVec2::new(0.0, 5.0),
            Anchor::Middle,
            &n.to_string(),
        );
        if let Some(hit) = world.hit(ray, 0.0, closest_so_far) {
            closest_so_far = hit.t;
            svg.circle("ray hollow", plane.point(ray.at(hit.t)), 5.0);
        }
        let y = 194.0 + 30.0 * f64::from(n);
        let words = format!("*t* < {} after sphere {n}", spoken(closest_so_far));
        step(&mut svg, y, closest_so_far, &words);
    }
    svg.finish()
}
