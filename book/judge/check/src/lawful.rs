//! Fault localization by hypotheses: finds the known mistakes that give all answers of a wrong
//! function.
//!
//! A wrong function is seldom random: it makes a known mistake, and the program of a [`Slip`] makes
//! it too. A slip is named if its program gives the answers of the function under test to all of a
//! few hundred questions. A single question would not do: where `a` is 1 or the radius 0, many slips
//! agree by chance.

use std::cmp::Reverse;

use common::rtweekend::*;
use interpreter::Value;
use laws::answers::{Answered, Answers};
use laws::camera::CameraPixel;
use laws::list::World;
use laws::prelude::{PRELUDE_FUNCTIONS, Prelude};
use laws::question::{decided, numbers_of_hit, numbers_of_ray, telling_cases};
use laws::ray_color::rays;
use laws::record::RecordedHit;
use laws::strategies::{ordinary, ordinary_with_interval, worlds};
use laws::{Case, ChapterScene, Complaint, IntervalCase, Outcome, Question, Report, Trial};
use slips::{Chapter, ChapterProgram, Edit, Languages, Slip};

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
    // The last answer is that to the smallest case: most other programs give another one.
    let gives_all = |program: &ChapterProgram| {
        let mut answers = answers.given.iter().rev();
        answers.all(|answered| is_given_by(program, answered))
    };
    if gives_all(&ChapterProgram::right(chapter)) {
        return Vec::new();
    }
    let mut mistakes: Vec<&'static Slip> = slips::all()
        .chain(slips::unnamed())
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

/// A comparison of recorded answers with those of a program: how many there are, and how many
/// differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mismatch {
    /// How many questions are recorded in all, also if the count stopped before the last.
    pub asked: usize,
    /// How many of these questions the program answers otherwise; at most the limit that was given.
    pub differing: usize,
}

/// Compares recorded answers of a reader's functions with those of a program: counts the answers,
/// and those that the program gives otherwise, up to rounding, but at most `most` of them. `chapter`
/// is the reader's; both counts are 0 if the program is of another one.
pub fn mismatch_with(
    answers: &Answers,
    chapter: Chapter,
    program: &ChapterProgram,
    most: usize,
) -> Mismatch {
    if program.chapter != chapter {
        return Mismatch::default();
    }
    let differing = answers.given.iter().filter(|it| !is_given_by(program, it));
    Mismatch {
        asked: answers.given.len(),
        differing: differing.take(most).count(),
    }
}

/// Returns true if the program gives an answer, up to rounding.
fn is_given_by(program: &ChapterProgram, Answered { question, answer }: &Answered) -> bool {
    question.answers_agree(answer, &answer_of(program, question))
}

/// Lists the questions to a chapter's functions by whose answers mistakes are told apart: first
/// about vectors and rays, then about the sphere, then about `ray_color`. Empty for the build test
/// and chapter 6.
pub fn questions(chapter: Chapter) -> Vec<Question> {
    let sphere = match chapter {
        Chapter::BuildTest | Chapter::SpeedVsAccuracy => return Vec::new(),
        Chapter::Gradient => Vec::new(),
        Chapter::RedSphere => of(telling_cases(&ordinary()), Question::Decision),
        Chapter::Normals | Chapter::HalfBSphere => of(telling_cases(&ordinary()), Question::Root),
        Chapter::HittableList => {
            let records = telling_cases(&ordinary_with_interval());
            let lists = telling_cases(&worlds());
            [of(records, Question::Record), of(lists, Question::Nearest)].concat()
        }
    };
    let prelude = PRELUDE_FUNCTIONS.iter().flat_map(|it| it.telling_cases());
    let prelude = of(prelude.collect(), Question::Prelude);
    let colors = of(telling_cases(&rays()), Question::RayColor);
    [prelude, sphere, colors].concat()
}

fn of<T>(cases: Vec<T>, kind: fn(T) -> Question) -> Vec<Question> {
    cases.into_iter().map(kind).collect()
}

/// Asks a program questions, in their order, and records its answers. A panic in the program is
/// passed on.
pub fn answers_of(
    program: &ChapterProgram,
    questions: impl IntoIterator<Item = Question>,
) -> Answers {
    let answered = questions.into_iter().map(|question| {
        let answer = answer_of(program, &question);
        Answered { question, answer }
    });
    Answers {
        given: answered.collect(),
    }
}

/// Asks the function of a program that the question is about.
fn answer_of(program: &ChapterProgram, question: &Question) -> Vec<f64> {
    let hit = |case: &Case| program.hit_sphere(case.center, case.radius, &case.ray);
    match question {
        Question::Prelude(asked) => with_prelude(program, |prelude| asked.put_to(prelude)),
        Question::Decision(case) => decided(hit(case).is_some()),
        Question::Root(case) => hit(case).into_iter().collect(),
        Question::Record(asked) => numbers_of_hit(asked, record(program, asked)),
        Question::Nearest(world) => nearest(program, world).into_iter().collect(),
        Question::RayColor(ray) => program.ray_color(ray).to_array().to_vec(),
        Question::PixelRay(pixel) => numbers_of_ray(pixel_ray(program, pixel)),
    }
}

/// Calls `Sphere::hit` on a sphere made by `Sphere::new`; `None` for a miss, if the program stops,
/// or if one of these functions or a field of the record is missing.
fn record(program: &ChapterProgram, asked: &IntervalCase) -> Option<RecordedHit> {
    let IntervalCase { case, t_min, t_max } = asked;
    let sphere = sphere(program, case.center, case.radius)?;
    let mut given = [sphere, case.ray.into(), (*t_min).into(), (*t_max).into()];
    let hit = program.call("Sphere::hit", &mut given)?;
    let record = hit.parts().first()?;
    let field = |name| program.code().field(record, name);
    Some(RecordedHit {
        t: field("t")?.float()?,
        point: field("point").or_else(|| field("p"))?.vec3()?,
        normal: field("normal")?.vec3()?,
        front_face: matches!(field("front_face")?, Value::Bool(true)),
    })
}

/// Calls `HittableList::hit` on a list with these spheres in this order; `None` like [`record`].
fn nearest(program: &ChapterProgram, world: &World) -> Option<f64> {
    let has_new = program.code().parameters("HittableList::new").is_some();
    let name = ["HittableList::default", "HittableList::new"][usize::from(has_new)];
    let mut list = program.call(name, &mut [])?;
    for (center, radius) in &world.spheres {
        let mut given = [list, sphere(program, *center, *radius)?];
        program.call("HittableList::add", &mut given)?;
        [list, _] = given;
    }
    let mut given = [
        list,
        world.ray.into(),
        world.t_min.into(),
        world.t_max.into(),
    ];
    let hit = program.call("HittableList::hit", &mut given)?;
    program.code().field(hit.parts().first()?, "t")?.float()
}

fn sphere(program: &ChapterProgram, center: Point3, radius: f64) -> Option<Value> {
    program.call("Sphere::new", &mut [center.into(), radius.into()])
}

fn pixel_ray(program: &ChapterProgram, pixel: &CameraPixel) -> Ray {
    // The text that a reader typed has no camera.
    let own = program.ray(pixel.width, pixel.i, pixel.j);
    own.unwrap_or_else(|| pixel.expected_ray())
}

/// Calls `act` with the functions and operators of a program's vectors and rays.
fn with_prelude<T>(program: &ChapterProgram, act: impl FnOnce(&Prelude) -> T) -> T {
    let number = |name: &str, given: &mut [Value]| {
        let number = program.call(name, given).and_then(|it| it.float());
        number.unwrap_or(f64::NAN)
    };
    let vector = |name: &str, given: &mut [Value]| {
        let vector = program.call(name, given).and_then(|it| it.vec3());
        vector.unwrap_or(Vec3::NAN)
    };
    act(&Prelude {
        mul: &|t, v| vector("f64::mul", &mut [t.into(), v.into()]),
        add: &|u, v| vector("DVec3::add", &mut [u.into(), v.into()]),
        neg: &|v| vector("DVec3::neg", &mut [v.into()]),
        sub: &|u, v| vector("DVec3::sub", &mut [u.into(), v.into()]),
        dot: &|u, v| number("DVec3::dot", &mut [u.into(), v.into()]),
        length_squared: &|v| number("DVec3::length_squared", &mut [v.into()]),
        length: &|v| number("DVec3::length", &mut [v.into()]),
        normalize: &|v| vector("DVec3::normalize", &mut [v.into()]),
        ray: &|origin, direction| {
            let ray = program.call("Ray::new", &mut [origin.into(), direction.into()]);
            let nowhere = Ray {
                origin: Point3::NAN,
                direction: Vec3::NAN,
            };
            ray.and_then(|it| it.ray()).unwrap_or(nowhere)
        },
        at: &|ray, t| vector("Ray::at", &mut [ray.into(), t.into()]),
    })
}

/// Returns the scene (sky, disc, ball or list of spheres) whose colors the `ray_color` of a chapter
/// has to return; the sky for the build test, chapter 0, which has no such function.
fn scene(chapter: Chapter) -> ChapterScene {
    match chapter {
        Chapter::BuildTest | Chapter::Gradient => ChapterScene::Sky,
        Chapter::RedSphere => ChapterScene::Disc,
        Chapter::Normals | Chapter::HalfBSphere => ChapterScene::Ball,
        Chapter::HittableList | Chapter::SpeedVsAccuracy => ChapterScene::List,
    }
}

/// Tests the functions that a program's chapter introduces against their laws, properties that must
/// hold for every ray: the intersection with a sphere, then `ray_color`.
///
/// # Errors
/// If a function breaks a law; only the first one is reported.
pub fn try_laws(program: &ChapterProgram, trial: &Trial) -> Outcome {
    let solve = |center, radius, ray: &Ray| program.hit_sphere(center, radius, ray);
    let record = |asked: &IntervalCase| record(program, asked);
    match program.chapter {
        Chapter::RedSphere => {
            trial.decision(&|center, radius, ray| solve(center, radius, ray).is_some())?;
        }
        Chapter::Normals | Chapter::HalfBSphere => trial.nearer_root(&solve)?,
        Chapter::HittableList => {
            trial.record(&record)?;
            trial.list(&record, &|world| nearest(program, world))?;
        }
        _ => {}
    }
    trial.ray_color(scene(program.chapter), &|ray| program.ray_color(ray))
}

/// Tests all functions of a program by the laws: those for vectors and the camera, then those of
/// [`try_laws`].
///
/// # Errors
/// If a function breaks a law; only the first one is reported.
pub fn try_all_laws(program: &ChapterProgram, trial: &Trial) -> Outcome {
    with_prelude(program, |prelude| trial.prelude(prelude))?;
    trial.pixel_ray(&|pixel| pixel_ray(program, pixel))?;
    try_laws(program, trial)
}
