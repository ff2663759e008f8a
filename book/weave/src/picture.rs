//! Live pictures: HTML around a chapter's picture, with which a reader paints it anew.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use figures::escape;
use live::picture::{self, LivePicture, PICTURES, WIDEST};
use slips::{Chapter, Slip};

use crate::directive::named;

/// The `image` of a chapter, in Markdown, with what is needed to paint it at another width
/// and with a slip. The pages that the slips belong to are in the folder `notes`.
pub(crate) fn picture(notes: &Path, chapter: &str, image: &str) -> Result<String, String> {
    let (place, live) = named("live picture", chapter, (0..).zip(PICTURES), |(_, live)| {
        live.chapter.name()
    })?;
    let width = live.chapter.book_width();
    Ok(format!(
        "<figure id=\"picture\" class=\"live\" data-module=\"lesson\" data-picture=\"{place}\">\
         <p class=\"question\">{question}</p>\
         <div class=\"controls\">\
         <label>Break it <select>{slips}</select></label>\
         <button type=\"button\" data-action=\"more\">More</button>\
         <label>Width, 1 to {WIDEST} <input type=\"number\" min=\"1\" max=\"{WIDEST}\" value=\"{width}\"></label>\
         <button type=\"button\" data-action=\"reset\">Reset</button>\
         <a class=\"this-case\">Link to this case</a></div>\n\n{image}\n\n\
         <div class=\"canvases\" style=\"--width: {width}px\">\
         <span><canvas tabindex=\"0\" role=\"img\" aria-label=\"{shown}: arrows choose a pixel\"></canvas></span>\
         <span><canvas tabindex=\"0\" role=\"img\" hidden></canvas></span></div>\
         <p class=\"sentence\" role=\"status\">{sentence}</p>\
         <div class=\"inspector\" aria-live=\"polite\"></div></figure>",
        shown = alternative(image)?,
        question = live.question,
        slips = choices(notes, live)?,
        sentence = picture::verdict(live, None, width, 0),
    ))
}

/// What the image says to whoever cannot see it.
fn alternative(image: &str) -> Result<String, String> {
    let text = image.strip_prefix("![").and_then(|it| it.split_once("]("));
    let (text, _) = text.ok_or_else(|| format!("{image} is no image in Markdown"))?;
    Ok(escape(text))
}

/// The slips that can be made in the chapter, by their names: at once those of its own page
/// and source, and behind "More" the others, under the titles of the pages that have them
/// right. As labels, the search does not know them.
fn choices(notes: &Path, live: &LivePicture) -> Result<String, String> {
    let mut html = "<option value=\"\" data-slip=\"-1\">nothing: it is right</option>".to_owned();
    for (page, slips) in by_page(live.chapter) {
        let options: String = slips.into_iter().map(option).collect();
        if page == live.chapter.name() {
            html += &options;
        } else {
            let title = escape(&title(&notes.join(format!("{page}.md")))?);
            let _ = write!(
                html,
                "<optgroup label=\"{title}\" hidden>{options}</optgroup>"
            );
        }
    }
    Ok(html)
}

fn option((place, slip): (usize, &Slip)) -> String {
    let (name, words) = (slip.name, slip.name.replace('-', " "));
    format!("<option value=\"{name}\" data-slip=\"{place}\" label=\"{words}\"></option>")
}

/// The slips of a chapter with their places in the catalogue. Its own are under its name.
fn by_page(chapter: Chapter) -> Vec<(&'static str, Vec<(usize, &'static Slip)>)> {
    let mut pages: Vec<(&str, Vec<_>)> = vec![(chapter.name(), Vec::new())];
    for (place, slip) in slips::all().enumerate() {
        if !slip.chapters.contains(&chapter) {
            continue;
        }
        let page = match slip.page_and_heading().0 {
            "setup" if chapter == Chapter::BuildTest => chapter.name(),
            _ if slip.source.contains(&format!("_{}/", chapter.name())) => chapter.name(),
            page => page,
        };
        match pages.iter_mut().find(|(other, _)| *other == page) {
            Some((_, slips)) => slips.push((place, slip)),
            None => pages.push((page, vec![(place, slip)])),
        }
    }
    pages
}

/// The first heading of a page.
fn title(page: &Path) -> Result<String, String> {
    let text = fs::read_to_string(page).map_err(|cause| format!("{}: {cause}", page.display()))?;
    let heading = text.lines().find_map(|line| line.strip_prefix("# "));
    heading
        .map(str::to_owned)
        .ok_or_else(|| format!("{}: no heading", page.display()))
}
