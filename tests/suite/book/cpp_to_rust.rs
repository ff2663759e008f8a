//! The C++ beside the Rust is the C++ that draws the same bytes.

#[test]
fn every_cpp_listing_is_a_part_of_the_program_that_is_compared() {
    let program = without_indentation(include_str!("../../../book/measure/rival/book.cc"));
    let page = include_str!("../../../book/notes/cpp_to_rust.md");
    let listings = page.split("```cpp\n").skip(1);
    assert!(listings.clone().count() > 0, "the page has lost its C++");
    for listing in listings {
        let listing = listing.split("```").next().unwrap_or(listing);
        assert!(
            program.contains(&without_indentation(listing)),
            "this is not in book/measure/rival/book.cc:\n{listing}"
        );
    }
}

fn without_indentation(text: &str) -> String {
    text.lines().flat_map(|line| [line.trim(), "\n"]).collect()
}
