//! Each slip is caught: by the book's picture, by a probe, or by a law.

mod tables;

use std::sync::LazyLock;

use check::comparison::Comparison;
use common::rtweekend::*;
use laws::Trial;
use laws::answers::Answers;
use laws::prelude;
use laws::trial::Report;
use slips::{Chapter, PROBES, Probe, Program, Slip, Unseen};
use suite::drawn::shown_in;
use suite::parallel;

#[test]
fn every_slip_is_caught_and_the_table_says_by_what() {
    let outcomes = &*OUTCOMES;
    let complaints: String = outcomes.iter().filter_map(Outcome::complaint).collect();
    assert!(complaints.is_empty(), "\n{complaints}");
    shown_in("slips").bind(|| {
        insta::assert_snapshot!("caught_by", tables::at_a_glance(outcomes));
    });
}

#[test]
fn a_program_without_a_slip_breaks_no_law() {
    for chapter in Chapter::OF_THE_BOOK {
        if let Some(report) = first_report(&Program::right(chapter)) {
            panic!("{chapter:?} breaks a law:\n{report}");
        }
    }
}

/// By them a judge tells one mistake from another. Of the camera it asks nothing.
#[test]
fn a_slip_that_breaks_a_law_has_other_answers_than_a_right_program() {
    let of_functions = |it: &&Outcome| it.report.is_some() && !it.breaks(laws::camera::LAW);
    let lawless = OUTCOMES.iter().filter(of_functions);
    for Outcome { slip, chapter, .. } in lawless {
        let answers = Answers::of(&slip.program(*chapter));
        let (_, unlike) = answers.unlike(&Program::right(*chapter), 1);
        assert_eq!(unlike, 1, "{} in {chapter:?}", slip.name);
    }
}

/// What happens to a slip in a chapter.
pub(crate) struct Outcome {
    pub(crate) slip: &'static Slip,
    pub(crate) chapter: Chapter,
    /// What the book's picture shows, and then each probe's.
    verdicts: Vec<(Option<Probe>, Shown)>,
    /// The first law that the slip breaks, and what is said about it.
    pub(crate) report: Option<Box<Report>>,
}

/// Each slip in each of its chapters, in the order of the chapters.
pub(crate) static OUTCOMES: LazyLock<Vec<Outcome>> = LazyLock::new(|| {
    let made = Chapter::OF_THE_BOOK.into_iter().flat_map(|chapter| {
        let slips = slips::all().filter(move |slip| slip.chapters.contains(&chapter));
        slips.map(move |slip| (chapter, slip))
    });
    let exams = Chapter::OF_THE_BOOK.map(exams);
    parallel::map(&made.collect::<Vec<_>>(), |&(chapter, slip)| {
        let program = slip.program(chapter);
        let exams = exams[chapter as usize].iter();
        Outcome {
            slip,
            chapter,
            verdicts: exams.map(|it| (it.probe, it.judge(program))).collect(),
            report: first_report(&program),
        }
    })
});

impl Outcome {
    fn complaint(&self) -> Option<String> {
        let mut verdicts = self.verdicts.iter();
        let seen = verdicts.any(|(_, verdict)| *verdict != Shown::Same);
        let unseen = self.slip.unseen_in(self.chapter);
        let complaint = match (seen, self.report.is_some(), unseen) {
            (false, _, None) => "is in no picture: add a probe, or say why nothing can show it",
            (true, _, Some(_)) => "is in a picture, but the catalogue says that none shows it",
            (_, false, Some(Unseen::OnlyByLaw(_))) => "breaks no law, but the catalogue says so",
            _ => return None,
        };
        Some(format!(
            "{} in {:?} {complaint}\n",
            self.slip.name, self.chapter
        ))
    }

    fn breaks(&self, law: &str) -> bool {
        let report = self.report.as_ref();
        report.is_some_and(|report| report.law() == law)
    }
}

/// What is said of the first law that the program breaks: on a few cases, enough to see a
/// mistake, not to prove anything.
pub(crate) fn first_report(program: &Program) -> Option<Box<Report>> {
    if program.chapter == Chapter::BuildTest {
        return None;
    }
    let trial = Trial {
        cases: 60,
        ..Trial::of(program.chapter)
    };
    prelude::of_program(program, |prelude| trial.prelude(prelude))
        .and_then(|()| trial.pixel_ray(&|pixel| pixel.ray_by(program)))
        .and_then(|()| trial.program(program))
        .err()
}

/// A picture that is compared: the book's, or a probe's.
struct Exam {
    probe: Option<Probe>,
    width: u32,
    right: Picture,
}

#[derive(PartialEq)]
enum Shown {
    Same,
    Size,
    /// The share of pixels that differ.
    Pixels(f64),
}

/// The exams that the chapter has spheres for, the book's picture first.
fn exams(chapter: Chapter) -> Vec<Exam> {
    let right = Program::right(chapter);
    let book = Exam {
        probe: None,
        width: chapter.book_width(),
        right: right.run(chapter.book_width()).picture(),
    };
    let probes = PROBES.into_iter().filter_map(|probe| {
        Some(Exam {
            probe: Some(probe),
            width: probe.width,
            right: probe.put_to(right)?.run(probe.width).picture(),
        })
    });
    std::iter::once(book).chain(probes).collect()
}

impl Exam {
    fn judge(&self, program: Program) -> Shown {
        let program = match self.probe {
            None => program,
            Some(probe) => probe
                .put_to(program)
                .expect("a slip leaves room for spheres"),
        };
        let wrong = program.run(self.width).picture();
        match Comparison::of(&self.right, &wrong) {
            Comparison::Equal => Shown::Same,
            Comparison::Size(..) => Shown::Size,
            Comparison::Pixels(difference) => {
                Shown::Pixels(difference.count as f64 / difference.total as f64)
            }
        }
    }
}
