//! The interpreter runs the right texts as they are compiled, and each slip is another program.

use std::collections::BTreeSet;

use difference::Comparison;
use slips::{Chapter, ChapterCode, ChapterProgram, Edit, Languages};

use fixtures::drawn::p3;

#[test]
fn the_interpreter_draws_the_texts_as_the_compiler_does() {
    for chapter in Chapter::OF_THE_BOOK {
        for width in [1, 2, 3, 50, 63, 110, chapter.book_width()] {
            assert_eq!(
                Comparison::of(
                    &chapter.picture(width),
                    &ChapterProgram::right(chapter).run(width).picture()
                ),
                Comparison::Equal,
                "{chapter:?} at {width} wide: the interpreter draws another picture of \
                 book/judge/slips/texts than the compiler"
            );
        }
    }
}

/// The loop and the levels of a right program are done without their text.
#[test]
fn the_text_around_a_chapter_does_what_is_done_without_it() {
    for chapter in Chapter::OF_THE_BOOK {
        let right = ChapterProgram::right(chapter);
        let edits = [
            Edit::new("255.999", "255.9990"),
            Edit::new("[i, j]", "[i + 0, j]"),
        ];
        let same = right.with_edits(&edits).expect("they stand there");
        assert!(
            right.run(33).pixels().eq(same.run(33).pixels()),
            "{chapter:?}"
        );
    }
}

#[test]
fn the_text_of_a_program_without_a_slip_is_the_p3_of_its_picture() {
    for chapter in Chapter::OF_THE_BOOK {
        let output = ChapterProgram::right(chapter).run(31);
        let text = p3(&output.picture());
        assert_eq!(output.to_string().into_bytes(), text, "{chapter:?}");
    }
}

#[test]
fn the_names_are_distinct_and_easy_to_type() {
    let names: BTreeSet<&str> = slips::all().map(|slip| slip.name).collect();
    assert_eq!(names.len(), slips::all().count(), "two slips share a name");
    let is_easy = |byte| matches!(byte, b'a'..=b'z' | b'0'..=b'9' | b'-');
    for name in names {
        assert!(name.bytes().all(is_easy), "{name} is awkward to type");
    }
}

/// In each chapter that has its line, the text with the slip is a program with another meaning.
#[test]
fn every_slip_makes_another_program() {
    for slip in slips::all().chain(slips::unnamed()) {
        for chapter in slip.chapters() {
            let right = ChapterProgram::right(chapter);
            let wrong = slip.program(chapter);
            let text =
                |program: &ChapterProgram| format!("{:?}", program.functions().collect::<Vec<_>>());
            let is_another = text(&right) != text(&wrong) || slip.name == "single-precision";
            assert!(is_another, "{} in {chapter:?}", slip.name);
        }
        assert!(
            slip.chapters().next().is_some(),
            "{} stands nowhere",
            slip.name
        );
    }
}

#[test]
fn in_both_languages_a_slip_changes_its_line() {
    for slip in slips::all().chain(slips::unnamed()) {
        for chapter in slip.chapters() {
            for line in slip.lines_in(Languages::Both, chapter) {
                assert_ne!(line.wrong, line.right, "{} in {chapter:?}", slip.name);
            }
        }
    }
}
