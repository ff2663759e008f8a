//! Ray casting by a method of choice: a scene as it looks with rounding, and without.

use common::rtweekend::*;

use super::case::Case;
use crate::method::Method;
use crate::nearest::certified_nearest;
use crate::precision::Precision;

/// A scene to be drawn by any method: some spheres, and a camera that looks at them.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The name of the scene in tables: one word.
    pub name: String,
    /// The usual width of its picture, in pixels; the picture is 16:9.
    pub width: u32,
    /// The unit vector towards the sun, or `None` if nothing casts a shadow.
    pub sun: Option<Vec3>,
    /// The `t` after which a hit counts, in lengths of the direction: first along rays of the
    /// camera, then along rays to the sun, which would else hit the surface where they start.
    pub t_min: [f64; 2],
    /// The lens of the camera: the eye's place, and its view of the spheres.
    pub lens: Lens,
    /// The spheres, center and radius of each; at least one.
    pub spheres: Vec<(Point3, f64)>,
}

/// The `t_min` of a scene that names none: 0 for the camera, and for shadows 0.001 as in the book's
/// later chapters.
pub const USUAL_T_MIN: [f64; 2] = [0.0, 1e-3];

impl Scene {
    /// Returns the scene of one star seen through a telescope, as far away for its size as a Sun at
    /// seven light-years.
    pub fn telescope() -> Self {
        Self {
            name: "telescope".to_owned(),
            width: 400,
            sun: None,
            t_min: USUAL_T_MIN,
            lens: Lens::new(Point3::ZERO, Vec3::NEG_Z, [33_554_432.0; 2]),
            spheres: vec![(Point3::new(0.25, -0.5, -1e8), 1.0)],
        }
    }

    /// Draws the picture, `width` pixels wide, by two kinds of arithmetic: the first for its left
    /// half, the second for its right half. The middle column of an odd width is in the left half.
    pub fn seen_by(&self, halves: [Arithmetic; 2], width: u32) -> Picture {
        let (scene, camera) = (self.clone(), Camera::new(width));
        Picture::paint(camera.image_width, camera.image_height, move |i, j| {
            let arithmetic = halves[usize::from(2 * i >= width)];
            scene.look(arithmetic, &camera.ray(i, j)).color
        })
    }

    /// Returns true if `precision` can hold the scene at its own width: no number of the scene or
    /// its rays becomes infinite, and no radius or direction 0.
    pub fn fits(&self, precision: Precision) -> bool {
        let camera = Camera::new(self.width);
        let [right, bottom] = [camera.image_width - 1, camera.image_height - 1];
        let corners = [(0, 0), (right, 0), (0, bottom), (right, bottom)];
        let mut rays: Vec<Ray> = corners.map(|(i, j)| self.ray(&camera.ray(i, j))).into();
        rays.extend(self.sun.map(|sun| Ray::new(Point3::ZERO, sun)));
        self.spheres.iter().all(|&(center, radius)| {
            rays.iter().all(|&ray| {
                let case = Case::new(center, radius, ray).rounded(precision);
                let is_something = case.radius != 0.0 && case.ray.direction != Vec3::ZERO;
                is_something && case.numbers().iter().all(|number| number.is_finite())
            })
        })
    }

    /// Turns a ray of the book's camera into the scene's ray through the same pixel, as seen
    /// through the scene's lens.
    pub fn ray(&self, ray: &Ray) -> Ray {
        self.lens.ray(ray)
    }

    /// Computes the color and the first hit of the pixel through which `ray` goes, a ray of the
    /// book's camera; the [`Lens`] turns it into the scene's own ray. A hit has the color of its
    /// normal, darker in shadow; a miss has that of the sky along `ray`, without the lens.
    pub fn look(&self, arithmetic: Arithmetic, ray: &Ray) -> Sight {
        let Some((sphere, case, t)) = self.nearest(arithmetic, &self.ray(ray), self.t_min[0])
        else {
            return Sight {
                hit: None,
                color: sky(ray),
            };
        };
        let point = case.point(t, arithmetic.precision());
        let normal = (point - case.center) / case.radius;
        let color = 0.5 * (normal + Vec3::ONE);
        let shaded_by = self.sun.and_then(|sun| {
            let (sphere, ..) = self.nearest(arithmetic, &Ray::new(point, sun), self.t_min[1])?;
            Some(sphere)
        });
        Sight {
            hit: Some(Hit {
                sphere,
                t,
                point,
                shaded_by,
            }),
            color: if shaded_by.is_some() {
                0.4 * color
            } else {
                color
            },
        }
    }

    /// Returns the index of the sphere that is hit first, its case, and `t`; `None` if all are
    /// missed.
    fn nearest(&self, arithmetic: Arithmetic, ray: &Ray, t_min: f64) -> Option<(usize, Case, f64)> {
        let case = |&(center, radius): &(Point3, f64)| Case {
            center,
            radius,
            ray: *ray,
        };
        let cases = self.spheres.iter().map(case);
        let cases: Vec<Case> = cases
            .map(|case| case.rounded(arithmetic.precision()))
            .collect();
        let (sphere, t) = match arithmetic {
            Arithmetic::Method(method) => nearest_by(&cases, &method, t_min),
            Arithmetic::Exact => first(&cases, t_min),
        }?;
        Some((sphere, cases[sphere], t))
    }
}

/// The color of a pixel, and the hit that gives this color.
#[derive(Clone, Copy, Debug)]
pub struct Sight {
    /// The first hit, or `None` for the sky.
    pub hit: Option<Hit>,
    /// The color of the pixel, each component from 0 to 1.
    pub color: Color,
}

/// The first hit of a ray in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// The index of the sphere in [`Scene::spheres`].
    pub sphere: usize,
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
    /// The point of the hit, computed from `t` and so not quite on the sphere.
    pub point: Point3,
    /// The index of the first sphere between the point and the sun; `None` if the sun reaches the
    /// point, or the scene has no sun.
    pub shaded_by: Option<usize>,
}

/// A lens before the book's camera: it moves the eye, turns its view and magnifies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    origin: Point3,
    /// The unit vectors to the right of the picture, to its top, and into it.
    right: Vec3,
    up: Vec3,
    forward: Vec3,
    /// The factors by which things look larger, across and upwards.
    zoom: [f64; 2],
}

impl Lens {
    /// Makes a lens at `origin` that looks along `direction`, which may have any length but 0. The
    /// two factors of `zoom`, across and upwards, tell how much larger things look than without a
    /// lens. The picture stands upright; that of an eye that looks straight up or down has −z at
    /// its top.
    pub fn new(origin: Point3, direction: Vec3, zoom: [f64; 2]) -> Self {
        let forward = unit(direction);
        let right = match forward {
            Vec3 { x: 0.0, z: 0.0, y } => Vec3::new(-y.signum(), 0.0, 0.0),
            Vec3 { x, z, .. } => unit(Vec3::new(-z, 0.0, x)),
        };
        Self {
            origin,
            right,
            up: right.cross(forward),
            forward,
            zoom,
        }
    }

    /// Returns the lens's ray for a ray of the book's camera, which looks along −z. With that
    /// direction and a zoom of 1, both have the same direction, to the bit.
    fn ray(&self, ray: &Ray) -> Ray {
        let [across, up] = self.zoom;
        let Vec3 { x, y, z } = ray.direction;
        let direction = (x / across) * self.right + (y / up) * self.up - z * self.forward;
        Ray::new(self.origin, direction)
    }
}

/// Returns the unit vector along `v`, which may be as long or short as numbers allow. `v` must not
/// be 0: the result is then NaN.
pub fn unit(v: Vec3) -> Vec3 {
    // Else its square might overflow, or underflow.
    let v = v / v.abs().max_element();
    v.normalize()
}

/// The arithmetic by which a scene's picture is computed: a method's own, or exact.
#[derive(Clone, Copy, Debug)]
pub enum Arithmetic {
    /// A method, in its own precision: as in chapter 5, it is asked about one sphere after the
    /// other.
    Method(Method),
    /// Exact arithmetic: no rounding decides what is hit, and `t` is rounded once, to `f64`.
    Exact,
}

impl Arithmetic {
    fn precision(&self) -> Precision {
        match self {
            Self::Method(method) => method.precision(),
            Self::Exact => Precision::Double,
        }
    }
}

/// Returns the index of the nearest sphere and `t` by the loop of chapter 5, with rounded answers
/// of `method`.
fn nearest_by(cases: &[Case], method: &Method, t_min: f64) -> Option<(usize, f64)> {
    let mut nearest = None;
    let mut closest_so_far = f64::INFINITY;
    for (sphere, case) in cases.iter().enumerate() {
        if let Some(t) = case.put_to(method, t_min, closest_so_far) {
            closest_so_far = t;
            nearest = Some((sphere, t));
        }
    }
    nearest
}

/// Returns the index of the nearest sphere and `t` without rounding errors, for cases of one ray;
/// `t` is rounded once.
fn first(cases: &[Case], t_min: f64) -> Option<(usize, f64)> {
    let spheres: Vec<(Point3, f64)> = cases
        .iter()
        .map(|case| (case.center, case.radius))
        .collect();
    let (sphere, _) = certified_nearest(&spheres, &cases.first()?.ray, t_min, f64::INFINITY)?;
    let t = cases[sphere].put_to(&Method::EXACT, t_min, f64::INFINITY)?;
    Some((sphere, t))
}
