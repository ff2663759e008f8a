//! Each slip is caught: by the book's picture, by a probe, or by a law.

use std::sync::LazyLock;

use check::lawful;
use laws::{Complaint, Question, Report, Trial};
use rayon::prelude::*;
use slips::{Chapter, ChapterProgram, Languages, Slip, Unseen};

#[test]
#[ignore = "asks all laws about all mistakes"]
fn every_slip_is_caught() {
    let complaints: String = OUTCOMES.iter().filter_map(Outcome::complaint).collect();
    assert!(complaints.is_empty(), "\n{complaints}");
}

#[test]
fn a_program_without_a_slip_breaks_no_law() {
    for chapter in Chapter::OF_THE_BOOK {
        if let Some(report) = first_report(&ChapterProgram::right(chapter)) {
            panic!("{chapter:?} breaks a law:\n{report}");
        }
    }
}

/// By its answers a judge tells one mistake from another. No answer is about the camera.
#[test]
#[ignore = "asks all laws about all mistakes"]
fn a_slip_that_breaks_a_law_has_other_answers_than_a_right_program() {
    let of_functions = |it: &&Outcome| {
        let smallest = it.report.as_ref().and_then(|it| it.answers.given.last());
        smallest.is_some_and(|it| !matches!(it.question, Question::PixelRay(_)))
    };
    let lawless = OUTCOMES.iter().filter(of_functions);
    for Outcome { slip, chapter, .. } in lawless {
        let answers = lawful::answers_of(&slip.program(*chapter), lawful::questions(*chapter));
        let mismatch =
            lawful::mismatch_with(&answers, *chapter, &ChapterProgram::right(*chapter), 1);
        assert_eq!(mismatch.differing, 1, "{} in {chapter:?}", slip.name);
    }
}

/// A slip in a chapter, and what catches it: a picture, or a law.
pub(crate) struct Outcome {
    pub(crate) slip: &'static Slip,
    pub(crate) chapter: Chapter,
    /// True if the book's picture or a probe's shows it.
    is_seen: bool,
    /// The report on the first law that the slip breaks; `None` if it breaks none.
    pub(crate) report: Option<Box<Report>>,
}

/// The outcomes of each slip in each of its chapters, in the order of the chapters.
pub(crate) static OUTCOMES: LazyLock<Vec<Outcome>> = LazyLock::new(|| {
    let made = Chapter::OF_THE_BOOK.into_iter().flat_map(|chapter| {
        let slips = slips::all().filter(move |slip| slip.is_possible_in(chapter));
        slips.map(move |slip| (chapter, slip))
    });
    let made: Vec<_> = made.collect();
    let made = made.into_par_iter().map(|(chapter, slip)| {
        let program = slip.program(chapter);
        let hidden = slip.revealing_probes(chapter);
        Outcome {
            slip,
            chapter,
            is_seen: hidden.is_none_or(|probes| !probes.is_empty()),
            report: first_report(&program),
        }
    });
    made.collect()
});

impl Outcome {
    fn complaint(&self) -> Option<String> {
        let unseen = self.slip.why_unseen_in(self.chapter);
        let complaint = match (self.is_seen, self.report.is_some(), unseen) {
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
}

/// Reports the first law that the program breaks, on a few cases: enough to see a mistake, not to
/// prove anything. Returns `None` if it breaks none of them.
pub(crate) fn first_report(program: &ChapterProgram) -> Option<Box<Report>> {
    if program.chapter == Chapter::BuildTest {
        return None;
    }
    let trial = Trial {
        cases: 60,
        ..Trial::default()
    };
    let outcome = lawful::try_all_laws(program, &trial);
    match lawful::explained(outcome, program.chapter, Languages::Rust) {
        Err(Complaint::Broken(report)) => Some(report),
        _ => None,
    }
}
