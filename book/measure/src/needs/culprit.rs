//! Blame: from the first wrong pixel to the ray and the sphere at which a method errs.

use crate::accuracy::{exact, ulps_off};
use crate::wrong_pixels::MethodView;
use common::rtweekend::*;
use speed_vs_accuracy::{Arithmetic, Case, Hit, Method, Scene};

/// The ray and the sphere about which a method errs in a scene's first wrong pixel, with that
/// pixel.
pub struct Culprit {
    /// The column and the row of the pixel, counted from 0 at the top left.
    pub pixel: [u32; 2],
    /// The color of the pixel as the method draws it, then the right one: red, green and blue, in
    /// levels from 0 to 255.
    pub colors: [[u8; 3]; 2],
    /// The index of the sphere in [`Scene::spheres`], from 0.
    pub sphere: usize,
    /// True if the ray leads from a hit point to the sun, false if it comes from the camera.
    pub is_to_sun: bool,
    /// True if the method sees the right sphere, but in the shadow instead of the sun, or the other
    /// way.
    pub is_shadow: bool,
    /// The ray and the sphere, in `f64`.
    pub case: Case,
    /// The excluded lower end of the range of t, in lengths of the direction; the upper end is
    /// infinite.
    pub t_min: f64,
    /// The error of the method's t in ulps, without sign: infinite if the method misses where there
    /// is a hit, or hits where there is none.
    pub error: f64,
}

impl Culprit {
    /// Finds the ray and the sphere to blame for the first wrong pixel, in reading order, of
    /// `view`, a picture of `scene` at its own width. Returns `None` if no pixel is wrong, or no
    /// sphere is involved.
    pub fn of(scene: &Scene, view: &MethodView) -> Option<Self> {
        let pixel @ [i, j] = view.first_wrong?;
        let ray = Camera::new(scene.width).ray(i, j);
        let [seen, right] =
            [Arithmetic::Method(view.method), Arithmetic::Exact].map(|it| scene.look(it, &ray));
        let from_eye = [seen.hit, right.hit].map(|hit| hit.map(|hit| hit.sphere));
        // It may have seen the right sphere, and asked about another ray to the sun
        // because its point is elsewhere: then that answer is right, and the one to
        // blame is that of the camera's ray.
        let shaded = seen.hit.zip(right.hit).filter(|(seen, right)| {
            let differ = seen.shaded_by.is_some() != right.shaded_by.is_some();
            seen.sphere == right.sphere && differ
        });
        let to_sun = shaded.and_then(|(seen, right)| {
            let ray = Ray::new(seen.point, scene.sun?);
            let spheres = [seen, right].map(|hit: Hit| hit.shaded_by);
            worst(scene, &view.method, ray, scene.t_min[1], spheres)
                .filter(|(_, error)| error.is_infinite())
        });
        let is_to_sun = to_sun.is_some();
        let t_min = scene.t_min[usize::from(is_to_sun)];
        let ((sphere, case), error) =
            to_sun.or_else(|| worst(scene, &view.method, scene.ray(&ray), t_min, from_eye))?;
        let color = |color: Color| {
            let mut pixel = [0; 3];
            write_color(&mut pixel, color);
            pixel
        };
        Some(Self {
            pixel,
            colors: [color(seen.color), color(right.color)],
            sphere,
            is_to_sun,
            is_shadow: shaded.is_some(),
            case,
            t_min,
            error,
        })
    }
}

/// Finds the sphere, of those that are seen or should be, about which the method errs most. Returns
/// its index, the case, and the error in ulps.
fn worst(
    scene: &Scene,
    method: &Method,
    ray: Ray,
    t_min: f64,
    spheres: [Option<usize>; 2],
) -> Option<((usize, Case), f64)> {
    let found = spheres.into_iter().flatten().map(|sphere| {
        let (center, radius) = scene.spheres[sphere];
        let case = Case::new(center, radius, ray);
        ((sphere, case), error(method, &case, t_min))
    });
    found.max_by(|(_, one), (_, other)| one.total_cmp(other))
}

/// Returns how many ulps t is off; infinity if only one of the method and the exact answer hits, 0
/// if neither does.
fn error(method: &Method, case: &Case, t_min: f64) -> f64 {
    let precision = method.precision();
    let exact = exact(&case.rounded(precision));
    let root = exact
        .as_ref()
        .and_then(|exact| exact.nearest_root_in(t_min, f64::INFINITY));
    match (case.put_to(method, t_min, f64::INFINITY), root) {
        (Some(t), Some(root)) => ulps_off(root, precision, t),
        (None, None) => 0.0,
        _ => f64::INFINITY,
    }
}
