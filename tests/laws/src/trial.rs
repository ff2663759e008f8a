//! Property testing of one function: a trial puts it under all laws for its kind, and reports the
//! smallest case found that breaks one.
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

use crate::answers::{self, ANSWERS_VARIABLE, Answered, Answers};
use crate::camera::{CameraPixel, the_ray_of_a_pixel_goes_through_its_center};
use crate::case::{Case, numbers_of_ray};
use crate::face::{SetFaceNormal, the_normal_is_turned_against_the_ray};
use crate::list::{ListSolver, World, the_nearest_of_all_members_is_returned};
use crate::nearer_root::{self, Solver};
use crate::prelude::{
    PRELUDE_FUNCTIONS, Prelude, PreludeQuestion, small_numbers_are_worked_out_by_head,
};
use crate::question::{Question, decided, numbers_of_hit, telling_cases};
use crate::ray_color::{self, ChapterScene, a_ray_has_its_color_from_anywhere};
use crate::record::{self, RecordSolver};
use crate::strategies::{self, config};
use crate::verdict::{BrokenLaw, Complaint, LawResult, Outcome};

/// A trial of the functions of a chapter: each under all *laws* of its kind, properties that a
/// right function has, on cases made by proptest. The outcome is `Ok` if all laws hold, or else the
/// smallest case found that breaks one, or the place of a `todo!()`. Any other panic of a function
/// is passed on.
///
/// Whole numbers and usual ranges are asked first, so that a broken law is shown by a case that the
/// function's author believes. [The package's own page](crate) has examples.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The number of cases on which each law is tried, for each kind of case, such as whole
    /// numbers.
    pub cases: u32,
    /// The file to which answers and verdicts are appended, made if it is missing; `None` keeps no
    /// file.
    pub answers: Option<PathBuf>,
}

impl Default for Trial {
    /// Makes a trial with as many cases as [`config`] has, and with the file that the environment
    /// variable [`ANSWERS_VARIABLE`] names.
    fn default() -> Self {
        Self {
            cases: config().cases,
            answers: std::env::var_os(ANSWERS_VARIABLE).map(PathBuf::from),
        }
    }
}

/// A function that asks the tried function about a case, and lists the answer's numbers.
pub(crate) type AnswerFn<'a, Q> = Box<dyn Fn(&Q) -> Vec<f64> + 'a>;

/// A law about a function's answer to a case.
pub(crate) type Law<'a, Q> = Box<dyn Fn(&Q) -> LawResult + 'a>;

/// The cases and the laws for one function.
pub(crate) struct LawSuite<'a, Q> {
    /// The name of the function.
    pub(crate) of: &'static str,
    /// The cases, one kind after the other: those first that an author believes.
    pub(crate) kinds: Vec<BoxedStrategy<Q>>,
    /// Questions by whose answers mistakes differ.
    pub(crate) telling: Vec<Q>,
    /// Turns a case into a question.
    pub(crate) question: fn(Q) -> Question,
    pub(crate) answer: AnswerFn<'a, Q>,
    /// The laws, those first that teach most.
    pub(crate) laws: Vec<Law<'a, Q>>,
    /// Writes the body of a test that asks about a case again. The test stands beside the reader's
    /// other tests, so the body calls the function without importing it.
    pub(crate) test: &'a dyn Fn(&Q) -> String,
}

impl Trial {
    /// Tries a function that only decides whether the ray's line meets the sphere, as the
    /// `hit_sphere` of chapter 2.
    pub fn decision(&self, decide: &dyn Fn(Point3, f64, &Ray) -> bool) -> Outcome {
        let solve = nearer_root::solver_of_decision(decide);
        self.put(&LawSuite {
            question: Question::Decision,
            answer: Box::new(|case: &Case| decided(case.solve(&solve).is_some())),
            test: &nearer_root::decision_as_test,
            ..nearer_root::suite(&solve)
        })
    }

    /// Tries a function that returns the nearer root, as the `hit_sphere` of chapters 3 and 4.
    pub fn nearer_root(&self, solve: &Solver) -> Outcome {
        self.put(&nearer_root::suite(solve))
    }

    /// Tries a function that returns the record of the nearest hit in an interval, as the
    /// `Sphere::hit` of chapter 5. For an unbounded interval, the record's `t` must be the nearer
    /// root.
    pub fn record(&self, record: &RecordSolver) -> Outcome {
        self.put(&record::suite(record))
    }

    /// Tries `search`, a list's search for the nearest hit of its spheres, as the
    /// `HittableList::hit` of chapter 5. Each sphere's own answer comes from `record`.
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
            laws: vec![Box::new(|world| {
                the_nearest_of_all_members_is_returned(record, search, world)
            })],
            test: &World::as_test,
        });
        if let Err(Complaint::Broken(report)) = &mut outcome {
            // What is wrong with the list alone is no mistake of its spheres.
            let asked = telling_cases(&strategies::ordinary_with_interval()).into_iter();
            let own = asked.map(|asked| {
                let answer = numbers_of_hit(&asked, record(&asked));
                let question = Question::Record(asked);
                Answered { question, answer }
            });
            report.answers.given.splice(0..0, own);
        }
        self.kept("list", outcome)
    }

    /// Tries the operators and functions of a program's own vectors and rays, in the order of
    /// [`PRELUDE_FUNCTIONS`], up to the first that breaks a law: those after it may be built on it.
    /// A `todo!()` is reported only if no function breaks a law.
    pub fn prelude(&self, prelude: &Prelude) -> Outcome {
        let mut outcome = Ok(());
        for function in &PRELUDE_FUNCTIONS {
            let one = self.outcome(&LawSuite {
                of: function.name(),
                kinds: vec![function.questions().boxed()],
                telling: function.telling_cases(),
                question: Question::Prelude,
                answer: Box::new(|asked| asked.put_to(prelude)),
                laws: vec![Box::new(|asked| {
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
        self.kept("prelude", outcome)
    }

    /// Tries the function of a camera that returns the ray through a pixel, on pictures of many
    /// widths.
    pub fn pixel_ray(&self, ray: &dyn Fn(&CameraPixel) -> Ray) -> Outcome {
        self.put(&LawSuite {
            of: "pixel_ray",
            kinds: vec![strategies::pixels().boxed()],
            telling: telling_cases(&strategies::pixels()),
            question: Question::PixelRay,
            answer: Box::new(|pixel| numbers_of_ray(ray(pixel))),
            laws: vec![Box::new(|pixel| {
                the_ray_of_a_pixel_goes_through_its_center(&ray(pixel), pixel)
            })],
            test: &CameraPixel::as_test,
        })
    }

    /// Tries the `ray_color` of a chapter's scene, each component of its colors, also on rays that
    /// the book's camera never casts. Makes no claim, and returns `Ok`, where the levels of the
    /// book's own picture are wrong already: there the picture shows the mistake.
    pub fn ray_color(&self, scene: ChapterScene, ray_color: &dyn Fn(&Ray) -> Color) -> Outcome {
        match written(|| scene.looks_right(ray_color)) {
            Ok(true) => self.put(&LawSuite {
                of: "ray_color",
                kinds: vec![ray_color::rays().boxed()],
                telling: telling_cases(&ray_color::rays()),
                question: Question::RayColor,
                answer: Box::new(|ray| ray_color(ray).to_array().to_vec()),
                laws: vec![Box::new(|ray| {
                    a_ray_has_its_color_from_anywhere(scene, ray_color(ray), ray)
                })],
                test: &|ray| scene.as_test(ray),
            }),
            Ok(false) => Ok(()),
            Err(complaint) => self.kept("ray_color", Err(complaint)),
        }
    }

    /// Tries the function that turns a normal against the ray, as the `set_face_normal` of chapter
    /// 5, on pairs of unit vectors: no sphere is needed. Its report has no answers and no test.
    ///
    /// # Panics
    /// If the function panics, other than by a `todo!()`.
    pub fn set_face_normal(&self, set_face_normal: &SetFaceNormal) -> Outcome {
        let law = |&(direction, outward): &(Vec3, Vec3)| {
            the_normal_is_turned_against_the_ray(set_face_normal, direction, outward)
        };
        let pairs = (strategies::unit(), strategies::unit()).boxed();
        let smallest = written(|| self.smallest(&pairs, law));
        let outcome = smallest.and_then(|smallest| match smallest {
            None => Ok(()),
            Some((_, broken)) => Err(Complaint::of(broken, Answers::default(), String::new())),
        });
        self.kept("set_face_normal", outcome)
    }

    /// Tries a function on its suite, and appends the verdict to the file.
    fn put<Q: Clone + Debug>(&self, suite: &LawSuite<Q>) -> Outcome {
        self.kept(suite.of, self.outcome(suite))
    }

    /// Appends the verdict on a function to the file, if there is one, and returns it.
    fn kept(&self, of: &'static str, outcome: Outcome) -> Outcome {
        if let Some(file) = &self.answers {
            answers::append(file, answers::verdict_line(of, &outcome));
        }
        outcome
    }

    /// Adds an answer to the list, and to the file, if there is one.
    fn keep_answer(&self, answers: &mut Answers, question: Question, answer: Vec<f64>) {
        if let Some(file) = &self.answers {
            answers::append(file, answers::answer_line(&question, &answer));
        }
        answers.given.push(Answered { question, answer });
    }

    /// Asks a function its telling questions, and tries its laws on all cases.
    fn outcome<Q: Clone + Debug>(&self, suite: &LawSuite<Q>) -> Outcome {
        let mut answers = Answers::default();
        // What panics does so here, and not again and again while a case is made smaller.
        for asked in &suite.telling {
            let answer = written(|| (suite.answer)(asked))?;
            self.keep_answer(&mut answers, (suite.question)(asked.clone()), answer);
        }
        let Some((smallest, broken)) = suite.kinds.iter().find_map(|cases| {
            // All laws at once first: a right function is asked about each case only once.
            self.smallest(cases, |case| {
                suite.laws.iter().try_for_each(|law| law(case))
            })?;
            suite.laws.iter().find_map(|law| self.smallest(cases, law))
        }) else {
            return Ok(());
        };
        let (test, answer) = ((suite.test)(&smallest), (suite.answer)(&smallest));
        self.keep_answer(&mut answers, (suite.question)(smallest), answer);
        Err(Complaint::of(broken, answers, test))
    }

    /// Returns the smallest case found by proptest that breaks the law, and how; `None` if the law
    /// holds.
    fn smallest<Q: Clone + Debug>(
        &self,
        cases: &BoxedStrategy<Q>,
        law: impl Fn(&Q) -> LawResult,
    ) -> Option<(Q, BrokenLaw)> {
        let mut runner = TestRunner::new(Config {
            cases: self.cases,
            ..config()
        });
        match runner.run(cases, |case| Ok(law(&case)?)) {
            Ok(()) => None,
            Err(TestError::Fail(_, smallest)) => {
                let broken = law(&smallest).expect_err("what breaks a law once breaks it again");
                Some((smallest, broken))
            }
            Err(TestError::Abort(reason)) => panic!("no law rejects a case: {reason}"),
        }
    }
}

thread_local! {
    /// The place of the last `todo!()` that this thread came upon.
    static UNWRITTEN: Cell<Option<String>> = const { Cell::new(None) };
}

/// Returns the result of `call`, or the place of the `todo!()` that `call` comes upon, which then
/// prints nothing. Other panics are passed on.
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
