//! Seven scenes, from the book's own to the hardest, as each method sees them.

use common::rtweekend::*;

use crate::case::Case;
use crate::method::Method;
use crate::nearest::certified_nearest;
use crate::precision::Precision;

/// Some spheres, and a camera that looks at them along the negative z axis.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// A word, for tables.
    pub name: &'static str,
    /// A few words, for charts.
    pub title: &'static str,
    /// Where the eye is.
    origin: Point3,
    /// How much of the book's view is seen: a lens, not the same both ways.
    zoom: [f64; 2],
    spheres: &'static [(Point3, f64)],
    /// Towards the sun, if it casts shadows.
    sun: Option<Vec3>,
}

/// All scenes, the book’s first.
pub const SCENES: [Scene; 7] = [
    Scene::BOOK,
    Scene::TELESCOPE,
    Scene::PLANET,
    Scene::GRAZING,
    Scene::INSIDE,
    Scene::SHADOWS,
    Scene::NEIGHBORS,
];

/// Shadow rays that hit closer than this are taken to hit where they start, as
/// in the book's later chapters.
const T_MIN_OF_SHADOWS: f64 = 1e-3;

impl Scene {
    /// The two spheres of the book.
    pub const BOOK: Self = Self {
        name: "book",
        title: "the book’s",
        origin: Point3::ZERO,
        zoom: [1.0; 2],
        spheres: &[
            (Point3::new(0.0, 0.0, -1.0), 0.5),
            (Point3::new(0.0, -100.5, -1.0), 100.0),
        ],
        sun: None,
    };

    /// As far as a star like the Sun at seven light-years.
    pub const TELESCOPE: Self = Self {
        name: "telescope",
        title: "a star in a telescope",
        zoom: [1.0 / 33_554_432.0; 2],
        spheres: &[(Point3::new(0.25, -0.5, -1e8), 1.0)],
        ..Self::BOOK
    };

    /// In meters, the eyes of someone who stands on the Earth.
    pub const PLANET: Self = Self {
        name: "planet",
        title: "the horizon of a planet",
        zoom: [1.0 / 256.0; 2],
        spheres: &[(Point3::new(-3000.0, -6_371_001.0, -2000.0), 6_371_000.0)],
        ..Self::BOOK
    };

    /// From as high as the balls are, so that a level ray touches them all. The
    /// lens is such that the round tops still look round.
    pub const GRAZING: Self = Self {
        name: "grazing",
        title: "a row of balls that a ray grazes",
        origin: Point3::new(0.0, 1.0, 0.0),
        zoom: [1.0 / 33_554_432.0, 1.0 / 1_125_899_906_842_624.0],
        spheres: &[
            (Point3::new(0.000_000_5, 0.0, -10.0), 1.0),
            (Point3::new(0.0, 0.0, -12.0), 1.0),
            (Point3::new(-0.000_000_5, 0.0, -14.0), 1.0),
        ],
        ..Self::BOOK
    };

    /// From inside a sphere.
    pub const INSIDE: Self = Self {
        name: "inside",
        title: "from inside",
        origin: Point3::new(0.5, 0.25, 0.125),
        spheres: &[(Point3::ZERO, 1.0)],
        ..Self::BOOK
    };

    /// Two spheres, and the rays that leave them for the sun.
    pub const SHADOWS: Self = Self {
        name: "shadows",
        title: "rays that leave a surface for the sun",
        spheres: &[
            (Point3::new(0.0, 0.0, -1.0), 0.5),
            (Point3::new(0.0, -10_000.5, -1.0), 10_000.0),
        ],
        sun: Some(Vec3::new(1.0, 0.25, 0.5)),
        ..Self::BOOK
    };

    /// The point that three balls share, so near that their surfaces are planes. Two
    /// of them meet below it, and the third stands above.
    pub const NEIGHBORS: Self = Self {
        name: "neighbors",
        title: "where three balls meet",
        zoom: [1.0 / 1_125_899_906_842_624.0; 2],
        spheres: &[
            (Point3::new(0.0, 4.0, -13.0), 5.0),
            (Point3::new(-2.0, -1.0, -12.0), 3.0),
            (Point3::new(2.0, -1.0, -12.0), 3.0),
        ],
        ..Self::BOOK
    };

    /// The picture at `width` pixels wide, by `method`: the loop of chapter 5 asks it
    /// about one sphere after the other.
    pub fn picture(self, method: Method, width: u32) -> Picture {
        self.seen_by(Eye::Method(method), width)
    }

    /// The picture that a method of that precision should draw: all numbers are
    /// rounded to it, and then nothing is, not even to tell which sphere is first.
    pub fn right_picture(self, precision: Precision, width: u32) -> Picture {
        self.seen_by(Eye::Exact(precision), width)
    }

    /// Left of the middle as one method sees it, right of it as another does.
    pub fn halves(self, left: Method, right: Method, width: u32) -> Picture {
        let eyes = [left, right].map(Eye::Method);
        let camera = Camera::new(width);
        Picture::paint(camera.image_width, camera.image_height, move |i, j| {
            self.color(eyes[usize::from(2 * i >= width)], &camera.ray(i, j))
        })
    }

    fn seen_by(self, eye: Eye, width: u32) -> Picture {
        let camera = Camera::new(width);
        Picture::paint(camera.image_width, camera.image_height, move |i, j| {
            // The block of pixels may hang over the edge.
            match i < width {
                true => self.color(eye, &camera.ray(i, j)),
                false => Color::ZERO,
            }
        })
    }

    /// The color of the nearest hit, darker where the sun does not reach it, or
    /// the sky.
    fn color(&self, eye: Eye, ray: &Ray) -> Color {
        let [across, up] = self.zoom;
        let Vec3 { x, y, z } = ray.direction;
        let ray = Ray::new(self.origin, Vec3::new(across * x, up * y, z));
        // Only the rays to the sun are of interest where there is one.
        let first_eye = match self.sun {
            Some(_) => Eye::Exact(eye.precision()),
            None => eye,
        };
        let Some((case, t)) = self.nearest(first_eye, &ray, 0.0) else {
            return sky(&Ray::new(self.origin, Vec3::new(x, y, z)));
        };
        let point = case.point(t, eye.precision());
        let normal = (point - case.center) / case.radius;
        let color = 0.5 * (normal + Vec3::ONE);
        let is_dark = self.sun.is_some_and(|sun| {
            let to_sun = Ray::new(point, sun);
            self.nearest(eye, &to_sun, T_MIN_OF_SHADOWS).is_some()
        });
        if is_dark { 0.4 * color } else { color }
    }

    /// The case of the sphere that is hit first, and where.
    fn nearest(&self, eye: Eye, ray: &Ray, t_min: f64) -> Option<(Case, f64)> {
        let case = |&(center, radius): &(Point3, f64)| Case {
            center,
            radius,
            ray: *ray,
        };
        let cases = self.spheres.iter().map(case);
        let cases: Vec<Case> = cases.map(|case| case.rounded(eye.precision())).collect();
        match eye {
            Eye::Method(method) => closest_so_far(&cases, &method, t_min),
            Eye::Exact(_) => first(&cases, t_min),
        }
    }
}

/// The answer of the loop of chapter 5: it goes by what `method` rounds.
fn closest_so_far(cases: &[Case], method: &Method, t_min: f64) -> Option<(Case, f64)> {
    let mut nearest = None;
    let mut closest_so_far = f64::INFINITY;
    for case in cases {
        if let Some(t) = case.put_to(method, t_min, closest_so_far) {
            closest_so_far = t;
            nearest = Some((*case, t));
        }
    }
    nearest
}

/// The right answer, for cases of one ray; `t` is rounded once.
fn first(cases: &[Case], t_min: f64) -> Option<(Case, f64)> {
    let spheres: Vec<(Point3, f64)> = cases
        .iter()
        .map(|case| (case.center, case.radius))
        .collect();
    let (index, _) = certified_nearest(&spheres, &cases.first()?.ray, t_min, f64::INFINITY)?;
    let t = cases[index].put_to(&Method::EXACT, t_min, f64::INFINITY)?;
    Some((cases[index], t))
}

/// Who looks.
#[derive(Clone, Copy, Debug)]
enum Eye {
    /// One that has a method for one sphere at a time.
    Method(Method),
    /// One that rounds the scene to a precision, and is never wrong about it.
    Exact(Precision),
}

impl Eye {
    fn precision(self) -> Precision {
        match self {
            Self::Method(method) => method.precision(),
            Self::Exact(precision) => precision,
        }
    }
}
