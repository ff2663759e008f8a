//! The chapters: each draws the book's picture, and obeys the laws that it is old enough for.
//!
//! A mistake in a chapter is told here, once, in seconds. What stands on right chapters is
//! tested by other programs, which cargo runs after this one, and only if it passes.

mod pictures;
mod quadratic;

/// Returns the commands that show more of a wrong chapter, and that bring the right one back.
fn more(chapter: &str) -> String {
    format!(
        "mistake:  cargo rtrace check {chapter} -- cargo run -q -p {chapter}\n\
         changed:  git diff chapters/*_{chapter}\n\
         back:     git checkout chapters/*_{chapter}\n\
         again:    cargo test {chapter}\n\
         waiting:  the programs after this one: all that stands on right chapters\n"
    )
}
