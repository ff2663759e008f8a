//! A plane of the scene on the sheet.

use common::rtweekend::*;
use glam::DVec2;

/// Takes points of the plane that x and y span to the sheet, where y points
/// down, and back.
pub(crate) struct Plane {
    /// Where (0, 0, z) is on the sheet.
    pub(crate) origin: DVec2,
    /// Units of the sheet for each unit of the scene.
    pub(crate) scale: f64,
}

impl Plane {
    pub(crate) const fn new(x: f64, y: f64, scale: f64) -> Self {
        Self {
            origin: DVec2::new(x, y),
            scale,
        }
    }

    /// A point of the scene on the sheet.
    pub(crate) fn point(&self, point: Point3) -> DVec2 {
        self.origin + self.vector(point)
    }

    /// A vector of the scene on the sheet.
    pub(crate) fn vector(&self, vector: Vec3) -> DVec2 {
        self.scale * DVec2::new(vector.x, -vector.y)
    }

    /// The point of the scene, with z = 0, that is there on the sheet.
    pub(crate) fn place(&self, at: DVec2) -> Point3 {
        let way = (at - self.origin) / self.scale;
        Point3::new(way.x, -way.y, 0.0)
    }

    /// The least and the greatest t at which the line of `ray` is on a sheet of that
    /// `size`, a margin of 14 left out; `None` if it never is.
    pub(crate) fn on_sheet(&self, ray: &Ray, size: DVec2) -> Option<(f64, f64)> {
        let (from, along) = (self.point(ray.origin), self.vector(ray.direction));
        let margin = DVec2::splat(14.0);
        let (one, other) = ((margin - from) / along, (size - margin - from) / along);
        let (first, last) = (one.min(other).max_element(), one.max(other).min_element());
        let is_a_way = first < last && first.is_finite() && last.is_finite();
        is_a_way.then_some((first, last))
    }
}
