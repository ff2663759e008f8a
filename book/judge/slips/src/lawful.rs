//! Fault localization by hypotheses: finds the known mistakes that give all answers of a wrong
//! function.
//!
//! A wrong function is seldom random: it makes a known mistake, and the program of a [`Slip`] makes
//! it too. A slip is named if its program gives the answers of the function under test to all of a
//! few hundred questions. A single question would not do: where `a` is 1 or the radius 0, many slips
//! agree by chance.

use std::cmp::Reverse;

use common::rtweekend::*;
use interpreter::Ball;
use laws::answers::Answers;
use laws::camera::CameraPixel;
use laws::list::World;
use laws::prelude::Prelude;
use laws::record::RecordedHit;
use laws::{
    Case, ChapterScene, Complaint, Functions, IntervalCase, Mismatch, Outcome, Question, Report,
    Trial,
};

use crate::chapter::Chapter;
use crate::edit::Edit;
use crate::program::ChapterProgram;
use crate::slip::{Languages, Slip};
use crate::{all, unnamed};

/// The most mistakes that a message names: a root can lose its sign in four places.
const NAMED: usize = 4;

/// Finds the slips (known mistakes) that explain a function's answers: the program of the chapter
/// with this one slip gives all of these answers. At most four, those first that most people
/// reported.
///
/// Empty if the right program gives the answers, too, or if no slip does. If only
/// Rust is shown, slips that it makes impossible are left out.
///
/// # Panics
/// If the chapter is not one of [`Chapter::OF_THE_BOOK`].
pub fn mistakes_with_answers(
    answers: &Answers,
    chapter: Chapter,
    languages: Languages,
) -> Vec<&'static Slip> {
    let gives_all = |program: &ChapterProgram| {
        answers.last_is_given_by(program) && answers.mismatch_with(program, 1).differing == 0
    };
    if gives_all(&ChapterProgram::right(chapter)) {
        return Vec::new();
    }
    let mut mistakes: Vec<&'static Slip> = all()
        .chain(unnamed())
        .filter(|slip| slip.is_possible_in(chapter))
        .filter(|slip| languages == Languages::Both || slip.is_possible_in_rust())
        .filter(|slip| gives_all(&slip.program(chapter)))
        .collect();
    mistakes.sort_by_key(|slip| Reverse(slip.report_count()));
    mistakes.truncate(NAMED);
    mistakes
}

/// Fills [`Report::same_as`] with the slips that explain the function's answers: one line of text
/// for each with its wrong and right code in each language, then a line that says that each of them
/// gives every answer. Leaves the list empty if there is no such slip.
pub fn explain(report: &mut Report, chapter: Chapter, languages: Languages) {
    let mistakes = mistakes_with_answers(&report.answers, chapter, languages);
    let in_lines = |slip: &&'static Slip| {
        let name = match slip.name {
            "" => String::new(),
            name => format!("{name}: "),
        };
        let lines = slip.lines_in(languages, chapter).into_iter();
        let begun = [name, "in Rust: ".to_owned()].into_iter().zip(lines);
        begun.map(|(begin, Edit { right, wrong })| {
            let wrong = wrong.trim_end_matches(';');
            format!("{begin}{wrong}; should be: {right}")
        })
    };
    report.same_as = mistakes.iter().flat_map(in_lines).collect();
    report.same_as.extend(match mistakes.len() {
        0 => None,
        1 => Some("this mistake gives your answer to every question".to_owned()),
        _ => Some("each of these mistakes gives your answer to every question".to_owned()),
    });
}

/// Returns the outcome of a trial as it is, but for the report of a broken law: [`explain`] fills
/// its list of known mistakes with the same answers.
///
/// # Errors
/// If the outcome is an error.
pub fn explained(mut outcome: Outcome, chapter: Chapter, languages: Languages) -> Outcome {
    if let Err(Complaint::Broken(report)) = &mut outcome {
        explain(report, chapter, languages);
    }
    outcome
}

/// Compares recorded answers of a reader's functions with those of a program: counts the answers,
/// and those that the program gives otherwise, but at most `most` of them. `chapter` is the
/// reader's; both counts are 0 if the program is of another one.
pub fn mismatch_with(
    answers: &Answers,
    chapter: Chapter,
    program: &ChapterProgram,
    most: usize,
) -> Mismatch {
    match program.chapter == chapter {
        true => answers.mismatch_with(program, most),
        false => Mismatch::default(),
    }
}

/// Lists the questions to a chapter's functions by whose answers mistakes are told apart: first
/// about vectors and rays, then about the sphere, then about `ray_color`. Empty for the build test
/// and chapter 6.
pub fn questions(chapter: Chapter) -> Vec<Question> {
    let sphere = match chapter {
        Chapter::BuildTest | Chapter::SpeedVsAccuracy => return Vec::new(),
        Chapter::Gradient => Vec::new(),
        Chapter::RedSphere => Question::of_sphere(Question::Decision),
        Chapter::Normals | Chapter::HalfBSphere => Question::of_sphere(Question::Root),
        Chapter::HittableList => [Question::of_record(), Question::of_list()].concat(),
    };
    let others = [Question::of_prelude(), sphere, Question::of_ray_color()];
    others.concat()
}

/// Returns the scene (sky, disc, ball or list of spheres) whose colors the `ray_color` of a chapter
/// has to return; the sky for the build test, chapter 0, which has no such function.
pub fn scene(chapter: Chapter) -> ChapterScene {
    match chapter {
        Chapter::BuildTest | Chapter::Gradient => ChapterScene::Sky,
        Chapter::RedSphere => ChapterScene::Disc,
        Chapter::Normals | Chapter::HalfBSphere => ChapterScene::Ball,
        Chapter::HittableList | Chapter::SpeedVsAccuracy => ChapterScene::List,
    }
}

impl ChapterProgram {
    /// Tests the functions that the program's chapter introduces against their laws, properties
    /// that must hold for every ray: the intersection with a sphere, then `ray_color`.
    ///
    /// # Errors
    /// If a function breaks a law; only the first one is reported.
    pub fn try_laws(&self, trial: &Trial) -> Outcome {
        let solve = |center, radius, ray: &Ray| self.hit_sphere(center, radius, ray);
        let record = |asked: &IntervalCase| Functions::record(self, asked);
        match self.chapter {
            Chapter::RedSphere => {
                trial.decision(&|center, radius, ray| solve(center, radius, ray).is_some())?;
            }
            Chapter::Normals | Chapter::HalfBSphere => trial.nearer_root(&solve)?,
            Chapter::HittableList => {
                trial.record(&record)?;
                trial.list(&record, &|world| self.nearest(world))?;
            }
            _ => {}
        }
        trial.ray_color(scene(self.chapter), &|ray| self.ray_color(ray))
    }

    /// Tests all functions of the program by the laws: those for vectors and the camera, then those
    /// of [`try_laws`](Self::try_laws).
    ///
    /// # Errors
    /// If a function breaks a law; only the first one is reported.
    pub fn try_all_laws(&self, trial: &Trial) -> Outcome {
        Prelude::of_program(self, |prelude| trial.prelude(prelude))?;
        trial.pixel_ray(&|pixel| self.pixel_ray(pixel))?;
        self.try_laws(trial)
    }
}

impl Functions for ChapterProgram {
    fn hit_sphere(&self, case: &Case) -> Option<f64> {
        self.hit_sphere(case.center, case.radius, &case.ray)
    }

    fn record(&self, asked: &IntervalCase) -> Option<RecordedHit> {
        let IntervalCase { case, t_min, t_max } = asked;
        let ball = Ball {
            center: case.center,
            radius: case.radius,
        };
        let hit = self.code().record(ball, &case.ray, *t_min, *t_max)?;
        Some(RecordedHit {
            t: hit.t,
            point: hit.point,
            normal: hit.normal,
            front_face: hit.front_face,
        })
    }

    fn nearest(&self, world: &World) -> Option<f64> {
        let ball = |&(center, radius): &(Point3, f64)| Ball { center, radius };
        let balls: Vec<Ball> = world.spheres.iter().map(ball).collect();
        self.code()
            .nearest(&balls, &world.ray, world.t_min, world.t_max)
    }

    fn ray_color(&self, ray: &Ray) -> Color {
        self.ray_color(ray)
    }

    fn pixel_ray(&self, pixel: &CameraPixel) -> Ray {
        // The text that a reader typed has no camera.
        let own = self.ray(pixel.width, pixel.i, pixel.j);
        own.unwrap_or_else(|| Camera::new(pixel.width).ray(pixel.i, pixel.j))
    }

    // Where the text has no function of these, glam's is meant.
    fn dot(&self, u: Vec3, v: Vec3) -> f64 {
        let own = self.code().call_with_vectors("dot", &[u, v]);
        own.map_or(u.dot(v), |it| it[0])
    }

    fn length_squared(&self, v: Vec3) -> f64 {
        let own = self.code().call_with_vectors("length_squared", &[v]);
        own.map_or(v.length_squared(), |it| it[0])
    }

    fn normalize(&self, v: Vec3) -> Vec3 {
        let own = self.code().call_with_vectors("normalize", &[v]);
        own.map_or(v.normalize(), |it| Vec3::from_slice(&it))
    }
}
