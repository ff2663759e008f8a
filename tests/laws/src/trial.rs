//! A trial: a function is put under all laws that there are for its kind, and found
//! wrong with one report, which names the known mistakes that give the same answers.
//!
//! Cases are made and made smaller by proptest: see its book on `TestRunner`.

use std::fmt;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;

use common::rtweekend::*;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestCaseError, TestError, TestRunner};
use slips::{Chapter, Letters, Program};

use crate::Verdict;
use crate::answers::{self, ANSWERS, Answers};
use crate::camera::{Pixel, the_ray_of_a_pixel_goes_through_its_center};
use crate::causes::Cause;
use crate::list::{Search, World, the_nearest_of_all_members_is_returned};
use crate::nearer_root::{self, NEARER_ROOT, Solver};
use crate::prelude::{Asked, FUNCTIONS, Prelude, small_numbers_are_worked_out_by_head};
use crate::question::{Question, WithInterval, of_ray};
use crate::ray_color::{a_ray_has_its_color_from_anywhere, looks_right};
use crate::record::{self, Recorder};
use crate::strategies::{self, config, telling};

/// `Ok` if every law holds.
pub type Outcome = Result<(), Box<Report>>;

/// What a trial found wrong with a function.
#[derive(Clone, Debug)]
pub struct Report {
    /// The law, as the smallest case that was found breaks it.
    broken: String,
    /// Which known mistakes give the same answers.
    pub cause: Cause,
    /// The test that asks about this case again.
    test: String,
}

impl Report {
    /// The sentence of the law.
    pub fn law(&self) -> &str {
        let law = self.broken.strip_prefix("the law:  ");
        law.and_then(|law| law.lines().next())
            .expect("it begins so")
    }

    /// The law, the value, the bound and the page, a line or more each. Before the page stands what
    /// is known `besides`, or else which known mistakes give the same answers.
    pub fn message(&self, besides: Option<&str>) -> String {
        let alike = self.cause.lines().join("\n          ");
        let (label, known) = besides.map_or(("same as:  ", &*alike), |it| ("besides:  ", it));
        if known.is_empty() {
            return self.broken.clone();
        }
        let known = format!("\n{label}{known}\nread:");
        self.broken.replacen("\nread:", &known, 1)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.message(None))?;
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
/// use laws::{Chapter, Trial, all_succeed};
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
/// // Panics if a law is broken, and says which, by what, and which mistake gives such answers.
/// all_succeed([trial.nearer_root(&hit_sphere)]);
/// ```
#[derive(Clone, Debug)]
pub struct Trial {
    /// The chapter: mistakes in it are looked for.
    pub chapter: Chapter,
    /// On how many cases each law is tried.
    pub cases: u32,
    /// The file to which [answers] are added.
    pub answers: Option<PathBuf>,
    /// The language in which the mistakes are said.
    pub letters: Letters,
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

/// Panics if a law does not hold for one case.
///
/// # Panics
/// With what the law says.
pub fn holds(law: Verdict) {
    if let Err(broken) = law {
        panic!("\n\n{}\n", message(&broken));
    }
}

/// What a law says, without the place of its `prop_assert!`.
fn message(broken: &TestCaseError) -> String {
    let TestCaseError::Fail(why) = broken else {
        unreachable!("no law rejects a case");
    };
    let message = why.message();
    let place = message.rfind(" at ").unwrap_or(message.len());
    message[..place].to_owned()
}

/// A function under trial, as it answers in plain numbers.
pub(crate) type Answer<'a, Q> = &'a dyn Fn(&Q) -> Vec<f64>;

impl Trial {
    /// With as many cases as [`config`] says, and with the file that the environment
    /// variable [`ANSWERS`] names.
    pub fn of(chapter: Chapter) -> Self {
        Self {
            chapter,
            cases: config().cases,
            answers: std::env::var_os(ANSWERS).map(PathBuf::from),
            letters: Letters::Rust,
        }
    }

    /// A function that only decides whether the line meets the sphere, as in chapter 2.
    pub fn decision(&self, decide: &dyn Fn(Point3, f64, &Ray) -> bool) -> Outcome {
        self.nearer_root(&nearer_root::decision(decide))
    }

    /// A function that returns the nearer root, as in chapters 3 and 4.
    pub fn nearer_root(&self, solve: &Solver) -> Outcome {
        let law = |law: nearer_root::Law| move |asked: &WithInterval| law(solve, &asked.case);
        self.of_a_sphere(
            &|asked| record::root(self.chapter, solve, asked),
            &NEARER_ROOT.map(law),
        )
    }

    /// A function that returns the record of the nearest hit between `t_min` and `t_max`, as
    /// the sphere of chapter 5. On the whole line, its `t` is the nearer root.
    pub fn record(&self, record: &Recorder) -> Outcome {
        let law = |asked: &WithInterval| record::obeys_every_law(record, asked);
        self.of_a_sphere(&|asked| record::numbers(asked, record), &[law])
    }

    /// A list that is searched for the nearest hit.
    pub fn list(&self, search: &Search) -> Outcome {
        let law = |world: &World| the_nearest_of_all_members_is_returned(search, world);
        let answer = |world: &World| search(world).into_iter().collect();
        self.obeys(strategies::worlds(), &answer, law)
    }

    /// The functions of a prelude, up to the first that is wrong: what follows may be built
    /// on it. One that is not written yet is not asked.
    pub fn prelude(&self, prelude: &Prelude) -> Outcome {
        let law = |asked: &Asked| small_numbers_are_worked_out_by_head(prelude, asked);
        for function in &FUNCTIONS {
            let (kind, telling) = (function.questions().boxed(), function.telling());
            if is_written(|| telling[0].put_to(prelude)) {
                self.obeys_on(&[kind], telling, &|asked| asked.put_to(prelude), &[law])?;
            }
        }
        Ok(())
    }

    /// The ray of a pixel.
    pub fn pixel_ray(&self, ray: &dyn Fn(&Pixel) -> Ray) -> Outcome {
        let law = |pixel: &Pixel| the_ray_of_a_pixel_goes_through_its_center(&ray(pixel), pixel);
        self.obeys(strategies::pixels(), &|pixel| of_ray(ray(pixel)), law)
    }

    /// The `ray_color` of the chapter, about rays that its camera never casts. Says nothing
    /// where the picture is wrong already.
    pub fn ray_color(&self, ray_color: &dyn Fn(&Ray) -> Color) -> Outcome {
        if !looks_right(self.chapter, ray_color) {
            return Ok(());
        }
        let law = |ray: &Ray| a_ray_has_its_color_from_anywhere(self.chapter, ray_color(ray), ray);
        let answer = |ray: &Ray| ray_color(ray).to_array().to_vec();
        self.obeys(strategies::rays(), &answer, law)
    }

    /// The functions of a program, as its chapter has them: the intersection, and what
    /// becomes of a hit.
    pub fn program(&self, program: &Program) -> Outcome {
        let solve = |center, radius, ray: &Ray| program.hit_sphere(center, radius, ray);
        match program.chapter {
            Chapter::RedSphere => {
                self.decision(&|center, radius, ray| solve(center, radius, ray).is_some())?;
            }
            Chapter::Normals | Chapter::HalfBSphere => self.nearer_root(&solve)?,
            Chapter::HittableList => {
                self.record(&|asked| record::record_of(program, asked))?;
                self.list(&|world| world.nearest_of(program))?;
            }
            _ => {}
        }
        self.ray_color(&|ray| program.ray_color(ray))
    }

    /// Whether these laws hold for what answers questions about one sphere.
    pub(crate) fn of_a_sphere(
        &self,
        answer: Answer<WithInterval>,
        laws: &[impl Fn(&WithInterval) -> Verdict],
    ) -> Outcome {
        let telling = telling(&strategies::ordinary_asked());
        self.obeys_on(&strategies::kinds(), telling, answer, laws)
    }

    fn obeys<Q: Question>(
        &self,
        cases: impl Strategy<Value = Q> + 'static,
        answer: Answer<Q>,
        law: impl Fn(&Q) -> Verdict,
    ) -> Outcome {
        let telling = telling(&cases);
        self.obeys_on(&[cases.boxed()], telling, answer, &[law])
    }

    /// Whether every law holds, on cases of one kind after those of another. The `telling`
    /// questions are those to which different mistakes give different answers.
    fn obeys_on<Q: Question>(
        &self,
        kinds: &[BoxedStrategy<Q>],
        telling: Vec<Q>,
        answer: Answer<Q>,
        laws: &[impl Fn(&Q) -> Verdict],
    ) -> Outcome {
        let mut given: Vec<(Box<dyn Question>, _)> = Vec::new();
        // What panics does so here, and not again and again while a case is made smaller.
        for question in telling {
            let answer = answer(&question);
            if let Some(file) = &self.answers {
                answers::keep(file, &question, &answer);
            }
            given.push((Box::new(question), answer));
        }
        let smallest = |cases| laws.iter().find_map(|law| self.smallest(cases, law));
        let Some((smallest, broken)) = kinds.iter().find_map(smallest) else {
            return Ok(());
        };
        let chapter = self.chapter;
        let (test, answer) = (smallest.as_test(chapter), answer(&smallest));
        given.push((Box::new(smallest), answer));
        Err(Box::new(Report {
            broken: message(&broken),
            cause: Cause::of(&Answers { chapter, given }, self.letters),
            test,
        }))
    }

    /// The smallest case that breaks the law, of those that proptest finds, and how.
    fn smallest<Q: Question>(
        &self,
        cases: &BoxedStrategy<Q>,
        law: &impl Fn(&Q) -> Verdict,
    ) -> Option<(Q, TestCaseError)> {
        let mut runner = TestRunner::new(Config {
            cases: self.cases,
            ..config()
        });
        match runner.run(cases, |case| law(&case)) {
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
