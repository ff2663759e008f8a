//! Listings of the lesson: who types them, and their comments in one sentence.

use course::chapter::Chapter;
use course::typed::{given, on_the_first_stair};

use crate::ground::escaped;

/// A listing as the page shows it.
pub(crate) struct LessonListing {
    /// The file, as seen from the workspace; that of the first stair, as seen from the reader's
    /// crate.
    pub(crate) file: String,
    /// Words behind the file, as HTML: who types the listing.
    pub(crate) whose: String,
    /// The button that opens the editor at the listing, as HTML; empty for one that readers do not
    /// type.
    pub(crate) tools: String,
    /// The code.
    pub(crate) code: String,
}

/// The folder with the files of chapter 5 as they are on its first stair.
const FIRST_STAIR: &str = "tests/suite/book/exercises/stairs/";

/// Returns the listing of `code`, which stands in `file`. That of a chapter or of `common` has one
/// sentence for each doc comment, and each comment in one line, which the style
/// sheet wraps.
pub(crate) fn listing(file: &str, code: String) -> LessonListing {
    let on_first = file.strip_prefix(FIRST_STAIR);
    let is_lesson = file.starts_with("common/src/") || file.starts_with("chapters/");
    let is_lesson = is_lesson && !file.contains("/6_") || on_first.is_some();
    let code = match is_lesson {
        true => on_one_line(&first_sentences(&code)),
        false => code,
    };
    let whose = match chapter_of(file) {
        Some(chapter) => whose(chapter, &code),
        None if is_lesson => ", to be read".to_owned(),
        None => String::new(),
    };
    let typed = chapter_of(file).filter(|_| whose.contains("typed"));
    LessonListing {
        file: on_first.map_or(file.to_owned(), |name| format!("src/{name}")),
        whose,
        tools: typed.map_or(String::new(), tools),
        code,
    }
}

/// Returns the chapter that readers type in this file, if they do.
fn chapter_of(file: &str) -> Option<Chapter> {
    if file.starts_with(FIRST_STAIR) {
        return Some(Chapter::HittableList);
    }
    let is_of = |it: &Chapter| file.contains(&format!("_{}/src/", it.name()));
    let chapter = Chapter::OF_THE_BOOK.into_iter().find(is_of);
    chapter.filter(|_| !file.ends_with("main.rs"))
}

/// Says what of a listing a reader types: the functions that are empty in the editor, and what the
/// second stair of chapter 5 changes.
fn whose(chapter: Chapter, code: &str) -> String {
    if chapter == Chapter::BuildTest {
        return ", to be typed: <b>the color of a pixel</b>".to_owned();
    }
    let words = code.lines().filter(|line| line.ends_with('{'));
    let functions = words.filter_map(|line| line.split_once("fn ")?.1.split(['(', '<']).next());
    let given = given(chapter);
    let typed: Vec<&str> = functions.filter(|name| !given.contains(name)).collect();
    if on_the_first_stair(code) != code {
        return ", to be typed, on the second stair".to_owned();
    }
    match &typed[..] {
        [] => ", in the editor already".to_owned(),
        names => format!(", to be typed: <b>{}</b>", escaped(&names.join(", "))),
    }
}

/// Returns the button that opens the editor, to type the listing.
fn tools(chapter: Chapter) -> String {
    format!(
        "<div class=\"tools\" data-chapter=\"{}\"><button type=\"button\">Type it here</button></div>",
        chapter.name()
    )
}

/// Returns the source with the first sentence only of each doc comment, and without `#[inline]`.
fn first_sentences(source: &str) -> String {
    let mut text = String::new();
    let mut is_open = true;
    let is_shown = |line: &&str| !line.trim_start().starts_with("#[inline]");
    for line in source.lines().filter(is_shown) {
        if !line.trim_start().starts_with("///") {
            text += &format!("{line}\n");
            is_open = true;
        } else if is_open {
            let ends = line.split_once(". ").map(|(first, _)| format!("{first}."));
            let line = ends.unwrap_or(line.to_owned());
            is_open = !line.ends_with('.');
            text += &format!("{line}\n");
        }
    }
    text
}

/// Joins the lines of each comment.
fn on_one_line(code: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for line in code.lines() {
        let before = lines.last_mut().filter(|before| comment(before).is_some());
        match (before, comment(line)) {
            (Some(before), Some((mark, words)))
                if before.trim_start().starts_with(&format!("{mark} ")) =>
            {
                *before += &format!(" {words}");
            }
            _ => lines.push(line.to_owned()),
        }
    }
    lines.join("\n") + "\n"
}

/// Returns the mark of a line that is only a comment, and its words, if it has any.
fn comment(line: &str) -> Option<(&str, &str)> {
    let (mark, words) = line.trim_start().split_once(' ')?;
    let is_heading = words.starts_with('#');
    (["///", "//!", "//"].contains(&mark) && !is_heading).then_some((mark, words))
}
