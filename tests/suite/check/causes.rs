//! The first report about a function names the mistake that was made in it, where its
//! answers are those of a known one.

use check::lawful;
use laws::{ChapterScene, Report, Trial};
use slips::{Chapter, Languages, Slip};

use crate::check::caught::{OUTCOMES, first_report};
use fixtures::slip;

/// Of all slips that break a law and can be made in Rust, 95 in 100 are named: alone, or
/// among four that give the same answer to every question.
#[test]
#[ignore = "asks all laws about all mistakes"]
fn the_first_broken_law_names_the_slip() {
    let in_rust = OUTCOMES.iter().filter(|it| it.slip.is_possible_in_rust());
    let reported = in_rust.filter_map(|it| Some((it, it.report.as_deref()?)));
    let (named, missed): (Vec<_>, Vec<_>) = reported.partition(|(outcome, report)| {
        let mut mistakes = mistakes(report, outcome.chapter).into_iter();
        mistakes.any(|it| it.name == outcome.slip.name)
    });
    let all = named.len() + missed.len();
    let missed = missed.iter().map(|(it, report)| {
        let (name, chapter) = (it.slip.name, it.chapter);
        format!("{name} in {chapter:?}:\n{report}\n\n")
    });
    let missed: String = missed.collect();
    println!("of {all} slips {} are named", named.len());
    assert!(
        100 * named.len() >= 95 * all,
        "of {all} are not named\n{missed}"
    );
}

#[test]
fn a_mistake_without_a_name_is_found_too() {
    for mistake in slips::unnamed() {
        for chapter in mistake.chapters() {
            let report = first_report(&mistake.program(chapter)).expect("a law is broken");
            let mut mistakes = mistakes(&report, chapter).into_iter();
            let is_found = mistakes.any(|it| std::ptr::eq(it, mistake));
            assert!(is_found, "{report} in {chapter:?}");
        }
    }
}

fn mistakes(report: &Report, chapter: Chapter) -> Vec<&'static Slip> {
    lawful::mistakes_with_answers(&report.answers, chapter, Languages::Rust)
}

/// A step on the way, for example, has another color on purpose.
#[test]
fn a_color_that_the_picture_shows_is_left_to_it() {
    let outcome = Trial::default().ray_color(ChapterScene::Ball, &red_sphere::ray_color);
    assert!(outcome.is_ok());
}

#[test]
fn a_lost_sign_is_named_with_the_smallest_case_that_shows_it() {
    let report = first_report(&slip("minus-h").program(Chapter::HalfBSphere));
    insta::assert_snapshot!("lost_sign", report.expect("a law is broken"));
}
