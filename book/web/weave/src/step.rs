//! Half-finished pictures: the picture after a step on the way to a chapter.

use slips::{Chapter, ChapterProgram, steps};

use crate::ground::{escaped, named};
use crate::slip::image;

/// Draws the picture after step `number` of a chapter; returns it with the words on what to type.
///
/// # Errors
/// If there is no such chapter or step.
pub(crate) fn step(chapter: &str, number: &str) -> Result<String, String> {
    let chapter = named("chapter", chapter, Chapter::ALL, |chapter| chapter.name())?;
    let (name, steps) = (chapter.name(), steps::of_chapter(chapter));
    let place = number.parse::<usize>().unwrap_or(0).checked_sub(1);
    let step = place
        .and_then(|place| steps.get(place))
        .ok_or_else(|| format!("{name} has no step {number}: it has {}", steps.len()))?;
    let program = step.applied_to(&ChapterProgram::right(chapter));
    let picture = program.run(chapter.book_width()).picture();
    Ok(format!(
        "<figure>{}<figcaption>{}</figcaption></figure>",
        image(&picture, step.description),
        with_code(step.instruction)
    ))
}

/// Puts the text between backticks into `<code>`.
fn with_code(says: &str) -> String {
    let tags = [["", ""], ["<code>", "</code>"]].into_iter().cycle();
    let pieces = says.split('`').zip(tags);
    pieces
        .map(|(piece, [before, after])| format!("{before}{}{after}", escaped(piece)))
        .collect()
}
