//! Half-finished pictures: what there is to see after a step on the way to a chapter.

use slips::{Chapter, Program, steps};

use crate::directive::named;
use crate::slip::image;

/// The picture of step `number` of the chapter, drawn now, and what to type for it.
pub(crate) fn step(chapter: &str, number: &str) -> Result<String, String> {
    let chapter = named("chapter", chapter, Chapter::ALL, |chapter| chapter.name())?;
    let steps = steps::of(chapter);
    let number = number.parse().unwrap_or(0);
    let step = (1..).zip(steps).find(|&(it, _)| it == number);
    let (_, step) = step.ok_or_else(|| {
        format!(
            "{} has no step {number}: it has {}",
            chapter.name(),
            steps.len()
        )
    })?;
    let picture = step
        .put_to(Program::right(chapter))
        .run(chapter.book_width())
        .picture();
    Ok(format!(
        "<figure>{}<figcaption>{}</figcaption></figure>",
        image(&picture, step.seen),
        with_code(step.says)
    ))
}

/// What stands between backticks is code.
fn with_code(says: &str) -> String {
    let pieces = says
        .split('`')
        .zip([["", ""], ["<code>", "</code>"]].iter().cycle());
    pieces
        .map(|(piece, [before, after])| format!("{before}{}{after}", piece.replace('<', "&lt;")))
        .collect()
}
