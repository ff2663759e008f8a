//! A plane of the scene on the sheet, and rays in it.

use common::rtweekend::*;
use glam::DVec2;

use crate::svg::{Anchor, Svg};

/// A map from the plane of x and y in the scene to the sheet, where y points down, and back.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    /// The place on the sheet of the scene's (0, 0, z).
    pub(crate) origin: DVec2,
    /// The length on the sheet of a unit of the scene.
    pub(crate) scale: f64,
}

impl Plane {
    /// Makes the map that takes the scene's origin to (x, y) of the sheet.
    pub(crate) const fn new(x: f64, y: f64, scale: f64) -> Self {
        let origin = DVec2::new(x, y);
        Self { origin, scale }
    }

    /// Returns the place on the sheet of a point of the scene.
    pub(crate) fn point(&self, point: Point3) -> DVec2 {
        self.origin + self.vector(point)
    }

    /// Returns a vector of the scene as a vector on the sheet.
    pub(crate) fn vector(&self, vector: Vec3) -> DVec2 {
        self.scale * DVec2::new(vector.x, -vector.y)
    }

    /// Returns the point of the scene, with z = 0, at a place on the sheet.
    pub(crate) fn place(&self, at: DVec2) -> Point3 {
        let way = (at - self.origin) / self.scale;
        xy(way.x, -way.y)
    }

    /// Returns the least and the greatest t for which the line of `ray` lies on a sheet of that
    /// `size`, without a margin of 14; `None` if no part of the line does.
    pub(crate) fn on_sheet(&self, ray: &Ray, size: DVec2) -> Option<(f64, f64)> {
        let (from, along) = (self.point(ray.origin), self.vector(ray.direction));
        let margin = DVec2::splat(14.0);
        let (one, other) = ((margin - from) / along, (size - margin - from) / along);
        let (first, last) = (one.min(other).max_element(), one.max(other).min_element());
        let is_a_way = first < last && first.is_finite() && last.is_finite();
        is_a_way.then_some((first, last))
    }

    /// Draws the line of `ray` on a sheet of that `size`: dashed behind its origin, and ahead as an
    /// arrow up to where t is `end`, or to the rim.
    pub(crate) fn draw_line(&self, svg: &mut Svg, ray: &Ray, size: DVec2, end: f64) {
        let Some((first, last)) = self.on_sheet(ray, size) else {
            return;
        };
        let at = |t| self.point(ray.at(t));
        svg.line("ray dashed", at(first), at(last.min(0.0)));
        if last > 0.0 {
            svg.arrow("ray line", at(first.max(0.0)), at(last.min(end)));
        }
    }

    /// Draws the origin **Q** of `ray`, and its direction **d** as an arrow from there.
    pub(crate) fn draw_ray(&self, svg: &mut Svg, ray: &Ray) {
        let [q, tip] = [0.0, 1.0].map(|t| self.point(ray.at(t)));
        svg.vector("ray", q, tip, "**d**");
        svg.dot("ray", q, Anchor::Below, "**Q**");
    }
}

/// Makes a point or a vector of the plane z = 0.
pub(crate) const fn xy(x: f64, y: f64) -> Vec3 {
    Vec3::new(x, y, 0.0)
}

/// Makes a ray in the plane. A `direction` without a length becomes (0.05, 0), one step of a
/// slider.
pub(crate) fn ray(origin: Point3, direction: Vec3) -> Ray {
    let shortest = xy(0.05, 0.0);
    let has_length = direction != Vec3::ZERO;
    Ray::new(origin, if has_length { direction } else { shortest })
}

/// Returns the t at which the line of `ray` is nearest to `point`.
pub(crate) fn nearest(ray: &Ray, point: Point3) -> f64 {
    ray.direction.dot(point - ray.origin) / ray.direction.length_squared()
}

/// Finds all t at which the line of `ray` meets a sphere, in rising order. `nearer` finds the
/// nearer root of a ray; the farther one is the nearer one of the ray turned round.
pub(crate) fn roots(ray: &Ray, nearer: impl Fn(&Ray) -> Option<f64>) -> Vec<f64> {
    let turned = Ray::new(ray.origin, -ray.direction);
    let farther = nearer(&turned).map(|t| -t);
    let mut roots: Vec<f64> = nearer(ray).into_iter().chain(farther).collect();
    roots.dedup();
    roots
}
