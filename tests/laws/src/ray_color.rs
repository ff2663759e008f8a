//! Laws for `ray_color`, which picks a color for what a ray meets: asked also about rays that the
//! book's camera never casts, because its eye is at the origin and outside of everything.

use common::rtweekend::*;
use proptest::prelude::*;
use proptest::sample::select;

use crate::camera::{CameraPixel, height};
use crate::case::{Case, code, numbers_of_ray, point_at, ray_from};
use crate::nearer_root::{BAND, U};
use crate::oracle::ExactCase;
use crate::record::normal_bound;
use crate::verdict::{BrokenLaw, LawResult};

/// The scene of a chapter: what a ray can meet there, and the colors that a law for `ray_color`
/// expects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChapterScene {
    /// The sky of chapter 1, without a sphere.
    Sky,
    /// The disc of chapter 2: red where the ray's line meets the sphere, in front of the ray's
    /// origin or behind it, and else the sky.
    Disc,
    /// The sphere of chapters 3 and 4, in the colors of its outward normals where the nearer root
    /// is positive, and the sky elsewhere.
    Ball,
    /// The sphere and the ground of chapter 5, in the colors of the normals that point against the
    /// ray, and the sky elsewhere.
    List,
}

/// Tests that `color`, which a chapter's `ray_color` returned for `ray`, is the color of what the
/// ray meets in the scene, wherever the ray starts, in each component: one that is too large becomes
/// the level 255 of a right picture, too.
///
/// Makes no claim where rounding may decide about a hit, or, in a scene with spheres, where a
/// number of the ray is infinite or NaN.
pub fn a_ray_has_its_color_from_anywhere(
    scene: ChapterScene,
    color: Color,
    ray: &Ray,
) -> LawResult {
    let Some((right, bound)) = scene.expected(ray) else {
        return Ok(());
    };
    let components = ["red", "green", "blue"].into_iter().zip(color.to_array());
    let mut components = components.zip(right.to_array());
    let is_near = |found: f64, right: f64| (found - right).abs() <= bound;
    let wrong = components.find(|&((_, found), right)| !is_near(found, right));
    let Some(((component, found), allowed)) = wrong else {
        return Ok(());
    };
    let Ray { origin, direction } = ray;
    let rounding = if bound == 0.0 {
        String::new()
    } else {
        format!(" ± {bound:.1e}")
    };
    Err(BrokenLaw {
        law: "a ray has the color of what it meets, from wherever it starts".into(),
        found: format!(
            "{component} = {found:?}, in {color:.4} for the ray from {origin} along {direction}"
        ),
        allowed: format!("{component} = {allowed:?}{rounding}, in {right:.4}"),
        read: "chapter 3: what t counts, and which t is in front".into(),
    })
}

impl ChapterScene {
    /// Returns true if the rays of the book's picture, 32 pixels wide, have the right levels of red,
    /// green and blue, or the right colors. Where they have not, the picture shows it, and a step on
    /// the way to the chapter may mean it.
    pub(crate) fn looks_right(self, ray_color: &dyn Fn(&Ray) -> Color) -> bool {
        let levels = |color: Color| color.to_array().map(|part| (255.999 * part) as u8);
        let (width, height) = (32, height(32));
        let pixels = (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
        let rays = pixels.map(|(i, j)| CameraPixel { width, i, j }.expected_ray());
        rays.into_iter().all(|ray| {
            let color = ray_color(&ray);
            let right = self.expected(&ray);
            right.is_none_or(|(right, _)| levels(color) == levels(right))
                || a_ray_has_its_color_from_anywhere(self, color, &ray).is_ok()
        })
    }

    /// Writes the body of a test that asks about this ray again.
    pub(crate) fn as_test(self, ray: &Ray) -> String {
        let ray = code(&numbers_of_ray(*ray));
        format!(
            "let ray = {ray};\nlet law = laws::ray_color::a_ray_has_its_color_from_anywhere;\n\
             laws::holds(law(laws::ChapterScene::{self:?}, ray_color(&ray), &ray));"
        )
    }

    /// Lists center and radius of each sphere in the scene.
    fn spheres(self) -> &'static [(Point3, f64)] {
        const SPHERES: [(Point3, f64); 2] = [
            (Point3::new(0.0, 0.0, -1.0), 0.5),
            (Point3::new(0.0, -100.5, -1.0), 100.0),
        ];
        match self {
            Self::Sky => &[],
            Self::Disc | Self::Ball => &SPHERES[..1],
            Self::List => &SPHERES,
        }
    }

    /// Returns the color of what a ray meets, by exact arithmetic, and how far rounding may take a
    /// component from it; `None` where rounding may decide about the hit.
    fn expected(self, ray: &Ray) -> Option<(Color, f64)> {
        let mut nearest: Option<(f64, Case)> = None;
        for &(center, radius) in self.spheres() {
            let case = Case::new(center, radius, *ray);
            let exact = ExactCase::of_finite(&case)?;
            if exact.discriminant_margin().abs() <= BAND {
                return None;
            }
            let root = match self {
                Self::List => exact.nearest_root_in(0.0, f64::INFINITY),
                Self::Ball => exact.nearer_root().filter(|root| *root > 0.0),
                Self::Sky | Self::Disc => exact.nearer_root(),
            };
            let hit = root.map(|root| (root.rounded(), case));
            nearest = nearest
                .into_iter()
                .chain(hit)
                .min_by(|(one, _), (other, _)| one.total_cmp(other));
        }
        Some(match nearest {
            // The length and the quotient, two products, a sum and a difference for each component.
            None => (sky(ray), 16.0 * U),
            Some(_) if self == Self::Disc => (Vec3::X, 0.0),
            Some((t, case)) => {
                let outward = (point_at(ray, t) - case.center) / case.radius;
                let is_turned = self == Self::List && ray.direction.dot(outward) >= 0.0;
                let normal = if is_turned { -outward } else { outward };
                (0.5 * (normal + Vec3::ONE), normal_bound(&case))
            }
        })
    }
}

/// Returns the color of the sky of chapter 1, written out.
fn sky(ray: &Ray) -> Color {
    let a = 0.5 * (ray.direction.y / ray.direction.length() + 1.0);
    (1.0 - a) * Vec3::ONE + a * Vec3::new(0.5, 0.7, 1.0)
}

/// Makes the rays that a `ray_color` is asked: from the eye and farther in front of the sphere, from
/// behind, beside and above it, from inside, and from far away, past it and at it, with directions
/// so long that t is small, and so short that it is in the thousands.
pub fn rays() -> impl Strategy<Value = Ray> {
    let v = Vec3::new;
    let from = vec![
        v(0.0, 0.0, 0.0),
        v(0.0, 0.0, -3.0),
        v(2.0, 1.0, 0.5),
        v(-3.0, 0.5, -1.5),
        v(0.5, 4.0, -1.0),
        v(0.1, 0.2, -1.1),
        v(300.0, 200.0, 4000.0),
    ];
    let to = vec![
        v(0.0, 0.0, -1.0),
        v(0.25, 0.125, -1.0),
        v(-0.125, -0.25, -0.875),
        v(0.0, 1.0, -1.0),
        v(2.0, -0.5, -3.0),
    ];
    let lengths = vec![1.0, -1.0, 3.0, 0.25, -0.5, 2.0, f64::exp2(-12.0)];
    (select(from), select(to), select(lengths))
        // A sum with 0 is no −0, which would be hard to read.
        .prop_map(|(from, to, length)| ray_from(from, Vec3::ZERO + length * (to - from)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Complaint, Trial};

    /// All levels of blue end at 255, so no picture shows a white of (1, 1, 2).
    #[test]
    fn a_component_that_is_too_large_is_told_although_the_picture_is_right() {
        let too_blue = |ray: &Ray| sky(ray).with_z(2.0 - (1.0 - sky(ray).x));
        let outcome = Trial::default().ray_color(ChapterScene::Sky, &too_blue);
        let Err(Complaint::Broken(report)) = outcome else {
            panic!("{outcome:?}");
        };
        assert!(report.broken.found.starts_with("blue = 1.75, "), "{report}");
    }
}
