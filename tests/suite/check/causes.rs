//! The first report about a function names the mistake that was made in it.

use laws::Trial;
use laws::causes::Cause;
use laws::report::Report;
use slips::{Chapter, Edition, Letters};

use crate::caught::{OUTCOMES, Outcome, TRIAL, first_report};
use suite::slip;

#[test]
fn the_first_broken_law_names_the_slip_in_a_chapter() {
    assert_named(|outcome| outcome.report.as_deref());
}

#[test]
fn the_first_broken_law_names_the_slip_in_a_function_of_a_readers_own() {
    assert_named(|outcome| outcome.own.as_deref());
}

#[test]
fn a_mistake_without_a_name_is_found_too() {
    let mut missed = String::new();
    for mistake in slips::unnamed() {
        for &chapter in mistake.chapters {
            let report = first_report(&mistake.program(chapter));
            let causes = report.map_or(Vec::new(), |report| report.cause.mistakes);
            if !causes
                .iter()
                .any(|(other, _)| std::ptr::eq(*other, mistake))
            {
                let wrong = mistake.words(Letters::Book(Edition::V4), chapter).wrong;
                missed += &format!("{wrong} in {chapter:?}\n");
            }
        }
    }
    assert!(missed.is_empty(), "not found:\n{missed}");
}

/// A step on the way, for example, which has another color on purpose.
#[test]
fn a_color_that_the_picture_shows_is_left_to_it() {
    let trial = Trial::of(Chapter::Normals);
    assert!(trial.ray_color(&red_sphere::ray_color).is_ok());
}

#[test]
fn a_lost_sign_is_named_with_the_simplest_question_that_shows_it() {
    let program = slip("minus-h").program(Chapter::HalfBSphere);
    let report = TRIAL.intersection(&program).expect_err("a law is broken");
    insta::assert_snapshot!("lost_sign", report);
}

/// Of all slips that break a law and can be made in Rust, 95 in 100 are named: alone, or among four that give
/// the same answer to every question.
fn assert_named(report: fn(&Outcome) -> Option<&Report>) {
    let (mut named, mut broken, mut missed) = ([0; 4], 0, String::new());
    let in_rust = |outcome: &&Outcome| outcome.slip.can_be_made_in(Letters::Rust);
    for outcome in OUTCOMES.iter().filter(in_rust) {
        let Some(report) = report(outcome) else {
            continue;
        };
        broken += 1;
        let Cause {
            mistakes,
            explained,
            asked,
        } = &report.cause;
        let (name, chapter) = (outcome.slip.name, outcome.chapter);
        let mut mistakes = mistakes.iter().take_while(|_| explained == asked);
        match mistakes.position(|(mistake, _)| mistake.name == name) {
            Some(place) => named[place] += 1,
            None => missed += &format!("{name} in {chapter:?}:\n{report}\n\n"),
        }
        let lines = report.to_string().lines().count();
        assert!(lines <= 25, "{lines} lines:\n{report}");
    }
    let all: usize = named.iter().sum();
    println!("of {broken} slips {all} are named, in the first place, second, …: {named:?}");
    assert!(
        100 * all >= 95 * broken,
        "{broken} slips break a law, {all} are named; not\n{missed}"
    );
}
