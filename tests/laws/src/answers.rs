//! Answers as evidence: what a function said to the telling questions, kept in a file, so
//! that a judge can weigh them beside a picture.
//!
//! Each line is an answer: the kind of the question, then numbers that read back to the
//! bit. A function that panics or never returns leaves what it answered before.

use std::fmt::{Debug, Write as _};
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::Path;

use common::rtweekend::*;
use slips::Program;
use speed_vs_accuracy::Case;

use crate::camera::{Pixel, Width};
use crate::intervals::WithInterval;
use crate::list::World;
use crate::nearer_root::Decided;
use crate::prelude::Asked;
use crate::question::Question;
use crate::ray_color::{Looking, Traced};
use crate::record::{Hit, Recorded};

/// The environment variable that names the file.
pub const ANSWERS: &str = "LAWS_ANSWERS";

/// What the functions of a reader answered.
#[derive(Debug, Default)]
pub struct Answers {
    kinds: Vec<Box<dyn Kind>>,
}

impl Answers {
    /// The answers in the text of a file. A text without any is no answers.
    pub fn read(text: &str) -> Self {
        let kinds = [
            Answered::<Decided>::read,
            Answered::<Case>::read,
            Answered::<WithInterval>::read,
            Answered::<Recorded>::read,
            Answered::<World>::read,
            Answered::<Asked>::read,
            Answered::<Width>::read,
            Answered::<Pixel>::read,
            Answered::<Looking>::read,
            Answered::<Traced<1>>::read,
            Answered::<Traced<2>>::read,
            Answered::<Traced<3>>::read,
            Answered::<Traced<4>>::read,
            Answered::<Traced<5>>::read,
        ];
        Self {
            kinds: kinds.iter().filter_map(|read| read(text)).collect(),
        }
    }

    /// What the functions of a program answer, as its chapter has them. What becomes of a hit
    /// is not asked where the picture is wrong already.
    pub fn of(program: &Program) -> Self {
        let kinds = [
            Answered::<Decided>::of,
            Answered::<Case>::of,
            Answered::<WithInterval>::of,
            Answered::<Recorded>::of,
            Answered::<World>::of,
            Answered::<Looking>::of,
            Answered::<Traced<1>>::of_color,
            Answered::<Traced<2>>::of_color,
            Answered::<Traced<3>>::of_color,
            Answered::<Traced<4>>::of_color,
            Answered::<Traced<5>>::of_color,
        ];
        Self {
            kinds: kinds.iter().filter_map(|of| of(program)).collect(),
        }
    }

    /// Whether nothing was answered.
    pub fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    /// Whether a function of the prelude is wrong, on which all others may stand.
    pub fn has_wrong_prelude(&self) -> bool {
        let right = Asked::right_program();
        let mut of_prelude = self.kinds.iter().filter(|it| it.name() == Asked::KIND);
        of_prelude.any(|kind| kind.unlike(&right, 1) > 0)
    }

    /// Of how many answers how many are not those of the program. What its chapter does not
    /// have counts as nothing; and after `most` of them no more are counted.
    pub fn unlike(&self, program: &Program, most: usize) -> (usize, usize) {
        let kinds = self.kinds.iter().filter(|kind| kind.is_in(program));
        kinds.fold((0, 0), |(asked, unlike), kind| {
            let more = kind.unlike(program, most - unlike);
            (asked + kind.asked(), unlike + more)
        })
    }
}

/// Adds the answers to the file.
///
/// # Panics
/// If that can't be written.
pub(crate) fn add<Q: Question>(file: &Path, answer: &dyn Fn(&Q) -> Q::Answer, questions: &[Q]) {
    let mut file = OpenOptions::new()
        .create(true)
        .append(true)
        .open(file)
        .unwrap_or_else(|cause| panic!("{}: {cause}", file.display()));
    for question in questions {
        let mut line = Q::KIND.to_owned();
        for number in answer(question).numbers() {
            write!(line, " {number:?}").expect("a string takes all");
        }
        line.push('\n');
        let written = file.write_all(line.as_bytes());
        written.expect("the file of answers can be written");
    }
}

/// What a function answers, as numbers.
pub trait Answer: Debug + Send + Sync + Sized {
    /// All that there is to tell the answer from others.
    fn numbers(&self) -> Vec<f64>;

    /// The answer of which these are the numbers.
    fn from_numbers(numbers: &[f64]) -> Option<Self>;
}

impl Answer for bool {
    fn numbers(&self) -> Vec<f64> {
        vec![f64::from(*self)]
    }

    fn from_numbers(numbers: &[f64]) -> Option<Self> {
        <[f64; 1]>::try_from(numbers)
            .ok()
            .map(|[number]| number != 0.0)
    }
}

impl Answer for u32 {
    fn numbers(&self) -> Vec<f64> {
        vec![f64::from(*self)]
    }

    fn from_numbers(numbers: &[f64]) -> Option<Self> {
        <[f64; 1]>::try_from(numbers)
            .ok()
            .map(|[number]| number as Self)
    }
}

impl Answer for Option<f64> {
    fn numbers(&self) -> Vec<f64> {
        self.iter().copied().collect()
    }

    fn from_numbers(numbers: &[f64]) -> Option<Self> {
        match *numbers {
            [] => Some(None),
            [number] => Some(Some(number)),
            _ => None,
        }
    }
}

impl Answer for Option<[f64; 2]> {
    fn numbers(&self) -> Vec<f64> {
        self.iter().flatten().copied().collect()
    }

    fn from_numbers(numbers: &[f64]) -> Option<Self> {
        match *numbers {
            [] => Some(None),
            [one, other] => Some(Some([one, other])),
            _ => None,
        }
    }
}

impl Answer for Vec3 {
    fn numbers(&self) -> Vec<f64> {
        self.to_array().to_vec()
    }

    fn from_numbers(numbers: &[f64]) -> Option<Self> {
        numbers.try_into().ok().map(Self::from_array)
    }
}

impl Answer for Option<Vec<f64>> {
    fn numbers(&self) -> Vec<f64> {
        self.clone().unwrap_or_default()
    }

    fn from_numbers(numbers: &[f64]) -> Option<Self> {
        Some((!numbers.is_empty()).then(|| numbers.to_vec()))
    }
}

impl Answer for Ray {
    fn numbers(&self) -> Vec<f64> {
        [self.origin.to_array(), self.direction.to_array()].concat()
    }

    fn from_numbers(numbers: &[f64]) -> Option<Self> {
        let &[x, y, z, u, v, w] = numbers else {
            return None;
        };
        Some(Self::new(Vec3::new(x, y, z), Vec3::new(u, v, w)))
    }
}

impl Answer for Vec<Hit> {
    fn numbers(&self) -> Vec<f64> {
        let numbers = |hit: &Hit| {
            let [point, normal] = [hit.point.to_array(), hit.normal.to_array()];
            [&[hit.t], &point[..], &normal, &[f64::from(hit.front_face)]].concat()
        };
        self.iter().flat_map(numbers).collect()
    }

    fn from_numbers(numbers: &[f64]) -> Option<Self> {
        let hit = |numbers: &[f64]| match *numbers {
            [t, x, y, z, u, v, w, front_face] => Some(Hit {
                t,
                point: Point3::new(x, y, z),
                normal: Vec3::new(u, v, w),
                front_face: front_face != 0.0,
            }),
            _ => None,
        };
        numbers.chunks(8).map(hit).collect()
    }
}

/// The answers to questions of one kind.
trait Kind: Debug + Send + Sync {
    /// What it is called in a file.
    fn name(&self) -> &'static str;

    /// Whether the program's chapter has a function of this kind.
    fn is_in(&self, program: &Program) -> bool;

    /// How many answers there are.
    fn asked(&self) -> usize;

    /// How many of them the program would not give, up to `most`.
    fn unlike(&self, program: &Program, most: usize) -> usize;
}

#[derive(Debug)]
struct Answered<Q: Question> {
    answers: Vec<(Q, Q::Answer)>,
}

impl<const CHAPTER: usize> Answered<Traced<CHAPTER>> {
    /// What a `ray_color` answers that looks right.
    fn of_color(program: &Program) -> Option<Box<dyn Kind>> {
        let color = |ray: &Ray| program.ray_color(ray);
        let is_asked = Traced::<CHAPTER>::is_of(program) && Traced::<CHAPTER>::looks_right(&color);
        is_asked.then(|| Self::of(program))?
    }
}

impl<Q: Question> Answered<Q> {
    /// What a program of a chapter that has such a function answers.
    fn of(program: &Program) -> Option<Box<dyn Kind>> {
        let answered = |question: Q| {
            let answer = question.answer_of(program);
            (question, answer)
        };
        let answers = || Q::telling().into_iter().map(answered).collect();
        Q::is_of(program).then(|| Box::new(Self { answers: answers() }) as _)
    }

    /// The answers of this kind in the text, up to the first that can't be read.
    fn read(text: &str) -> Option<Box<dyn Kind>> {
        let of_kind = |line: &str| {
            let mut words = line.split(' ');
            (words.next() == Some(Q::KIND)).then(|| words.map(str::parse).collect())
        };
        let lines = text
            .split_inclusive('\n')
            .map_while(|line| line.strip_suffix('\n'));
        let answers = lines
            .filter_map(of_kind)
            .map_while(|numbers: Result<Vec<f64>, _>| Q::Answer::from_numbers(&numbers.ok()?));
        let mut answers = answers.peekable();
        answers.peek()?;
        let answers = Q::telling().into_iter().zip(answers).collect();
        Some(Box::new(Self { answers }))
    }
}

impl<Q: Question> Kind for Answered<Q> {
    fn name(&self) -> &'static str {
        Q::KIND
    }

    fn is_in(&self, program: &Program) -> bool {
        Q::is_of(program)
    }

    fn asked(&self) -> usize {
        self.answers.len()
    }

    fn unlike(&self, program: &Program, most: usize) -> usize {
        let answers = self.answers.iter();
        let unlike = answers
            .filter(|(question, answer)| !question.same(answer, &question.answer_of(program)));
        unlike.take(most).count()
    }
}
