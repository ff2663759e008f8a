//! Figure 5 of the notes: how often a line meets a sphere.

use normals::hit_sphere;

use crate::vocabulary::*;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "roots",
    title: "No root, one root, two roots",
    description: "Three rays run from left to right. The highest one passes above the sphere: no \
        root. The second one touches it in a single point: one root. The third one goes in and \
        comes out again: two roots, each marked with its t.",
    caption: "The discriminant *b*² − 4*ac* counts the roots. If it is negative, the ray misses; if it is zero, the ray \
        touches; if it is positive, the ray goes in at the smaller *t* and comes out at the larger.",
    draw,
};

/// The sphere, in the plane of x and y.
const CENTER: Point3 = Point3::new(2.0, 0.0, 0.0);
const RADIUS: f64 = 1.0;

/// Draws the sphere, and each ray with what it meets.
fn draw() -> String {
    let mut svg = FIGURE.sheet(256.0);
    let plane = Plane::new(16.0, 164.0, 74.0);
    svg.circle("sphere area", plane.point(CENTER), plane.scale * RADIUS);
    for y in [1.65, 1.0, 0.0] {
        let ray = Ray::new(xy(0.0, y), Vec3::X);
        let roots = roots(&ray, |ray| hit_sphere(CENTER, RADIUS, ray));
        let at = |t| plane.point(ray.at(t));
        svg.circle("ray solid", at(0.0), 3.5);
        svg.arrow("ray line", at(0.0), at(3.7));
        for &t in &roots {
            svg.circle("ray hollow", at(t), 5.0);
            let is_left = ray.at(t).x < CENTER.x;
            let anchor = if is_left { UpperLeft } else { UpperRight };
            svg.label("ink", at(t), anchor, &format!("*t* = {}", spoken(t)));
        }
        let counts = [("no root", '<'), ("one root", '='), ("two roots", '>')];
        let (count, sign) = counts[roots.len()];
        let beside = at(3.8) + spot(2.0, -2.0);
        svg.label("ink", beside, Start, count);
        let words = format!("*b*² − 4*ac* {sign} 0");
        svg.small_label("faint", beside.down(16.0), Start, &words);
    }
    svg.finish()
}

/// All t at which the line of `ray` meets what `nearer` finds: the farther one is the nearer
/// one of the ray turned round.
pub(crate) fn roots(ray: &Ray, nearer: impl Fn(&Ray) -> Option<f64>) -> Vec<f64> {
    let turned = Ray::new(ray.origin, -ray.direction);
    let farther = nearer(&turned).map(|t| -t);
    let mut roots: Vec<f64> = nearer(ray).into_iter().chain(farther).collect();
    roots.dedup();
    roots
}
