//! The C++ in the book is the C++ that draws the same bytes.

use std::fs;
use std::path::Path;

#[test]
fn every_cpp_listing_of_the_book_is_a_part_of_the_program_that_is_compared() {
    let program = without_indentation(include_str!("rival/book.cc"));
    let notes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../book/notes");
    let mut count = 0;
    for entry in fs::read_dir(notes).expect("the notes are there") {
        let path = entry.expect("the folder can be read").path();
        if path.extension().is_some_and(|extension| extension == "md") {
            let page = fs::read_to_string(&path).expect("a page is text");
            for listing in page.split("```cpp\n").skip(1) {
                let listing = listing.split("```").next().unwrap_or(listing);
                assert!(
                    program.contains(&without_indentation(listing)),
                    "{} has a listing that is not in tests/rival/book.cc:\n{listing}",
                    path.display()
                );
                count += 1;
            }
        }
    }
    assert!(count > 0, "no page has a listing in C++");
}

fn without_indentation(text: &str) -> String {
    text.lines().flat_map(|line| [line.trim(), "\n"]).collect()
}
