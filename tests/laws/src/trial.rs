//! A trial: a function is put under all laws that there are for its kind, and found wrong with
//! one report.
//!
//! Cases are made and made smaller by proptest: see its book on `TestRunner`.

use std::cell::Cell;
use std::fmt::Debug;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;
use std::sync::Once;

use common::rtweekend::*;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestError, TestRunner};
use speed_vs_accuracy::Case;

use crate::answers::{ANSWERS_VARIABLE, AnswerLine, Answered, Answers};
use crate::camera::{CameraPixel, the_ray_of_a_pixel_goes_through_its_center};
use crate::face::{SetFaceNormal, the_normal_is_turned_against_the_ray};
use crate::list::{ListSolver, World, the_nearest_of_all_members_is_returned};
use crate::nearer_root::{self, Solver};
use crate::prelude::{FUNCTIONS, Prelude, PreludeQuestion, small_numbers_are_worked_out_by_head};
use crate::question::{Question, decided, of_hit, of_ray, telling_cases};
use crate::ray_color::{self, ChapterScene, a_ray_has_its_color_from_anywhere};
use crate::record::{self, RecordSolver};
use crate::strategies::{self, config};
use crate::verdict::{BrokenLaw, Complaint, LawResult, Outcome, Report};

/// How the functions of a chapter are tried.
///
/// This is what a reader does in a test of their own, in a package that has
/// `common` and `laws` among its `[dev-dependencies]`, as
/// `{ path = "…/common" }` and `{ path = "…/tests/laws" }`:
///
/// ```
/// use common::rtweekend::*;
/// use laws::{Trial, holds};
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
/// // Panics if a law is broken, and says which, and by what.
/// holds(Trial::default().nearer_root(&hit_sphere));
/// ```
#[derive(Clone, Debug)]
pub struct Trial {
    /// On how many cases each law is tried.
    pub cases: u32,
    /// The file to which answers and verdicts are added.
    pub answers: Option<PathBuf>,
}

impl Default for Trial {
    /// With as many cases as [`config`] says, and with the file that the environment
    /// variable [`ANSWERS_VARIABLE`] names.
    fn default() -> Self {
        Self {
            cases: config().cases,
            answers: std::env::var_os(ANSWERS_VARIABLE).map(PathBuf::from),
        }
    }
}

/// A law about what a function answers to the question.
pub(crate) type Law<'a, Q> = Box<dyn Fn(&Q) -> LawResult + 'a>;

/// Asks a function, and writes its answer as numbers.
pub(crate) type AnswerFn<'a, Q> = Box<dyn Fn(&Q) -> Vec<f64> + 'a>;

/// The cases and the laws for one function.
pub(crate) struct LawSuite<'a, Q> {
    /// The name of the function.
    pub(crate) of: &'static str,
    /// The cases, one kind after the other.
    pub(crate) kinds: Vec<BoxedStrategy<Q>>,
    /// Questions to which different mistakes give different answers.
    pub(crate) telling: Vec<Q>,
    pub(crate) question: fn(Q) -> Question,
    pub(crate) answer: AnswerFn<'a, Q>,
    pub(crate) laws: Vec<Law<'a, Q>>,
    /// The body of a test that asks this again. It stands where the function has its name, so it
    /// need not guess from where to import it.
    pub(crate) test: &'a dyn Fn(&Q) -> String,
}

impl Trial {
    /// Tries a function that only decides whether the line meets the sphere, as in chapter 2.
    ///
    /// # Errors
    /// As every method here: the smallest case found that breaks a law, or a `todo!()`.
    pub fn decision(&self, decide: &dyn Fn(Point3, f64, &Ray) -> bool) -> Outcome {
        let solve = nearer_root::solver_of_decision(decide);
        self.put(&LawSuite {
            question: Question::Decision,
            answer: Box::new(|case: &Case| decided(case.solve(&solve).is_some())),
            test: &nearer_root::decision_as_test,
            ..nearer_root::suite(&solve)
        })
    }

    /// Tries a function that returns the nearer root, as in chapters 3 and 4.
    ///
    /// # Errors
    /// See [`Trial::decision`].
    pub fn nearer_root(&self, solve: &Solver) -> Outcome {
        self.put(&nearer_root::suite(solve))
    }

    /// Tries a function that returns the record of the nearest hit between `t_min` and `t_max`, as
    /// the sphere of chapter 5. On the whole line, its `t` is the nearer root.
    ///
    /// # Errors
    /// See [`Trial::decision`].
    pub fn record(&self, record: &RecordSolver) -> Outcome {
        self.put(&record::suite(record))
    }

    /// Tries a list that is searched for the nearest hit of its spheres, whose own answers are the
    /// records.
    ///
    /// # Errors
    /// See [`Trial::decision`].
    pub fn list(&self, record: &RecordSolver, search: &ListSolver) -> Outcome {
        let mut outcome = self.outcome(&LawSuite {
            of: "list",
            kinds: vec![
                strategies::whole_worlds().boxed(),
                strategies::worlds().boxed(),
            ],
            telling: telling_cases(&strategies::worlds()),
            question: Question::Nearest,
            answer: Box::new(|world| search(world).into_iter().collect()),
            laws: vec![Box::new(|world: &World| {
                the_nearest_of_all_members_is_returned(record, search, world)
            })],
            test: &World::as_test,
        });
        if let Err(Complaint::Broken(report)) = &mut outcome {
            // What is wrong with the list alone is no mistake of its spheres.
            let asked = telling_cases(&strategies::ordinary_with_interval()).into_iter();
            let own = asked.map(|asked| {
                let answer = of_hit(&asked, record(&asked));
                let question = Question::Record(asked);
                Answered { question, answer }
            });
            report.answers.given.splice(0..0, own);
        }
        self.kept("list", outcome)
    }

    /// Tries the functions of a prelude, up to the first that is wrong: those that follow may be
    /// built on it. One that is not written yet is told if no other is wrong.
    ///
    /// # Errors
    /// See [`Trial::decision`].
    pub fn prelude(&self, prelude: &Prelude) -> Outcome {
        let mut outcome = Ok(());
        for function in &FUNCTIONS {
            let one = self.outcome(&LawSuite {
                of: function.name(),
                kinds: vec![function.questions().boxed()],
                telling: function.telling_cases(),
                question: Question::Prelude,
                answer: Box::new(|asked| asked.put_to(prelude)),
                laws: vec![Box::new(|asked: &PreludeQuestion| {
                    small_numbers_are_worked_out_by_head(prelude, asked)
                })],
                test: &PreludeQuestion::as_test,
            });
            if matches!(one, Err(Complaint::Broken(_))) {
                outcome = one;
                break;
            }
            outcome = outcome.and(one);
        }
        self.keep(&AnswerLine::Verdict("prelude", &outcome));
        outcome
    }

    /// Tries the function that returns the ray of a pixel.
    ///
    /// # Errors
    /// See [`Trial::decision`].
    pub fn pixel_ray(&self, ray: &dyn Fn(&CameraPixel) -> Ray) -> Outcome {
        self.put(&LawSuite {
            of: "pixel_ray",
            kinds: vec![strategies::pixels().boxed()],
            telling: telling_cases(&strategies::pixels()),
            question: Question::PixelRay,
            answer: Box::new(|pixel| of_ray(ray(pixel))),
            laws: vec![Box::new(|pixel: &CameraPixel| {
                the_ray_of_a_pixel_goes_through_its_center(&ray(pixel), pixel)
            })],
            test: &CameraPixel::as_test,
        })
    }

    /// Tries the `ray_color` of a scene on rays that its camera never casts. Makes no claim where
    /// the picture is wrong already.
    ///
    /// # Errors
    /// See [`Trial::decision`].
    pub fn ray_color(&self, scene: ChapterScene, ray_color: &dyn Fn(&Ray) -> Color) -> Outcome {
        let law = |ray: &Ray| a_ray_has_its_color_from_anywhere(scene, ray_color(ray), ray);
        let suite = LawSuite {
            of: "ray_color",
            kinds: vec![ray_color::rays().boxed()],
            telling: telling_cases(&ray_color::rays()),
            question: Question::RayColor,
            answer: Box::new(|ray| ray_color(ray).to_array().to_vec()),
            laws: vec![Box::new(law)],
            test: &|ray| scene.as_test(ray),
        };
        match written(|| scene.looks_right(ray_color)) {
            Ok(true) => self.put(&suite),
            Ok(false) => Ok(()),
            Err(complaint) => self.kept("ray_color", Err(complaint)),
        }
    }

    /// Tries the function of a record that turns the normal, which can be asked before there is a
    /// sphere.
    ///
    /// # Errors
    /// See [`Trial::decision`].
    pub fn set_face_normal(&self, set_face_normal: &SetFaceNormal) -> Outcome {
        let law: Law<(Vec3, Vec3)> = Box::new(|&(direction, outward)| {
            the_normal_is_turned_against_the_ray(set_face_normal, direction, outward)
        });
        let pairs = (strategies::unit(), strategies::unit()).boxed();
        let smallest = written(|| self.smallest(&pairs, &law));
        let outcome = smallest.and_then(|smallest| match smallest {
            None => Ok(()),
            Some((_, broken)) => Err(Complaint::Broken(Box::new(Report {
                broken,
                answers: Answers::default(),
                same_as: Vec::new(),
                test: String::new(),
            }))),
        });
        self.kept("set_face_normal", outcome)
    }

    /// Puts a function under its laws, and keeps what comes of it.
    pub(crate) fn put<Q: Clone + Debug>(&self, suite: &LawSuite<Q>) -> Outcome {
        self.kept(suite.of, self.outcome(suite))
    }

    fn kept(&self, of: &'static str, outcome: Outcome) -> Outcome {
        self.keep(&AnswerLine::Verdict(of, &outcome));
        outcome
    }

    fn keep_answer(&self, answers: &mut Answers, question: Question, answer: Vec<f64>) {
        self.keep(&AnswerLine::Answer(&question, &answer));
        answers.given.push(Answered { question, answer });
    }

    fn keep(&self, line: &AnswerLine) {
        if let Some(file) = &self.answers {
            line.keep(file);
        }
    }

    fn outcome<Q: Clone + Debug>(&self, suite: &LawSuite<Q>) -> Outcome {
        let mut answers = Answers::default();
        // What panics does so here, and not again and again while a case is made smaller.
        for asked in &suite.telling {
            let answer = written(|| (suite.answer)(asked))?;
            self.keep_answer(&mut answers, (suite.question)(asked.clone()), answer);
        }
        let smallest = |cases| suite.laws.iter().find_map(|law| self.smallest(cases, law));
        let Some((smallest, broken)) = suite.kinds.iter().find_map(smallest) else {
            return Ok(());
        };
        let (test, answer) = ((suite.test)(&smallest), (suite.answer)(&smallest));
        self.keep_answer(&mut answers, (suite.question)(smallest), answer);
        Err(Complaint::Broken(Box::new(Report {
            broken,
            answers,
            same_as: Vec::new(),
            test,
        })))
    }

    /// Returns the smallest case that breaks the law, of those that proptest finds, and how.
    fn smallest<Q: Clone + Debug>(
        &self,
        cases: &BoxedStrategy<Q>,
        law: &Law<Q>,
    ) -> Option<(Q, BrokenLaw)> {
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

thread_local! {
    /// Where this thread came upon a `todo!()` last.
    static UNWRITTEN: Cell<Option<String>> = const { Cell::new(None) };
}

/// Returns the result of `call`, or the place of the `todo!()` that it comes upon, which then
/// prints nothing.
fn written<T>(call: impl FnOnce() -> T) -> Result<T, Complaint> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            let message = info.payload_as_str().unwrap_or_default();
            let place = info.location().map(ToString::to_string);
            match place.filter(|_| message.starts_with("not yet implemented")) {
                Some(place) => UNWRITTEN.set(Some(place)),
                None => before(info),
            }
        }));
    });
    let done = panic::catch_unwind(AssertUnwindSafe(call));
    done.map_err(|panicked| match UNWRITTEN.take() {
        Some(place) => Complaint::NotWritten(place),
        None => panic::resume_unwind(panicked),
    })
}
