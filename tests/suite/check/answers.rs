//! The answers of a function, kept in a file, belong to the program that gives them.

use std::cell::Cell;
use std::panic::AssertUnwindSafe;
use std::{fs, panic};

use common::rtweekend::*;
use laws::Trial;
use laws::answers::Answers;
use slips::{Chapter, Program};

use crate::caught::OUTCOMES;
use suite::parallel;

#[test]
fn the_answers_of_a_right_function_are_those_of_the_right_program() {
    for chapter in Chapter::OF_THE_BOOK {
        let program = Program::right(chapter);
        let (asked, unlike) = answers_of(&program).unlike(&program, usize::MAX);
        assert_eq!(unlike, 0, "of {asked} answers in {chapter:?}");
    }
}

/// One in four; the next test asks all.
#[test]
fn the_answers_of_a_slip_that_breaks_a_law_are_its_own_and_not_the_right_ones() {
    assert_answers(4);
}

#[test]
#[ignore = "it asks each slip thousands of times, which takes a quarter of a minute"]
fn the_answers_of_all_slips_that_break_a_law_are_their_own() {
    assert_answers(1);
}

fn assert_answers(step: usize) {
    let lawless = OUTCOMES.iter().filter(|it| it.report.is_some());
    let lawless: Vec<_> = lawless.step_by(step).collect();
    let wrong = parallel::map(&lawless, |outcome| {
        let (slip, chapter) = (outcome.slip, outcome.chapter);
        let program = slip.program(chapter);
        let answers = answers_of(&program);
        let [(_, own), (asked, unlike)] =
            [program, Program::right(chapter)].map(|it| answers.unlike(&it, usize::MAX));
        (own > 0 || unlike == 0).then(|| {
            format!(
                "{} in {chapter:?}: {own} not its own, {unlike} of {asked} wrong\n",
                slip.name
            )
        })
    });
    let wrong: String = wrong.into_iter().flatten().collect();
    assert!(!lawless.is_empty() && wrong.is_empty(), "\n{wrong}");
}

#[test]
fn a_function_that_panics_leaves_what_it_answered_before() {
    let right = Program::right(Chapter::HalfBSphere);
    let answers = in_a_file(|trial| {
        let asked = Cell::new(0);
        let panicking = |center, radius, ray: &Ray| {
            asked.set(asked.get() + 1);
            assert!(asked.get() <= 7);
            right.hit_sphere(center, radius, ray)
        };
        let attempt = AssertUnwindSafe(|| trial.nearer_root(&panicking));
        assert!(panic::catch_unwind(attempt).is_err());
    });
    assert_eq!(answers.unlike(&right, usize::MAX), (7, 0));
}

#[test]
fn a_text_that_is_none_of_answers_is_no_answers() {
    for text in [
        "",
        "list",
        "height 3",
        "height three\n",
        "height 1.0 2.0\n",
        "\u{fffd}",
    ] {
        assert!(Answers::read(text).is_empty(), "{text:?}");
    }
}

/// What the functions of the program answer, whatever the laws say of that.
fn answers_of(program: &Program) -> Answers {
    in_a_file(|trial| {
        let camera = |width| program.camera(width);
        let ray =
            |[width, _]: [u32; 2], [i, j]: [u32; 2]| (program.ray)(program, &camera(width), i, j);
        let _ = trial.prelude(&|asked| asked.put_to_program(program));
        let _ = trial.height(&|width| camera(width).image_height);
        let _ = trial.pixel_ray(&ray);
        let _ = trial.intersection(program);
        let _ = trial.rest(program);
    })
}

fn in_a_file(attempt: impl Fn(&Trial)) -> Answers {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("answers");
    attempt(&Trial {
        cases: 0,
        chapter: None,
        answers: Some(file.clone()),
    });
    Answers::read(&fs::read_to_string(file).unwrap_or_default())
}
