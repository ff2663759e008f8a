//! Live pictures: HTML around a chapter's picture, with which a reader paints it anew.

use slips::{Chapter, Slip};

use crate::ground::{escaped, named};

/// The widest picture that a page paints, in pixels.
const WIDEST: u32 = 1920;

/// A question about the picture of a chapter and the image itself, in Markdown, with what is
/// needed to paint it at another width and with a slip.
pub(crate) fn picture(chapter: &str, rest: &str) -> Result<String, String> {
    let chapters = (0..).zip(Chapter::OF_THE_BOOK);
    let (place, chapter) = named("picture", chapter, chapters, |(_, it)| it.name())?;
    let (question, image) = rest
        .split_once("![")
        .ok_or_else(|| format!("{rest} has no image in Markdown"))?;
    let (shown, _) = image.split_once(']').unwrap_or((image, ""));
    let width = chapter.book_width();
    Ok(format!(
        "<figure id=\"picture\" class=\"live\" data-module=\"lesson\" data-picture=\"{place}\">\
         <p class=\"question\">{question}</p>\
         <div class=\"controls\">\
         <label>Break it <select>{slips}</select></label>\
         <button type=\"button\" data-action=\"more\">More</button>\
         <label>Width, 1 to {WIDEST} <input type=\"number\" min=\"1\" max=\"{WIDEST}\" value=\"{width}\"></label>\
         <button type=\"button\" data-action=\"reset\">Reset</button>\
         <a class=\"this-case\">Link to this case</a></div>\n\n![{image}\n\n\
         <div class=\"canvases\" style=\"--width: {width}px\">\
         <span><canvas tabindex=\"0\" role=\"img\" aria-label=\"{shown}: arrows choose a pixel\"></canvas></span>\
         <span><canvas tabindex=\"0\" role=\"img\" hidden></canvas></span></div>\
         <p class=\"sentence\" role=\"status\"></p>\
         <div class=\"inspector\" aria-live=\"polite\"></div></figure>",
        question = question.trim(),
        shown = escaped(shown),
        slips = choices(chapter),
    ))
}

/// The slips that can be made in the chapter, by their names: at once those of its own page
/// and source, and behind "More" those of the others. As labels, the search does not know them.
fn choices(chapter: Chapter) -> String {
    let all = slips::all().enumerate();
    let (own, others): (Vec<_>, Vec<_>) = all
        .filter(|(_, slip)| slip.chapters.contains(&chapter))
        .partition(|(_, slip)| is_own(slip, chapter));
    format!(
        "<option value=\"\" data-slip=\"-1\">nothing: it is right</option>{}\
         <optgroup label=\"of other pages\" hidden>{}</optgroup>",
        own.into_iter().map(option).collect::<String>(),
        others.into_iter().map(option).collect::<String>()
    )
}

fn is_own(slip: &Slip, chapter: Chapter) -> bool {
    let (page, _) = slip.page_and_heading();
    let is_on_setup = page == "setup" && chapter == Chapter::BuildTest;
    page == chapter.name() || is_on_setup || slip.source.contains(&format!("_{}/", chapter.name()))
}

fn option((place, slip): (usize, &Slip)) -> String {
    let (name, words) = (slip.name, slip.name.replace('-', " "));
    format!("<option value=\"{name}\" data-slip=\"{place}\" label=\"{words}\"></option>")
}
