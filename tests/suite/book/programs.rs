//! Programs that pages tell of: the book's C++, of versions 4 and 3, prints the same bytes as ours.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

use fixtures::command::run;
use fixtures::drawn::p3;
use fixtures::left_out::left_out;
use measure::rival;
use slips::{self, Chapter, ChapterCode, ChapterProgram};

/// The program in C++, in a folder of its own, if there is a compiler.
fn compiled(source: &str) -> Option<PathBuf> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(source);
    match rival::compile(&source, &Path::new(env!("CARGO_TARGET_TMPDIR")).join("cpp")) {
        Ok(program) => Some(program),
        Err(cause) if cause.kind() == ErrorKind::NotFound => {
            let source = source.display();
            left_out(&format!(
                "there is no C++ compiler to build {source} ({cause})"
            ));
            None
        }
        Err(cause) => panic!("{} does not compile:\n{cause}", source.display()),
    }
}

fn printed(program: &Path, words: &[&str]) -> Vec<u8> {
    run(Command::new(program).args(words)).stdout
}

#[test]
#[ignore = "compiles C++"]
fn the_books_program_in_cpp_draws_the_same_bytes() {
    let Some(program) = compiled("../../book/measure/rival/book.cc") else {
        return;
    };
    // The build test has no part in the race.
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        for width in [1, 79, 80, 81, 161, 257] {
            let drawn = printed(&program, &[chapter.name(), &width.to_string()]);
            assert!(
                drawn == p3(&chapter.picture(width)),
                "{chapter:?} at {width} wide"
            );
        }
    }
}

#[test]
#[ignore = "compiles C++"]
fn version_3_draws_what_its_program_in_cpp_draws() {
    let Some(program) = compiled("book/version_3.cc") else {
        return;
    };
    for chapter in Chapter::OF_THE_BOOK {
        let ours = slips::version_3().applied_to(&ChapterProgram::right(chapter));
        // As in the texts, and some that leave a remainder.
        for width in [18, 83, 200, 384] {
            let drawn = printed(&program, &[chapter.name(), &width.to_string()]);
            assert!(
                drawn == ours.run(width).to_string().into_bytes(),
                "{chapter:?} of version 3 at {width} wide"
            );
        }
    }
}
