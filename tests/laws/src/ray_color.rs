//! Laws for `ray_color`, which picks a color for what a ray meets: asked about rays that the
//! book's camera never casts, because its eye is at the origin and outside of everything.

use common::rtweekend::*;
use slips::{Chapter, Program};

use crate::numbers::{color_in_words, in_words};
use crate::question::{LIST, Question, code_of};
use crate::verdict::{Broken, Verdict};

/// A ray that is traced in the chapter of that number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Traced<const CHAPTER: usize>(pub Ray);

/// A ray has the color of what it meets, from wherever it starts.
pub fn a_ray_has_its_color_from_anywhere<const CHAPTER: usize>(
    ray_color: &dyn Fn(&Ray) -> Color,
    traced: &Traced<CHAPTER>,
) -> Verdict {
    let Traced(ray) = traced;
    let (found, expected) = (ray_color(ray), traced.right());
    if traced.same(&found, &expected) {
        return Ok(());
    }
    Err(Broken {
        law: "a ray has the color of what it meets, from wherever it starts",
        found: format!(
            "{} for the ray from {} along {}",
            color_in_words(found),
            in_words(ray.origin),
            in_words(ray.direction)
        ),
        allowed: color_in_words(expected),
        usually: "the origin of the ray is left out, its direction is made a unit vector while t \
                  counts lengths of it, or what lies behind is not left out",
        page: "chapter 3: what t counts, and which t is in front",
    })
}

impl<const CHAPTER: usize> Traced<CHAPTER> {
    /// Whether the rays of the book's own picture have the right colors: where they don't,
    /// the picture says so, and a step on the way may want it so.
    pub(crate) fn looks_right(ray_color: &dyn Fn(&Ray) -> Color) -> bool {
        let camera = Camera::new(32);
        let pixels = (0..camera.image_height).flat_map(|j| (0..32).map(move |i| (i, j)));
        let mut traced = pixels.map(|(i, j)| Self(camera.ray(i, j)));
        traced.all(|traced| traced.same(&ray_color(&traced.0), &traced.right()))
    }
}

impl<const CHAPTER: usize> Question for Traced<CHAPTER> {
    type Answer = Color;

    const KIND: &'static str = "ray_color";

    const FUNCTION: &'static str = "ray_color";

    const CHAPTERS: &'static [Chapter] = &[Chapter::OF_THE_BOOK[CHAPTER]];

    fn answer_of(&self, program: &Program) -> Color {
        program.ray_color(&self.0)
    }

    /// No level of a picture is as narrow as that.
    fn same(&self, one: &Color, other: &Color) -> bool {
        (*one - *other).abs().max_element() <= 1e-6 || one.is_nan() && other.is_nan()
    }

    /// From in front of the sphere, from behind, beside and above it, from inside, and from
    /// far away, past it and at it, with directions of several lengths.
    fn telling() -> Vec<Self> {
        let v = Vec3::new;
        let from = [
            v(0.0, 0.0, -3.0),
            v(2.0, 1.0, 0.5),
            v(-3.0, 0.5, -1.5),
            v(0.5, 4.0, -1.0),
            v(0.1, 0.2, -1.1),
            v(300.0, 200.0, 4000.0),
        ];
        let to = [
            v(0.0, 0.0, -1.0),
            v(0.25, 0.125, -1.0),
            v(-0.125, -0.25, -0.875),
            v(0.0, 1.0, -1.0),
            v(2.0, -0.5, -3.0),
        ];
        let lengths = [1.0, -1.0, 3.0, 0.25, -0.5, 2.0, 0.125];
        let ways = from
            .into_iter()
            .flat_map(|from| to.map(|to| (from, to - from)));
        let rays = ways.zip(lengths.into_iter().cycle());
        rays.map(|((from, way), length)| Self(Ray::new(from, length * way)))
            .collect()
    }

    fn as_test(&self, ray_color: &str) -> String {
        let Ray { origin, direction } = self.0;
        let [origin, direction, right] = [origin, direction, self.right()].map(code_of);
        format!(
            "let ray = Ray::new({origin}, {direction});\n\
             assert!(({ray_color}(&ray) - {right}).length() < 1e-6);"
        )
    }
}

/// A ray that asks a world, as in chapter 5, what it meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Looking(pub Ray);

/// A ray asks for what is in front of it, however far: from 0, or from where rounding can't
/// find the surface that it starts on, without an end.
pub fn all_that_is_in_front_is_asked_for(
    range: &dyn Fn(&Ray) -> Option<[f64; 2]>,
    &Looking(ray): &Looking,
) -> Verdict {
    let found = range(&ray);
    if is_in_front(&found) {
        return Ok(());
    }
    Err(Broken {
        law: "a ray asks the world for what is in front of it, however far",
        found: found.map_or("the world is not asked".to_owned(), |[t_min, t_max]| {
            format!("world.hit with t_min = {t_min}, t_max = {t_max}")
        }),
        allowed: "t_min = 0, t_max = inf".to_owned(),
        usually: "the two are swapped, or t_min is negative",
        page: "chapter 5: anything that a ray can hit",
    })
}

fn is_in_front(range: &Option<[f64; 2]>) -> bool {
    range.is_some_and(|[t_min, t_max]| (0.0..=0.001).contains(&t_min) && t_max >= f64::MAX)
}

impl Question for Looking {
    type Answer = Option<[f64; 2]>;

    const KIND: &'static str = "range";

    const FUNCTION: &'static str = "range";

    const CHAPTERS: &'static [Chapter] = LIST;

    fn answer_of(&self, program: &Program) -> Option<[f64; 2]> {
        Some([program.t_min, program.t_max])
    }

    fn same(&self, one: &Self::Answer, other: &Self::Answer) -> bool {
        one == other || is_in_front(one) && is_in_front(other)
    }

    fn telling() -> Vec<Self> {
        vec![
            Self(Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, -1.0))),
            Self(Ray::new(
                Point3::new(1.0, 2.0, 3.0),
                Vec3::new(4.0, 5.0, 6.0),
            )),
        ]
    }

    fn as_test(&self, range: &str) -> String {
        let Ray { origin, direction } = self.0;
        let [origin, direction] = [origin, direction].map(code_of);
        format!(
            "let ray = Ray::new({origin}, {direction});\n\
             assert_eq!({range}(&ray), Some([0.0, f64::INFINITY]));"
        )
    }
}
