//! Diffs: what changed from one chapter to the next in the picture, and which files are new.

use difference::{Comparison, difference_picture};
use figures::number::as_printed;
use slips::{Chapter, ChapterCode};

use crate::slip::address;

/// Returns the Markdown for `{{changes NAME}}`: the pictures of the chapter `name` and of the one
/// before, the pixels that changed, and the names of new files.
///
/// # Errors
/// If there is no such chapter, or none before it, or if no pixel changes, or all.
pub(crate) fn changes(name: &str) -> Result<String, String> {
    let [before, after] = Chapter::OF_THE_BOOK
        .array_windows()
        .find(|[_, after]| after.name() == name)
        .ok_or_else(|| format!("no chapter `{name}` comes after another one"))?;
    let (sentence, panels) = pictures(*before, *after)?;
    let files = new_files(*before, *after);
    Ok(format!("{panels}{sentence}{files}"))
}

/// Returns a sentence about what changed in the picture, and the HTML of the pictures.
///
/// # Errors
/// If no pixel did, or all: then there is nothing to show.
fn pictures(before: Chapter, after: Chapter) -> Result<(String, String), String> {
    let [old, new] = [before, after].map(|chapter| chapter.picture(chapter.book_width()));
    let Comparison::Pixels(it) = Comparison::of(&old, &new) else {
        return Err(format!("`{}` changes no pixels, or all", after.name()));
    };
    let changed = difference_picture(&old, &new).ok_or("the pictures differ in size")?;
    let [count, total] = [it.count, it.total].map(|it| as_printed(&it.to_string()));
    let sentence = format!(
        "{count} of {total} pixels change, in columns {} to {} and rows {} to {}.",
        it.columns[0], it.columns[1], it.rows[0], it.rows[1]
    );
    let file = |of: Chapter| format!("pictures/{}.snap.png", of.name());
    let panels = [
        panel("Before", &file(before), before.shows()),
        panel("After", &file(after), after.shows()),
        panel("Changed pixels", &address(&changed), &sentence),
    ];
    let panels = format!("<div class=\"changes\">{}</div>\n\n", panels.concat());
    Ok((sentence, panels))
}

/// Returns a picture with a title below, as HTML.
fn panel(title: &str, file: &str, alt: &str) -> String {
    format!("<figure><img src=\"{file}\" alt=\"{alt}\"><figcaption>{title}</figcaption></figure>")
}

/// Returns a sentence that names the files which only the later chapter has: empty, if there are
/// none.
fn new_files(before: Chapter, after: Chapter) -> String {
    let is_old = |name: &str| before.files().iter().any(|old| old.name == name);
    let names = after.files().iter().map(|file| file.name);
    let added: Vec<String> = names
        .filter(|name| !is_old(name))
        .map(|name| format!("`{}`", name.trim_start_matches("src/")))
        .collect();
    match &added[..] {
        [] => String::new(),
        _ => format!(" New files: {}.", added.join(", ")),
    }
}
