//! A chapter as a table of functions, so that one step of it can be replaced.

use common::rtweekend::*;
pub use interpreter::{Ball, Hit, Interpreted};

use crate::chapter::Chapter;
use crate::edition::Edition;

/// The sphere of chapters 2 to 4.
pub(super) const BALL: Ball = Ball::new(0.0, 0.0, -1.0, 0.5);

/// Chooses one of all hits, by its ray parameter and its sphere.
pub(super) type Search = fn(&Program, &[Ball], &Ray) -> Option<(f64, Ball)>;

/// A chapter as its steps, in the order in which a pixel passes through them.
///
/// The steps are fields, so a slip is the right program with one of them
/// replaced, and two slips make a program that has both. Where a step needs
/// another one it gets the program, because that one may be replaced as well.
#[derive(Clone, Copy)]
pub struct Program {
    /// Which chapter it is meant to be.
    pub chapter: Chapter,
    /// Which edition of the book it follows.
    pub edition: Edition,
    /// Width over height, as the reader would like it.
    pub aspect_ratio: f64,
    /// Rows of the picture, from its width and the aspect ratio.
    pub image_height: fn(f64, f64) -> u32,
    /// Width over height of the viewport, from those of the picture and the aspect ratio.
    pub viewport_ratio: fn(f64, f64, f64) -> f64,
    /// Height of the viewport in units of space.
    pub viewport_height: f64,
    /// Which way along x and y the edges of the viewport point: 1 or -1.
    pub edges: [f64; 2],
    /// From the eye to the viewport, along the negative z axis.
    pub focal_length: f64,
    /// Which part of the upper edge lies left of the axis, and of the left edge above it.
    pub corner: [f64; 2],
    /// How many pixels less than all are counted along an edge: 1 if the last lies on its end.
    pub last: f64,
    /// By how much columns and rows are divided to run from 0 to 1, given how many are counted.
    pub divisors: fn(f64, f64) -> [f64; 2],
    /// How many pixels the first one lies to the right of the upper left corner, and below.
    pub inset: [f64; 2],
    /// The column and row of the nth printed pixel, given the picture's width and height.
    pub order: fn(u32, u32, u32) -> (u32, u32),
    /// The column and row that are seen, from those that the loops count.
    pub place: fn([f64; 2]) -> [f64; 2],
    /// Red and green in the build test, from column and row and the divisors.
    pub ramp: fn([f64; 2], [f64; 2]) -> [f64; 2],
    /// Blue in every pixel of the build test.
    pub blue: f64,
    /// The color of the pixel in a column and row.
    pub color: fn(&Program, &Camera, u32, u32) -> Color,
    /// The ray that is cast, from the right one.
    pub aim: fn(&Program, Ray) -> Ray,
    /// The vector of length 1 in the same direction.
    pub unit: fn(Vec3) -> Vec3,
    /// The direction by which the sky is blended, from that of the ray.
    pub sky_direction: fn(&Program, Vec3) -> Vec3,
    /// The weight of blue in the sky, from that direction.
    pub blend: fn(Vec3) -> f64,
    /// The colors of the sky, below and above.
    pub sky: [Color; 2],
    /// The sky's color from the weight of the one above.
    pub lerp: fn([Color; 2], f64) -> Color,
    /// What there is to hit.
    pub world: &'static [Ball],
    /// Which hit wins.
    pub search: Search,
    /// Only a greater ray parameter counts.
    pub t_min: f64,
    /// Only a lesser one counts: no bound in any chapter, but a list has one.
    pub t_max: f64,
    /// Whether `t_min`, `t` and `t_max` follow each other.
    pub in_range: fn(f64, f64, f64) -> bool,
    /// From the ray's origin to the sphere's center, given center and origin.
    pub oc: fn(Point3, Point3) -> Vec3,
    /// The dot product.
    pub dot: fn(Vec3, Vec3) -> f64,
    /// The square of a length.
    pub squared: fn(&Program, Vec3) -> f64,
    /// The quadratic's a from the ray's direction.
    pub a: fn(&Program, Vec3) -> f64,
    /// The quadratic's b or h from d·oc.
    pub linear: fn(f64) -> f64,
    /// The quadratic's c from oc·oc and the radius.
    pub constant: fn(f64, f64) -> f64,
    /// The 4 of the discriminant, or 1 where b is halved.
    pub four: f64,
    /// From that, a, b or h, and c.
    pub discriminant: fn(f64, f64, f64, f64) -> f64,
    /// Whether there is a root, from the discriminant.
    pub meets: fn(f64) -> bool,
    /// The square root.
    pub sqrt: fn(f64) -> f64,
    /// The first term of the numerator, from b or h.
    pub first_term: fn(f64) -> f64,
    /// The numerators of the roots as they are tried, from the first term, the root, and a.
    pub numerators: fn(f64, f64, f64) -> [f64; 2],
    /// A root from its numerator and a.
    pub divide: fn(f64, f64) -> f64,
    /// What is returned of the two roots, if there are any.
    pub kept: fn(Option<[f64; 2]>) -> Option<[f64; 2]>,
    /// Which of two roots counts, given `t_min` and `t_max`.
    pub choice: fn(&Program, [f64; 2], f64, f64) -> Option<f64>,
    /// The unit normal that points out, from a point on a sphere.
    pub outward: fn(&Program, Point3, Ball) -> Vec3,
    /// Whether the ray comes from outside, from its direction and the normal that points out.
    pub front_face: fn(&Program, Vec3, Vec3) -> bool,
    /// The normal that is colored, from the ray's direction and the one that points out.
    pub face: fn(&Program, Vec3, Vec3) -> Vec3,
    /// The color of a sphere that has only one.
    pub paint: Color,
    /// The color of a hit, from the one above or from the normal.
    pub shade: fn(Color, Vec3) -> Color,
    /// An integer for the file, from a color's component.
    pub level: fn(f64) -> i32,
    /// Which component is printed first, second and third.
    pub channels: [usize; 3],
    /// Width and height as the header of the file tells them.
    pub header: fn(u32, u32) -> (u32, u32),
    /// What runs in place of the steps from a ray to its color.
    pub code: Option<&'static dyn Interpreted>,
}

impl Program {
    /// The chapter as it should be.
    ///
    /// A copy, since the chapter itself can't be taken apart; a test compares
    /// the two.
    ///
    /// # Panics
    /// If it is not one of [`Chapter::OF_THE_BOOK`].
    pub fn right(chapter: Chapter) -> Self {
        match chapter {
            Chapter::BuildTest => BUILD_TEST,
            Chapter::Gradient => GRADIENT,
            Chapter::RedSphere => RED_SPHERE,
            Chapter::Normals => NORMALS,
            Chapter::HalfBSphere => HALF_B_SPHERE,
            Chapter::HittableList => HITTABLE_LIST,
            Chapter::SpeedVsAccuracy => panic!("chapter 6 is no program of the book"),
        }
    }

    /// The camera of the program.
    pub fn camera(&self, image_width: u32) -> Camera {
        let width = f64::from(image_width);
        let image_height = (self.image_height)(width, self.aspect_ratio);
        let height = f64::from(image_height);
        let center = Point3::ZERO;

        let viewport_ratio = (self.viewport_ratio)(width, height, self.aspect_ratio);
        let viewport_width = self.viewport_height * viewport_ratio;
        let [right, up] = self.edges;
        let viewport_u = Vec3::new(right * viewport_width, 0.0, 0.0);
        let viewport_v = Vec3::new(0.0, up * self.viewport_height, 0.0);

        let [left, above] = self.corner;
        let corner = center
            - Vec3::new(0.0, 0.0, self.focal_length)
            - left * viewport_u
            - above * viewport_v;
        let mut camera = Camera {
            image_width,
            image_height,
            center,
            pixel00: corner,
            pixel_delta_u: viewport_u,
            pixel_delta_v: viewport_v,
        };
        if !self.edition.counts_from_below() {
            let [across, down] = self.divided(image_width, image_height);
            camera.pixel_delta_u = viewport_u * (1.0 / across);
            camera.pixel_delta_v = viewport_v * (1.0 / down);
            let [right, down] = self.inset;
            camera.pixel00 = corner + (right * camera.pixel_delta_u + down * camera.pixel_delta_v);
        }
        camera
    }

    /// The chapter's `ray_color`.
    pub fn ray_color(&self, ray: &Ray) -> Color {
        if let Some(code) = self.code {
            return code.ray_color(ray);
        }
        match self.normal(ray) {
            Some(normal) => (self.shade)(self.paint, normal),
            None => (self.lerp)(self.sky, self.weight_of_blue(ray.direction)),
        }
    }

    /// The weight of blue in the sky, from the direction of a ray.
    pub fn weight_of_blue(&self, direction: Vec3) -> f64 {
        (self.blend)((self.sky_direction)(self, direction))
    }

    /// The normal of a hit that is colored, if the ray hits anything.
    pub fn normal(&self, ray: &Ray) -> Option<Vec3> {
        let (t, ball) = self.search(ray)?;
        let outward = (self.outward)(self, ray.at(t), ball);
        Some((self.face)(self, ray.direction, outward))
    }

    /// What wins of all that the ray hits in the program's world.
    pub fn search(&self, ray: &Ray) -> Option<(f64, Ball)> {
        (self.search)(self, self.world, ray)
    }

    /// What wins in a world of other spheres, between `t_min` and `t_max`.
    pub fn search_among(&self, balls: &[Ball], ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
        if let Some(code) = self.code {
            return code.nearest(balls, ray, t_min, t_max);
        }
        let program = Self {
            t_min,
            t_max,
            ..*self
        };
        (self.search)(&program, balls, ray).map(|(t, _)| t)
    }

    /// The record of a sphere's nearest hit between `t_min` and `t_max`.
    pub fn record(&self, ball: Ball, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        if let Some(code) = self.code {
            return code.record(ball, ray, t_min, t_max);
        }
        let t = self.hit(ball, ray, t_min, t_max)?;
        let point = ray.at(t);
        let outward = (self.outward)(self, point, ball);
        Some(Hit {
            t,
            point,
            normal: (self.face)(self, ray.direction, outward),
            front_face: (self.front_face)(self, ray.direction, outward),
        })
    }

    /// The column and row that are seen in the `j`th row from above.
    pub(super) fn seen(&self, camera: &Camera, i: u32, j: u32) -> [f64; 2] {
        (self.place)([i.into(), self.edition.row(j, camera.image_height)])
    }

    /// By how much columns and rows are divided.
    pub(super) fn divided(&self, width: u32, height: u32) -> [f64; 2] {
        (self.divisors)(f64::from(width) - self.last, f64::from(height) - self.last)
    }

    /// The ray that is cast for the pixel in a column and row.
    pub fn ray(&self, camera: &Camera, i: u32, j: u32) -> Ray {
        let [mut u, mut v] = self.seen(camera, i, j);
        if self.edition.counts_from_below() {
            let [across, up] = self.divided(camera.image_width, camera.image_height);
            [u, v] = [u / across, v / up];
        }
        let point = camera.pixel00 + u * camera.pixel_delta_u + v * camera.pixel_delta_v;
        (self.aim)(self, Ray::new(camera.center, point - camera.center))
    }

    /// The color of a pixel in a chapter without rays.
    fn build_test(&self, camera: &Camera, i: u32, j: u32) -> Color {
        let divisors = self.divided(camera.image_width, camera.image_height);
        let [red, green] = (self.ramp)(self.seen(camera, i, j), divisors);
        Color::new(red, green, self.blue)
    }

    /// The `hit_sphere` of chapters 2 to 4, which knows no interval: the nearer
    /// root `t`, in lengths of `ray.direction`. Chapter 2 only tells whether
    /// there is one.
    pub fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        if let Some(code) = self.code {
            return code.hit_sphere(center, radius, ray);
        }
        self.roots(Ball { center, radius }, ray)
            .map(|[first, _]| first)
    }

    /// The `hit` of a sphere in chapter 5: the first root tried that lies in
    /// the interval, in lengths of `ray.direction`.
    pub fn hit(&self, ball: Ball, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
        if let Some(code) = self.code {
            return code.record(ball, ray, t_min, t_max).map(|hit| hit.t);
        }
        (self.choice)(self, self.roots(ball, ray)?, t_min, t_max)
    }

    /// The two roots that are tried, one after the other.
    fn roots(&self, ball: Ball, ray: &Ray) -> Option<[f64; 2]> {
        let [a, b, c] = self.coefficients(ball, ray);
        let discriminant = (self.discriminant)(self.four, a, b, c);
        let roots = || {
            let numerators = (self.numerators)((self.first_term)(b), (self.sqrt)(discriminant), a);
            numerators.map(|numerator| (self.divide)(numerator, a))
        };
        (self.kept)((self.meets)(discriminant).then(roots))
    }

    /// The quadratic's a, b or h, and c.
    pub(super) fn coefficients(&self, ball: Ball, ray: &Ray) -> [f64; 3] {
        let oc = (self.oc)(ball.center, ray.origin);
        let a = (self.a)(self, ray.direction);
        let b = (self.linear)((self.dot)(ray.direction, oc));
        let c = (self.constant)((self.squared)(self, oc), ball.radius);
        [a, b, c]
    }
}

/// The last chapter has all there is; each one before it is the next one with
/// a few steps less.
const HITTABLE_LIST: Program = Program {
    chapter: Chapter::HittableList,
    edition: Edition::V4,
    aspect_ratio: 16.0 / 9.0,
    image_height: |width, aspect_ratio| ((width / aspect_ratio) as u32).max(1),
    viewport_ratio: |width, height, _| width / height,
    viewport_height: 2.0,
    edges: [1.0, -1.0],
    focal_length: 1.0,
    corner: [0.5, 0.5],
    last: 0.0,
    divisors: |width, height| [width, height],
    inset: [0.5, 0.5],
    order: |n, width, _| (n % width, n / width),
    place: |place| place,
    ramp: |[i, j], [width, height]| [i / width, j / height],
    blue: 0.0,
    color: |program, camera, i, j| program.ray_color(&program.ray(camera, i, j)),
    aim: |_, ray| ray,
    unit: Vec3::normalize,
    sky_direction: |program, direction| (program.unit)(direction),
    blend: |direction| 0.5 * (direction.y + 1.0),
    sky: [Color::new(1.0, 1.0, 1.0), Color::new(0.5, 0.7, 1.0)],
    lerp: |[below, above], a| (1.0 - a) * below + a * above,
    world: &[BALL, Ball::new(0.0, -100.5, -1.0, 100.0)],
    search: nearest,
    t_min: 0.0,
    t_max: f64::INFINITY,
    in_range: |t_min, t, t_max| t_min < t && t < t_max,
    oc: |center, origin| center - origin,
    dot: Vec3::dot,
    squared: |_, v| v.length_squared(),
    a: |program, direction| (program.squared)(program, direction),
    linear: |d_oc| d_oc,
    constant: |oc_squared, radius| oc_squared - radius * radius,
    four: 1.0,
    discriminant: |four, a, b, c| b * b - four * a * c,
    meets: |discriminant| discriminant >= 0.0,
    sqrt: f64::sqrt,
    first_term: |h| h,
    numerators: |first, sqrtd, _| [first - sqrtd, first + sqrtd],
    divide: |numerator, a| numerator / a,
    kept: |roots| roots,
    choice: |program, roots, t_min, t_max| {
        let in_range = |&t: &f64| (program.in_range)(t_min, t, t_max);
        roots.into_iter().find(in_range)
    },
    outward: |_, point, ball| (point - ball.center) * (1.0 / ball.radius),
    front_face: |program, direction, outward| (program.dot)(direction, outward) < 0.0,
    face: |program, direction, outward| {
        if (program.front_face)(program, direction, outward) {
            outward
        } else {
            -outward
        }
    },
    paint: Color::new(1.0, 0.0, 0.0),
    shade: |_, normal| 0.5 * (normal + Vec3::ONE),
    level: |component| (255.999 * component) as i32,
    channels: [0, 1, 2],
    header: |width, height| (width, height),
    code: None,
};

const HALF_B_SPHERE: Program = Program {
    chapter: Chapter::HalfBSphere,
    world: &[BALL],
    numerators: |first, sqrtd, _| [first - sqrtd; 2],
    outward: |program, point, ball| (program.unit)(point - ball.center),
    face: |_, _, outward| outward,
    ..HITTABLE_LIST
};

const NORMALS: Program = Program {
    chapter: Chapter::Normals,
    squared: |program, v| (program.dot)(v, v),
    linear: |d_oc| -2.0 * d_oc,
    four: 4.0,
    first_term: |b| -b,
    divide: |numerator, a| numerator / (2.0 * a),
    ..HALF_B_SPHERE
};

const RED_SPHERE: Program = Program {
    chapter: Chapter::RedSphere,
    t_min: f64::NEG_INFINITY,
    // It asks whether there is a root, and not where.
    in_range: |_, _, _| true,
    shade: |paint, _| paint,
    ..NORMALS
};

const GRADIENT: Program = Program {
    chapter: Chapter::Gradient,
    world: &[],
    ..RED_SPHERE
};

const BUILD_TEST: Program = Program {
    chapter: Chapter::BuildTest,
    image_height: |width, _| width as u32,
    last: 1.0,
    divisors: |width, height| [width.max(1.0), height.max(1.0)],
    color: Program::build_test,
    ..GRADIENT
};

fn nearest(program: &Program, balls: &[Ball], ray: &Ray) -> Option<(f64, Ball)> {
    let mut found = None;
    let mut closest_so_far = program.t_max;
    for &ball in balls {
        if let Some(t) = program.hit(ball, ray, program.t_min, closest_so_far) {
            closest_so_far = t;
            found = Some((t, ball));
        }
    }
    found
}
