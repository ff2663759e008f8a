//! A plane of the scene on the sheet.

use common::rtweekend::*;
use glam::DVec2;

/// Takes points of the plane that x and y span to the sheet, where y points
/// down.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    /// Where (0, 0, z) is on the sheet.
    pub(crate) origin: DVec2,
    /// Units of the sheet for each unit of the scene.
    pub(crate) scale: f64,
}

impl Plane {
    pub(crate) fn new(x: f64, y: f64, scale: f64) -> Self {
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
}
