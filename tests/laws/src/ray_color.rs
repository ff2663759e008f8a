//! Laws for `ray_color`, which picks a color for what a ray meets: asked about rays that the
//! book's camera never casts, because its eye is at the origin and outside of everything.

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Chapter, Program};

use crate::Verdict;
use crate::question::{Question, code, of_ray, same, vector};

/// A ray has the color of what it meets in the chapter, from wherever it starts.
pub fn a_ray_has_its_color_from_anywhere(chapter: Chapter, color: Color, ray: &Ray) -> Verdict {
    let right = Program::right(chapter).ray_color(ray);
    prop_assert!(
        same(&color.to_array(), &right.to_array()),
        "the law:  a ray has the color of what it meets, from wherever it starts\n\
         found:    {color:.4} for the ray from {} along {}\n\
         allowed:  {right:.4}\n\
         read:     chapter 3: what t counts, and which t is in front",
        ray.origin,
        ray.direction
    );
    Ok(())
}

/// Whether the rays of the book's own picture have the right colors: where they don't,
/// the picture says so, and a step on the way may want it so.
pub(crate) fn looks_right(chapter: Chapter, ray_color: &dyn Fn(&Ray) -> Color) -> bool {
    let camera = Camera::new(32);
    let pixels = (0..camera.image_height).flat_map(|j| (0..32).map(move |i| (i, j)));
    let mut rays = pixels.map(|(i, j)| camera.ray(i, j));
    rays.all(|ray| a_ray_has_its_color_from_anywhere(chapter, ray_color(&ray), &ray).is_ok())
}

/// What the `ray_color` of a chapter is asked.
impl Question for Ray {
    fn kind(&self) -> &'static str {
        "ray_color"
    }

    fn as_test(&self, chapter: Chapter) -> String {
        let ray = code(&of_ray(*self));
        let right = vector(Program::right(chapter).ray_color(self));
        format!("let ray = {ray};\nassert!((ray_color(&ray) - {right}).length() < 1e-9);")
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        program.ray_color(self).to_array().to_vec()
    }
}
