//! Differential testing: whether a program draws the right pixels and answers as the chapter's
//! functions do.
//!
//! Pixels alone take some nonsense for right. Questions that no pixel asks, about other origins,
//! balls and ranges, settle it, and find what the picture hides.

use std::rc::Rc;

use common::rtweekend::*;
use interpreter::{Program, Sample};
use slips::{Ball, Chapter};

use crate::pixels::spread;
use crate::reading::Reading;
use crate::scene::Scene;

/// So many wrong and right pixels are looked at, the wrong ones first.
pub(super) const LOOKED: u32 = 100;
/// A picture is drawn whole up to this size; of a larger one so many pixels are.
pub(super) const DRAWN: u32 = 100_000;
/// So wide is a picture that a reader's own loop draws for each text that is tried.
const SMALL: u32 = 24;
/// So many questions are asked.
const ASKED: usize = 120;

/// What a right program does.
pub(super) struct Goal {
    width: u32,
    sample: Rc<Sample>,
    all: Rc<Sample>,
    chapter: Chapter,
    /// What the chapter answers; nothing where it is not asked.
    answers: Vec<Vec<f64>>,
    /// What a reader's own loop over all pixels is to draw, at [`SMALL`].
    small: Option<Picture>,
}

/// The program, if the interpreter takes it.
pub(super) fn program(files: &[(String, String)]) -> Option<Program> {
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(name, text)| (&**name, &**text))
        .collect();
    interpreter::read(&files).ok()
}

/// Whether the program draws this picture, by the look of so many pixels.
pub(super) fn draws(program: &Program, reading: &Reading, count: u32) -> bool {
    let pixel = |n: u32| {
        (
            n,
            reading.pixels[n as usize].map(|it| it.clamp(0, 255) as u8),
        )
    };
    let sample = spread(count, reading.pixels.len() as u32);
    let sample: Rc<Sample> = sample.map(pixel).collect();
    program.matches(reading.width, &sample).ok() == Some(sample.len())
}

impl Goal {
    /// The right picture, and the answers of the chapter.
    pub(super) fn new(chapter: Chapter, right: &Picture, reading: &Reading) -> Self {
        let (width, total) = (right.width(), right.width() * right.height());
        let level = |n: u32| <[u8; 3]>::try_from(&right.rgb()[3 * n as usize..][..3]);
        let pixel = |n: u32| (n, level(n).expect("three levels"));
        let has_same_shape = (reading.width, reading.height) == (width, right.height());
        let is_wrong = |n: &u32| {
            let right = pixel(*n).1.map(i16::from);
            !has_same_shape || reading.pixels[*n as usize] != right
        };
        let (wrong, fine): (Vec<u32>, Vec<u32>) = (0..total).partition(is_wrong);
        let some = |all: &[u32]| -> Vec<u32> {
            spread(LOOKED, all.len() as u32)
                .map(|n| all[n as usize])
                .collect()
        };
        let sample = [some(&wrong), some(&fine)].concat().into_iter();
        Self {
            width,
            sample: sample.map(pixel).collect(),
            all: spread(DRAWN, total).map(pixel).collect(),
            chapter,
            answers: Vec::new(),
            small: None,
        }
    }

    /// The same where the reader has a loop over all pixels, too.
    pub(super) fn looping(self, scene: &Scene) -> Self {
        let small = scene.right(SMALL, scene.height(SMALL));
        Self {
            small: Some(small),
            ..self
        }
    }

    /// The same with questions to which the chapter has the answers.
    pub(super) fn asking(self, right: &Program) -> Self {
        let answers = (0..ASKED).map(|n| answer(right, self.chapter, n)).collect();
        Self { answers, ..self }
    }

    /// Whether the program answers all questions as the chapter does.
    pub(super) fn is_answered_by(&self, program: &Program) -> bool {
        let mut questions = self.answers.iter().enumerate();
        questions.all(|(n, right)| are_near(right, &answer(program, self.chapter, n)))
    }

    /// Whether the program is right, by its answers and by what it draws.
    pub(super) fn is_met_by(&self, program: &Program) -> bool {
        let has =
            |sample: &Rc<Sample>| program.matches(self.width, sample).ok() == Some(sample.len());
        let loops = |small: &Picture| program.draw(SMALL).is_ok_and(|it| it == *small);
        has(&self.sample)
            && self.small.as_ref().is_none_or(loops)
            && self.is_answered_by(program)
            && has(&self.all)
    }
}

/// What a program answers to the nth question.
fn answer(program: &Program, chapter: Chapter, n: usize) -> Vec<f64> {
    let mut random = random(n);
    let mut vector = |size: f64| Vec3::new(random(), random(), random()) * size;
    let origin = vector(if n.is_multiple_of(3) { 0.0 } else { 3.0 });
    let center = match n % 4 {
        0 => Point3::new(0.0, 0.0, -1.0),
        _ => vector(3.0),
    };
    let radius = [0.5, 1.0, 2.0][n % 3];
    // Forwards and backwards, near and far, and past the ball.
    let way = [1.0, -1.0][n / 2 % 2] * [1.0, 0.3, 2.5][n / 3 % 3];
    let direction = match n % 5 {
        4 => vector(1.0),
        _ => way * (center + vector(0.8 * radius) - origin),
    };
    let ray = Ray::new(origin, direction);
    let ranges = [(0.0, f64::INFINITY), (0.5, 1.5), (-1.0, 2.0), (0.0, 1.0)];
    let (t_min, t_max) = ranges[n % 4];
    let ball = Ball { center, radius };
    let mut answer = program.ray_color(&ray).to_array().to_vec();
    match chapter {
        Chapter::BuildTest | Chapter::Gradient => {}
        Chapter::HittableList => {
            let [up, down] = [1.0, -1.0].map(|sign| Ball {
                center: center + sign * Vec3::new(0.5, 0.2, 0.9),
                radius: 0.9,
            });
            if let Some(hit) = program.record(ball, &ray, t_min, t_max) {
                let vectors = [hit.point, hit.normal].map(|it| it.to_array());
                answer.extend(vectors.concat());
                answer.extend([hit.t, f64::from(hit.front_face)]);
            }
            answer.extend(program.nearest(&[ball, up, down], &ray, t_min, t_max));
        }
        _ => answer.extend(program.hit_sphere(center, radius, &ray)),
    }
    answer
}

/// Numbers from −1 to 1, the same for the same seed (xorshift: Marsaglia, 2003).
fn random(seed: usize) -> impl FnMut() -> f64 {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(seed as u64 + 1);
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Whether two answers are the same but for rounding.
fn are_near(one: &[f64], other: &[f64]) -> bool {
    let is_near = |(one, other): (&f64, &f64)| {
        let near = 1e-9 * (1.0 + one.abs());
        one == other || one.is_nan() && other.is_nan() || (one - other).abs() <= near
    };
    one.len() == other.len() && one.iter().zip(other).all(is_near)
}
