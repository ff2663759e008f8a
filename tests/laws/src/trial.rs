//! A trial: a function is put under all laws that there are for its kind, and found
//! wrong with one report, which names the cause.

use std::env;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Ball, Chapter, Program};
use speed_vs_accuracy::Case;

use crate::answers::{self, ANSWERS};
use crate::camera::{self, Pixel, Width};
use crate::causes;
use crate::intervals::{NEAREST_IN_RANGE, WithInterval};
use crate::list::{self, Search, World, worlds};
use crate::nearer_root::{DECISION, Decided, NEARER_ROOT};
use crate::prelude::{self, Asked};
use crate::question::{Question, simplified};
use crate::ray_color::{self, Looking, Traced};
use crate::record::{Hit, RECORD, Recorded};
use crate::report::{self, Report};
use crate::sampling::{cases, chosen_seed, endless};
use crate::strategies;
use crate::verdict::Verdict;

/// `Ok` if every law holds.
pub type Outcome = Result<(), Box<Report>>;

/// How functions are tried.
#[derive(Clone, Debug)]
pub struct Trial {
    /// On how many questions each law is tried.
    pub cases: u32,
    /// The chapter of the function: mistakes in it are looked for, or else in all that have
    /// such a function.
    pub chapter: Option<Chapter>,
    /// The file to which [answers] are added.
    pub answers: Option<PathBuf>,
}

impl Default for Trial {
    /// With as many questions as [`cases`] says, and with the file that the environment
    /// variable [`ANSWERS`] names.
    fn default() -> Self {
        Self {
            cases: cases(),
            chapter: None,
            answers: env::var_os(ANSWERS).map(PathBuf::from),
        }
    }
}

/// A law of a function under trial.
type Law<'a, Q> = dyn Fn(&Q) -> Verdict + 'a;

/// A function under trial.
struct Tried<'a, Q: Question> {
    trial: &'a Trial,
    answer: &'a dyn Fn(&Q) -> Q::Answer,
    /// In teaching order.
    laws: &'a [&'a Law<'a, Q>],
    /// The questions, from the start.
    questions: &'a dyn Fn() -> Box<dyn Iterator<Item = Q>>,
}

impl Trial {
    /// The same for a function of that chapter.
    pub fn of(chapter: Chapter) -> Self {
        Self {
            chapter: Some(chapter),
            ..Self::default()
        }
    }

    /// A function that only decides whether the line meets the sphere, as in chapter 2.
    pub fn decision<F>(&self, decide: &F) -> Outcome
    where
        F: Fn(Point3, f64, &Ray) -> bool + ?Sized,
    {
        // The laws are for roots: any number stands for one.
        let solve = |center, radius, ray: &Ray| decide(center, radius, ray).then_some(0.0);
        let laws = DECISION.map(|law| move |Decided(case): &Decided| law(&solve, case));
        Tried {
            trial: self,
            answer: &|Decided(case)| case.solve(&solve).is_some(),
            laws: &laws.each_ref().map(|law| law as _),
            questions: &|| self.generated(strategies::anywhere().prop_map(Decided)),
        }
        .outcome()
    }

    /// A function that returns the nearer root, as in chapters 3 and 4.
    pub fn nearer_root<F>(&self, solve: &F) -> Outcome
    where
        F: Fn(Point3, f64, &Ray) -> Option<f64> + ?Sized,
    {
        let solver = |center, radius, ray: &Ray| solve(center, radius, ray);
        let laws = NEARER_ROOT.map(|law| move |case: &Case| law(&solver, case));
        Tried {
            trial: self,
            answer: &|case: &Case| case.solve(&solver),
            laws: &laws.each_ref().map(|law| law as _),
            questions: &|| self.generated(strategies::anywhere()),
        }
        .outcome()
    }

    /// A function that returns the nearest root between `t_min` and `t_max`, as the
    /// sphere of chapter 5: on the whole line, that is the nearer root.
    pub fn nearest_in_range<F>(&self, solve: &F) -> Outcome
    where
        F: Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> + ?Sized,
    {
        let solver = |center, radius, ray: &Ray, low, high| solve(center, radius, ray, low, high);
        let (least, greatest) = (f64::NEG_INFINITY, f64::INFINITY);
        let nearer = |center, radius, ray: &Ray| solve(center, radius, ray, least, greatest);
        let on_the_line =
            NEARER_ROOT.map(|law| move |asked: &WithInterval| law(&nearer, &asked.case));
        let in_range = NEAREST_IN_RANGE.map(|law| move |asked: &WithInterval| law(&solver, asked));
        let laws: Vec<&Law<WithInterval>> = on_the_line
            .iter()
            .map(|law| law as _)
            .chain(in_range.iter().map(|law| law as _))
            .collect();
        let questions = || {
            // An end exactly at a root tells an open range from a closed one.
            self.generated(prop_oneof![
                8 => strategies::with_interval(strategies::anywhere()),
                1 => strategies::with_interval(strategies::specks()),
                1 => strategies::with_hostile_interval(strategies::tangents()),
            ])
        };
        Tried {
            trial: self,
            answer: &|asked: &WithInterval| asked.solve(&solver),
            laws: &laws,
            questions: &questions,
        }
        .outcome()
    }

    /// The intersection of a program, as its chapter has one.
    pub fn intersection(&self, program: &Program) -> Outcome {
        let hit = |center, radius, ray: &Ray| program.hit_sphere(center, radius, ray);
        let trial = self.in_chapter_of(program);
        match program.chapter {
            Chapter::RedSphere => {
                trial.decision(&|center, radius, ray: &Ray| hit(center, radius, ray).is_some())
            }
            Chapter::Normals | Chapter::HalfBSphere => trial.nearer_root(&hit),
            Chapter::HittableList => {
                trial.nearest_in_range(&|center, radius, ray: &Ray, t_min, t_max| {
                    program.hit(Ball { center, radius }, ray, t_min, t_max)
                })
            }
            _ => Ok(()),
        }
    }

    /// What becomes of a hit in a program, as its chapter has it: the record, the search of a
    /// list, and the color.
    pub fn rest(&self, program: &Program) -> Outcome {
        let trial = self.in_chapter_of(program);
        if program.chapter == Chapter::HittableList {
            trial.record(&|center, radius, ray: &Ray, t_min, t_max| {
                program.record(Ball { center, radius }, ray, t_min, t_max)
            })?;
            trial.list(&|world: &World| world.answer_of(program))?;
            trial.range(&|_| Some([program.t_min, program.t_max]))?;
        }
        trial.ray_color(&|ray: &Ray| program.ray_color(ray))
    }

    fn in_chapter_of(&self, program: &Program) -> Self {
        Self {
            chapter: Some(program.chapter),
            ..self.clone()
        }
    }

    /// A function that returns the record of the nearest hit between `t_min` and
    /// `t_max`: its normal, and its side. That `t` is right is another trial.
    pub fn record<F>(&self, record: &F) -> Outcome
    where
        F: Fn(Point3, f64, &Ray, f64, f64) -> Option<Hit> + ?Sized,
    {
        let recorder =
            |center, radius, ray: &Ray, low, high| record(center, radius, ray, low, high);
        let laws = RECORD.map(|law| move |asked: &Recorded| asked.obeys(&recorder, law));
        Tried {
            trial: self,
            answer: &|asked: &Recorded| asked.hits(&recorder),
            laws: &laws.each_ref().map(|law| law as _),
            questions: &|| self.generated(strategies::anywhere().prop_map(Recorded)),
        }
        .outcome()
    }

    /// A list that is searched for the nearest hit.
    pub fn list<F>(&self, search: &F) -> Outcome
    where
        F: Fn(&World) -> Option<f64>,
    {
        let laws = [
            list::the_nearest_of_all_members_is_returned as fn(&Search, &World) -> Verdict,
            list::the_order_of_members_does_not_matter,
        ]
        .map(|law| move |world: &World| law(search, world));
        Tried {
            trial: self,
            answer: search,
            laws: &laws.each_ref().map(|law| law as _),
            questions: &|| self.generated(worlds()),
        }
        .outcome()
    }

    /// The functions of a prelude, up to the first that is wrong: what follows may be built
    /// on it. One that is not written yet is not asked.
    pub fn prelude<F: Fn(&Asked) -> Vec<f64>>(&self, prelude: &F) -> Outcome {
        let telling = Asked::telling();
        let mut asked = Vec::new();
        for function in telling.chunk_by(Asked::is_akin) {
            let answer = |it: &Asked| Some(prelude(it));
            if is_written(|| prelude(&function[0])) {
                asked.push(function[0]);
                if !function.iter().all(|it| it.same(&answer(it), &it.right())) {
                    break;
                }
            }
        }
        let answer = |it: &Asked| {
            let is_asked = asked.iter().any(|one| one.is_akin(it));
            is_asked.then(|| prelude(it))
        };
        self.small(&answer, &|asked| {
            prelude::small_numbers_are_worked_out_by_head(&answer, asked)
        })
    }

    /// A function that returns the height of a picture of 16:9 from its width.
    pub fn height<F: Fn(u32) -> u32>(&self, height: &F) -> Outcome {
        self.small(&|width: &Width| height(width.0), &|width| {
            camera::the_height_is_rounded_down_and_at_least_one(height, width)
        })
    }

    /// A function that returns the ray of a pixel, from the size of the picture and
    /// the pixel's column and row.
    pub fn pixel_ray<F: Fn([u32; 2], [u32; 2]) -> Ray>(&self, ray: &F) -> Outcome {
        self.small(&|pixel: &Pixel| ray(pixel.size, pixel.place), &|pixel| {
            camera::the_ray_of_a_pixel_goes_through_its_center(ray, pixel)
        })
    }

    /// The trial of a function with one law, and few questions that are always the same.
    fn small<Q: Question>(&self, answer: &dyn Fn(&Q) -> Q::Answer, law: &Law<Q>) -> Outcome {
        Tried {
            trial: self,
            answer,
            laws: &[law],
            questions: &|| Box::new(Q::telling().into_iter()),
        }
        .outcome()
    }

    /// The `ray_color` of the chapter, about rays that its camera never casts. Says nothing
    /// where the picture is wrong already.
    pub fn ray_color<F: Fn(&Ray) -> Color>(&self, ray_color: &F) -> Outcome {
        match self.chapter {
            Some(Chapter::Gradient) => self.traced::<1>(ray_color),
            Some(Chapter::RedSphere) => self.traced::<2>(ray_color),
            Some(Chapter::Normals) => self.traced::<3>(ray_color),
            Some(Chapter::HalfBSphere) => self.traced::<4>(ray_color),
            Some(Chapter::HittableList) => self.traced::<5>(ray_color),
            _ => Ok(()),
        }
    }

    fn traced<const CHAPTER: usize>(&self, ray_color: &dyn Fn(&Ray) -> Color) -> Outcome {
        if !Traced::<CHAPTER>::looks_right(ray_color) {
            return Ok(());
        }
        self.small(
            &|traced: &Traced<CHAPTER>| ray_color(&traced.0),
            &|traced| ray_color::a_ray_has_its_color_from_anywhere(ray_color, traced),
        )
    }

    /// A function that returns the range of `t` for which a ray asks a world, if it does.
    pub fn range<F: Fn(&Ray) -> Option<[f64; 2]>>(&self, range: &F) -> Outcome {
        self.small(&|looking: &Looking| range(&looking.0), &|looking| {
            ray_color::all_that_is_in_front_is_asked_for(range, looking)
        })
    }

    fn generated<Q: Question>(
        &self,
        strategy: impl Strategy<Value = Q> + 'static,
    ) -> Box<dyn Iterator<Item = Q>> {
        Box::new(endless(strategy, &chosen_seed()).take(self.cases as usize))
    }
}

/// Whether something else is there than `todo!()`.
fn is_written<T>(call: impl FnOnce() -> T) -> bool {
    let panicked = panic::catch_unwind(AssertUnwindSafe(call)).err();
    let message = panicked.and_then(|it| it.downcast::<&str>().ok());
    message.is_none_or(|message| *message != "not yet implemented")
}

impl<Q: Question> Tried<'_, Q> {
    fn outcome(&self) -> Outcome {
        let telling = Q::telling();
        if let Some(file) = &self.trial.answers {
            answers::add(file, self.answer, &telling);
        }
        // What ordinary questions show comes before what only an overflow does.
        let Some((first, found)) = self
            .first_broken(|| telling.iter().cloned())
            .or_else(|| self.first_broken(self.questions))
        else {
            return Ok(());
        };
        let law = self.laws[first];
        let telling = telling
            .into_iter()
            .filter(|it| it.is_akin(&found))
            .collect();
        let (cause, mutant) = causes::of(self.answer, telling, &found, self.trial.chapter);
        let simplest = self.simplest(found, law, mutant.as_ref());
        Err(Box::new(Report {
            broken: law(&simplest).expect_err("what is simpler breaks the law as well"),
            cause,
            others: self.laws[first + 1..]
                .iter()
                .filter(|law| self.breaks(law))
                .count(),
            test: report::test(&simplest),
        }))
    }

    /// The simplest question that breaks the law as the one that was found does: from the
    /// same cause, with a wrong answer, and not by chance.
    fn simplest(&self, found: Q, law: &Law<Q>, mutant: Option<&Program>) -> Q {
        let (degenerate, wrong) = (found.is_degenerate(), self.is_wrong(&found));
        simplified(found, |simpler| {
            law(simpler).is_err()
                && (degenerate || !simpler.is_degenerate())
                && (!wrong || self.is_wrong(simpler))
                && mutant.is_none_or(|mutant| {
                    simpler.same(&(self.answer)(simpler), &simpler.answer_of(mutant))
                })
        })
    }

    /// The first law that is broken by one of the questions, and the most telling of
    /// those: its own answer is wrong, though a law may ask further ones.
    fn first_broken<I: Iterator<Item = Q>>(&self, questions: impl Fn() -> I) -> Option<(usize, Q)> {
        self.laws.iter().enumerate().find_map(|(place, law)| {
            let breaking = || questions().filter(|question| law(question).is_err());
            let wrong = |question: &Q| !question.is_degenerate() && self.is_wrong(question);
            let found = breaking().find(wrong).or_else(|| breaking().next())?;
            Some((place, found))
        })
    }

    fn breaks(&self, law: &Law<Q>) -> bool {
        (self.questions)().any(|question| law(&question).is_err())
    }

    fn is_wrong(&self, question: &Q) -> bool {
        !question.same(&(self.answer)(question), &question.right())
    }
}
