//! A trial: a function is put under all laws that there are for its kind, and found
//! wrong with one report, which names the cause.
//!
//! Cases are made and made smaller by proptest: see its book on `TestRunner`.

use std::fmt;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;

use common::rtweekend::*;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestError, TestRunner};
use slips::{Ball, Chapter, Program};
use speed_vs_accuracy::Case;

use crate::answers::{self, ANSWERS};
use crate::broken::{Broken, Verdict};
use crate::camera::{Pixel, the_ray_of_a_pixel_goes_through_its_center};
use crate::causes::Cause;
use crate::intervals::{NEAREST_IN_RANGE, RangeSolver, WithInterval};
use crate::list::{self, World};
use crate::nearer_root::{self, NEARER_ROOT, Solver, decision};
use crate::prelude::{self, Asked, FUNCTIONS, Prelude};
use crate::question::{Question, numbers, of_ray};
use crate::ray_color::{self, Traced};
use crate::record::{Recorded, Recorder, both_records_obey_the_laws};
use crate::strategies::{config, samples};

/// `Ok` if every law holds.
pub type Outcome = Result<(), Box<Report>>;

/// What a trial found wrong with a function.
#[derive(Clone, Debug)]
pub struct Report {
    /// The law, as the smallest case that was found breaks it.
    pub broken: Broken,
    /// What makes it so.
    pub cause: Cause,
    /// The test that asks about this case again.
    pub test: String,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let usually = self.cause.lines(self.broken.usually).join("\n          ");
        let law = self.broken.to_string();
        writeln!(f, "{}", law.replacen(self.broken.usually, &usually, 1))?;
        let body = self.test.replace('\n', "\n    ");
        write!(
            f,
            "\n// Beside the test that failed:\n\
             #[test]\nfn this_case_is_right() {{\n    use common::rtweekend::*;\n    {body}\n}}"
        )
    }
}

/// How functions of a chapter are tried.
///
/// This is what a reader does in a test of their own, in a package that has
/// `common` and `laws` among its `[dev-dependencies]`, as
/// `{ path = "…/common" }` and `{ path = "…/tests/laws" }`:
///
/// ```
/// use common::rtweekend::*;
/// use laws::trial::all_succeed;
/// use laws::{Chapter, Trial};
///
/// /// Your own function, as you typed it.
/// fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
///     let oc = center - ray.origin;
///     let a = ray.direction.length_squared();
///     let h = ray.direction.dot(oc);
///     let c = oc.length_squared() - radius * radius;
///     let discriminant = h * h - a * c;
///     (discriminant >= 0.0).then(|| (h - discriminant.sqrt()) / a)
/// }
///
/// let trial = Trial::of(Chapter::HalfBSphere);
/// all_succeed([trial.nearer_root(&hit_sphere)]);
/// ```
///
/// It panics if a law is broken, and says which, by what, and which mistake gives such answers:
///
/// ```should_panic
/// # use laws::{trial::all_succeed, Chapter, Ray, Trial};
/// let trial = Trial::of(Chapter::HalfBSphere);
/// all_succeed([trial.nearer_root(&|_center, _radius, _ray: &Ray| None)]);
/// ```
#[derive(Clone, Debug)]
pub struct Trial {
    /// The chapter: mistakes in it are looked for.
    pub chapter: Chapter,
    /// On how many cases each law is tried.
    pub cases: u32,
    /// The file to which [answers] are added.
    pub answers: Option<PathBuf>,
}

/// Panics with the first report, if there is one. All functions are tried before, so that
/// all that they answer can be kept.
///
/// # Panics
/// If a law is broken.
pub fn all_succeed<const N: usize>(outcomes: [Outcome; N]) {
    for outcome in outcomes {
        if let Err(report) = outcome {
            panic!("\n\n{report}\n");
        }
    }
}

/// A law of a function under trial.
type Law<'a, Q> = Box<dyn Fn(&Q) -> Verdict + 'a>;

/// A function under trial, as it answers in plain numbers.
type Answer<'a, Q> = dyn Fn(&Q) -> Vec<f64> + 'a;

impl Trial {
    /// With as many cases as [`config`] says, and with the file that the environment
    /// variable [`ANSWERS`] names.
    pub fn of(chapter: Chapter) -> Self {
        Self {
            chapter,
            cases: config().cases,
            answers: std::env::var_os(ANSWERS).map(PathBuf::from),
        }
    }

    /// A function that only decides whether the line meets the sphere, as in chapter 2.
    pub fn decision(&self, decide: &dyn Fn(Point3, f64, &Ray) -> bool) -> Outcome {
        let is_hit = |case: &Case| decide(case.center, case.radius, &case.ray);
        self.on_the_line(
            &|case| numbers(is_hit(case).then_some([0.0])),
            &decision(decide),
        )
    }

    /// A function that returns the nearer root, as in chapters 3 and 4.
    pub fn nearer_root(&self, solve: &Solver) -> Outcome {
        self.on_the_line(&|case| numbers(case.solve(solve).map(|t| [t])), solve)
    }

    fn on_the_line(&self, answer: &Answer<Case>, solve: &Solver) -> Outcome {
        let law = |law: nearer_root::Law| -> Law<Case> { Box::new(move |case| law(solve, case)) };
        self.obeys(answer, &NEARER_ROOT.map(law))
    }

    /// A function that returns the nearest root between `t_min` and `t_max`, as the
    /// sphere of chapter 5: on the whole line, that is the nearer root.
    pub fn nearest_in_range(&self, solve: &RangeSolver) -> Outcome {
        let (least, greatest) = (f64::NEG_INFINITY, f64::INFINITY);
        let nearer = |center, radius, ray: &Ray| solve(center, radius, ray, least, greatest);
        let on_the_line = NEARER_ROOT
            .map(|law| -> Law<WithInterval> { Box::new(move |asked| law(&nearer, &asked.case)) });
        let in_range = NEAREST_IN_RANGE
            .map(|law| -> Law<WithInterval> { Box::new(move |asked| law(solve, asked)) });
        let laws: Vec<_> = on_the_line.into_iter().chain(in_range).collect();
        self.obeys(
            &|asked: &WithInterval| numbers(asked.solve(solve).map(|t| [t])),
            &laws,
        )
    }

    /// A function that returns the record of the nearest hit between `t_min` and
    /// `t_max`: its normal, and its side. That `t` is right is another trial.
    pub fn record(&self, record: &Recorder) -> Outcome {
        let law = |asked: &Recorded| both_records_obey_the_laws(record, asked);
        self.obeys(&|asked: &Recorded| asked.answer(record), &[Box::new(law)])
    }

    /// A list that is searched for the nearest hit.
    pub fn list(&self, search: &list::Search) -> Outcome {
        let law = |world: &World| list::the_nearest_of_all_members_is_returned(search, world);
        self.obeys(
            &|world| numbers(search(world).map(|t| [t])),
            &[Box::new(law)],
        )
    }

    /// The functions of a prelude, up to the first that is wrong: what follows may be built
    /// on it. One that is not written yet is not asked.
    pub fn prelude(&self, prelude: &Prelude) -> Outcome {
        for function in &FUNCTIONS {
            let telling = samples(&function.questions(), 20);
            if !is_written(|| telling[0].put_to(prelude)) {
                continue;
            }
            let law = |asked: &Asked| prelude::small_numbers_are_worked_out_by_head(prelude, asked);
            let cases = [function.questions().boxed()];
            let answer = |asked: &Asked| asked.put_to(prelude);
            self.obeys_on(&cases, telling, &answer, &[Box::new(law)])?;
        }
        Ok(())
    }

    /// The ray of a pixel.
    pub fn pixel_ray(&self, ray: &dyn Fn(&Pixel) -> Ray) -> Outcome {
        let law = |pixel: &Pixel| the_ray_of_a_pixel_goes_through_its_center(&ray(pixel), pixel);
        self.obeys(&|pixel| of_ray(ray(pixel)), &[Box::new(law)])
    }

    /// The `ray_color` of the chapter, about rays that its camera never casts. Says nothing
    /// where the picture is wrong already.
    pub fn ray_color(&self, ray_color: &dyn Fn(&Ray) -> Color) -> Outcome {
        if !Traced::looks_right(self.chapter, ray_color) {
            return Ok(());
        }
        let color = |traced: &Traced| ray_color(&traced.ray);
        let law =
            |traced: &Traced| ray_color::a_ray_has_its_color_from_anywhere(color(traced), traced);
        let answer = |traced: &Traced| color(traced).to_array().to_vec();
        self.obeys(&answer, &[Box::new(law)])
    }

    /// The functions of a program, as its chapter has them: the intersection, and what
    /// becomes of a hit.
    pub fn program(&self, program: &Program) -> Outcome {
        let ball = |center, radius| Ball { center, radius };
        let solve = |center, radius, ray: &Ray| program.hit_sphere(center, radius, ray);
        match program.chapter {
            Chapter::RedSphere => {
                self.decision(&|center, radius, ray| solve(center, radius, ray).is_some())?;
            }
            Chapter::Normals | Chapter::HalfBSphere => self.nearer_root(&solve)?,
            Chapter::HittableList => {
                self.nearest_in_range(&|center, radius, ray, t_min, t_max| {
                    program.hit(ball(center, radius), ray, t_min, t_max)
                })?;
                self.record(&|center, radius, ray, t_min, t_max| {
                    program.record(ball(center, radius), ray, t_min, t_max)
                })?;
                self.list(&|world| world.put_to_program(program))?;
            }
            _ => {}
        }
        self.ray_color(&|ray| program.ray_color(ray))
    }

    fn obeys<Q: Question>(&self, answer: &Answer<Q>, laws: &[Law<Q>]) -> Outcome {
        let telling = Q::telling(self.chapter);
        self.obeys_on(&Q::cases(self.chapter), telling, answer, laws)
    }

    /// Whether every law holds, on cases of one kind after those of another. The `telling`
    /// questions are those to which different mistakes give different answers.
    fn obeys_on<Q: Question>(
        &self,
        kinds: &[BoxedStrategy<Q>],
        telling: Vec<Q>,
        answer: &Answer<Q>,
        laws: &[Law<Q>],
    ) -> Outcome {
        // What panics does so here, and not again and again while a case is made smaller.
        for question in &telling {
            let answer = answer(question);
            if let Some(file) = &self.answers {
                answers::add(file, question, &answer);
            }
        }
        for cases in kinds {
            if let Some((smallest, broken)) = laws.iter().find_map(|law| self.smallest(cases, law))
            {
                return Err(Box::new(Report {
                    broken,
                    test: smallest.as_test(self.chapter),
                    cause: Cause::of(answer, telling, smallest, self.chapter),
                }));
            }
        }
        Ok(())
    }

    /// The smallest case that breaks the law, of those that proptest finds, and how.
    fn smallest<Q: Question>(&self, cases: &BoxedStrategy<Q>, law: &Law<Q>) -> Option<(Q, Broken)> {
        let mut runner = TestRunner::new(Config {
            cases: self.cases,
            ..config()
        });
        match runner.run(cases, |case| Ok(law(&case)?)) {
            Ok(()) => None,
            Err(TestError::Fail(_, smallest)) => {
                let broken = law(&smallest).expect_err("what it finds once breaks the law again");
                Some((smallest, broken))
            }
            Err(TestError::Abort(reason)) => panic!("no law rejects a case: {reason}"),
        }
    }
}

/// Whether something else is there than `todo!()`.
fn is_written<T>(call: impl FnOnce() -> T) -> bool {
    let panicked = panic::catch_unwind(AssertUnwindSafe(call)).err();
    let message = panicked.and_then(|it| it.downcast::<&str>().ok());
    message.is_none_or(|message| *message != "not yet implemented")
}

/// Puts `solve` under every law for a nearer root, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_case(solve: &Solver, case: &Case) {
    holds(NEARER_ROOT.into_iter().map(|law| law(solve, case)));
}

/// Puts a solver with a range under every law for one, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_interval(solve: &RangeSolver, case: Case, t_min: f64, t_max: f64) {
    let (least, greatest) = (f64::NEG_INFINITY, f64::INFINITY);
    one_case(
        &|center, radius, ray| solve(center, radius, ray, least, greatest),
        &case,
    );
    let asked = WithInterval { case, t_min, t_max };
    holds(NEAREST_IN_RANGE.into_iter().map(|law| law(solve, &asked)));
}

/// Puts what records a hit under every law for that, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_record(record: &Recorder, case: &Case) {
    holds([both_records_obey_the_laws(record, &Recorded(*case))].into_iter());
}

fn holds(mut verdicts: impl Iterator<Item = Verdict>) {
    if let Some(broken) = verdicts.find_map(Verdict::err) {
        panic!("\n\n{broken}\n");
    }
}
