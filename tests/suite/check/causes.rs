//! The first report about a function names the mistake that was made in it.

use laws::causes::Cause;
use laws::trial::Outcome;
use slips::Chapter;
use slips::{self, Program, Slip};

use crate::caught::{tried, try_intersection};
use suite::slip;

#[test]
fn the_first_broken_law_names_the_slip_in_a_chapter() {
    assert_named(tried);
}

/// A reader's own crate has a `hit_sphere` and takes the rest from `common`.
#[test]
fn the_first_broken_law_names_the_slip_in_a_function_of_a_readers_own() {
    assert_named(try_intersection);
}

#[test]
fn the_readme_shows_what_is_said_of_a_lost_sign() {
    let program = slip("minus-h").program(Chapter::HalfBSphere);
    let report = try_intersection(&program).expect_err("a law is broken");
    let report = report.to_string();
    let (said, _test) = report.split_once("\n\n").expect("a test follows");
    let readme = include_str!("../../../README.md");
    assert!(readme.contains(said), "the README should show\n{said}");
}

/// Of all slips that break a law, 95 in 100 are named: alone, or among three that give
/// the same answer to every question.
fn assert_named(attempt: fn(&Program) -> Outcome) {
    let (mut named, mut broken, mut missed) = ([0; 3], 0, String::new());
    for (slip, chapter) in everything() {
        let Err(report) = attempt(&slip.program(chapter)) else {
            continue;
        };
        broken += 1;
        let Cause {
            mistakes,
            explained,
            asked,
        } = &report.cause;
        let mut mistakes = mistakes.iter().take_while(|_| explained == asked);
        match mistakes.position(|mistake| mistake.names.contains(&slip.name)) {
            Some(place) => named[place] += 1,
            None => missed += &format!("{} in {chapter:?}:\n{report}\n\n", slip.name),
        }
        let lines = report.to_string().lines().count();
        assert!(lines <= 20, "{lines} lines:\n{report}");
    }
    let all: usize = named.iter().sum();
    println!("of {broken} slips {all} are named: in the first place, second, third {named:?}");
    assert!(
        100 * all >= 95 * broken,
        "{broken} slips break a law, {all} are named; not\n{missed}"
    );
}

fn everything() -> impl Iterator<Item = (&'static Slip, Chapter)> {
    slips::all().flat_map(|slip| slip.chapters.iter().map(move |&chapter| (slip, chapter)))
}
